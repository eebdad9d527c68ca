// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// An axis-aligned box.
struct space_box {
    std::array<double, 3> least, most;

    /// Returns the smallest box of some points. Precondition: there is at least one.
    static space_box of(std::span<const std::array<double, 3>> points)
    {
        space_box result{points[0], points[0]};
        for (const auto& p : points.subspan(1))
            result.add({p, p});
        return result;
    }
    /// Grows the box so that it contains another one.
    void add(const space_box& more)
    {
        for (std::size_t x = 0; x < 3; ++x) {
            least[x] = std::min(least[x], more.least[x]);
            most[x] = std::max(most[x], more.most[x]);
        }
    }
    [[nodiscard]] std::array<std::array<double, 3>, 8> corners() const
    {
        std::array<std::array<double, 3>, 8> result;
        for (std::size_t k = 0; k < 8; ++k)
            for (std::size_t x = 0; x < 3; ++x)
                result[k][x] = (k >> x & 1) != 0 ? most[x] : least[x];
        return result;
    }
};

/// A binary tree of boxes (bounding volume hierarchy), halved along the longest extent of their middles. An R-tree of
/// Boost.Geometry 1.74 is no alternative: it sorts all boxes that it has met in each leaf when they are requested one
/// by one.
class box_tree {
public:
    struct node {
        space_box box;
        std::size_t item;      ///< the number of the box in a leaf
        std::size_t first = 0; ///< the children, or 0 in a leaf
        std::size_t second = 0;
    };

    box_tree() = default;
    /// Takes the boxes of the leaves. Cost: O(boxes log boxes).
    explicit box_tree(std::span<const space_box> boxes)
    {
        std::vector<std::size_t> items(boxes.size());
        for (std::size_t i = 0; i < items.size(); ++i)
            items[i] = i;
        nodes_.reserve(2 * items.size());
        if (not items.empty())
            add(boxes, items);
    }
    /// Returns the nodes, the root first.
    [[nodiscard]] const std::vector<node>& nodes() const { return nodes_; }

private:
    std::size_t add(std::span<const space_box> boxes, std::span<std::size_t> items)
    {
        const std::size_t number = nodes_.size();
        nodes_.push_back({boxes[items[0]], items[0]});
        if (items.size() == 1)
            return number;
        const auto twice_middle = [&](std::size_t item, std::size_t x) {
            return boxes[item].least[x] + boxes[item].most[x];
        };
        space_box middles{};
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::array middle{twice_middle(items[i], 0), twice_middle(items[i], 1), twice_middle(items[i], 2)};
            if (i == 0)
                middles = {middle, middle};
            middles.add({middle, middle});
            nodes_[number].box.add(boxes[items[i]]);
        }
        std::size_t axis = 0;
        for (std::size_t x = 1; x < 3; ++x)
            if (middles.most[x] - middles.least[x] > middles.most[axis] - middles.least[axis])
                axis = x;
        const std::size_t half = items.size() / 2;
        std::ranges::nth_element(items, items.begin() + std::ptrdiff_t(half), {}, [&](std::size_t item) {
            return std::pair(twice_middle(item, axis), item);
        });
        const std::size_t first = add(boxes, items.first(half)), second = add(boxes, items.subspan(half));
        nodes_[number].first = first;
        nodes_[number].second = second;
        return number;
    }

    std::vector<node> nodes_;
};

} // namespace kith::detail
