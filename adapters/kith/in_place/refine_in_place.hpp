// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/refine_in_patches.hpp>
#include <kith/field/values_in_patches.hpp>
#include <kith/four_eight.hpp>
#include <kith/level/lift.hpp>
#include <kith/neighbourhood/coming_scheme.hpp>
#include <kith/plan.hpp>
#include <kith/refine.hpp>
#include <kith/step/level_state.hpp>
#include <kith/step/step.hpp>

#include <algorithm>
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

/// Returns true if the new vertex of each vertex has its number.
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

#ifdef KITH_HAS_LANES

/// Makes the last steps of a surface at once, in the patches of its control mesh, and scheme and values those of the
/// last level. Returns nothing if that is no gain, or if state says something of elements; then all is as before.
/// Preconditions: patches.is_worth_looking(), and the level is patches.begin().
template <class Point, scheme Scheme, class Carried>
std::optional<refined<Point>> last_in_patches(const refined<Point>& surface, Scheme& scheme, Carried& carried,
                                              patch_refinement<Point, std::uint32_t, Scheme>& patches)
{
    const auto& topology = surface.mesh.topology();
    if (not scheme_of_places<Scheme> or not state_marks<std::uint32_t>(topology, scheme).empty())
        return {};
    const fields_in_patches in_patches(
        topology, surface.mesh.generation(), scheme, patches.plan(), connect::everything);
    if (not carried.can_go(in_patches))
        return {};
    auto fine = patches.refine_from(surface.mesh, scheme);
    if (not fine)
        return {};
    carried.go(in_patches);
    for (int generation = surface.mesh.generation(); generation < fine->generation(); ++generation)
        kith::detail::advance_without_elements<native_mesh<Point>>(scheme, generation);
    const bool keeps = std::ranges::all_of(patches.plan().bases, [](const column_bases& step) {
        return step.count(tuple_kind::v, tuple_kind::v) != 0 and step.base(tuple_kind::v, tuple_kind::v) == 0;
    });
    return refined<Point>{std::move(*fine), surface.keeps_vertices and keeps};
}

#endif

/// Refines, and makes scheme and values those of the last level. After each level that is made go_on(share of the work)
/// may say no; then nothing is returned. Where it is a gain the last levels are made at once. Errors: as `refine`.
template <class Point, scheme Scheme, class Carried>
std::optional<refined<Point>> refine(native_mesh<Point> control, Scheme& scheme, int levels, Carried& carried,
                                     bool points_stay, const std::function<bool(double)>& go_on)
{
    refined<Point> surface{std::move(control), true};
    prepare(surface, scheme, carried);
    detail::require_refinable(surface.mesh, scheme, levels, {});
    const auto done = shares_of_work(count(surface.mesh.topology()), scheme, levels, surface.mesh.generation());
    int level = 0;
    const auto go_to = [&](int last) {
        bool goes_on = true;
        while (goes_on and level < last) {
            step(surface, scheme, carried, points_stay);
            goes_on = go_on(done[std::size_t(++level)]);
        }
        return goes_on;
    };
#ifdef KITH_HAS_LANES
    if constexpr (patchable_scheme<Scheme, Point, std::uint32_t>)
        if (not points_stay and carried.template may_go_in_patches<Scheme>()) {
            patch_refinement<Point, std::uint32_t, Scheme> patches(surface.mesh, scheme, levels, connect::everything);
            if (patches.is_worth_looking()) {
                if (not go_to(patches.begin()))
                    return std::nullopt;
                if (auto last = last_in_patches(surface, scheme, carried, patches))
                    return go_on(done.back()) ? std::move(last) : std::nullopt;
            }
        }
#endif
    return go_to(levels) ? std::optional(std::move(surface)) : std::nullopt;
}

} // namespace kith::in_place
