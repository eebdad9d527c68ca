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

/// An element of a neighbourhood, given by a corner: the vertex of the corner, its edge, its face, or the first corner
/// of its face.
struct walked_element {
    tuple_kind kind; ///< v, e, f or vf
    walked_corner at;
};

/// A finder of elements in alike neighbourhoods around up to `AtOnce` faces. It goes step by step around all of them,
/// so that they wait for the memory together.
template <std::unsigned_integral Index, std::size_t AtOnce>
class element_finder {
public:
    /// Takes the connectivity of a mesh that has its edges. It must outlive this.
    explicit element_finder(const connectivity<Index>& mesh) : mesh_(&mesh) {}

    /// Walks around each of the faces by these steps. Precondition: these steps can be made around each of them. Cost:
    /// O(steps * AtOnce).
    void walk(std::span<const walk_step> steps, std::span<const Index> faces)
    {
        ensure_size(first_corners_, (steps.size() + 1) * AtOnce);
        Index* to = first_corners_.data();
        for (std::size_t i = 0; i < AtOnce; ++i) // the first face stands for missing ones
            to[i] = mesh_->first_corner(faces[i < faces.size() ? i : 0]);
        count_ = faces.size();
        for (const walk_step& step : steps) {
            to += AtOnce;
            for (std::size_t i = 0; i < count_; ++i)
                to[i] = Index(mesh_->across(corner(step.from, i)) - step.rotation);
            std::fill(to + count_, to + AtOnce, to[0]);
        }
    }
    /// Writes the numbers of an element around each of the faces of the last walk(), `AtOnce` of them.
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
    storage<Index> first_corners_; // of the walked faces, step by step, `AtOnce` each
    std::size_t count_ = 0;
};

} // namespace kith
