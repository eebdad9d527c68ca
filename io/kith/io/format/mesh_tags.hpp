// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/crease/boundary.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith {

enum class crease_method : unsigned char; // <kith/schemes/crease/creases.hpp>, which reading files does not need

} // namespace kith

namespace kith::io {

/// The tags of an OBJ file: sharp edges, sharp vertices and holes in lines `t ...`, as in OpenSubdiv's test files.
/// Vertices and faces are numbered from 0, both here and in the file.
struct mesh_tags {
    struct edge {
        std::size_t from = 0;
        std::size_t to = 0;
        double sharpness = 0;
    };
    /// A line with a tag that is not read.
    struct unknown {
        std::size_t line = 0;
        std::string name;
    };

    std::vector<edge> edges;
    std::vector<std::pair<std::size_t, double>> vertices;
    std::vector<std::size_t> holes; ///< faces
    bool boundary_is_hole = false;  ///< the faces at the boundary are holes, too
    std::optional<boundary_corner> corners;
    std::optional<crease_method> method;
    std::vector<unknown> unread;

    [[nodiscard]] bool has_creases() const { return not edges.empty() or not vertices.empty(); }
};

} // namespace kith::io
