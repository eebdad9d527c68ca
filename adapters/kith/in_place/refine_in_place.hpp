// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/four_eight.hpp>
#include <kith/level/lift.hpp>
#include <kith/plan.hpp>
#include <kith/refine.hpp>
#include <kith/step/level_state.hpp>
#include <kith/step/step.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace kith::in_place {

template <class Point>
using native_mesh = basic_mesh<Point, std::uint32_t>;

/// A refinement for a mesh that is overwritten: nothing of it is touched before the last level is there.
template <class Point>
struct refined {
    native_mesh<Point> mesh;
    bool keeps_vertices; ///< the first vertices are those of the control mesh, in their order
};

/// Whether the new vertex of each vertex has its number.
template <element_ids Ids>
bool keeps_vertices(const Ids& ids, std::size_t vertices)
{
    if constexpr (Ids::template has<tuple_kind::v>)
        return vertices != 0 and ids.template id<tuple_kind::v>(0) == 0 and
               ids.template id<tuple_kind::v>(vertices - 1) == vertices - 1;
    else
        return false;
}

/// One step, with what goes along: `carried`, such as carried_values, and the scheme, which becomes that of the next
/// level. Where points stay, old vertices do not move, as if each had been reset after the step. change(numbering,
/// points) is called with the new points before they are used.
template <class Point, scheme Scheme, class Carried, class Change>
void step(refined<Point>& surface, Scheme& scheme, Carried& carried, bool points_stay, const Change& change)
{
    numbering_of<Scheme, std::uint32_t> ids;
    auto fine = refine_mesh<connect::everything>(surface.mesh, scheme, ids);
    const level_of<native_mesh<Point>> coarse(surface.mesh);
    const bool keeps = keeps_vertices(ids.vertices, surface.mesh.vertex_count());
    if (points_stay and keeps)
        for (std::size_t v = 0; v < surface.mesh.vertex_count(); ++v)
            fine.points()[v] = surface.mesh.point(v);
    change(ids, fine.points());
    const made_step<Scheme, level_of<native_mesh<Point>>, numbering_of<Scheme, std::uint32_t>, native_mesh<Point>> made{
        scheme, coarse, surface.mesh.generation(), ids, fine};
    carried.advance(made, points_stay and keeps);
    advance(scheme, coarse, surface.mesh.generation(), ids, fine);
    surface = {std::move(fine), surface.keeps_vertices and keeps};
}
template <class Point, scheme Scheme, class Carried>
void step(refined<Point>& surface, Scheme& scheme, Carried& carried, bool points_stay)
{
    step(surface, scheme, carried, points_stay, [](const auto&, const auto&) {});
}

/// What a scheme needs before its first step: 4-8 a tri-quad mesh, which it makes of any mesh as `tri_quad` does.
template <class Point, scheme Scheme, class Carried>
void prepare(refined<Point>&, const Scheme&, Carried&)
{
}
template <class Point, class Carried>
void prepare(refined<Point>& surface, const four_eight&, Carried& carried)
{
    const auto elements = [&] { return level_of<native_mesh<Point>>(surface.mesh); };
    const auto split = [&](auto scheme, int generation) {
        step(surface, scheme, carried, false);
        surface.mesh = {storage<Point>(surface.mesh.points()), surface.mesh.topology(), generation};
    };
    const int degree = surface.mesh.topology().degree;
    // Triangles without marks are cut like other faces.
    if (degree == 3 and bisection_split::has_marks(elements()))
        return;
    if (degree == 4) {
        const auto is_odd = detail::choose_diagonals(
            level_elements<native_level<Point, std::uint32_t, 4>>(surface.mesh));
        split(detail::diagonal_split{&is_odd}, 0);
    } else {
        split(detail::centroid_split{}, 1);
    }
}

/// Refuses faces of a mesh that a scheme does not take, by the numbers of its handles; `control` has been lifted from
/// it. 4-8 takes any. Errors: mesh_error.
template <mesh M, class Point, scheme Scheme>
void require_faces(const M& mesh, const native_mesh<Point>& control, const Scheme& scheme)
{
    if constexpr (not std::same_as<Scheme, four_eight>)
        detail::with_numbers_of(mesh, scheme, control.generation(), [&] {
            detail::require_control_level(scheme, level_of<native_mesh<Point>>(control), control.generation());
        });
}

/// Refines, and makes scheme and values those of the last level. After each level go_on(share of the work) may say no;
/// then nothing is returned. Errors: as `refine`.
template <class Point, scheme Scheme, class Carried>
std::optional<refined<Point>> refine(native_mesh<Point> control, Scheme& scheme, int levels, Carried& carried,
                                     bool points_stay, const std::function<bool(double)>& go_on)
{
    refined<Point> surface{std::move(control), true};
    prepare(surface, scheme, carried);
    detail::require_refinable(surface.mesh, scheme, levels, {});
    const auto done = shares_of_work(count(surface.mesh.topology()), scheme, levels, surface.mesh.generation());
    for (int level = 1; level <= levels; ++level) {
        step(surface, scheme, carried, points_stay);
        if (not go_on(done[std::size_t(level)]))
            return std::nullopt;
    }
    return surface;
}

} // namespace kith::in_place
