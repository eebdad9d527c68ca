// SPDX-License-Identifier: BSD-3-Clause
#include <kith/refine.hpp>

#include "support/consistent.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>

// The built-in schemes declare that they are trusted. These tests show that they may.

namespace {

/// A built-in scheme with every association checked.
template <class S>
struct checked : S {
    static constexpr auto traits()
    {
        auto result = kith::traits_of<S>;
        result.trusted = false;
        return result;
    }
};

constexpr int levels = 3;

template <class S>
constexpr bool is_mid_edge = std::same_as<std::remove_cvref_t<S>, kith::mid_edge>;

} // namespace

TEST(checked, no_scheme_reads_or_sets_an_association_wrongly)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        using scheme_type = std::remove_cvref_t<decltype(scheme)>;
        EXPECT_NO_THROW(kith::refine(mesh, checked<scheme_type>{scheme}, levels));
    });
}

TEST(checked, checking_changes_no_bit)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        using scheme_type = std::remove_cvref_t<decltype(scheme)>;
        EXPECT_TRUE(same_bits(kith::refine(mesh, checked<scheme_type>{scheme}, 2), kith::refine(mesh, scheme, 2)));
    });
}

TEST(checked, the_connectivity_that_schemes_write_is_consistent)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, mesh3d mesh) {
        for (int level = 1; level <= levels; ++level) {
            mesh = kith::refine(mesh, scheme, 1);
            SCOPED_TRACE(level);
            expect_consistent(mesh.topology());
        }
    });
}

TEST(checked, plans_are_the_counts_of_the_levels)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, mesh3d mesh) {
        const auto control = count(mesh.topology());
        const auto plan = kith::plan(control, scheme, levels, mesh.generation());
        const bool is_exact = not is_mid_edge<decltype(scheme)> or control.boundary_edges == 0;
        for (std::size_t level = 1; level <= (is_exact ? levels : 1); ++level) {
            SCOPED_TRACE(level);
            mesh = kith::refine(mesh, scheme, 1);
            const auto& planned = plan[level].counts;
            EXPECT_EQ(planned.vertices, mesh.vertex_count());
            EXPECT_EQ(planned.edges, mesh.edge_count());
            EXPECT_EQ(planned.faces, mesh.face_count());
            EXPECT_EQ(planned.corners(), mesh.corner_count());
        }
    });
}

TEST(checked, plans_of_the_mid_edge_scheme_with_a_boundary_are_upper_bounds)
{
    for_each_other_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if constexpr (is_mid_edge<decltype(scheme)>) {
            const auto planned = kith::plan(count(mesh.topology()), scheme, levels).back().counts;
            const auto fine = kith::refine(mesh, scheme, levels);
            EXPECT_GE(planned.vertices, fine.vertex_count());
            EXPECT_GE(planned.edges, fine.edge_count());
            EXPECT_GE(planned.faces, fine.face_count());
        }
    });
}

TEST(checked, plans_are_never_short_of_bytes)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const auto planned = kith::plan(count(mesh.topology()), scheme, levels, mesh.generation()).back();
        const auto bytes_of = [](const mesh3d& m) {
            const auto& t = m.topology();
            std::size_t indices = 0;
            for (const auto* array : {&t.corner_vertex,
                                      &t.corner_halfedge,
                                      &t.halfedge_corner,
                                      &t.vertex_corner,
                                      &t.face_corner,
                                      &t.corner_face})
                indices += array->size();
            return m.points().size_bytes() + indices * sizeof(std::uint32_t);
        };
        EXPECT_GE(planned.bytes, bytes_of(kith::refine(mesh, scheme, levels)));
        EXPECT_GE(planned.least_bytes,
                  bytes_of(kith::refine(mesh, scheme, levels, {.last_level = kith::connect::faces})));
        EXPECT_LE(planned.least_bytes, planned.bytes);
    });
}
