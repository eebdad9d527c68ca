// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbered_tile.hpp"

#include <kith/base/error.hpp>
#include <kith/base/storage.hpp>
#include <kith/neighbourhood/descents.hpp>
#include <kith/patch/patch_writer.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// Writes what a tile knows of the faces that descend from its owned ones in an earlier level, in their order. `there`
/// are the descents of faces in the whole mesh.
template <class Point, std::unsigned_integral Index>
void number_owned_faces(const tile<Point, Index>& coarse, std::span<const Index> owned, std::span<const descent> there,
                        tile<Point, Index>& result)
{
    std::size_t each = 0;
    for (const descent& way : there)
        each += way.each;
    const std::size_t size = each * owned.size();
    result.face_ids = storage<global_id>(size);
    result.root_of = storage<Index>(size);
    result.face_marks = storage<unsigned char>(size);
    std::ranges::fill(result.face_marks, owned_mark);
    result.roots = coarse.roots;
    global_id* id = result.face_ids.data();
    Index* root = result.root_of.data();
    for (const descent& way : there)
        for (const Index f : owned) {
            std::iota(id, id + way.each, way.first + way.each * coarse.face_ids[f]);
            id += way.each;
            root = std::fill_n(root, way.each, coarse.root_of[f]);
        }
}

#ifdef KITH_HAS_LANES

/// Makes the last level of a tile from what patches have made of it and of its rim. Its elements are known by their
/// descent from the level whose faces own patches.
template <class Point, std::unsigned_integral Index>
class tile_of_patches {
public:
    /// `here` and `there` are the columns of the steps in the mesh of the tile and in the whole mesh, which make `last`
    /// and so many vertices; all faces have this degree. `coarse` must outlive this object.
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
        , owned_(owned_faces_of(coarse))
    {
        KITH_ASSERT(vertices_.size() == vertices_there_.size() and faces_.size() == faces_there_.size());
        std::vector<unsigned char> is_near(coarse.mesh.vertex_count(), 0);
        for (const Index f : owned_)
            for (const Index v : coarse.mesh.face(f))
                is_near[v] = 1;
        is_patched_.assign(coarse.mesh.face_count(), 0);
        for (std::size_t f = 0; f < is_patched_.size(); ++f)
            is_patched_[f] = std::ranges::any_of(coarse.mesh.face(f), [&](Index v) { return is_near[v] != 0; });
        for (std::size_t f = 0; f < is_patched_.size(); ++f)
            if (is_patched_[f] != 0 and not coarse.owns_face(f))
                rim_.push_back(Index(f));
        is_whole_ = owned_.size() == coarse.mesh.face_count() and last.vertices == vertices_there;
    }

    /// Returns marks of the faces of the coarse tile whose patches are needed: the owned ones and those around them.
    [[nodiscard]] std::span<const unsigned char> is_patched() const { return is_patched_; }
    /// Makes room for the patches, which are written in the numbers of the refined mesh of the tile.
    [[nodiscard]] patch_output<Point, Index> make_room()
    {
        points_ = storage<Point>(last_.vertices);
        corner_vertex_ = storage<Index>(degree_ * last_.faces);
        return {.points = points_.data(), .corner_vertex = corner_vertex_.data()};
    }

    /// Returns the owned faces and their vertices. Precondition: the patches have been written. Cost: O(last level).
    [[nodiscard]] tile<Point, Index> take(int generation)
    {
        tile<Point, Index> result;
        const auto marks = marks_of_vertices();
        number_vertices(marks, result);
        number_owned_faces<Point, Index>(coarse_, owned_, faces_there_, result);
        auto faces = taken_faces(result.face_ids.size());
        faces.vertices = result.vertex_ids.size();
        corner_vertex_ = {}; // before there are points twice
        result.mesh = basic_mesh<Point, Index>(taken_points(marks, faces.vertices), std::move(faces), generation);
        return result;
    }

private:
    enum : unsigned char { ours = 1, at_rim = 2, rim_comes_first = 4 };

    /// Calls f(face, vertex) for the corners of all descendants of some faces, in the order of their numbers.
    template <class F>
    void for_each_corner(std::span<const Index> coarse_faces, const F& f) const
    {
        for (const descent& way : faces_)
            for (const Index coarse_face : coarse_faces) {
                const std::size_t first = way.first + way.each * coarse_face;
                const Index* vertex = corner_vertex_.data() + first * degree_;
                for (std::size_t face = first; face < first + way.each; ++face)
                    for (std::size_t k = 0; k < degree_; ++k)
                        f(Index(face), *vertex++);
            }
    }
    /// Marks the vertices of owned faces, and of those at the rim whether the first face is there.
    [[nodiscard]] storage<unsigned char> marks_of_vertices() const
    {
        storage<unsigned char> marks(points_.size());
        std::ranges::fill(marks, is_whole_ ? ours : 0);
        if (is_whole_)
            return marks;
        storage<Index> first_at_rim(points_.size()); // of the faces of a vertex, if it is marked
        for_each_corner(rim_, [&](Index face, Index v) {
            if (marks[v] == 0)
                first_at_rim[v] = face;
            marks[v] = at_rim;
        });
        for_each_corner(owned_, [&](Index face, Index v) {
            if ((marks[v] & ours) == 0 and marks[v] != 0 and first_at_rim[v] < face)
                marks[v] |= rim_comes_first;
            marks[v] |= ours;
        });
        return marks;
    }
    /// Numbers the vertices of owned faces one after the other, and writes what the tile knows of them.
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
            const auto ids = ids_of(coarse_, parent_kind(way.from));
            for (std::size_t x = 0; x < ids.size(); ++x) {
                const std::size_t first = way.first + way.each * x;
                const global_id first_there = there.first + there.each * ids[x];
                const bool is_of_other = of_faces and not coarse_.owns_face(x);
                for (std::size_t which = 0; which < way.each; ++which) {
                    const std::size_t v = first + which;
                    if ((marks[v] & ours) == 0)
                        continue;
                    const bool is_owned = of_faces ? not is_of_other : (marks[v] & rim_comes_first) == 0;
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
    [[nodiscard]] connectivity<Index> taken_faces(std::size_t size)
    {
        connectivity<Index> faces;
        faces.allocate_faces(size, int(degree_), [&](std::size_t) { return degree_; });
        if (is_whole_ and corner_vertex_.size() == faces.corner_vertex.size()) {
            faces.corner_vertex = std::move(corner_vertex_);
            return faces;
        }
        Index* to = faces.corner_vertex.data();
        for_each_corner(owned_, [&](Index, Index v) { *to++ = number_[v]; });
        return faces;
    }

    const tile<Point, Index>& coarse_;
    std::size_t degree_; // of the faces
    std::vector<descent> vertices_, vertices_there_, faces_, faces_there_;
    counts last_;
    storage<Point> points_; // of the refined mesh of the tile, as far as patches have written it
    storage<Index> corner_vertex_;
    storage<Index> number_;          // of each of its vertices that is taken
    std::vector<Index> owned_, rim_; // faces of the coarse tile; the rim is around the owned ones
    std::vector<unsigned char> is_patched_;
    bool is_whole_; // all vertices are taken, with their numbers
};

#endif

} // namespace kith::detail
