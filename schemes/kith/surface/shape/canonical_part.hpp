// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::detail {

/// A part of a mesh around a face, with numbers that do not depend on those in the mesh. Faces have the order in which
/// a walk from face 0 reaches them. Each begins at the corner at which the walk enters it, or keeps its first corner.
/// Vertices and edges have the order of their corners.
template <std::unsigned_integral Index, scheme Scheme>
struct canonical_part {
    connectivity<Index> mesh;
    Scheme scheme;                  ///< with the state of the part
    std::vector<Index> corner_from; ///< for each corner its number before
    std::u32string key{};           ///< equal for equal parts; empty if the part keeps the numbers that it had
    Index face = 0;                 ///< the face around which the part lies
};

/// The canonical numbers of a part. Faces may keep their first corners.
template <std::unsigned_integral Index>
class canonical_numbers {
    static constexpr Index none = connectivity<Index>::none;

public:
    canonical_numbers(const connectivity<Index>& part, Index face, bool keeps_first_corners)
        : part_(part)
        , keeps_first_corners_(keeps_first_corners)
        , vertex_(part.vertices, none)
        , edge_(part.edges(), none)
        , side_(part.edges())
        , face_(part.faces, none)
    {
        enter(part.first_corner(face));
        for (std::size_t f = 0; f < entries_.size(); ++f)
            for_corners(f, [&](Index c) {
                number(vertex_, vertex_from_, part.corner_vertex[c]);
                const Index half = part.corner_halfedge[c];
                if (number(edge_, edge_from_, Index(half / 2)))
                    side_[half / 2] = half % 2;
                if (const Index across = part.across(c); across != none and face_[part.face_of(across)] == none)
                    enter(across);
            });
    }

    /// Returns false if the part is not connected by edges: then it has no canonical numbers.
    [[nodiscard]] bool has_all() const { return entries_.size() == part_.faces; }
    /// Returns for each corner of the part, in the new order, its number before.
    [[nodiscard]] std::vector<Index> corner_from() const
    {
        std::vector<Index> result;
        for (std::size_t f = 0; f < entries_.size(); ++f)
            for_corners(f, [&](Index c) { result.push_back(c); });
        return result;
    }

    /// Returns the part in these numbers, and appends a description of it to a key.
    [[nodiscard]] connectivity<Index> connect(std::u32string& key) const
    {
        std::vector<std::size_t> degrees;
        for (const Index entry : entries_)
            degrees.push_back(degree_of(part_.face_of(entry)));
        const bool are_alike = std::ranges::all_of(degrees, [&](std::size_t d) { return d == degrees[0]; });
        connectivity<Index> result;
        result.vertices = vertex_from_.size();
        result.allocate_faces(degrees.size(),
                              are_alike and (degrees[0] == 3 or degrees[0] == 4) ? int(degrees[0]) : 0,
                              [&](std::size_t f) { return degrees[f]; });
        result.allocate_edges(edge_from_.size());
        result.vertex_corner = storage<Index>(result.vertices, none);
        Index corner = 0;
        for (std::size_t f = 0; f < entries_.size(); ++f) {
            key += char32_t(degrees[f]);
            for_corners(f, [&](Index c) {
                const Index half = part_.corner_halfedge[c], v = vertex_[part_.corner_vertex[c]];
                const Index new_half = Index(2 * edge_[half / 2] + (half % 2 == side_[half / 2] ? 0 : 1));
                result.corner_vertex[corner] = v;
                result.set_side(corner, new_half);
                if (result.vertex_corner[v] == none or part_.across(c) == none)
                    result.vertex_corner[v] = corner;
                key += char32_t(v);
                key += char32_t(new_half);
                ++corner;
            });
        }
        return result;
    }
    /// Calls f with the new numbers of the elements of the part.
    template <class F>
    void with_part_numbers(const F& f) const
    {
        f(part_numbers<Index>{vertex_, edge_, face_, std::size_t(part_.degree)});
    }

private:
    [[nodiscard]] std::size_t degree_of(Index face) const
    {
        return std::size_t(part_.first_corner(face + std::size_t(1)) - part_.first_corner(face));
    }
    void enter(Index corner)
    {
        const Index face = part_.face_of(corner);
        face_[face] = Index(entries_.size());
        entries_.push_back(keeps_first_corners_ ? Index(part_.first_corner(face)) : corner);
    }
    /// Calls f for the corners of the f-th face, from its entry on.
    template <class F>
    void for_corners(std::size_t face, const F& f) const
    {
        const Index entry = entries_[face];
        Index c = entry;
        do {
            f(c);
            c = part_.next(c);
        } while (c != entry);
    }
    /// Numbers an element. Returns false if it has a number.
    static bool number(std::vector<Index>& numbers, std::vector<Index>& from, Index element)
    {
        if (numbers[element] != none)
            return false;
        numbers[element] = Index(from.size());
        from.push_back(element);
        return true;
    }

    const connectivity<Index>& part_;
    bool keeps_first_corners_;
    std::vector<Index> vertex_, edge_, side_, face_; // the new numbers, and which side of an edge becomes side 0
    std::vector<Index> entries_;                     // of the faces in the order of the walk
    std::vector<Index> vertex_from_, edge_from_;
};

/// Requirements of a state that lists its elements and can be given other numbers.
template <class State>
concept renumbered_state = sparse_state<State> and requires(State& state, const part_numbers<std::uint32_t>& part) {
    state.add_part(std::as_const(state), part);
};

/// Returns a part in canonical numbers. First corners of faces are kept if these have a meaning. A part keeps its
/// numbers if it has state that cannot be given others. Cost: O(elements of the part).
template <std::unsigned_integral Index, scheme Scheme>
canonical_part<Index, Scheme> make_canonical(const connectivity<Index>& part, int generation, const Scheme& scheme,
                                             Index face, bool keeps_first_corners)
{
    const auto as_it_is = [&] {
        std::vector<Index> same(part.corners());
        for (std::size_t c = 0; c < same.size(); ++c)
            same[c] = Index(c);
        return canonical_part<Index, Scheme>{part, scheme, std::move(same), {}, face};
    };
    if constexpr (scheme_of_places<Scheme>) {
        const canonical_numbers<Index> numbers(part, face, keeps_first_corners);
        bool can_be_renumbered = numbers.has_all();
        std::u32string key;
        if constexpr (requires { scheme.columns(generation); }) // which differ in even and odd generations
            key += char32_t(generation % 2);
        Scheme renumbered = without_state(scheme);
        for_each_state(renumbered, scheme, [&](auto& to, const auto& from) {
            if constexpr (renumbered_state<std::remove_cvref_t<decltype(from)>>)
                numbers.with_part_numbers([&](const auto& new_numbers) { to.add_part(from, new_numbers); });
            else
                from.for_each_place([&](auto&&...) { can_be_renumbered = false; });
        });
        if (can_be_renumbered) {
            auto mesh = numbers.connect(key);
            char32_t which = 0;
            for_each_state(std::as_const(renumbered), [&](const auto& state) {
                state.for_each_place([&](tuple_kind kind, std::size_t element, const auto& value) {
                    key += which;
                    key += char32_t(kind);
                    key += char32_t(element);
                    for (const std::byte b : std::bit_cast<std::array<std::byte, sizeof(value)>>(value))
                        key += char32_t(b);
                });
                ++which;
            });
            return {std::move(mesh), std::move(renumbered), numbers.corner_from(), std::move(key)};
        }
    }
    return as_it_is();
}

/// Returns for each corner the first corner at its vertex for which is_alike(first, corner) is true.
template <std::unsigned_integral Index, class IsAlike>
std::vector<Index> first_alike(const connectivity<Index>& mesh, const IsAlike& is_alike)
{
    std::vector<std::vector<Index>> kinds(mesh.vertices);
    std::vector<Index> result;
    for (std::size_t c = 0; c < mesh.corners(); ++c) {
        auto& of_vertex = kinds[mesh.corner_vertex[c]];
        const auto known = std::ranges::find_if(of_vertex, [&](Index first) { return is_alike(first, Index(c)); });
        result.push_back(known == of_vertex.end() ? Index(c) : *known);
        if (known == of_vertex.end())
            of_vertex.push_back(Index(c));
    }
    return result;
}
/// Returns for each corner of a part of a mesh its number in the mesh.
template <std::unsigned_integral Index>
std::vector<Index> corners_of(const connectivity<Index>& mesh, const connectivity<Index>& part,
                              std::span<const Index> face_from)
{
    std::vector<Index> result;
    for (std::size_t f = 0; f < face_from.size(); ++f)
        for (Index c = part.first_corner(f); c < part.first_corner(f + 1); ++c)
            result.push_back(Index(mesh.first_corner(face_from[f]) + (c - part.first_corner(f))));
    return result;
}

} // namespace kith::detail
