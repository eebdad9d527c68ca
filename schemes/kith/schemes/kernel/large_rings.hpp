// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/level_elements.hpp>
#include <kith/core/mask/ring_waves.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// What a scheme notes of each vertex before it makes edges and faces, so that none of them counts a fan again.
enum class fan_kind : unsigned char {
    regular,
    irregular, ///< with a row of weights
    large      ///< irregular, with more operands than longest_row
};

/// An inner vertex whose valence is not the regular one.
constexpr fan_kind irregular_fan(std::size_t valence)
{
    return valence > longest_row ? fan_kind::large : fan_kind::irregular;
}

namespace detail {

/// The place of a corner in a large fan.
struct corner_of_large_fan {
    std::size_t corner;
    std::uint32_t fan, step;
};
/// The place of a large face among these.
struct large_face {
    std::size_t face, place;
};

} // namespace detail

/// What has been summed of each large fan (ring_waves), and where its corners lie in it. Few among many, so they are
/// kept as a sorted list. Cost: O(corners of large fans log of them), and a look at every vertex's kind.
template <class Sums>
class large_fans {
public:
    struct place {
        const Sums& sums;
        std::int64_t step; ///< how many corners lie between the first one of the fan and this one
    };

    /// `make(v, n)` sums the fan of a vertex of valence n; `kinds` is by vertex number.
    template <level Level, class Make>
    large_fans(const Level& coarse, const std::vector<fan_kind>& kinds, const Make& make)
    {
        if (std::ranges::find(kinds, fan_kind::large) == kinds.end())
            return;
        for (const auto v : coarse.vertices()) {
            if (kinds[v.index()] != fan_kind::large)
                continue;
            std::uint32_t step = 0;
            for (const auto c : v.corners())
                corners_.push_back({c.index(), std::uint32_t(sums_.size()), step++});
            sums_.push_back(make(v, std::size_t(step)));
        }
        std::ranges::sort(corners_, {}, &detail::corner_of_large_fan::corner);
    }

    /// Precondition: a corner of a large fan. Cost: O(log corners of large fans).
    template <corner_element Corner>
    [[nodiscard]] place at(const Corner& c) const
    {
        const auto found = std::ranges::lower_bound(corners_, c.index(), {}, &detail::corner_of_large_fan::corner);
        return {sums_[found->fan], found->step};
    }

private:
    std::vector<detail::corner_of_large_fan> corners_;
    std::vector<Sums> sums_;
};

template <level Level, class Make>
large_fans(const Level& coarse, const std::vector<fan_kind>&, const Make&)
    -> large_fans<decltype(std::declval<const Make&>()(coarse.vertices()[0], std::size_t()))>;

/// The same of large faces: the sums over their corners from the first one on. Cost: O(faces + corners of large faces).
template <class Sums>
class large_faces {
public:
    /// `make(f, n)` sums a face of n corners.
    template <level Level, class Make>
    large_faces(const Level& coarse, const Make& make)
    {
        for (const auto f : coarse.faces())
            if (const std::size_t n = f.degree(); n > longest_row) {
                faces_.push_back({f.index(), sums_.size()});
                sums_.push_back(make(f, n));
            }
        std::ranges::sort(faces_, {}, &detail::large_face::face);
    }

    /// Precondition: a face of more than longest_row corners. Cost: O(log large faces).
    template <face_element Face>
    [[nodiscard]] const Sums& of(const Face& f) const
    {
        return sums_[std::ranges::lower_bound(faces_, f.index(), {}, &detail::large_face::face)->place];
    }

private:
    std::vector<detail::large_face> faces_;
    std::vector<Sums> sums_;
};

template <level Level, class Make>
large_faces(const Level& coarse, const Make&)
    -> large_faces<decltype(std::declval<const Make&>()(coarse.faces()[0], std::size_t()))>;

/// How many corners lie between the first one of its face and this one. Cost: O(1).
template <corner_element Corner>
[[nodiscard]] std::int64_t step_in_face(const Corner& c)
{
    return std::int64_t(c.index() - c.f().first_corner().index());
}

} // namespace kith
