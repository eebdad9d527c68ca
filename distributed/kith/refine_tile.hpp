// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reach.hpp"
#include "submesh.hpp"
#include "tile.hpp"
#include "whole_numbering.hpp"

#include <kith/error.hpp>
#include <kith/refine.hpp>
#include <kith/step.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

template <class List>
inline constexpr bool counts_faces_at_vertices = false;
template <class... C>
inline constexpr bool counts_faces_at_vertices<new_faces<C...>> = ((C::kind == tuple_kind::v and not requires {
                                                                       decltype(C::degree)::value;
                                                                   }) or ...);

/// Where a tuple belongs in a tile: to whom, and to which face.
template <class Tile>
class tuple_facts {
public:
    using level_type = level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>>;

    explicit tuple_facts(const Tile& coarse) : coarse_(coarse), level_(coarse.mesh) {}

    [[nodiscard]] const level_type& level() const { return level_; }

    [[nodiscard]] bool is_owned(tuple_kind kind, std::size_t tuple) const
    {
        switch (kind) {
        case tuple_kind::v: return coarse_.owns_vertex(tuple);
        case tuple_kind::e: return coarse_.owns_edge(tuple);
        case tuple_kind::ve: return coarse_.owns_edge(tuple / 2);
        default: return coarse_.owns_face(face(kind, tuple));
        }
    }
    /// Of the faces at the tuple the one with the smallest number.
    [[nodiscard]] std::size_t face(tuple_kind kind, std::size_t tuple) const
    {
        switch (kind) {
        case tuple_kind::v: {
            std::size_t result = coarse_.mesh.face_count();
            for (const auto f : level_.vertices()[tuple].faces())
                result = std::min(result, f.index());
            return result;
        }
        case tuple_kind::ve: tuple /= 2; [[fallthrough]];
        case tuple_kind::e: {
            const auto e = level_.edges()[tuple];
            return e.is_boundary() ? e.lface().index() : std::min(e.lface().index(), e.rface().index());
        }
        case tuple_kind::f: return tuple;
        case tuple_kind::vfe: tuple /= 2; [[fallthrough]];
        default: return level_.corners()[tuple].f().index();
        }
    }
    /// Whether a rim that a tuple gives birth to is the boundary of the whole mesh. Precondition: it is a rim here.
    [[nodiscard]] bool is_at_true_boundary(tuple_kind kind, std::size_t tuple) const
    {
        switch (kind) {
        case tuple_kind::v: return is_complete(level_.vertices()[tuple]);
        case tuple_kind::e: return not coarse_.is_cut(tuple);
        case tuple_kind::ve: return not coarse_.is_cut(tuple / 2);
        case tuple_kind::f: return true;
        case tuple_kind::vfe: tuple /= 2; [[fallthrough]];
        default: return not coarse_.is_cut(level_.corners()[tuple].next_edge().index());
        }
    }
    /// All faces that a vertex or an edge has in the whole mesh are here.
    [[nodiscard]] bool is_complete(tuple_kind kind, std::size_t tuple) const
    {
        return kind == tuple_kind::v ? is_complete(level_.vertices()[tuple])
                                     : not coarse_.is_cut(kind == tuple_kind::ve ? tuple / 2 : tuple);
    }
    [[nodiscard]] bool is_complete(const vertex<level_type>& v) const
    {
        return not v.is_boundary() or not(coarse_.is_cut(v.first_corner().next_edge().index()) or
                                          coarse_.is_cut(v.last_corner().prev_edge().index()));
    }

private:
    const Tile& coarse_;
    level_type level_;
};

/// Who owns a new vertex or edge: what a face, or a corner of it, gave birth to belongs to whom the face belongs. All else
/// belongs to the first of the new faces around it; they are all here when all old ones around the tuple are.
constexpr bool is_of_face(tuple_kind kind)
{
    return kind != tuple_kind::v and kind != tuple_kind::e and kind != tuple_kind::ve;
}

/// What whole_column_ids::first_corner asks for.
template <class Tile>
global_id corners_before(const Tile& coarse, tuple_kind kind, std::size_t tuple)
{
    if (kind == tuple_kind::v)
        return coarse.corners_before.empty() ? 0 : coarse.corners_before[tuple];
    return kind == tuple_kind::f ? coarse.corner_id(tuple, 0) : 0;
}

/// The part of a scheme's state (creases) that belongs to a submesh.
template <class Scheme, class Index>
Scheme scheme_of_part(const Scheme& scheme, std::span<const Index> vertex_from, std::span<const Index> edge_from)
{
    if constexpr (requires { scheme.of_part(vertex_from, edge_from); })
        return scheme.of_part(vertex_from, edge_from);
    else
        return scheme;
}

} // namespace detail

/// For schemes with faces that have as many corners as a vertex has faces: how many corners the vertices before a vertex
/// have. Inside, all vertices that such a scheme makes have four faces; those at the boundary are listed.
class corners_at_vertices {
public:
    corners_at_vertices() = default;
    template <class Tile>
    explicit corners_at_vertices(const Tile& rim)
    {
        const level_of<decltype(rim.mesh)> level(rim.mesh);
        std::vector<std::pair<global_id, global_id>> found;
        for (const auto v : level.vertices())
            if (v.is_boundary() and rim.owns_vertex(v.index()))
                found.emplace_back(rim.vertex_ids[v.index()], v.face_count());
        std::sort(found.begin(), found.end());
        std::int64_t fewer = 0;
        for (const auto& [id, faces] : found) {
            vertices_.push_back(id);
            fewer_.push_back(fewer += 4 - std::int64_t(faces));
        }
    }

    [[nodiscard]] global_id before(global_id vertex) const
    {
        const auto n = std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
        return 4 * vertex - global_id(n == 0 ? 0 : fewer_[std::size_t(n - 1)]);
    }

private:
    std::vector<global_id> vertices_;
    std::vector<std::int64_t> fewer_; // than four, in sum
};

template <class Scheme>
using columns_type = decltype(columns_of(std::declval<const Scheme&>(), 0));

/// A scheme whose tiles need `tile::corners_before`: Doo-Sabin, mid-edge.
template <class Scheme>
inline constexpr bool numbers_corners_at_vertices =
    detail::counts_faces_at_vertices<decltype(columns_type<Scheme>::faces)>;

namespace detail {

/// A refined tile before it is trimmed: too large by what the shadows made, wrong at its rim.
template <class Tile, class Scheme>
class tile_step {
    using point = typename Tile::point_type;
    using index = typename Tile::index_type;
    static constexpr index none = connectivity<index>::none;

public:
    tile_step(const Tile& coarse, const Scheme& scheme)
        : coarse_(coarse)
        , facts_(coarse)
        , fine_(refine_mesh<connect::everything>(coarse.mesh, scheme, ids_))
        , scheme_(scheme)
    {
        advance(scheme_, facts_.level(), ids_);
        const auto& t = fine_.topology();
        is_cut_.assign(fine_.edge_count(), 0);
        for (std::size_t e = 0; e < fine_.edge_count(); ++e)
            if (t.halfedge_corner[2 * e + 1] == none) {
                const auto [kind, tuple] = ids_.edges.origin(e);
                is_cut_[e] = not facts_.is_at_true_boundary(kind, tuple);
            }
        is_owned_.assign(fine_.face_count(), 0);
        for (std::size_t f = 0; f < fine_.face_count(); ++f) {
            const auto [kind, tuple] = ids_.faces.origin(f);
            is_owned_[f] = facts_.is_owned(kind, tuple);
        }
    }

    /// Of the owned faces keeps those that touch the boundary of the whole mesh.
    void keep_boundary()
    {
        const auto& t = fine_.topology();
        std::vector<unsigned char> at_boundary(fine_.vertex_count(), 0);
        for (std::size_t e = 0; e < fine_.edge_count(); ++e)
            if (t.halfedge_corner[2 * e + 1] == none and not is_cut_[e]) {
                const index c = t.halfedge_corner[2 * e];
                at_boundary[t.corner_vertex[c]] = at_boundary[t.corner_vertex[next_corner(t, c)]] = 1;
            }
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            if (std::ranges::none_of(fine_.face(f), [&](index v) { return at_boundary[v] != 0; }))
                is_owned_[f] = 0;
    }

    /// The owned faces with `rings` rings around them, in the numbers of the whole mesh.
    [[nodiscard]] Tile trim(int rings, const whole_numbering<columns_type<Scheme>>& whole, Scheme& scheme)
    {
        submesh_cutter<point, index> cutter(fine_);
        std::vector<index> owned;
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            if (is_owned_[f] != 0)
                owned.push_back(index(f));
        const auto kept = cutter.faces_around(owned, rings);
        auto part = cutter.cut(kept);
        scheme = scheme_of_part(
            scheme_, std::span<const index>(part.vertex_from), std::span<const index>(part.edge_from));

        Tile result;
        result.vertex_ids = storage<global_id>(part.vertex_from.size());
        result.vertex_marks = storage<unsigned char>(part.vertex_from.size());
        for (std::size_t v = 0; v < part.vertex_from.size(); ++v) {
            const auto [kind, tuple] = ids_.vertices.origin(part.vertex_from[v]);
            result.vertex_ids[v] = whole.vertices.id(kind, tuple_id(coarse_, facts_.level(), kind, tuple));
            const bool mine = is_of_face(kind) ? facts_.is_owned(kind, tuple)
                                               : facts_.is_complete(kind, tuple) and
                                                     is_owned_face(first_face_at_vertex(part.vertex_from[v]));
            result.vertex_marks[v] = mine and not part.is_copy(v) ? owned_mark : 0;
        }
        result.edge_ids = storage<global_id>(part.edge_from.size());
        result.edge_marks = storage<unsigned char>(part.edge_from.size());
        for (std::size_t e = 0; e < part.edge_from.size(); ++e) {
            const auto [kind, tuple] = ids_.edges.origin(part.edge_from[e]);
            result.edge_ids[e] = whole.edges.id(kind, tuple_id(coarse_, facts_.level(), kind, tuple));
            const bool is_piece = kind == tuple_kind::e or kind == tuple_kind::ve; // of an edge, directed as it
            const std::size_t old = kind == tuple_kind::ve ? tuple / 2 : tuple;
            const bool was_turned = is_piece and (coarse_.edge_marks[old] & turned_mark) != 0;
            const bool cut = is_cut_[part.edge_from[e]] != 0 or part.edge_is_new_rim[e] != 0;
            const bool mine = is_of_face(kind) ? facts_.is_owned(kind, tuple)
                                               : facts_.is_complete(kind, tuple) and
                                                     is_owned_face(first_face_at_edge(part.edge_from[e]));
            result.edge_marks[e] = static_cast<unsigned char>(
                (mine ? owned_mark : 0) | (cut ? cut_mark : 0) |
                (was_turned != (part.edge_is_turned[e] != 0) ? turned_mark : 0));
        }
        result.face_ids = storage<global_id>(kept.size());
        result.face_marks = storage<unsigned char>(kept.size());
        result.root_of = storage<index>(kept.size());
        constexpr bool mixed = numbering_of<Scheme, index>::common_degree == 0; // if not here, then elsewhere
        if constexpr (mixed)
            result.first_corner_ids = storage<global_id>(kept.size());
        for (std::size_t f = 0; f < kept.size(); ++f) {
            const auto [kind, tuple] = ids_.faces.origin(kept[f]);
            const global_id tuple_there = tuple_id(coarse_, facts_.level(), kind, tuple);
            result.face_ids[f] = whole.faces.id(kind, tuple_there);
            result.root_of[f] = coarse_.root_of[facts_.face(kind, tuple)];
            result.face_marks[f] = is_owned_[kept[f]] != 0 ? owned_mark : 0;
            if constexpr (mixed)
                result.first_corner_ids[f] = whole.faces.first_corner(
                    kind, tuple_there, corners_before(coarse_, kind, tuple));
        }
        result.roots = coarse_.roots;
        result.mesh = std::move(part.mesh);
        return result;
    }

private:
    [[nodiscard]] bool is_owned_face(index face) const { return is_owned_[face] != 0; }
    [[nodiscard]] index first_face_at_vertex(index vertex) const
    {
        const level_of<basic_mesh<point, index>> level(fine_);
        std::size_t result = fine_.face_count();
        for (const auto f : level.vertices()[vertex].faces())
            result = std::min(result, f.index());
        return index(result);
    }
    [[nodiscard]] index first_face_at_edge(index edge) const
    {
        const auto& t = fine_.topology();
        const index left = face_of_corner(t, t.halfedge_corner[2 * edge]);
        const index right = t.halfedge_corner[2 * edge + 1];
        return right == none ? left : std::min(left, face_of_corner(t, right));
    }

    const Tile& coarse_;
    tuple_facts<Tile> facts_;
    numbering_of<Scheme, index> ids_;
    basic_mesh<point, index> fine_;
    Scheme scheme_;
    std::vector<unsigned char> is_cut_;
    std::vector<unsigned char> is_owned_;
};

} // namespace detail

/// What all tiles of a refinement have to know of the whole mesh, level by level: how many elements there are, how they
/// are numbered, and how many rings of shadows are needed. It is the same on every rank and is made without
/// communication: from the counts of the control mesh and, where it has a boundary, from the faces along it.
template <reaching_scheme Scheme>
class whole_levels {
public:
    using columns_type = kith::columns_type<Scheme>;

    /// `rim` is the tile that owns all faces of level 0 that touch the boundary, with at least
    /// ring_schedule(scheme, levels)[0] rings, and `scheme` is that of this tile.
    /// Errors: mesh_error when there are more elements than global_id can number.
    /// Cost: that of refining the boundary.
    template <class Tile>
    whole_levels(const whole_counts& control, Tile rim, Scheme scheme, int levels, int last_rings = 0)
        : rings_(ring_schedule(scheme, levels, last_rings)), counts_{control}
    {
        const auto rim_rings = ring_schedule(
            scheme, levels, 1); // one at the end, so that all of the boundary is complete
        corners_.emplace_back();
        for (int level = 0; level < levels; ++level) {
            numberings_.emplace_back(counts_.back(), columns_of(scheme, rim.mesh.generation()), rim);
            counts_.push_back(numberings_.back().counts());
            if (rim.mesh.face_count() != 0) {
                detail::tile_step step(rim, scheme);
                step.keep_boundary();
                Tile next = step.trim(rim_rings[std::size_t(level) + 1], numberings_.back(), scheme);
                corners_.emplace_back(next);
                if constexpr (numbers_corners_at_vertices<Scheme>)
                    number_corners(next, corners_.back());
                rim = std::move(next);
            } else {
                corners_.emplace_back();
            }
        }
    }

    [[nodiscard]] int levels() const { return int(numberings_.size()); }
    [[nodiscard]] const whole_counts& counts(int level) const { return counts_[std::size_t(level)]; }
    [[nodiscard]] int rings(int level) const { return rings_[std::size_t(level)]; }
    [[nodiscard]] const whole_numbering<columns_type>& numbering(int level) const
    {
        return numberings_[std::size_t(level)];
    }
    [[nodiscard]] const corners_at_vertices& corners(int level) const { return corners_[std::size_t(level)]; }

    /// Gives the vertices of a tile the numbers that schemes with faces of as many corners as a vertex has faces need.
    template <class Tile>
    static void number_corners(Tile& tile, const corners_at_vertices& corners)
    {
        tile.corners_before = storage<global_id>(tile.vertex_ids.size());
        for (std::size_t v = 0; v < tile.vertex_ids.size(); ++v)
            tile.corners_before[v] = corners.before(tile.vertex_ids[v]);
    }

private:
    std::vector<int> rings_;
    std::vector<whole_counts> counts_;
    std::vector<whole_numbering<columns_type>> numberings_;
    std::vector<corners_at_vertices> corners_;
};

/// Refines a tile of level `level` once: by the unchanged scheme, over its shadows; what lies beyond the rings that the
/// levels to come need is cut off. `scheme` is that of this tile and becomes that of the next. No communication.
/// The result has the bits of the whole mesh's next level. Errors: as `refine`. Cost: that of the step.
template <class Point, class Index, reaching_scheme Scheme>
tile<Point, Index> refine_once(const tile<Point, Index>& coarse, Scheme& scheme, int level,
                               const whole_levels<Scheme>& whole)
{
    detail::tile_step step(coarse, scheme);
    auto result = step.trim(whole.rings(level + 1), whole.numbering(level), scheme);
    if constexpr (numbers_corners_at_vertices<Scheme>)
        whole_levels<Scheme>::number_corners(result, whole.corners(level + 1));
    return result;
}

/// The last step of all: the faces that the tile owns and their vertices, without edges and shadows, in half of the memory.
/// Errors and cost: as refine_once.
template <class Point, class Index, reaching_scheme Scheme>
tile<Point, Index> refine_last(const tile<Point, Index>& coarse, const Scheme& scheme, int level,
                               const whole_levels<Scheme>& whole)
{
    constexpr Index none = connectivity<Index>::none;
    const detail::tuple_facts facts(coarse);
    const auto& numbers = whole.numbering(level);
    numbering_of<Scheme, Index> ids;
    auto fine = refine_mesh<connect::faces>(coarse.mesh, scheme, ids);

    std::vector<unsigned char> owned(fine.face_count());
    std::size_t faces = 0, corners = 0;
    for (std::size_t f = 0; f < fine.face_count(); ++f) {
        const auto [kind, tuple] = ids.faces.origin(f);
        owned[f] = facts.is_owned(kind, tuple);
        faces += owned[f];
        corners += owned[f] != 0 ? fine.face(f).size() : 0;
    }
    // As in tile_step: what no face gave birth to belongs to the first of the new faces around it.
    std::vector<unsigned char> is_met(fine.vertex_count(), 0), first_face_is_owned(fine.vertex_count(), 0);
    std::vector<Index> here(fine.vertex_count(), none);
    for (std::size_t f = 0; f < fine.face_count(); ++f)
        for (const Index v : fine.face(f)) {
            if (is_met[v] == 0)
                first_face_is_owned[v] = owned[f];
            is_met[v] = 1;
            if (owned[f] != 0)
                here[v] = 0;
        }
    Index vertices = 0;
    for (Index& v : here)
        if (v != none)
            v = vertices++;

    tile<Point, Index> result;
    result.roots = coarse.roots;
    connectivity<Index> t;
    t.vertices = vertices;
    t.faces = faces;
    t.degree = fine.topology().degree;
    t.corner_vertex = storage<Index>(corners);
    if (t.degree == 0) {
        t.face_corner = storage<Index>(faces + 1);
        t.corner_face = storage<Index>(corners);
        t.face_corner[faces] = Index(corners);
    }
    constexpr bool mixed = numbering_of<Scheme, Index>::common_degree == 0;
    if constexpr (mixed)
        result.first_corner_ids = storage<global_id>(faces);
    result.face_ids = storage<global_id>(faces);
    result.face_marks = storage<unsigned char>(faces, owned_mark);
    result.root_of = storage<Index>(faces);
    Index corner = 0;
    for (std::size_t f = 0, n = 0; f < fine.face_count(); ++f) {
        if (owned[f] == 0)
            continue;
        const auto [kind, tuple] = ids.faces.origin(f);
        const global_id tuple_there = detail::tuple_id(coarse, facts.level(), kind, tuple);
        result.face_ids[n] = numbers.faces.id(kind, tuple_there);
        result.root_of[n] = coarse.root_of[facts.face(kind, tuple)];
        if constexpr (mixed)
            result.first_corner_ids[n] = numbers.faces.first_corner(
                kind, tuple_there, detail::corners_before(coarse, kind, tuple));
        if (t.degree == 0) {
            t.face_corner[n] = corner;
            std::fill_n(t.corner_face.begin() + corner, fine.face(f).size(), Index(n));
        }
        for (const Index v : fine.face(f))
            t.corner_vertex[corner++] = here[v];
        ++n;
    }
    storage<Point> points(vertices);
    result.vertex_ids = storage<global_id>(vertices);
    result.vertex_marks = storage<unsigned char>(vertices);
    for (std::size_t v = 0; v < fine.vertex_count(); ++v) {
        if (here[v] == none)
            continue;
        const auto [kind, tuple] = ids.vertices.origin(v);
        points[here[v]] = fine.point(v);
        result.vertex_ids[here[v]] = numbers.vertices.id(kind, detail::tuple_id(coarse, facts.level(), kind, tuple));
        const bool mine = detail::is_of_face(kind) ? facts.is_owned(kind, tuple)
                                                   : facts.is_complete(kind, tuple) and first_face_is_owned[v] != 0;
        result.vertex_marks[here[v]] = mine ? owned_mark : 0;
    }
    result.mesh = {std::move(points), std::move(t), fine.generation()};
    return result;
}

/// Refines a tile of level 0 through all levels that `whole` was made for. `connect::faces` gives the last level without
/// edges and shadows. `each(tile)` is called with every level but the first.
template <class Point, class Index, reaching_scheme Scheme, class Each>
tile<Point, Index> refine(tile<Point, Index> part, Scheme scheme, const whole_levels<Scheme>& whole, connect last,
                          const Each& each)
{
    for (int level = 0; level < whole.levels(); ++level) {
        const bool is_last = level + 1 == whole.levels();
        part = is_last and last == connect::faces ? refine_last(part, scheme, level, whole)
                                                  : refine_once(part, scheme, level, whole);
        each(std::as_const(part));
    }
    return part;
}
template <class Point, class Index, reaching_scheme Scheme>
tile<Point, Index> refine(tile<Point, Index> part, Scheme scheme, const whole_levels<Scheme>& whole,
                          connect last = connect::everything)
{
    return refine(std::move(part), std::move(scheme), whole, last, [](const auto&) {});
}

} // namespace kith
