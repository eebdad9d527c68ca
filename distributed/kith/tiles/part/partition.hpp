// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/basic_mesh.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace kith {

/// The assignment of each face of a control mesh to a part. Refined surfaces never depend on it; time and memory do.
struct partition {
    std::vector<std::uint32_t> part_of; ///< per face
    std::size_t parts = 1;
};

namespace detail {

/// Throws mesh_error for 0 parts and for too many parts. More parts than faces are useless but allowed, up to 2^20.
inline void require_parts(std::size_t parts, std::size_t faces)
{
    if (parts == 0)
        throw mesh_error("0 parts were asked for; ask for 1 or more");
    const std::size_t most = std::clamp(faces, std::size_t(1) << 20, std::size_t(UINT32_MAX));
    if (parts > most)
        throw mesh_error(std::to_string(parts) + " parts were asked for, and the mesh has " + std::to_string(faces) +
                         " faces; ask for at most " + std::to_string(most));
}

/// Returns the part of a face in block_partition. The face has `degree` corners, the first of which is corner `first`
/// of all `corners`.
inline std::size_t block_of(std::uint64_t first, std::size_t degree, std::uint64_t corners, std::size_t parts)
{
    const double corners_of_part = double(corners) / double(parts);
    return std::min(parts - 1, std::size_t((double(first) + double(degree) / 2) / corners_of_part));
}

} // namespace detail

/// Returns parts that are runs of faces in the order of their numbers, each with about as many corners as the others.
/// Corners count since a polygon makes a child per corner. Errors: mesh_error for 0 parts, and for more parts than
/// faces if they are more than 2^20. Cost: O(faces).
template <class Point, std::unsigned_integral Index>
partition block_partition(const basic_mesh<Point, Index>& mesh, std::size_t parts)
{
    detail::require_parts(parts, mesh.face_count());
    partition result{std::vector<std::uint32_t>(mesh.face_count()), parts};
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.part_of[f] = std::uint32_t(
            detail::block_of(mesh.topology().first_corner(f), mesh.face(f).size(), mesh.corner_count(), parts));
    return result;
}

/// Reads a partition as METIS's programs write it: for each face the number of its part, below the number of faces.
/// Parts may be empty. Errors: mesh_error for any other input.
template <class Point, std::unsigned_integral Index>
partition read_partition(std::istream& in, const basic_mesh<Point, Index>& mesh)
{
    partition result;
    const auto faces = std::min<std::uint64_t>(mesh.face_count(), UINT32_MAX);
    for (std::int64_t part; in >> part;) {
        if (part < 0 or std::uint64_t(part) >= faces)
            throw mesh_error("the partition file gives face " + std::to_string(result.part_of.size()) + " part " +
                             std::to_string(part) + ", the mesh has " + std::to_string(mesh.face_count()) +
                             " faces; number the parts from 0, below the number of faces");
        result.part_of.push_back(std::uint32_t(part));
        result.parts = std::max(result.parts, std::size_t(part) + 1);
    }
    if (not in.eof() or result.part_of.size() != mesh.face_count())
        throw mesh_error("the partition file has " + std::to_string(result.part_of.size()) + " numbers, the mesh has " +
                         std::to_string(mesh.face_count()) + " faces; give one number per face");
    return result;
}

} // namespace kith
