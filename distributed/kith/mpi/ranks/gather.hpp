// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "known_state.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/number/global_numbering.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

/// Packs the faces and vertices that a tile owns.
template <class Point, std::unsigned_integral Index>
void pack_owned(packer& out, const tile<Point, Index>& part)
{
    std::vector<global_id> vertex_ids, faces; // per face its number, its first corner, its degree, its vertices
    std::vector<Point> points;
    for (std::size_t v = 0; v < part.vertex_ids.size(); ++v)
        if (part.owns_vertex(v)) {
            vertex_ids.push_back(part.vertex_ids[v]);
            points.push_back(part.mesh.point(v));
        }
    for (std::size_t f = 0; f < part.face_ids.size(); ++f)
        if (part.owns_face(f)) {
            faces.insert(faces.end(), {part.face_ids[f], part.corner_id(f, 0), part.mesh.face(f).size()});
            for (const Index v : part.mesh.face(f))
                faces.push_back(part.vertex_ids[v]);
        }
    out.add_array(vertex_ids).add_array(points).add_array(faces);
}

/// A mesh of face-vertex lists that is filled tile by tile.
template <class Point, std::unsigned_integral Index>
class gathered_mesh {
public:
    gathered_mesh(const global_counts& counts, int degree) : points_(counts.vertices)
    {
        topology_.vertices = counts.vertices;
        topology_.faces = counts.faces;
        topology_.degree = degree;
        topology_.corner_vertex = storage<Index>(counts.corners);
        if (degree == 0) {
            topology_.face_corner = storage<Index>(counts.faces + 1);
            topology_.corner_face = storage<Index>(counts.corners);
            topology_.face_corner[counts.faces] = Index(counts.corners);
        }
    }
    using face_corners = typename part_numbers<global_id>::face_corners;

    /// Adds a tile and returns the corners of its faces, in their order. Precondition: pack_owned has written what is
    /// read.
    std::vector<face_corners> add(unpacker& in)
    {
        const auto ids = in.get_array<std::vector<global_id>>();
        const auto points = in.get_array<std::vector<Point>>();
        for (std::size_t i = 0; i < ids.size(); ++i)
            points_[ids[i]] = points[i];
        const auto faces = in.get_array<std::vector<global_id>>();
        std::vector<face_corners> result;
        for (std::size_t i = 0; i < faces.size();) {
            const global_id face = faces[i], corner = faces[i + 1], degree = faces[i + 2];
            std::copy_n(faces.begin() + std::ptrdiff_t(i + 3), degree, topology_.corner_vertex.begin() + corner);
            if (topology_.degree == 0) {
                topology_.face_corner[face] = Index(corner);
                std::fill_n(topology_.corner_face.begin() + corner, degree, Index(face));
            }
            result.push_back({corner, degree});
            i += 3 + degree;
        }
        return result;
    }
    basic_mesh<Point, Index> take(int generation) { return {std::move(points_), std::move(topology_), generation}; }

private:
    storage<Point> points_;
    connectivity<Index> topology_;
};

/// The facts on the tiles of a level that are computed from all ranks.
struct gathered_facts {
    int generation;
    int degree;             ///< of all faces, or 0
    std::uint64_t vertices; ///< owned by tiles
    std::uint64_t faces;
};

/// Returns the facts on the tiles of a level. Collective.
template <class Point, std::unsigned_integral Index>
gathered_facts facts_of(communicator& comm, const std::vector<const tile<Point, Index>*>& tiles)
{
    // The generation, and the most and the fewest corners of a face, are known only where a tile is. If one tile has
    // only quads, others may differ.
    constexpr double none = std::numeric_limits<double>::lowest();
    std::array<double, 3> form{0, none, none};
    std::array<std::uint64_t, 2> owned{0, 0};
    for (const auto* part : tiles) {
        form[0] = double(part->mesh.generation());
        if (part->mesh.face_count() != 0) {
            const double degree_of_part = part->mesh.topology().degree;
            form[1] = std::max(form[1], degree_of_part);
            form[2] = std::max(form[2], -degree_of_part);
        }
        owned[0] += owned_count(part->vertex_marks);
        owned[1] += owned_count(part->face_marks);
    }
    const auto [generation, most, fewest] = comm.maximum(form);
    owned = comm.sum(owned);
    return {int(generation), most == -fewest ? int(most) : 0, owned[0], owned[1]};
}

/// Throws mesh_error for a level that one rank cannot hold, and for one of which tiles are missing.
template <class Point, std::unsigned_integral Index>
void require_gatherable(const global_counts& counts, const gathered_facts& facts, std::uint64_t state_bytes,
                        std::uint64_t memory_limit)
{
    const std::uint64_t mixed = facts.degree == 0 ? counts.faces + 1 + counts.corners : 0;
    const std::uint64_t bytes = counts.vertices * sizeof(Point) + (counts.corners + mixed) * sizeof(Index) +
                                state_bytes;
    const std::string what = "the level has " + std::to_string(counts.vertices) + " vertices and " +
                             std::to_string(counts.faces) + " faces";
    const std::string remedy = "; gather a coarser level, or write the tiles into one file";
    if (bytes > memory_limit)
        throw mesh_error(what + ", " + std::to_string(bytes) + " bytes on one rank, and the limit is " +
                         std::to_string(memory_limit) + remedy);
    if (std::max({counts.vertices, counts.faces, counts.corners}) >= std::numeric_limits<Index>::max())
        throw mesh_error(what + ", more than a " + std::to_string(8 * sizeof(Index)) + "-bit index can number" +
                         remedy);
    if (facts.vertices != counts.vertices or facts.faces != counts.faces)
        throw mesh_error(what + ", the tiles own " + std::to_string(facts.vertices) + " and " +
                         std::to_string(facts.faces) + "; give all tiles of the level, each once");
}

/// Sends a message for each of the `tiles` tiles of each rank to rank 0, which takes them one after the other.
/// packed(i) makes the message of tile i of this rank; an empty message says that its rank has failed. Collective.
template <std::invocable<std::size_t> Packed, std::invocable<const std::vector<std::byte>&> Take>
void send_to_root(communicator& comm, std::size_t tiles, const Packed& packed, const Take& take)
{
    if (not comm.is_root())
        comm.send(packer().add(std::uint64_t(tiles)).take(), 0);
    for (std::size_t i = 0; i < tiles; ++i)
        comm.is_root() ? take(packed(i)) : comm.send(packed(i), 0);
    for (int rank = 1; comm.is_root() and rank < comm.size(); ++rank) {
        const auto count = comm.receive(rank);
        for (auto left = unpacker(count).get<std::uint64_t>(); left > 0; --left)
            take(comm.receive(rank));
    }
}

/// Returns these tiles of a level as one mesh on rank 0. `pack(out, i)` adds data of tile i to the message with its
/// faces; `add(in, corners)` reads them on rank 0, given the corners of these faces. The data need `state_bytes` more
/// bytes there. Collective.
template <class Point, std::unsigned_integral Index, std::invocable<packer&, std::size_t> Pack, class Add>
    requires std::invocable<const Add&, unpacker&,
                            const std::vector<typename gathered_mesh<Point, Index>::face_corners>&>
basic_mesh<Point, Index> gather_tiles(communicator& comm, const std::vector<const tile<Point, Index>*>& tiles,
                                      const global_counts& counts, std::uint64_t memory_limit,
                                      std::uint64_t state_bytes, const Pack& pack, const Add& add)
{
    const gathered_facts facts = facts_of(comm, tiles);
    collective_phase(comm, [&] { require_gatherable<Point, Index>(counts, facts, state_bytes, memory_limit); });
    std::optional<gathered_mesh<Point, Index>> whole;
    collective_phase(comm, [&] { comm.is_root() ? void(whole.emplace(counts, facts.degree)) : void(); });
    collective_phase(comm, [&] {
        std::string problem; // no rank may leave while others wait for a message
        const auto packed = [&](std::size_t i) {
            std::vector<std::byte> message;
            if (problem.empty())
                problem = problem_of(
                    [&] {
                        packer out;
                        pack_owned(out, *tiles[i]);
                        pack(out, i);
                        message = out.take();
                    },
                    "there is not enough memory to send a tile");
            return message;
        };
        const auto take = [&](const std::vector<std::byte>& message) {
            if (problem.empty() and not message.empty()) // an empty message: its rank has failed, and reports that
                problem = problem_of(
                    [&] {
                        unpacker in(message);
                        const auto corners = whole->add(in);
                        add(in, corners);
                    },
                    "there is not enough memory to gather a tile");
        };
        send_to_root(comm, tiles.size(), packed, take);
        if (not problem.empty())
            throw std::runtime_error(problem);
    });
    return comm.is_root() ? whole->take(facts.generation) : basic_mesh<Point, Index>();
}

} // namespace detail

/// Returns a level as one mesh on rank 0, with the numbers and the bits of refining it there, as face-vertex lists
/// (connect::faces). Other ranks get an empty mesh. `tiles` are those of this rank, `counts` those of the level. If the
/// mesh needs more than `memory_limit` bytes on rank 0, this is refused before anything is allocated. Collective.
/// Errors: phase_error in this case, for more elements than Index can number, and when tiles are missing. Cost: rank 0
/// receives tile by tile, so it holds the mesh and one tile.
template <class Point, std::unsigned_integral Index>
basic_mesh<Point, Index> gather(communicator& comm, std::span<const numbered_tile<tile<Point, Index>>> tiles,
                                const global_counts& counts, std::uint64_t memory_limit)
{
    const auto parts = collective_phase(comm, [&] {
        std::vector<const tile<Point, Index>*> result;
        for (const auto& numbered : tiles)
            result.push_back(&numbered.part);
        return result;
    });
    return detail::gather_tiles(
        comm, parts, counts, memory_limit, 0, [](packer&, std::size_t) {}, [](unpacker&, const auto&) {});
}

/// A level as one mesh, and the scheme for it.
template <class Point, std::unsigned_integral Index, scheme Scheme>
struct gathered_level {
    basic_mesh<Point, Index> mesh;
    Scheme scheme;
};

/// Returns the tiles of `level` among `tiles` as one mesh, with the state (creases, fields) in the numbers of the
/// whole mesh. `scheme` gives the options, on all ranks; its state is not used, and other ranks than 0 get one without
/// state. Twice the bytes of the state count for the limit, as it grows tile by tile. Collective. Otherwise as above.
template <class Point, std::unsigned_integral Index, scheme Scheme>
gathered_level<Point, Index, Scheme>
gather(communicator& comm, const std::vector<kept_tile<tile<Point, Index>, Scheme>>& tiles, int level,
       const global_counts& counts, std::uint64_t memory_limit, const Scheme& scheme)
{
    std::vector<const tile<Point, Index>*> parts;
    std::vector<const Scheme*> schemes;
    collective_phase(comm, [&] {
        for (const auto& kept : tiles)
            if (kept.level == level) {
                parts.push_back(&kept.part);
                schemes.push_back(&kept.scheme);
            }
    });
    const auto owned_state = [&](std::size_t i) {
        std::vector<Index> faces;
        for (std::size_t f = 0; f < parts[i]->mesh.face_count(); ++f)
            if (parts[i]->owns_face(f))
                faces.push_back(Index(f));
        return kith::detail::state_at_faces(*parts[i], *schemes[i], std::move(faces));
    };
    std::uint64_t bytes = 0;
    collective_phase(comm, [&] {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            packer out;
            kith::detail::pack_state(out, owned_state(i).scheme);
            bytes += out.take().size();
        }
    });
    bytes = comm.sum(std::array{bytes})[0];
    const Scheme without = collective_phase(
        comm, [&] { return kith::detail::scheme_of_part(scheme, part_numbers<Index>()); });
    Scheme whole = collective_phase(comm, [&] { return without; });
    auto mesh = detail::gather_tiles(
        comm,
        parts,
        counts,
        memory_limit,
        2 * bytes,
        [&](packer& out, std::size_t i) { kith::detail::pack_known_state(out, owned_state(i)); },
        [&](unpacker& in, const std::vector<part_numbers<global_id>::face_corners>& corners) {
            const auto known = kith::detail::unpack_known_state(in, without);
            const auto& [vertices, edges, faces, degrees] = known.elements;
            kith::detail::add_state(whole, known.scheme, part_numbers<global_id>{vertices, edges, faces, 0, corners});
        });
    return {std::move(mesh), std::move(whole)};
}

} // namespace kith::mpi
