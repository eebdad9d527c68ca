// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_job.hpp"

#include <kith/core/base/message.hpp>
#include <kith/core/mask/hash_value.hpp>
#include <kith/tiles/part/check_tile.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The error of bytes that were damaged in transfer or have another format.
struct pack_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A writer of plain values and arrays to a message. The bytes are those of this machine, so messages stay within one
/// job on machines of one kind. Messages with tiles verify that by `kind_of_message` at their start.
class packer {
public:
    template <class T>
        requires std::is_trivially_copyable_v<T>
    packer& add(const T& value)
    {
        const auto* bytes = reinterpret_cast<const std::byte*>(&value);
        bytes_.insert(bytes_.end(), bytes, bytes + sizeof(T));
        return *this;
    }
    template <class T>
        requires std::is_trivially_copyable_v<T>
    packer& add_array(const T* data, std::size_t size)
    {
        add(std::uint64_t(size));
        const auto* bytes = reinterpret_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), bytes, bytes + size * sizeof(T));
        return *this;
    }
    template <class Array>
        requires requires(const Array& array) { array.data(), array.size(); }
    packer& add_array(const Array& array)
    {
        return add_array(array.data(), array.size());
    }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

/// A reader of the values that a packer wrote, in the same order. Errors: pack_error when the message has too few
/// bytes.
class unpacker {
public:
    explicit unpacker(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class T>
        requires std::is_trivially_copyable_v<T>
    T get()
    {
        T value;
        std::memcpy(&value, take(sizeof(T), 1).data(), sizeof(T));
        return value;
    }
    template <class Array>
    Array get_array()
    {
        using value = typename Array::value_type;
        const auto size = get<std::uint64_t>();
        const auto bytes = take(size, sizeof(value));
        Array result = made<Array>(size);
        if (size != 0)
            std::memcpy(result.data(), bytes.data(), bytes.size());
        return result;
    }
    [[nodiscard]] bool is_at_end() const { return bytes_.empty(); }

private:
    template <class Array>
    static Array made(std::size_t size)
    {
        if constexpr (std::constructible_from<Array, std::size_t>) {
            return Array(size);
        } else { // a string
            Array result;
            result.resize(size);
            return result;
        }
    }
    std::span<const std::byte> take(std::size_t count, std::size_t size)
    {
        if (count > bytes_.size() / size)
            throw pack_error("a message is truncated or from another version");
        const auto result = bytes_.first(count * size);
        bytes_ = bytes_.subspan(count * size);
        return result;
    }

    std::span<const std::byte> bytes_;
};
static_assert(message_writer<packer> and message_reader<unpacker>);

namespace detail {

/// Returns the first word of messages of one format, version and kind of machine. Other machines may read its bytes in
/// reverse order.
template <class Point, std::unsigned_integral Index>
constexpr std::uint64_t kind_of_bytes(std::uint64_t format, std::uint64_t version)
{
    return format << 32 | version << 16 | sizeof(Point) << 8 | sizeof(Index);
}
template <class Point, std::unsigned_integral Index>
inline constexpr std::uint64_t kind_of_message = kind_of_bytes<Point, Index>(0x6b697468, 5);

template <class State>
constexpr bool can_be_packed()
{
    constexpr bool can = requires(const State& from, State& to, packer& out, unpacker& in) {
        from.pack(out);
        to.unpack(in);
    };
    static_assert(
        can,
        "the state that a scheme names in its traits() needs pack(out) const and unpack(in), which write it to a "
        "kith::packer and read it from a kith::unpacker, to be sent to other ranks");
    return can;
}
template <scheme Scheme>
void pack_state(packer& out, const Scheme& scheme)
{
    for_each_state(scheme, [&]<class State>(const State& state) {
        if constexpr (can_be_packed<State>())
            state.pack(out);
    });
}
template <scheme Scheme>
void unpack_state(unpacker& in, Scheme& scheme)
{
    for_each_state(scheme, [&]<class State>(State& state) {
        if constexpr (can_be_packed<State>())
            state.unpack(in);
    });
}

/// Returns the sum of the hashed words of a message, each mixed with its position. It detects damage, not malice.
inline std::uint64_t checksum_of_bytes(std::span<const std::byte> bytes)
{
    std::uint64_t sum = mix_bits(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
        sum += mix_bits(word ^ mix_bits(i));
    }
    return sum;
}

/// The mesh that a message contains, which may be damaged.
template <class Point, std::unsigned_integral Index>
struct told_mesh {
    storage<Point> points;
    connectivity<Index> topology;
    int generation;
};

/// Calls f for the arrays of a mesh except its points, in the order of a message.
template <class Topology, class F>
void for_each_array(Topology& t, const F& f)
{
    f(t.corner_vertex), f(t.corner_halfedge), f(t.halfedge_corner), f(t.vertex_corner);
    f(t.face_corner), f(t.corner_face);
}

template <class Point, std::unsigned_integral Index>
void pack_mesh(packer& out, const basic_mesh<Point, Index>& mesh)
{
    static_assert(std::is_trivially_copyable_v<Point>, "points that are plain bytes can be sent, others not");
    const auto& t = mesh.topology();
    out.add(std::uint64_t(t.vertices)).add(std::uint64_t(t.faces)).add(t.degree).add(mesh.generation());
    out.add_array(mesh.points());
    for_each_array(t, [&](const auto& array) { out.add_array(array); });
}

/// Returns the mesh that pack_mesh has written. Errors: pack_error for a message that ends too early.
template <class Point, std::unsigned_integral Index>
told_mesh<Point, Index> unpack_mesh(unpacker& in)
{
    connectivity<Index> t;
    t.vertices = in.get<std::uint64_t>();
    t.faces = in.get<std::uint64_t>();
    t.degree = in.get<int>();
    const int generation = in.get<int>();
    auto points = in.get_array<storage<Point>>();
    for_each_array(t, [&]<class Array>(Array& array) { array = in.get_array<Array>(); });
    return {std::move(points), std::move(t), generation};
}

/// Calls f for the arrays of a tile besides its mesh, in the order of a message.
template <tile_like Tile, class F>
void for_each_array_of_tile(Tile& part, const F& f)
{
    f(part.root_of), f(part.vertex_ids), f(part.edge_ids), f(part.face_ids);
    f(part.first_corner_ids), f(part.corners_before), f(part.marked_before), f(part.roots);
    f(part.vertex_marks), f(part.edge_marks), f(part.face_marks), f(part.normals);
    f(part.corner_normals);
}

} // namespace detail

/// Returns a tile and the state of its scheme as one message. Cost: O(elements).
template <class Point, std::unsigned_integral Index, scheme Scheme>
std::vector<std::byte> pack(const tile_job<tile<Point, Index>, Scheme>& job)
{
    packer out;
    out.add(detail::kind_of_message<Point, Index>);
    detail::pack_mesh(out, job.part.mesh);
    detail::for_each_array_of_tile(job.part, [&](const auto& array) { out.add_array(array); });
    detail::pack_state(out, job.scheme);
    auto bytes = out.take();
    const std::uint64_t sum = detail::checksum_of_bytes(bytes);
    const auto* tail = reinterpret_cast<const std::byte*>(&sum);
    bytes.insert(bytes.end(), tail, tail + sizeof sum);
    return bytes;
}

/// Returns the tile and the scheme that `pack` has written. `scheme` has the options of the job, which messages do not
/// contain; its state is replaced. Errors: pack_error for bytes that are damaged or no such message; and for a tile
/// whose elements are not in the order of their global numbers.
template <class Point, std::unsigned_integral Index, scheme Scheme>
tile_job<tile<Point, Index>, Scheme> unpack(std::span<const std::byte> bytes, Scheme scheme)
{
    std::uint64_t sum = 0;
    if (bytes.size() < sizeof sum)
        throw pack_error("a message is too short");
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    bytes = bytes.first(bytes.size() - sizeof sum);
    if (sum != detail::checksum_of_bytes(bytes))
        throw pack_error("a message was damaged in transfer; its checksum is wrong");
    unpacker in(bytes);
    if (in.get<std::uint64_t>() != detail::kind_of_message<Point, Index>)
        throw pack_error("a message comes from another program, version or kind of machine");
    auto mesh = detail::unpack_mesh<Point, Index>(in);
    tile<Point, Index> part;
    detail::for_each_array_of_tile(part, [&]<class Array>(Array& array) { array = in.get_array<Array>(); });
    detail::unpack_state(in, scheme);
    if (not in.is_at_end())
        throw pack_error("a message is longer than its contents");
    const char* fault = detail::fault_of_tile(mesh.topology, mesh.points.size(), part);
    if (fault == nullptr and not part.normals.empty() and part.normals.size() != mesh.points.size())
        fault = "has more or fewer normals than vertices";
    if (fault == nullptr and not part.corner_normals.empty() and part.corner_normals.size() != mesh.topology.corners())
        fault = "has more or fewer normals of corners than corners";
    if (fault != nullptr)
        throw pack_error(std::string("a message holds a tile that ") + fault + "; its sender is at fault");
    part.mesh = {std::move(mesh.points), std::move(mesh.topology), mesh.generation};
    return {std::move(part), std::move(scheme)};
}

} // namespace kith
