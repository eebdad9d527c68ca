// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tiles/refine/global_levels.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/tiles.hpp"

#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/schemes/split/quad_split.hpp>

#include <gtest/gtest.h>

namespace {

/// A scheme whose even steps split faces into quads, and whose odd steps keep the faces and move the vertices.
struct by_turns {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "by-turns", .reach = [](int rings) { return rings + 1; }};
    }
    static constexpr auto columns(int generation)
    {
        using namespace kith;
        const bool even = generation % 2 == 0;
        const auto degree = [](const auto& f) { return f.degree(); };
        return kith::columns(new_vertices(per_vertex, per_edge.when(even), per_face.when(even)),
                             new_edges(per_edge.when(not even), per_end.when(even), per_side.when(even)),
                             new_faces(quads(per_corner.when(even)), per_face.when(not even).of_degree(degree)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        if (generation % 2 == 0) {
            kith::linear()(r);
            return;
        }
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = 1. / 2 * v + 1. / 2 * average(v.neighbors()); });
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, F) = polygon(
                f.corners(), [&](auto c) { return assoc(c.v(), V) >> assoc(c.next_edge(), E).along(c.next_edge()); });
        });
        for_each(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            const auto k = c.index() - c.f().first_corner().index();
            assoc(v, V).starts_at(assoc(c.f(), F).corner(k), assoc(c.next_edge(), E).along(c.next_edge()));
        });
    }
};

/// A linear split that also makes vertices for tuples that it does not declare; these tuples go into the dictionary.
struct with_dictionary {
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "with-dictionary", .reach = [](int rings) { return rings / 2 + 1; }};
    }
    static constexpr auto columns() { return kith::linear::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        kith::linear()(r);
        for (const auto e : coarse.edges())
            assoc(e.org(), e, V) = 3. / 4 * e.org() + 1. / 4 * e.dst();
    }
};

mesh3d from_generation(const mesh3d& mesh, int generation)
{
    return {kith::storage<shapes::point>(mesh.points()), mesh.topology(), generation};
}

} // namespace

TEST(global_levels, takes_columns_that_alternate_by_generation)
{
    for (const auto& shape : {shapes::shaken(shapes::torus(5, 6)), shapes::shaken(shapes::grid(4, 5))})
        for (const int generation : {0, 1}) {
            const auto mesh = from_generation(native(shape), generation);
            kith::hierarchy levels(mesh, by_turns());
            levels.refine(4);
            const kith::partition parts{partitions::scattered(mesh.face_count(), 4, 1), 5};
            const kith::tiled_refinement refinement(mesh, by_turns(), 4, parts);
            for (int level = 1; level <= 4; ++level) {
                const auto& whole = levels[level];
                EXPECT_EQ(refinement.whole().counts(level),
                          (kith::global_counts{
                              whole.vertex_count(), whole.edge_count(), whole.face_count(), whole.corner_count()}));
                EXPECT_EQ(tiles_differ(mesh, by_turns(), level, parts.part_of, parts.parts), "") << level;
                EXPECT_EQ(tiles_differ(mesh, by_turns(), level, parts.part_of, parts.parts, 0, kith::connect::faces),
                          "")
                    << level;
            }
        }
}

TEST(global_levels, has_no_numbers_for_vertices_of_the_dictionary)
{
    for (const auto& shape : {shapes::torus(5, 6), shapes::grid(4, 5)}) {
        const auto mesh = native(shape);
        const kith::partition parts{partitions::blocks(mesh.face_count(), 3), 3};
        for (const auto last : {kith::connect::faces, kith::connect::everything})
            EXPECT_EQ(error_text<kith::association_error>([&] {
                          kith::tiled_refinement refinement(mesh, with_dictionary(), 2, parts);
                          static_cast<void>(refinement.refine(0, last));
                      }),
                      error_text<kith::association_error>([&] { kith::refine(mesh, with_dictionary(), 1); }));
    }
}
