// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_surface.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/evaluator.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

enum class limit_part : unsigned char { position, first_tangent, second_tangent };

/// The replacement of points by the results of a limit mask, or by NaN if there is no mask.
template <limit_part Part>
struct limits_in_place {
    template <class Point, std::unsigned_integral Index, scheme Scheme, std::predicate<std::size_t> IsWanted>
    static void replace(basic_mesh<Point, Index>& mesh, const Scheme& scheme, const IsWanted& is_wanted)
    {
        constexpr auto no_number = std::numeric_limits<scalar_of<Point>>::quiet_NaN();
        storage<Point> made(std::as_const(mesh).points());
        with_native_level<Scheme>(mesh, [&]<level Level>(const Level& level) {
            const auto& rules = limit_rules<Scheme>::on(scheme, level);
            const auto vertices = level.vertices();
            for (std::size_t v = 0; v < made.size(); ++v)
                if (is_wanted(v)) {
                    bool is_known = false;
                    const auto use = [&](const auto& mask) {
                        made[v] = affine<Point>::store(mask.evaluate(point_values<Level>()));
                        is_known = true;
                    };
                    use_mask<Scheme>(rules, vertices[v], use);
                    if (not is_known)
                        use(no_number * vertices[v]);
                }
        });
        std::ranges::copy(made, mesh.points().begin());
    }

private:
    template <scheme Scheme, class Rules, vertex_element Vertex, class Use>
    static void use_mask(const Rules& rules, const Vertex& v, const Use& use)
    {
        if constexpr (Part == limit_part::position)
            limit_rules<Scheme>::position(rules, v, use);
        else
            limit_rules<Scheme>::tangents(rules, v, [&](const auto& first, const auto& second) {
                if constexpr (Part == limit_part::first_tangent)
                    use(first);
                else
                    use(second);
            });
    }
};

/// The patches of the limits of a scheme. The scheme may have masks for positions alone, or none.
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
struct patched_limits {
    using level_type = level_of<basic_mesh<Point, Index>>;
    static constexpr bool have_positions = has_limit_positions<Scheme, vertex<level_type>, level_type>;
    static constexpr bool have_normals = has_limit_tangents<Scheme, vertex<level_type>, level_type>;

    using type = patched_levels<Point, Index, Scheme>;
    using kind = typename type::kind;

    /// Returns a kind for each limit_part that has masks, in their order.
    static std::vector<kind> kinds()
    {
        std::vector<kind> result{kind_of<limit_part::position>()};
        if constexpr (have_normals) {
            result.push_back(kind_of<limit_part::first_tangent>());
            result.push_back(kind_of<limit_part::second_tangent>());
        }
        return result;
    }

private:
    template <limit_part Part>
    static kind kind_of()
    {
        if constexpr (patchable_scheme<Scheme, Point, Index>) {
            return {1 + std::size_t(Part), [](auto& last, const Scheme& scheme, const auto& is_wanted) {
                        limits_in_place<Part>::replace(last, scheme, is_wanted);
                    }};
        } else {
            return {};
        }
    }
};

} // namespace detail

/// The limit surface of the last level of a refinement, evaluated again and again while the control points move and the
/// connectivity stays. Positions and normals are those of `limit_surface_of`. Faces with the same neighbourhood are
/// evaluated from the control points by shared templates. One thread at a time may use an object; the object itself
/// runs OpenMP threads.
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
    requires detail::patched_limits<Point, Index, Scheme>::have_positions
class limit_evaluator {
public:
    /// Takes a control mesh with points of three coordinates. The limits are those of the vertices of `refine(control,
    /// scheme, levels)`. Errors: those of `refine`. Cost: that of three `evaluator`s. From the first limit without a
    /// mask on, it also takes the memory of the last level.
    limit_evaluator(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                    const refine_options& options = {})
        : options_(options)
        , count_(levels)
        , levels_(control, scheme, levels, patched::kinds(), limit_rules<Scheme>::rings(scheme) + 1, options)
    {
    }
    /// Takes a mesh of another library. `evaluate` takes its points in the order of its vertices.
    template <refinable_mesh M>
    limit_evaluator(const M& control, const Scheme& scheme, int levels, const refine_options& options = {})
        : limit_evaluator(to_native_valid<M, Point>(control), scheme, levels, options)
    {
    }

    /// Returns the limit surface for these control points: the same bits as `limit_surface_of` a mesh that is refined
    /// with them. Errors: mesh_error unless there is a point for each control vertex, all finite; those of
    /// limit_surface_of. Cost: that of the masks, and of the search for limits without masks.
    [[nodiscard]] limit_surface<Point> evaluate(std::span<const Point> control)
    {
        levels_.levels().move_points(0, control);
        if (not levels_.has_patches())
            return limit_surface_of(levels_.levels(), count_);
        wanted limits(make(detail::limit_part::position), {});
        std::vector<Index> open = take_patches(limits);
        if (open.empty() and limits.has_normals())
            return std::move(limits).take();
        make_whole();
        whole_->move(control);
        look_again(limits, open);
        return std::move(limits).complete(whole_->mesh, whole_->scheme, open, false);
    }

private:
    using patched = detail::patched_limits<Point, Index, Scheme>;
    using wanted = detail::wanted_limits<Point, Index, Scheme>;
    using search_type = typename wanted::search_type;

    /// The last level as a mesh, for limits without a mask.
    struct whole_level {
        basic_mesh<Point, Index> mesh;
        Scheme scheme;
        evaluator<Point, Index, Scheme> points;

        void move(std::span<const Point> control)
        {
            const auto moved = points.evaluate(control);
            std::ranges::copy(moved, mesh.points().begin());
        }
    };

    [[nodiscard]] storage<Point> make(detail::limit_part part) const { return levels_.make(std::size_t(part)); }

    void make_whole()
    {
        if (whole_)
            return;
        const auto& control = levels_.levels()[0];
        const Scheme& scheme = levels_.levels().scheme(0);
        hierarchy<basic_mesh<Point, Index>, Scheme> all(control, scheme, options_);
        all.keep_last(1);
        all.refine(count_);
        const Scheme of_last = all.scheme(count_);
        whole_.emplace(
            std::move(all).finest(), of_last, evaluator<Point, Index, Scheme>(control, scheme, count_, options_));
    }

    /// Keeps the normals that the tangents give. Returns the vertices whose position or normal is still open, by
    /// increasing number.
    std::vector<Index> take_patches(wanted& limits)
    {
        storage<Point> first, second;
        if constexpr (patched::have_normals) {
            first = make(detail::limit_part::first_tangent);
            second = make(detail::limit_part::second_tangent);
        }
        std::vector<unsigned char> is_open(levels_.last_vertices(), 0);
        detail::for_parts(is_open.size(), true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                if constexpr (patched::have_normals) {
                    const auto a = detail::scaled(affine<Point>::load(first[v]), 0);
                    const auto b = detail::scaled(affine<Point>::load(second[v]), 0);
                    if (detail::are_in_range(a, b))
                        limits.keep(v, {{}, unit_normal(a, b)});
                }
                is_open[v] = not limits.is_placed(v) or limits.awaits_normal(v);
            }
        });
        std::vector<Index> open;
        for (std::size_t v = 0; v < is_open.size(); ++v)
            if (is_open[v] != 0)
                open.push_back(Index(v));
        return open;
    }
    /// Evaluates the masks of the last level at the open vertices, since their tangents may have been out of range.
    /// Leaves in `open` the vertices that the masks do not decide.
    void look_again(wanted& limits, std::vector<Index>& open) const
    {
        const typename patched::level_type level(whole_->mesh);
        const auto& rules = limit_rules<Scheme>::on(whole_->scheme, level);
        std::erase_if(open, [&](Index v) {
            typename search_type::found limit;
            search_type::take(level.vertices()[v], rules, limit, 0);
            limits.keep(v, limit);
            return limit.position and not limits.awaits_normal(level.vertices()[v], rules);
        });
    }

    refine_options options_;
    int count_;
    typename patched::type levels_;
    std::optional<whole_level> whole_; // made when a limit has no mask
};

template <refinable_mesh M, searchable_scheme Scheme>
limit_evaluator(const M&, const Scheme&, int, const refine_options& = {})
    -> limit_evaluator<typename mesh_traits<M>::point, std::uint32_t, Scheme>;
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
limit_evaluator(const basic_mesh<Point, Index>&, const Scheme&, int, const refine_options& = {})
    -> limit_evaluator<Point, Index, Scheme>;

} // namespace kith
