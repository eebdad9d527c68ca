// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/engine/refinement_run.hpp>
#include <kith/fields/values_in_patches.hpp>
#include <kith/four_eight.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/plan.hpp>
#include <kith/refine.hpp>

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

/// A refined mesh that is going to overwrite a mesh of another library. That mesh is not changed before the last level
/// is complete.
template <class Point>
struct refined {
    native_mesh<Point> mesh;
    bool keeps_vertices; ///< the first vertices are those of the control mesh, in their order
};

/// Returns true if the new vertex of each old vertex has the number of the old one.
template <element_ids Ids>
bool keeps_vertices(const Ids& ids, std::size_t vertices)
{
    if constexpr (Ids::template has<tuple_kind::v>)
        return vertices != 0 and ids.template id<tuple_kind::v>(0) == 0 and
               ids.template id<tuple_kind::v>(vertices - 1) == vertices - 1;
    else
        return false;
}

/// Values that are carried through a refinement in place, such as carried_values, and whether the first vertices are
/// those of the control mesh. If points stay, old vertices do not move, as if each had been reset after each step.
template <scheme Scheme, class Carried, class AfterStep>
class carried_in_place {
public:
    /// Takes the values and a function after_step(numbering, points). It is called with the new points of each step
    /// before they are used. If it returns false, the refinement stops.
    carried_in_place(Carried& values, bool& keeps_vertices, bool points_stay, const AfterStep& after_step)
        : values_(values), keeps_vertices_(keeps_vertices), points_stay_(points_stay), after_step_(after_step)
    {
    }

    [[nodiscard]] static constexpr bool needs_scheme() { return true; }
    template <finished_step Step, mesh Fine>
    bool advance(const Step& step, Fine& fine)
    {
        const std::size_t old = step.coarse.vertex_count();
        const bool keeps = in_place::keeps_vertices(step.ids.vertices, old);
        if (points_stay_ and keeps)
            for (const auto v : step.coarse.vertices())
                fine.points()[v.index()] = v.point();
        const bool goes_on = after_step_(step.ids, fine.points());
        values_.advance(step, points_stay_ and keeps);
        keeps_vertices_ = keeps_vertices_ and keeps;
        return goes_on;
    }

#ifdef KITH_HAS_LANES
    [[nodiscard]] bool may_go_in_patches() const
    {
        return not points_stay_ and values_.template may_go_in_patches<Scheme>();
    }
    template <class Mesh>
    bool enter_patches(const Mesh& level, const Scheme& scheme, const patch_plan& plan, connect last_level)
    {
        in_patches_.emplace(level.topology(), level.generation(), scheme, plan, last_level);
        plan_ = &plan;
        return values_.can_go(*in_patches_);
    }
    bool leave_patches()
    {
        values_.go(*in_patches_);
        keeps_vertices_ = keeps_vertices_ and std::ranges::all_of(plan_->bases, [](const column_bases& step) {
                              return step.count(tuple_kind::v, tuple_kind::v) != 0 and
                                     step.base(tuple_kind::v, tuple_kind::v) == 0;
                          });
        return true;
    }
#else
    [[nodiscard]] static constexpr bool may_go_in_patches() { return false; }
    static constexpr bool leave_patches() { return true; }
#endif

private:
    Carried& values_;
    bool& keeps_vertices_;
    bool points_stay_;
    const AfterStep& after_step_;
#ifdef KITH_HAS_LANES
    std::optional<fields_in_patches<std::uint32_t, Scheme>> in_patches_;
    const patch_plan* plan_ = nullptr;
#endif
};

/// Makes one step, and takes the scheme and the values to the next level. change(numbering, points) is called with the
/// new points before they are used.
template <class Point, scheme Scheme, class Carried, class Change>
void step(refined<Point>& surface, Scheme& scheme, Carried& values, bool points_stay, const Change& change)
{
    const auto after_step = [&](const auto& ids, const auto& points) {
        change(ids, points);
        return true;
    };
    carried_in_place<Scheme, Carried, decltype(after_step)> carried(
        values, surface.keeps_vertices, points_stay, after_step);
    make_next_level<connect::everything>(surface.mesh, scheme, carried);
}
template <class Point, scheme Scheme, class Carried>
void step(refined<Point>& surface, Scheme& scheme, Carried& values, bool points_stay)
{
    step(surface, scheme, values, points_stay, [](const auto&, const auto&) {});
}

/// Prepares a mesh for the first step of a scheme. Only 4-8 needs this: any mesh becomes a tri-quad mesh, as by
/// `tri_quad`.
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

/// Throws mesh_error if the mesh has faces that the scheme does not take, and names them by the numbers of the mesh's
/// handles. `control` is the native copy of the mesh. The 4-8 scheme takes any faces.
template <mesh M, class Point, scheme Scheme>
void require_faces(const M& mesh, const native_mesh<Point>& control, const Scheme& scheme)
{
    if constexpr (not std::same_as<Scheme, four_eight>)
        detail::with_numbers_of(mesh, scheme, control.generation(), [&] {
            detail::require_control_level(scheme, level_of<native_mesh<Point>>(control), control.generation());
        });
}

/// Refines, and takes the scheme and the values to the last level. go_on(share of the work done) is called after each
/// level; if it returns false, nothing is returned. If that is faster, the last levels are made at once. Errors: as
/// `refine`.
template <class Point, scheme Scheme, class Carried>
std::optional<refined<Point>> refine(native_mesh<Point> control, Scheme& scheme, int levels, Carried& values,
                                     bool points_stay, const std::function<bool(double)>& go_on)
{
    refined<Point> surface{std::move(control), true};
    prepare(surface, scheme, values);
    detail::require_refinable(surface.mesh, scheme, levels, {});
    const auto done = shares_of_work(count(surface.mesh.topology()), scheme, levels, surface.mesh.generation());
    int level = 0;
    const auto after_step = [&](const auto&, const auto&) { return go_on(done[std::size_t(++level)]); };
    using carried_type = carried_in_place<Scheme, Carried, decltype(after_step)>;
    carried_type carried(values, surface.keeps_vertices, points_stay, after_step);
    native_last_level<Point, std::uint32_t> last(connect::everything);
    refinement_run<Point, std::uint32_t, Scheme, carried_type> run(std::move(surface.mesh), scheme, levels, carried);
    if (not run.make(last) or (level < levels and not go_on(done.back())))
        return std::nullopt;
    surface.mesh = last.take();
    return surface;
}

} // namespace kith::in_place
