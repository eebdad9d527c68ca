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

/// Errors: mesh_error where 64 bits are too few.
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

/// Picks inner tuples or tuples at the boundary, which has to be known for this.
template <class Where>
inline constexpr bool picks_at_boundary = requires { Where::inner; };
/// Columns without one have all of their tuples or none, on any mesh.
template <class Where>
inline constexpr bool has_condition = not std::same_as<Where, everywhere> and not std::same_as<Where, all_or_none>;
/// Whether nothing but the boundary, of which closed meshes have none, decides which tuples are picked.
template <class Where>
constexpr bool picks_without_condition(bool closed)
{
    return picks_at_boundary<Where> ? closed : not has_condition<Where>;
}

} // namespace detail

/// Numbers that follow one another, from `begin` to before `end`.
struct number_range {
    std::size_t begin = 0, end = 0;

    friend constexpr bool operator==(const number_range&, const number_range&) = default;
};

/// The tuples of a column that its condition picks; Picked() are all.
template <class P>
concept picked_tuples = std::default_initializable<P> and requires(const P& picked) {
    // The first tuple, where they follow one another.
    { picked.first() } -> std::convertible_to<std::uint64_t>;
    // How many they are.
    { picked.count() } -> std::convertible_to<std::uint64_t>;
};

/// How the new elements of one kind are numbered, and the corners of new faces: column after column, in each column the
/// tuples that give birth in their order. All numbers of new elements come from here, whoever knows how many elements
/// the coarse level has and which tuples the conditions of columns pick; of the latter speaks, for each column, a
/// `Picked`, with more than the concept says:
///
///   is_run()             they follow one another
///   has(index, each)     a tuple is picked, `each` tuples per element; not asked of a run
///   rank(tuple, each)    how many before a tuple are picked
///   tuple(rank, each)    the inverse
///   corners(all), corners_before(tuple)    of faces that have as many corners as their face, or their vertex faces: in
///                        sum, out of all corners of the coarse level, and before that of a tuple
///
/// A Picked needs only those of these functions that are called for its columns.
template <std::unsigned_integral Index, picked_tuples Picked, class... Columns>
class column_numbers {
public:
    static constexpr std::size_t size = sizeof...(Columns);
    static constexpr std::array<tuple_kind, size> kinds{Columns::kind...};

    template <tuple_kind Kind>
    static constexpr bool has = ((Columns::kind == Kind) or ...);
    /// Every tuple of this kind gives birth, on any mesh.
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
    /// `pick(i, column, tuples)` tells the Picked of a column that has a condition.
    /// Errors: mesh_error for more elements than 64 bits can number. Cost: that of `pick`.
    template <class Pick>
    column_numbers(const element_counts& coarse, const std::tuple<Columns...>& list, const Pick& pick)
    {
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (append(I, coarse, std::get<I>(list), pick), ...);
        }(std::make_index_sequence<size>());
    }

    /// The number of new elements, of those in column i, and of those before it.
    [[nodiscard]] std::uint64_t total() const { return base_[size]; }
    [[nodiscard]] std::uint64_t count(std::size_t i) const { return base_[i + 1] - base_[i]; }
    [[nodiscard]] std::uint64_t base(std::size_t i) const { return base_[i]; }
    /// The corners of all new faces.
    [[nodiscard]] std::uint64_t total_corners() const { return first_corner_[size]; }
    [[nodiscard]] const Picked& picked(std::size_t i) const { return picked_[i]; }
    [[nodiscard]] Picked& picked(std::size_t i) { return picked_[i]; }

    /// The number in column i of a tuple that is picked there.
    [[nodiscard]] Index number(std::size_t i, const auto& tuple, std::size_t each) const
    {
        if (picked_[i].is_run())
            return Index(start_[i] + index_of(tuple));
        return Index(base_[i] + picked_[i].rank(tuple, each));
    }
    /// The same where all tuples are.
    template <tuple_kind Kind>
        requires is_full<Kind>
    [[nodiscard]] Index number(std::size_t index) const
    {
        return Index(start_[position<Kind>()] + index);
    }
    /// Whether the tuple with this index is picked in column i.
    [[nodiscard]] bool has_number(std::size_t i, std::size_t index, std::size_t each) const
    {
        return picked_[i].is_run() ? start_[i] + index - base_[i] < count(i) : picked_[i].has(index, each);
    }
    /// The numbers in column i of tuples that follow one another, of all those of their parents; where some are not
    /// picked there are fewer.
    [[nodiscard]] number_range numbers(std::size_t i, const number_range& tuples) const
    {
        const auto before = [&](std::uint64_t tuple) {
            if (not picked_[i].is_run())
                return base_[i] + picked_[i].rank(tuple, tuples_per_element(kinds[i]));
            const std::uint64_t first = base_[i] - start_[i];
            return start_[i] + std::clamp(tuple, first, first + count(i));
        };
        return {before(tuples.begin), before(tuples.end)};
    }
    /// The inverse: the tuple that gave birth to an element. Precondition: id < total().
    [[nodiscard]] std::pair<tuple_kind, std::uint64_t> origin(std::uint64_t id) const
    {
        const std::size_t i = column_of(id);
        return {kinds[i],
                picked_[i].is_run() ? id - start_[i] : picked_[i].tuple(id - base_[i], tuples_per_element(kinds[i]))};
    }
    /// How many corners a new face has if its column says it while compiling, else 0. Precondition: id < total().
    [[nodiscard]] std::size_t degree(std::uint64_t id) const { return degrees[column_of(id)]; }
    /// The column of a new element. Precondition: id < total().
    [[nodiscard]] std::size_t column_of(std::uint64_t id) const
    {
        std::size_t i = 0;
        while (id >= base_[i + 1])
            ++i;
        return i;
    }
    /// The column of a new face by one of its corners. Precondition: corner < total_corners().
    [[nodiscard]] std::size_t column_of_corner(std::uint64_t corner) const
    {
        std::size_t i = 0;
        while (corner >= first_corner_[i + 1])
            ++i;
        return i;
    }
    /// How many corners the faces of column i have if it says it while compiling, else 0; and the first corner of all.
    [[nodiscard]] static constexpr std::size_t degree_in(std::size_t i) { return degrees[i]; }
    [[nodiscard]] std::uint64_t first_corner_in(std::size_t i) const { return first_corner_[i]; }
    /// The first corner of a face of column i, and the face that has a corner. Preconditions: degree_in(i) != 0, and
    /// the face is one of the column.
    [[nodiscard]] std::uint64_t first_corner_of(std::size_t i, std::uint64_t face) const
    {
        return first_corner_[i] + degrees[i] * (face - base_[i]);
    }
    [[nodiscard]] std::uint64_t face_of_corner(std::size_t i, std::uint64_t corner) const
    {
        return base_[i] + (corner - first_corner_[i]) / degrees[i];
    }
    /// The first corner of the face that a tuple in column i gives birth to.
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
    // Of a column that is a run of tuples: what the index of a tuple and its number differ by.
    std::array<std::uint64_t, size> start_{};
    std::array<Picked, size> picked_;
};

} // namespace kith
