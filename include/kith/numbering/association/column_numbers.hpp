// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "columns.hpp"

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

/// Returns a + b. Errors: mesh_error if 64 bits are too few.
constexpr std::uint64_t checked_sum(std::uint64_t a, std::uint64_t b)
{
    if (a + b < a)
        throw mesh_error("the whole mesh has more elements than 64 bits can number; refine fewer times");
    return a + b;
}
constexpr std::uint64_t checked_product(std::uint64_t a, std::uint64_t b)
{
    return b != 0 and a > ~std::uint64_t(0) / b ? checked_sum(~std::uint64_t(0), 1) : a * b;
}

template <class Degree>
inline constexpr bool has_degree = not std::same_as<Degree, int>;
template <class Degree>
inline constexpr std::size_t fixed_degree_of = 0;
template <std::size_t N>
inline constexpr std::size_t fixed_degree_of<fixed_degree<N>> = N;

/// True if a condition picks inner tuples or tuples at the boundary; the boundary has to be known for this.
template <class Where>
inline constexpr bool picks_at_boundary = requires { Where::inner; };
/// True if a column has a condition. Without a condition it has all of its tuples or none, on any mesh.
template <class Where>
inline constexpr bool has_condition = not std::same_as<Where, everywhere> and not std::same_as<Where, all_or_none>;
/// Returns true if at most the boundary decides which tuples are picked; closed meshes have no boundary.
template <class Where>
constexpr bool picks_without_condition(bool closed)
{
    return picks_at_boundary<Where> ? closed : not has_condition<Where>;
}

} // namespace detail

/// A range of consecutive numbers, from `begin` to before `end`.
struct number_range {
    std::size_t begin = 0, end = 0;

    friend constexpr bool operator==(const number_range&, const number_range&) = default;
};

/// The tuples of a column that its condition picks; Picked() stands for all tuples.
template <class P>
concept picked_tuples = std::default_initializable<P> and requires(const P& picked) {
    // The first tuple, if the tuples are consecutive.
    { picked.first() } -> std::convertible_to<std::uint64_t>;
    // The number of tuples.
    { picked.count() } -> std::convertible_to<std::uint64_t>;
};

/// The numbers of the new elements of one kind, and of the corners of new faces. They count column after column, and in
/// each column the tuples that make an element in their order. All numbers of new elements come from this class. It
/// needs the number of elements of the coarse level, and the tuples that the conditions of columns pick. A `Picked`
/// describes these tuples for each column, by more functions than the concept requires:
///
///   is_run()             true if the tuples are consecutive
///   has(index, each)     true if a tuple is picked, with `each` tuples per element; not called for a run
///   rank(tuple, each)    the number of picked tuples before a tuple
///   tuple(rank, each)    the inverse of rank
///   corners(all)         the number of corners of new faces that have as many as their face, or as their vertex has
///                        faces; `all` is the number of corners of the coarse level
///   corners_before(tuple)    the number of corners of such faces before that of a tuple
///
/// A Picked needs only the functions that are called for its columns.
template <std::unsigned_integral Index, picked_tuples Picked, class... Columns>
class column_numbers {
public:
    static constexpr std::size_t size = sizeof...(Columns);
    static constexpr std::array<tuple_kind, size> kinds{Columns::kind...};

    template <tuple_kind Kind>
    static constexpr bool has = ((Columns::kind == Kind) or ...);
    /// True if every tuple of this kind makes an element, on any mesh.
    template <tuple_kind Kind>
    static constexpr bool is_full = ((Columns::kind == Kind and std::same_as<decltype(Columns::where), everywhere>) or
                                     ...);
    template <tuple_kind Kind>
    static constexpr std::size_t position()
    {
        static_assert(has<Kind>, "the scheme's columns() declare no new element of this kind for this kind of tuple");
        return position(Kind);
    }
    static constexpr std::size_t position(tuple_kind kind)
    {
        return std::size_t(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
    }

    column_numbers() = default;
    /// Takes the counts of the coarse level and the columns. `pick(i, column, tuples)` returns the Picked of a column
    /// that has a condition. Errors: mesh_error for more elements than 64 bits can number. Cost: that of `pick`.
    template <class Pick>
    column_numbers(const element_counts& coarse, const std::tuple<Columns...>& list, const Pick& pick)
    {
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (append(I, coarse, std::get<I>(list), pick), ...);
        }(std::make_index_sequence<size>());
    }

    /// Returns the number of new elements; count(i) those of column i, base(i) those before it.
    [[nodiscard]] std::uint64_t total() const { return base_[size]; }
    [[nodiscard]] std::uint64_t count(std::size_t i) const { return base_[i + 1] - base_[i]; }
    [[nodiscard]] std::uint64_t base(std::size_t i) const { return base_[i]; }
    /// Returns the number of corners of all new faces.
    [[nodiscard]] std::uint64_t total_corners() const { return first_corner_[size]; }
    [[nodiscard]] const Picked& picked(std::size_t i) const { return picked_[i]; }
    [[nodiscard]] Picked& picked(std::size_t i) { return picked_[i]; }

    /// Returns the number of the element that a picked tuple of column i makes.
    [[nodiscard]] Index number(std::size_t i, const auto& tuple, std::size_t each) const
    {
        if (picked_[i].is_run())
            return Index(start_[i] + index_of(tuple));
        return Index(base_[i] + picked_[i].rank(tuple, each));
    }
    /// Returns the number of the element that a tuple makes, for a kind of which all tuples make an element.
    template <tuple_kind Kind>
        requires is_full<Kind>
    [[nodiscard]] Index number(std::size_t index) const
    {
        return Index(start_[position<Kind>()] + index);
    }
    /// Returns true if the tuple with this index is picked in column i.
    [[nodiscard]] bool has_number(std::size_t i, std::size_t index, std::size_t each) const
    {
        return picked_[i].is_run() ? start_[i] + index - base_[i] < count(i) : picked_[i].has(index, each);
    }
    /// Returns the numbers in column i of consecutive tuples, which are all tuples of their parents. If some tuples are
    /// not picked, there are fewer numbers than tuples.
    [[nodiscard]] number_range numbers(std::size_t i, const number_range& tuples) const
    {
        const auto before = [&](std::uint64_t tuple) {
            if (not picked_[i].is_run())
                return base_[i] + picked_[i].rank(tuple, tuples_per_element(kinds[i]));
            const std::uint64_t first = base_[i] - start_[i];
            return start_[i] + std::clamp(tuple, first, first + count(i));
        };
        return {std::size_t(before(tuples.begin)), std::size_t(before(tuples.end))};
    }
    /// Returns the tuple that made an element. Precondition: id < total().
    [[nodiscard]] std::pair<tuple_kind, std::uint64_t> origin(std::uint64_t id) const
    {
        const std::size_t i = column_of(id);
        return {kinds[i],
                picked_[i].is_run() ? id - start_[i] : picked_[i].tuple(id - base_[i], tuples_per_element(kinds[i]))};
    }
    /// Returns the number of corners of a new face if its column fixes it at compile time, else 0. Precondition: id <
    /// total().
    [[nodiscard]] std::size_t degree(std::uint64_t id) const { return degrees[column_of(id)]; }
    /// Returns the column of a new element. Precondition: id < total().
    [[nodiscard]] std::size_t column_of(std::uint64_t id) const
    {
        std::size_t i = 0;
        while (id >= base_[i + 1])
            ++i;
        return i;
    }
    /// Returns the column of the new face that has a corner. Precondition: corner < total_corners().
    [[nodiscard]] std::size_t column_of_corner(std::uint64_t corner) const
    {
        std::size_t i = 0;
        while (corner >= first_corner_[i + 1])
            ++i;
        return i;
    }
    /// Returns the number of corners of each face of column i if fixed at compile time, else 0. first_corner_in returns
    /// the first corner of all these faces.
    [[nodiscard]] static constexpr std::size_t degree_in(std::size_t i) { return degrees[i]; }
    [[nodiscard]] std::uint64_t first_corner_in(std::size_t i) const { return first_corner_[i]; }
    /// Returns the first corner of a face of column i; face_of_corner returns the face that has a corner.
    /// Preconditions: degree_in(i) != 0, and the face is one of the column.
    [[nodiscard]] std::uint64_t first_corner_of(std::size_t i, std::uint64_t face) const
    {
        return first_corner_[i] + degrees[i] * (face - base_[i]);
    }
    [[nodiscard]] std::uint64_t face_of_corner(std::size_t i, std::uint64_t corner) const
    {
        return base_[i] + (corner - first_corner_[i]) / degrees[i];
    }
    /// Returns the first corner of the face that a tuple in column i makes.
    [[nodiscard]] std::uint64_t first_corner(std::size_t i, const auto& tuple) const
    {
        if (degrees[i] == 0)
            return first_corner_[i] + picked_[i].corners_before(tuple);
        return first_corner_of(i, number(i, tuple, tuples_per_element(kinds[i])));
    }

private:
    static constexpr std::array<std::size_t, size> degrees{detail::fixed_degree_of<decltype(Columns::degree)>...};

    static std::uint64_t index_of(std::uint64_t index) { return index; }
    static std::uint64_t index_of(const auto& tuple)
        requires requires { tuple.id; }
    {
        return tuple.id;
    }

    template <tuple_kind Kind, class Where, class Degree, class Pick>
    void append(std::size_t i, const element_counts& coarse, const column<Kind, Where, Degree>& c, const Pick& pick)
    {
        std::uint64_t count = tuple_count(coarse, Kind);
        start_[i] = base_[i];
        if constexpr (detail::has_condition<Where>) {
            picked_[i] = pick(i, c, count);
            count = picked_[i].count();
            start_[i] -= picked_[i].first();
        } else if constexpr (std::same_as<Where, all_or_none>) {
            count = c.where.all ? count : 0;
        }
        base_[i + 1] = detail::checked_sum(base_[i], count);
        if constexpr (detail::fixed_degree_of<Degree> != 0)
            first_corner_[i + 1] = detail::checked_sum(first_corner_[i],
                                                       detail::checked_product(detail::fixed_degree_of<Degree>, count));
        else if constexpr (detail::has_degree<Degree> and requires { picked_[i].corners(count); })
            first_corner_[i + 1] = detail::checked_sum(first_corner_[i],
                                                       count == 0 ? 0 : picked_[i].corners(coarse.corners));
    }

    std::array<std::uint64_t, size + 1> base_{}, first_corner_{};
    // The difference between the number of an element and the index of its tuple, for columns that are runs of tuples.
    std::array<std::uint64_t, size> start_{};
    std::array<Picked, size> picked_;
};

} // namespace kith
