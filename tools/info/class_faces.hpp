// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vertex_classes.hpp"

#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::tool {

/// Rotates a cycle to the rotation that is lexicographically smallest.
template <class T>
void turn_to_least(std::span<T> cycle)
{
    const std::size_t n = cycle.size();
    std::size_t best = 0;
    for (std::size_t start = 1; start < n; ++start)
        for (std::size_t i = 0; i < n; ++i) {
            const T x = cycle[(start + i) % n], y = cycle[(best + i) % n];
            if (x < y)
                best = start;
            if (x != y)
                break;
        }
    std::ranges::rotate(cycle, cycle.begin() + std::ptrdiff_t(best));
}

/// The faces of a mesh as cycles of vertex classes. They are found by their smallest class.
class class_faces {
public:
    using id = vertex_classes::id;

    class_faces(const face_list& faces, const std::vector<id>& class_of, std::size_t classes)
        : first_(&faces.first), begin_(classes + 2, 0)
    {
        corners_.reserve(faces.vertices.size());
        for (const std::size_t v : faces.vertices)
            corners_.push_back(class_of[v]);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            turn_to_least(std::span(corners_).subspan(faces.first[f], faces[f].size()));
            ++begin_[bucket(f) + 1];
        }
        for (std::size_t c = 1; c < begin_.size(); ++c)
            begin_[c] += begin_[c - 1];
        order_.resize(faces.size());
        std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
        for (std::size_t f = 0; f < faces.size(); ++f)
            order_[end[bucket(f)]++] = f;
        for (std::size_t c = 0; c < buckets(); ++c)
            std::sort(order_.begin() + std::ptrdiff_t(begin_[c]),
                      order_.begin() + std::ptrdiff_t(begin_[c + 1]),
                      [this](std::size_t f, std::size_t g) { return less((*this)[f], (*this)[g]); });
    }

    [[nodiscard]] std::span<const id> operator[](std::size_t face) const
    {
        return std::span(corners_).subspan((*first_)[face], (*first_)[face + 1] - (*first_)[face]);
    }

    /// Returns the number of faces of either mesh that have no partner in the other.
    friend std::size_t count_unmatched(const class_faces& a, const class_faces& b)
    {
        std::size_t result = 0;
        for (std::size_t c = 0; c < a.buckets(); ++c) {
            const auto in_a = a.in_bucket(c), in_b = b.in_bucket(c);
            std::size_t i = 0, j = 0;
            while (i < in_a.size() and j < in_b.size()) {
                const auto f = a[in_a[i]], g = b[in_b[j]];
                const bool f_first = less(f, g), g_first = less(g, f);
                result += f_first or g_first;
                i += not g_first;
                j += not f_first;
            }
            result += in_a.size() - i + in_b.size() - j;
        }
        return result;
    }

private:
    [[nodiscard]] std::size_t buckets() const { return begin_.size() - 1; }
    /// Returns the bucket of a face: its smallest class, or the last bucket for a face without corners.
    [[nodiscard]] std::size_t bucket(std::size_t face) const
    {
        return (*this)[face].empty() ? buckets() - 1 : (*this)[face][0];
    }
    [[nodiscard]] std::span<const std::size_t> in_bucket(std::size_t c) const
    {
        return std::span(order_).subspan(begin_[c], begin_[c + 1] - begin_[c]);
    }
    [[nodiscard]] static bool less(std::span<const id> f, std::span<const id> g)
    {
        return std::ranges::lexicographical_compare(f, g);
    }

    const std::vector<std::size_t>* first_;
    std::vector<id> corners_;
    std::vector<std::size_t> begin_; // by class: its faces in `order_`
    std::vector<std::size_t> order_;
};

} // namespace kith::tool
