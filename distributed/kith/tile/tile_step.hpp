// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_job.hpp"

#include <kith/number/new_elements.hpp>
#include <kith/step/children.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith::detail {

/// A refined tile before it is trimmed: too large by what the shadows made, wrong at its rim.
template <tile_like Tile, scheme Scheme>
class tile_step {
    using point = typename Tile::point_type;
    using index = typename Tile::index_type;
    static constexpr index none = connectivity<index>::none;

public:
    tile_step(const Tile& coarse, const Scheme& scheme, const whole_numbering<columns_type<Scheme>>& whole)
        : coarse_(coarse)
        , fine_(refine_mesh<connect::everything>(coarse.mesh, scheme, ids_))
        , elements_(coarse, ids_, whole)
        , scheme_(scheme)
    {
        advance(scheme_, elements_.facts().level(), coarse.mesh.generation(), ids_, fine_);
        const auto& t = fine_.topology();
        is_cut_.assign(fine_.edge_count(), 0);
        for (std::size_t e = 0; e < fine_.edge_count(); ++e)
            if (t.is_boundary(e)) {
                const auto [kind, tuple] = ids_.edges.origin(e);
                is_cut_[e] = not elements_.facts().is_at_true_boundary(kind, tuple);
            }
        is_owned_.assign(fine_.face_count(), 0);
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            is_owned_[f] = elements_.owns_face(f);
    }

    /// Of the owned faces keeps those that touch the boundary of the whole mesh.
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

    /// The owned faces with `rings` rings around them, in the numbers of the whole mesh; `scheme` becomes theirs.
    [[nodiscard]] Tile trim(int rings, Scheme& scheme)
    {
        submesh_cutter<point, index> cutter(fine_);
        std::vector<index> owned;
        for (std::size_t f = 0; f < fine_.face_count(); ++f)
            if (is_owned_[f] != 0)
                owned.push_back(index(f));
        auto part = cutter.cut(cutter.faces_around(owned, rings));
        take_part(scheme, scheme_, part.numbers());

        const level_of<basic_mesh<point, index>> level(fine_);
        Tile result;
        result.vertex_ids = storage<global_id>(part.vertex_from.size());
        result.vertex_marks = storage<unsigned char>(part.vertex_from.size());
        for (std::size_t v = 0; v < part.vertex_from.size(); ++v) {
            const index from = part.vertex_from[v];
            result.vertex_ids[v] = elements_.vertex_id(from);
            const bool mine = elements_.owns_vertex(
                from, [&] { return is_owned_[parent_face(level, tuple_kind::v, from)] != 0; });
            result.vertex_marks[v] = mine and not part.is_copy(v) ? owned_mark : 0;
        }
        result.edge_ids = storage<global_id>(part.edge_from.size());
        result.edge_marks = storage<unsigned char>(part.edge_from.size());
        for (std::size_t e = 0; e < part.edge_from.size(); ++e) {
            const index from = part.edge_from[e];
            result.edge_ids[e] = elements_.edge_id(from);
            const bool cut = is_cut_[from] != 0 or part.edge_is_new_rim[e] != 0;
            const bool mine = elements_.owns_edge(
                from, [&] { return is_owned_[parent_face(level, tuple_kind::e, from)] != 0; });
            result.edge_marks[e] = static_cast<unsigned char>(
                (mine ? owned_mark : 0) | (cut ? cut_mark : 0) |
                (was_turned(from) != (part.edge_is_turned[e] != 0) ? turned_mark : 0));
        }
        elements_.begin_faces(result, part.face_from.size());
        for (std::size_t f = 0; f < part.face_from.size(); ++f) {
            elements_.number_face(result, f, part.face_from[f]);
            result.face_marks[f] = is_owned_[part.face_from[f]] != 0 ? owned_mark : 0;
        }
        result.mesh = std::move(part.mesh);
        return result;
    }

private:
    /// A part of an edge is directed as the edge is.
    [[nodiscard]] bool was_turned(index edge) const
    {
        const auto [kind, tuple] = ids_.edges.origin(edge);
        return parent_kind(kind) == element_kind::edge and
               (coarse_.edge_marks[parent(elements_.facts().level(), kind, tuple)] & turned_mark) != 0;
    }

    const Tile& coarse_;
    numbering_of<Scheme, index> ids_;
    basic_mesh<point, index> fine_;
    new_elements<Tile, Scheme> elements_;
    Scheme scheme_;
    std::vector<unsigned char> is_cut_;
    std::vector<unsigned char> is_owned_;
};

} // namespace kith::detail
