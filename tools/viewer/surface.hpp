// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/hierarchy.hpp>
#include <kith/mesh.hpp>
#include <kith/plan.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith::viewer {

using point = std::array<double, 3>;
using mesh_type = basic_mesh<point>;
using level_type = level_of<mesh_type>;

/// A control mesh, a scheme, and the levels that were asked for, each with its elements and their relatives.
class surface {
public:
    surface() = default;
    surface(const surface&) = delete;
    surface& operator=(const surface&) = delete;
    virtual ~surface() = default;

    /// Returns the number of levels whose faces are at most `faces`, level 0 not counted.
    [[nodiscard]] virtual int levels_within(std::size_t faces) const = 0;
    /// Makes the levels up to `level` unless they are there. Errors: as `hierarchy::refine`.
    virtual void refine_to(int level) = 0;
    /// Begins again with creases on the control mesh; only level 0 is there then. Schemes without rules for creases
    /// ignore them.
    virtual void sharpen(const creases& sharpness) = 0;
    /// Moves the vertices of the control mesh, and the levels up to `last` with them. Drops the levels after it.
    virtual void move_points(std::span<const point> points, int last) = 0;

    // Functions of a level: precondition: it has been made.
    [[nodiscard]] virtual const level_type& elements(int level) const = 0;
    /// Returns the creases of a level, or nothing if the scheme has no rules for them.
    [[nodiscard]] virtual const creases* sharpness(int level) const = 0;
    /// Returns values at the vertices of the control mesh, carried to a level by the masks of the scheme.
    [[nodiscard]] virtual std::vector<double> carry(int level, std::span<const double> values) const = 0;
    [[nodiscard]] virtual birth<mesh_type> origin(int level, numbered_element x) const = 0;
    [[nodiscard]] virtual numbered_element ancestor(int level, numbered_element x, int coarser) const = 0;
    [[nodiscard]] virtual element_ranges descendants(int level, numbered_element x, int finer) const = 0;
};

/// Calls function(handle) with the handle of an element of a native mesh.
template <class Function>
auto with_handle(numbered_element x, const Function& function)
{
    using traits = mesh_traits<mesh_type>;
    const auto number = std::uint32_t(x.number);
    switch (x.kind) {
    case element_kind::vertex: return function(traits::vertex{number});
    case element_kind::edge: return function(traits::edge{number});
    default: return function(traits::face{number});
    }
}

template <scheme Scheme>
class surface_of_scheme : public surface {
public:
    /// Errors: as the constructor of `hierarchy`.
    explicit surface_of_scheme(mesh_type control) : levels_(std::move(control)) {}

    int levels_within(std::size_t faces) const override
    {
        constexpr int most_levels = 20;
        const auto planned = plan_what_fits(levels_.elements(0).counts(), levels_.scheme(0), most_levels).levels;
        int level = 0;
        while (std::size_t(level) + 1 < planned.size() and planned[std::size_t(level) + 1].counts.faces <= faces)
            ++level;
        return level;
    }
    void refine_to(int level) override
    {
        if (level > levels_.depth())
            levels_.refine(level - levels_.depth());
    }
    void sharpen(const creases& sharpness) override
    {
        if constexpr (requires(Scheme s) { s.sharpness; }) {
            Scheme scheme = levels_.scheme(0);
            scheme.sharpness = sharpness;
            levels_ = hierarchy(mesh_type(levels_[0]), std::move(scheme));
        }
    }
    void move_points(std::span<const point> points, int last) override
    {
        if (last < levels_.depth())
            levels_.undo(levels_.depth() - last);
        levels_.move_points(0, points);
    }

    const level_type& elements(int level) const override { return levels_.elements(level); }
    const creases* sharpness(int level) const override
    {
        if constexpr (requires(Scheme s) { s.sharpness; })
            return &levels_.scheme(level).sharpness;
        return nullptr;
    }
    std::vector<double> carry(int level, std::span<const double> values) const override
    {
        const auto carried = levels_.carry(0, level, values);
        return {carried.begin(), carried.end()};
    }
    birth<mesh_type> origin(int level, numbered_element x) const override
    {
        return with_handle(x, [&](auto handle) { return levels_.origin(level, handle); });
    }
    numbered_element ancestor(int level, numbered_element x, int coarser) const override
    {
        const auto found = with_handle(x, [&](auto handle) { return levels_.ancestor(level, handle, coarser); });
        return {found.kind, found.v ? found.v->value : found.e ? found.e->value : found.f->value};
    }
    element_ranges descendants(int level, numbered_element x, int finer) const override
    {
        return with_handle(x, [&](auto handle) { return levels_.descendants(level, handle, finer).numbers(); });
    }

private:
    hierarchy<mesh_type, Scheme> levels_;
};

} // namespace kith::viewer
