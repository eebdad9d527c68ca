// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tuple_facts.hpp"
#include "global_numbering.hpp"
#include "global_tuple.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The new elements that one step makes from a tile: their global numbers, and whether the tile owns them. The owner of
/// a coarse element owns the new faces that come from it. The owner of a face also owns the vertices and edges that
/// come from the face or its corners; any other new vertex or edge is owned by the owner of the first new face around
/// it. These new faces are all in the tile if all coarse faces around the tuple are.
template <tile_like Tile, declared_columns Columns>
class new_elements {
    using index = typename Tile::index_type;
    using numbers = numbering<Columns, index>;

public:
    new_elements(const Tile& coarse, const numbers& ids, const global_numbering<Columns>& whole)
        : coarse_(coarse), ids_(ids), whole_(whole), facts_(coarse)
    {
    }

    [[nodiscard]] const tuple_facts<Tile>& facts() const { return facts_; }

    /// Returns for each new face 1 if the tile owns it, else 0.
    [[nodiscard]] std::vector<unsigned char> owned_faces() const
    {
        std::vector<unsigned char> result(ids_.faces.total());
        for_each_born(ids_.faces, [&]<tuple_kind Kind>(std::size_t face, std::size_t parent, std::size_t) {
            result[face] = is_owned<Kind>(parent);
        });
        return result;
    }
    // Numbers and marks are written in separate loops: a byte may alias any object, so the compiler reloads everything
    // after each write of one.

    /// Sets the numbers, marks and roots in `next` of the new faces `faces`, which increase.
    void number_faces(Tile& next, std::span<const index> faces, const std::vector<unsigned char>& owned) const
    {
        next.face_ids = storage<global_id>(faces.size());
        next.root_of = storage<index>(faces.size());
        if constexpr (is_mixed)
            next.first_corner_ids = storage<global_id>(faces.size());
        next.roots = coarse_.roots;
        for_each_of(ids_.faces, faces, [&]<tuple_kind Kind>(std::size_t at, std::size_t parent, std::size_t tuple) {
            const global_tuple there = in_whole<Kind>(coarse_, parent, tuple);
            next.face_ids[at] = whole_.faces.id(there);
            next.root_of[at] = coarse_.root_of[face_at<Kind>(parent)];
            if constexpr (is_mixed)
                next.first_corner_ids[at] = whole_.faces.first_corner(there);
        });
        next.face_marks = storage<unsigned char>(faces.size());
        for (std::size_t at = 0; at < faces.size(); ++at)
            next.face_marks[at] = owned[faces[at]] != 0 ? owned_mark : 0;
    }
    /// Sets the numbers and marks in `next` of the new vertices `vertices`, which may occur several times.
    /// `owns_first_face(vertex)` returns true if the first of the new faces around a new vertex is owned.
    template <std::predicate<index> F>
    void number_vertices(Tile& next, std::span<const index> vertices, const F& owns_first_face) const
    {
        next.vertex_ids = ids_in_whole(ids_.vertices, whole_.vertices, vertices);
        next.vertex_marks = storage<unsigned char>(vertices.size());
        for_each_of(ids_.vertices, vertices, [&]<tuple_kind Kind>(std::size_t at, std::size_t parent, std::size_t) {
            const bool is_copy = at != 0 and vertices[at] == vertices[at - 1];
            const bool mine = not is_copy and owns<Kind>(parent, [&] { return owns_first_face(vertices[at]); });
            next.vertex_marks[at] = mine ? owned_mark : 0;
        });
    }
    /// Sets the numbers and marks in `next` of the new edges `edges`. A part of a coarse edge has the direction of that
    /// edge and its turned_mark; cut_mark is not set.
    template <std::predicate<index> F>
    void number_edges(Tile& next, std::span<const index> edges, const F& owns_first_face) const
    {
        next.edge_ids = ids_in_whole(ids_.edges, whole_.edges, edges);
        next.edge_marks = storage<unsigned char>(edges.size());
        for_each_of(ids_.edges, edges, [&]<tuple_kind Kind>(std::size_t at, std::size_t parent, std::size_t) {
            unsigned char marks = owns<Kind>(parent, [&] { return owns_first_face(edges[at]); }) ? owned_mark : 0;
            if constexpr (parent_kind(Kind) == element_kind::edge)
                marks = static_cast<unsigned char>(marks | (coarse_.edge_marks[parent] & turned_mark));
            next.edge_marks[at] = marks;
        });
    }

private:
    static constexpr bool is_mixed = numbers::common_degree == 0; // in the whole mesh, if not in this tile

    /// Calls f.operator()<kind>(number, parent, tuple) for all new elements of a kind, in the order of their numbers.
    template <element_ids Ids, class F>
    void for_each_born(const Ids& ids, const F& f) const
    {
        const auto& t = coarse_.mesh.topology();
        const auto in_column = [&]<tuple_kind Kind>() {
            constexpr element_kind kind = parent_kind(Kind);
            const std::size_t parents = kind == element_kind::vertex ? t.vertices
                                        : kind == element_kind::edge ? t.edges()
                                                                     : t.faces;
            for (std::size_t parent = 0; parent < parents; ++parent) {
                const auto tuples = tuples_of(
                    Kind, {parent, parent + 1}, [&](std::size_t face) { return t.first_corner(face); });
                for (std::size_t tuple = tuples.begin; tuple < tuples.end; ++tuple)
                    if (const auto id = ids.template id<Kind>(tuple); id != Ids::none)
                        f.template operator()<Kind>(std::size_t(id), parent, tuple);
            }
        };
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (in_column.template operator()<Ids::kinds[I]>(), ...);
        }(std::make_index_sequence<Ids::size>());
    }
    /// Calls f.operator()<kind>(place, parent, tuple) for each place in an increasing list of new elements. New
    /// elements are numbered in the order of their tuples.
    template <element_ids Ids, class F>
    void for_each_of(const Ids& ids, std::span<const index> listed, const F& f) const
    {
        std::size_t at = 0;
        for_each_born(ids, [&]<tuple_kind Kind>(std::size_t id, std::size_t parent, std::size_t tuple) {
            for (; at < listed.size() and listed[at] == id; ++at)
                f.template operator()<Kind>(at, parent, tuple);
        });
    }
    template <element_ids Ids, class WholeIds>
    [[nodiscard]] storage<global_id> ids_in_whole(const Ids& ids, const WholeIds& whole,
                                                  std::span<const index> listed) const
    {
        storage<global_id> result(listed.size());
        for_each_of(ids, listed, [&]<tuple_kind Kind>(std::size_t at, std::size_t parent, std::size_t tuple) {
            result[at] = whole.id(in_whole<Kind>(coarse_, parent, tuple));
        });
        return result;
    }
    template <tuple_kind Kind>
    [[nodiscard]] bool is_owned(std::size_t parent) const
    {
        if constexpr (parent_kind(Kind) == element_kind::vertex)
            return coarse_.owns_vertex(parent);
        else if constexpr (parent_kind(Kind) == element_kind::edge)
            return coarse_.owns_edge(parent);
        else
            return coarse_.owns_face(parent);
    }
    /// Returns true if the tile has all faces that a vertex or an edge has in the whole mesh.
    template <tuple_kind Kind>
    [[nodiscard]] bool is_complete(std::size_t parent) const
    {
        if constexpr (Kind == tuple_kind::v)
            return facts_.is_complete(parent);
        else
            return not coarse_.is_cut(parent);
    }
    /// Returns the face with the smallest number at the parent.
    template <tuple_kind Kind>
    [[nodiscard]] std::size_t face_at(std::size_t parent) const
    {
        if constexpr (parent_kind(Kind) == element_kind::face)
            return parent;
        else
            return parent_face(facts_.level(), Kind, Kind == tuple_kind::ve ? 2 * parent : parent);
    }

    template <tuple_kind Kind, class F>
    [[nodiscard]] bool owns(std::size_t parent, const F& owns_first_face) const
    {
        if constexpr (parent_kind(Kind) == element_kind::face)
            return coarse_.owns_face(parent);
        else
            return is_complete<Kind>(parent) and owns_first_face();
    }

    const Tile& coarse_;
    const numbers& ids_;
    const global_numbering<Columns>& whole_;
    tuple_facts<Tile> facts_;
};

/// Returns for each vertex of a mesh 1 if its face with the smallest number is owned, else 0.
template <class Point, std::unsigned_integral Index>
std::vector<unsigned char> owned_first_faces(const basic_mesh<Point, Index>& mesh,
                                             const std::vector<unsigned char>& is_owned)
{
    constexpr unsigned char unmet = 2;
    std::vector<unsigned char> result(mesh.vertex_count(), unmet);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const Index v : mesh.face(f))
            if (result[v] == unmet)
                result[v] = is_owned[f];
    return result;
}

} // namespace kith::detail
