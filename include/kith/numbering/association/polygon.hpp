// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association.hpp"

#include <concepts>
#include <array>

namespace kith {

namespace detail {
template <std::unsigned_integral Index>
Index index_of_line(const face_line<Index>&);
template <class Association>
typename Association::index index_of_line(const Association&);
} // namespace detail

/// A source of a line of a new face: assoc(v, V), or a vertex with its side.
template <class T>
concept face_line_source = requires(const T& x) { face_line<decltype(detail::index_of_line(x))>(x); };

/// Returns the lines of a new face: its vertices counter-clockwise, each with the side that leaves it (`assoc(v, V) >>
/// side`). The sides may be left out if the scheme declares no edges.
template <face_line_source First, face_line_source... More>
    requires(sizeof...(More) >= 2)
auto polygon(const First& first, const More&... more)
{
    using line = face_line<decltype(detail::index_of_line(first))>;
    return std::array<line, 1 + sizeof...(More)>{line(first), line(more)...};
}

/// Returns the lines of a new face from a range of elements; line_of(element) gives each line and must outlive the
/// result.
template <class Range, class LineOf>
    requires requires(const Range& range, const LineOf& line_of) {
        { line_of(*range.begin()) } -> face_line_source;
    }
auto polygon(const Range& range, const LineOf& line_of)
{
    using line = face_line<decltype(detail::index_of_line(line_of(*range.begin())))>;
    return range.map([&line_of](const auto& x) { return line(line_of(x)); });
}

/// Returns the lines of a new face from a range of associations: polygon(assoc(f, f.vertices(), V)).
template <class Range>
    requires requires(const Range& range) {
        { *range.begin() } -> face_line_source;
    }
auto polygon(const Range& range)
{
    using line = face_line<typename decltype(*range.begin())::index>;
    return range.map([](const auto& association) { return line(association); });
}

/// Reports while compiling what is wrong with any other arguments.
template <class First, class... More>
auto polygon(const First&, const More&...)
{
    constexpr bool few = face_line_source<First> and (face_line_source<More> and ...) and sizeof...(More) < 2;
    static_cast<void>(diagnostics::polygon_of_few<few>());
    static_cast<void>(diagnostics::polygon_of_other_things<not few>());
    return diagnostics::any_lines();
}

} // namespace kith
