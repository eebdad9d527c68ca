// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "known_state.hpp"

#include <kith/mpi/all_to_all.hpp>
#include <kith/tile/numbered_tile.hpp>
#include <kith/tile/pack.hpp>
#include <kith/tile/known_faces.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

/// Of a tile that has grown, what it owned before.
template <tile_like Tile>
void keep_owned(const Tile& before, Tile& grown)
{
    const auto keep = [](const auto& old_ids, const auto& old_marks, const auto& ids, auto& marks) {
        for (std::size_t x = 0; x < ids.size(); ++x) {
            const auto old = std::lower_bound(old_ids.begin(), old_ids.end(), ids[x]) - old_ids.begin();
            const bool is_copy = x != 0 and ids[x - 1] == ids[x];
            if (std::size_t(old) < old_ids.size() and old_ids[std::size_t(old)] == ids[x] and not is_copy)
                marks[x] = static_cast<unsigned char>(marks[x] | (old_marks[std::size_t(old)] & owned_mark));
        }
    };
    keep(before.vertex_ids, before.vertex_marks, grown.vertex_ids, grown.vertex_marks);
    keep(before.edge_ids, before.edge_marks, grown.edge_ids, grown.edge_marks);
    keep(before.face_ids, before.face_marks, grown.face_ids, grown.face_marks);
}

template <class Point>
void pack_faces(packer& out, const known_faces<Point>& some)
{
    out.add_array(some.faces).add_array(some.corners).add_array(some.vertices);
}
template <class Point>
known_faces<Point> unpack_faces(unpacker& in)
{
    known_faces<Point> result;
    result.faces = in.get_array<decltype(result.faces)>();
    result.corners = in.get_array<decltype(result.corners)>();
    result.vertices = in.get_array<decltype(result.vertices)>();
    return result;
}

/// Which faces lie at a vertex, and who owns them: asked of rank `vertex modulo ranks`.
class faces_at_vertices {
public:
    struct place {
        global_id face;
        std::uint64_t rank, tile; // the tile by where it is on that rank
    };
    struct answer {
        std::uint64_t question;
        place where;
    };

    /// Collective. Tells of the faces that tiles may ask for which are to have so many rings of shadows.
    template <tile_like Tile>
    faces_at_vertices(communicator& comm, std::span<const numbered_tile<Tile>> tiles, int rings) : comm_(comm)
    {
        using index = typename Tile::index_type;
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
        const auto came = all_to_all(comm, offers);
        for (std::size_t rank = 0; rank < came.size(); ++rank)
            for (const auto& [vertex, face, tile] : came[rank])
                known_.push_back({vertex, {face, rank, tile}});
        std::ranges::sort(known_, {}, &entry::vertex);
    }

    /// Collective. `questions[r]` are vertices for rank r; the answers tell by their place there which one they are
    /// for.
    std::vector<std::vector<answer>> ask(const std::vector<std::vector<global_id>>& questions)
    {
        const auto asked = all_to_all(comm_, questions);
        std::vector<std::vector<answer>> answers(asked.size());
        for (std::size_t rank = 0; rank < asked.size(); ++rank)
            for (std::size_t q = 0; q < asked[rank].size(); ++q)
                for (const auto& [vertex, found] : std::ranges::equal_range(known_, asked[rank][q], {}, &entry::vertex))
                    answers[rank].push_back({q, found});
        return all_to_all(comm_, answers);
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

/// What owners answer: faces, and the state that their schemes have there.
template <class Point, scheme Scheme>
struct fetched_faces {
    known_faces<Point> known;
    std::vector<kith::detail::known_state<Scheme>> states;
};

/// Collective: asks owners for faces. `wanted[r]` lie on rank r; the result has them in that order. `schemes` are those
/// of the tiles, in their order.
template <tile_like Tile, scheme Scheme>
std::vector<fetched_faces<typename Tile::point_type, Scheme>>
fetch_faces(communicator& comm, std::span<const numbered_tile<Tile>> tiles, std::span<const Scheme> schemes,
            const std::vector<std::vector<faces_at_vertices::place>>& wanted)
{
    using index = typename Tile::index_type;
    using point = typename Tile::point_type;
    const auto asked = all_to_all(comm, wanted);
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
        pack_faces(out, reply);
        if constexpr (has_state<Scheme>) {
            out.add(std::uint64_t(faces_of_tile.size()));
            for (auto& [tile, faces] : faces_of_tile)
                kith::detail::pack_known_state(
                    out, kith::detail::state_at_faces(tiles[tile].part, schemes[tile], std::move(faces)));
        }
        replies[rank] = out.take();
    }
    std::vector<fetched_faces<point, Scheme>> result;
    for (const auto& bytes : all_to_all(comm, std::move(replies))) {
        unpacker in(bytes);
        auto& came = result.emplace_back(unpack_faces<point>(in));
        if constexpr (has_state<Scheme>)
            for (auto left = in.get<std::uint64_t>(); left > 0; --left)
                came.states.push_back(kith::detail::unpack_known_state(in, schemes.front()));
    }
    return result;
}

/// Collective: of each tile the faces that it lacks at its outermost vertices, in their order, each once.
template <tile_like Tile>
std::vector<std::vector<faces_at_vertices::place>> lacking_faces(faces_at_vertices& directory, std::size_t ranks,
                                                                 std::span<const numbered_tile<Tile>> tiles)
{
    std::vector<std::vector<global_id>> questions(ranks);
    std::vector<std::vector<std::size_t>> asking(ranks); // the tile that has each of the questions
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const auto& part = tiles[t].part;
        const auto incomplete = incomplete_vertices(part);
        for (std::size_t v = 0; v < incomplete.size(); ++v)
            if (incomplete[v] != 0) {
                questions[part.vertex_ids[v] % ranks].push_back(part.vertex_ids[v]);
                asking[part.vertex_ids[v] % ranks].push_back(t);
            }
    }
    std::vector<std::vector<faces_at_vertices::place>> lacking(tiles.size());
    const auto answers = directory.ask(questions);
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
}

/// The faces that the tiles of this rank lacked, from their owners.
template <tile_like Tile, scheme Scheme>
class faces_from_owners {
public:
    using known = known_faces<typename Tile::point_type>;

    /// Collective.
    faces_from_owners(communicator& comm, std::span<const numbered_tile<Tile>> tiles, std::span<const Scheme> schemes,
                      const std::vector<std::vector<faces_at_vertices::place>>& lacking)
        : asking_(std::size_t(comm.size())), of_tile_(tiles.size())
    {
        std::vector<std::vector<faces_at_vertices::place>> wanted(asking_.size());
        for (std::size_t t = 0; t < lacking.size(); ++t)
            for (const auto& where : lacking[t]) {
                wanted[where.rank].push_back(where);
                asking_[where.rank].push_back(t);
            }
        came_ = fetch_faces(comm, tiles, schemes, wanted);
        for (std::size_t rank = 0; rank < came_.size(); ++rank)
            for (std::size_t f = 0, corner = 0; f < came_[rank].known.faces.size(); ++f) {
                of_tile_[asking_[rank][f]].append_face(came_[rank].known, f, corner);
                corner += came_[rank].known.faces[f].degree;
            }
    }
    [[nodiscard]] const known& of_tile(std::size_t t) const { return of_tile_[t]; }
    /// f(state) with what the schemes of all ranks say that tile t has asked.
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

/// A tile that has these faces, too.
template <class Point, std::unsigned_integral Index>
tile<Point, Index> with_faces(const tile<Point, Index>& part, const known_faces<Point>& more)
{
    std::vector<Index> all(part.mesh.face_count());
    std::iota(all.begin(), all.end(), Index(0));
    auto known = known_faces_of(part, std::span<const Index>(all));
    known.append(more);
    auto grown = tile_of_faces<Index>(
        std::move(known), not part.first_corner_ids.empty(), part.mesh.generation(), not part.corners_before.empty());
    keep_owned(part, grown);
    return grown;
}

} // namespace detail

/// Collective: lets the shadows of all tiles of a level grow from one ring to `rings`, by asking ring after ring who
/// holds the faces at the outermost vertices. `tiles` are those of this rank, `schemes` those of the tiles, whose state
/// (creases) is fetched, too; what they own stays.
/// Preconditions: each has its edges and a ring of shadows. Marks of edges on level 0 are not carried.
/// Errors: mpi::error. Cost: four messages at most to each rank per ring, and building each tile anew.
template <class Point, std::unsigned_integral Index, scheme Scheme>
void grow_shadows(communicator& comm, std::span<numbered_tile<tile<Point, Index>>> tiles, std::span<Scheme> schemes,
                  int rings)
{
    if (rings <= 1)
        return;
    using tile_type = tile<Point, Index>;
    const std::span<const numbered_tile<tile_type>> all_tiles(tiles);
    detail::faces_at_vertices directory(comm, all_tiles, rings + 1);
    for (int ring = 2; ring <= rings; ++ring) {
        const auto lacking = detail::lacking_faces(directory, std::size_t(comm.size()), all_tiles);
        const detail::faces_from_owners came(comm, all_tiles, std::span<const Scheme>(schemes), lacking);
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            auto& part = tiles[t].part;
            auto grown = detail::with_faces(part, came.of_tile(t));
            if constexpr (has_state<Scheme>) {
                const Scheme before = schemes[t];
                kith::detail::take_part(schemes[t], before, part_numbers<Index>());
                kith::detail::take_over(schemes[t], grown, before, kith::detail::elements_of(part));
                came.for_states(t, [&](const auto& known) {
                    kith::detail::take_over(schemes[t], grown, known.scheme, known.elements);
                });
            }
            part = std::move(grown);
        }
    }
}
/// The same for tiles of a scheme without state.
template <class Point, std::unsigned_integral Index>
void grow_shadows(communicator& comm, std::span<numbered_tile<tile<Point, Index>>> tiles, int rings)
{
    std::vector<kith::detail::no_scheme> none(tiles.size());
    grow_shadows(comm, tiles, std::span(none), rings);
}

} // namespace kith::mpi
