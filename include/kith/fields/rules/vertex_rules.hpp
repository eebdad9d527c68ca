// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "inherit.hpp"
#include "linear_masks.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/numbering/step/refinement.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>

namespace kith {

namespace detail {

/// Returns memory for the values at the vertices of the next level. Vertices of the dictionary have T(), or zero if T()
/// is uninitialized.
template <class T, finished_step Step>
storage<T> values_at_new_vertices(const Step& step)
{
    storage<T> result(step.fine_vertices());
    std::fill(result.begin() + step.ids.vertices.total(), result.end(), value_of_nothing<T>());
    return result;
}

} // namespace detail

/// The linear rule of values at vertices. A new vertex has the mean of the elements of its tuple, even if that is in no
/// column. An edge counts as the mean of its ends, a face as that of its vertices. On edges that are cut in three, the
/// values are those at the thirds. Cost: O(corners).
struct linear_values {
    template <affine_value T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        using masks = detail::linear_masks_of<T, decltype(step.ids.vertices)>;
        const auto at = [&](const auto& c) { return values[c.v().index()]; };
        const auto mean = [&](const auto& f) { return masks::mean(step, f, at); };
        const auto middle = [&](const auto& e) {
            return masks::middle(values[e.org().index()], values[e.dst().index()]);
        };
        storage<T> means(needs_means<decltype(step.ids.vertices)> ? step.coarse.face_count() : 0);
        detail::for_parts(means.size(), step.coarse.parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f)
                means[f] = mean(step.coarse.faces()[f]);
        });
        auto result = detail::values_at_new_vertices<T>(step);
        detail::for_new_elements(
            step.coarse,
            step.ids.vertices,
            detail::columns_of_step(step).vertices.list,
            [&]<tuple_kind K>(std::size_t id, std::size_t tuple) {
                const auto x = tuple_element<K>(step.coarse, tuple);
                if constexpr (K == tuple_kind::v)
                    result[id] = values[tuple];
                else if constexpr (K == tuple_kind::e)
                    result[id] = middle(x);
                else if constexpr (K == tuple_kind::f)
                    result[id] = mean(x);
                else if constexpr (K == tuple_kind::ve) {
                    const T &org = values[x.org().index()], &dst = values[x.dst().index()];
                    result[id] = tuple % 2 == 0 ? masks::third(org, dst) : masks::third(dst, org);
                } else if constexpr (K == tuple_kind::vf)
                    result[id] = masks::in_face(at(x), means[x.f().index()]);
                else if constexpr (K == tuple_kind::ef)
                    result[id] = masks::middle(middle(x.next_edge()), means[x.f().index()]);
                else
                    result[id] = masks::of_three(
                        at(x), middle(tuple % 2 == 0 ? x.next_edge() : x.prev_edge()), means[x.f().index()]);
            });
        const auto& listed = step.ids.dictionary;
        for (std::size_t k = 0; k < listed.size(); ++k)
            result[step.ids.vertices.total() + k] = detail::mean_of_tuple<T>(
                listed.tuple_of(k),
                [&](std::size_t v) { return values[v]; },
                [&](std::size_t e) { return middle(step.coarse.edges()[e]); },
                [&](std::size_t f) { return mean(step.coarse.faces()[f]); });
        return result;
    }

private:
    template <element_ids Ids>
    static constexpr bool needs_means = Ids::template has<tuple_kind::vf> or Ids::template has<tuple_kind::ef> or
                                        Ids::template has<tuple_kind::vfe>;
};

/// The rule of marks on vertices. A vertex that comes from a vertex inherits from it, by `inherit(value)`. All others
/// have `born`: a value, or a function of (const auto& element, values). The element is the edge, face or corner that
/// made the vertex. A vertex of the dictionary has `born` if that is a value, else T(). The functions may be called on
/// several threads.
template <class Inherit = std::identity, class Born = no_value>
struct from_vertex {
    [[no_unique_address]] Inherit inherit{};
    [[no_unique_address]] Born born{};

    template <class T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        auto result = detail::values_at_new_vertices<T>(step);
        if constexpr (std::convertible_to<const Born&, T>)
            std::fill(result.begin() + step.ids.vertices.total(), result.end(), T(born));
        detail::inherit_values<element_kind::vertex>(result, values, *this, step);
        return result;
    }
};

/// The rule of values at vertices that are as smooth as the surface, by the scheme's own masks. Cost: that of the step
/// without its connectivity.
struct by_mask {
    template <affine_value T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        attribute_values<T> run(values);
        run_scheme<connect::nothing, false>(
            step.coarse, step.scheme, step.generation, step.ids, detail::columns_of_step(step), run);
        return run.take();
    }
};

} // namespace kith
