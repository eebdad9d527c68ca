// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/basic_mesh.hpp>
#include <kith/error.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace kith {

/// Which part each face of a control mesh belongs to. Refined surfaces never depend on it; time and memory do.
struct partition {
    std::vector<std::uint32_t> part_of; ///< per face
    std::size_t parts = 1;
};

namespace detail {

inline void require_parts(std::size_t parts)
{
    if (parts == 0 or parts > UINT32_MAX)
        throw mesh_error(std::to_string(parts) + " parts were asked for; ask for 1 or more");
}

/// Of a run of faces: the part of a face of `degree` corners, the first of which is `first` of all `corners`.
inline std::size_t block_of(std::uint64_t first, std::size_t degree, std::uint64_t corners, std::size_t parts)
{
    const double corners_of_part = double(corners) / double(parts);
    return std::min(parts - 1, std::size_t((double(first) + double(degree) / 2) / corners_of_part));
}

} // namespace detail

/// Runs of faces in the order of their numbers, of as many corners each as can be: polygons make a child per corner.
/// Cost: O(faces).
template <class Point, class Index>
partition block_partition(const basic_mesh<Point, Index>& mesh, std::size_t parts)
{
    detail::require_parts(parts);
    partition result{std::vector<std::uint32_t>(mesh.face_count()), parts};
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.part_of[f] = std::uint32_t(
            detail::block_of(mesh.topology().first_corner(f), mesh.face(f).size(), mesh.corner_count(), parts));
    return result;
}

/// One number per face, as METIS's programs write them. Errors: mesh_error for anything else.
template <class Point, class Index>
partition read_partition(std::istream& in, const basic_mesh<Point, Index>& mesh)
{
    partition result;
    for (std::int64_t part; in >> part;) {
        if (part < 0 or part > UINT32_MAX - 1)
            throw mesh_error("the partition file gives face " + std::to_string(result.part_of.size()) + " part " +
                             std::to_string(part) + "; number the parts from 0");
        result.part_of.push_back(std::uint32_t(part));
        result.parts = std::max(result.parts, std::size_t(part) + 1);
    }
    if (not in.eof() or result.part_of.size() != mesh.face_count())
        throw mesh_error("the partition file has " + std::to_string(result.part_of.size()) + " numbers, the mesh has " +
                         std::to_string(mesh.face_count()) + " faces; give one number per face");
    return result;
}

} // namespace kith
