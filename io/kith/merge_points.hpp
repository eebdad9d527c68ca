// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon_soup.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith::io {

/// A class that makes triangles with shared vertices of triangles that repeat their points, as STL has them. Points
/// with equal coordinates are the same vertex. Vertices are numbered in the order of their first corners.
class merged_points {
public:
    /// Reserves room for this number of corners; more may come.
    explicit merged_points(std::size_t corners)
    {
        soup_.faces.vertices.reserve(corners);
        grow(std::bit_ceil(std::max<std::size_t>(corners / 4, 64)));
    }

    /// Adds the next corner. Cost: O(1) on average.
    void add(const std::array<double, 3>& point)
    {
        if (2 * soup_.points.size() >= slots_.size())
            grow(2 * slots_.size());
        std::size_t slot = hash(point) & (slots_.size() - 1);
        while (slots_[slot] != none and soup_.points[slots_[slot]] != point)
            slot = (slot + 1) & (slots_.size() - 1);
        if (slots_[slot] == none) {
            slots_[slot] = soup_.points.size();
            soup_.points.push_back(point);
        }
        soup_.faces.vertices.push_back(slots_[slot]);
    }
    /// Returns the triangles, of three corners each; the object is empty then.
    [[nodiscard]] polygon_soup triangles()
    {
        soup_.faces.first.resize(soup_.faces.vertices.size() / 3 + 1);
        for (std::size_t f = 0; f < soup_.faces.first.size(); ++f)
            soup_.faces.first[f] = 3 * f;
        return std::move(soup_);
    }

private:
    static constexpr std::size_t none = std::size_t(-1);

    static std::size_t hash(const std::array<double, 3>& point)
    {
        std::uint64_t result = 0;
        for (const double x : point) { // x + 0 makes 0 of -0
            result = (result ^ std::bit_cast<std::uint64_t>(x + 0)) * 0x9e3779b97f4a7c15;
            result ^= result >> 32;
        }
        return std::size_t(result);
    }
    void grow(std::size_t size)
    {
        slots_.assign(size, none);
        for (std::size_t v = 0; v < soup_.points.size(); ++v) {
            std::size_t slot = hash(soup_.points[v]) & (size - 1);
            while (slots_[slot] != none)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = v;
        }
    }

    polygon_soup soup_;
    std::vector<std::size_t> slots_; ///< open addressing; never more than half full
};

} // namespace kith::io
