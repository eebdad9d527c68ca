// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_walk.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/numbering/association/columns.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>

namespace kith {

/// An element of a neighbourhood: the vertex of a corner, its edge, its face, the first corner of that.
struct walked_element {
    tuple_kind kind; ///< v, e, f or vf
    walked_corner at;
};

/// Finds elements of alike neighbourhoods around up to `AtOnce` faces: step by step around all of them, so that what
/// one waits for from the memory, the others do, too.
template <std::unsigned_integral Index, std::size_t AtOnce>
class element_finder {
public:
    /// In a mesh that has its edges and outlives this.
    explicit element_finder(const connectivity<Index>& mesh) : mesh_(&mesh) {}

    /// Precondition: these steps can be made around each of the faces. Cost: O(steps * AtOnce).
    void walk(std::span<const walk_step> steps, std::span<const Index> faces)
    {
        ensure_size(first_corners_, (steps.size() + 1) * AtOnce);
        Index* to = first_corners_.data();
        for (std::size_t i = 0; i < AtOnce; ++i) // where there are fewer faces the first stands for them
            to[i] = mesh_->first_corner(faces[i < faces.size() ? i : 0]);
        count_ = faces.size();
        for (const walk_step& step : steps) {
            to += AtOnce;
            for (std::size_t i = 0; i < count_; ++i)
                to[i] = Index(mesh_->across(corner(step.from, i)) - step.rotation);
            std::fill(to + count_, to + AtOnce, to[0]);
        }
    }
    /// The numbers of an element around each of the faces walked around last, `AtOnce` of them.
    void find(const walked_element& element, Index* to) const
    {
        const auto at_each = [&](const auto& number) {
            for (std::size_t i = 0; i < AtOnce; ++i)
                to[i] = number(corner(element.at, i));
        };
        switch (element.kind) {
        case tuple_kind::v: return at_each([&](Index c) { return mesh_->corner_vertex[c]; });
        case tuple_kind::e: return at_each([&](Index c) { return Index(mesh_->corner_halfedge[c] / 2); });
        case tuple_kind::f: return at_each([&](Index c) { return mesh_->face_of(c); });
        default: return at_each([&](Index c) { return Index(c - element.at.corner); });
        }
    }

private:
    [[nodiscard]] Index corner(const walked_corner& c, std::size_t i) const
    {
        return Index(first_corners_[AtOnce * c.face + i] + c.corner);
    }

    const connectivity<Index>* mesh_;
    storage<Index> first_corners_; // of the faces of the neighbourhoods, in the order of the walk
    std::size_t count_ = 0;
};

} // namespace kith
