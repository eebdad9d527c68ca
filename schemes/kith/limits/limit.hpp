// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unit_normal.hpp"

#include <kith/core/level/elements.hpp>
#include <kith/core/level/for_each.hpp>
#include <kith/core/level/values.hpp>
// These headers have the limit rules of all schemes: no limit may be searched for if its scheme has a rule.
#include <kith/limits/rules/butterfly.hpp>
#include <kith/limits/rules/catmull_clark.hpp>
#include <kith/limits/rules/doo_sabin.hpp>
#include <kith/limits/rules/four_eight.hpp>
#include <kith/limits/rules/interpolating.hpp>
#include <kith/limits/rules/kobbelt.hpp>
#include <kith/limits/rules/loop.hpp>
#include <kith/limits/rules/mid_edge.hpp>
#include <kith/limits/rules/nasri_hasbini.hpp>
#include <kith/limits/rules/quad_tri.hpp>
#include <kith/limits/rules/sqrt3.hpp>
#include <kith/limits/rules/unified.hpp>
#include <kith/schemes/kernel/limit_rules.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

struct any_masks {
    template <class... Masks>
    void operator()(const Masks&...) const; // masks, and other arguments that the rules pass
};

template <scheme Scheme, level Level>
using limit_rules_argument = decltype(limit_rules<Scheme>::on(std::declval<const Scheme&>(),
                                                              std::declval<const Level&>()));

} // namespace detail

/// Requirements of a scheme whose limit_rules have masks for the positions of these elements.
template <class Scheme, class Element, class Level>
concept has_limit_positions = requires(const detail::limit_rules_argument<Scheme, Level>& rules, const Element& x) {
    limit_rules<Scheme>::position(rules, x, detail::any_masks());
};
template <class Scheme, class Element, class Level>
concept has_limit_tangents = requires(const detail::limit_rules_argument<Scheme, Level>& rules, const Element& x) {
    limit_rules<Scheme>::tangents(rules, x, detail::any_masks());
};
/// Requirements of a scheme whose limit_rules have tangent masks for each side of a crease at these elements.
template <class Scheme, class Element, class Level>
concept has_limit_sides = requires(const detail::limit_rules_argument<Scheme, Level>& rules, const Element& x) {
    limit_rules<Scheme>::sides(rules, x, detail::any_masks());
};

namespace detail {

template <class T, level Level, element Element, scheme Scheme, value_space Values>
auto limits(const all_elements<Level, Element>& elements, const Scheme& scheme, const Values& values)
{
    static_assert(has_limit_positions<Scheme, Element, Level>,
                  "this scheme has no limit masks for these elements; docs/schemes.md, Limit, lists those that have");
    std::vector<std::optional<T>> result(elements.size());
    const auto& rules = limit_rules<Scheme>::on(scheme, elements.level());
    for_each_by_number(elements, [&](const auto& x) {
        limit_rules<Scheme>::position(
            rules, x, [&](const auto& mask) { result[x.index()] = affine<T>::store(mask.evaluate(values)); });
    });
    return result;
}

/// The point alone, without other values that it carries, such as weights. Normals are computed from it.
template <class Point>
struct bare_point {
    using type = Point;
    static const Point& of(const Point& point) { return point; }
};

/// The bare points of a level, as a value space for masks.
template <level Level>
class bare_points {
    using bare = bare_point<typename Level::point_type>;
    using number = affine<typename bare::type>;

public:
    using scalar = typename number::scalar;
    using sum = typename number::sum;

    static void add(sum& total, const sum& more) { number::add(total, more); }
    static void scale(sum& total, const scalar& weight) { number::scale(total, weight); }
    [[nodiscard]] decltype(auto) coarse(const vertex<Level>& v) const { return number::load(bare::of(v.point())); }
};

/// The bare points of a level times a factor.
template <level Level>
class scaled_points : public bare_points<Level> {
public:
    using typename bare_points<Level>::scalar, typename bare_points<Level>::sum;

    explicit scaled_points(double factor) : factor_(factor) {}
    [[nodiscard]] sum coarse(const vertex<Level>& v) const
    {
        sum result = bare_points<Level>::coarse(v);
        this->scale(result, scalar(factor_));
        return result;
    }

private:
    double factor_;
};

/// Returns true if the sums of tangent masks are finite, and not so small that digits are lost.
inline bool is_in_range(std::uint64_t exponent_bits)
{
    return is_usual(exponent_bits) and exponent_bits >= 1023 - 900;
}
template <class... Vectors>
bool are_in_range(const Vectors&... tangents)
{
    return (is_in_range(exponent_bits(tangents)) and ...);
}

/// Returns tangents in range. `tangents` are the results of the masks; over(factor) evaluates the masks again with
/// points times a factor.
template <std::size_t Count, class Over>
std::array<normal_vector, Count> brought_into_range(std::array<normal_vector, Count> tangents, const Over& over)
{
    const auto are_finite = [](const auto& some) {
        return std::ranges::all_of(some, [](const normal_vector& t) { return is_finite(t); });
    };
    if (not are_finite(tangents))
        tangents = over(std::scalbn(1., -100));
    int least = std::numeric_limits<int>::max();
    for (const normal_vector& t : tangents) {
        common_exponent exponent;
        exponent.add(t);
        least = std::min(least, exponent.value());
    }
    if (least < -900)
        if (const auto larger = over(std::scalbn(1., 200)); are_finite(larger))
            tangents = larger;
    return tangents;
}

/// Returns tangents in range, given the results of the masks.
template <level Level, std::size_t Count, class... Masks>
[[gnu::noinline, gnu::cold]] std::array<normal_vector, Count>
tangents_of_scaled(const std::array<normal_vector, Count>& tangents, const Masks&... masks)
{
    const std::function<std::array<normal_vector, Count>(double)> over =
        [&](double factor) __attribute__((noinline, cold)) {
            const scaled_points<Level> points(factor);
            return std::array{scaled(masks.evaluate(points), 0)...};
        };
    return brought_into_range(tangents, over);
}

/// Returns the tangents that masks give. If their sums are out of range, the masks are evaluated again with scaled
/// points.
template <level Level, class... Masks>
std::array<normal_vector, sizeof...(Masks)> tangents_of(const Masks&... masks)
{
    const bare_points<Level> points;
    const auto tangents = std::array{scaled(masks.evaluate(points), 0)...};
    if (std::apply([](const auto&... t) { return are_in_range(t...); }, tangents)) [[likely]]
        return tangents;
    return tangents_of_scaled<Level>(tangents, masks...);
}

/// Returns the unit normal that two tangent masks give; nothing if they give none.
template <level Level, class First, class Second>
std::optional<normal_vector> normal_of(const First& first, const Second& second)
{
    const auto [a, b] = tangents_of<Level>(first, second);
    return unit_normal(a, b);
}

} // namespace detail

/// Returns the limits of the vertices of a level by closed-form masks alone. The result is nothing for a vertex without
/// a known mask (at faces that the first step splits, at semi-sharp creases that still decay); limit_surface_of finds
/// those, too. `level` is mesh.elements(i) of a hierarchy, `scheme` its scheme(i). Instead of the level, its vertices()
/// may be given or, if the scheme has masks for them, its faces(): level.faces() of Doo-Sabin. The level must be a
/// whole mesh: at the cuts of a part the masks would take the border of the part for a boundary. For a tile, pass the
/// tile (limits_of_tile.hpp). Cost: O(corners).
template <level Level, element Element, scheme Scheme>
auto limit_positions(const all_elements<Level, Element>& elements, const Scheme& scheme)
{
    return detail::limits<typename Level::point_type>(elements, scheme, point_values<Level>());
}
template <level Level, scheme Scheme>
auto limit_positions(const Level& level, const Scheme& scheme)
{
    return limit_positions(level.vertices(), scheme);
}

/// Returns the limits of any values of the vertices of a level, by the masks of the positions: colours, or stencil rows
/// for a matrix. Precondition: one value per vertex.
template <level Level, element Element, scheme Scheme, affine_value T>
auto limit_values(const all_elements<Level, Element>& elements, const Scheme& scheme, std::span<const T> values)
{
    return detail::limits<T>(elements, scheme, attribute_values<T>(values));
}
template <level Level, scheme Scheme, affine_value T>
auto limit_values(const Level& level, const Scheme& scheme, std::span<const T> values)
{
    return limit_values(level.vertices(), scheme, values);
}

/// Returns the unit normals of the limit surface at the limits of the elements, outward for counter-clockwise faces.
/// The result is nothing if no mask is known or the surface has no single normal (corners with several faces, creases).
/// limit_surface_of has a normal for each side of a crease. A normal does not depend on the level. For points of three
/// coordinates and a whole mesh.
template <level Level, element Element, scheme Scheme>
auto limit_normals(const all_elements<Level, Element>& elements, const Scheme& scheme)
{
    static_assert(has_limit_tangents<Scheme, Element, Level>,
                  "this scheme has no tangent masks for these elements; docs/schemes.md, Limit, lists those that have");
    std::vector<std::optional<normal_vector>> result(elements.size());
    const auto& rules = limit_rules<Scheme>::on(scheme, elements.level());
    for_each_by_number(elements, [&](const auto& x) {
        limit_rules<Scheme>::tangents(rules, x, [&](const auto& first, const auto& second) {
            result[x.index()] = detail::normal_of<Level>(first, second);
        });
    });
    return result;
}
template <level Level, scheme Scheme>
auto limit_normals(const Level& level, const Scheme& scheme)
{
    return limit_normals(level.vertices(), scheme);
}

} // namespace kith
