// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sharp_rules.hpp"

#include <kith/hierarchy.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace kith {

/// The limit at corners, and along boundaries and creases: 1/6, 2/3, 1/6, where a cubic B-spline curve ends up.
template <class Level, class Use>
void limit_on_curve(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
{
    using kinds = typename sharp_rules<Level>::limit_kind;
    const auto [kind, ends] = sharp.limit_of(v);
    if (kind == kinds::corner)
        use(sum(v));
    else if (kind == kinds::curve)
        use((ends[0] + 4. * v + ends[1]) / 6);
}

/// A corner with one face lies in the plane of its two edges; at other corners and along creases each side has a plane of
/// its own, and none is given.
template <class Level, class Use>
void limit_at_corner(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
{
    if (v.is_boundary() and v.face_count() == 1 and sharp.limit_of(v).kind == sharp_rules<Level>::limit_kind::corner)
        use(v.first_rim() - v, v.last_rim() - v);
}

namespace detail {

struct any_masks {
    template <class... Masks>
    void operator()(const Masks&...) const;
};

} // namespace detail

/// A scheme says where its surface ends up by members that call use(mask), or use(first, second), unless no closed mask
/// is known for an element:
///
///   limit_position(x, use)    x a vertex, or what else goes to one point of the limit surface
///   limit_tangents(x, use)    two tangents there, counter-clockwise
///
/// Schemes with creases take the sharp rules of the level as a further first argument.
template <class Scheme, class Element, class Level>
concept has_limit_positions = requires(const Scheme& s, const Element& x) {
    s.limit_position(x, detail::any_masks());
} or requires(const Scheme& s, const Element& x, const sharp_rules<Level>& sharp) {
    s.limit_position(sharp, x, detail::any_masks());
};
template <class Scheme, class Element, class Level>
concept has_limit_tangents = requires(const Scheme& s, const Element& x) {
    s.limit_tangents(x, detail::any_masks());
} or requires(const Scheme& s, const Element& x, const sharp_rules<Level>& sharp) {
    s.limit_tangents(sharp, x, detail::any_masks());
};

namespace detail {

/// Calls f(arguments...) with what the scheme's limit functions take before the element: the sharp rules, or nothing.
template <class Level, class Scheme, class F>
void with_sharp_rules(const Level& level, const Scheme& scheme, const F& f)
{
    if constexpr (requires { scheme.sharpness; })
        f(sharp_rules(level, scheme.sharpness, scheme.corners));
    else
        f();
}

template <class T, class Level, class Element, class Scheme, class Values>
auto limits(const all_elements<Level, Element>& elements, const Scheme& scheme, const Values& values)
{
    static_assert(has_limit_positions<Scheme, Element, Level>,
                  "this scheme has no limit masks for these elements; docs/schemes.md, Limit, lists those that have");
    std::vector<std::optional<T>> result(elements.size());
    with_sharp_rules(elements.level(), scheme, [&](const auto&... sharp) {
        for (const auto x : elements)
            scheme.limit_position(
                sharp..., x, [&](const auto& mask) { result[x.index()] = affine<T>::store(mask.evaluate(values)); });
    });
    return result;
}

} // namespace detail

/// Where the vertices of a level end up when it is refined for ever; nothing where no closed mask is known (faces that
/// the first step splits, darts, semi-sharp creases that still decay): refine once more.
/// `level` is mesh.elements(i) of a hierarchy, `scheme` its scheme(i). Instead of the level, its vertices() or, where the
/// scheme has masks for them, its faces() may be given: of Doo-Sabin, level.faces(). Cost: O(corners).
template <class Level, class Element, class Scheme>
auto limit_positions(const all_elements<Level, Element>& elements, const Scheme& scheme)
{
    return detail::limits<typename Level::point_type>(elements, scheme, point_values<Level>());
}
template <class Level, class Scheme>
auto limit_positions(const Level& level, const Scheme& scheme)
{
    return limit_positions(level.vertices(), scheme);
}

/// Any values of the vertices of a level, carried to the limit by the same masks: colours, or stencil rows for a matrix.
/// Precondition: one value per vertex.
template <class Level, class Element, class Scheme, affine_value T>
auto limit_values(const all_elements<Level, Element>& elements, const Scheme& scheme, std::span<const T> values)
{
    return detail::limits<T>(elements, scheme, attribute_values<T>(values));
}
template <class Level, class Scheme, affine_value T>
auto limit_values(const Level& level, const Scheme& scheme, std::span<const T> values)
{
    return limit_values(level.vertices(), scheme, values);
}

/// The unit normals of the limit surface at the same places, outward for counter-clockwise faces; nothing where no mask is
/// known or the surface has none (corners with several faces, creases). For points of three coordinates.
template <class Level, class Element, class Scheme>
auto limit_normals(const all_elements<Level, Element>& elements, const Scheme& scheme)
{
    static_assert(has_limit_tangents<Scheme, Element, Level>,
                  "this scheme has no tangent masks for these elements; docs/schemes.md, Limit, lists those that have");
    std::vector<std::optional<std::array<double, 3>>> result(elements.size());
    const point_values<Level> values;
    detail::with_sharp_rules(elements.level(), scheme, [&](const auto&... sharp) {
        for (const auto x : elements)
            scheme.limit_tangents(sharp..., x, [&](const auto& first, const auto& second) {
                const auto a = first.evaluate(values), b = second.evaluate(values);
                std::array<double, 3> n;
                for (std::size_t i = 0; i < 3; ++i)
                    n[i] = double(a[(i + 1) % 3]) * double(b[(i + 2) % 3]) -
                           double(a[(i + 2) % 3]) * double(b[(i + 1) % 3]);
                const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
                if (length > 0)
                    result[x.index()] = std::array{n[0] / length, n[1] / length, n[2] / length};
            });
    });
    return result;
}
template <class Level, class Scheme>
auto limit_normals(const Level& level, const Scheme& scheme)
{
    return limit_normals(level.vertices(), scheme);
}

} // namespace kith
