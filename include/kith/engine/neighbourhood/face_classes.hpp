// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sparse_state.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/sequence_numbers.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace kith {

/// Classes of faces with alike neighbourhoods, including the state of the scheme there. They are found without walking
/// around faces. Two vertices are of one kind if their fans are alike from start to end. Two faces are of one class if
/// their corners have the same places in fans of the same kinds. Each round over vertices and faces adds a ring (the
/// colour refinement of Weisfeiler & Leman 1968). The elements around an element of a surface are in order. So this
/// tells apart all neighbourhoods, except those that meet themselves again from another side; see `face_walk::is_disk`.
template <std::unsigned_integral Index>
class face_classes {
public:
    using number = sequence_numbers::number;
    static constexpr std::size_t most_corners = std::size_t(1) << 30;
    static constexpr number none = std::numeric_limits<number>::max(); ///< stands for the class of faces left out

    /// Finds the classes by this many rings. Preconditions: the mesh has its edges and at most `most_corners`; rings >
    /// 0. Cost: O(corners) per ring, on all threads.
    face_classes(const connectivity<Index>& mesh, int rings, state_marks<Index> marks);

    /// Leaves out the faces without a mark. The numbers of the classes stay; some classes may then have no faces.
    void keep_marked(std::span<const unsigned char> is_marked)
    {
        for (std::size_t f = 0; f < class_.size(); ++f)
            if (is_marked[f] == 0)
                class_[f] = none;
    }

    [[nodiscard]] std::size_t count() const { return count_; }
    /// Returns the class of each face, or `none`.
    [[nodiscard]] const storage<number>& of_faces() const { return class_; }
    /// Returns the number of faces of each class. Cost: O(faces).
    [[nodiscard]] std::vector<std::size_t> sizes() const
    {
        std::vector<std::size_t> result(count_, 0);
        for (const number c : class_)
            if (c != none)
                ++result[c];
        return result;
    }

private:
    /// Sets the class of each face by what is seen of the face alone: its degree, and its state.
    void look_at_each(const connectivity<Index>& mesh, state_marks<Index>& marks)
    {
        number used = 0; // how many numbers of items are taken
        std::map<std::pair<std::uint32_t, Index>, number> first_items;
        for (std::size_t f = 0; f < mesh.faces; ++f) {
            const Index degree = mesh.first_corner(f + 1) - mesh.first_corner(f);
            const std::uint32_t mark = marks.empty() ? 0 : marks.number_of_face(f);
            const auto [place, is_new] = first_items.try_emplace({mark, degree}, used);
            if (is_new)
                used += number(degree);
            class_[f] = place->second;
        }
    }
    /// Returns the first vertex of each group of `vertices_at_once`, in the order of the faces at which these vertices
    /// lie. Threads that share the groups then read and write in different places, and rarely wait for each other's
    /// cache lines. A refined mesh has its vertices column by column, each column in this order.
    static std::vector<std::size_t> vertices_by_faces(const connectivity<Index>& mesh)
    {
        std::vector<std::size_t> firsts;
        for (std::size_t v = 0; v < mesh.vertices; v += vertices_at_once)
            firsts.push_back(v);
        std::ranges::stable_sort(firsts, {}, [&](std::size_t v) { return mesh.vertex_corner[v]; });
        return firsts;
    }
    void look_at_fans(const connectivity<Index>& mesh)
    {
        sequence_numbers kinds;
        const auto degree = Index(mesh.degree);
        const auto in_order = vertices_by_faces(mesh);
        detail::for_shared_parts(
            in_order.size(), 1, detail::is_worth_threads(mesh.faces), [&](detail::parts_to_do parts) {
                sequence_numbers::reader kind(kinds);
                std::u32string fan;
                std::vector<Index> corners;
                const auto look_at = [&](Index start) {
                    fan.clear();
                    corners.clear();
                    Index c = start;
                    do {
                        const Index h = mesh.corner_halfedge[c];
                        // Divides by constants where possible, which is faster.
                        const Index face = degree == 4 ? c / 4 : degree == 3 ? c / 3 : mesh.corner_face[c];
                        const Index first = degree != 0 ? degree * face : mesh.face_corner[face];
                        const bool is_boundary = mesh.halfedge_corner[h ^ 1] == mesh.none;
                        fan += char32_t(4 * (class_[face] + number(c - first)) + 2 * (h % 2) + is_boundary);
                        corners.push_back(c);
                        c = mesh.next_in_fan(c);
                    } while (c != mesh.none and c != start);
                    number place = kind(fan).first_item;
                    for (const Index corner : corners)
                        place_in_fan_[corner] = char32_t(place++);
                };
                parts.for_each([&](std::size_t part, std::size_t) {
                    const std::size_t first = in_order[part];
                    const std::size_t last = std::min(first + vertices_at_once, mesh.vertices);
                    for (std::size_t v = first; v < last; ++v)
                        look_at(mesh.vertex_corner[v]);
                });
            });
    }
    void look_at_faces(const connectivity<Index>& mesh, bool is_last)
    {
        sequence_numbers classes;
        const auto degree = std::size_t(mesh.degree);
        detail::for_shared_parts(
            mesh.faces, faces_at_once, detail::is_worth_threads(mesh.faces), [&](detail::parts_to_do parts) {
                sequence_numbers::reader class_of(classes);
                parts.for_each([&](std::size_t begin, std::size_t end) {
                    for (std::size_t f = begin; f < end; ++f) {
                        const std::size_t first = degree != 0 ? degree * f : mesh.face_corner[f];
                        const std::size_t corners = degree != 0 ? degree : mesh.face_corner[f + 1] - first;
                        const auto made = class_of(std::u32string_view(place_in_fan_.data() + first, corners));
                        class_[f] = is_last ? made.sequence : made.first_item;
                    }
                });
            });
        count_ = classes.count();
    }

    static constexpr std::size_t vertices_at_once = 256, faces_at_once = 2048;

    std::size_t count_ = 0;
    // Per face: its class; before the last round the number of the class's first item. There are as many items as
    // corners.
    storage<number> class_;
    storage<char32_t> place_in_fan_; // of corners: the place in a fan, different for each kind of fan
};

// Defined outside of the class, so that files that declare it `extern template` do not compile them.

template <std::unsigned_integral Index>
face_classes<Index>::face_classes(const connectivity<Index>& mesh, int rings, state_marks<Index> marks)
    : class_(mesh.faces, 0), place_in_fan_(mesh.corners())
{
    if (not marks.empty() or mesh.degree == 0)
        look_at_each(mesh, marks);
    for (int ring = 0; ring < rings; ++ring) {
        look_at_fans(mesh);
        look_at_faces(mesh, ring + 1 == rings);
    }
}

/// Returns the number of classes in a sample of faces, divided by the faces of the sample. For small meshes the sample
/// is all faces, which is as quick. Preconditions: the mesh has its edges and faces. Cost: at most that of one to two
/// times `most_looks` walks.
template <std::unsigned_integral Index>
double share_of_classes(const connectivity<Index>& mesh, int rings, std::size_t most_looks = 1024)
{
    constexpr std::size_t enough = 128;
    if (mesh.faces <= 4 * most_looks)
        return double(face_classes<Index>(mesh, rings, state_marks<Index>(mesh)).count()) / double(mesh.faces);
    face_walk<Index> walk(mesh, rings);
    std::unordered_set<std::u16string> classes;
    const std::size_t step = mesh.faces / most_looks | 1; // odd, to meet different ones of a face's four children
    std::size_t looks = 0;
    for (std::size_t f = 0; f < mesh.faces; f += step) {
        walk.around(f);
        classes.insert(walk.key());
        if (++looks == enough and classes.size() == looks)
            return 1;
    }
    return double(classes.size()) / double(looks);
}

} // namespace kith
