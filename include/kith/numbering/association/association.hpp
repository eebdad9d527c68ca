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

// Scheme texts that say `using namespace kith::targets` find these functions for points, too, such as std::array, and
// are told that a mask takes vertices.
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

/// What a tuple is to give birth to: V, E or F.
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

/// The association (tuple, E). A new edge has two sides; an edge that can end up at the boundary must have its face
/// on the left one.
template <mask_evaluator Space, tuple_kind Kind>
class edge_association {
public:
    using index = typename Space::index_type;

    edge_association(Space& space, std::size_t tuple) : space_(&space), tuple_(tuple) {}

    [[nodiscard]] index id() const { return space_->template edge_id<Kind>(tuple_); }
    [[nodiscard]] new_side<index> left() const { return {index(2 * id())}; }
    [[nodiscard]] new_side<index> right() const { return {index(2 * id() + 1)}; }
    /// The side on which a new face lies that runs along a part of `e` on the side from which `e` is seen.
    template <level Level>
    [[nodiscard]] new_side<index> along(const edge<Level>& e) const
    {
        return {index(2 * id() + (e.seen_from().halfedge() & 1))};
    }
    /// Says that this is a mistake.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::edge_that_is_set<(sizeof(Other) > 0)>());
    }

private:
    Space* space_;
    std::size_t tuple_;
};

/// The association (tuple, V): assigned a mask it makes the vertex, read it is the operand of a mask, `>>` starts a
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
    /// Says that this is a mistake.
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
    /// Says at which corner of a new face the fan of this vertex starts, and the side that leaves the vertex there:
    /// what the line of that face says. At the boundary the library turns the fan, it may be left out.
    void starts_at(index corner, new_side<index> side) const { space_->start_fan(id(), corner, side.halfedge); }

private:
    Space* space_;
    std::size_t tuple_;
};

/// The association (tuple, F): assigned the lines of a face it makes the face.
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
    /// Says that this is a mistake, unless polygon() has.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::face_of_other_things<not std::same_as<Other, diagnostics::any_lines>>());
    }
    [[nodiscard]] index id() const { return space_->template face_id<Kind>(tuple_); }
    /// The number of its k-th corner on the new level.
    [[nodiscard]] index corner(std::size_t k) const { return space_->first_corner(id()) + index(k); }

private:
    Space* space_;
    std::size_t tuple_;
};

/// A vertex of the new level that belongs to two elements of one kind, to elements which do not touch, or to a tuple
/// for which the scheme declares no column. Two neighbours are their edge; everything else is kept in a dictionary:
/// general, slower, and not to be written in for_each: what is made there has no order, and so no numbers. Errors:
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
    /// Says that this is a mistake.
    template <class Other>
    void operator=(const Other&) const
    {
        static_cast<void>(diagnostics::vertex_of_other_things<(sizeof(Other) > 0)>());
    }
    /// Remembers a vertex that exists already under this tuple, too. Precondition: the tuple is not in a column.
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

/// In place of an association that is none.
struct any_association : any_mask {
    template <class Other>
    void operator=(const Other&) const
    {
    }
};

} // namespace diagnostics

} // namespace kith
