// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.hpp"

#include <kith/core/level/named_level.hpp>
#include <kith/core/level/validate.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/engine/refinement_run.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>

namespace kith {

/// Options of `refine` beside the scheme and the number of levels.
struct refine_options {
    /// The connectivity of the last level. `connect::faces` leaves out its edges, which saves about a third of the time
    /// and nearly half of the memory. If such a mesh is refined again, its edges are found by matching: the surface is
    /// the same, edge numbers differ. Only native meshes can do without edges; meshes of other libraries and the levels
    /// of a `hierarchy` have everything.
    connect last_level = connect::everything;
    /// The limit of memory in bytes. A refinement whose native levels would need more is refused before they are made.
    /// The limit does not count meshes of other libraries that are copied or built. Nor does it count the levels of a
    /// scheme that is no countable_scheme. Such a scheme has matched edges, or a column condition that does not say how
    /// many tuples it picks.
    std::uint64_t memory_limit = std::numeric_limits<std::uint64_t>::max();
};

/// Returns true if a refinement that is made level by level gains from the order of the surface: the control mesh is
/// scattered, and the last level is so large that the scattering costs more than sorting. Levels after the control mesh
/// are as scattered, but look less so. Cost: O(levels).
template <scheme Scheme, class Point, std::unsigned_integral Index>
    requires orderable_scheme<Scheme, Index>
bool is_worth_ordering(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels, connect last_level)
{
    if (not can_be_ordered(control.topology(), scheme, levels))
        return false;
    if (const auto way = forced_way())
        return way == refinement_way::in_surface_order;
    const auto last = plan(count(control.topology()), scheme, levels, control.generation()).back().counts;
    return double(last.faces) >= usual_costs().least_to_order(last_level) and is_scattered(control.topology());
}

namespace detail {

template <scheme Scheme>
void require_levels(int levels)
{
    if (levels < 0)
        refuse_levels(scheme_name<Scheme>(), levels);
}

/// Throws mesh_error if the levels need more bytes than the limit.
void require_bytes(std::string_view scheme, std::uint64_t need, int levels, std::uint64_t limit);
#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY void require_bytes(std::string_view scheme, std::uint64_t need, int levels, std::uint64_t limit)
{
    if (need > limit)
        throw mesh_error(std::string(scheme) + ": " + std::to_string(levels) + " levels need " + std::to_string(need) +
                         " bytes at once, the limit is " + std::to_string(limit) + "; refine fewer times");
}
#endif

/// Throws mesh_error if levels cannot be numbered or do not fit; else returns the number of bytes that are left.
/// Schemes that cannot count their levels are checked step by step.
template <class Point, std::unsigned_integral Index, scheme Scheme>
std::uint64_t require_room(const counts& control, const Scheme& scheme, int levels, int generation, bool keep_levels,
                           const refine_options& options)
{
    if constexpr (countable_scheme<Scheme>) {
        const auto levels_planned = plan(control, scheme, levels, generation, sizeof(Point), sizeof(Index));
        const std::uint64_t need = peak_bytes(levels_planned, keep_levels, options.last_level == connect::faces);
        require_bytes(scheme_name<Scheme>(), need, levels, options.memory_limit);
        return options.memory_limit - need;
    } else {
        return options.memory_limit;
    }
}

/// Returns the bytes that the element numbers of a reordered mesh take in the last step.
template <class Point, std::unsigned_integral Index, countable_scheme Scheme>
std::uint64_t bytes_of_numbers(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels)
{
    const counts coarse = plan(count(control.topology()),
                               scheme,
                               levels - 1,
                               control.generation(),
                               sizeof(double),
                               sizeof(Index))
                              .back()
                              .counts;
    return (coarse.vertices + coarse.edges + coarse.faces) * sizeof(Index);
}

/// Throws mesh_error if `refine` cannot refine a valid mesh; else returns the number of bytes that are left.
template <class Point, std::unsigned_integral Index, scheme Scheme>
std::uint64_t require_refinable(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                                const refine_options& options)
{
    require_levels<Scheme>(levels);
    with_native_level<Scheme>(control,
                              [&](const auto& level) { require_control_level(scheme, level, control.generation()); });
    return require_room<Point, Index>(count(control.topology()), scheme, levels, control.generation(), false, options);
}

/// Returns f(), which refines the native copy of a mesh of this generation. If the scheme refuses faces, the error
/// names them by the numbers of the mesh itself, which differ if it has removed elements. Cost: that of f; if f throws,
/// also that of making the native copy once more.
template <scheme Scheme, mesh M, class F>
auto with_numbers_of(const M& mesh, const Scheme& scheme, int generation, const F& f)
{
    try {
        return f();
    } catch (const mesh_error&) {
        const auto lifted = to_native_valid(mesh);
        require_control_level(
            scheme,
            named_level<typename decltype(lifted)::point_type, std::uint32_t>(lifted, handle_numbers_of(mesh)),
            generation);
        throw;
    }
}

/// Refines a control mesh with any faces and writes the last level into a mesh of another library.
template <scheme Scheme, class Point, std::unsigned_integral Index>
void refine_levels_into(level_writer<Point, Index>& fine, basic_mesh<Point, Index> control, Scheme scheme, int levels,
                        const refine_options& options)
{
    require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    written_last_level last(fine);
    refinement_run(std::move(control), scheme, levels).make(last);
}

/// Returns the strategy of the last steps, which says if they are made in patches, and why.
template <class Point, std::unsigned_integral Index, scheme Scheme>
strategy strategy_in_patches(basic_mesh<Point, Index> control, Scheme scheme, int levels, connect last_level)
{
    no_last_level none(last_level);
    refinement_run run(std::move(control), scheme, levels);
    run.make_in_patches(none);
    return run.so_far();
}

/// Returns a copy with edges. If the mesh has face-vertex lists only, its edges are found by matching.
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> with_edges(const basic_mesh<Point, Index>& mesh)
{
    if (not mesh.topology().faces_only())
        return mesh;
    auto topology = mesh.topology();
    mesh_report report;
    match(topology, report);
    report.require_ok();
    return {storage<Point>(mesh.points()), std::move(topology), mesh.generation()};
}

} // namespace detail

/// Refines a mesh `levels` times and returns a mesh of the same type; the input is not touched.
/// A mesh of another library is converted to a native mesh and refined there. The last level is written straight into a
/// mesh of its type. The bits are those of refining on the mesh itself, level by level, as `hierarchy` does.
/// Errors: mesh_error for everything `validate` finds, for faces the scheme does not take and for negative levels;
/// mesh_error for levels that no index can number or no memory holds; association_error for faults of the scheme.
/// Cost: that of the last level, times 4/3 for a scheme that quadruples faces.
template <class Point, std::unsigned_integral Index, scheme Scheme>
basic_mesh<Point, Index> refine(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels,
                                const refine_options& options = {})
{
    validate(mesh).require_ok();
    auto coarse = detail::with_edges(mesh);
    [[maybe_unused]] const std::uint64_t bytes_left = detail::require_refinable(coarse, scheme, levels, options);
    Scheme of_level = scheme;
    native_last_level<Point, Index> last(options.last_level);
    refinement_run run(std::move(coarse), of_level, levels);
    if constexpr (orderable_scheme<Scheme, Index>)
        if (is_worth_ordering(run.mesh(), scheme, levels, options.last_level) and
            detail::bytes_of_numbers(run.mesh(), scheme, levels) <= bytes_left) {
            run.make_in_order(last);
            return last.take();
        }
    run.make(last);
    return last.take();
}
template <refinable_mesh M, scheme Scheme>
M refine(const M& mesh, const Scheme& scheme, int levels, const refine_options& options = {})
{
    auto control = to_native_valid(mesh);
    return detail::with_numbers_of(mesh, scheme, generation_of(mesh), [&] {
        if constexpr (fillable_mesh<M>) {
            return detail::made_like<typename lifted_point<M>::type>(mesh, [&](auto& fine) {
                detail::refine_levels_into(fine, std::move(control), scheme, levels, options);
            });
        } else {
            detail::require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
            Scheme of_level = scheme;
            native_last_level<typename decltype(control)::point_type, typename decltype(control)::index_type> last(
                connect::everything);
            refinement_run(std::move(control), of_level, levels).make(last);
            return build_like(mesh, last.take());
        }
    });
}

/// Returns how `refine` makes the last level, and why; explain(strategy) says it in a sentence. Errors: those of
/// `refine`. Cost: that of the level with which patches begin, if they are a gain, and of their templates, which are
/// cached.
template <class Point, std::unsigned_integral Index, scheme Scheme>
strategy strategy_of(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels,
                     const refine_options& options = {})
{
    validate(mesh).require_ok();
    auto control = detail::with_edges(mesh);
    detail::require_refinable(control, scheme, levels, options);
    bool is_ordering_worth_it = false;
    if constexpr (orderable_scheme<Scheme, Index>)
        is_ordering_worth_it = is_worth_ordering(control, scheme, levels, options.last_level);
    strategy how = detail::strategy_in_patches(std::move(control), scheme, levels, options.last_level);
    if (how.way == refinement_way::by_levels and is_ordering_worth_it) {
        how.way = refinement_way::in_surface_order;
        how.is_ordered = true;
    }
    return how;
}
template <refinable_mesh M, scheme Scheme>
strategy strategy_of(const M& mesh, const Scheme& scheme, int levels, const refine_options& options = {})
{
    auto control = to_native_valid(mesh);
    detail::require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    return detail::strategy_in_patches(std::move(control), scheme, levels, connect::everything);
}

/// Refines a list of points and a list of faces, such as vectors of std::array<double, 3> and std::array<int, 4>.
/// Returns the native mesh, whose points() and faces() are lists again; `faces_as` gives faces in a type of the caller.
/// Points may be of any type with an `affine`. Errors: as `make_mesh`, and those of `refine`.
template <std::ranges::sized_range Points, class Faces, class Scheme>
    requires std::same_as<Faces, face_list> or
             (std::ranges::input_range<Faces> and std::ranges::range<std::ranges::range_reference_t<const Faces&>>)
auto refine(const Points& points, const Faces& faces, const Scheme& scheme, int levels,
            const refine_options& options = {})
{
    return refine(make_mesh(points, faces), scheme, levels, options);
}

/// Takes arguments that no other overload takes, and says in one sentence what their type lacks.
template <class M, class Scheme>
    requires(not scheme<Scheme>)
const M& refine(const M& mesh, const Scheme&, int, const refine_options& = {})
{
    static_cast<void>(diagnostics::scheme_columns<(sizeof(Scheme) > 0)>());
    return mesh;
}
template <class M, scheme Scheme>
    requires(not refinable_mesh<M>)
const M& refine(const M& mesh, const Scheme&, int, const refine_options& = {})
{
    // To assert the concept itself would make the compiler list all its requirements.
    constexpr bool has_points = requires { requires affine_value<typename mesh_traits<M>::point>; };
    constexpr bool has_point = requires { typename mesh_traits<M>::point; };
    static_cast<void>(diagnostics::point_without_affine<has_point and not has_points>());
    constexpr bool is_mesh = kith::mesh<M> or (has_point and not has_points);
    static_assert(is_mesh,
                  "kith::refine: this type is no mesh to kith; include its adapter (<kith/cgal.hpp>, "
                  "<kith/openmesh.hpp>) or specialise kith::mesh_traits for it");
    static_assert(not kith::mesh<M>,
                  "kith::refine: this mesh can be read, not made; give its kith::mesh_traits a build()");
    return mesh;
}

} // namespace kith
