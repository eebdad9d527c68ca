// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <kith/core/mask/hash_value.hpp>

#include <concepts>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace kith {

/// A checksum of a refined surface. Two surfaces share it if their faces have the same numbers, the same vertices, by
/// number, and the same places, bit for bit. Other surfaces share it only by chance. It is a sum over the faces, so it
/// does not depend on their order, nor on the tile or rank of a face. The sum of the checksums of parts is the checksum
/// of all.
struct mesh_checksum {
    std::uint64_t bits = 0;

    mesh_checksum& operator+=(mesh_checksum other)
    {
        bits += other.bits;
        return *this;
    }
    friend bool operator==(mesh_checksum, mesh_checksum) = default;
};

namespace detail {

/// A hash of words, which are added one after the other.
class word_hash {
public:
    explicit word_hash(std::uint64_t first) : bits_(mix_bits(first + 0x9e3779b97f4a7c15U)) {}
    void add(std::uint64_t word) { bits_ = mix_bits(bits_ + word + 0x9e3779b97f4a7c15U); }
    [[nodiscard]] std::uint64_t bits() const { return bits_; }

private:
    std::uint64_t bits_;
};

template <class Point>
void add_place(word_hash& hash, const Point& point)
{
    static_assert(std::is_trivially_copyable_v<Point>, "a checksum needs points that are plain bytes");
    std::array<std::uint64_t, (sizeof(Point) + 7) / 8> words{};
    std::memcpy(words.data(), &point, sizeof(Point));
    for (const std::uint64_t word : words)
        hash.add(word);
}

template <class Point, std::unsigned_integral Index, std::invocable<Index> VertexId>
mesh_checksum checksum_of_face(const basic_mesh<Point, Index>& mesh, std::size_t face, global_id face_id,
                               const VertexId& vertex_id)
{
    word_hash hash(face_id);
    for (const auto v : mesh.face(face)) {
        hash.add(vertex_id(v));
        add_place(hash, mesh.point(v));
    }
    return {hash.bits()};
}

} // namespace detail

/// Returns the checksum of a whole mesh. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
mesh_checksum checksum(const basic_mesh<Point, Index>& mesh)
{
    mesh_checksum sum;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        sum += detail::checksum_of_face(mesh, f, f, [](Index v) { return global_id(v); });
    return sum;
}

/// Returns for each of the `roots` of a tile the checksum of the owned faces that descend from it. It does not depend
/// on the tile that has the root, so one tile is verified by refining some of its roots in another. Local. Cost:
/// O(corners).
template <class Point, std::unsigned_integral Index>
std::vector<mesh_checksum> checksums_of_roots(const tile<Point, Index>& part)
{
    std::vector<mesh_checksum> sums(part.roots.size());
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f))
            sums[part.root_of[f]] += detail::checksum_of_face(
                part.mesh, f, part.face_ids[f], [&](Index v) { return part.vertex_ids[v]; });
    return sums;
}

/// Returns the checksum of the faces that a tile owns. Local. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
mesh_checksum checksum(const tile<Point, Index>& part)
{
    mesh_checksum sum;
    for (const auto of_root : checksums_of_roots(part))
        sum += of_root;
    return sum;
}

} // namespace kith
