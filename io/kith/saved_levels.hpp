// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "packed_mesh.hpp"

#include <kith/hierarchy.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <iterator>
#include <ostream>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::io {

namespace detail {

template <class Point, std::unsigned_integral Index>
inline constexpr std::uint64_t kind_of_levels = kith::detail::kind_of_bytes<Point, Index>(0x6b69746c, 3);

template <level Level>
auto points_of(const Level& level)
{
    storage<typename Level::point_type> result(level.vertex_count());
    for (const auto v : level.vertices())
        result[v.index()] = v.point();
    return result;
}
template <class Point>
std::uint64_t checksum_of(const storage<Point>& points)
{
    return kith::detail::checksum_of_bytes(std::as_bytes(std::span(points.data(), points.size())));
}

/// Returns a code of the elements on which a state has values, and of the type of its numbers. The code of a state that
/// is no field is 0.
template <class State>
constexpr std::uint64_t kind_of_state()
{
    if constexpr (requires {
                      typename State::value_type;
                      State::where;
                  }) {
        using value = typename State::value_type;
        const auto kind = []<class Number>(const Number*) {
            return std::uint64_t(std::is_arithmetic_v<Number>) << 2 |
                   std::uint64_t(std::is_floating_point_v<Number>) << 1 | std::uint64_t(std::is_signed_v<Number>);
        };
        std::uint64_t numbers = 0;
        if constexpr (requires { typename value::value_type; })
            numbers = kind(static_cast<const typename value::value_type*>(nullptr)) << 3 |
                      sizeof(typename value::value_type) << 8;
        else
            numbers = kind(static_cast<const value*>(nullptr));
        return std::uint64_t(sizeof(value)) << 32 | numbers << 8 | std::uint64_t(State::where) << 1 | 1;
    } else {
        return 0;
    }
}
/// Returns the codes of all states that a scheme keeps of a level.
template <scheme Scheme>
std::vector<std::uint64_t> kinds_of_state(const Scheme& scheme)
{
    std::vector<std::uint64_t> result;
    kith::detail::for_each_state(scheme, [&]<class State>(const State&) { result.push_back(kind_of_state<State>()); });
    return result;
}

/// Adds a level. A scheme that refines chosen faces gets the faces that were chosen when the level was saved.
template <mesh M, scheme Scheme>
void refine_as_saved(hierarchy<M, Scheme>& levels, unpacker& bytes)
{
    if constexpr (selecting_scheme<Scheme, level_of<M>>) {
        const auto chosen = bytes.get_array<std::vector<unsigned char>>();
        chosen.empty() ? levels.refine() : levels.refine_flagged(chosen);
    } else {
        levels.refine();
    }
}

/// Returns the scheme of the control mesh, without the faces that were chosen for a step that has been undone.
template <mesh M, scheme Scheme>
Scheme control_scheme(const hierarchy<M, Scheme>& levels)
{
    Scheme result = levels.scheme(0);
    if constexpr (selecting_scheme<Scheme, level_of<M>>)
        if (levels.depth() == 0 and levels.undone() > 0)
            result.select(levels.elements(0), std::vector<unsigned char>(levels.elements(0).face_count(), 1));
    return result;
}

/// Throws file_error if the states of the scheme do not fit the control mesh.
template <class Point, std::unsigned_integral Index, scheme Scheme>
void require_states_of(const basic_mesh<Point, Index>& control, const Scheme& scheme)
try {
    kith::detail::require_states_of(level_of<basic_mesh<Point, Index>>(control), scheme);
} catch (const mesh_error& error) {
    throw file_error(std::string("saved levels: their control mesh and its state do not fit: ") + error.what());
}

/// Returns the native mesh with the elements of this mesh.
template <mesh M>
auto native(const M& mesh)
{
    if constexpr (requires { mesh.topology(); })
        return mesh;
    else
        return to_native(mesh);
}

} // namespace detail

/// Writes a hierarchy with the state of its scheme (creases, fields) for `read_levels`. The bytes hold the control
/// mesh, the number of refinements, the faces chosen for them, and the points that `move_points` has moved; all else
/// follows from these. The bytes are those of this kind of machine. They lack removed elements of the control mesh and
/// properties that are no fields of the scheme.
/// Errors: those of the stream, in its state. Cost: that of the control mesh and of levels that were moved.
template <mesh M, scheme Scheme>
void write_levels(std::ostream& out, const hierarchy<M, Scheme>& levels)
{
    using point = typename mesh_traits<M>::point;
    const auto control = detail::native(levels[0]);
    packer bytes;
    bytes.add(detail::kind_of_levels<point, typename hierarchy<M, Scheme>::index_type>);
    bytes.add_array(scheme_name<Scheme>());
    bytes.add_array(detail::kinds_of_state(levels.scheme(0)));
    bytes.add(levels.depth()).add(levels.kept_levels());
    pack_mesh(bytes, control);
    kith::detail::pack_state(bytes, detail::control_scheme(levels));
    for (int level = 1; level <= levels.depth(); ++level) {
        if constexpr (selecting_scheme<Scheme, level_of<M>>)
            bytes.add_array(levels.scheme(level - 1).chosen());
        bytes.add(std::uint8_t(levels.is_moved(level)));
        if (levels.is_moved(level))
            bytes.add_array(detail::points_of(levels.elements(level)));
    }
    bytes.add(detail::checksum_of(detail::points_of(levels.elements(levels.depth()))));
    const auto all = bytes.take();
    const std::uint64_t sum = kith::detail::checksum_of_bytes(all);
    out.write(reinterpret_cast<const char*>(all.data()), std::streamsize(all.size()));
    out.write(reinterpret_cast<const char*>(&sum), sizeof sum);
}

/// Reads a hierarchy that `write_levels` has written, with all its levels, to the same bits. `scheme` has the options
/// of the saved one, and as many fields of the same types; their values are read. Errors: file_error for bytes that are
/// damaged, or belong to other types or another scheme, and if the options make other levels. Also mesh_error if the
/// hierarchy does not fit into the memory limit. Cost: that of refining.
template <mesh M, scheme Scheme>
hierarchy<M, Scheme> read_levels(std::istream& in, Scheme scheme = Scheme(), refine_options options = {})
try {
    using point = typename mesh_traits<M>::point;
    using index = typename hierarchy<M, Scheme>::index_type;
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::uint64_t sum = 0;
    if (text.size() < sizeof sum)
        throw file_error("saved levels: there are " + std::to_string(text.size()) + " bytes, too few to hold any");
    const auto all = std::as_bytes(std::span(text)).first(text.size() - sizeof sum);
    std::memcpy(&sum, text.data() + all.size(), sizeof sum);
    if (sum != kith::detail::checksum_of_bytes(all))
        throw file_error("saved levels: the checksum is wrong; they were damaged or cut, save them again");
    unpacker bytes(all);
    if (bytes.get<std::uint64_t>() != detail::kind_of_levels<point, index>)
        throw file_error("saved levels: they are of another type of mesh, version or kind of machine");
    const auto letters = bytes.get_array<std::vector<char>>();
    const std::string name(letters.begin(), letters.end());
    if (name != scheme_name<Scheme>())
        throw file_error("saved levels: they are of the scheme " + name + ", not of " +
                         std::string(scheme_name<Scheme>()));
    if (bytes.get_array<std::vector<std::uint64_t>>() != detail::kinds_of_state(scheme))
        throw file_error(
            "saved levels: their scheme has other fields; give it those that it had, of the same types and "
            "in the same order");
    const int depth = bytes.get<int>(), kept = bytes.get<int>();
    if (depth < 0 or kept < 1)
        throw file_error("saved levels: they are said to be " + std::to_string(depth) + ", of which the last " +
                         std::to_string(kept) + " are kept; save them again");
    auto control = unpack_mesh<point, index>(bytes);
    kith::detail::unpack_state(bytes, scheme);
    detail::require_states_of(control, scheme);
    hierarchy<M, Scheme> levels(
        [&] {
            if constexpr (std::same_as<M, basic_mesh<point, index>>)
                return std::move(control);
            else
                return mesh_traits<M>::build(std::move(control));
        }(),
        std::move(scheme),
        options);
    levels.keep_last(kept);
    for (int level = 1; level <= depth; ++level) {
        detail::refine_as_saved(levels, bytes);
        if (bytes.get<std::uint8_t>() != 0) {
            const auto moved = bytes.get_array<storage<point>>();
            if constexpr (movable_mesh<M>) // points of other meshes were not moved
                levels.move_points(level, {moved.data(), moved.size()});
        }
    }
    if (bytes.get<std::uint64_t>() != detail::checksum_of(detail::points_of(levels.elements(depth))))
        throw file_error("saved levels: the scheme makes other points of them; give it the options that it had");
    if (not bytes.is_at_end())
        throw file_error("saved levels: there is more than they need; give the scheme the state that it had");
    return levels;
} catch (const pack_error& error) {
    throw file_error(std::string("saved levels: ") + error.what());
}

} // namespace kith::io
