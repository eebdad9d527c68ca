// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/core/level/elements.hpp>
#include <kith/core/mask/mask.hpp>
#include <kith/unified.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith::detail {

/// The values at 0, 1/2, 1, ... of the uniform B-spline of a degree up to 9, centred at 0, and of minus its derivative.
class spline_values {
public:
    constexpr explicit spline_values(int degree)
    {
        for (int half = 0; half < int(value_.size()); ++half) {
            value_[std::size_t(half)] = spline(degree, half);
            fall_[std::size_t(half)] = degree == 0 ? 0 : spline(degree - 1, half - 1) - spline(degree - 1, half + 1);
        }
    }
    [[nodiscard]] constexpr double value(int half_steps) const { return value_[magnitude(half_steps)]; }
    [[nodiscard]] constexpr double fall(int half_steps) const
    {
        return half_steps < 0 ? -fall_[magnitude(half_steps)] : fall_[magnitude(half_steps)];
    }

private:
    static constexpr std::size_t magnitude(int half_steps)
    {
        return std::size_t(half_steps < 0 ? -half_steps : half_steps);
    }
    /// Returns the value by the recursion of de Boor and Cox.
    static constexpr double spline(int degree, int half)
    {
        if (degree == 0)
            return -1 <= half and half < 1 ? 1 : 0;
        const double x = half / 2., end = (degree + 1) / 2.;
        return ((end + x) * spline(degree - 1, half + 1) + (end - x) * spline(degree - 1, half - 1)) / degree;
    }

    std::array<double, 12> value_{}, fall_{};
};

inline constexpr auto spline_values_by_degree = []<std::size_t... D>(std::index_sequence<D...>) {
    return std::array{spline_values(int(D))...};
}(std::make_index_sequence<10>());

/// Calls f(i, j, vertex) for the vertices to the left of the straight line that starts with half-edge u: i = 1, ...,
/// `steps` along the line, then j = 0, ..., `steps` to the left. Returns true if all faces there are quads and all
/// vertices but the outermost are regular. Precondition: no boundary.
template <corner_element Corner, class F>
bool walk_sector(Corner u, int steps, const F& f)
{
    const auto straight_on = [](const Corner& c) { return c.next().across().next(); };
    for (int i = 1; i <= steps; ++i) {
        Corner c = u; // its next vertex is the one at (i, j)
        for (int j = 0; j <= steps; ++j) {
            const auto end = c.next().v();
            if (c.f().degree() != 4 or (i < steps and j < steps and end.valence() != 4))
                return false;
            f(i, j, end);
            if (j < steps)
                c = j == 0 ? c.next() : straight_on(c);
        }
        if (i < steps)
            u = straight_on(u);
    }
    return true;
}

/// Calls use(sector, x, y, vertex) for the vertices around an element among quads, seen as n sectors of a lattice. x
/// and y are the place in the sector in half steps, with the element at 0, 0. Returns false if the lattice is not
/// regular.
template <level Level, class Use>
bool walk_lattice(const vertex<Level>& v, int degree, const Use& use)
{
    use(0, 0, 0, v);
    int sector = 0;
    for (const auto c : v.corners()) {
        if (not walk_sector(c, degree / 2, [&](int i, int j, const auto& u) { use(sector, 2 * i, 2 * j, u); }))
            return false;
        ++sector;
    }
    return true;
}
template <level Level, class Use>
bool walk_lattice(const face<Level>& f, int degree, const Use& use)
{
    const int steps = degree / 2 - 1; // beyond the face's own corners
    int sector = 0;
    for (const auto c : f.corners()) {
        use(sector, 1, 1, c.v());
        if (steps > 0) {
            if (c.v().valence() != 4)
                return false;
            auto up = c.across().next(); // the corner at c.v() beyond the edge after c
            if (not walk_sector(up.across().next(), steps, [&](int i, int j, const auto& u) {
                    use(sector, 2 * i + 1, 2 * j + 1, u);
                }))
                return false;
            for (int j = 1; j <= steps; ++j) {
                if (up.f().degree() != 4 or (j < steps and up.next().v().valence() != 4))
                    return false;
                use(sector, 1, 2 * j + 1, up.next().v());
                if (j < steps)
                    up = up.next().across().next();
            }
        }
        ++sector;
    }
    return true;
}

/// Calls use(mask) with the limit mask of the family of Zorin & Schroeder at an element with n sectors. Averaging acts
/// on the mean of the n sectors as it does on the mean of four. So the weights are those of the tensor B-spline, shared
/// among n sectors.
template <element Element, class Use>
void use_spline_position(const Element& x, std::size_t sectors, int degree, const Use& use)
{
    using entry = std::pair<std::remove_cvref_t<decltype(x.first_corner().v())>, double>;
    const auto& spline = spline_values_by_degree[std::size_t(degree)];
    std::vector<entry> row;
    if (walk_lattice(x, degree, [&](int, int i, int j, const auto& u) {
            const double share = i == 0 and j == 0 ? 1 : 4 / double(sectors);
            row.emplace_back(u, spline.value(i) * spline.value(j) * share);
        }))
        use(weighted(row));
}
/// Calls use(first, second) with the two derivatives. Precondition: the element has four sectors.
template <element Element, class Use>
void use_spline_tangents(const Element& x, int degree, const Use& use)
{
    using entry = std::pair<std::remove_cvref_t<decltype(x.first_corner().v())>, double>;
    const auto& spline = spline_values_by_degree[std::size_t(degree)];
    std::vector<entry> first, second;
    if (walk_lattice(x, degree, [&](int sector, int i, int j, const auto& u) {
            for (; sector > 0; --sector) { // a quarter turn
                const int turned = -j;
                j = i;
                i = turned;
            }
            first.emplace_back(u, spline.fall(i) * spline.value(j));
            second.emplace_back(u, spline.value(i) * spline.fall(j));
        }))
        use(weighted(first), weighted(second));
}

} // namespace kith::detail

namespace kith {

/// The limit rules of unified: masks at vertices and, for even degrees, at faces with regular quads around. There is no
/// mask if other faces or vertices are near. docs/schemes.md.
template <>
struct limit_rules<unified> : limit_defaults {
    template <level Level, class Use>
    static void position(const unified& s, const vertex<Level>& v, const Use& use)
    {
        if (s.degree == 1)
            use(sum(v));
        else
            detail::use_spline_position(v, v.face_count(), s.degree, use);
    }
    template <level Level, class Use>
    static void position(const unified& s, const face<Level>& f, const Use& use)
    {
        if (not s.is_primal())
            detail::use_spline_position(f, f.degree(), s.degree, use);
    }
    /// Calls use(first, second) with the derivatives of the B-spline, at vertices and faces that are regular
    /// themselves.
    template <level Level, class Use>
    static void tangents(const unified& s, const vertex<Level>& v, const Use& use)
    {
        if (s.degree > 1 and v.valence() == 4)
            detail::use_spline_tangents(v, s.degree, use);
    }
    template <level Level, class Use>
    static void tangents(const unified& s, const face<Level>& f, const Use& use)
    {
        if (not s.is_primal() and f.degree() == 4)
            detail::use_spline_tangents(f, s.degree, use);
    }
    static constexpr bool are_alike_where_regular = true;
    static constexpr int rings(const unified& s) { return s.degree / 2 + 1; }
    /// Returns the rings before a step. Two averaging steps take a refined ring. Two refined rings lie in one ring of
    /// faces that share a vertex.
    static constexpr int reach(const unified& s, int rings) { return (rings + s.degree / 2 + 1) / 2; }
    static constexpr int tangent_steps = 0; ///< irregular elements stay irregular
};

} // namespace kith
