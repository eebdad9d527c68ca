// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_order.hpp"

#include <kith/core/level/native_level.hpp>

#include <concepts>
#include <cstddef>

namespace kith {

/// A native level whose elements have other numbers than their places in its arrays: the numbers of the same elements
/// in another mesh. A step then reads in the order of this mesh and writes the next level of the other mesh. Ranges go
/// by place: `coarse.vertices()[i].index()` need not be i.
template <class Point, std::unsigned_integral Index, int Degree>
class numbered_level : public native_level<Point, Index, Degree> {
    using native = native_level<Point, Index, Degree>;
    static_assert(Degree != 0);

public:
    /// Takes a mesh and the numbers of its elements. Preconditions: those of native_level, and the numbers are of this
    /// mesh. Both must outlive the view.
    numbered_level(const basic_mesh<Point, Index>& mesh, const element_numbers<Index>& numbers)
        : native(mesh), vertices_(numbers.vertices.data()), edges_(numbers.edges.data()), faces_(numbers.faces.data())
    {
    }

    [[nodiscard]] std::size_t index(typename native::vertex_handle v) const { return vertices_[v.value]; }
    [[nodiscard]] std::size_t index(typename native::edge_handle e) const { return edges_[e.value]; }
    [[nodiscard]] std::size_t index(typename native::face_handle f) const { return faces_[f.value]; }
    [[nodiscard]] std::size_t index(typename native::corner_handle c) const
    {
        return std::size_t(Degree) * faces_[c.value / Degree] + c.value % Degree;
    }
    [[nodiscard]] std::size_t halfedge(typename native::corner_handle c) const
    {
        const std::size_t here = native::halfedge(c);
        return 2 * std::size_t(edges_[here / 2]) + here % 2;
    }

private:
    const Index* vertices_;
    const Index* edges_;
    const Index* faces_;
};

} // namespace kith
