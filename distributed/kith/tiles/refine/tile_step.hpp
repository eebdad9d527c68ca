// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"
#include "tile_job.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/engine/neighbourhood/affine_columns.hpp>
#include <kith/engine/neighbourhood/descents.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/numbering/step/submesh.hpp>
#include <kith/tiles/number/new_elements.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// A refined tile before it is trimmed. It still has all that its ghosts made, and its outermost elements are wrong.
/// The code depends on the columns of the scheme alone.
template <tile_like Tile, declared_columns Columns>
class tile_step {
    using point = typename Tile::point_type;
    using index = typename Tile::index_type;

public:
    /// Takes the level that a step has made of a tile, and the numbering of the step. `coarse` and `whole` must outlive
    /// this object.
    tile_step(const Tile& coarse, basic_mesh<point, index> fine, numbering<Columns, index> ids,
              const global_numbering<Columns>& whole)
        : ids_(std::move(ids)), fine_(std::move(fine)), elements_(coarse, ids_, whole)
    {
        const auto& t = fine_.topology();
        is_cut_.assign(fine_.edge_count(), 0);
        for (std::size_t e = 0; e < fine_.edge_count(); ++e)
            if (t.is_boundary(e)) {
                const auto [kind, tuple] = ids_.edges.origin(e);
                is_cut_[e] = not elements_.facts().is_at_true_boundary(kind, tuple);
            }
        is_owned_ = elements_.owned_faces();
    }

    /// Keeps as owned only the owned faces that touch the boundary of the whole mesh.
    void keep_boundary()
    {
        const auto& t = fine_.topology();
        std::vector<unsigned char> at_boundary(fine_.vertex_count(), 0);
        for (std::size_t e = 0; e < fine_.edge_count(); ++e)
            if (t.is_boundary(e) and not is_cut_[e])
                for (const index v : t.ends(e))
                    at_boundary[v] = 1;
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            if (std::ranges::none_of(fine_.face(f), [&](index v) { return at_boundary[v] != 0; }))
                is_owned_[f] = 0;
    }

    /// Returns the owned faces with `rings` rings around them and their global numbers. use(part) is called with their
    /// numbers in the level that the step has made.
    [[nodiscard]] Tile trim(int rings, const std::function<void(const part_numbers<index>&)>& use)
    {
        submesh_cutter<point, index> cutter(fine_);
        std::vector<index> owned;
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            if (is_owned_[f] != 0)
                owned.push_back(index(f));
        auto part = cutter.cut(cutter.faces_around(owned, rings));
        use(part.numbers());

        Tile result;
        const auto first_is_owned = owned_first_faces(fine_, is_owned_);
        elements_.number_vertices(result, part.vertex_from, [&](index v) { return first_is_owned[v] != 0; });
        elements_.number_edges(result, part.edge_from, [&](index e) { return is_owned_[first_face(e)] != 0; });
        for (std::size_t e = 0; e < part.edge_from.size(); ++e) {
            const bool cut = is_cut_[part.edge_from[e]] != 0 or part.edge_is_new_rim[e] != 0;
            const bool is_turned = part.edge_is_turned[e] != 0;
            result.edge_marks[e] = static_cast<unsigned char>((result.edge_marks[e] | (cut ? cut_mark : 0)) ^
                                                              (is_turned ? turned_mark : 0));
        }
        elements_.number_faces(result, part.face_from, is_owned_);
        result.mesh = std::move(part.mesh);
        return result;
    }

private:
    /// Returns the face with the smallest number at an edge.
    [[nodiscard]] index first_face(std::size_t edge) const
    {
        const auto& t = fine_.topology();
        const index left = t.face_of(t.halfedge_corner[2 * edge]);
        return t.is_boundary(edge) ? left : std::min(left, t.face_of(t.halfedge_corner[2 * edge + 1]));
    }

    numbering<Columns, index> ids_;
    basic_mesh<point, index> fine_;
    new_elements<Tile, Columns> elements_;
    std::vector<unsigned char> is_cut_;
    std::vector<unsigned char> is_owned_;
};

/// Makes one step of a tile and advances `scheme`, the scheme of the tile, to the level that the step makes. Errors: as
/// `refine`. Cost: that of the step.
template <tile_like Tile, scheme Scheme>
tile_step<Tile, columns_type<Scheme>> refined_tile(const Tile& coarse, Scheme& scheme,
                                                   const global_numbering<columns_type<Scheme>>& whole)
{
    using mesh_type = basic_mesh<typename Tile::point_type, typename Tile::index_type>;
    numbering_of<Scheme, typename Tile::index_type> ids;
    auto fine = refine_mesh<connect::everything>(coarse.mesh, scheme, ids);
    advance(scheme, level_of<mesh_type>(coarse.mesh), coarse.mesh.generation(), ids, fine);
    return {coarse, std::move(fine), std::move(ids), whole};
}

/// Refines a tile of a whole mesh with these counts once and keeps all that the step makes, including wrong outermost
/// elements. The result has the global numbers of its elements and their owned marks, but no cut marks. `scheme`
/// becomes that of the next level.
/// Preconditions: numbers are affine with and without a boundary, and all faces have the degree of refined ones.
/// Errors: as `refine`. Cost: that of the step.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
    requires faces_descend_from_faces<Scheme, Index>
tile<Point, Index> refine_untrimmed(const tile<Point, Index>& coarse, Scheme& scheme, const counts& whole)
{
    constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;
    const int generation = coarse.mesh.generation();
    const column_bases here = bases_of_columns(scheme, count(coarse.mesh.topology()), generation);
    const column_bases there = bases_of_columns(scheme, whole, generation);
    tile<Point, Index> result;
    result.mesh = coarse.mesh;
    make_levels(result.mesh, scheme, 1);

    const auto number = [&](tuple_kind made, std::size_t size, auto& ids, auto& marks, auto&& each) {
        const auto ways = descents_of(made, std::span(&here, 1), degree);
        const auto ways_there = descents_of(made, std::span(&there, 1), degree);
        ids = storage<global_id>(size);
        marks = storage<unsigned char>(size);
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const auto parents = ids_of(coarse, parent_kind(ways[i].from));
            const auto marks_of_parents = marks_of(coarse, parent_kind(ways[i].from));
            std::size_t next = ways[i].first;
            for (std::size_t parent = 0; parent < parents.size(); ++parent)
                for (std::size_t which = 0; which < ways[i].each; ++which, ++next) {
                    ids[next] = ways_there[i].first + ways_there[i].each * parents[parent] + which;
                    marks[next] = marks_of_parents[parent] & owned_mark;
                    each(next, parent);
                }
        }
    };
    const auto nothing_more = [](std::size_t, std::size_t) {};
    number(tuple_kind::v, result.mesh.vertex_count(), result.vertex_ids, result.vertex_marks, nothing_more);
    number(tuple_kind::e, result.mesh.edge_count(), result.edge_ids, result.edge_marks, nothing_more);
    result.roots = coarse.roots;
    result.root_of = storage<Index>(result.mesh.face_count());
    number(tuple_kind::f,
           result.mesh.face_count(),
           result.face_ids,
           result.face_marks,
           [&](std::size_t face, std::size_t parent) { result.root_of[face] = coarse.root_of[parent]; });
    return result;
}

} // namespace kith::detail
