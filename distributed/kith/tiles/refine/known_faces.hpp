// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/submesh.hpp>
#include <kith/tiles/part/tile.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// Some faces of a level, with all data that a tile has of them, in the numbers of the whole mesh. Lists of such faces
/// may be joined, so that a face occurs several times, and turned into tiles again.
template <class Point>
struct known_faces {
    struct face {
        global_id id, first_corner, root;
        std::uint64_t degree;
    };
    struct corner {
        global_id vertex;
        global_id end;           ///< 2e+s, for side s of edge e, which lies in the face
        std::uint64_t has_other; ///< true if the edge has another face in the whole mesh
    };
    struct vertex {
        global_id id;
        /// The face at which the fan of the vertex starts, and the corner within that face; ~0 if unknown.
        global_id first_face, first_corner;
        global_id corners_before; ///< see tile
        Point point;
    };

    std::vector<face> faces;
    std::vector<corner> corners;  ///< grouped by face
    std::vector<vertex> vertices; ///< of all corners, in any order, with or without repetition

    void append(const known_faces& more)
    {
        faces.insert(faces.end(), more.faces.begin(), more.faces.end());
        corners.insert(corners.end(), more.corners.begin(), more.corners.end());
        vertices.insert(vertices.end(), more.vertices.begin(), more.vertices.end());
    }
    /// Appends one face of `from`, whose vertices are in the order of its corners; `first` is the first corner of the
    /// face.
    void append_face(const known_faces& from, std::size_t face, std::size_t first)
    {
        const auto begin = std::ptrdiff_t(first), end = std::ptrdiff_t(first + from.faces[face].degree);
        faces.push_back(from.faces[face]);
        corners.insert(corners.end(), from.corners.begin() + begin, from.corners.begin() + end);
        vertices.insert(vertices.end(), from.vertices.begin() + begin, from.vertices.begin() + end);
    }
};

/// Returns these faces of a tile that has its edges. The start of a vertex's fan is known if all its faces are in the
/// tile.
template <class Point, std::unsigned_integral Index>
known_faces<Point> known_faces_of(const tile<Point, Index>& part, std::span<const Index> faces)
{
    constexpr global_id unknown = ~global_id(0);
    const auto& t = part.mesh.topology();
    known_faces<Point> result;
    for (const Index f : faces) {
        const auto vertices = part.mesh.face(f);
        result.faces.push_back({part.face_ids[f], part.corner_id(f, 0), part.root(f), vertices.size()});
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const Index half = t.corner_halfedge[t.first_corner(f) + k], v = vertices[k], start = t.vertex_corner[v];
            result.corners.push_back({part.vertex_ids[v],
                                      part.end_id(half / 2, half % 2),
                                      t.halfedge_corner[half ^ 1] != t.none or part.is_cut(half / 2)});
            const bool is_closed = t.across(start) != t.none;
            const Index first = t.face_of(start);
            result.vertices.push_back({part.vertex_ids[v],
                                       is_closed ? part.face_ids[first] : unknown,
                                       is_closed ? start - t.first_corner(first) : unknown,
                                       part.corners_before.empty() ? 0 : part.corners_before[v],
                                       part.mesh.point(v)});
        }
    }
    return result;
}

namespace detail {

/// A builder of a tile from known faces, without the marks of ownership.
template <class Point, std::unsigned_integral Index>
class known_faces_builder {
    using facts = known_faces<Point>;
    static constexpr Index none = connectivity<Index>::none;

public:
    explicit known_faces_builder(facts all) : all_(std::move(all))
    {
        std::size_t corner = 0;
        for (const auto& f : all_.faces) {
            faces_.push_back({&f, corner});
            corner += f.degree;
        }
        const auto face_id = [](const placed_face& f) { return f.face->id; };
        std::ranges::sort(faces_, {}, face_id);
        faces_.erase(std::ranges::unique(faces_, {}, face_id).begin(), faces_.end());
        std::ranges::sort(all_.vertices, {}, [](const auto& v) { return std::tuple(v.id, v.first_face); });
        all_.vertices.erase(std::ranges::unique(all_.vertices, {}, &facts::vertex::id).begin(), all_.vertices.end());
        for (const auto& f : faces_)
            for (std::size_t k = 0; k < f.face->degree; ++k)
                edges_.push_back(all_.corners[f.corner + k].end / 2);
        std::ranges::sort(edges_);
        edges_.erase(std::ranges::unique(edges_).begin(), edges_.end());
    }

    [[nodiscard]] tile<Point, Index> build(bool with_first_corners, int generation, bool with_corners_before) const
    {
        tile<Point, Index> result;
        connectivity<Index> t;
        fill_corners(t, result);
        std::vector<global_id> vertex_ids;
        for (const auto& v : all_.vertices)
            vertex_ids.push_back(v.id);
        split_fans(t, vertex_ids);
        storage<Point> points(t.vertices);
        result.vertex_marks = storage<unsigned char>(t.vertices, 0);
        if (with_corners_before)
            result.corners_before = storage<global_id>(t.vertices);
        for (std::size_t v = 0; v < t.vertices; ++v) {
            const auto& known = *std::ranges::lower_bound(all_.vertices, vertex_ids[v], {}, &facts::vertex::id);
            points[v] = known.point;
            if (with_corners_before)
                result.corners_before[v] = known.corners_before;
            if (t.vertex_corner[v] == none)
                t.vertex_corner[v] = Index(t.first_corner(local_face(known.first_face)) + known.first_corner);
        }
        result.vertex_ids = storage<global_id>(vertex_ids);
        result.edge_ids = storage<global_id>(edges_);
        fill_faces(result, with_first_corners);
        result.mesh = {std::move(points), std::move(t), generation};
        return result;
    }

private:
    struct placed_face {
        const typename facts::face* face;
        std::size_t corner; // the first corner of the face
    };

    [[nodiscard]] std::size_t local_face(global_id id) const
    {
        const auto face_id = [](const placed_face& f) { return f.face->id; };
        return std::size_t(std::ranges::lower_bound(faces_, id, {}, face_id) - faces_.begin());
    }
    [[nodiscard]] std::size_t local_edge(global_id end) const
    {
        return std::size_t(std::ranges::lower_bound(edges_, end / 2) - edges_.begin());
    }

    /// Returns 3 or 4 if all faces have that many corners, else 0.
    [[nodiscard]] int degree_of_all() const
    {
        const std::uint64_t first = faces_.empty() ? 0 : faces_.front().face->degree;
        const auto is_like_first = [&](const placed_face& f) { return f.face->degree == first; };
        return (first == 3 or first == 4) and std::ranges::all_of(faces_, is_like_first) ? int(first) : 0;
    }

    void fill_corners(connectivity<Index>& t, tile<Point, Index>& result) const
    {
        t.vertices = all_.vertices.size();
        t.allocate_faces(faces_.size(), degree_of_all(), [this](std::size_t f) { return faces_[f].face->degree; });
        t.allocate_edges(edges_.size());
        // Side 0 of an edge in the tile always has a face. If only side 1 has a face in the tile, the edge is turned.
        std::vector<unsigned char> left_is_here(edges_.size(), 0);
        for (const auto& f : faces_)
            for (std::size_t k = 0; k < f.face->degree; ++k)
                if (const global_id end = all_.corners[f.corner + k].end; end % 2 == 0)
                    left_is_here[local_edge(end)] = 1;
        result.edge_marks = storage<unsigned char>(edges_.size(), 0);
        std::size_t c = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            for (std::size_t k = 0; k < faces_[f].face->degree; ++k, ++c) {
                const auto& corner = all_.corners[faces_[f].corner + k];
                const std::size_t edge = local_edge(corner.end);
                const bool turned = left_is_here[edge] == 0;
                const std::size_t half = 2 * edge + (corner.end % 2 ^ std::size_t(turned));
                t.set_side(Index(c), Index(half));
                t.corner_vertex[c] = Index(
                    std::ranges::lower_bound(all_.vertices, corner.vertex, {}, &facts::vertex::id) -
                    all_.vertices.begin());
                result.edge_marks[edge] = static_cast<unsigned char>((turned ? turned_mark : 0) |
                                                                     (corner.has_other != 0 ? cut_mark : 0));
            }
        }
        for (std::size_t e = 0; e < edges_.size(); ++e)
            if (not t.is_boundary(e))
                result.edge_marks[e] = 0;
    }

    void fill_faces(tile<Point, Index>& result, bool with_first_corners) const
    {
        std::vector<global_id> roots;
        for (const auto& f : faces_)
            roots.push_back(f.face->root);
        std::ranges::sort(roots);
        roots.erase(std::ranges::unique(roots).begin(), roots.end());
        result.roots = storage<global_id>(roots);
        result.face_ids = storage<global_id>(faces_.size());
        result.root_of = storage<Index>(faces_.size());
        result.face_marks = storage<unsigned char>(faces_.size(), 0);
        if (with_first_corners)
            result.first_corner_ids = storage<global_id>(faces_.size());
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const auto& face = *faces_[f].face;
            result.face_ids[f] = face.id;
            result.root_of[f] = Index(std::ranges::lower_bound(roots, face.root) - roots.begin());
            if (with_first_corners)
                result.first_corner_ids[f] = face.first_corner;
        }
    }

    facts all_;
    std::vector<placed_face> faces_; // by number, without repetition
    std::vector<global_id> edges_;
};

} // namespace detail

/// Returns the tile that consists of these faces and owns none of them yet. `with_first_corners` says that the faces of
/// the whole mesh have several degrees, even if these faces have one. Precondition: if all faces of an inner vertex are
/// given, at least one entry for the vertex has the start of its fan. Cost: O(n log n) for n elements.
template <std::unsigned_integral Index, class Point>
tile<Point, Index> tile_of_faces(known_faces<Point> faces, bool with_first_corners, int generation,
                                 bool with_corners_before)
{
    return detail::known_faces_builder<Point, Index>(std::move(faces))
        .build(with_first_corners, generation, with_corners_before);
}

namespace detail {

/// Marks in a grown tile the elements that the tile owned before.
template <tile_like Tile>
void keep_owned(const Tile& before, Tile& grown)
{
    const auto keep = [](const auto& old_ids, const auto& old_marks, const auto& ids, auto& marks) {
        for (std::size_t x = 0; x < ids.size(); ++x) {
            const auto old = std::lower_bound(old_ids.begin(), old_ids.end(), ids[x]) - old_ids.begin();
            const bool is_copy = x != 0 and ids[x - 1] == ids[x];
            if (std::size_t(old) < old_ids.size() and old_ids[std::size_t(old)] == ids[x] and not is_copy)
                marks[x] = static_cast<unsigned char>(marks[x] | (old_marks[std::size_t(old)] & owned_mark));
        }
    };
    keep(before.vertex_ids, before.vertex_marks, grown.vertex_ids, grown.vertex_marks);
    keep(before.edge_ids, before.edge_marks, grown.edge_ids, grown.edge_marks);
    keep(before.face_ids, before.face_marks, grown.face_ids, grown.face_marks);
}

/// Returns a tile with more faces, which owns the same elements. Cost: O(n log n) for n elements.
template <class Point, std::unsigned_integral Index>
tile<Point, Index> with_faces(const tile<Point, Index>& part, const known_faces<Point>& more)
{
    std::vector<Index> all(part.mesh.face_count());
    std::iota(all.begin(), all.end(), Index(0));
    auto known = known_faces_of(part, std::span<const Index>(all));
    known.append(more);
    auto grown = tile_of_faces<Index>(
        std::move(known), not part.first_corner_ids.empty(), part.mesh.generation(), not part.corners_before.empty());
    keep_owned(part, grown);
    return grown;
}

} // namespace detail

} // namespace kith
