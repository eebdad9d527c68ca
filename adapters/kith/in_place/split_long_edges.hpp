// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_values.hpp"
#include "refine_in_place.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::in_place {

/// A class that splits the longest edge of a triangle mesh in its middle, with the triangles beside it, until all edges
/// are short enough. Of edges of equal length, the edge whose ends have the smaller numbers comes first. Old vertices
/// keep their numbers. For every vertex the class keeps its place in a triangle or an edge of the control mesh, as
/// weights.
template <class Point>
class long_edge_splitter {
    using index = std::uint32_t;
    using scalar = scalar_of<Point>;
    static constexpr index none = no_element;

public:
    /// Takes a mesh and the largest length allowed. Precondition: the mesh has triangles only, and its edges. Errors:
    /// mesh_error unless the length is positive.
    long_edge_splitter(const native_mesh<Point>& control, double length) : control_(&control), most_(length * length)
    {
        if (not(length > 0))
            throw mesh_error("the longest edge allowed has no length; give a length above 0");
        const auto& t = control.topology();
        points_.assign(control.points().begin(), control.points().end());
        for (std::size_t v = 0; v < points_.size(); ++v)
            places_.push_back({{{index(v), 1}, {none, 0}, {none, 0}}});
        for (std::size_t f = 0; f < t.faces; ++f) {
            faces_.push_back({t.corner_vertex[3 * f], t.corner_vertex[3 * f + 1], t.corner_vertex[3 * f + 2]});
            parents_.push_back(index(f));
        }
        for (std::size_t e = 0; e < t.edges(); ++e)
            edges_[key(t.ends(e)[0], t.ends(e)[1])].parent = index(e);
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                join(f, faces_[f][i], faces_[f][(i + 1) % 3]);
        for (const auto& [ends, edge] : edges_)
            push(ends);
    }

    /// Returns true if an edge is longer than allowed.
    [[nodiscard]] bool has_long_edges() const { return not longest_.empty(); }
    /// Splits edges until none is too long, and returns the mesh. Cost: O(log(edges)) per split. Errors: mesh_error for
    /// more vertices than an index can number.
    refined<Point> run()
    {
        while (not longest_.empty()) {
            const auto ends = longest_.top().ends;
            longest_.pop();
            split(ends);
        }
        return {make_mesh(points_, faces_), true};
    }

    /// Carries values to the elements of the split mesh: means by the weights of its vertices, all other values from
    /// the parents.
    template <class Number>
    void carry(const native_mesh<Point>& fine, carried_values<Number>& values) const
    {
        const auto& t = fine.topology();
        const auto& old = control_->topology();
        for (auto& each : values.vertex_means) {
            storage<kith::detail::four_numbers<Number>> means(points_.size());
            for (std::size_t v = 0; v < means.size(); ++v)
                means[v] = mean(places_[v], [&](index from) { return each[from]; });
            each = std::remove_cvref_t<decltype(each)>(means);
        }
        for (auto& each : values.corner_means) {
            storage<kith::detail::four_numbers<Number>> means(t.corners());
            for (std::size_t c = 0; c < means.size(); ++c)
                means[c] = mean(places_[t.corner_vertex[c]],
                                [&](index from) { return each[corner_of(old, parents_[c / 3], from)]; });
            each = std::remove_cvref_t<decltype(each)>(means);
        }
        inherit_from(
            values.vertex_heirs, points_.size(), [&](std::size_t v) { return v < old.vertices ? index(v) : none; });
        inherit_from(
            values.edge_heirs, t.edges(), [&](std::size_t e) { return parent_of(t.ends(e)[0], t.ends(e)[1]); });
        inherit_from(values.face_heirs, t.faces, [&](std::size_t f) { return parents_[f]; });
        inherit_from(values.corner_heirs, t.corners(), [&](std::size_t c) {
            const std::size_t first = c - c % 3;
            const index edge = parent_of(t.corner_vertex[first + (c % 3 + 2) % 3], t.corner_vertex[c]);
            for (std::size_t i = 0; edge != none and i < 3; ++i) // the corner to which the side on this edge leads
                if (old.corner_halfedge[3 * parents_[c / 3] + i] / 2 == edge)
                    return index(3 * parents_[c / 3] + (i + 1) % 3);
            return none;
        });
    }

private:
    using ends_type = std::pair<index, index>;
    struct edge_type {
        index parent = none;
        std::array<index, 2> faces{none, none};
    };
    struct long_edge {
        double length;
        ends_type ends;
        friend bool operator<(const long_edge& a, const long_edge& b)
        {
            return a.length != b.length ? a.length < b.length : a.ends > b.ends;
        }
    };
    /// A place in the control mesh: some of its vertices and their weights.
    using place = std::array<std::pair<index, double>, 3>;

    static ends_type key(index a, index b) { return {std::min(a, b), std::max(a, b)}; }
    index parent_of(index a, index b) const { return edges_.at(key(a, b)).parent; }
    void join(std::size_t face, index a, index b)
    {
        auto& beside = edges_[key(a, b)].faces;
        beside[beside[0] == none ? 0 : 1] = index(face);
    }
    void push(const ends_type& ends)
    {
        double length = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = double(points_[ends.second][i]) - double(points_[ends.first][i]);
            length += d * d;
        }
        if (length > most_)
            longest_.push({length, ends});
    }
    void split(const ends_type& ends)
    {
        const auto [a, b] = ends;
        const edge_type edge = edges_.at(ends);
        edges_.erase(ends);
        if (points_.size() >= none / 8)
            throw mesh_error("edges of this length would be more than can be numbered; allow longer ones");
        const auto middle = index(points_.size());
        Point p = points_[a];
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = scalar(0.5) * (points_[a][i] + points_[b][i]);
        points_.push_back(p);
        places_.push_back(between(places_[a], places_[b]));
        edges_[key(a, middle)].parent = edges_[key(b, middle)].parent = edge.parent;
        for (const index f : edge.faces) {
            if (f == none)
                continue;
            auto& corners = faces_[f];
            std::size_t i = 0; // the corner from which the edge leaves
            while ((corners[i] != a and corners[i] != b) or (corners[(i + 1) % 3] != a and corners[(i + 1) % 3] != b))
                ++i;
            const index from = corners[i], to = corners[(i + 1) % 3], apex = corners[(i + 2) % 3];
            const auto added = index(faces_.size());
            faces_[f] = {from, middle, apex};
            faces_.push_back({middle, to, apex});
            parents_.push_back(parents_[f]);
            auto& beyond = edges_.at(key(to, apex)).faces;
            beyond[beyond[0] == f ? 0 : 1] = added;
            join(f, from, middle), join(f, middle, apex), join(added, middle, to), join(added, middle, apex);
            push(key(middle, apex));
        }
        push(key(a, middle)), push(key(b, middle));
    }
    /// Returns the place in the middle between two places. Precondition: both lie in one triangle of the control mesh.
    static place between(const place& a, const place& b)
    {
        place result{{{none, 0}, {none, 0}, {none, 0}}};
        for (const place* each : {&a, &b})
            for (const auto& [vertex, weight] : *each)
                for (auto& [own, sum] : result)
                    if (vertex != none and (own == vertex or own == none)) {
                        own = vertex;
                        sum += weight / 2;
                        break;
                    }
        return result;
    }
    template <class ValueOf>
    static auto mean(const place& at, const ValueOf& value_of)
    {
        auto result = value_of(at[0].first);
        if (at[1].first == none)
            return result;
        for (auto& x : result)
            x *= at[0].second;
        for (std::size_t i = 1; i < 3 and at[i].first != none; ++i) {
            const auto more = value_of(at[i].first);
            for (std::size_t k = 0; k < result.size(); ++k)
                result[k] += at[i].second * more[k];
        }
        return result;
    }
    static std::size_t corner_of(const connectivity<index>& t, std::size_t face, index vertex)
    {
        for (std::size_t c = 3 * face; c < 3 * face + 2; ++c)
            if (t.corner_vertex[c] == vertex)
                return c;
        return 3 * face + 2;
    }

    const native_mesh<Point>* control_;
    double most_;
    std::vector<Point> points_;
    std::vector<place> places_;
    std::vector<std::array<index, 3>> faces_;
    std::vector<index> parents_;
    std::map<ends_type, edge_type> edges_;
    std::priority_queue<long_edge> longest_;
};

} // namespace kith::in_place
