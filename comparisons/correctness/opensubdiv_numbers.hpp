// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peers/opensubdiv_peer.hpp"

#include <kith/hierarchy.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace kith::comparison {

/// The numbers that OpenSubdiv gives to the elements of a hierarchy, one level after the other.
template <class Scheme>
class opensubdiv_numbers {
public:
    using levels_type = hierarchy<basic_mesh<>, Scheme>;
    using level_type = level_of<basic_mesh<>>;

    /// Begins with the control mesh. Both hierarchies must outlive this object and be refined alike.
    opensubdiv_numbers(const levels_type& ours, const opensubdiv_peer::mesh& theirs)
        : ours_(ours), theirs_(*theirs), vertices_(ours[0].vertex_count())
    {
        for (std::size_t v = 0; v < vertices_.size(); ++v)
            vertices_[v] = int(v);
    }

    [[nodiscard]] int level() const { return level_; }
    [[nodiscard]] const level_type& elements() const { return ours_.elements(level_); }
    [[nodiscard]] auto their_level() const { return theirs_.GetLevel(level_); }
    [[noreturn]] void fail(const std::string& what) const
    {
        throw std::runtime_error("level " + std::to_string(level_) + ": " + what);
    }

    [[nodiscard]] int of(const vertex<level_type>& v) const { return vertices_[v.index()]; }
    [[nodiscard]] int of(const edge<level_type>& e) const { return their_level().FindEdge(of(e.org()), of(e.dst())); }
    [[nodiscard]] int of(const face<level_type>& f) const
    {
        std::vector<int> vertices;
        for (const auto v : f.vertices())
            vertices.push_back(of(v));
        const auto found = their_level().GetVertexFaces(vertices[0]);
        for (int i = 0; i < found.size(); ++i) {
            const auto theirs = their_level().GetFaceVertices(found[i]);
            if (std::is_permutation(vertices.begin(), vertices.end(), theirs.begin(), theirs.end()))
                return found[i];
        }
        fail("OpenSubdiv has no such face");
    }
    /// Returns OpenSubdiv's number of the vertex that an element makes on the next level.
    [[nodiscard]] int child_of(const vertex<level_type>& v) const { return their_level().GetVertexChildVertex(of(v)); }
    [[nodiscard]] int child_of(const edge<level_type>& e) const { return their_level().GetEdgeChildVertex(of(e)); }
    [[nodiscard]] int child_of(const face<level_type>& f) const { return their_level().GetFaceChildVertex(of(f)); }

    /// Calls f on all elements that make vertices on the next level.
    template <class F>
    void for_parents(const F& f) const
    {
        for (const auto v : elements().vertices())
            f("vertex ", v);
        for (const auto e : elements().edges())
            f("edge ", e);
        if constexpr (not needs_triangles<Scheme>)
            for (const auto face : elements().faces())
                f("face ", face);
    }
    /// Returns kith's number of the vertex that an element makes on the next level.
    template <element Element>
    [[nodiscard]] std::size_t our_child_of(const Element& x) const
    {
        return ours_.assoc(level_, x.handle(), targets::V).value;
    }

    void go_to_next_level()
    {
        std::vector<int> next(ours_[level_ + 1].vertex_count(), -1);
        for_parents([&](const char*, const auto& x) { next[our_child_of(x)] = child_of(x); });
        vertices_ = std::move(next);
        ++level_;
    }

private:
    const levels_type& ours_;
    const OpenSubdiv::Far::TopologyRefiner& theirs_;
    std::vector<int> vertices_;
    int level_ = 0;
};

} // namespace kith::comparison
