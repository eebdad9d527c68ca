// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/refine/known_faces.hpp>
#include <kith/tiles/refine/pack.hpp>
#include <kith/tiles/refine/tile_job.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith::detail {

/// Some elements of a level by their global numbers, increasing.
struct global_elements {
    std::vector<global_id> vertices, edges, faces;
    std::vector<std::uint64_t> degrees; ///< of the faces
};
/// Returns the first corner of a face of a tile, and the number of its corners.
template <tile_like Tile, std::unsigned_integral Face>
auto corners_of(const Tile& part, Face f)
{
    using index = typename Tile::index_type;
    return typename part_numbers<index>::face_corners{index(part.mesh.topology().first_corner(f)),
                                                      index(part.mesh.face(f).size())};
}
template <tile_like Tile>
global_elements elements_of(const Tile& part)
{
    const auto list = [](const auto& ids) { return std::vector<global_id>(ids.begin(), ids.end()); };
    global_elements result{list(part.vertex_ids), list(part.edge_ids), list(part.face_ids), {}};
    for (std::size_t f = 0; f < result.faces.size(); ++f)
        result.degrees.push_back(corners_of(part, f).count);
    return result;
}

/// A scheme with the state of some elements only. It numbers them by their indices in these lists.
template <scheme Scheme>
struct known_state {
    Scheme scheme;
    global_elements elements;
};

/// Returns the state that the scheme of a tile has for some faces, their edges and their vertices.
template <tile_like Tile, scheme Scheme, std::unsigned_integral Index>
known_state<Scheme> state_at_faces(const Tile& part, const Scheme& scheme, std::vector<Index> faces)
{
    const auto& t = part.mesh.topology();
    std::vector<Index> vertices, edges;
    for (const Index f : faces)
        for (Index c = t.first_corner(f); c < t.first_corner(std::size_t(f) + 1); ++c) {
            vertices.push_back(t.corner_vertex[c]);
            edges.push_back(t.corner_halfedge[c] / 2);
        }
    for (auto* list : {&vertices, &edges, &faces}) {
        std::ranges::sort(*list);
        list->erase(std::ranges::unique(*list).begin(), list->end());
    }
    const auto ids = [](const std::vector<Index>& numbers, const auto& all) {
        std::vector<global_id> result;
        for (const Index x : numbers)
            result.push_back(all[x]);
        return result;
    };
    std::vector<typename part_numbers<Index>::face_corners> corners;
    std::vector<std::uint64_t> degrees;
    for (const Index f : faces) {
        corners.push_back(corners_of(part, f));
        degrees.push_back(corners.back().count);
    }
    return {scheme_of_part(scheme, part_numbers<Index>{vertices, edges, faces, 0, corners}),
            {ids(vertices, part.vertex_ids), ids(edges, part.edge_ids), ids(faces, part.face_ids), std::move(degrees)}};
}

template <scheme Scheme>
void pack_known_state(packer& out, const known_state<Scheme>& known)
{
    out.add_array(known.elements.vertices).add_array(known.elements.edges).add_array(known.elements.faces);
    out.add_array(known.elements.degrees);
    pack_state(out, known.scheme);
}
/// Returns the state that pack_known_state has added. `scheme` has the options of the packed scheme; its state is
/// replaced.
template <scheme Scheme>
known_state<Scheme> unpack_known_state(unpacker& in, Scheme scheme)
{
    using ids = std::vector<global_id>;
    global_elements elements;
    elements.vertices = in.get_array<ids>();
    elements.edges = in.get_array<ids>();
    elements.faces = in.get_array<ids>();
    elements.degrees = in.get_array<std::vector<std::uint64_t>>();
    unpack_state(in, scheme);
    return {std::move(scheme), std::move(elements)};
}

/// Adds faces to a message.
template <class Point>
void pack_faces(packer& out, const known_faces<Point>& some)
{
    out.add_array(some.faces).add_array(some.corners).add_array(some.vertices);
}
/// Returns the faces that pack_faces has added. Errors: pack_error.
template <class Point>
known_faces<Point> unpack_faces(unpacker& in)
{
    known_faces<Point> result;
    result.faces = in.get_array<decltype(result.faces)>();
    result.corners = in.get_array<decltype(result.corners)>();
    result.vertices = in.get_array<decltype(result.vertices)>();
    return result;
}

/// Adds to the state of a scheme that of another scheme of its type for a part. `part` has the numbers of the part's
/// elements in `scheme`.
template <scheme Scheme, std::unsigned_integral Index>
void add_state(Scheme& scheme, const Scheme& of_part, const part_numbers<Index>& part)
{
    for_each_state(scheme, of_part, [&]<class State>(State& state, const State& more) {
        constexpr bool joins = requires { state.add_part(more, part); };
        static_assert(
            joins,
            "the state that a scheme names in its traits() needs add_part(const T&, const part_numbers<Index>&), the "
            "inverse of of_part, to be gathered on one rank and to be refined with ghosts that are fetched; give it "
            "that, or "
            "use rank_refinement");
        if constexpr (joins)
            state.add_part(more, part);
    });
}

/// Adds to the state of a tile's scheme that of another scheme of its type, for the known elements that the tile has.
/// Cost: O(n log n) for n elements.
template <scheme Scheme, tile_like Tile>
void take_over(Scheme& scheme, const Tile& part, const Scheme& other, const global_elements& known)
{
    using index = typename Tile::index_type;
    struct numbers {
        std::vector<index> there, here;
    };
    const auto common = [](const std::vector<global_id>& theirs, const auto& ours) {
        numbers result;
        for (std::size_t x = 0; x < ours.size(); ++x)
            if (const auto found = std::ranges::lower_bound(theirs, ours[x]);
                found != theirs.end() and *found == ours[x]) {
                result.there.push_back(index(found - theirs.begin()));
                result.here.push_back(index(x));
            }
        return result;
    };
    const numbers vertices = common(known.vertices, part.vertex_ids), edges = common(known.edges, part.edge_ids),
                  faces = common(known.faces, part.face_ids);
    using face_corners = typename part_numbers<index>::face_corners;
    std::vector<face_corners> all_there, there, here_corners;
    for (index first = 0; const auto degree : known.degrees) {
        all_there.push_back({first, index(degree)});
        first += index(degree);
    }
    for (std::size_t i = 0; i < faces.here.size(); ++i) {
        there.push_back(all_there[faces.there[i]]);
        here_corners.push_back(corners_of(part, faces.here[i]));
    }
    const Scheme shared = scheme_of_part(other,
                                         part_numbers<index>{vertices.there, edges.there, faces.there, 0, there});
    add_state(scheme, shared, part_numbers<index>{vertices.here, edges.here, faces.here, 0, here_corners});
}

} // namespace kith::detail
