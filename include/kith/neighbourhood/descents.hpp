// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "affine_columns.hpp"
#include "coming_scheme.hpp"

#include <kith/step/children.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace kith {

namespace detail {

/// Returns true if all new faces come from faces or corners of faces.
template <class... Columns>
constexpr bool come_from_faces(const std::tuple<Columns...>*)
{
    return ((parent_kind(Columns::kind) == element_kind::face) and ...);
}

} // namespace detail

/// A scheme whose new faces come from faces, of one degree, and whose numbers follow in one way from the first level
/// on. Then who owns a face owns its descendants.
template <class Scheme, class Index>
concept faces_descend_from_faces = has_affine_numbers<Scheme> and not has_numbers_by_marks<Scheme> and
                                   not has_faces_by_valence<Scheme> and not detail::may_ask_state<Scheme>() and
                                   numbering_of<Scheme, Index>::common_degree != 0 and
                                   detail::come_from_faces(
                                       static_cast<const decltype(columns_type<Scheme>::faces.list)*>(nullptr));

/// A way of descent: elements of a later level that come by the same columns from those of an earlier one. The
/// descendants of element x are `each` in number, from first + each * x on.
struct descent {
    tuple_kind from;           ///< elements of the earlier level: v, e or f
    tuple_kind last;           ///< tuples that gave birth to the elements of the later level
    std::uint64_t first, each; ///< see above
};

/// Returns the descents of all vertices, edges or faces (v, e, f) that some steps make, in the order of their numbers.
/// `steps` are at least one, and all faces before and after each of them have this degree. Cost: O(result).
inline std::vector<descent> descents_of(tuple_kind made, std::span<const column_bases> steps, std::size_t degree)
{
    const column_bases& last = steps.back();
    std::vector<std::size_t> columns;
    for (std::size_t kind = 0; kind < last.faces.size(); ++kind)
        if (last.count(made, tuple_kind(kind)) != 0)
            columns.push_back(kind);
    std::ranges::sort(columns, {}, [&](std::size_t kind) { return last.base(made, tuple_kind(kind)); });
    std::vector<descent> result;
    for (const std::size_t column : columns) {
        const auto kind = tuple_kind(column);
        const std::uint64_t base = last.base(made, kind), each = last.of_each(made, kind);
        const tuple_kind parent = numbered_elements(kind, degree);
        if (steps.size() == 1)
            result.push_back({parent, kind, base, each});
        else
            for (const descent& before : descents_of(parent, steps.first(steps.size() - 1), degree))
                result.push_back({before.from, kind, base + each * before.first, each * before.each});
    }
    return result;
}

} // namespace kith
