// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// A corner of a neighbourhood: the number of its face in the order of the walk, and which corner of that face it is.
struct walked_corner {
    std::uint16_t face, corner;
};
/// A step of a walk, to a new face of the neighbourhood: across an edge of a face that was found before.
struct walk_step {
    walked_corner from;     ///< the corner whose edge is crossed
    std::uint16_t rotation; ///< the corner of the new face that lies across
};

/// The faces around a face, in an order that follows from the connectivity alone, and a key. Two faces share a key if
/// everything that a scheme can ask within the rings has one answer for both. That is: which corners lie across, which
/// way edges run, where fans start, and where the boundary is. Numbers of elements are not in the key.
template <std::unsigned_integral Index>
class face_walk {
public:
    /// The size of the largest neighbourhoods that have a key.
    static constexpr std::size_t most_faces = 512, most_corners = 8192;

    /// Takes a mesh, which must have its edges and outlive this, and the number of rings. Cost: O(elements).
    face_walk(const connectivity<Index>& mesh, int rings)
        : mesh_(mesh), rings_(rings), face_(mesh.faces, none), vertex_(mesh.vertices, none)
    {
    }

    /// Walks around a face, over `rings` rings of faces that share a vertex. Cost: O(corners within).
    void around(std::size_t face)
    {
        faces_.clear();
        places_.assign(1, 0);
        steps_.clear();
        key_.clear();
        is_disk_ = false;
        add(Index(face));
        std::size_t ring = 0;
        for (int r = 0; r < rings_ and is_small(); ++r)
            for (const std::size_t end = faces_.size(); ring < end and is_small(); ++ring)
                for_corners(faces_[ring], [&](Index c) { turn_around(c); });
        if (is_small()) {
            const std::size_t complete = number_vertices(ring);
            make_key(complete);
            is_disk_ = meets_no_other_side(complete);
            for (const Index v : vertices_)
                vertex_[v] = none;
            vertices_.clear();
        }
        for (const Index f : faces_)
            face_[f] = none;
    }

    /// Returns the faces of the walk; the face itself comes first.
    [[nodiscard]] std::span<const Index> faces() const { return faces_; }
    /// Returns the step to each face but the first.
    [[nodiscard]] std::span<const walk_step> steps() const { return steps_; }
    /// Returns the key; it is empty if there are too many faces or corners.
    [[nodiscard]] const std::u16string& key() const { return key_; }
    /// Returns true if the neighbourhood is a disk that touches itself only around the vertices whose whole fans are in
    /// it. Then the steps of its walk, around any face of its class (`face_classes`), find all elements that can be
    /// told apart. This is not so around a thin tube, where a vertex is met from both sides. Returns false if there is
    /// no key.
    [[nodiscard]] bool is_disk() const { return is_disk_; }

private:
    static constexpr Index none = connectivity<Index>::none;

    void add(Index face)
    {
        face_[face] = Index(faces_.size());
        faces_.push_back(face);
        places_.push_back(places_.back() + (mesh_.first_corner(face + std::size_t(1)) - mesh_.first_corner(face)));
    }
    [[nodiscard]] bool is_small() const { return faces_.size() <= most_faces and places_.back() <= most_corners; }
    /// Calls f(corner) for the corners of a face.
    template <class F>
    void for_corners(Index face, const F& f) const
    {
        const Index end = mesh_.first_corner(face + std::size_t(1));
        for (Index c = mesh_.first_corner(face); c < end; ++c)
            f(c);
    }
    /// Returns the face of a corner. Dividing by constants takes a third of the time.
    [[nodiscard]] Index face_of(Index corner) const
    {
        return mesh_.degree == 4 ? corner / 4 : mesh_.degree == 3 ? corner / 3 : mesh_.face_of(corner);
    }
    [[nodiscard]] walked_corner walked(Index corner) const
    {
        const Index face = face_of(corner);
        return {std::uint16_t(face_[face]), std::uint16_t(corner - mesh_.first_corner(face))};
    }
    /// Returns the place of a corner of a walked face, in the order of the walk.
    [[nodiscard]] std::size_t place_of(Index corner) const
    {
        const auto [face, at] = walked(corner);
        return places_[face] + at;
    }
    void reach(Index from, Index across)
    {
        const Index face = face_of(across);
        if (face_[face] != none)
            return;
        steps_.push_back({walked(from), std::uint16_t(across - mesh_.first_corner(face))});
        add(face);
    }
    /// Finds all faces of the fan that a corner lies in.
    void turn_around(const Index first)
    {
        for (Index c = first;;) {
            const Index from = mesh_.prev(c);
            const Index next = mesh_.across(from);
            if (next == first)
                return;
            if (next == none)
                break;
            reach(from, next);
            c = next;
        }
        for (Index c = first;;) {
            const Index across = mesh_.across(c);
            if (across == none)
                return;
            reach(c, across);
            c = mesh_.next(across);
        }
    }
    /// Numbers the vertices in the order in which they are met. Returns the number of vertices of the first `inner`
    /// faces. These come first, and their fans are complete.
    std::size_t number_vertices(std::size_t inner)
    {
        std::size_t complete = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            if (f == inner)
                complete = vertices_.size();
            for_corners(faces_[f], [&](Index c) {
                const Index v = mesh_.corner_vertex[c];
                if (vertex_[v] == none) {
                    vertex_[v] = Index(vertices_.size());
                    vertices_.push_back(v);
                }
            });
        }
        return inner >= faces_.size() ? vertices_.size() : complete;
    }
    /// Returns true if the faces form a disk in which no vertex lies at two places. They are glued along the edges at
    /// vertices whose fans are complete. The Euler characteristic tells a disk. The corners that are glued around a
    /// vertex form arcs, each of which is one place of the vertex. Around an inner vertex they close to a circle, so
    /// that no arc is left.
    [[nodiscard]] bool meets_no_other_side(std::size_t complete)
    {
        std::size_t sides = 0; // of edges that are glued
        arcs_.assign(vertices_.size(), 0);
        for (const Index f : faces_)
            for_corners(f, [&](Index c) {
                const Index v = vertex_[mesh_.corner_vertex[c]], across = mesh_.across(c);
                const bool is_glued = across != none and face_[face_of(across)] != none and
                                      (v < complete or vertex_[mesh_.corner_vertex[mesh_.next(c)]] < complete);
                sides += is_glued;
                arcs_[v] += not is_glued;
            });
        const auto whole = arcs_.begin() + std::ptrdiff_t(complete);
        const auto within = std::size_t(std::count(arcs_.begin(), whole, 0));
        return std::ranges::all_of(arcs_, [](std::uint16_t arcs) { return arcs <= 1; }) and
               faces_.size() + within == 1 + sides / 2;
    }
    void make_key(std::size_t complete)
    {
        constexpr char16_t boundary = 0, outside = 1, first_corner = 2;
        key_.resize(2 * places_.back() + faces_.size());
        char16_t* to = key_.data();
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            *to++ = char16_t(places_[f + 1] - places_[f]); // its degree
            for_corners(faces_[f], [&](Index c) {
                const Index v = mesh_.corner_vertex[c];
                const Index halfedge = mesh_.corner_halfedge[c], across = mesh_.halfedge_corner[halfedge ^ 1];
                const bool starts = vertex_[v] < complete and mesh_.vertex_corner[v] == c;
                *to++ = char16_t(2 * vertex_[v] + starts);
                if (across == none) {
                    const bool matters = vertex_[v] < complete or
                                         vertex_[mesh_.corner_vertex[mesh_.next(c)]] < complete;
                    *to++ = matters ? boundary : outside; // beyond it all is cut off
                    return;
                }
                *to++ = face_[face_of(across)] == none ? outside
                                                       : char16_t(first_corner + 2 * place_of(across) + halfedge % 2);
            });
        }
    }

    const connectivity<Index>& mesh_;
    int rings_;
    storage<Index> face_, vertex_; // numbers in the current neighbourhood; none outside
    std::vector<Index> faces_, vertices_;
    std::vector<std::size_t>
        places_; // where the corners of each face begin in the order of the walk, and where all end
    std::vector<walk_step> steps_;
    std::u16string key_;
    bool is_disk_ = false;
    std::vector<std::uint16_t> arcs_; // of glued corners around each vertex
};

} // namespace kith
