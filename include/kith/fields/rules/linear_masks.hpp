// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/numbering/association/column_ids.hpp>
#include <kith/numbering/association/tuples.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/scheme_traits.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace kith::detail {

/// True if the scheme of a step has a closure, which keeps the level conforming if only some faces are refined.
template <finished_step Step>
inline constexpr bool has_closure =
    is_said<decltype(traits_of<std::remove_cvref_t<decltype(std::declval<const Step&>().scheme)>>.closure)>;
template <finished_step Step>
const auto& closure_of(const Step& step)
{
    return std::invoke(traits_of<std::remove_cvref_t<decltype(step.scheme)>>.closure, step.scheme);
}

/// A weighted sum of values, formed in the order in which they are added.
template <affine_value T>
class blend {
    using number = affine<T>;

public:
    explicit blend(const T& first) : sum_(number::load(first)) {}
    blend& add(const T& more)
    {
        number::add(sum_, number::load(more));
        return *this;
    }
    [[nodiscard]] T over(std::size_t count) const
    {
        auto result = sum_;
        number::scale(result, scalar_of<T>(1) / scalar_of<T>(double(count)));
        return number::store(result);
    }

private:
    typename number::sum sum_;
};

/// Returns the mean of the values of the elements of a tuple. The functions return these by number.
template <affine_value T, class AtVertex, class AtEdge, class AtFace>
T mean_of_tuple(const tuple_elements& tuple, const AtVertex& at_vertex, const AtEdge& at_edge, const AtFace& at_face)
{
    const auto at = [&](const std::pair<char, std::size_t>& x) -> T {
        return x.first == 'v' ? at_vertex(x.second) : x.first == 'e' ? at_edge(x.second) : at_face(x.second);
    };
    blend<T> sum(at(tuple.front()));
    for (std::size_t i = 1; i < tuple.size(); ++i)
        sum.add(at(tuple[i]));
    return sum.over(tuple.size());
}

/// The masks of a linear rule for the tuples of one face or edge. The value of a tuple is the mean of the values of its
/// elements. A vertex has its own value, an edge that of its middle, and a face the mean of its corners. But a scheme
/// that makes two vertices of an edge cuts edges and faces in thirds. Masks are inlined, since g++ passes arrays of two
/// numbers through the memory.
template <affine_value T, bool InThirds>
struct linear_masks {
    [[nodiscard, gnu::always_inline]] static inline T middle(const T& a, const T& b)
    {
        return blend<T>(a).add(b).over(2);
    }
    [[nodiscard, gnu::always_inline]] static inline T third(const T& near, const T& far)
    {
        return blend<T>(near).add(near).add(far).over(3);
    }
    [[nodiscard, gnu::always_inline]] static inline T in_face(const T& corner, const T& mean)
    {
        return InThirds ? third(mean, corner) : middle(corner, mean);
    }
    [[nodiscard, gnu::always_inline]] static inline T of_three(const T& vertex, const T& edge, const T& face)
    {
        return blend<T>(vertex).add(edge).add(face).over(3);
    }
    /// Returns the mean over the corners that the face was made with, of which the first is one. `at(corner)` is the
    /// value of a corner.
    template <finished_step Step, face_element Face, class At>
    [[nodiscard]] static T mean([[maybe_unused]] const Step& step, const Face& f, const At& at)
    {
        const auto first = f.first_corner();
        blend<T> sum(at(first));
        std::size_t count = 1;
        for (auto c = first.next(); not(c == first); c = c.next()) {
            if constexpr (has_closure<Step>)
                if (closure_of(step).lies_on_side(c))
                    continue;
            sum.add(at(c));
            ++count;
        }
        return sum.over(count);
    }
};
template <affine_value T, element_ids VertexIds>
using linear_masks_of =
    linear_masks<T, VertexIds::template has<tuple_kind::ve> and VertexIds::template has<tuple_kind::vf>>;

} // namespace kith::detail
