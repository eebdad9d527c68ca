// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_state.hpp"
#include "refinement.hpp"
#include "scheme.hpp"

#include <kith/core/base/large_blocks.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/core/mesh/foreign_level.hpp>

#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>

namespace kith {

/// Makes one step over the points of a level. Returns the next level as a native mesh and sets `ids` to its numbering.
/// Errors: mesh_error for more elements than the index can number, association_error for faults of the scheme.
template <connect Connect, level Level, scheme Scheme>
auto refine_level(const Level& coarse, const Scheme& scheme, int generation,
                  numbering_of<Scheme, typename Level::index_type>& ids)
{
    const auto columns = columns_of(scheme, generation);
    ids = {coarse, columns};
    point_values<Level> values;
    auto topology = run_scheme<Connect, not is_trusted<Scheme>>(
        coarse, scheme, generation, ids, columns, values, &ids.dictionary);
    return basic_mesh<typename Level::point_type, typename Level::index_type>(
        values.take(), std::move(topology), generation + 1);
}

/// Calls f with the native mesh as the level that fits its faces best: quads, triangles or any.
template <scheme Scheme, class Point, std::unsigned_integral Index, class F>
decltype(auto) with_native_level(const basic_mesh<Point, Index>& mesh, const F& f)
{
    KITH_ASSERT(not mesh.topology().faces_only());
    if constexpr (needs_triangles<Scheme>) {
        if (mesh.topology().degree != 3)
            require_shape<Scheme>(level_elements<native_level<Point, Index, 0>>(mesh));
        return f(level_elements<native_level<Point, Index, 3>>(mesh));
    } else if constexpr (needs_quads<Scheme>) {
        if (mesh.topology().degree != 4)
            require_shape<Scheme>(level_elements<native_level<Point, Index, 0>>(mesh));
        return f(level_elements<native_level<Point, Index, 4>>(mesh));
    } else {
        if (mesh.topology().degree == 4)
            return f(level_elements<native_level<Point, Index, 4>>(mesh));
        return f(level_elements<native_level<Point, Index, 0>>(mesh));
    }
}

/// Makes one step from a native mesh. Precondition: it has its edges. Errors: as `refine_level`, and for faces that the
/// scheme does not take.
template <connect Connect, scheme Scheme, class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> refine_mesh(const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                                     numbering_of<Scheme, Index>& ids)
{
    if constexpr (wrapped_scheme<Scheme>)
        return refine_mesh<Connect>(mesh, scheme.plain(), ids);
    else
        return with_native_level<Scheme>(
            mesh, [&](const auto& level) { return refine_level<Connect>(level, scheme, mesh.generation(), ids); });
}

/// Returns true if the next level of a closed level is closed; `ids` is its numbering. A scheme may make faces around
/// holes. Cost: O(1); O(new faces) for a scheme that makes faces of several degrees and cannot count them.
template <level Level, scheme Scheme, level_numbering Numbering>
bool stays_closed(const Level& coarse, const Scheme& scheme, int generation, const Numbering& ids)
{
    if constexpr (Numbering::common_degree != 0) {
        return ids.faces.total() * Numbering::common_degree == 2 * ids.edges.total();
    } else if constexpr (countable_scheme<Scheme>) {
        return next_counts(scheme, {coarse.vertex_count(), coarse.edge_count(), coarse.face_count()}, generation)
                   .boundary_edges == 0;
    } else {
        std::atomic<std::size_t> corners = 0;
        detail::for_new_faces(coarse, ids, columns_of(scheme, generation), [&](std::size_t, const auto& degree) {
            corners.fetch_add(std::size_t(degree()), std::memory_order_relaxed);
        });
        return corners == 2 * ids.edges.total();
    }
}

/// Makes one step and writes the next level into a mesh of another library, directly if the scheme is trusted and
/// declares its edges. Errors: as `refine_level`, and those of `make_room`.
template <class Point, level Level, scheme Scheme>
void refine_level_into(level_writer<Point, typename Level::index_type>& fine, const Level& coarse, const Scheme& scheme,
                       int generation, numbering_of<Scheme, typename Level::index_type>& ids)
{
    if constexpr (is_trusted<Scheme> and std::remove_cvref_t<decltype(ids)>::has_edges) {
        ids = {coarse, columns_of(scheme, generation)};
        fine.make_room(ids.vertices.total(),
                       ids.edges.total(),
                       ids.faces.total(),
                       coarse.is_closed() and stays_closed(coarse, scheme, generation, ids));
        run_scheme_into(fine, coarse, scheme, generation, ids, &ids.dictionary);
    } else {
        write_level(fine, refine_level<connect::everything>(coarse, scheme, generation, ids));
    }
}

/// Makes one step from a native mesh and writes the next level into a mesh of another library. Precondition: the native
/// mesh has its edges. Errors: as `refine_level_into`, and for faces that the scheme does not take.
template <scheme Scheme, class Point, std::unsigned_integral Index>
void refine_mesh_into(level_writer<Point, Index>& fine, const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                      numbering_of<Scheme, Index>& ids)
{
    if constexpr (wrapped_scheme<Scheme>)
        refine_mesh_into(fine, mesh, scheme.plain(), ids);
    else
        with_native_level<Scheme>(
            mesh, [&](const auto& level) { refine_level_into(fine, level, scheme, mesh.generation(), ids); });
}

namespace detail {

/// A function that writes a level.
template <class Point>
using level_source = std::function<void(level_writer<Point, std::uint32_t>&)>;

/// Returns a mesh written by write(level_writer). The mesh is made in place, in a function of its own: g++ before 14
/// would copy a mesh of OpenMesh out of an inner block.
template <class Point, fillable_mesh M, class Write>
M make_here(const M& source, const Write& write)
{
    M result;
    foreign_level<M, Point> fine(result, &source);
    write(fine);
    return result;
}

/// Returns a mesh as make_here does, but is compiled in the library that `is_compiled_mesh` names.
template <fillable_mesh M, class Point>
M make_in_library(const M& source, const level_source<Point>& write);

/// Returns a mesh of the type of `source`, written by write(level_writer).
template <class Point, fillable_mesh M, class Write>
M made_like(const M& source, const Write& write)
{
    if constexpr (is_compiled_mesh<M> and std::same_as<Point, typename lifted_point<M>::type>)
        return make_in_library<M, Point>(source, write);
    else
        return make_here<Point>(source, write);
}

} // namespace detail

/// Makes one step and returns the next level as a mesh of the type of `source`, from which it was refined. Errors: as
/// `refine_level`, and those of `make_room` or `build`.
template <mesh M, level Level, scheme Scheme>
M refine_level_like(const M& source, const Level& coarse, const Scheme& scheme, int generation,
                    numbering_of<Scheme, typename Level::index_type>& ids)
{
    if constexpr (wrapped_scheme<Scheme>) {
        return refine_level_like(source, coarse, scheme.plain(), generation, ids);
    } else if constexpr (fillable_mesh<M>) {
        return detail::made_like<typename Level::point_type>(
            source, [&](auto& fine) { refine_level_into(fine, coarse, scheme, generation, ids); });
    } else {
        auto fine = refine_level<connect::everything>(coarse, scheme, generation, ids);
        shared_blocks.give_back(); // the other library takes its memory elsewhere
        return build_like(source, std::move(fine));
    }
}

/// Makes one step from a native mesh and returns the next level as a mesh of the type of `source`. Precondition: the
/// native mesh has its edges. Errors: as `refine_level_like`, and for faces that the scheme does not take.
template <mesh M, scheme Scheme, class Point, std::unsigned_integral Index>
M refine_mesh_like(const M& source, const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                   numbering_of<Scheme, Index>& ids)
{
    if constexpr (fillable_mesh<M>) {
        return detail::made_like<Point>(source, [&](auto& fine) { refine_mesh_into(fine, mesh, scheme, ids); });
    } else {
        return with_native_level<Scheme>(
            mesh, [&](const auto& level) { return refine_level_like(source, level, scheme, mesh.generation(), ids); });
    }
}

/// A stand-in for data that is carried along with a refinement, if there is none. `advance` makes such data that of the
/// next level, whose points it may change, and returns false to stop the refinement.
struct nothing_carried {
    template <finished_step Step, mesh Fine>
    bool advance(const Step&, Fine&) const
    {
        return true;
    }
};

/// Makes a native mesh its next level, and advances the scheme and the data carried along to that level. Returns false
/// if `carried` stops the refinement. Precondition: the mesh has its edges. Errors: as `refine_mesh`.
template <connect Connect, scheme Scheme, class Point, std::unsigned_integral Index, class Carried>
bool make_next_level(basic_mesh<Point, Index>& mesh, Scheme& scheme, Carried& carried)
{
    numbering_of<Scheme, Index> ids;
    auto fine = refine_mesh<Connect>(mesh, scheme, ids);
    const level_of<basic_mesh<Point, Index>> coarse(mesh);
    const int generation = mesh.generation();
    const step_result<Scheme, level_of<basic_mesh<Point, Index>>, numbering_of<Scheme, Index>, basic_mesh<Point, Index>>
        made{scheme, coarse, generation, ids, fine};
    const bool goes_on = carried.advance(made, fine);
    advance(scheme, coarse, generation, ids, fine);
    mesh = std::move(fine);
    return goes_on;
}

/// Makes `steps` steps with all connectivity. Returns false if `carried` stops them.
template <scheme Scheme, class Point, std::unsigned_integral Index, class Carried = const nothing_carried>
bool make_levels(basic_mesh<Point, Index>& mesh, Scheme& scheme, int steps, Carried& carried = {})
{
    for (; steps > 0; --steps)
        if (not make_next_level<connect::everything>(mesh, scheme, carried))
            return false;
    return true;
}

} // namespace kith
