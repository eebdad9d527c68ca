// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/engine/neighbourhood/descents.hpp>
#include <kith/engine/patch/patch_writer.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

#ifdef KITH_HAS_LANES

/// The last level of a tile, made from patches of the owned faces and of the faces around them. Its elements are
/// numbered by their descent from the level whose faces have patches.
template <class Point, std::unsigned_integral Index>
class tile_of_patches {
public:
    /// Takes the tile `coarse`, which must outlive this object. `here` and `there` are the columns of the steps in the
    /// mesh of the tile and in the whole mesh. `last` has the counts of the tile's last level, `vertices_there` the
    /// vertices of the whole last level. `degree` is the degree of all faces, or 0 if they may have several.
    tile_of_patches(const tile<Point, Index>& coarse, std::span<const column_bases> here,
                    std::span<const column_bases> there, const counts& last, std::uint64_t vertices_there,
                    std::size_t degree)
        : coarse_(coarse)
        , degree_(degree)
        , vertices_(descents_of(tuple_kind::v, here, degree))
        , vertices_there_(descents_of(tuple_kind::v, there, degree))
        , faces_(descents_of(tuple_kind::f, here, degree))
        , faces_there_(descents_of(tuple_kind::f, there, degree))
        , last_(last)
    {
        for (const descent& way : faces_)
            corners_.push_back(corners_of(way, here));
        for (const descent& way : faces_there_)
            corners_there_.push_back(corners_of(way, there));
        KITH_ASSERT(vertices_.size() == vertices_there_.size() and faces_.size() == faces_there_.size());
        const auto& t = coarse.mesh.topology();
        const auto owned = owned_faces_of(coarse);
        std::vector<unsigned char> is_near(coarse.mesh.vertex_count(), 0);
        for (const Index f : owned)
            for (const Index v : coarse.mesh.face(f))
                is_near[v] = 1;
        is_patched_.assign(t.faces, 0);
        for (std::size_t f = 0; f < is_patched_.size(); ++f)
            is_patched_[f] = std::ranges::any_of(coarse.mesh.face(f), [&](Index v) { return is_near[v] != 0; });
        is_whole_ = degree != 0 and owned.size() == t.faces and last.vertices == vertices_there;
        if (degree == 0)
            for (std::size_t f = 0; f < t.faces; ++f)
                for (std::size_t k = 0; k < coarse.mesh.face(f).size(); ++k)
                    corner_ids_.push_back(coarse.corner_id(f, k));
        for (const tuple_kind kind : {tuple_kind::v, tuple_kind::e, tuple_kind::f, tuple_kind::vf}) {
            auto& places = places_[std::size_t(kind)];
            for (std::size_t x = 0; x < ids(kind).size(); ++x)
                places.push_back(is_owned(kind, x) ? ours : is_patched_[maker_of(kind, x)] != 0 ? at_rim : elsewhere);
        }
    }

    /// Returns marks of the faces of the coarse tile whose patches are needed: the owned faces and the faces around
    /// them.
    [[nodiscard]] std::span<const unsigned char> is_patched() const { return is_patched_; }
    /// Allocates the output of the patches, which is in the numbers of the refined mesh of the tile.
    [[nodiscard]] patch_output<Point, Index> make_room()
    {
        points_ = storage<Point>(last_.vertices);
        corner_vertex_ = storage<Index>(last_.corners());
        if (degree_ == 0) // at a cut some faces are not made, and others have fewer corners
            std::ranges::fill(corner_vertex_, connectivity<Index>::none);
        return {.points = points_.data(), .corner_vertex = corner_vertex_.data()};
    }

    /// Returns the owned faces and their vertices. Precondition: the patches have been written. Cost: O(last level).
    [[nodiscard]] tile<Point, Index> take(int generation)
    {
        tile<Point, Index> result;
        const auto marks = marks_of_vertices();
        number_vertices(marks, result);
        auto faces = taken_faces(result);
        faces.vertices = result.vertex_ids.size();
        corner_vertex_ = {}; // released before the points are copied
        result.mesh = basic_mesh<Point, Index>(taken_points(marks, faces.vertices), std::move(faces), generation);
        return result;
    }

private:
    enum : unsigned char { elsewhere = 0, ours = 1, at_rim = 2, rim_comes_first = 4 };

    /// A run of faces of the last level that descend in one way from one element of the coarse tile.
    struct face_run {
        std::size_t way, element;
        std::uint64_t first, corner, degree; ///< the first face, its first corner, and the degree of all faces
    };

    [[nodiscard]] std::span<const global_id> ids(tuple_kind kind) const
    {
        return kind == tuple_kind::vf ? std::span<const global_id>(corner_ids_) : ids_of(coarse_, parent_kind(kind));
    }
    [[nodiscard]] bool is_owned(tuple_kind kind, std::size_t x) const
    {
        switch (kind) {
        case tuple_kind::v: return coarse_.owns_vertex(x);
        case tuple_kind::e: return coarse_.owns_edge(x);
        default: return coarse_.owns_face(maker_of(kind, x));
        }
    }
    [[nodiscard]] std::size_t maker_of(tuple_kind kind, std::size_t x) const
    {
        return face_of_patch(coarse_.mesh.topology(), kind, x);
    }
    /// Calls f(face_run) for the faces that descend from elements with `place` `ours` or `at_rim`, in the order of
    /// their numbers.
    template <class F>
    void for_each_run(unsigned char place, const F& f) const
    {
        for (std::size_t way = 0; way < faces_.size(); ++way) {
            const auto& places = places_[std::size_t(faces_[way].from)];
            const auto [offset, degree] = corners_[way];
            for (std::size_t x = 0; x < places.size(); ++x) {
                if (places[x] != place)
                    continue;
                const std::uint64_t first = faces_[way].first + faces_[way].each * x;
                const std::uint64_t before = degree != 0 ? degree * first : coarse_.mesh.topology().first_corner(x);
                f(face_run{way, x, first, offset + before, degree != 0 ? degree : coarse_.mesh.face(x).size()});
            }
        }
    }
    /// Calls f(face, vertex) for the corners that patches have made of faces with this place.
    template <class F>
    void for_each_corner(unsigned char place, F f) const
    {
        for_each_run(place, [&](const face_run& run) {
            const Index* vertex = corner_vertex_.data() + run.corner;
            for (std::size_t face = run.first; face < run.first + faces_[run.way].each; ++face)
                for (std::size_t k = 0; k < run.degree; ++k, ++vertex)
                    if (*vertex != connectivity<Index>::none)
                        f(Index(face), *vertex);
        });
    }
    /// Returns marks of the vertices of owned faces. At the rim they also tell whether the first face at the vertex is
    /// not owned.
    [[nodiscard]] storage<unsigned char> marks_of_vertices() const
    {
        storage<unsigned char> marks(points_.size());
        std::ranges::fill(marks, is_whole_ ? ours : 0);
        if (is_whole_)
            return marks;
        storage<Index> first_at_rim(points_.size()); // the first face at each marked vertex
        for_each_corner(at_rim, [&](Index face, Index v) {
            if (marks[v] == 0)
                first_at_rim[v] = face;
            marks[v] = at_rim;
        });
        for_each_corner(ours, [&](Index face, Index v) {
            if ((marks[v] & ours) == 0 and marks[v] != 0 and first_at_rim[v] < face)
                marks[v] |= rim_comes_first;
            marks[v] |= ours;
        });
        return marks;
    }
    /// Numbers the vertices of owned faces in their order, and writes their global numbers and marks.
    void number_vertices(const storage<unsigned char>& marks, tile<Point, Index>& result)
    {
        const auto size = std::size_t(
            std::ranges::count_if(marks, [](unsigned char mark) { return (mark & ours) != 0; }));
        number_ = storage<Index>(points_.size());
        result.vertex_ids = storage<global_id>(size);
        result.vertex_marks = storage<unsigned char>(size);
        std::size_t next = 0;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const descent &way = vertices_[i], &there = vertices_there_[i];
            const bool of_faces = parent_kind(way.last) == element_kind::face;
            const auto parents = ids(way.from);
            const auto& places = places_[std::size_t(way.from)];
            for (std::size_t x = 0; x < parents.size(); ++x) {
                const std::size_t first = way.first + way.each * x;
                const global_id first_there = there.first + there.each * parents[x];
                for (std::size_t which = 0; which < way.each; ++which) {
                    const std::size_t v = first + which;
                    if ((marks[v] & ours) == 0)
                        continue;
                    const bool is_owned = of_faces ? places[x] == ours : (marks[v] & rim_comes_first) == 0;
                    number_[v] = Index(next);
                    result.vertex_ids[next] = first_there + which;
                    result.vertex_marks[next] = is_owned ? owned_mark : 0;
                    ++next;
                }
            }
        }
    }
    [[nodiscard]] storage<Point> taken_points(const storage<unsigned char>& marks, std::size_t size)
    {
        if (is_whole_)
            return std::move(points_);
        storage<Point> points(size);
        for (std::size_t v = 0; v < points_.size(); ++v)
            if ((marks[v] & ours) != 0)
                points[number_[v]] = points_[v];
        return points;
    }
    /// Writes the numbers and marks of owned faces, and returns the faces with their new vertices.
    [[nodiscard]] connectivity<Index> taken_faces(tile<Point, Index>& result)
    {
        std::vector<std::size_t> degrees; // of the faces of each run
        std::size_t size = 0;
        for_each_run(ours, [&](const face_run& run) {
            size += faces_[run.way].each;
            degrees.push_back(run.degree);
        });
        number_faces(size, result);
        const auto degree_of_run = [&](std::size_t run) { return degrees[run]; };
        const int degree = degree_ != 0 ? int(degree_) : degree_if_alike(degrees.size(), degree_of_run);
        connectivity<Index> faces;
        if (degree != 0) {
            faces.allocate_faces(size, degree, [&](std::size_t) { return std::size_t(degree); });
        } else {
            std::vector<std::size_t> each;
            for_each_run(ours, [&](const face_run& run) { each.insert(each.end(), faces_[run.way].each, run.degree); });
            faces.allocate_faces(size, 0, [&](std::size_t face) { return each[face]; });
        }
        if (is_whole_ and corner_vertex_.size() == faces.corner_vertex.size())
            faces.corner_vertex = std::move(corner_vertex_);
        else
            for_each_corner(ours, [&, to = faces.corner_vertex.data()](Index, Index v) mutable { *to++ = number_[v]; });
        return faces;
    }
    void number_faces(std::size_t size, tile<Point, Index>& result) const
    {
        result.face_ids = storage<global_id>(size);
        result.root_of = storage<Index>(size);
        result.face_marks = storage<unsigned char>(size);
        std::ranges::fill(result.face_marks, owned_mark);
        result.roots = coarse_.roots;
        if (degree_ == 0)
            result.first_corner_ids = storage<global_id>(size);
        const auto first_of_vertex = first_faces(tuple_kind::v), first_of_edge = first_faces(tuple_kind::e);
        std::size_t next = 0;
        for_each_run(ours, [&](const face_run& run) {
            const descent& there = faces_there_[run.way];
            const global_id first = there.first + there.each * ids(there.from)[run.element];
            const std::size_t face = there.from == tuple_kind::v   ? first_of_vertex[run.element]
                                     : there.from == tuple_kind::e ? first_of_edge[run.element]
                                                                   : maker_of(there.from, run.element);
            std::fill_n(result.root_of.begin() + next, there.each, coarse_.root_of[face]);
            std::iota(result.face_ids.begin() + next, result.face_ids.begin() + next + there.each, first);
            if (degree_ == 0) {
                const auto [offset, degree] = corners_there_[run.way];
                const global_id corner = offset + (degree != 0 ? degree * first : coarse_.corner_id(face, 0));
                for (std::size_t which = 0; which < there.each; ++which)
                    result.first_corner_ids[next + which] = corner + which * run.degree;
            }
            next += there.each;
        });
    }
    /// Returns the first face at each vertex or edge, if faces descend from elements of this kind; else nothing.
    [[nodiscard]] std::vector<Index> first_faces(tuple_kind kind) const
    {
        if (std::ranges::find(faces_, kind, &descent::from) == faces_.end())
            return {};
        const auto& t = coarse_.mesh.topology();
        std::vector<Index> result(ids(kind).size(), t.none);
        for (std::size_t f = 0; f < t.faces; ++f)
            for (Index c = t.first_corner(f); c < t.first_corner(f + 1); ++c) {
                Index& first = result[kind == tuple_kind::v ? t.corner_vertex[c] : t.corner_halfedge[c] / 2];
                first = std::min(first, Index(f));
            }
        return result;
    }

    const tile<Point, Index>& coarse_;
    std::size_t degree_; // of the faces, or 0 if they may have several
    std::vector<descent> vertices_, vertices_there_, faces_, faces_there_;
    std::vector<descent_of_corners> corners_, corners_there_; // of these faces
    counts last_;
    std::vector<global_id> corner_ids_;                // of the coarse tile, if faces may have several degrees
    std::array<std::vector<unsigned char>, 7> places_; // by kind: the place of each element
    storage<Point> points_;                 // of the refined mesh of the tile; patches have written only a part
    storage<Index> corner_vertex_, number_; // number_: the new number of each kept vertex
    std::vector<unsigned char> is_patched_;
    bool is_whole_; // true if all vertices are kept with their numbers
};

#endif

} // namespace kith::detail
