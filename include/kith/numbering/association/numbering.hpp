// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_ids.hpp"
#include "vertex_dictionary.hpp"

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>

namespace kith {

/// Returns the columns of a scheme for a step that starts at a level of this generation.
template <class Scheme>
    requires requires(const Scheme& s) { s.columns(); } or requires(const Scheme& s) { s.columns(0); }
constexpr auto columns_of(const Scheme& scheme, [[maybe_unused]] int generation)
{
    if constexpr (requires { scheme.columns(generation); })
        return scheme.columns(generation);
    else
        return scheme.columns();
}

namespace detail {

/// Throws mesh_error if Index cannot number `total` elements with `numbers_of_each` numbers each.
template <std::unsigned_integral Index>
void require_numbers(std::size_t total, std::size_t numbers_of_each, const char* what)
{
    if (total >= std::numeric_limits<Index>::max() / numbers_of_each)
        throw mesh_error("the next level has " + std::to_string(total) + " " + what + ", more than a " +
                         std::to_string(8 * sizeof(Index)) +
                         "-bit index can number; refine fewer times or use basic_mesh<Point, std::uint64_t>");
}

/// Returns the degree, 3 or 4, that all new faces have if the columns fix it at compile time, else 0.
template <class... Columns>
constexpr std::size_t common_degree(const std::tuple<Columns...>*)
{
    [[maybe_unused]] constexpr auto degree = []<tuple_kind K, class W, class D>(const column<K, W, D>*) {
        if constexpr (std::same_as<D, fixed_degree<3>>)
            return std::size_t(3);
        else if constexpr (std::same_as<D, fixed_degree<4>>)
            return std::size_t(4);
        else
            return std::size_t(0);
    };
    constexpr std::array<std::size_t, sizeof...(Columns)> all{degree(static_cast<const Columns*>(nullptr))...};
    std::size_t common = sizeof...(Columns) == 0 ? 0 : *all.begin();
    for (const std::size_t d : all)
        if (d != common)
            return 0;
    return common;
}

} // namespace detail

/// The numbering of a step: the ids of all elements of the next level.
template <class N>
concept level_numbering = requires(const N& ids) {
    requires std::unsigned_integral<typename N::index_type>;
    requires declared_columns<typename N::columns_type>;
    requires element_ids<std::remove_cvref_t<decltype(ids.vertices)>>;
    requires element_ids<std::remove_cvref_t<decltype(ids.edges)>>;
    requires element_ids<std::remove_cvref_t<decltype(ids.faces)>>;
    requires std::same_as<std::remove_cvref_t<decltype(ids.dictionary)>, vertex_dictionary<typename N::index_type>>;
    // True if the columns declare edges; otherwise edges are matched.
    { N::has_edges } -> std::convertible_to<bool>;
    // The number of corners of each new face if it is known at compile time, else 0.
    { N::common_degree } -> std::convertible_to<std::size_t>;
};

/// The ids of all elements of the next level, in closed form from the columns, and the vertices that are in no column.
/// It is all that remains of an association space once the level is made. It gives the element that a tuple made and,
/// by `origin`, the tuple that made an element.
template <declared_columns Columns, std::unsigned_integral Index>
class numbering {
    template <class List>
    struct ids_of;
    template <template <class...> class List, class... C>
    struct ids_of<List<C...>> {
        using type = column_ids<Index, C...>;
    };

public:
    using index_type = Index;
    using columns_type = Columns;
    static constexpr bool has_edges = std::tuple_size_v<decltype(Columns::edges.list)> != 0;
    /// The number of corners of each new face if it is known at compile time, else 0.
    static constexpr std::size_t common_degree = detail::common_degree(
        static_cast<const decltype(Columns::faces.list)*>(nullptr));

    typename ids_of<decltype(Columns::vertices)>::type vertices;
    typename ids_of<decltype(Columns::edges)>::type edges;
    typename ids_of<decltype(Columns::faces)>::type faces;
    vertex_dictionary<Index> dictionary; ///< filled by the step; empty for schemes that use none

    numbering() = default;
    /// Takes the coarse level and the columns. Errors: mesh_error if the next level has more elements than Index can
    /// number; nothing is allocated for it then.
    template <level Level>
    numbering(const Level& coarse, const Columns& columns)
        : vertices(coarse, columns.vertices.list)
        , edges(coarse, columns.edges.list)
        , faces(coarse, columns.faces.list)
        , dictionary()
    {
        detail::require_numbers<Index>(vertices.total(), 1, "vertices");
        detail::require_numbers<Index>(edges.total(), 2, "edges"); // half-edges are numbered, too
        detail::require_numbers<Index>(faces.total(), std::max<std::size_t>(common_degree, 1), "faces"); // and corners
    }
};

} // namespace kith
