// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "known_state.hpp"
#include "require_tiles.hpp"

#include <kith/core/base/error.hpp>
#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/refine/known_faces.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

/// A directory of the faces at vertices and their owners. Rank `vertex modulo ranks` answers for a vertex.
class faces_at_vertices {
public:
    struct place {
        global_id face;
        std::uint64_t rank, tile; // the index of the tile on that rank
    };
    struct answer {
        std::uint64_t question;
        place where;
    };

    /// Sends the directory the faces that tiles may ask for to get `rings` rings of ghosts. Collective.
    template <tile_like Tile>
    faces_at_vertices(communicator& comm, std::span<const numbered_tile<Tile>> tiles, int rings) : comm_(comm)
    {
        using index = typename Tile::index_type;
        const auto came = all_to_all(comm, [&] {
            std::vector<std::vector<offer>> offers(std::size_t(comm.size()));
            for (std::size_t t = 0; t < tiles.size(); ++t) {
                const Tile& part = tiles[t].part;
                for (const index f : submesh_cutter(part.mesh).faces_around(faces_at_cuts(part), rings))
                    if (part.owns_face(f))
                        for (const index v : part.mesh.face(f)) {
                            const global_id id = part.vertex_ids[v];
                            offers[id % offers.size()].push_back({id, part.face_ids[f], t});
                        }
            }
            return offers;
        });
        collective_phase(comm, [&] {
            for (std::size_t rank = 0; rank < came.size(); ++rank)
                for (const auto& [vertex, face, tile] : came[rank])
                    known_.push_back({vertex, {face, rank, tile}});
            std::ranges::sort(known_, {}, &entry::vertex);
        });
    }

    /// Returns the faces at vertices. `questions()` makes a list of vertices for each rank; each answer has the index
    /// of its question in that list. Collective.
    template <class Questions>
    std::vector<std::vector<answer>> ask(const Questions& questions)
    {
        const auto asked = all_to_all(comm_, questions);
        return all_to_all(comm_, [&] {
            std::vector<std::vector<answer>> answers(asked.size());
            for (std::size_t rank = 0; rank < asked.size(); ++rank)
                for (std::size_t q = 0; q < asked[rank].size(); ++q)
                    for (const auto& [vertex, found] :
                         std::ranges::equal_range(known_, asked[rank][q], {}, &entry::vertex))
                        answers[rank].push_back({q, found});
            return answers;
        });
    }

private:
    struct offer {
        global_id vertex, face;
        std::uint64_t tile;
    };
    struct entry {
        global_id vertex;
        place found;
    };

    communicator& comm_;
    std::vector<entry> known_; // by vertex
};

/// The answers of owners: faces, and the state that their schemes have there.
template <class Point, scheme Scheme>
struct fetched_faces {
    known_faces<Point> known;
    std::vector<kith::detail::known_state<Scheme>> states;
};

/// Asks owners for faces. `wanted()` makes a list for each rank of faces that lie there; the result has them in that
/// order. `schemes` are those of the tiles, in their order. Collective.
template <tile_like Tile, scheme Scheme, class Wanted>
std::vector<fetched_faces<typename Tile::point_type, Scheme>>
fetch_faces(communicator& comm, std::span<const numbered_tile<Tile>> tiles, std::span<const Scheme> schemes,
            const Wanted& wanted)
{
    using index = typename Tile::index_type;
    using point = typename Tile::point_type;
    const auto asked = all_to_all(comm, wanted);
    const auto came = all_to_all(comm, [&] {
        std::vector<std::vector<std::byte>> replies(asked.size());
        for (std::size_t rank = 0; rank < asked.size(); ++rank) {
            known_faces<point> reply;
            std::map<std::uint64_t, std::vector<index>> faces_of_tile;
            for (const auto& where : asked[rank]) {
                const auto& part = tiles[where.tile].part;
                const auto face = index(std::ranges::lower_bound(part.face_ids, where.face) - part.face_ids.begin());
                reply.append(known_faces_of(part, std::span<const index>(std::array{face})));
                faces_of_tile[where.tile].push_back(face);
            }
            packer out;
            kith::detail::pack_faces(out, reply);
            if constexpr (has_state<Scheme>) {
                out.add(std::uint64_t(faces_of_tile.size()));
                for (auto& [tile, faces] : faces_of_tile)
                    kith::detail::pack_known_state(
                        out, kith::detail::state_at_faces(tiles[tile].part, schemes[tile], std::move(faces)));
            }
            replies[rank] = out.take();
        }
        return replies;
    });
    return collective_phase(comm, [&] {
        std::vector<fetched_faces<point, Scheme>> result;
        for (const auto& bytes : came) {
            unpacker in(bytes);
            auto& one = result.emplace_back(kith::detail::unpack_faces<point>(in));
            if constexpr (has_state<Scheme>)
                for (auto left = in.get<std::uint64_t>(); left > 0; --left)
                    one.states.push_back(kith::detail::unpack_known_state(in, schemes.front()));
        }
        return result;
    });
}

/// Returns for each tile the faces that it lacks at its outermost vertices, in their order, without repetition. A tile
/// that has `ring` rings according to `rings_of` lacks none. Collective.
template <tile_like Tile>
std::vector<std::vector<faces_at_vertices::place>> lacking_faces(communicator& comm, faces_at_vertices& directory,
                                                                 std::span<const numbered_tile<Tile>> tiles,
                                                                 std::span<const int> rings_of, int ring)
{
    const auto ranks = std::size_t(comm.size());
    std::vector<std::vector<std::size_t>> asking; // the tile that asks each question
    const auto answers = directory.ask([&] {
        std::vector<std::vector<global_id>> questions(ranks);
        asking.resize(ranks);
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            const auto& part = tiles[t].part;
            if (rings_of[t] >= ring)
                continue;
            const auto incomplete = incomplete_vertices(part);
            for (std::size_t v = 0; v < incomplete.size(); ++v)
                if (incomplete[v] != 0) {
                    questions[part.vertex_ids[v] % ranks].push_back(part.vertex_ids[v]);
                    asking[part.vertex_ids[v] % ranks].push_back(t);
                }
        }
        return questions;
    });
    return collective_phase(comm, [&] {
        std::vector<std::vector<faces_at_vertices::place>> lacking(tiles.size());
        for (std::size_t rank = 0; rank < ranks; ++rank)
            for (const auto& [question, where] : answers[rank])
                if (const std::size_t t = asking[rank][question];
                    not std::ranges::binary_search(tiles[t].part.face_ids, where.face))
                    lacking[t].push_back(where);
        for (auto& faces : lacking) {
            std::ranges::sort(faces, {}, &faces_at_vertices::place::face);
            const auto twice = std::ranges::unique(faces, {}, &faces_at_vertices::place::face);
            faces.erase(twice.begin(), twice.end());
        }
        return lacking;
    });
}

/// The faces that the tiles of this rank lacked, fetched from their owners.
template <tile_like Tile, scheme Scheme>
class faces_from_owners {
public:
    using known = known_faces<typename Tile::point_type>;

    /// Fetches the faces. Collective.
    faces_from_owners(communicator& comm, std::span<const numbered_tile<Tile>> tiles, std::span<const Scheme> schemes,
                      const std::vector<std::vector<faces_at_vertices::place>>& lacking)
    {
        came_ = fetch_faces(comm, tiles, schemes, [&] {
            asking_.resize(std::size_t(comm.size()));
            of_tile_.resize(tiles.size());
            std::vector<std::vector<faces_at_vertices::place>> wanted(asking_.size());
            for (std::size_t t = 0; t < lacking.size(); ++t)
                for (const auto& where : lacking[t]) {
                    wanted[where.rank].push_back(where);
                    asking_[where.rank].push_back(t);
                }
            return wanted;
        });
        collective_phase(comm, [&] {
            for (std::size_t rank = 0; rank < came_.size(); ++rank)
                for (std::size_t f = 0, corner = 0; f < came_[rank].known.faces.size(); ++f) {
                    of_tile_[asking_[rank][f]].append_face(came_[rank].known, f, corner);
                    corner += came_[rank].known.faces[f].degree;
                }
        });
    }
    [[nodiscard]] const known& of_tile(std::size_t t) const { return of_tile_[t]; }
    /// Calls f(state) for the states received from each rank that tile t has asked.
    template <class F>
    void for_states(std::size_t t, const F& f) const
    {
        for (std::size_t rank = 0; rank < came_.size(); ++rank)
            if (std::ranges::find(asking_[rank], t) != asking_[rank].end())
                std::ranges::for_each(came_[rank].states, f);
    }

private:
    std::vector<std::vector<std::size_t>> asking_; // by rank: the tile that has asked for each face
    std::vector<fetched_faces<typename Tile::point_type, Scheme>> came_; // from each rank
    std::vector<known> of_tile_;
};

} // namespace detail

/// Adds rings of ghosts to all tiles of a level that have fewer than `rings` complete ones. Ring after ring, the tiles
/// fetch the faces at their outermost vertices from the owners, with the state of their schemes (creases). `tiles` are
/// those of this rank, `schemes` those of the tiles. The elements that a tile owns stay the same. Collective.
/// Preconditions: each tile has its edges. Marks of edges on level 0 are not carried. Errors: phase_error for a tile
/// without one complete ring, and for lack of memory; mpi::error. Cost: at most four messages to each rank per ring,
/// and rebuilding each tile.
template <class Point, std::unsigned_integral Index, scheme Scheme>
void grow_ghosts(communicator& comm, std::span<numbered_tile<tile<Point, Index>>> tiles, std::span<Scheme> schemes,
                 int rings)
{
    using tile_type = tile<Point, Index>;
    const std::span<const numbered_tile<tile_type>> all_tiles(tiles);
    const auto [fewest, rings_of] = rings_of_tiles(comm, all_tiles, rings);
    if (fewest >= rings)
        return;
    collective_phase(comm, [&, &rings_of = rings_of] {
        for (std::size_t t = 0; t < tiles.size(); ++t)
            if (rings_of[t] == 0)
                throw mesh_error("tile " + std::to_string(tiles[t].number) +
                                 " has no complete ring of ghosts, from which more can be fetched; cut or read the "
                                 "tiles with at least one ring");
    });
    detail::faces_at_vertices directory(comm, all_tiles, rings + 1);
    for (int ring = fewest + 1; ring <= rings; ++ring) {
        const auto lacking = detail::lacking_faces(comm, directory, all_tiles, std::span(rings_of), ring);
        const detail::faces_from_owners came(comm, all_tiles, std::span<const Scheme>(schemes), lacking);
        collective_phase(comm, [&] {
            for (std::size_t t = 0; t < tiles.size(); ++t) {
                if (rings_of[t] >= ring)
                    continue;
                auto& part = tiles[t].part;
                auto grown = kith::detail::with_faces(part, came.of_tile(t));
                if constexpr (has_state<Scheme>) {
                    const Scheme before = schemes[t];
                    kith::detail::restrict_state(schemes[t], before, part_numbers<Index>());
                    kith::detail::take_over(schemes[t], grown, before, kith::detail::elements_of(part));
                    came.for_states(t, [&](const auto& known) {
                        kith::detail::take_over(schemes[t], grown, known.scheme, known.elements);
                    });
                }
                part = std::move(grown);
            }
        });
    }
}
/// Adds rings of ghosts to tiles of a scheme without state. Collective.
template <class Point, std::unsigned_integral Index>
void grow_ghosts(communicator& comm, std::span<numbered_tile<tile<Point, Index>>> tiles, int rings)
{
    auto none = collective_phase(comm, [&] { return std::vector<kith::detail::no_scheme>(tiles.size()); });
    grow_ghosts(comm, tiles, std::span(none), rings);
}

} // namespace kith::mpi
