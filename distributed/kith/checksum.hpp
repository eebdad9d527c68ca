// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <kith/hash_value.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace kith {

/// A number that two refined surfaces share if and, but for chance, only if they have the same faces, by number, with the
/// same vertices, by number, at the same places, bit for bit. It is a sum over the faces, so it does not depend on which
/// tile or rank a face belongs to, nor on their order: sums of checksums are the checksum of all.
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

/// Hashes words one after the other.
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

template <class Mesh, class FaceId, class VertexId, class Counts>
mesh_checksum checksum_of_faces(const Mesh& mesh, const FaceId& face_id, const VertexId& vertex_id,
                                const Counts& counts)
{
    mesh_checksum sum;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (not counts(f))
            continue;
        word_hash hash(face_id(f));
        for (const auto v : mesh.face(f)) {
            hash.add(vertex_id(v));
            add_place(hash, mesh.point(v));
        }
        sum.bits += hash.bits();
    }
    return sum;
}

} // namespace detail

/// Of a whole mesh. Cost: O(corners).
template <class Point, class Index>
mesh_checksum checksum(const basic_mesh<Point, Index>& mesh)
{
    const auto same = [](std::size_t i) { return std::uint64_t(i); };
    return detail::checksum_of_faces(mesh, same, same, [](std::size_t) { return true; });
}

/// Of the faces that a tile owns. Local. Cost: O(corners).
template <class Point, class Index>
mesh_checksum checksum(const tile<Point, Index>& part)
{
    return detail::checksum_of_faces(
        part.mesh,
        [&](std::size_t f) { return part.face_ids[f]; },
        [&](std::size_t v) { return part.vertex_ids[v]; },
        [&](std::size_t f) { return part.owns_face(f); });
}

} // namespace kith
