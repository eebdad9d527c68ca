// SPDX-License-Identifier: BSD-3-Clause
#include "golden_suite.hpp"

#include <kith/compiled_schemes.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Tests of creases, and of the schemes that golden_test.cpp leaves out, on the native mesh.

namespace {

using native = native_mesh<double>;

template <class Scheme, class Test>
void for_each_file(const std::string& name, const Test& test)
{
    for (const auto& f : golden::files_of(name))
        test(f, control_mesh<native>(f), Scheme{});
}

struct butterfly_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::butterfly>("butterfly", test); }
};
struct kobbelt_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::kobbelt>("kobbelt", test); }
};
struct linear_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::linear>("linear_quad", test); }
};
struct linear_triangles_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::linear_triangles>("linear_tri", test); }
};
struct mid_edge_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::mid_edge>("mid_edge", test); }
};
struct nasri_hasbini_on_native {
    using mesh = native;
    static void for_each(const auto& test) { for_each_file<kith::nasri_hasbini>("nasri_hasbini", test); }
};

/// The test type of 4-8. Its files contain tri-quad meshes as lists of triangles and of marked edges.
struct four_eight_on_native {
    using mesh = native;
    static void for_each(const auto& test)
    {
        for (const auto& f : golden::files_of("four_eight")) {
            const std::vector<std::pair<std::uint32_t, std::uint32_t>> marked(f.levels[0].marked_edges.begin(),
                                                                              f.levels[0].marked_edges.end());
            test(f, mark_edges(control_mesh<native>(f), marked), kith::four_eight{});
        }
    }
};

kith::creases creases_of(const golden::file& f, const native& control)
{
    kith::creases result(f.crease_method == "chaikin" ? kith::crease_method::chaikin : kith::crease_method::uniform);
    const kith::level_of<native> level(control);
    for (const auto& [a, b, sharpness] : f.levels[0].creases)
        result.sharpen_edge(level.index(edge_between(level, a, b)), sharpness);
    for (const auto& [v, sharpness] : f.levels[0].corners)
        result.sharpen_vertex(v, sharpness);
    return result;
}
template <class Scheme>
struct creased_on_native {
    using mesh = native;
    static void for_each(const auto& test)
    {
        for (const auto& f : golden::files_of(std::is_same_v<Scheme, kith::loop> ? "loop" : "catmull_clark"))
            if (not f.levels[0].creases.empty()) {
                const auto control = control_mesh<native>(f);
                Scheme scheme;
                scheme.sharpness = creases_of(f, control);
                test(f, control, scheme);
            }
    }
};

using other_schemes_on_native = testing::Types<
    butterfly_on_native, four_eight_on_native, kobbelt_on_native, linear_on_native, linear_triangles_on_native,
    mid_edge_on_native, nasri_hasbini_on_native, creased_on_native<kith::catmull_clark>, creased_on_native<kith::loop>>;

} // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(others, golden_files, other_schemes_on_native);

namespace {

/// Expects that every level has the creases of the file. Vertices are found by their places.
template <class Scheme>
void expect_golden_tags()
{
    creased_on_native<Scheme>::for_each([](const golden::file& f, const native& control, const Scheme& scheme) {
        kith::hierarchy levels(control, scheme);
        levels.refine(int(f.levels.size()) - 1);
        for (std::size_t n = 1; n < f.levels.size(); ++n) {
            SCOPED_TRACE(f.name + ", level " + std::to_string(n));
            const auto& golden = f.levels[n];
            const auto& sharpness = levels.scheme(int(n)).sharpness;
            const auto points = levels[int(n)].points();
            const auto number = [&](std::size_t golden_vertex) {
                const auto& q = golden.vertices[golden_vertex];
                return std::size_t(
                    std::ranges::min_element(
                        points, {}, [&q](const auto& p) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }) -
                    points.begin());
            };
            EXPECT_EQ(sharpness.edges().size(), golden.creases.size());
            EXPECT_EQ(sharpness.vertices().size(), golden.corners.size());
            const auto& level = levels.elements(int(n));
            for (const auto& [a, b, s] : golden.creases)
                EXPECT_DOUBLE_EQ(sharpness.of_edge(level.index(edge_between(level, number(a), number(b)))), s);
            for (const auto& [v, s] : golden.corners)
                EXPECT_DOUBLE_EQ(sharpness.of_vertex(number(v)), s);
        }
    });
}

} // namespace

TEST(golden_creases, every_level_of_catmull_clark_has_the_golden_tags)
{
    expect_golden_tags<kith::catmull_clark>();
}

TEST(golden_creases, every_level_of_loop_has_the_golden_tags)
{
    expect_golden_tags<kith::loop>();
}
