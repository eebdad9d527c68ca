// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/children.hpp>

#include "support/every_level.hpp"
#include "support/every_scheme.hpp"

#include <gtest/gtest.h>

#include <vector>

using kith::element_kind;
using kith::element_ranges;
using kith::number_range;

namespace {

std::vector<std::size_t> numbers(const std::vector<number_range>& ranges)
{
    std::vector<std::size_t> result;
    for (const auto& [begin, end] : ranges)
        for (std::size_t id = begin; id < end; ++id)
            result.push_back(id);
    return result;
}

element_ranges one(element_kind kind, std::size_t number)
{
    element_ranges result;
    (kind == element_kind::vertex ? result.vertices
     : kind == element_kind::edge ? result.edges
                                  : result.faces) = {{number, number + 1}};
    return result;
}

/// Returns the new elements whose origin names this element as their parent.
std::vector<std::size_t> born_by(const level_type& level, const auto& ids, element_kind kind, std::size_t number)
{
    std::vector<std::size_t> result;
    for (std::size_t id = 0; id < ids.total(); ++id) {
        const auto [of, tuple] = ids.origin(id);
        if (kith::parent_kind(of) == kind and kith::parent(level, of, tuple) == number)
            result.push_back(id);
    }
    return result;
}

} // namespace

TEST(children, are_the_elements_whose_parent_their_origin_names)
{
    for_each_scheme_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        const level_type level(mesh);
        for (const int generation : {0, 1}) {
            const kith::numbering_of<Scheme, std::uint32_t> ids(level, kith::columns_of(scheme, generation));
            const auto test = [&](element_kind kind, std::size_t count) {
                for (std::size_t x = 0; x < count; x += 3) {
                    const auto born = kith::children(level, ids, one(kind, x));
                    EXPECT_EQ(numbers(born.vertices), born_by(level, ids.vertices, kind, x));
                    EXPECT_EQ(numbers(born.edges), born_by(level, ids.edges, kind, x));
                    EXPECT_EQ(numbers(born.faces), born_by(level, ids.faces, kind, x));
                }
            };
            test(element_kind::vertex, mesh.vertex_count());
            test(element_kind::edge, mesh.edge_count());
            test(element_kind::face, mesh.face_count());
        }
    });
}

TEST(children, of_all_elements_are_all_elements_level_by_level)
{
    for_each_scheme_and_shape([]<class Scheme>(const Scheme& scheme, mesh3d mesh) {
        element_ranges all{{{0, mesh.vertex_count()}}, {{0, mesh.edge_count()}}, {{0, mesh.face_count()}}};
        for (int step = 0; step < 2; ++step) {
            kith::numbering_of<Scheme, std::uint32_t> ids;
            auto fine = kith::refine_mesh<kith::connect::everything>(mesh, scheme, ids);
            all = kith::children(level_type(mesh), ids, all);
            mesh = std::move(fine);
            EXPECT_EQ(all,
                      (element_ranges{{{0, mesh.vertex_count()}}, {{0, mesh.edge_count()}}, {{0, mesh.face_count()}}}));
        }
    });
}

TEST(children, of_a_face_are_the_faces_whose_points_lie_in_it)
{
    auto mesh = native(shapes::grid(3, 2)); // quads in the plane
    const auto corner = mesh.point(mesh.face(4)[0]), opposite = mesh.point(mesh.face(4)[2]);
    element_ranges inner = one(element_kind::face, 4);
    for (int step = 0; step < 2; ++step) {
        kith::numbering_of<kith::linear, std::uint32_t> ids;
        auto fine = kith::refine_mesh<kith::connect::everything>(mesh, kith::linear(), ids);
        inner = kith::children(level_type(mesh), ids, inner);
        mesh = std::move(fine);
    }
    EXPECT_EQ(inner.faces, (std::vector<number_range>{{64, 80}}));
    std::size_t inside = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        double x = 0, y = 0;
        for (const auto v : mesh.face(f))
            x += mesh.point(v)[0] / 4, y += mesh.point(v)[1] / 4;
        const auto between = [](double a, double t, double b) { return (a < t) == (t < b); };
        const bool in = between(corner[0], x, opposite[0]) and between(corner[1], y, opposite[1]);
        inside += in;
        EXPECT_EQ(in, f >= 64 and f < 80) << f;
    }
    EXPECT_EQ(inside, 16U);
}
