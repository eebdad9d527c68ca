// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "affine_columns.hpp"
#include "scheme_forecast.hpp"

#include <kith/numbering/step/children.hpp>

#include <algorithm>
#include <concepts>
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

/// A scheme whose new faces come from faces and have one degree, and whose numbers follow in the same way from the
/// first level on. Then the owner of a face owns its descendants.
template <class Scheme, class Index>
concept faces_descend_from_faces = has_affine_numbers<Scheme> and not has_numbers_by_marks<Scheme> and
                                   not has_faces_by_valence<Scheme> and not detail::may_ask_state<Scheme>() and
                                   numbering_of<Scheme, Index>::common_degree != 0 and
                                   detail::come_from_faces(
                                       static_cast<const decltype(columns_type<Scheme>::faces.list)*>(nullptr));

/// A way of descent: elements of a later level that come by the same columns from those of an earlier one. The
/// descendants of element x are `each` in number, from first + each * x on.
struct descent {
    tuple_kind from;           ///< elements of the earlier level: v, e, f or vf
    tuple_kind last;           ///< the tuples that made the elements of the later level
    std::uint64_t first, each; ///< see above
};

/// Returns the descents of all vertices, edges, faces or corners (v, e, f, vf) that some steps make, in the order of
/// their numbers. There is at least one step. All faces before and after each step have this degree; if they have
/// several (0), elements may descend from corners (vf). Cost: O(result).
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
        const bool of_corners = made == tuple_kind::vf and last.has_corners_of_face(kind);
        const tuple_kind parent = of_corners ? tuple_kind::vf : numbered_elements(kind, degree);
        if (steps.size() == 1)
            result.push_back({parent, kind, base, each});
        else
            for (const descent& before : descents_of(parent, steps.first(steps.size() - 1), degree))
                result.push_back({before.from, kind, base + each * before.first, each * before.each});
    }
    return result;
}

/// The corners of the faces of one descent. Face number f has the corners from offset + degree * f on. If all steps
/// keep the degrees of faces, its corners begin at offset + c. Here c is the first corner of the face before the steps.
struct descent_of_corners {
    std::uint64_t offset, degree; ///< offset modulo 2^64; degree 0: that of the face before the steps
};

/// Returns the corners of the faces of a descent. Cost: O(steps).
inline descent_of_corners corners_of(const descent& way, std::span<const column_bases> steps)
{
    std::uint64_t kept = 0, face = way.first;
    for (std::size_t step = steps.size(); step > 0; --step) {
        const column_bases& columns = steps[step - 1];
        std::size_t kind = columns.faces.size();
        for (std::size_t k = 0; k < columns.faces.size(); ++k)
            if (columns.face_counts[k] != 0 and columns.faces[k] <= face and
                (kind == columns.faces.size() or columns.faces[k] > columns.faces[kind]))
                kind = k;
        face -= columns.faces[kind];
        kept += columns.corners[kind];
        if (const std::uint64_t degree = columns.degrees[kind]; degree != 0)
            return {kept + degree * (face - way.first), degree};
    }
    return {kept, 0};
}

} // namespace kith
