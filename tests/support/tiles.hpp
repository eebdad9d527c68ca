// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/pack.hpp>
#include <kith/tiles/refine/refine_tile.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

/// Partitions for tests. Results must not depend on the partition.
namespace partitions {

/// Returns parts of consecutive faces, of equal sizes up to one face.
inline std::vector<std::uint32_t> blocks(std::size_t faces, std::size_t parts)
{
    std::vector<std::uint32_t> part_of(faces);
    for (std::size_t f = 0; f < faces; ++f)
        part_of[f] = std::uint32_t(f * parts / faces);
    return part_of;
}

/// Returns a random part for every face; some parts may stay empty.
inline std::vector<std::uint32_t> scattered(std::size_t faces, std::size_t parts, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::vector<std::uint32_t> part_of(faces);
    for (auto& p : part_of)
        p = std::uint32_t(random() % parts);
    return part_of;
}

/// Returns parts that are grown around random faces, layer by layer. Each part is connected if the mesh is.
template <class Mesh>
std::vector<std::uint32_t> grown(const Mesh& mesh, std::size_t parts, std::uint32_t seed)
{
    const auto& t = mesh.topology();
    std::mt19937 random(seed);
    std::vector<std::uint32_t> part_of(mesh.face_count(), 0);
    std::vector<unsigned char> is_taken(mesh.face_count(), 0);
    std::vector<std::size_t> queue;
    for (std::uint32_t p = 0; p < parts; ++p) {
        queue.push_back(random() % mesh.face_count());
        part_of[queue.back()] = p;
        is_taken[queue.back()] = 1;
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (auto c = t.first_corner(queue[i]); c < t.first_corner(queue[i] + 1); ++c)
            if (const auto across = t.halfedge_corner[t.corner_halfedge[c] ^ 1]; across != t.none) {
                const auto f = t.face_of(across);
                if (is_taken[f] == 0) {
                    is_taken[f] = 1;
                    part_of[f] = part_of[queue[i]];
                    queue.push_back(f);
                }
            }
    return part_of;
}

} // namespace partitions

/// Compares every element of a refined tile, including ghosts, with the mesh that was refined as a whole. Returns the
/// first difference, or "". Counts the elements that the tile owns.
template <class Tile, class Mesh>
std::string difference(const Tile& tile, const Mesh& whole, std::vector<int>& vertex_owners,
                       std::vector<int>& edge_owners, std::vector<int>& face_owners)
{
    const auto number = [](auto x) { return std::to_string(x); };
    for (std::size_t v = 0; v < tile.vertex_ids.size(); ++v) {
        const auto id = tile.vertex_ids[v];
        if (id >= whole.vertex_count())
            return "vertex " + number(v) + " has id " + number(id);
        if (not(tile.mesh.point(v) == whole.point(id)))
            return "vertex " + number(id) + " is elsewhere";
        vertex_owners[id] += tile.owns_vertex(v);
    }
    const auto& here = tile.mesh.topology();
    const auto& there = whole.topology();
    for (std::size_t f = 0; f < tile.face_ids.size(); ++f) {
        const auto id = tile.face_ids[f];
        if (id >= whole.face_count())
            return "face " + number(f) + " has id " + number(id);
        face_owners[id] += tile.owns_face(f);
        const auto a = tile.mesh.face(f), b = whole.face(id);
        if (a.size() != b.size())
            return "face " + number(id) + " has another degree";
        for (std::size_t k = 0; k < a.size(); ++k) {
            if (tile.vertex_ids[a[k]] != b[k])
                return "face " + number(id) + " has other vertices";
            if (tile.corner_id(f, k) != there.first_corner(id) + k)
                return "face " + number(id) + " has other corners";
            if (here.faces_only())
                continue;
            const auto half = here.corner_halfedge[here.first_corner(f) + k];
            if (tile.end_id(half / 2, half % 2) != there.corner_halfedge[there.first_corner(id) + k])
                return "face " + number(id) + " has other edges";
            const bool is_rim = here.halfedge_corner[half ^ 1] == here.none;
            const bool is_boundary = there.halfedge_corner[tile.end_id(half / 2, half % 2) ^ 1] == there.none;
            if (tile.owns_face(f) and is_rim and tile.is_cut(half / 2) == is_boundary)
                return "face " + number(id) + " takes a cut for a boundary or a boundary for a cut";
        }
    }
    for (std::size_t e = 0; e < tile.edge_ids.size(); ++e)
        if (tile.edge_ids[e] >= whole.edge_count())
            return "edge " + number(e) + " has id " + number(tile.edge_ids[e]);
        else
            edge_owners[tile.edge_ids[e]] += tile.owns_edge(e);
    return {};
}

/// Returns the number of marked edges, or 0 if the scheme marks no edges.
template <class Scheme, class Mesh>
std::size_t marked_edges(const Mesh& mesh)
{
    std::size_t result = 0;
    if constexpr (kith::marks_edges<Scheme>) {
        const kith::level_of<Mesh> level(mesh);
        for (const auto e : level.edges())
            result += kith::traits_of<Scheme>.is_marked(e);
    }
    return result;
}

/// Refines every part of a mesh as a tile and compares the tiles with the refined mesh. Returns a difference, or "".
template <class Mesh, class Scheme>
std::string tiles_differ(const Mesh& control, const Scheme& scheme, int levels, std::span<const std::uint32_t> part_of,
                         std::size_t parts, int last_rings = 0, kith::connect last = kith::connect::everything)
{
    const auto whole_mesh = kith::refine(control, scheme, levels);
    kith::tile_cutter cutter(control, scheme, part_of, parts);
    const auto rings = kith::ring_schedule(scheme, levels, last_rings);
    auto rim = cutter.cut_rim(kith::ring_schedule(scheme, levels, 1)[0]);
    const kith::global_levels_of<Scheme> whole(
        cutter.counts(), std::move(rim.part), std::move(rim.scheme), levels, last_rings);
    if (whole.counts(levels) != kith::global_counts{whole_mesh.vertex_count(),
                                                    whole_mesh.edge_count(),
                                                    whole_mesh.face_count(),
                                                    whole_mesh.corner_count(),
                                                    marked_edges<Scheme>(whole_mesh)})
        return "the counts differ";
    std::vector<int> vertices(whole_mesh.vertex_count()), edges(whole_mesh.edge_count()),
        faces(whole_mesh.face_count());
    for (std::size_t p = 0; p < parts; ++p) {
        auto job = cutter.cut(p, rings[0]);
        const auto fine = kith::refine(std::move(job.part), std::move(job.scheme), whole, last);
        if (auto text = difference(fine, whole_mesh, vertices, edges, faces); not text.empty())
            return "part " + std::to_string(p) + ": " + text;
    }
    const auto once = [](int owners) { return owners == 1; };
    if (not std::ranges::all_of(faces, once))
        return "a face has no owner, or two";
    if (not std::ranges::all_of(vertices, once))
        return "a vertex has no owner, or two";
    if (last == kith::connect::everything and not std::ranges::all_of(edges, once))
        return "an edge has no owner, or two";
    return {};
}

/// Returns the number of ghost rings that a step needs around a part of one face, so that `last` rings are right
/// afterwards. It is the maximum over the parts of every `stride`-th face.
template <class Mesh, class Scheme>
int rings_that_suffice(const Mesh& mesh, const Scheme& scheme, int last, std::size_t stride)
{
    const std::size_t parts = mesh.face_count();
    const auto part_of = partitions::blocks(parts, parts);
    kith::tile_cutter cutter(mesh, scheme, part_of, parts);
    auto rim = cutter.cut_rim(reach_of(scheme, std::max(1, last)));
    const kith::global_levels_of<Scheme> whole(cutter.counts(), std::move(rim.part), std::move(rim.scheme), 1, last);
    int result = 0;
    for (std::size_t p = 0; p < parts; p += stride) {
        const auto refined = [&](int rings) {
            auto job = cutter.cut(p, rings);
            job.part = kith::refine(std::move(job.part), std::move(job.scheme), whole);
            job.part.roots = {}; // the roots depend on the number of rings
            job.part.root_of = {};
            return kith::pack(job);
        };
        int rings = reach_of(scheme, last);
        const auto right = refined(rings);
        while (rings > 0 and refined(rings - 1) == right)
            --rings;
        result = std::max(result, rings);
    }
    return result;
}
