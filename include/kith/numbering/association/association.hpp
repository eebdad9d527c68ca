// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tuples.hpp"

#include <kith/core/base/diagnostics.hpp>
#include <kith/core/mesh/level_sink.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace kith {

/// The kinds of elements an association leads to: assoc(f, V) is a vertex of the next level.
namespace targets {
struct to_vertex {};
struct to_edge {};
struct to_face {};
inline constexpr to_vertex V{};
inline constexpr to_edge E{};
inline constexpr to_face F{};

// Schemes that say `using namespace kith::targets` find these functions for points, too, such as std::array. The error
// message then says that a mask takes vertices.
using kith::average;
using kith::sum;
template <diagnostics::point_without_sum Point>
[[nodiscard]] auto operator+(const Point&, const Point&)
{
    static_cast<void>(diagnostics::points_in_a_mask<(sizeof(Point) > 0)>());
    return diagnostics::any_mask();
}
template <class Weight, diagnostics::point_without_sum Point>
    requires std::is_arithmetic_v<Weight>
[[nodiscard]] auto operator*(const Weight&, const Point&)
{
    static_cast<void>(diagnostics::points_in_a_mask<(sizeof(Point) > 0)>());
    return diagnostics::any_mask();
}
} // namespace targets

/// The kind of element that a tuple makes: V, E or F.
template <class T>
concept target = std::same_as<T, targets::to_vertex> or std::same_as<T, targets::to_edge> or
                 std::same_as<T, targets::to_face>;

/// One side of a new edge, as a half-edge number of the new level.
template <std::unsigned_integral Index>
struct new_side {
    Index halfedge;
};

/// A vertex of the new level, as the start of a line of a face.
template <std::unsigned_integral Index>
struct new_vertex {
    Index id;

    [[nodiscard]] face_line<Index> operator>>(new_side<Index> side) const { return {id, side.halfedge}; }
};

/// The association (tuple, E). A new edge has two sides. An edge that can end up at the boundary must have its face on
/// the left side.
template <mask_evaluator Space, tuple_kind Kind>
class edge_association {
public:
    using index = typename Space::index_type;

    edge_association(Space& space, std::size_t tuple) : space_(&space), tuple_(tuple) {}

    [[nodiscard]] index id() const { return space_->template edge_id<Kind>(tuple_); }
    [[nodiscard]] new_side<index> left() const { return {index(2 * id())}; }
    [[nodiscard]] new_side<index> right() const { return {index(2 * id() + 1)}; }
    /// Returns the side for a new face that runs along a part of `e`, on the side from which `e` is seen.
    template <level Level>
    [[nodiscard]] new_side<index> along(const edge<Level>& e) const
    {
        return {index(2 * id() + (e.seen_from().halfedge() & 1))};
    }
    /// Reports while compiling that an edge is not assigned.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::edge_that_is_set<(sizeof(Other) > 0)>());
    }

private:
    Space* space_;
    std::size_t tuple_;
};

/// The association (tuple, V). Assigning a mask to it makes the vertex. In a mask it is an operand, and `>>` starts a
/// line of a new face with it.
template <mask_evaluator Space, tuple_kind Kind>
class vertex_association : public mask_base {
public:
    using index = typename Space::index_type;

    vertex_association(Space& space, std::size_t tuple) : space_(&space), tuple_(tuple) {}
    vertex_association(const vertex_association&) = default;

    template <mask Mask>
    void operator=(const Mask& mask) const
    {
        space_->template make_vertex<Kind>(tuple_, mask);
    }
    void operator=(const vertex_association& other) const { space_->template make_vertex<Kind>(tuple_, other); }
    /// Reports while compiling that a vertex is assigned a mask only.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::vertex_of_other_things<(sizeof(Other) > 0)>());
    }

    [[nodiscard]] index id() const { return space_->template vertex_id<Kind>(tuple_); }
    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values&) const
    {
        return space_->template vertex_value<Kind>(tuple_);
    }
    [[nodiscard]] new_vertex<index> vertex() const { return {id()}; }
    [[nodiscard]] face_line<index> operator>>(new_side<index> side) const { return vertex() >> side; }
    operator face_line<index>() const { return {id(), Space::none}; }
    /// Sets the start of the fan of this vertex: a corner of a new face, and the side that leaves the vertex there, as
    /// in the line of that face. A scheme may leave it out at the boundary, where the library turns the fan.
    void starts_at(index corner, new_side<index> side) const { space_->start_fan(id(), corner, side.halfedge); }

private:
    Space* space_;
    std::size_t tuple_;
};

/// The association (tuple, F). Assigning the lines of a face to it makes the face.
template <mask_evaluator Space, tuple_kind Kind>
class face_association {
public:
    using index = typename Space::index_type;

    face_association(Space& space, std::size_t tuple) : space_(&space), tuple_(tuple) {}

    template <face_sides Lines>
    void operator=(const Lines& lines) const
    {
        space_->template make_face<Kind>(tuple_, lines);
    }
    /// Reports while compiling that a face is assigned its lines only, unless polygon() has reported an error.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::face_of_other_things<not std::same_as<Other, diagnostics::any_lines>>());
    }
    [[nodiscard]] index id() const { return space_->template face_id<Kind>(tuple_); }
    /// Returns the number of the k-th corner of this face on the new level.
    [[nodiscard]] index corner(std::size_t k) const { return space_->first_corner(id()) + index(k); }

private:
    Space* space_;
    std::size_t tuple_;
};

/// A vertex of the new level under a tuple of two elements of one kind, of elements that do not touch, or without a
/// column. Two neighbours count as their edge; all other tuples are kept in a dictionary, which is general and slower.
/// Such vertices must not be made in for_each, whose order is undefined: their numbers follow from that order. Errors:
/// association_error.
template <mask_evaluator Space>
class dictionary_association : public mask_base {
public:
    using index = typename Space::index_type;
    static constexpr std::size_t no_edge = tuple_index<tuple_kind::e>::not_incident;

    dictionary_association(Space& space, tuple_elements tuple, std::size_t edge)
        : space_(&space), tuple_(std::move(tuple)), edge_(edge)
    {
    }
    dictionary_association(const dictionary_association&) = default;

    template <mask Mask>
    void operator=(const Mask& mask) const
    {
        if constexpr (has_edge_column)
            if (edge_ != no_edge)
                return space_->template make_vertex<tuple_kind::e>(edge_, mask);
        space_->make_listed_vertex(tuple_, mask);
    }
    void operator=(const dictionary_association& other) const { operator= <dictionary_association>(other); }
    /// Reports while compiling that a vertex is assigned a mask only.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::vertex_of_other_things<(sizeof(Other) > 0)>());
    }
    /// Names an existing vertex by this tuple, too. Precondition: the tuple is not in a column.
    template <class Association>
    void refers_to(const Association& other) const
    {
        space_->dictionary_.add_name(tuple_, other.id());
    }
    [[nodiscard]] index id() const
    {
        if constexpr (has_edge_column)
            if (edge_ != no_edge)
                return space_->template vertex_id<tuple_kind::e>(edge_);
        return space_->dictionary_.at(tuple_);
    }
    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values&) const
    {
        if constexpr (has_edge_column)
            if (edge_ != no_edge)
                return space_->template vertex_value<tuple_kind::e>(edge_);
        return space_->listed_value(tuple_);
    }
    operator face_line<index>() const { return {id(), Space::none}; }

private:
    static constexpr bool has_edge_column = Space::template has_vertices<tuple_kind::e>;

    Space* space_;
    tuple_elements tuple_;
    std::size_t edge_;
};

namespace diagnostics {

/// A stand-in for an association that does not exist; anything can be assigned to it.
struct any_association : any_mask {
    template <class Other>
    void operator=(const Other&) const
    {
    }
};

} // namespace diagnostics

} // namespace kith
