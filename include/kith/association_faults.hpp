// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association.hpp"
#include "error.hpp"

#include <cstddef>
#include <string>

/// The faults of a scheme that an association space finds while the scheme runs. They stay out of the loops: `for_each`
/// has everything inlined into its loops that is not told otherwise.
namespace kith::faults {

[[noreturn, gnu::noinline]] inline void refuse(const tuple_elements& tuple, const std::string& why)
{
    throw association_error("assoc" + to_string(tuple) + why);
}
template <class Level>
[[noreturn, gnu::noinline]] void refuse(const Level& level, tuple_kind kind, std::size_t tuple, const char* why)
{
    refuse(list_tuple(level, kind, tuple), why);
}
template <element... X>
[[noreturn, gnu::noinline]] void not_incident(const char* target,
                                              X... x) // by value: references would keep the elements out of registers
{
    refuse(list_tuple(x...), std::string(" -> ") + target + ": the elements do not touch");
}
template <class Level>
[[noreturn, gnu::noinline]] void wrong_degree(const Level& level, tuple_kind kind, std::size_t tuple, std::size_t has,
                                              std::size_t declared)
{
    refuse(list_tuple(level, kind, tuple),
           " -> F has " + std::to_string(has) + " vertices, its column says " + std::to_string(declared));
}
template <class Level>
[[noreturn, gnu::noinline]] void taken_side(const Level& level, tuple_kind kind, std::size_t tuple,
                                            std::size_t halfedge)
{
    refuse(list_tuple(level, kind, tuple),
           " -> F: side " + std::to_string(halfedge % 2) + " of new edge " + std::to_string(halfedge / 2) +
               " has a face already");
}

inline constexpr const char* absent_vertex = " -> V: the columns of the scheme leave this tuple out";
inline constexpr const char* absent_edge = " -> E: the columns of the scheme leave this tuple out";
inline constexpr const char* absent_face = " -> F: the columns of the scheme leave this tuple out";
inline constexpr const char* vertex_read_early = " -> V is read before it is set";
inline constexpr const char* vertex_set_twice = " -> V is set twice";
inline constexpr const char* face_set_twice = " -> F is set twice";
inline constexpr const char* no_side = " -> F: the scheme declares edges, so each line needs its side: v >> side";

} // namespace kith::faults
