// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_elements.hpp"

#include <kith/core/base/for_parts.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

// A file whose loops need not be fast defines KITH_COMPILE_FAST. It then compiles in half the time, since calls in
// loops are not all inlined.
#ifdef KITH_COMPILE_FAST
#define KITH_FLATTEN
#else
#define KITH_FLATTEN gnu::flatten
#endif

namespace kith {

namespace detail {

/// A level whose vertices and edges are visited face by face instead of in the order of their numbers. This is faster
/// on large levels. The children of a face mostly have consecutive numbers, so faces that follow one another are
/// neighbours on the surface. Most of what a mask reads around a vertex is then in the cache from the vertex before. In
/// the order of their numbers, vertices that follow one another may be far apart, and most of each ring comes from main
/// memory. There is no gain for points that are not trivially copyable. Their coordinates lie elsewhere in memory, as
/// those of exact kernels do, or they record what a scheme does on a few faces (`recorded`).
template <class Level>
concept ordered_by_faces = requires(const Level& level, void (*f)(typename Level::vertex_handle),
                                    void (*g)(typename Level::edge_handle, typename Level::corner_handle)) {
    level.for_vertices_of(0, 0, f);
    level.for_edges_of(0, 0, g);
} and std::is_trivially_copyable_v<typename Level::point_type>;

template <walkable_level Level, element Element>
inline constexpr bool met_by_faces = ordered_by_faces<Level> and
                                     (std::same_as<Element, vertex<Level>> or std::same_as<Element, edge<Level>>);

/// The choice to inline masks over a level completely into loops. A mask is a tree of small functions, and one call
/// left in the innermost loop costs more than the arithmetic. It is not made for walks through the traits of other
/// meshes, nor for number classes with memory of their own: the functions would be very large.
template <walkable_level Level>
inline constexpr bool inlines_masks = ordered_by_faces<Level>;

/// Calls f on the elements with the numbers [begin, end).
template <walkable_level Level, element Element, class F>
void for_numbers(const all_elements<Level, Element>& range, std::size_t begin, std::size_t end, const F& f)
{
    for (std::size_t i = begin; i < end; ++i)
        f(range[i]);
}

/// Calls f on the elements with the numbers [begin, end), with all calls in f inlined.
template <walkable_level Level, element Element, class F>
[[KITH_FLATTEN]] void for_numbers_inlined(const all_elements<Level, Element>& range, std::size_t begin, std::size_t end,
                                          const F& f)
{
    for_numbers(range, begin, end, f);
}

/// Calls f on the elements that belong to the faces [begin, end).
template <walkable_level Level, element Element, class F>
void for_faces(const all_elements<Level, Element>& range, std::size_t begin, std::size_t end, const F& f)
{
    const Level& level = range.level();
    if constexpr (std::same_as<Element, vertex<Level>>)
        level.for_vertices_of(begin, end, [&](auto v) { f(vertex<Level>(level, v)); });
    else
        level.for_edges_of(begin, end, [&](auto e, auto left) { f(edge<Level>(level, e, left, left)); });
}

/// Calls f on the elements that belong to the faces [begin, end), with all calls in f inlined. The function itself is
/// not inlined: several loops in one function share its registers, and Loop takes a twentieth longer.
template <walkable_level Level, element Element, class F>
[[gnu::noinline, KITH_FLATTEN]] void for_faces_inlined(const all_elements<Level, Element>& range, std::size_t begin,
                                                       std::size_t end, const F& f)
{
    for_faces(range, begin, end, f);
}

/// Calls f on the elements that belong to the faces [begin, end), as the body of a loop without a promised order.
template <walkable_level Level, element Element, class F>
void for_part_of_faces(const all_elements<Level, Element>& range, std::size_t begin, std::size_t end, const F& f)
{
    const loop_body inside(true);
    if constexpr (inlines_masks<Level>)
        for_faces_inlined(range, begin, end, f);
    else
        for_faces(range, begin, end, f);
}

} // namespace detail

/// Calls f(element) out of line, so that rarely executed code does not take registers from the hot loop.
template <class F, element Element>
[[gnu::noinline]] void out_of_line(const F& f, Element element)
{
    f(element);
}

namespace detail {

/// Calls f(element) out of line, with all calls in f inlined.
template <class F, element Element>
[[gnu::noinline, KITH_FLATTEN]] void rarely_flattened(const F& f, Element element)
{
    f(element);
}

} // namespace detail

/// Calls f(element) out of line. All calls in f are inlined on levels where masks are inlined.
template <class F, template <walkable_level> class Element, walkable_level Level>
void rarely_inlined(const F& f, Element<Level> element)
{
    if constexpr (detail::inlines_masks<Level>)
        detail::rarely_flattened(f, element);
    else
        out_of_line(f, element);
}

/// Calls f on every element of a range, in the order of the numbers on each thread. It suits bodies that touch only
/// their own element and write to memory laid out in the same order.
template <walkable_level Level, element Element, class F>
void for_each_by_number(const all_elements<Level, Element>& range, const F& f)
{
    detail::for_parts(range.size(), Level::parallel, [&](std::size_t begin, std::size_t end) {
        const detail::loop_body inside(true);
        if constexpr (detail::inlines_masks<Level>)
            detail::for_numbers_inlined(range, begin, end, f);
        else
            detail::for_numbers(range, begin, end, f);
    });
}

/// Calls f on every element of a range such as `coarse.faces()`. The order is not promised, so bodies must write only
/// what belongs to their own element, as associations do. Vertices of the dictionary depend on the order: each would be
/// numbered by its turn. Errors: association_error for them.
template <walkable_level Level, element Element, class F>
void for_each(const all_elements<Level, Element>& range, const F& f)
{
    if constexpr (detail::met_by_faces<Level, Element>) {
        const std::size_t faces = range.level().face_count();
        if (not Level::parallel or not detail::is_worth_threads(faces) or detail::most_threads() == 1)
            return detail::for_part_of_faces(range, 0, faces, f);
        // Vertices and edges are not spread evenly over the faces. After a step of Loop none belongs to the middle
        // triangles of the old faces, which are the last quarter.
        constexpr std::size_t faces_of_part = 1024;
        detail::for_shared_parts(faces, faces_of_part, true, [&](detail::parts_to_do parts) {
            parts.for_each(
                [&](std::size_t begin, std::size_t end) { detail::for_part_of_faces(range, begin, end, f); });
        });
    } else {
        for_each_by_number(range, f);
    }
}

} // namespace kith

#undef KITH_FLATTEN
