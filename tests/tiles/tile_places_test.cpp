// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tiles/part/tile_places.hpp>

#include "support/every_level.hpp"
#include "support/tiles.hpp"

#include <kith/catmull_clark.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace {

using kith::tile_place;
using parts = std::set<std::uint32_t>; // of the faces at an element of the whole mesh

tile_place place_in(std::uint32_t part, const parts& of_faces)
{
    if (not of_faces.contains(part))
        return tile_place::ghost;
    return of_faces.size() == 1 ? tile_place::inner : tile_place::boundary;
}

} // namespace

TEST(tile_places, say_which_tiles_have_the_faces_at_an_element)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const mesh3d mesh = native(shape);
        const level_type level(mesh);
        const auto part_of = partitions::scattered(mesh.face_count(), 3, 7);
        kith::tile_cutter cutter(mesh, kith::catmull_clark(), part_of, 3);
        for (std::uint32_t p = 0; p < 3; ++p) {
            const auto tile = cutter.cut(p, 2).part;
            const kith::tile_places places = places_of(tile);
            for (std::size_t v = 0; v < tile.vertex_ids.size(); ++v) {
                parts of_faces;
                for (const auto f : level.vertices()[tile.vertex_ids[v]].faces())
                    of_faces.insert(part_of[f.index()]);
                EXPECT_EQ(places.vertices[v], place_in(p, of_faces)) << "vertex " << tile.vertex_ids[v];
            }
            for (std::size_t e = 0; e < tile.edge_ids.size(); ++e) {
                const auto edge = level.edges()[tile.edge_ids[e]];
                parts of_faces{part_of[edge.lface().index()]};
                if (not edge.is_boundary())
                    of_faces.insert(part_of[edge.rface().index()]);
                EXPECT_EQ(places.edges[e], place_in(p, of_faces)) << "edge " << tile.edge_ids[e];
            }
            for (std::size_t f = 0; f < tile.face_ids.size(); ++f) {
                parts of_faces{part_of[tile.face_ids[f]]};
                if (of_faces.contains(p))
                    for (const auto v : level.faces()[tile.face_ids[f]].vertices())
                        for (const auto at_vertex : v.faces())
                            of_faces.insert(part_of[at_vertex.index()]);
                EXPECT_EQ(places.faces[f], place_in(p, of_faces)) << "face " << tile.face_ids[f];
            }
        }
    }
}
