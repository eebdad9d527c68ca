// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/connectivity.hpp>
#include <kith/numbering/association/tuples.hpp>
#include <kith/numbering/step/children.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace kith {

/// A tuple of elements of a face, given by a corner of the face. (v) and (v,f) are at the vertex of the corner. (e) and
/// (e,f) have the side that leaves the corner. (v,e) is at the start of that side if `is_first`, else at its end.
/// (v,f,e) has that side if `is_first`, else the side that leads to the corner. (f) has corner 0.
struct tuple_in_face {
    tuple_kind kind;
    std::uint8_t corner = 0;
    bool is_first = true;

    friend bool operator==(const tuple_in_face&, const tuple_in_face&) = default;
};

/// The faces that a step makes of each face of a level, where faces come from faces and have one degree.
struct face_children {
    /// A new face: its tuple, (f), (v,f), (e,f) or (v,f,e), and its corners.
    struct child {
        tuple_in_face born;
        std::vector<std::uint8_t> vertices; ///< for each corner the index of its tuple in `tuples`
        std::vector<std::uint8_t> along;    ///< for each corner 1 + the corner to which a side of the face leads that
                                            ///< contains the side to this corner; 0 if that lies inside the face

        /// Returns the index of the tuple that made this child of a face, in its column. All faces have this degree.
        [[nodiscard]] std::size_t tuple_of(std::size_t face, std::size_t degree) const
        {
            const std::size_t corner = degree * face + born.corner;
            return born.kind == tuple_kind::f     ? face
                   : born.kind == tuple_kind::vfe ? 2 * corner + !born.is_first
                                                  : corner;
        }
    };

    std::size_t degree;
    std::vector<tuple_in_face> tuples; ///< the tuples that make the vertices of the children
    std::vector<child> children;
    bool ends_lie_along_edges = false, middles_lie_along_edges = false; ///< of new edges from tuples (v,e) and (e)
};

namespace detail {

/// A face of a level, in terms of which tuples are expressed.
template <std::unsigned_integral Index>
class tuples_around_face {
public:
    tuples_around_face(const connectivity<Index>& level, std::size_t face)
        : level_(level), first_(level.first_corner(face)), degree_(level.first_corner(face + 1) - first_)
    {
    }

    /// Returns a tuple in terms of the face, or nothing if it has elements outside the face.
    [[nodiscard]] std::optional<tuple_in_face> find(tuple_kind kind, std::size_t tuple) const
    {
        const auto corner_where = [&](const auto& is_here) -> std::optional<std::uint8_t> {
            for (std::size_t k = 0; k < degree_; ++k)
                if (is_here(Index(first_ + k)))
                    return std::uint8_t(k);
            return {};
        };
        const auto make = [&](const std::optional<std::uint8_t>& corner, bool is_first = true) {
            return corner ? std::optional(tuple_in_face{kind, *corner, is_first}) : std::nullopt;
        };
        switch (kind) {
        case tuple_kind::v: return make(corner_where([&](Index c) { return level_.corner_vertex[c] == tuple; }));
        case tuple_kind::e: return make(side_of(tuple, corner_where));
        case tuple_kind::ve: {
            // The first end of an edge is its origin, which its half-edge 0 leaves.
            const auto corner = side_of(tuple / 2, corner_where);
            return corner ? make(corner, (level_.corner_halfedge[first_ + *corner] % 2 == 0) == (tuple % 2 == 0))
                          : std::nullopt;
        }
        case tuple_kind::f:
            return tuple == std::size_t(level_.face_of(Index(first_))) ? std::optional(tuple_in_face{kind})
                                                                       : std::nullopt;
        case tuple_kind::vfe: return make(corner_where([&](Index c) { return c == tuple / 2; }), tuple % 2 == 0);
        default: return make(corner_where([&](Index c) { return c == tuple; }));
        }
    }

private:
    template <class CornerWhere>
    [[nodiscard]] std::optional<std::uint8_t> side_of(std::size_t edge, const CornerWhere& corner_where) const
    {
        return corner_where([&](Index c) { return level_.corner_halfedge[c] / 2 == edge; });
    }

    const connectivity<Index>& level_;
    std::size_t first_, degree_;
};

/// Returns 1 + the corner to which a side of a face leads that contains both tuples, or 0 if there is no such side. The
/// face has this degree.
inline std::uint8_t side_with(const tuple_in_face& from, const tuple_in_face& to, std::size_t degree)
{
    const auto lies_on = [&](const tuple_in_face& tuple, std::size_t side) {
        switch (tuple.kind) {
        case tuple_kind::v: return tuple.corner == side or tuple.corner == (side + 1) % degree;
        case tuple_kind::e:
        case tuple_kind::ve: return tuple.corner == side;
        default: return false;
        }
    };
    for (std::size_t side = 0; side < degree; ++side)
        if (lies_on(from, side) and lies_on(to, side))
            return std::uint8_t(1 + (side + 1) % degree);
    return 0;
}

} // namespace detail

/// Returns the faces that a step makes of a face of a level. Returns nothing if their vertices come from other faces,
/// too. `fine` is the next level and `ids` are the numbers of the step.
/// Precondition: the scheme of the step ignores numbers, so that all inner faces are alike. Cost: O(faces of fine).
template <std::unsigned_integral Index, level_numbering Ids>
std::optional<face_children> children_of_face(const connectivity<Index>& level, std::size_t face,
                                              const connectivity<Index>& fine, const Ids& ids)
{
    const detail::tuples_around_face<Index> here(level, face);
    face_children result{std::size_t(level.first_corner(face + 1) - level.first_corner(face)), {}, {}};
    for (std::size_t f = 0; f < fine.faces; ++f) {
        const auto [kind, tuple] = ids.faces.origin(f);
        const std::size_t from = parent_by(kind, tuple, [&](std::size_t c) { return level.face_of(Index(c)); });
        if (parent_kind(kind) != element_kind::face or from != face)
            continue;
        face_children::child child{*here.find(kind, tuple), {}, {}};
        for (Index c = fine.first_corner(f); c < fine.first_corner(f + 1); ++c) {
            const auto [vertex_kind, of_vertex] = ids.vertices.origin(fine.corner_vertex[c]);
            const auto at = here.find(vertex_kind, of_vertex);
            if (not at)
                return {};
            auto known = std::ranges::find(result.tuples, *at);
            if (known == result.tuples.end())
                known = result.tuples.insert(known, *at);
            child.vertices.push_back(std::uint8_t(known - result.tuples.begin()));
        }
        const std::size_t n = child.vertices.size();
        for (std::size_t k = 0; k < n; ++k)
            child.along.push_back(detail::side_with(
                result.tuples[child.vertices[(k + n - 1) % n]], result.tuples[child.vertices[k]], result.degree));
        result.children.push_back(std::move(child));
    }
    if constexpr (Ids::has_edges)
        for (std::size_t e = 0; e < fine.edges(); ++e) {
            const auto [kind, tuple] = ids.edges.origin(e);
            if (parent_kind(kind) != element_kind::edge or not here.find(kind, tuple))
                continue;
            const Index c = fine.halfedge_corner[2 * e] != fine.none ? fine.halfedge_corner[2 * e]
                                                                     : fine.halfedge_corner[2 * e + 1];
            const auto tuple_at = [&](Index corner) {
                const auto [vertex_kind, of_vertex] = ids.vertices.origin(fine.corner_vertex[corner]);
                return here.find(vertex_kind, of_vertex);
            };
            const auto from = tuple_at(c), to = tuple_at(fine.next(c));
            const bool lies_along = from and to and detail::side_with(*from, *to, result.degree) != 0;
            (kind == tuple_kind::e ? result.middles_lie_along_edges : result.ends_lie_along_edges) = lies_along;
        }
    return result;
}

} // namespace kith
