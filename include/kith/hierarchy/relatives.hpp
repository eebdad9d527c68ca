// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parent_of.hpp"

#include <kith/core/mesh/mesh_traits.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace kith {

/// A vertex, an edge and a face of a mesh, each of which may be unset.
template <mesh M>
struct some_elements {
    std::optional<typename mesh_traits<M>::vertex> v{};
    std::optional<typename mesh_traits<M>::edge> e{};
    std::optional<typename mesh_traits<M>::face> f{};

    friend bool operator==(const some_elements&, const some_elements&) = default;
};

/// The elements of the next coarser level that made an element. The elements of its tuple are set.
template <mesh M>
struct birth : some_elements<M> {
    std::optional<tuple_kind> kind{}; ///< nothing for a vertex of the dictionary, whose tuple is in no column
    std::optional<typename mesh_traits<M>::vertex> other_v{}; ///< the second of two vertices that do not touch
    std::optional<typename mesh_traits<M>::face> other_f{};   ///< the second of two faces that do not touch
};

/// The element of a level from which another one descends. It may be of any kind: only the member of its kind is set.
template <mesh M>
struct ancestor_element : some_elements<M> {
    element_kind kind;

    /// Takes the element with this kind and number on a level of M.
    template <level Level>
    ancestor_element(const Level& level, const numbered_element& x) : kind(x.kind)
    {
        switch (kind) {
        case element_kind::vertex: this->v = level.vertex_at(x.number); break;
        case element_kind::edge: this->e = level.edge_at(x.number); break;
        case element_kind::face: this->f = level.face_at(x.number); break;
        }
    }
    friend bool operator==(const ancestor_element&, const ancestor_element&) = default;
};

/// Returns the elements that made an element of the next level. For an edge that was found by matching, it is a single
/// element, as (v), (e) or (f). This lies between the parents of the ends of the edge, or is what parent_of returns.
/// Cost: that of parent_of.
template <mesh M, level Level, level_numbering Numbering, level Fine, element X>
birth<M> birth_of(const Level& coarse, const Numbering& ids, const Fine& fine, const X& x)
{
    const auto from_elements = [&](std::optional<tuple_kind> kind, const tuple_elements& tuple) {
        birth<M> result{{}, kind};
        for (const auto& [letter, number] : tuple) {
            if (letter == 'v')
                (result.v ? result.other_v : result.v) = coarse.vertex_at(number);
            else if (letter == 'e')
                result.e = coarse.edge_at(number);
            else
                (result.f ? result.other_f : result.f) = coarse.face_at(number);
        }
        return result;
    };
    const auto from_tuple = [&](const auto& of_kind) {
        const auto [kind, index] = of_kind.origin(x.index());
        return from_elements(kind, list_tuple(coarse, kind, index));
    };
    if constexpr (element_letter<X> == 'v') {
        const std::size_t total = ids.vertices.total();
        return x.index() < total ? from_tuple(ids.vertices)
                                 : from_elements({}, ids.dictionary.tuple_of(x.index() - total));
    } else if constexpr (element_letter<X> == 'f') {
        return from_tuple(ids.faces);
    } else if constexpr (Numbering::has_edges) {
        return from_tuple(ids.edges);
    } else {
        const ancestor_element<M> from(coarse, parent_of(coarse, ids, fine, numbered(x)));
        return birth<M>{from, from.v ? tuple_kind::v : from.e ? tuple_kind::e : tuple_kind::f};
    }
}

/// The elements of a level that descend from an element of a coarser level, as ranges of numbers and as handles of the
/// mesh. The object may be used as long as the hierarchy has this level.
template <level Level>
class descendant_elements {
public:
    descendant_elements(const Level& level, element_ranges numbers) : level_(&level), numbers_(std::move(numbers)) {}

    /// Returns increasing ranges of dense numbers, by which `elements(level)` counts.
    [[nodiscard]] const element_ranges& numbers() const { return numbers_; }
    /// Returns the handles of the vertices. Cost: O(their number).
    [[nodiscard]] auto vertices() const
    {
        return handles(numbers_.vertices, [this](std::size_t i) { return level_->vertex_at(i); });
    }
    [[nodiscard]] auto edges() const
    {
        return handles(numbers_.edges, [this](std::size_t i) { return level_->edge_at(i); });
    }
    [[nodiscard]] auto faces() const
    {
        return handles(numbers_.faces, [this](std::size_t i) { return level_->face_at(i); });
    }

private:
    template <class At>
    static auto handles(const std::vector<number_range>& ranges, const At& at)
    {
        std::vector<decltype(at(0))> result;
        for (const auto& [begin, end] : ranges)
            for (std::size_t i = begin; i < end; ++i)
                result.push_back(at(i));
        return result;
    }

    const Level* level_;
    element_ranges numbers_;
};

} // namespace kith
