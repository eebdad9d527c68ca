// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_of_patches.hpp"
#include "global_levels.hpp"

#include <kith/engine/neighbourhood/affine_columns.hpp>
#include <kith/engine/neighbourhood/descents.hpp>
#include <kith/engine/neighbourhood/face_classes.hpp>
#include <kith/engine/patch/patched_level.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/tiles/number/column_facts.hpp>
#include <kith/tiles/part/closure_of_faces.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// Requirements of a scheme whose last steps on a tile may be made in patches: one formula gives the numbers of all
/// steps.
template <class Scheme, class Point, class Index>
concept patchable_in_tiles = patchable_scheme<Scheme, Point, Index> and not has_numbers_by_marks<Scheme> and
                             not detail::may_ask_state<Scheme>() and owners_keep_descendants<Scheme>;

namespace detail {

/// Returns the plan of patches for the mesh of a tile, or nothing if there are no patches. It counts as for a closed
/// mesh, so that elements beyond the cut have numbers, too. If faces have several degrees, the counts are those of a
/// mesh with four corners per vertex. These suffice for the corners of all new faces. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<patch_plan> plan_for_tile(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels)
{
    const auto& t = mesh.topology();
    counts closed{t.vertices, t.edges(), t.faces};
    if constexpr (numbering_of<Scheme, Index>::common_degree == 0) {
        closed.vertices = std::max(t.vertices, (t.edges() + 1) / 2);
        closed.edges = 2 * closed.vertices;
    }
    return plan_patches(closed, t.degree, scheme, levels, mesh.generation());
}

#ifdef KITH_HAS_LANES

/// The last level of a tile's owned faces, made directly at its final places. It is for schemes whose faces have only
/// vertices that descend from elements of the same coarse face. The elements of the owned faces are then numbered
/// alone, and all other numbers follow from these.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
class owned_in_patches {
public:
    /// Plans the steps that begin with this tile and its scheme. `there` are the columns of the steps in the whole
    /// mesh.
    owned_in_patches(const tile<Point, Index>& coarse, const Scheme& scheme, const patch_plan& plan,
                     std::span<const column_bases> there)
        : coarse_(coarse), scheme_(scheme), steps_(int(plan.bases.size())), there_(there)
    {
    }

    /// Returns the last level, or nothing if patches do not pay at these costs. Cost: that of the patches.
    [[nodiscard]] std::optional<tile<Point, Index>> make(const face_classes<Index>& classes,
                                                         const strategy_costs& costs) const
    {
        const auto ours = patches_of(owned_faces_of(coarse_), classes, costs);
        if (not ours)
            return {};
        std::vector<Index> rim = makers_of(ours->closure);
        tile<Point, Index> result;
        storage<Point> points(ours->plan.last().vertices);
        connectivity<Index> faces;
        faces.allocate_faces(ours->plan.last().faces, int(degree), [](std::size_t) { return degree; });
        faces.vertices = points.size();
        ours->made.fill(coarse_.mesh,
                        {.points = points.data(),
                         .corner_vertex = faces.corner_vertex.data(),
                         .coarse_numbers = &ours->closure.numbers});
        if (not rim.empty())
            take_points_of_rim(*ours, *patches_of(std::move(rim), classes, without_choice(costs)), points);
        number_vertices(*ours, result);
        number_faces(ours->closure.faces, result);
        result.mesh = basic_mesh<Point, Index>(std::move(points), std::move(faces), coarse_.mesh.generation() + steps_);
        return result;
    }

private:
    static constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;

    /// Some faces with their patches, numbered within the closure of these faces.
    struct numbered_patches {
        closure_of_faces<Index> closure;
        patch_plan plan;
        patched_level<Point, Index> made;
    };

    static strategy_costs without_choice(strategy_costs costs)
    {
        costs.to_be_cheaper = strategy_costs::without_choice().to_be_cheaper;
        return costs;
    }
    [[nodiscard]] std::optional<numbered_patches> patches_of(std::vector<Index> faces, face_classes<Index> classes,
                                                             const strategy_costs& costs) const
    {
        const auto& t = coarse_.mesh.topology();
        const int generation = coarse_.mesh.generation();
        std::vector<unsigned char> is_one(t.faces, 0);
        for (const Index f : faces)
            is_one[f] = 1;
        classes.keep_marked(is_one);
        closure_of_faces<Index> closure(t, std::move(faces), degree);
        auto plan = plan_patches(closure.count(), int(degree), scheme_, steps_, generation);
        if (not plan)
            return {};
        plan->begin_at(0, scheme_, generation);
        auto made = patched_level<Point, Index>::make(
            coarse_.mesh,
            classes,
            recorder_of<scalar_of<Point>, Index, Scheme>(scheme_, *plan, generation, {}),
            *plan,
            costs,
            false);
        if (not made)
            return {};
        return numbered_patches{std::move(closure), std::move(*plan), std::move(*made)};
    }

    [[nodiscard]] Index maker_of(tuple_kind kind, std::size_t element) const
    {
        return face_of_patch(coarse_.mesh.topology(), kind, element);
    }
    /// Returns the faces that are not owned and whose patches make points of owned faces, increasing.
    [[nodiscard]] std::vector<Index> makers_of(const closure_of_faces<Index>& owned) const
    {
        std::vector<unsigned char> is_maker(coarse_.mesh.face_count(), 0);
        for (const Index v : owned.vertices)
            is_maker[maker_of(tuple_kind::v, v)] = 1;
        for (const Index e : owned.edges)
            is_maker[maker_of(tuple_kind::e, e)] = 1;
        std::vector<Index> result;
        for (std::size_t f = 0; f < is_maker.size(); ++f)
            if (is_maker[f] != 0 and not coarse_.owns_face(f))
                result.push_back(Index(f));
        return result;
    }
    /// Copies the points on the border of the owned faces that patches of other faces make.
    void take_points_of_rim(const numbered_patches& ours, const numbered_patches& rim, storage<Point>& points) const
    {
        storage<Point> of_rim(rim.plan.last().vertices);
        rim.made.fill(coarse_.mesh, {.points = of_rim.data(), .coarse_numbers = &rim.closure.numbers});
        const auto from = descents_of(tuple_kind::v, rim.plan.bases, degree),
                   to = descents_of(tuple_kind::v, ours.plan.bases, degree);
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (to[i].from == tuple_kind::f)
                continue;
            const bool is_of_edges = to[i].from == tuple_kind::e;
            const std::vector<Index>& elements = is_of_edges ? ours.closure.edges : ours.closure.vertices;
            const storage<Index>& number = rim.closure.numbers.of(to[i].from);
            for (std::size_t x = 0; x < elements.size(); ++x)
                if (not coarse_.owns_face(maker_of(to[i].from, elements[x])))
                    std::copy_n(of_rim.begin() + from[i].first + from[i].each * number[elements[x]],
                                to[i].each,
                                points.begin() + to[i].first + to[i].each * x);
        }
    }
    /// Writes the numbers and marks of the vertices. A vertex between two tiles belongs to the tile that owns the
    /// element from which the vertex descends.
    void number_vertices(const numbered_patches& ours, tile<Point, Index>& result) const
    {
        result.vertex_ids = storage<global_id>(ours.plan.last().vertices);
        result.vertex_marks = storage<unsigned char>(ours.plan.last().vertices);
        const auto here = descents_of(tuple_kind::v, ours.plan.bases, degree),
                   there = descents_of(tuple_kind::v, there_, degree);
        for (std::size_t i = 0; i < here.size(); ++i) {
            const auto kind = parent_kind(here[i].from);
            const auto ids = ids_of(coarse_, kind);
            const auto marks = marks_of(coarse_, kind);
            const std::vector<Index>& elements = kind == element_kind::vertex ? ours.closure.vertices
                                                 : kind == element_kind::edge ? ours.closure.edges
                                                                              : ours.closure.faces;
            global_id* id = result.vertex_ids.data() + here[i].first;
            unsigned char* mark = result.vertex_marks.data() + here[i].first;
            for (const Index x : elements) {
                std::iota(id, id + here[i].each, there[i].first + there[i].each * ids[x]);
                id += here[i].each;
                mark = std::fill_n(mark, here[i].each, static_cast<unsigned char>(marks[x] & owned_mark));
            }
        }
    }

    /// Writes the numbers, marks and roots of the faces that descend from `owned`, in their order.
    void number_faces(const std::vector<Index>& owned, tile<Point, Index>& result) const
    {
        const auto there = descents_of(tuple_kind::f, there_, degree);
        std::size_t each = 0;
        for (const descent& way : there)
            each += way.each;
        const std::size_t size = each * owned.size();
        result.face_ids = storage<global_id>(size);
        result.root_of = storage<Index>(size);
        result.face_marks = storage<unsigned char>(size);
        std::ranges::fill(result.face_marks, owned_mark);
        result.roots = coarse_.roots;
        global_id* id = result.face_ids.data();
        Index* root = result.root_of.data();
        for (const descent& way : there)
            for (const Index f : owned) {
                std::iota(id, id + way.each, way.first + way.each * coarse_.face_ids[f]);
                id += way.each;
                root = std::fill_n(root, way.each, coarse_.root_of[f]);
            }
    }

    const tile<Point, Index>& coarse_;
    const Scheme& scheme_;
    int steps_;
    std::span<const column_bases> there_;
};

#endif

} // namespace detail

/// Returns the level from which the remaining steps of a tile of level 0 may be made in patches, or `levels` if there
/// is none. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
int first_in_patches([[maybe_unused]] const tile<Point, Index>& control, [[maybe_unused]] const Scheme& scheme,
                     int levels)
{
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        const auto plan = detail::plan_for_tile(control.mesh, scheme, levels);
        if (plan and not are_patches_ruled_out())
            return plan->begin;
    }
    return levels;
}

/// Returns the costs that decide whether patches pay for a tile of this level. A template is taken to serve as many
/// tiles as classes have faces in a sample, which are many where faces are alike. Cost: O(faces of the tile).
template <tile_like Tile, declared_columns Columns>
strategy_costs costs_in_tiles(const Tile& coarse, int level, const global_levels<Columns>& whole)
{
    constexpr std::size_t looks = 128;
    const auto owned = std::max<std::uint64_t>(owned_count(coarse.face_marks), 1);
    const double tiles = double(whole.counts(level).faces) / double(owned);
    const auto& t = coarse.mesh.topology();
    const double faces_of_class = t.faces == 0 ? 1 : 1 / share_of_classes(t, 1, looks);
    return usual_costs(strategy_costs().if_in_tiles(std::max(std::min(tiles, faces_of_class), 1.)));
}

/// Makes the remaining steps of a tile of level `level` at once, in patches. Returns the owned faces of the last level
/// with their vertices, without edges and ghosts. Returns nothing if patches do not pay at these costs. The bits are
/// those of refine_once and refine_last. `scheme` is the scheme of the tile. Errors: as refine_once. Cost: about that
/// of `refine` with connect::faces, and of copying the level once.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<tile<Point, Index>> last_in_patches([[maybe_unused]] const tile<Point, Index>& coarse,
                                                  [[maybe_unused]] const Scheme& scheme, [[maybe_unused]] int level,
                                                  [[maybe_unused]] const global_levels_of<Scheme>& whole,
                                                  [[maybe_unused]] const strategy_costs& costs)
{
#ifdef KITH_HAS_LANES
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;
        const auto& t = coarse.mesh.topology();
        const int generation = coarse.mesh.generation(), steps = whole.levels() - level;
        auto plan = detail::plan_for_tile(coarse.mesh, scheme, steps);
        if (not plan or (degree != 0 and std::size_t(t.degree) != degree) or
            (has_faces_by_valence<Scheme> and level == 0) or
            not numbers_are_affine<Scheme>(whole.counts(level).as_counts().boundary_edges == 0))
            return {};
        if (plan->begin != 0)
            plan->begin_at(0, scheme, generation);
        if (plan->last().corners() >= connectivity<Index>::none)
            return {};
        std::vector<column_bases> there;
        for (int step = 0; step < steps; ++step)
            there.push_back(bases_of_columns(scheme, whole.counts(level + step).as_counts(), generation + step));
        face_classes<Index> classes(t, plan->rings, state_marks<Index>(t, scheme));
        const auto recorder = recorder_of<scalar_of<Point>, Index, Scheme>(scheme, *plan, generation, {});
        if constexpr (faces_descend_from_faces<Scheme, Index>)
            if (numbers_are_affine<Scheme>(false) and recorder->children_of_faces(t, generation))
                return detail::owned_in_patches(coarse, scheme, *plan, there).make(classes, costs);
        detail::tile_of_patches<Point, Index> made(
            coarse, plan->bases, there, plan->last(), whole.counts(whole.levels()).vertices, degree);
        classes.keep_marked(made.is_patched());
        const auto patches = patched_level<Point, Index>::make(coarse.mesh, classes, recorder, *plan, costs, false);
        if (not patches)
            return {};
        patches->fill(coarse.mesh, made.make_room());
        return made.take(generation + steps);
    }
#endif
    return {};
}

} // namespace kith
