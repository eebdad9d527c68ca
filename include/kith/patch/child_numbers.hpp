// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/storage.hpp>
#include <kith/step/scheme.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kith {

/// Where the columns of a step of a whole mesh begin: the new element of a tuple has the number base + index of the tuple.
struct column_bases {
    using by_kind = std::array<std::uint64_t, 7>;
    by_kind vertices{}, edges{}, faces{};

    friend bool operator==(const column_bases&, const column_bases&) = default;
};

namespace detail {

template <class List>
column_bases::by_kind bases_of(const List& columns, const counts& coarse, int generation)
{
    const auto numbers = counted_columns<List>::count(columns, coarse, generation);
    column_bases::by_kind result{};
    for (std::size_t i = 0; i < numbers.size; ++i)
        result[std::size_t(numbers.kinds[i])] = numbers.base(i);
    return result;
}

} // namespace detail

/// Precondition: no column leaves out some of its tuples on a mesh with these counts. Cost: O(1).
template <countable_scheme Scheme>
column_bases bases_of_columns(const Scheme& scheme, const counts& coarse, int generation)
{
    const auto columns = columns_of(scheme, generation);
    return {detail::bases_of(columns.vertices, coarse, generation),
            detail::bases_of(columns.edges, coarse, generation),
            detail::bases_of(columns.faces, coarse, generation)};
}

/// What is known of the number of an element of a part in the whole mesh, and becomes that of its children: number * each + base.
template <class N>
concept inherited_number = requires(const N& n, std::uint64_t i) {
    { n.child(i, i) } -> std::same_as<N>;
};

/// A number in the whole mesh as a function of that of an element of an earlier level: offset + factor * its number.
template <std::unsigned_integral Index>
struct affine_number {
    Index offset, factor;
    std::uint32_t source; ///< which element

    [[nodiscard]] affine_number child(std::uint64_t base, std::uint64_t each) const
    {
        return {Index(base + each * offset), Index(each * factor), source};
    }
};

/// A number in the whole mesh, and whether an element of the earlier level that is looked after gave birth to it.
template <std::unsigned_integral Index>
struct owned_number {
    Index number;
    bool owned;

    [[nodiscard]] owned_number child(std::uint64_t base, std::uint64_t each) const
    {
        return {Index(base + each * number), owned};
    }
};

/// The numbers of all elements of a part of a level whose faces have one degree.
template <inherited_number Number>
struct part_of_whole {
    storage<Number> vertices, edges, faces;
    std::size_t degree = 0;

    /// Those of a part of the part: of the elements listed.
    template <std::unsigned_integral Index>
    [[nodiscard]] part_of_whole of_part(std::span<const Index> some_vertices, std::span<const Index> some_edges,
                                        std::span<const Index> some_faces) const
    {
        const auto some = [](const storage<Number>& all, std::span<const Index> which) {
            storage<Number> result(which.size());
            for (std::size_t i = 0; i < which.size(); ++i)
                result[i] = all[which[i]];
            return result;
        };
        return {some(vertices, some_vertices), some(edges, some_edges), some(faces, some_faces), degree};
    }
    /// Those of the next level of the part, which a step has made with these ids; without edges where nobody asks for them.
    /// Cost: O(elements).
    template <level_numbering Numbering>
    [[nodiscard]] part_of_whole next(const Numbering& ids, const column_bases& bases, bool with_edges = true) const
    {
        return {children(ids.vertices, bases.vertices),
                with_edges ? children(ids.edges, bases.edges) : storage<Number>(),
                children(ids.faces, bases.faces),
                Numbering::common_degree};
    }

private:
    template <element_ids Ids>
    [[nodiscard]] storage<Number> children(const Ids& ids, const column_bases::by_kind& bases) const
    {
        storage<Number> result(ids.total());
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (add_column<Ids::kinds[I]>(ids, bases[std::size_t(Ids::kinds[I])], result), ...);
        }(std::make_index_sequence<Ids::size>());
        return result;
    }
    template <tuple_kind Kind, element_ids Ids>
    void add_column(const Ids& ids, std::uint64_t base, storage<Number>& result) const
    {
        constexpr bool of_corners = Kind != tuple_kind::v and Kind != tuple_kind::e and Kind != tuple_kind::ve and
                                    Kind != tuple_kind::f;
        const std::size_t each = tuples_per_element(Kind) * (of_corners ? degree : 1);
        const storage<Number>& parents = Kind == tuple_kind::v                             ? vertices
                                         : Kind == tuple_kind::e or Kind == tuple_kind::ve ? edges
                                                                                           : faces;
        std::size_t tuple = 0;
        for (const Number& parent : parents)
            for (std::size_t rest = 0; rest < each; ++rest, ++tuple)
                if (const auto id = ids.template id<Kind>(tuple); id != Ids::none)
                    result[id] = parent.child(base + rest, each);
    }
};

} // namespace kith
