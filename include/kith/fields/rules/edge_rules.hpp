// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "inherit.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/numbering/step/children.hpp>

#include <cstddef>
#include <functional>
#include <span>

namespace kith {

namespace detail {

/// Returns true if a vertex of the next level was made on an edge: by the edge, by one of its ends, or by both.
template <finished_step Step, edge_element Edge>
bool is_born_on(const Step& step, std::size_t vertex, const Edge& e)
{
    if (vertex >= step.ids.vertices.total())
        return false; // of the dictionary
    const auto [kind, tuple] = step.ids.vertices.origin(vertex);
    if (kind == tuple_kind::v)
        return tuple == e.org().index() or tuple == e.dst().index();
    return parent_kind(kind) == element_kind::edge and parent(step.coarse, kind, tuple) == e.index();
}

} // namespace detail

/// The rule of values on edges (sharpness, features, tags). A new edge both of whose ends lie on an old edge inherits
/// from it, by `inherit(value)`. All others have `born`: a value, or a function of (const auto& element, values). The
/// element is the vertex, edge, face or corner that made the new edge. The functions may be called on several threads.
template <class Inherit = std::identity, class Born = no_value>
struct along_edges {
    [[no_unique_address]] Inherit inherit{};
    [[no_unique_address]] Born born{};

    template <class T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        static_assert(
            Step::numbering_type::has_edges,
            "values on edges need a scheme that says which edges it makes: let its columns declare new_edges");
        const auto fine = step.fine();
        if (fine.edge_count() != step.ids.edges.total())
            throw mesh_error("a field has values on edges, and the next level is made without its edges; ask for "
                             "connect::everything");
        storage<T> result(step.ids.edges.total());
        detail::inherit_values<element_kind::edge>(result, values, *this, step, [&](std::size_t id, std::size_t old) {
            const auto e = step.coarse.edges()[old];
            return detail::is_born_on(step, fine.edges()[id].org().index(), e) and
                   detail::is_born_on(step, fine.edges()[id].dst().index(), e);
        });
        return result;
    }
};

} // namespace kith
