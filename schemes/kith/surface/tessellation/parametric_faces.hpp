// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/connectivity.hpp>
#include <kith/surface/shape/parametric_scheme.hpp>
#include <kith/surface/surface_place.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// A curve on a limit surface that faces share: an edge, half of an edge, or a line from the middle of an edge to the
/// centre of a polygon. `first` and `last` are the numbers of its ends.
struct shared_curve {
    std::size_t first = 0, last = 0;
    std::size_t face = std::numeric_limits<std::size_t>::max(); ///< the parametric face that was the first to have it
    std::size_t part = 0;                                       ///< the number of the part of the sides of that face
    bool is_half = false;                                       ///< true if it is as long as half of an edge
    bool is_boundary = false;                                   ///< true if no other face has it
    bool is_wall = false;                                       ///< true on a boundary or an infinitely sharp edge
};
/// A curve as a part of a side of a face.
struct part_of_side {
    std::size_t curve = 0;
    bool is_reversed = false;
};
/// A face with parameters: a face of the control mesh or a sub-face of a polygon. Sides are counter-clockwise, and each
/// consists of one or two curves.
struct parametric_face {
    surface_place origin; ///< the place of (0, 0)
    std::uint32_t sides = 0, parts_of_side = 1;
    std::array<part_of_side, 8> all_parts{};
    bool is_sub_face = false; ///< true if it is a sub-face, which is half as wide

    /// Returns the curves around the face.
    [[nodiscard]] std::span<const part_of_side> parts() const { return {all_parts.data(), sides * parts_of_side}; }
};

/// Returns the parameters of t, 0 to 1, on a side of a face with this number of sides.
inline std::array<double, 2> parameters_on_side(std::size_t sides, std::size_t side, double t)
{
    if (side == 0)
        return {t, 0};
    if (side == sides - 1)
        return {0, 1 - t};
    return sides == 3 ? std::array{1 - t, t} : side == 1 ? std::array{1., t} : std::array{1 - t, 1.};
}

/// Returns u and v within a face with this number of sides, out of which rounding may have brought them.
inline std::array<double, 2> parameters_within(std::size_t sides, double u, double v)
{
    u = std::clamp(u, 0., 1.);
    return {u, std::clamp(v, 0., sides == 3 ? 1 - u : 1.)};
}

/// The parametric faces of a mesh, and the curves and corners that they share. Corners are the vertices. If there are
/// polygons with sub-faces, the middles of the edges and the centres of the polygons follow.
class parametric_faces {
public:
    /// A part of a face that begins at a corner.
    struct start {
        std::size_t face = std::numeric_limits<std::size_t>::max(); ///< the largest number if the corner has none
        std::size_t part = 0;
    };

    /// Returns the parametric faces of a mesh, with the scheme of its level. Cost: O(corners).
    template <std::unsigned_integral Index, parametric_scheme Scheme>
    static parametric_faces of(const connectivity<Index>& mesh, const Scheme& scheme)
    {
        constexpr std::size_t degree = domain_of<Scheme>::sides;
        parametric_faces result;
        result.vertices_ = mesh.vertices;
        bool has_polygons = false;
        for (std::size_t f = 0; f < mesh.faces; ++f)
            has_polygons = has_polygons or mesh.first_corner(f + 1) - mesh.first_corner(f) != degree;
        const std::size_t first_middle = mesh.vertices, first_centre = first_middle + mesh.edges();
        const std::size_t per_edge = has_polygons ? 2 : 1;
        result.curves_.resize(per_edge * mesh.edges());
        result.starts_.resize(has_polygons ? first_centre + mesh.faces : mesh.vertices);
        for (std::size_t c = 0; c < result.curves_.size(); ++c) {
            result.curves_[c].is_boundary = mesh.is_boundary(c / per_edge);
            result.curves_[c].is_wall = result.curves_[c].is_boundary or is_sharp(scheme, c / per_edge);
        }
        for (std::size_t f = 0; f < mesh.faces; ++f) {
            const std::size_t first = mesh.first_corner(f), n = mesh.first_corner(f + 1) - first;
            const auto edge = [&](std::size_t k) { return std::size_t(mesh.corner_halfedge[first + k] / 2); };
            const auto is_reversed = [&](std::size_t k) { return mesh.corner_halfedge[first + k] % 2 != 0; };
            const auto vertex = [&](std::size_t k) { return std::size_t(mesh.corner_vertex[first + k % n]); };
            // The half of an edge that begins, or ends, at its origin in this face.
            const auto half = [&](std::size_t k, bool is_first) {
                return part_of_side{2 * edge(k) + (is_first == is_reversed(k) ? 1 : 0), is_reversed(k)};
            };
            if (n == degree) {
                result.faces_.push_back({{f, 0, 0, 0}, std::uint32_t(n), std::uint32_t(per_edge)});
                for (std::size_t k = 0; k < n; ++k)
                    if (has_polygons) {
                        result.add_part(2 * k, half(k, true), vertex(k), first_middle + edge(k));
                        result.add_part(2 * k + 1, half(k, false), first_middle + edge(k), vertex(k + 1));
                    } else {
                        result.add_part(k, {edge(k), is_reversed(k)}, vertex(k), vertex(k + 1));
                    }
                continue;
            }
            const std::size_t first_spoke = result.curves_.size(), centre = first_centre + f;
            result.curves_.resize(first_spoke + n);
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t before = (k + n - 1) % n;
                const std::size_t next_middle = first_middle + edge(k), middle_before = first_middle + edge(before);
                result.faces_.push_back({{f, 0, 0, k}, 4, 1, {}, true});
                result.add_part(0, half(k, true), vertex(k), next_middle);
                result.add_part(1, {first_spoke + k, false}, next_middle, centre);
                result.add_part(2, {first_spoke + before, true}, centre, middle_before);
                result.add_part(3, half(before, false), middle_before, vertex(k));
            }
        }
        return result;
    }

    [[nodiscard]] const std::vector<parametric_face>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<shared_curve>& curves() const { return curves_; }
    /// Returns for each corner a part that begins there, on the boundary if there is such a part.
    [[nodiscard]] const std::vector<start>& starts() const { return starts_; }
    /// Returns the number of the corner at which a part of a side begins.
    [[nodiscard]] std::size_t corner_of(const part_of_side& part) const
    {
        return part.is_reversed ? curves_[part.curve].last : curves_[part.curve].first;
    }
    /// Returns the parameters of t, 0 to 1, on a curve, in the face that was the first to have it.
    [[nodiscard]] std::array<double, 2> parameters_on(const shared_curve& curve, double t) const
    {
        const parametric_face& face = faces_[curve.face];
        const double parts = face.parts_of_side, in_part = face.all_parts[curve.part].is_reversed ? 1 - t : t;
        return parameters_on_side(
            face.sides, curve.part / face.parts_of_side, (double(curve.part % face.parts_of_side) + in_part) / parts);
    }

private:
    /// Adds a part to the last face, from one corner to another.
    void add_part(std::size_t number, const part_of_side& part, std::size_t from, std::size_t to)
    {
        const std::size_t face = faces_.size() - 1;
        faces_.back().all_parts[number] = part;
        shared_curve& curve = curves_[part.curve];
        if (curve.face > face) {
            const auto [first, last] = part.is_reversed ? std::pair(to, from) : std::pair(from, to);
            curve = {first, last, face, number, std::max(from, to) >= vertices_, curve.is_boundary, curve.is_wall};
        }
        if (starts_[from].face > face or curve.is_boundary)
            starts_[from] = {face, number};
    }

    std::vector<parametric_face> faces_;
    std::vector<shared_curve> curves_;
    std::vector<start> starts_;
    std::size_t vertices_ = 0;
};

} // namespace kith::detail
