// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scheme.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/level/for_each.hpp>
#include <kith/core/level/values.hpp>
#include <kith/core/mask/choose.hpp>
#include <kith/core/mesh/match.hpp>
#include <kith/numbering/association/pass_space.hpp>
#include <kith/numbering/association/polygon.hpp>
#include <kith/numbering/association/step_context.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace kith {

/// One refinement step as a scheme sees it: `auto& [coarse, assoc, generation] = r;`
template <level_or_block Level, mask_evaluator Space, weight_number Scalar>
struct refinement {
    using scalar = Scalar;

    const Level& coarse; ///< the level that is read
    const Space& assoc;  ///< its association space; assigning to an association makes an element of the next level
    int generation;      ///< steps since the control mesh
};

/// The number type in which a scheme computes its weights.
template <has_scalar Refinement>
using scalar_type = typename Refinement::scalar;

namespace detail {

/// Calls f(id, degree) for each new face, on threads; `degree()` returns the number of its corners.
template <level Level, level_numbering Numbering, declared_columns Columns, class F>
void for_new_faces(const Level& coarse, const Numbering& ids, const Columns& columns, const F& f)
{
    const auto in_column = [&]<tuple_kind K, class W, class D>(const column<K, W, D>& c) {
        constexpr std::size_t each = tuples_per_element(K);
        for_each_by_number(tuple_elements_of<K>(coarse), [&](const auto& x) {
            for (std::size_t tuple = each * x.index(); tuple < each * (x.index() + 1); ++tuple)
                if (const auto id = ids.faces.template id<K>(tuple); id != ids.faces.none)
                    f(id, [&] { return c.degree(x); });
        });
    };
    std::apply([&](const auto&... c) { (in_column(c), ...); }, columns.faces.list);
}

/// Returns 3 or 4 if all new faces have that many corners, else 0.
template <level Level, level_numbering Numbering, declared_columns Columns>
int degree_of_all(const Level& coarse, const Numbering& ids, const Columns& columns)
{
    constexpr std::size_t unknown = 0, mixed = std::numeric_limits<std::size_t>::max();
    std::atomic<std::size_t> common = unknown;
    for_new_faces(coarse, ids, columns, [&](std::size_t, const auto& degree) {
        std::size_t so_far = common.load(std::memory_order_relaxed);
        if (so_far == mixed)
            return;
        const std::size_t here = degree();
        if (so_far == unknown and common.compare_exchange_strong(so_far, here, std::memory_order_relaxed))
            return;
        if (here != so_far)
            common.store(mixed, std::memory_order_relaxed);
    });
    return common == 3 or common == 4 ? int(common) : 0;
}

/// Returns `size` times `none`, written by all threads.
template <std::unsigned_integral Index>
storage<Index> none_yet(std::size_t size)
{
    storage<Index> result(size);
    for_parts(size, true, [&](std::size_t begin, std::size_t end) {
        std::fill(result.begin() + begin, result.begin() + end, connectivity<Index>::none);
    });
    return result;
}

/// Returns the connectivity of the next level, allocated as far as its numbering determines it.
template <connect Connect, bool Checked, level Level, level_numbering Numbering, declared_columns Columns>
auto allocate_level(const Level& coarse, const Numbering& ids, const Columns& columns)
{
    using index = typename Numbering::index_type;
    connectivity<index> fine;
    if constexpr (Connect != connect::nothing) {
        fine.vertices = ids.vertices.total();
        fine.faces = ids.faces.total();
        fine.degree = int(Numbering::common_degree);
        std::size_t corners = fine.faces * Numbering::common_degree;
        if constexpr (Numbering::common_degree == 0) {
            fine.degree = degree_of_all(coarse, ids, columns);
            corners = fine.faces * std::size_t(fine.degree);
            if (fine.degree == 0) {
                fine.face_corner = storage<index>(fine.faces + 1);
                for_new_faces(coarse, ids, columns, [&](std::size_t id, const auto& degree) {
                    fine.face_corner[id + 1] = index(degree());
                });
                corners = fine.sum_degrees();
            }
        }
        // If edges are matched, there may be two half-edges for each corner.
        require_numbers<index>(corners, Connect == connect::everything and not Numbering::has_edges ? 2 : 1, "corners");
        if (fine.degree == 0)
            fine.corner_face = storage<index>(corners);
        fine.corner_vertex = storage<index>(corners);
        if constexpr (Connect == connect::everything and Numbering::has_edges) {
            const bool clear = Checked or corners != 2 * ids.edges.total(); // else each side is written
            fine.corner_halfedge = storage<index>(corners);
            fine.halfedge_corner = clear ? none_yet<index>(2 * ids.edges.total())
                                         : storage<index>(2 * ids.edges.total());
            fine.vertex_corner = Checked ? none_yet<index>(fine.vertices) : storage<index>(fine.vertices);
        }
    }
    return fine;
}

/// Starts the fan of each boundary vertex behind the boundary edge that leaves the vertex: no face lies clockwise of
/// it. Precondition if `parallel`: no vertex has several fans at the boundary.
template <std::unsigned_integral Index>
void turn_boundary_fans(connectivity<Index>& fine, bool parallel)
{
    constexpr std::size_t edges_at_once = 16; // looked at side by side, since few are at the boundary
    for_parts(fine.edges(), parallel, [&](std::size_t begin, std::size_t end) {
        const Index* const sides = fine.halfedge_corner.data();
        const auto turn = [&](std::size_t first, std::size_t last) {
            for (std::size_t e = first; e < last; ++e)
                if (fine.is_boundary(e)) {
                    const Index c = sides[2 * e];
                    fine.vertex_corner[fine.corner_vertex[c]] = c;
                }
        };
        std::size_t e = begin;
        for (; e + edges_at_once <= end; e += edges_at_once) {
            Index without_face = 0;
            for (std::size_t side = 0; side < 2 * edges_at_once; ++side)
                without_face += Index(sides[2 * e + side] == fine.none);
            if (without_face != 0)
                turn(e, e + edges_at_once);
        }
        turn(e, end);
    });
}

/// Throws association_error for faults that cannot be seen while a scheme runs: elements that were never made, and
/// faces that form no manifold. Starts the fans for which the scheme has set no start.
template <level Level, level_numbering Numbering, std::unsigned_integral Index>
void check_level(const Level& coarse, const Numbering& ids, connectivity<Index>& fine, const made_elements<Index>& made)
{
    const auto require_all = [&](const auto& column_ids, const auto& is_set, const char* why) {
        for (std::size_t id = 0; id < is_set.size(); ++id)
            if (not is_set[id]) {
                const auto [kind, index] = column_ids.origin(id);
                faults::refuse(coarse, kind, index, why);
            }
    };
    require_all(ids.vertices, made.vertices(), " -> V was never set");
    require_all(ids.faces, made.faces(), " -> F was never set");
    for (std::size_t e = 0; e < fine.edges(); ++e)
        if (fine.halfedge_corner[2 * e] == fine.none) {
            const auto [kind, index] = ids.edges.origin(e);
            faults::refuse(coarse, kind, index, " -> E has no face on its left side");
        }
    for (std::size_t e = 0; e < fine.edges(); ++e) {
        const Index left = fine.halfedge_corner[2 * e], right = fine.halfedge_corner[2 * e + 1];
        if (right != fine.none and
            (fine.corner_vertex[left] != fine.target(right) or fine.corner_vertex[right] != fine.target(left))) {
            const auto [kind, index] = ids.edges.origin(e);
            faults::refuse(coarse, kind, index, " -> E: its two half-edges join different vertices");
        }
    }
    if (fine.vertex_corner.empty())
        return;
    for (std::size_t v = 0; v < made.starts().size(); ++v)
        if (const Index c = fine.vertex_corner[v];
            c != fine.none and
            (c >= fine.corners() or fine.corner_vertex[c] != v or fine.corner_halfedge[c] != made.starts()[v])) {
            const auto [kind, index] = ids.vertices.origin(v);
            faults::refuse(
                coarse, kind, index, " -> V has a wrong start: the corner or the half-edge does not belong to it");
        }
    for (std::size_t c = 0; c < fine.corners(); ++c) // vertices for which the scheme named no start
        if (Index& start = fine.vertex_corner[fine.corner_vertex[c]]; start == fine.none)
            start = Index(c);
    for (std::size_t v = 0; v < fine.vertices; ++v)
        if (fine.vertex_corner[v] == fine.none) {
            const auto [kind, index] = ids.vertices.origin(v);
            faults::refuse(coarse, kind, index, " -> V is in no face");
        }
}

/// Throws association_error for vertices at which several fans of faces meet. Precondition: boundary fans have been
/// turned.
template <level Level, level_numbering Numbering, std::unsigned_integral Index>
void check_fans(const Level& coarse, const Numbering& ids, const connectivity<Index>& fine)
{
    std::vector<Index> faces(fine.vertices, 0);
    for (const Index v : fine.corner_vertex)
        ++faces[v];
    for (std::size_t v = 0; v < fine.vertices; ++v) {
        const Index start = fine.vertex_corner[v];
        Index met = 0, c = start;
        do {
            ++met;
            c = fine.next_in_fan(c);
        } while (c != fine.none and c != start);
        if (met != faces[v]) {
            const auto [kind, index] = ids.vertices.origin(v);
            faults::refuse(list_tuple(coarse, kind, index),
                           " -> V is in " + std::to_string(faces[v]) + " faces, but a walk across edges reaches only " +
                               std::to_string(met) + "; let adjacent faces name the same new edge");
        }
    }
}

/// Calls a scheme for one step. If it is no function of a step, one sentence says so; no concept requires it before.
template <class Scheme, step_context Refinement>
void call(const Scheme& scheme, const Refinement& r)
{
    if constexpr (std::invocable<const Scheme&, const Refinement&>)
        scheme(r);
    else
        static_cast<void>(diagnostics::scheme_call<(sizeof(Scheme) > 0)>());
}

} // namespace detail

/// Runs a scheme once: fills `values` with the values of the next level and returns its connectivity, as far as
/// `Connect` asks. Only the call operator of the scheme is needed here, so a function of a step_context is as good.
/// Hands the vertices that are in no column to `dictionary`, unless it is null.
/// Errors: association_error for faults of the scheme. Cost: that of the scheme.
template <connect Connect, bool Checked, level Level, class Scheme, level_numbering Numbering, declared_columns Columns,
          values_of_step<Level> Values>
auto run_scheme(const Level& coarse, const Scheme& scheme, int generation, const Numbering& ids, const Columns& columns,
                Values& values, vertex_dictionary<typename Numbering::index_type>* dictionary = nullptr)
{
    auto fine = detail::allocate_level<Connect, Checked>(coarse, ids, columns);
    values.allocate(ids.vertices.total());
    using space = association_space<Level, Numbering, Values, Connect, Checked>;
    space assoc(coarse, ids, values, fine);
    const detail::loop_body outside(false); // the caller's loops are not the scheme's
    detail::call(scheme, refinement<Level, space, typename Values::scalar>{coarse, assoc, generation});
    if (dictionary != nullptr)
        *dictionary = assoc.take_dictionary();
    if constexpr (Checked and Connect != connect::nothing)
        detail::check_level(coarse, ids, fine, assoc.made());
    if constexpr (Connect != connect::nothing)
        fine.vertices += values.listed_count();
    if constexpr (Connect == connect::everything) {
        if constexpr (Numbering::has_edges) {
            if (fine.corners() != 2 * fine.edges())
                detail::turn_boundary_fans(fine, not Checked);
            // A scheme for closed meshes may make anything at the cut of a part, which is given ghosts for that.
            if constexpr (Checked)
                if (coarse.is_closed() or not needs_closed<Scheme>)
                    detail::check_fans(coarse, ids, fine);
        } else {
            mesh_report report;
            match(fine, report);
            if (not report)
                throw association_error("the faces that the scheme made do not form a manifold:\n" + report.text());
        }
    }
    return fine;
}

/// Runs a scheme once and writes the next level into a sink, which has room. Precondition: the scheme is trusted and
/// declares its edges.
template <level_sink Sink, level Level, scheme Scheme, level_numbering Numbering>
void run_scheme_into(Sink& fine, const Level& coarse, const Scheme& scheme, int generation, const Numbering& ids,
                     vertex_dictionary<typename Numbering::index_type>* dictionary = nullptr)
{
    point_values<Level> values;
    values.allocate_at(fine.points(), ids.vertices.total());
    using space = association_space<Level, Numbering, point_values<Level>, connect::everything, false, Sink>;
    space assoc(coarse, ids, values, fine);
    const detail::loop_body outside(false);
    detail::call(scheme, refinement<Level, space, typename point_values<Level>::scalar>{coarse, assoc, generation});
    if (dictionary != nullptr)
        *dictionary = assoc.take_dictionary();
    fine.finish(generation + 1);
}

} // namespace kith
