// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#ifdef KITH_HAS_BODIES

namespace kith::detail {

/// A side of a face from one corner to the next, with the two ends of its edge.
struct face_side {
    std::size_t low, high, corner;

    friend auto operator<=>(const face_side&, const face_side&) = default;
};

/// The sides of all faces, sorted by their edges. The sides of an edge are in the order of their corners.
class sides_by_edge {
public:
    explicit sides_by_edge(const face_list& faces) : face_of_(faces.vertices.size()), faces_(faces)
    {
        sides_.reserve(faces.vertices.size());
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (std::size_t c = faces.first[f]; c < faces.first[f + 1]; ++c) {
                face_of_[c] = f;
                const auto [low, high] = std::minmax({faces.vertices[c], faces.vertices[next(c)]});
                sides_.push_back({low, high, c});
            }
        std::ranges::sort(sides_);
    }

    [[nodiscard]] std::size_t face_of(std::size_t corner) const { return face_of_[corner]; }
    [[nodiscard]] std::size_t vertex_of(std::size_t corner) const { return faces_.vertices[corner]; }
    [[nodiscard]] std::size_t next(std::size_t corner) const
    {
        const std::size_t f = face_of_[corner];
        return corner + 1 == faces_.first[f + 1] ? faces_.first[f] : corner + 1;
    }
    [[nodiscard]] std::size_t prev(std::size_t corner) const
    {
        const std::size_t f = face_of_[corner];
        return corner == faces_.first[f] ? faces_.first[f + 1] - 1 : corner - 1;
    }
    /// Returns true if a side leads to the larger end of its edge.
    [[nodiscard]] bool is_forward(const face_side& side) const { return faces_.vertices[side.corner] == side.low; }
    [[nodiscard]] bool agree(std::span<const face_side> two) const { return is_forward(two[0]) != is_forward(two[1]); }

    /// Calls f(sides) for each edge.
    template <class F>
    void for_each_edge(const F& f) const
    {
        for (auto run = sides_.begin(); run != sides_.end();) {
            const auto end = std::find_if(
                run, sides_.end(), [&](const auto& s) { return s.low != run->low or s.high != run->high; });
            f(std::span<const face_side>(run, end));
            run = end;
        }
    }
    /// Returns the pairs of faces at all edges that have exactly two sides, of different faces.
    [[nodiscard]] std::vector<face_pair> pairs() const
    {
        std::vector<face_pair> result;
        for_each_edge([&](std::span<const face_side> at) {
            if (at.size() == 2 and face_of(at[0].corner) != face_of(at[1].corner))
                result.push_back({face_of(at[0].corner), face_of(at[1].corner), not agree(at)});
        });
        return result;
    }

    /// Returns for each corner the corner across the side after it. It is `none` at the boundary and at edges that have
    /// to be cut. An edge is cut if it has more than two sides, two sides of one face, or two that run in the same
    /// direction. Calls cut(sides) for each of these edges.
    template <class Cut>
    [[nodiscard]] std::vector<std::size_t> across(const Cut& cut) const
    {
        std::vector<std::size_t> result(face_of_.size(), none);
        for_each_edge([&](std::span<const face_side> at) {
            if (at.size() == 2 and agree(at) and face_of(at[0].corner) != face_of(at[1].corner)) {
                result[at[0].corner] = at[1].corner;
                result[at[1].corner] = at[0].corner;
            } else if (at.size() > 1) {
                cut(at);
            }
        });
        return result;
    }

    static constexpr std::size_t none = std::size_t(-1);

private:
    std::vector<std::size_t> face_of_;
    const face_list& faces_;
    std::vector<face_side> sides_;
};

} // namespace kith::detail

#endif
