// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"
#include "whole_levels.hpp"

#include <kith/base/storage.hpp>
#include <kith/neighbourhood/descents.hpp>
#include <kith/patch/patched_level.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Whether all new faces come from faces or corners of faces, so that who owns a face owns its descendants.
template <class... Columns>
constexpr bool come_from_faces(const std::tuple<Columns...>*)
{
    return ((parent_kind(Columns::kind) == element_kind::face) and ...);
}

} // namespace detail

/// A scheme whose last steps on a tile may be made in patches: its new faces come from faces, and its numbers follow in
/// one way from the first level on.
template <class Scheme, class Point, class Index>
concept patchable_in_tiles = patchable_scheme<Scheme, Point, Index> and not has_numbers_by_marks<Scheme> and
                             not has_faces_by_valence<Scheme> and not detail::may_ask_state<Scheme>() and
                             numbering_of<Scheme, Index>::common_degree != 0 and
                             detail::come_from_faces(
                                 static_cast<const decltype(columns_type<Scheme>::faces.list)*>(nullptr));

namespace detail {

/// Returns the plan of patches for the mesh of a tile, with the numbers of a closed mesh: what lies beyond the rim would
/// have numbers, too. Nothing where there are no patches. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<patch_plan> plan_for_tile(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels)
{
    const auto& t = mesh.topology();
    if (t.faces == 0)
        return {};
    return plan_patches({t.vertices, t.edges(), t.faces}, t.degree, scheme, levels, mesh.generation());
}

} // namespace detail

#ifdef KITH_HAS_LANES

namespace detail {

/// Makes the last level of a tile from what patches have made of it and of its rim. Its elements are known by their
/// descent from the level whose faces own patches.
template <class Point, std::unsigned_integral Index>
class tile_of_patches {
public:
    /// `here` and `there` are the columns of the steps in the mesh of the tile and in the whole mesh; the last level of
    /// the former has so many vertices and faces of this degree. `coarse` must outlive this object.
    tile_of_patches(const tile<Point, Index>& coarse, std::span<const column_bases> here,
                    std::span<const column_bases> there, const counts& last, std::size_t degree)
        : coarse_(coarse)
        , degree_(degree)
        , vertices_(descents_of(tuple_kind::v, here, degree))
        , vertices_there_(descents_of(tuple_kind::v, there, degree))
        , faces_(descents_of(tuple_kind::f, here, degree))
        , faces_there_(descents_of(tuple_kind::f, there, degree))
        , points_(last.vertices)
        , corner_vertex_(degree * last.faces)
        , number_(last.vertices)
        , owned_(owned_faces_of(coarse))
    {
        std::vector<unsigned char> is_near(coarse.mesh.vertex_count(), 0);
        for (const Index f : owned_)
            for (const Index v : coarse.mesh.face(f))
                is_near[v] = 1;
        is_patched_.assign(coarse.mesh.face_count(), 0);
        for (std::size_t f = 0; f < is_patched_.size(); ++f)
            is_patched_[f] = std::ranges::any_of(coarse.mesh.face(f), [&](Index v) { return is_near[v] != 0; });
        for (std::size_t f = 0; f < is_patched_.size(); ++f)
            if (is_patched_[f] != 0 and not coarse.owns_face(f))
                rim_.push_back(Index(f));
    }

    /// Per face of the coarse tile whether its patch is needed: of the owned faces and of those around them.
    [[nodiscard]] std::span<const unsigned char> is_patched() const { return is_patched_; }
    /// Where the patches are written, in the numbers of the refined mesh of the tile.
    [[nodiscard]] patch_output<Point, Index> output()
    {
        return {.points = points_.data(), .corner_vertex = corner_vertex_.data()};
    }

    /// Returns the owned faces and their vertices. Precondition: the patches have been written. Cost: O(last level).
    [[nodiscard]] tile<Point, Index> take(int generation)
    {
        const auto marks = marks_of_vertices();
        tile<Point, Index> result;
        auto points = take_vertices(marks, result);
        auto faces = take_faces(result);
        faces.vertices = points.size();
        result.mesh = basic_mesh<Point, Index>(std::move(points), std::move(faces), generation);
        return result;
    }

private:
    enum : unsigned char { ours = 1, at_rim = 2, rim_comes_first = 4 };

    /// Calls f(face, vertex) for the corners of all descendants of some faces, in the order of their numbers.
    template <class F>
    void for_each_corner(std::span<const Index> coarse_faces, const F& f) const
    {
        for (const descent& way : faces_)
            for (const Index coarse_face : coarse_faces) {
                const std::size_t first = way.first + way.each * coarse_face;
                const Index* vertex = corner_vertex_.data() + first * degree_;
                for (std::size_t face = first; face < first + way.each; ++face)
                    for (std::size_t k = 0; k < degree_; ++k)
                        f(Index(face), *vertex++);
            }
    }
    /// Marks the vertices of owned faces. Those at the rim are looked up in the first face of either side.
    [[nodiscard]] storage<unsigned char> marks_of_vertices() const
    {
        storage<unsigned char> marks(points_.size());
        std::ranges::fill(marks, 0);
        using firsts = std::vector<std::array<Index, 2>>; // vertices with the first of their faces
        firsts of_ours, of_rim;
        for_each_corner(rim_, [&](Index, Index v) { marks[v] = at_rim; });
        for_each_corner(owned_, [&](Index face, Index v) {
            if (marks[v] == at_rim)
                of_ours.push_back({v, face});
            marks[v] |= ours;
        });
        for_each_corner(rim_, [&](Index face, Index v) {
            if (marks[v] == (ours | at_rim)) {
                of_rim.push_back({v, face});
                marks[v] = ours;
            }
        });
        std::ranges::sort(of_ours);
        std::ranges::sort(of_rim);
        for (std::size_t i = 0; i < of_ours.size(); ++i)
            if (of_rim[i][1] < of_ours[i][1])
                marks[of_ours[i][0]] |= rim_comes_first;
        return marks;
    }
    /// Numbers the vertices of owned faces one after the other, and returns their points.
    [[nodiscard]] storage<Point> take_vertices(const storage<unsigned char>& marks, tile<Point, Index>& result)
    {
        const auto size = std::size_t(
            std::ranges::count_if(marks, [](unsigned char mark) { return (mark & ours) != 0; }));
        storage<Point> points(size);
        result.vertex_ids = storage<global_id>(size);
        result.vertex_marks = storage<unsigned char>(size);
        std::size_t next = 0;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const descent &way = vertices_[i], &there = vertices_there_[i];
            const bool of_faces = parent_kind(way.last) == element_kind::face;
            const auto ids = ids_of(coarse_, parent_kind(way.from));
            for (std::size_t x = 0; x < ids.size(); ++x) {
                const std::size_t first = way.first + way.each * x;
                const global_id first_there = there.first + there.each * ids[x];
                const bool is_of_other = of_faces and not coarse_.owns_face(x);
                for (std::size_t which = 0; which < way.each; ++which) {
                    const std::size_t v = first + which;
                    if ((marks[v] & ours) == 0)
                        continue;
                    const bool is_owned = of_faces ? not is_of_other : (marks[v] & rim_comes_first) == 0;
                    number_[v] = Index(next);
                    points[next] = points_[v];
                    result.vertex_ids[next] = first_there + which;
                    result.vertex_marks[next] = is_owned ? owned_mark : 0;
                    ++next;
                }
            }
        }
        return points;
    }
    [[nodiscard]] connectivity<Index> take_faces(tile<Point, Index>& result) const
    {
        std::size_t each = 0;
        for (const descent& way : faces_)
            each += way.each;
        const std::size_t size = each * owned_.size();
        connectivity<Index> faces;
        faces.allocate_faces(size, int(degree_), [&](std::size_t) { return degree_; });
        result.face_ids = storage<global_id>(size);
        result.root_of = storage<Index>(size);
        result.face_marks = storage<unsigned char>(size);
        std::ranges::fill(result.face_marks, owned_mark);
        result.roots = coarse_.roots;
        std::size_t next = 0;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const descent &way = faces_[i], &there = faces_there_[i];
            for (const Index f : owned_) {
                const Index* from = corner_vertex_.data() + degree_ * (way.first + way.each * f);
                Index* const to = faces.corner_vertex.data() + degree_ * next;
                for (std::size_t c = 0; c < degree_ * way.each; ++c)
                    to[c] = number_[from[c]];
                const global_id first_there = there.first + there.each * coarse_.face_ids[f];
                for (std::size_t which = 0; which < way.each; ++which, ++next) {
                    result.face_ids[next] = first_there + which;
                    result.root_of[next] = coarse_.root_of[f];
                }
            }
        }
        return faces;
    }

    const tile<Point, Index>& coarse_;
    std::size_t degree_; // of the faces
    std::vector<descent> vertices_, vertices_there_, faces_, faces_there_;
    storage<Point> points_; // of the refined mesh of the tile, as far as patches have written it
    storage<Index> corner_vertex_;
    storage<Index> number_;          // of each of its vertices that is taken
    std::vector<Index> owned_, rim_; // faces of the coarse tile; the rim is around the owned ones
    std::vector<unsigned char> is_patched_;
};

} // namespace detail

#endif

/// Returns the level from which the remaining steps of a tile of level 0 may be made in patches; `levels` if there is
/// none. Cost: O(levels).
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
int first_in_patches([[maybe_unused]] const tile<Point, Index>& control, [[maybe_unused]] const Scheme& scheme,
                     int levels)
{
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        if (const auto plan = detail::plan_for_tile(control.mesh, scheme, levels))
            return plan->begin;
    }
    return levels;
}

/// Returns when patches are worth while for a tile of this level: other tiles of the surface use the same templates.
/// Cost: O(faces of the tile).
template <tile_like Tile, reaching_scheme Scheme>
patch_costs costs_in_tiles(const Tile& coarse, int level, const whole_levels<Scheme>& whole)
{
    const auto owned = std::max<std::uint64_t>(owned_count(coarse.face_marks), 1);
    return patch_costs().if_in_tiles(double(whole.counts(level).faces) / double(owned));
}

/// Makes the remaining steps of a tile of level `level` at once, in patches: returns the faces of the last level that
/// the tile owns with their vertices, without edges and ghosts, as refine_once and refine_last make them, to the bit.
/// Returns nothing where patches are no gain at these costs. `scheme` is that of the tile.
/// Errors: as refine_once. Cost: about that of `refine` with connect::faces, and of copying the level once.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
std::optional<tile<Point, Index>> last_in_patches([[maybe_unused]] const tile<Point, Index>& coarse,
                                                  [[maybe_unused]] const Scheme& scheme, [[maybe_unused]] int level,
                                                  [[maybe_unused]] const whole_levels<Scheme>& whole,
                                                  [[maybe_unused]] const patch_costs& costs)
{
#ifdef KITH_HAS_LANES
    if constexpr (patchable_in_tiles<Scheme, Point, Index>) {
        constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;
        const auto& t = coarse.mesh.topology();
        const int generation = coarse.mesh.generation(), steps = whole.levels() - level;
        auto plan = detail::plan_for_tile(coarse.mesh, scheme, steps);
        if (not plan or std::size_t(t.degree) != degree or
            not numbers_are_affine<Scheme>(whole.counts(level).as_counts().boundary_edges == 0))
            return {};
        if (plan->begin != 0)
            plan->begin_at(0, scheme, generation);
        if (degree * plan->last().faces >= connectivity<Index>::none)
            return {};
        std::vector<column_bases> there;
        for (int step = 0; step < steps; ++step)
            there.push_back(bases_of_columns(scheme, whole.counts(level + step).as_counts(), generation + step));
        detail::tile_of_patches<Point, Index> made(coarse, plan->bases, there, plan->last(), degree);
        face_classes<Index> classes(t, plan->rings, state_marks<Index>(t, scheme));
        classes.keep_marked(made.is_patched());
        const auto patches = patched_level<Point, Index, Scheme>::make(coarse.mesh, classes, scheme, *plan, costs);
        if (not patches)
            return {};
        patches->fill(coarse.mesh, made.output());
        return made.take(generation + steps);
    }
#endif
    return {};
}

} // namespace kith
