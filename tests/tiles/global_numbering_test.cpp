// SPDX-License-Identifier: BSD-3-Clause
#include "support/every_scheme.hpp"
#include "support/tiles.hpp"

#include <kith/tiles/number/global_numbering.hpp>

#include <array>

namespace {

/// Calls test(numbering of the whole mesh, global numbering from the tiles) for one step of each scheme. Steps start
/// from control meshes and from their first and second levels.
template <class Test>
void for_each_numbering(const Test& test)
{
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& control) {
        if constexpr (kith::reaching_scheme<Scheme>)
            for (const int level : {0, 1, 2}) {
                if (kith::marks_edges<Scheme> and level == 0) // any edges may be marked
                    continue;
                const auto mesh = kith::refine(control, scheme, level);
                const auto columns = columns_of(scheme, mesh.generation());
                const kith::numbering_of<Scheme, std::uint32_t> expected(kith::level_of<mesh3d>(mesh), columns);
                kith::tile_cutter cutter(mesh, scheme, partitions::scattered(mesh.face_count(), 3, 1), 3);
                std::array<std::vector<kith::boundary_fact>, 3> facts;
                for (std::size_t part = 3; part-- > 0;) {
                    auto more = kith::global_numbering<kith::columns_type<Scheme>>::facts_at_boundary(
                        columns, cutter.cut(part, 1).part);
                    for (std::size_t i = 0; i < 3; ++i)
                        facts[i].insert(facts[i].end(), more[i].begin(), more[i].end());
                }
                test(expected,
                     kith::global_numbering<kith::columns_type<Scheme>>(
                         cutter.counts(), columns, cutter.cut_rim(1).part));
                test(expected, kith::global_numbering<kith::columns_type<Scheme>>(cutter.counts(), columns, facts));
            }
    });
}

template <class Ids, class WholeIds>
void expect_same(const Ids& here, const WholeIds& there)
{
    ASSERT_EQ(there.total(), here.total());
    for (std::size_t id = 0; id < here.total(); ++id) {
        const auto [kind, tuple] = here.origin(id);
        const auto origin = there.origin(id);
        ASSERT_EQ(origin.kind, kind);
        ASSERT_EQ(origin.id, tuple);
        ASSERT_EQ(there.id(origin), id);
    }
}

} // namespace

TEST(global_numbering, leads_from_tuples_to_new_elements_and_back)
{
    for_each_numbering([](const auto& here, const auto& there) {
        expect_same(here.vertices, there.vertices);
        expect_same(here.edges, there.edges);
        expect_same(here.faces, there.faces);
    });
}
