// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mesh/connectivity.hpp>
#include <kith/shape/parametric_scheme.hpp>
#include <kith/surface/surface_place.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kith::detail {

/// A curve on a limit surface that faces share: an edge, half of an edge, or a line from the middle of an edge to the
/// centre of a polygon. `first` and `last` are the numbers of its ends.
struct shared_curve {
    std::size_t first = 0, last = 0;
    std::size_t face = 0, side = 0; ///< a parametric face that has it, and on which side
    double begin = 0, end = 0;      ///< where it lies on that side; it runs backwards if begin > end
    bool is_half = false;           ///< as long as half of an edge
    bool is_wall = false;           ///< on a boundary or an infinitely sharp edge
};
/// One of the one or two curves that a side of a face consists of.
struct part_of_side {
    std::size_t curve;
    bool is_reversed;
};
/// A face with parameters: a face of the control mesh or a sub-face of a polygon. Sides are counter-clockwise.
struct parametric_face {
    surface_place origin; ///< the place of (0, 0)
    std::vector<std::vector<part_of_side>> sides{};
    std::vector<std::size_t> corners{}; ///< numbers of its corners
    bool is_sub_face = false;           ///< half as wide
};

/// Returns the place at t, 0 to 1, on a side of a face with so many sides.
inline surface_place place_on_side(const parametric_face& face, std::size_t side, double t)
{
    surface_place place = face.origin;
    const std::array<double, 2> uv = face.sides.size() == 3 ? side == 0   ? std::array{t, 0.}
                                                              : side == 1 ? std::array{1 - t, t}
                                                                          : std::array{0., 1 - t}
                                     : side == 0 ? std::array{t, 0.}
                                     : side == 1            ? std::array{1., t}
                                     : side == 2            ? std::array{1 - t, 1.}
                                                            : std::array{0., 1 - t};
    place.u = uv[0];
    place.v = uv[1];
    return place;
}

/// The parametric faces of a mesh, and the curves and corners that they share. Corners are the vertices, then, where
/// there are polygons with sub-faces, the middles of the edges and the centres of the polygons.
class parametric_faces {
public:
    /// Returns those of a mesh, with the scheme of its level. Cost: O(corners).
    template <std::unsigned_integral Index, parametric_scheme Scheme>
    static parametric_faces of(const connectivity<Index>& mesh, const Scheme& scheme)
    {
        constexpr std::size_t degree = domain_of<Scheme>::sides;
        parametric_faces result;
        result.corners_ = result.vertices_ = mesh.vertices;
        bool has_polygons = false;
        for (std::size_t f = 0; f < mesh.faces; ++f)
            has_polygons = has_polygons or mesh.first_corner(f + 1) - mesh.first_corner(f) != degree;
        const std::size_t first_middle = mesh.vertices, first_centre = first_middle + mesh.edges();
        const std::size_t per_edge = has_polygons ? 2 : 1;
        result.curves_.resize(per_edge * mesh.edges());
        if (has_polygons)
            result.corners_ = first_centre + mesh.faces;
        for (std::size_t f = 0; f < mesh.faces; ++f) {
            const std::size_t first = mesh.first_corner(f), n = mesh.first_corner(f + 1) - first;
            const auto edge = [&](std::size_t k) { return std::size_t(mesh.corner_halfedge[first + k] / 2); };
            const auto is_reversed = [&](std::size_t k) { return mesh.corner_halfedge[first + k] % 2 != 0; };
            const auto vertex = [&](std::size_t k) { return std::size_t(mesh.corner_vertex[first + k % n]); };
            // The half of an edge that begins or ends at its origin in this face.
            const auto half = [&](std::size_t k, bool is_first) {
                return part_of_side{2 * edge(k) + (is_first == is_reversed(k) ? 1 : 0), is_reversed(k)};
            };
            if (n == degree) {
                parametric_face& face = result.faces_.emplace_back(parametric_face{{f, 0, 0, 0}});
                for (std::size_t k = 0; k < n; ++k) {
                    face.corners.push_back(vertex(k));
                    if (has_polygons)
                        face.sides.push_back({half(k, true), half(k, false)});
                    else
                        face.sides.push_back({{edge(k), is_reversed(k)}});
                }
                for (std::size_t k = 0; k < n; ++k)
                    if (has_polygons) {
                        result.see(half(k, true), vertex(k), first_middle + edge(k), k, 0, .5);
                        result.see(half(k, false), first_middle + edge(k), vertex(k + 1), k, .5, 1);
                    } else {
                        result.see({edge(k), is_reversed(k)}, vertex(k), vertex(k + 1), k, 0, 1);
                    }
                continue;
            }
            const std::size_t first_spoke = result.curves_.size(), centre = first_centre + f;
            result.curves_.resize(first_spoke + n);
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t before = (k + n - 1) % n;
                const std::size_t next_middle = first_middle + edge(k), middle_before = first_middle + edge(before);
                result.faces_.push_back({{f, 0, 0, k},
                                         {{half(k, true)},
                                          {{first_spoke + k, false}},
                                          {{first_spoke + before, true}},
                                          {half(before, false)}},
                                         {vertex(k), next_middle, centre, middle_before},
                                         true});
                result.see(half(k, true), vertex(k), next_middle, 0, 0, 1);
                result.see({first_spoke + k, false}, next_middle, centre, 1, 0, 1);
                result.see({first_spoke + before, true}, centre, middle_before, 2, 0, 1);
                result.see(half(before, false), middle_before, vertex(k), 3, 0, 1);
            }
        }
        for (std::size_t c = 0; c < per_edge * mesh.edges(); ++c)
            result.curves_[c].is_wall = mesh.is_boundary(c / per_edge) or is_sharp(scheme, c / per_edge);
        return result;
    }

    /// Returns the place at t, 0 to 1, on a curve.
    [[nodiscard]] surface_place place_on(const shared_curve& curve, double t) const
    {
        return place_on_side(faces_[curve.face], curve.side, curve.begin + (curve.end - curve.begin) * t);
    }

    [[nodiscard]] const std::vector<parametric_face>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<shared_curve>& curves() const { return curves_; }
    /// The numbers of corners are below this; those of no corner may be left out.
    [[nodiscard]] std::size_t corners() const { return corners_; }

private:
    /// Notes where a curve is met first: on a side of the last face.
    void see(const part_of_side& part, std::size_t first, std::size_t last, std::size_t side, double begin, double end)
    {
        shared_curve& curve = curves_[part.curve];
        if (curve.begin != curve.end)
            return;
        const std::size_t face = faces_.size() - 1;
        const bool is_half = last >= vertices_ or first >= vertices_;
        curve = part.is_reversed ? shared_curve{last, first, face, side, end, begin, is_half}
                                 : shared_curve{first, last, face, side, begin, end, is_half};
    }

    std::vector<parametric_face> faces_;
    std::vector<shared_curve> curves_;
    std::size_t corners_ = 0, vertices_ = 0;
};

} // namespace kith::detail
