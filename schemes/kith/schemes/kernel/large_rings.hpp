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

/// The kind of a vertex's fan. A scheme stores it for each vertex before it makes edges and faces, so that none of them
/// counts a fan again.
enum class fan_kind : unsigned char {
    regular,
    irregular, ///< with a row of weights
    large      ///< irregular, with more operands than longest_row
};

/// Returns the kind of an inner vertex whose valence is not the regular one.
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
/// The index of the sums of a large face.
struct large_face {
    std::size_t face, place;
};

} // namespace detail

/// The sums over each large fan (ring_waves), and the places of its corners in it. Large fans are few, so their corners
/// are stored as a sorted list. Cost: O(n log n) for n corners of large fans, and a pass over the kinds of all
/// vertices.
template <class Sums>
class large_fans {
public:
    struct place {
        const Sums& sums;
        std::int64_t step; ///< number of corners from the first one of the fan to this one
    };

    /// Takes a level and the kinds of its vertices, by number; `make(v, n)` sums the fan of a vertex of valence n.
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

    /// Returns the fan of a corner and the place of the corner in it. Precondition: the fan is large. Cost: O(log
    /// corners of large fans).
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

/// The sums over the corners of each large face, from its first corner on. Cost: O(faces + corners of large faces).
template <class Sums>
class large_faces {
public:
    /// Takes a level; `make(f, n)` sums a face of n corners.
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

    /// Returns the sums of a face. Precondition: it has more than longest_row corners. Cost: O(log large faces).
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

/// Returns the number of corners from the first one of its face to this one. Cost: O(1).
template <corner_element Corner>
[[nodiscard]] std::int64_t step_in_face(const Corner& c)
{
    return std::int64_t(c.index() - c.f().first_corner().index());
}

} // namespace kith
