// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kith::viewer {

/// A unit vector times 127, and a byte that fills a word.
using drawn_normal = std::array<std::int8_t, 4>;

/// A corner of a triangle as a graphics card takes it.
struct drawn_corner {
    std::array<float, 3> position;
    drawn_normal normal;
};

/// Red, green, blue and opacity from 0 to 255.
using drawn_color = std::array<std::uint8_t, 4>;

/// The center and the size of what is shown. Graphics cards calculate in floats, so they get points in this frame.
struct frame {
    point center{};
    double radius = 1;

    [[nodiscard]] point operator()(const point& p) const
    {
        return {(p[0] - center[0]) / radius, (p[1] - center[1]) / radius, (p[2] - center[2]) / radius};
    }
};

/// Returns the corners of the triangles into which the faces of a level are cut from their first corners. Smooth
/// normals are means over the faces around a vertex, except at sharp edges, whose faces look flat. Cost: O(corners).
std::vector<drawn_corner> triangles_of(const surface& shape, int level, bool is_smooth, const frame& seen);

/// Returns the two ends of each edge of a level.
std::vector<std::array<float, 3>> edge_ends(const level_type& level, const frame& seen);

/// The meaning of the colors of a level.
enum class coloring : int {
    plain,
    parent,       ///< of faces: the number of their face of the control mesh
    face_number,  ///< a number for each face of the control mesh, which its descendants inherit
    face_value,   ///< as face_number, for values that may lie between numbers
    vertex_value, ///< a value for each vertex of the control mesh, carried by the scheme
    gaussian,     ///< curvature by the angles around vertices
    mean,         ///< curvature by the turn of faces at edges, negative on convex surfaces
    level         ///< the number of the level
};

/// Values of all vertices or all faces of a level; NaN where there is none.
struct shown_values {
    std::vector<double> values{};
    bool are_at_vertices = false;
};

/// Returns the values that give a level its colors. `given` has a value for each face or vertex of the control mesh.
shown_values values_of(const surface& shape, int level, coloring by, std::span<const double> given);

/// Returns the range of the values that colors span. If `is_signed`, it is symmetric around 0 and leaves out the
/// largest twentieth. Returns nothing unless a value is a number.
std::optional<std::array<double, 2>> range_of(std::span<const double> values, bool is_signed);

/// The colors that stand for values.
enum class palette : int { numbers, shares, signs };

/// Returns a color for each corner that `triangles_of` returns. `range` spans the palettes of shares and signs.
std::vector<drawn_color> colors_of(const level_type& level, const shown_values& shown, palette colors,
                                   std::array<double, 2> range);
drawn_color color_of(double value, palette colors, std::array<double, 2> range);

/// Returns the place in `triangles_of` at which each face begins.
std::vector<std::uint32_t> first_triangles(const level_type& level);

/// Returns the face of a level that a ray meets first; the ray is in the frame. Cost: O(corners).
std::optional<std::uint32_t> face_at(const level_type& level, const point& from, const point& direction,
                                     const frame& seen);

} // namespace kith::viewer
