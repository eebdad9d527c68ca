// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "edge_rules.hpp"
#include "inherit.hpp"
#include "linear_masks.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/numbering/association/tuples.hpp>
#include <kith/numbering/step/children.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

/// The values at the corners of a level, extended linearly to the tuples of its elements.
template <class T, finished_step Step>
class linear_in_level {
    using masks = linear_masks_of<T, std::remove_cvref_t<decltype(std::declval<const Step&>().ids.vertices)>>;

public:
    linear_in_level(std::span<const T> values, const Step& step)
        : values_(values), step_(step), means_(level().face_count())
    {
        for_parts(means_.size(), level().parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f)
                means_[f] = masks::mean(step_, level().faces()[f], [&](const auto& c) { return values_[c.index()]; });
        });
    }

    /// Returns the value at a new vertex as a corner of a new face. Both are given by the tuples that made them.
    [[nodiscard]] T at(std::pair<tuple_kind, std::size_t> face, std::pair<tuple_kind, std::size_t> vertex) const
    {
        const std::size_t i = vertex.second;
        switch (vertex.first) {
        case tuple_kind::v: return at_vertex(face, level().vertices()[i]);
        case tuple_kind::e: {
            const auto e = level().edges()[i];
            return of_edge(face, e, [&](const auto& c) { return masks::middle(here(c), here(c.next())); });
        }
        case tuple_kind::ve: {
            const auto e = level().edges()[i / 2];
            return of_edge(face, e, [&](const auto& c) { // from org to dst on the left, back on the right
                const bool starts_here = (c == e.lcorner()) == (i % 2 == 0);
                return starts_here ? masks::third(here(c), here(c.next())) : masks::third(here(c.next()), here(c));
            });
        }
        case tuple_kind::f: return means_[i];
        case tuple_kind::vf: {
            const auto c = level().corners()[i];
            return masks::in_face(here(c), mean(c));
        }
        case tuple_kind::ef: {
            const auto c = level().corners()[i];
            return masks::middle(masks::middle(here(c), here(c.next())), mean(c));
        }
        case tuple_kind::vfe: break;
        }
        const auto c = level().corners()[i / 2];
        return masks::of_three(here(c), masks::middle(here(c), here(i % 2 == 0 ? c.next() : c.prev())), mean(c));
    }
    /// Returns the value in the same way if the tuple of the vertex is in no column.
    [[nodiscard]] T at(std::pair<tuple_kind, std::size_t> face, const tuple_elements& vertex) const
    {
        return mean_of_tuple<T>(
            vertex,
            [&](std::size_t v) { return at_vertex(face, level().vertices()[v]); },
            [&](std::size_t e) { return at(face, std::pair(tuple_kind::e, e)); },
            [&](std::size_t f) { return means_[f]; });
    }

private:
    [[nodiscard]] const auto& level() const { return step_.coarse; }
    template <corner_element Corner>
    [[nodiscard]] const T& here(const Corner& c) const
    {
        return values_[c.index()];
    }
    template <corner_element Corner>
    [[nodiscard]] const T& mean(const Corner& c) const
    {
        return means_[c.f().index()];
    }
    /// Returns the value on a side of an edge that lies in the parent of the new face. If there is none, returns the
    /// mean over all its sides.
    template <edge_element Edge, class F>
    [[nodiscard]] T of_edge(std::pair<tuple_kind, std::size_t> face, const Edge& e, const F& in_face) const
    {
        const auto left = e.lcorner();
        if (e.is_boundary() or is_parent(face, left.f()))
            return in_face(left);
        const auto right = e.rcorner();
        if (is_parent(face, right.f()))
            return in_face(right);
        return masks::middle(in_face(left), in_face(right));
    }
    /// Returns the value at a vertex in the face that is the parent of the new face. If the parent is an edge of the
    /// vertex, returns the mean over the faces of that edge. In all other cases, returns the mean over all faces around
    /// the vertex.
    template <vertex_element Vertex>
    [[nodiscard]] T at_vertex(std::pair<tuple_kind, std::size_t> face, const Vertex& v) const
    {
        const auto [kind, i] = face;
        constexpr std::size_t none = tuple_index<tuple_kind::vf>::not_incident;
        if (kind == tuple_kind::vf and level().corners()[i].v() == v)
            return values_[i];
        const std::size_t from = parent(level(), kind, i);
        if (parent_kind(kind) == element_kind::edge) {
            const auto e = level().edges()[from];
            const auto here_in = [&](const auto& c) { return here(c.v() == v ? c : c.next()); };
            if (e.org() == v or e.dst() == v)
                return e.is_boundary() ? here_in(e.lcorner())
                                       : masks::middle(here_in(e.lcorner()), here_in(e.rcorner()));
        } else if (parent_kind(kind) == element_kind::face) {
            if (const std::size_t corner = index_tuple(v, level().faces()[from]).value; corner != none)
                return values_[corner];
        }
        const auto corners = v.corners();
        auto c = corners.begin();
        blend<T> sum(here(*c));
        std::size_t count = 1;
        for (++c; not(c == corners.end()); ++c, ++count)
            sum.add(here(*c));
        return sum.over(count);
    }
    template <face_element Face>
    [[nodiscard]] bool is_parent(std::pair<tuple_kind, std::size_t> face, const Face& f) const
    {
        if (parent_kind(face.first) != element_kind::face)
            return false;
        const std::size_t from = parent(level(), face.first, face.second);
        if constexpr (has_closure<Step>)
            if (closure_of(step_).is_pair(level().faces()[from], f))
                return true;
        return from == f.index();
    }

    std::span<const T> values_;
    const Step& step_;
    storage<T> means_;
};

} // namespace detail

/// The rule of values at corners that are linear inside each face, which OpenSubdiv calls "linear all". Such values are
/// texture coordinates, and all else that differs from face to face at a vertex. If the values of two faces differ
/// along their edge, there is a seam, and it stays. A new vertex, as a corner of a new face, has the mean of the
/// elements of its tuple in one old face. This is the face in the tuple of the vertex or, if it has none, the old face
/// from which the new face comes. If there is neither, it has the mean over the old faces at its edge or vertex.
/// Cost: O(corners).
struct linear_in_faces {
    static constexpr bool is_linear_in_faces() { return true; }

    template <affine_value T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        const detail::linear_in_level<T, Step> linear(values, step);
        const auto fine = step.fine();
        storage<T> result(fine.corner_count());
        detail::for_new_corners(fine, step.ids, [&](const auto& c, const auto& face) {
            const std::size_t v = c.v().index(), listed = step.ids.vertices.total();
            result[c.index()] = v < listed ? linear.at(face, step.ids.vertices.origin(v))
                                           : linear.at(face, step.ids.dictionary.tuple_of(v - listed));
        });
        return result;
    }
};

/// The rule of marks on the sides of faces, as half-edges of CGAL and OpenMesh have them. A corner has the mark of the
/// side that leads to it. A new side inherits the mark if it lies along a side of the face from which its own face
/// comes. All others have T(), or zero if T() is uninitialized.
/// Cost: O(corners) for faces of bounded degree.
struct along_sides {
    template <class T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        const auto fine = step.fine();
        storage<T> result(fine.corner_count());
        detail::for_new_corners(fine, step.ids, [&](const auto& c, const auto& face) {
            result[c.index()] = detail::value_of_nothing<T>();
            if (parent_kind(face.first) != element_kind::face)
                return;
            const std::size_t from = c.prev().v().index(), to = c.v().index();
            for (const auto old : step.coarse.faces()[parent(step.coarse, face.first, face.second)].corners())
                if (detail::is_born_on(step, from, old.prev_edge()) and detail::is_born_on(step, to, old.prev_edge()))
                    result[c.index()] = values[old.index()];
        });
        return result;
    }
};

} // namespace kith
