// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/tiles/part/partition.hpp>

#include <metis.h>

#include <concepts>
#include <limits>
#include <new>
#include <string>

namespace kith {

/// Returns connected parts with short borders, by METIS (Karypis & Kumar 1998, multilevel k-way). The graph joins faces
/// that share an edge. A face weighs as many units as it has corners, since a polygon makes a child per corner. The
/// random numbers are seeded, so that one version of METIS always gives the same partition. Parts may be empty. Two
/// cases are cut by block_partition instead: graphs whose arrays the 32-bit index of METIS cannot number, and parts of
/// fewer than two faces.
/// Errors: mesh_error for a mesh of face-vertex lists only, and when METIS reports one. Cost: about 150 bytes per face.
template <class Point, std::unsigned_integral Index>
partition metis_partition(const basic_mesh<Point, Index>& mesh, std::size_t parts)
{
    detail::require_parts(parts, mesh.face_count());
    require_edges(mesh);
    const auto& t = mesh.topology();
    const std::size_t inner_edges = mesh.corner_count() - mesh.edge_count();
    constexpr auto most = std::size_t(std::numeric_limits<idx_t>::max());
    if (parts == 1 or 2 * parts > mesh.face_count() or 2 * inner_edges >= most or mesh.corner_count() >= most)
        return block_partition(mesh, parts);

    std::vector<idx_t> first(mesh.face_count() + 1), neighbors, weights(mesh.face_count());
    neighbors.reserve(2 * inner_edges);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (Index c = t.first_corner(f); c < t.first_corner(f + 1); ++c)
            if (const Index other = t.across(c); other != t.none)
                neighbors.push_back(idx_t(t.face_of(other)));
        first[f + 1] = idx_t(neighbors.size());
        weights[f] = idx_t(mesh.face(f).size());
    }
    idx_t vertices = idx_t(mesh.face_count()), constraints = 1, part_count = idx_t(parts), cut = 0;
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    options[METIS_OPTION_NUMBERING] = 0;
    std::vector<idx_t> part_of(mesh.face_count());
    const int status = METIS_PartGraphKway(&vertices,
                                           &constraints,
                                           first.data(),
                                           neighbors.data(),
                                           weights.data(),
                                           nullptr,
                                           nullptr,
                                           &part_count,
                                           nullptr,
                                           nullptr,
                                           options,
                                           &cut,
                                           part_of.data());
    if (status == METIS_ERROR_MEMORY)
        throw std::bad_alloc();
    if (status != METIS_OK)
        throw mesh_error("METIS cannot cut the mesh into " + std::to_string(parts) + " parts (code " +
                         std::to_string(status) + "); use blocks or a partition file");
    return {std::vector<std::uint32_t>(part_of.begin(), part_of.end()), parts};
}

} // namespace kith
