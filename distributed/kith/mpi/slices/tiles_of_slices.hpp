// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/ply/ply_slice.hpp>
#include "slice_links.hpp"

#include <kith/core/base/error.hpp>
#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/ranks/grow_ghosts.hpp>
#include <kith/tiles/number/global_counts.hpp>
#include <kith/tiles/refine/known_faces.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// The tiles of a control mesh that no rank holds as a whole: one tile per rank, with the number of the rank.
template <class Point, std::unsigned_integral Index>
struct sliced_mesh {
    std::vector<numbered_tile<tile<Point, Index>>> tiles; ///< of this rank
    global_counts counts;
    std::uint64_t bytes_read = 0; ///< by this rank
};

namespace detail {

/// Returns the faces of a slice and the faces that touch them, as a tile with one ring of ghosts and no owned marks.
/// Collective.
template <class Point, std::unsigned_integral Index>
tile<Point, Index> tile_of_slice(communicator& comm, const mesh_slice<Point>& slice, slice_links<Point>& links)
{
    auto faces = links.own_faces();
    const auto asked = all_to_all(comm, links.faces_around());
    const auto came = all_to_all(comm, [&] {
        std::vector<std::vector<std::byte>> replies(asked.size());
        for (std::size_t rank = 0; rank < asked.size(); ++rank) {
            known_faces<Point> reply;
            for (const global_id face : asked[rank]) {
                const std::size_t f = face - slice.first_face;
                reply.append_face(faces, f, f * std::size_t(slice.degree));
            }
            packer out;
            kith::detail::pack_faces(out, reply);
            replies[rank] = out.take();
        }
        return replies;
    });
    return collective_phase(comm, [&] {
        for (const auto& bytes : came) {
            unpacker in(bytes);
            faces.append(kith::detail::unpack_faces<Point>(in));
        }
        return tile_of_faces<Index>(std::move(faces), false, 0, true);
    });
}

/// Marks the elements that the tile owns: an element belongs to the owner of its face with the smallest number.
/// Precondition: the tile has a ring of ghosts around faces [first, end).
template <class Point, std::unsigned_integral Index>
void mark_owned(tile<Point, Index>& part, global_id first, global_id end)
{
    const auto& t = part.mesh.topology();
    std::vector<global_id> smallest(part.mesh.vertex_count(), ~global_id(0));
    const auto is_ours = [&](global_id face) { return face >= first and face < end; };
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f) {
        part.face_marks[f] = is_ours(part.face_ids[f]) ? owned_mark : 0;
        for (const Index v : part.mesh.face(f))
            smallest[v] = std::min(smallest[v], part.face_ids[f]);
    }
    const auto incomplete = incomplete_vertices(part);
    for (std::size_t v = 0; v < smallest.size(); ++v)
        part.vertex_marks[v] = incomplete[v] == 0 and is_ours(smallest[v]) ? owned_mark : 0;
    for (std::size_t e = 0; e < t.edges(); ++e) {
        global_id face = part.face_ids[t.face_of(t.halfedge_corner[2 * e])];
        if (not t.is_boundary(e))
            face = std::min(face, part.face_ids[t.face_of(t.halfedge_corner[2 * e + 1])]);
        if (not part.is_cut(e) and is_ours(face))
            part.edge_marks[e] = static_cast<unsigned char>(part.edge_marks[e] | owned_mark);
    }
}

} // namespace detail

/// Throws phase_error on all ranks unless all of them can read a file, before they read their parts of it. Collective.
/// The message has the path and the reason of the system and, if only some ranks cannot read it, the rank and its host.
inline void require_readable_on_all(communicator& comm, const std::string& path)
{
    std::string problem = problem_of([&] { sliced_ply::require_readable(path); });
    const bool is_here = problem.empty();
    const std::uint64_t failed = comm.sum(std::array{std::uint64_t(is_here ? 0 : 1)})[0];
    if (not is_here and failed != std::uint64_t(comm.size()))
        problem += " on rank " + std::to_string(comm.rank()) + " of " + std::to_string(comm.size()) + ", " +
                   host_name() + "; put the file where all ranks see it";
    comm.agree(problem);
}

/// Reads a PLY file of triangles or of quads, each rank its part of the bytes. Returns one tile per rank with `rings` >
/// 0 rings of ghosts: the tiles that tile_cutter makes of the mesh and its block_partition, with the numbers that
/// make_mesh gives. The rank that reads a vertex is responsible for it and for its edges to vertices of larger number.
/// Collective. Errors: phase_error for a file that a rank cannot read; for files of other kinds; and for a mesh that is
/// not a manifold.
/// Cost: O(file / ranks) memory and work on each rank, and that of the ghosts, but O(n log n) work for a vertex of n
/// faces; at most about twenty messages to each rank.
template <std::unsigned_integral Index = std::uint32_t>
sliced_mesh<std::array<double, 3>, Index> read_tiles(communicator& comm, const std::string& path, int rings)
{
    using point = std::array<double, 3>;
    sliced_mesh<point, Index> result;
    require_readable_on_all(comm, path);
    mesh_slice<point> slice;
    const auto ranges = collective_phase(comm, [&] {
        if (rings < 1)
            throw mesh_error(path + ": tiles with " + std::to_string(rings) +
                             " rings of ghosts were asked for; ask for 1 or more");
        sliced_ply file(path);
        slice_ranges all(file.vertices(), file.faces(), file.degree(), comm.size());
        const auto r = std::size_t(comm.rank());
        slice = file.read(all.face[r], all.face[r + 1], all.vertex[r], all.vertex[r + 1]);
        result.bytes_read = file.bytes_read();
        try {
            start_at_smallest(slice);
        } catch (const mesh_error& error) {
            throw mesh_error(path + ": " + error.what());
        }
        return all;
    });
    require_same_on_ranks(comm, slice.vertices, "the number of vertices", path);
    require_same_on_ranks(comm, slice.faces, "the number of faces", path);
    detail::slice_links<point> links(comm, path, slice, ranges);
    result.counts = {slice.vertices, links.edges(), slice.faces, slice.faces * global_id(slice.degree)};
    auto part = detail::tile_of_slice<point, Index>(comm, slice, links);
    collective_phase(comm, [&] {
        const auto r = std::size_t(comm.rank());
        detail::mark_owned(part, ranges.face[r], ranges.face[r + 1]);
        result.tiles.push_back({std::uint64_t(comm.rank()), std::move(part)});
    });
    grow_ghosts(comm, std::span(result.tiles), rings);
    return result;
}

} // namespace kith::mpi
