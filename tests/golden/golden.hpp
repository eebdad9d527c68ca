// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The contents of the files of golden/. golden/README.md describes their format.
namespace golden {

/// The tuple of the control mesh to which a vertex belongs: "v", "e", "f", "vf" or "ve" and its numbers.
struct key {
    std::string kind;
    std::vector<std::size_t> numbers;
};

struct sharp_edge {
    std::size_t a, b;
    double sharpness;
};
struct sharp_vertex {
    std::size_t v;
    double sharpness;
};

struct level {
    std::array<std::size_t, 3> counts; ///< vertices, edges, faces
    std::size_t boundary_edges;
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::vector<std::size_t>> faces;
    std::vector<sharp_edge> creases;
    std::vector<sharp_vertex> corners;
    std::vector<std::pair<std::size_t, std::size_t>> marked_edges; ///< 4-8 only
    std::vector<key> keys;                                         ///< level 1 only
    double min_vertex_distance;                                    ///< levels 1 and above
    /// The limit points of the vertices, on level 1 of some files only. A point is missing if no mask is known.
    std::vector<std::optional<std::array<double, 3>>> limit_points;
};

struct file {
    std::string name;
    std::string corner_rule, weights, boundary, crease_method; ///< empty if the scheme has no such option
    int degree;                                                ///< of the unified scheme
    std::vector<level> levels;
};

/// Returns all files of a scheme, given by its name in the files, such as "catmull_clark".
std::vector<file> files_of(const std::string& scheme);

} // namespace golden
