// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unit_normal.hpp"

#include <kith/crease/sharp_rules.hpp>
#include <kith/hierarchy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
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

/// Points times a factor.
template <class Level>
class scaled_points {
    using number = affine<typename Level::point_type>;

public:
    using scalar = typename number::scalar;
    using sum = typename number::sum;

    explicit scaled_points(double factor) : factor_(factor) {}
    static void add(sum& total, const sum& more) { number::add(total, more); }
    static void scale(sum& total, const scalar& weight) { number::scale(total, weight); }
    [[nodiscard]] sum coarse(const vertex<Level>& v) const
    {
        sum result = number::load(v.point());
        scale(result, scalar(factor_));
        return result;
    }

private:
    double factor_;
};

/// The unit normal that two tangent masks give; nothing where they give none. Where their sums overflow, or are so small that
/// digits are lost, they are formed once more of scaled points.
template <class Level, class First, class Second>
std::optional<normal_vector> normal_of(const First& first, const Second& second)
{
    const auto over = [&](const auto& values) {
        const auto a = first.evaluate(values), b = second.evaluate(values);
        return std::pair{scaled(a, 0), scaled(b, 0)};
    };
    const auto are_finite = [](const auto& tangents) {
        return is_finite(tangents.first) and is_finite(tangents.second);
    };
    auto tangents = over(point_values<Level>());
    if (not are_finite(tangents))
        tangents = over(scaled_points<Level>(std::scalbn(1., -100)));
    common_exponent a, b;
    a.add(tangents.first);
    b.add(tangents.second);
    if (std::min(a.value(), b.value()) < -900)
        if (const auto larger = over(scaled_points<Level>(std::scalbn(1., 200))); are_finite(larger))
            tangents = larger;
    return unit_normal(tangents.first, tangents.second);
}

} // namespace detail

/// Where the vertices of a level end up when it is refined for ever, by closed masks alone; nothing where none is known
/// (faces that the first step splits, darts, semi-sharp creases that still decay): limit_surface finds those, too.
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
    std::vector<std::optional<normal_vector>> result(elements.size());
    detail::with_sharp_rules(elements.level(), scheme, [&](const auto&... sharp) {
        for (const auto x : elements)
            scheme.limit_tangents(sharp..., x, [&](const auto& first, const auto& second) {
                result[x.index()] = detail::normal_of<Level>(first, second);
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
