// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <cstddef>
#include <vector>

namespace kith {

/// Marks the vertices that have faces in the whole mesh which are not in the tile. Precondition: the tile has its
/// edges.
template <tile_like Tile>
std::vector<unsigned char> incomplete_vertices(const Tile& part)
{
    const auto& t = part.mesh.topology();
    std::vector<unsigned char> result(part.mesh.vertex_count(), 0);
    for (std::size_t e = 0; e < t.edges(); ++e)
        if (part.is_cut(e))
            for (const auto v : t.ends(e))
                result[v] = 1;
    return result;
}

namespace detail {

/// The facts that tell the boundary of the whole mesh from the cuts of a tile.
template <tile_like Tile>
class tuple_facts {
public:
    using level_type = level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>>;

    /// Takes a tile with its edges. Cost: O(elements).
    explicit tuple_facts(const Tile& coarse)
        : coarse_(coarse), level_(coarse.mesh), is_incomplete_(incomplete_vertices(coarse))
    {
    }

    [[nodiscard]] const level_type& level() const { return level_; }

    /// Returns true if a new edge with one face, made from this tuple, is at the boundary of the whole mesh. The
    /// missing face is that of an edge of the tuple that has one face. Otherwise it is the face of the tuple's vertex,
    /// which dual schemes make if all faces of the vertex are in the tile.
    [[nodiscard]] bool is_at_true_boundary(tuple_kind kind, std::size_t tuple) const
    {
        switch (kind) {
        case tuple_kind::v: return is_complete(tuple);
        case tuple_kind::e: return not coarse_.is_cut(tuple);
        case tuple_kind::ve: {
            const auto& t = coarse_.mesh.topology();
            const std::size_t e = tuple / 2;
            return t.is_boundary(e) ? not coarse_.is_cut(e) : is_complete(t.ends(e)[tuple % 2]);
        }
        case tuple_kind::f: return true;
        case tuple_kind::vf: return is_complete(level_.corners()[tuple].v().index());
        case tuple_kind::vfe: tuple /= 2; [[fallthrough]];
        default: return not coarse_.is_cut(level_.corners()[tuple].next_edge().index());
        }
    }
    /// Returns true if the tile has all faces that a vertex has in the whole mesh.
    [[nodiscard]] bool is_complete(std::size_t vertex) const { return is_incomplete_[vertex] == 0; }

private:
    const Tile& coarse_;
    level_type level_;
    std::vector<unsigned char> is_incomplete_; // per vertex
};

} // namespace detail

} // namespace kith
