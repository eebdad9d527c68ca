// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The faults of a scheme that an association space finds while the scheme runs. The functions are not inlined, because
/// `for_each` inlines everything into its loops that is not excluded.
namespace kith::faults {

struct named_column {
    std::string_view letters;
    const char* name;
};
inline constexpr std::array<named_column, 7> columns_by_letters{{{"v", "per_vertex"},
                                                                 {"e", "per_edge"},
                                                                 {"f", "per_face"},
                                                                 {"fv", "per_corner"},
                                                                 {"ev", "per_end"},
                                                                 {"ef", "per_side"},
                                                                 {"efv", "per_corner_side"}}};

[[noreturn, gnu::noinline]] inline void refuse(const tuple_elements& tuple, const std::string& why)
{
    throw association_error("assoc" + to_string(tuple) + why);
}
template <level Level>
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
template <level Level>
[[noreturn, gnu::noinline]] void wrong_degree(const Level& level, tuple_kind kind, std::size_t tuple, std::size_t has,
                                              std::size_t declared)
{
    refuse(list_tuple(level, kind, tuple),
           " -> F has " + std::to_string(has) + " vertices, but its column declares " + std::to_string(declared));
}
template <level Level>
[[gnu::noinline]] void require_degree(const Level& level, tuple_kind kind, std::size_t tuple, std::size_t has,
                                      std::size_t declared)
{
    if (has != declared)
        wrong_degree(level, kind, tuple, has, declared);
    if (has < 3)
        refuse(list_tuple(level, kind, tuple),
               " -> F has " + std::to_string(has) + " vertices; a face has three or more");
}
/// Returns advice to declare the column of such a tuple, which no column declares. It is empty for elements of one
/// kind, for which there is no column.
inline std::string column_for(const tuple_elements& tuple)
{
    std::string letters;
    for (const auto& [letter, index] : tuple)
        letters += letter;
    const auto found = std::ranges::find(columns_by_letters, letters, &named_column::letters);
    return found == columns_by_letters.end() ? ""
                                             : std::string("declare ") + found->name + " among the new vertices, or ";
}
/// Throws association_error for a vertex that no column declares and that is read before it is set.
[[noreturn, gnu::noinline]] inline void read_early(const tuple_elements& tuple)
{
    const std::string column = column_for(tuple);
    refuse(tuple, " -> V is read before it is set" + (column.empty() ? "" : "; " + column + "set it first"));
}
/// Throws association_error for a vertex under a tuple that no column declares, in a scheme that declares edges.
[[noreturn, gnu::noinline]] inline void undeclared(const tuple_elements& tuple)
{
    refuse(tuple,
           " -> V: a scheme that declares edges cannot make vertices under tuples that no column declares; " +
               column_for(tuple) + "leave edges to be matched");
}
/// Throws association_error for a vertex that no column declares, made in a loop that may run on threads. Its number
/// would follow from the order of the threads.
[[noreturn, gnu::noinline]] inline void without_order(const tuple_elements& tuple)
{
    const auto [letter, index] = tuple.front();
    const std::string of = letter == 'v' ? "vertices" : letter == 'e' ? "edges" : "faces";
    refuse(tuple,
           " -> V is in no column and is written inside for_each or in_blocks, whose order is undefined; " +
               column_for(tuple) + "write it in a plain loop: for (auto " + letter + " : coarse." + of + "())");
}

inline constexpr const char* absent_vertex = " -> V: the columns of the scheme leave this tuple out";
inline constexpr const char* absent_edge = " -> E: the columns of the scheme leave this tuple out";
inline constexpr const char* absent_face = " -> F: the columns of the scheme leave this tuple out";
inline constexpr const char* vertex_read_early = " -> V is read before it is set";
inline constexpr const char* vertex_set_twice = " -> V is set twice";
inline constexpr const char* face_set_twice = " -> F is set twice";

/// Throws association_error unless the vertex of a line of a face exists; the new level has `vertices` vertices.
template <level Level>
[[gnu::noinline]] void require_vertex(const Level& level, tuple_kind kind, std::size_t tuple, std::size_t vertex,
                                      std::size_t vertices)
{
    if (vertex >= vertices)
        refuse(list_tuple(level, kind, tuple),
               " -> F: new vertex " + std::to_string(vertex) + " does not exist, there are " +
                   std::to_string(vertices) + "; vertices of a pass are not part of a level; use one of the new level");
}
/// Throws association_error unless a line of a face has a side of a new edge that no other face has.
template <level Level, std::unsigned_integral Index>
[[gnu::noinline]] void require_free_side(const Level& level, tuple_kind kind, std::size_t tuple, Index halfedge,
                                         const connectivity<Index>& fine)
{
    if (halfedge == connectivity<Index>::none)
        refuse(level,
               kind,
               tuple,
               " -> F: the scheme declares edges, so each line needs its side: "
               "assoc(v, V) >> assoc(v, e, E).along(e)");
    if (halfedge >= fine.halfedge_corner.size())
        refuse(list_tuple(level, kind, tuple),
               " -> F: new edge " + std::to_string(halfedge / 2) + " does not exist, there are " +
                   std::to_string(fine.edges()) +
                   "; edges of a pass are not part of a level; use one of the new level");
    if (fine.halfedge_corner[halfedge] != connectivity<Index>::none)
        refuse(list_tuple(level, kind, tuple),
               " -> F: side " + std::to_string(halfedge % 2) + " of new edge " + std::to_string(halfedge / 2) +
                   " has a face already");
}

} // namespace kith::faults

namespace kith {

/// A record of the elements of the next level that a scheme has made, and of the starts of fans that it has set.
/// Vertices and faces may be queried and made on several threads. Only spaces that check their scheme keep this record.
template <std::unsigned_integral Index>
class made_elements {
public:
    made_elements() = default;
    /// Begins with none of these vertices and faces made; `none` stands for a fan whose start is not set.
    made_elements(std::size_t vertices, std::size_t faces, Index none)
        : vertices_(vertices), faces_(faces), starts_(vertices, none)
    {
    }

    [[nodiscard]] bool has_vertex(std::size_t id)
    {
        return std::atomic_ref(vertices_[id]).load(std::memory_order_relaxed) != 0;
    }
    /// Marks a vertex as made and returns true if it was made before; make_face does so for a face.
    bool make_vertex(std::size_t id) { return make(vertices_[id]); }
    bool make_face(std::size_t id) { return make(faces_[id]); }
    void start_fan(std::size_t vertex, Index halfedge) { starts_[vertex] = halfedge; }
    void forget_vertices() { vertices_.assign(vertices_.size(), 0); }

    /// Returns a mark per vertex, which is not 0 if the vertex has been made; faces() returns a mark per face.
    [[nodiscard]] const std::vector<unsigned char>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<unsigned char>& faces() const { return faces_; }
    /// Returns the side at which the fan of each vertex starts, or `none` if the scheme has not set it.
    [[nodiscard]] const std::vector<Index>& starts() const { return starts_; }

private:
    static bool make(unsigned char& mark) { return std::atomic_ref(mark).exchange(1, std::memory_order_relaxed) != 0; }

    std::vector<unsigned char> vertices_, faces_;
    std::vector<Index> starts_;
};

} // namespace kith
