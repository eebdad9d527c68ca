// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "color.hpp"
#include "image.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace kith::picture {

using point = std::array<double, 3>;

/// A light from the upper left over the viewer's shoulder; bright and dark stripes, as a room of parallel lamps would
/// be reflected (Klass 1980: they show where curvature jumps); or no light.
enum class shading { lit, reflection_lines, none };

/// Lines along the edges of polygons; `width` is in pixels, and 0 means none.
struct outline {
    double width = 0;
    color ink{.15F, .15F, .18F, 1};
};

/// Convex polygons. Polygon i has the points corners[first[i]] to corners[first[i + 1] - 1].
struct surface {
    std::vector<point> points{};
    std::vector<std::uint32_t> corners{};
    std::vector<std::uint32_t> first{0};
    std::vector<point> normals{};           ///< unit normals of the points; without normals polygons are flat
    std::vector<point> corner_normals{};    ///< unit normals of the corners, which come before those of the points
    color paint = gray;                     ///< of everything that has no color of its own
    std::vector<color> face_colors{};       ///< of the polygons, or empty
    std::vector<color> vertex_colors{};     ///< of the points, or empty
    std::shared_ptr<const image> texture{}; ///< an image in place of all colors
    std::vector<std::array<float, 2>> corner_textures{}; ///< texture coordinates of the corners
    shading light = shading::lit;
    outline edges{};
    bool closed = false; ///< polygons that are seen from behind are left out

    [[nodiscard]] std::size_t face_count() const { return first.size() - 1; }
};

/// Straight lines with round ends between pairs of points; `width` is in pixels. A line between equal points is a dot.
/// Surfaces hide lines only if they are nearer to the viewer by `lift`, a length in the scene.
struct lines {
    std::vector<point> points{};
    std::vector<std::array<std::uint32_t, 2>> segments{};
    color ink{.15F, .15F, .18F, 1};
    double width = 1;
    double lift = 0;
    double hidden = 0; ///< opacity behind surfaces, from 0 to 1; only in images of pixels
};

/// A drawing: items in the order in which they are drawn where they have the same depth. Lines come after surfaces.
struct panel {
    std::vector<std::variant<surface, lines>> items{};
    std::string title{};
};

/// The direction in which the viewer looks, without perspective, in degrees. At azimuth 0 and elevation 0 the viewer
/// stands in front. A positive azimuth moves the viewer to the right, a positive elevation upward. `up` is the axis
/// that points upward: 2 is z, with x to the right in front; 1 is y, with x to the right; 0 is x, with y to the right.
struct view {
    double azimuth = 45, elevation = 35.264389682754654;
    int up = 2;
};

/// The meaning of the colors: a bar that goes through the colors upward, or a list of colors. Each color has a text.
struct legend {
    struct entry {
        color paint;
        std::string text;
    };
    std::string title{};
    std::vector<entry> entries{};
    bool is_scale = false;
};

/// A picture: panels side by side, seen from one direction in one scale, so that the largest one fills its place.
struct sheet {
    std::vector<panel> panels{};
    kith::picture::view view{};
    kith::picture::legend legend{};
    int width = 800, height = 600; ///< in pixels
    int columns = 0;               ///< number of panels in a row; 0 puts all in one row
    color background = white;
    color ink{.1F, .1F, .12F, 1}; ///< of texts
    double text_size = 15;        ///< in pixels
    int samples = 3;              ///< of each pixel in each direction, for images
};

/// Returns the faces of a mesh as a surface. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
surface surface_of(const basic_mesh<Point, Index>& mesh)
{
    surface result;
    result.points.reserve(mesh.vertex_count());
    for (const Point& p : mesh.points())
        result.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    result.corners.reserve(mesh.corner_count());
    result.first.reserve(mesh.face_count() + 1);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (const Index v : mesh.face(f))
            result.corners.push_back(std::uint32_t(v));
        result.first.push_back(std::uint32_t(result.corners.size()));
    }
    return result;
}

/// Returns the edges of the faces of a mesh as lines, each edge once. Cost: O(corners log corners).
template <class Point, std::unsigned_integral Index>
lines edges_of(const basic_mesh<Point, Index>& mesh)
{
    lines result;
    result.points = surface_of(mesh).points;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto a = std::uint32_t(face[i]), b = std::uint32_t(face[(i + 1) % face.size()]);
            result.segments.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::ranges::sort(result.segments);
    const auto [begin, end] = std::ranges::unique(result.segments);
    result.segments.erase(begin, end);
    return result;
}

} // namespace kith::picture
