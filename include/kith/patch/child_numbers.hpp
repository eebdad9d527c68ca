// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/storage.hpp>
#include <kith/step/scheme.hpp>

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace kith {

/// Where the columns of a step of a whole mesh begin: the new element of a tuple has the number base + index of the tuple.
struct column_bases {
    using by_kind = std::array<std::uint64_t, 7>;
    by_kind vertices{}, edges{}, faces{};

    friend bool operator==(const column_bases&, const column_bases&) = default;

    /// Of the columns that make vertices, edges or faces: v, e or f.
    [[nodiscard]] const by_kind& of(tuple_kind made) const
    {
        return made == tuple_kind::v ? vertices : made == tuple_kind::e ? edges : faces;
    }
};

/// The elements from whose numbers those of tuples follow: v, e or f.
constexpr tuple_kind numbered_elements(tuple_kind kind)
{
    return kind == tuple_kind::v                             ? tuple_kind::v
           : kind == tuple_kind::e or kind == tuple_kind::ve ? tuple_kind::e
                                                             : tuple_kind::f;
}
/// How many tuples there are of each of these elements, where faces have this degree.
constexpr std::size_t tuples_of_each(tuple_kind kind, std::size_t degree)
{
    const bool of_corners = numbered_elements(kind) == tuple_kind::f and kind != tuple_kind::f;
    return tuples_per_element(kind) * (of_corners ? degree : 1);
}

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

/// A column of a step of a whole mesh: of which tuples it is, and where it begins.
struct whole_column {
    tuple_kind kind;
    std::uint64_t base;
};

/// What is known of the number of an element of a part in the whole mesh, and becomes that of one of its `each` children in a column:
/// base + number * each + which.
template <class N>
concept inherited_number = requires(const N& n, const whole_column& column, std::uint64_t i) {
    { n.child(column, i, i) } -> std::same_as<N>;
};

/// The columns that have led to an element, one after the other. Where they begin is another number in each mesh.
class column_path {
    static constexpr int bits = 3;

public:
    static constexpr int most_columns = std::numeric_limits<std::uint32_t>::digits / bits;

    /// Precondition: there are fewer than most_columns.
    [[nodiscard]] column_path then(tuple_kind kind) const
    {
        column_path result;
        result.kinds_ = kinds_ << bits | (std::uint32_t(kind) + 1);
        return result;
    }
    /// The number of the first child of the first child and so on of the ancestor with number 0, in a mesh whose steps have these bases;
    /// `last`: whether it is a vertex, an edge or a face, v, e or f. 0 for no columns at all. Precondition: there is one for each step.
    [[nodiscard]] std::uint64_t base(tuple_kind last, std::span<const column_bases> bases, std::size_t degree) const
    {
        if (kinds_ == 0)
            return 0;
        std::uint64_t number = 0;
        for (std::size_t step = 0; step < bases.size(); ++step) {
            const std::size_t steps_left = bases.size() - step - 1;
            const tuple_kind made = steps_left == 0 ? last : numbered_elements(kind_before(steps_left - 1));
            const tuple_kind kind = kind_before(steps_left);
            number = bases[step].of(made)[std::size_t(kind)] + tuples_of_each(kind, degree) * number;
        }
        return number;
    }

    friend auto operator<=>(const column_path&, const column_path&) = default;

private:
    [[nodiscard]] tuple_kind kind_before(std::size_t columns) const
    {
        return tuple_kind((kinds_ >> bits * columns & ((1U << bits) - 1)) - 1);
    }

    std::uint32_t kinds_ = 0; // the last one lowest
};

/// A number in the whole mesh as a function of that of an element of an earlier level: what the path makes of 0 + offset + factor * its number.
template <std::unsigned_integral Index>
struct affine_number {
    Index offset, factor;
    std::uint32_t source; ///< which element
    column_path path{};

    [[nodiscard]] affine_number child(const whole_column& column, std::uint64_t which, std::uint64_t each) const
    {
        return {Index(which + each * offset), Index(each * factor), source, path.then(column.kind)};
    }
    /// Of what there is `each` times of each element: a corner of a face, a side of an edge. What the path makes of 0 is multiplied, too.
    [[nodiscard]] affine_number of_each(std::uint64_t which, std::uint64_t each) const
    {
        return {Index(which + each * offset), Index(each * factor), source, path};
    }
};

/// A number in the whole mesh, and whether an element of the earlier level that is looked after gave birth to it.
template <std::unsigned_integral Index>
struct owned_number {
    Index number;
    bool owned;

    [[nodiscard]] owned_number child(const whole_column& column, std::uint64_t which, std::uint64_t each) const
    {
        return {Index(column.base + which + each * number), owned};
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
        constexpr tuple_kind of = numbered_elements(Kind);
        const std::size_t each = tuples_of_each(Kind, degree);
        const storage<Number>& parents = of == tuple_kind::v ? vertices : of == tuple_kind::e ? edges : faces;
        std::size_t tuple = 0;
        for (const Number& parent : parents)
            for (std::size_t which = 0; which < each; ++which, ++tuple)
                if (const auto id = ids.template id<Kind>(tuple); id != Ids::none)
                    result[id] = parent.child({Kind, base}, which, each);
    }
};

} // namespace kith
