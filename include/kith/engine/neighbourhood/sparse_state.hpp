// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_walk.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/numbering/association/tuples.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// A stand-in for the value that a state has at an element.
struct any_value {
    template <class T>
        requires std::is_trivially_copyable_v<T>
    any_value(const T&);
};

} // namespace detail

/// State of a level that can list the elements at which it has a value, and these values, such as creases.
template <class State>
concept sparse_state = requires(const State& state, void (*f)(tuple_kind, std::size_t, detail::any_value)) {
    state.for_each_place(f);
    { state.of_part(part_numbers<std::uint32_t>()) } -> std::convertible_to<State>;
};

namespace detail {

template <class... State>
constexpr bool are_placed(const std::tuple<State&...>*)
{
    return (sparse_state<std::remove_const_t<State>> and ...);
}

} // namespace detail

/// A scheme whose state, if it has any, is sparse. Away from the elements with values it is the scheme without the
/// state.
template <class Scheme>
concept scheme_of_places = scheme<Scheme> and
                           detail::are_placed(
                               static_cast<const decltype(detail::states_of(std::declval<Scheme&>()))*>(nullptr));

/// Returns the scheme with empty state, or the scheme itself if its state is not sparse.
template <scheme Scheme>
Scheme without_state(const Scheme& scheme)
{
    if constexpr (scheme_of_places<Scheme>)
        return detail::scheme_of_part(scheme, part_numbers<std::uint32_t>());
    else
        return scheme;
}

/// Restricts the state of a scheme to a part of a level. `whole` is the same scheme with the state of that level. If
/// the state is not sparse, nothing changes; such a scheme must ignore numbers.
template <scheme Scheme, std::unsigned_integral Index>
void take_state_of_part(Scheme& scheme, const Scheme& whole, const part_numbers<Index>& part)
{
    if constexpr (scheme_of_places<Scheme>)
        detail::restrict_state(scheme, whole, part);
}

/// The values that the state of a scheme has at the elements of a level, as part of the keys of neighbourhoods. With
/// them, faces are alike only if the state is alike, too.
template <std::unsigned_integral Index>
class state_marks {
public:
    /// Takes a mesh without state.
    explicit state_marks(const connectivity<Index>& mesh) : mesh_(mesh) {}
    /// Takes a mesh and the scheme with its state. Precondition: the mesh, which must outlive this, has its edges.
    /// Errors: mesh_error for a state of elements that do not exist. Cost: O(1) if there is no state, else O(elements).
    template <scheme Scheme>
    state_marks(const connectivity<Index>& mesh, const Scheme& scheme) : state_marks(mesh)
    {
        if constexpr (scheme_of_places<Scheme>) {
            char16_t which = 0;
            detail::for_each_state(scheme, [&](const auto& state) {
                state.for_each_place(
                    [&](tuple_kind kind, std::size_t element, const auto& value) { add(kind, element, which, value); });
                ++which;
            });
        }
    }

    /// Returns true if there is no state.
    [[nodiscard]] bool empty() const { return texts_.empty(); }

    /// Returns the key of a walk. If the state has values at the elements that were met, they come before that key.
    /// Cost: O(corners).
    [[nodiscard]] const std::u16string& key(const face_walk<Index>& walk)
    {
        if (texts_.empty() or walk.key().empty() or
            std::ranges::none_of(walk.faces(), [&](Index f) { return bool(is_marked_[f]); }))
            return walk.key();
        key_.assign(1, no_walk);
        for (const Index f : walk.faces())
            append_all_of(f);
        return key_ += walk.key();
    }
    /// Returns a number for the state of a face, of the vertices of its corners and of its edges. Equal state has equal
    /// numbers; 0 means no state. Precondition: not empty(). Cost: O(1), or O(corners) of the face if there are values.
    [[nodiscard]] std::uint32_t number_of_face(std::size_t face);

private:
    static constexpr Index none = connectivity<Index>::none;
    static constexpr char16_t no_walk = 0xffff; // no key of a walk begins with it

    template <class Value>
    void add(tuple_kind kind, std::size_t element, char16_t which, const Value& value)
    {
        add_bytes(kind, element, which, std::as_bytes(std::span(&value, 1)));
    }
    void add_bytes(tuple_kind kind, std::size_t element, char16_t which, std::span<const std::byte> value);
    /// Marks the faces that have the element.
    void mark_faces(tuple_kind kind, std::size_t element)
    {
        const auto mark = [&](Index corner) {
            if (corner != none)
                is_marked_[mesh_.face_of(corner)] = true;
        };
        if (kind == tuple_kind::v) {
            Index c = mesh_.vertex_corner[element];
            do {
                mark(c);
                c = mesh_.next_in_fan(c);
            } while (c != none and c != mesh_.vertex_corner[element]);
        } else if (kind == tuple_kind::e) {
            mark(mesh_.halfedge_corner[2 * element]);
            mark(mesh_.halfedge_corner[2 * element + 1]);
        } else {
            is_marked_[element] = true;
        }
    }
    void append_all_of(Index face)
    {
        append(of_face_[face]);
        for (Index c = mesh_.first_corner(face); c < mesh_.first_corner(face + std::size_t(1)); ++c) {
            append(of_vertex_[mesh_.corner_vertex[c]]);
            append(of_edge_[mesh_.corner_halfedge[c] / 2]);
        }
    }
    /// Appends a text after its length, so that keys can be read in one way only.
    void append(Index place)
    {
        if (place == none) {
            key_ += char16_t(0);
        } else {
            key_ += char16_t(texts_[place].size());
            key_ += texts_[place];
        }
    }

    const connectivity<Index>& mesh_;
    storage<Index> of_vertex_, of_edge_, of_face_; // places in the list of texts; empty without state
    storage<unsigned char> is_marked_;             // of faces: whether the face, a vertex or an edge of it has a text
    std::vector<std::u16string> texts_;
    std::u16string key_;
    std::unordered_map<std::u16string, std::uint32_t> number_; // of the texts at a face
};

// Defined outside of the class, so that files that declare it `extern template` do not compile them.

template <std::unsigned_integral Index>
std::uint32_t state_marks<Index>::number_of_face(std::size_t face)
{
    if (not is_marked_[face])
        return 0;
    key_.clear();
    append_all_of(Index(face));
    return number_.try_emplace(key_, std::uint32_t(number_.size() + 1)).first->second;
}

template <std::unsigned_integral Index>
void state_marks<Index>::add_bytes(tuple_kind kind, std::size_t element, char16_t which,
                                   std::span<const std::byte> value)
{
    if (texts_.empty()) {
        of_vertex_ = storage<Index>(mesh_.vertices, none);
        of_edge_ = storage<Index>(mesh_.edges(), none);
        of_face_ = storage<Index>(mesh_.faces, none);
        is_marked_ = storage<unsigned char>(mesh_.faces, false);
    }
    storage<Index>& of_kind = kind == tuple_kind::v ? of_vertex_ : kind == tuple_kind::e ? of_edge_ : of_face_;
    if (element >= of_kind.size())
        throw mesh_error("the state of the scheme: " +
                         std::string(kind == tuple_kind::v   ? "vertex "
                                     : kind == tuple_kind::e ? "edge "
                                                             : "face ") +
                         std::to_string(element) + " does not exist, there are " + std::to_string(of_kind.size()) +
                         "; make the state for this mesh and level");
    if (of_kind[element] == none) {
        of_kind[element] = Index(texts_.size());
        texts_.emplace_back();
        mark_faces(kind, element);
    }
    std::u16string& text = texts_[of_kind[element]];
    text += which;
    for (const std::byte b : value)
        text += char16_t(b);
}

} // namespace kith
