// SPDX-License-Identifier: BSD-3-Clause
#include <kith/fields/field.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"
#include "support/some_fields.hpp"
#include "support/tiles.hpp"

#include <kith/evaluator.hpp>
#include <kith/fields/sparse_values.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using kith::tuple_kind;

/// Expects that each value of level 1 follows from the origin of its element.
template <class Scheme>
void expect_inherited(const mesh3d& mesh, const Scheme& scheme)
{
    const auto with = some_fields::with_some_fields(scheme, mesh);
    kith::hierarchy levels(mesh, with);
    levels.refine(1);
    const auto &old = levels.elements(0), &made = levels.elements(1);
    const auto& now = levels.scheme(1);
    ASSERT_EQ(now.template field<0>().size(), made.face_count());
    ASSERT_EQ(now.template field<6>().size(), made.corner_count());
    const auto index = [&](const auto& handle) { return old.index(*handle); };
    for (const auto f : made.faces()) {
        const auto from = levels.origin(1, f.handle());
        const auto& material = with.template field<0>();
        const auto& label = with.template field<1>();
        EXPECT_EQ(now.template field<0>()[f.index()], from.f ? material[index(from.f)] : 0);
        if (from.f)
            EXPECT_EQ(now.template field<1>()[f.index()], label[index(from.f)]);
        else {
            std::set<std::int32_t> around;
            for (const auto g : old.faces())
                for (const auto c : g.corners())
                    if ((from.e and index(from.e) == c.next_edge().index()) or
                        (not from.e and index(from.v) == c.v().index()))
                        around.insert(label[g.index()].group);
            EXPECT_EQ(now.template field<1>()[f.index()], (some_fields::label{*around.begin(), true}));
        }
    }
    const auto edge_under = [&](const auto& e) { // the old edge on which both ends lie
        std::optional<std::size_t> result;
        for (const auto x : old.edges()) {
            const auto lies_on = [&](const auto& v) {
                const auto from = levels.origin(1, v.handle());
                return not from.f and (from.e ? index(from.e) == x.index()
                                              : index(from.v) == x.org().index() or index(from.v) == x.dst().index());
            };
            if (lies_on(e.org()) and lies_on(e.dst()))
                result = x.index();
        }
        return result;
    };
    for (const auto e : made.edges()) {
        const auto under = edge_under(e);
        const double expected = under ? std::max(with.template field<2>()[*under] - 1, 0.) : -1;
        EXPECT_EQ(now.template field<2>()[e.index()], expected) << "edge " << e.index();
    }
    for (const auto v : made.vertices()) {
        const auto from = levels.origin(1, v.handle());
        const bool is_old = from.kind == tuple_kind::v;
        EXPECT_EQ(now.template field<3>()[v.index()], is_old and with.template field<3>()[index(from.v)]);
        EXPECT_TRUE(same_points(now.template field<5>()[v.index()], v.point()));
        const auto& weight = with.template field<4>();
        double expected = 0, face = 0, edge = 0;
        if (from.f)
            for (const auto u : old.faces()[index(from.f)].vertices())
                face += weight[u.index()] / double(old.faces()[index(from.f)].degree());
        if (from.e)
            edge = (weight[old.edges()[index(from.e)].org().index()] +
                    weight[old.edges()[index(from.e)].dst().index()]) /
                   2;
        const bool thirds = kith::scheme_name<Scheme>() == "nasri-hasbini";
        switch (*from.kind) {
        case tuple_kind::v: expected = weight[index(from.v)]; break;
        case tuple_kind::e: expected = edge; break;
        case tuple_kind::f: expected = face; break;
        case tuple_kind::ve: expected = weight[index(from.v)] / 3 + edge * 2 / 3; break;
        case tuple_kind::vf:
            expected = thirds ? weight[index(from.v)] / 3 + face * 2 / 3 : (weight[index(from.v)] + face) / 2;
            break;
        default: ADD_FAILURE() << "no scheme here does that";
        }
        EXPECT_NEAR(now.template field<4>()[v.index()], expected, 1e-14);
    }
}

/// Returns the values of vertices at the corners of a mesh.
template <class T>
std::vector<T> at_corners(const mesh3d& mesh, std::span<const T> values)
{
    std::vector<T> result;
    for (const auto v : mesh.topology().corner_vertex)
        result.push_back(values[v]);
    return result;
}

mesh3d some_mesh(bool open)
{
    return native(open ? shapes::shaken(shapes::open_house())
                       : shapes::with_joins(shapes::shaken(shapes::torus(6, 6)), 3, 100));
}

/// A scheme with a field as its state.
struct drawn : kith::linear {
    kith::field<kith::field_on::faces, double, kith::from_parent<>> pull;

    static constexpr auto traits() { return kith::scheme_traits{.name = "drawn", .state = &drawn::pull}; }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const double t = pull[f.index()];
            assoc(f, V) = t * f.first_corner().v() + (1 - t) * average(f.vertices());
        });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = 1. * v; });
        kith::quad_split::connect(r);
    }
};

} // namespace

TEST(field, is_inherited_as_the_origins_say_by_every_scheme)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if (mesh.face_count() < 40)
            expect_inherited(mesh, scheme);
    });
}

TEST(field, on_corners_without_seams_is_that_on_vertices)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if (mesh.face_count() >= 40)
            return;
        std::vector<double> weight;
        for (const auto& p : mesh.points())
            weight.push_back(p[0] + 2 * p[1] - p[2]);
        auto with = kith::with_fields(
            scheme, kith::on_vertices(weight), kith::on_corners(at_corners(mesh, std::span<const double>(weight))));
        const auto fine = kith::refine_with_fields(mesh, with, 2);
        const auto expected = at_corners(fine, with.template field<0>().values());
        ASSERT_EQ(with.template field<1>().size(), expected.size());
        for (std::size_t c = 0; c < expected.size(); ++c)
            EXPECT_NEAR(with.template field<1>()[c], expected[c], 1e-13) << "corner " << c;
    });
}

TEST(field, on_corners_keeps_seams)
{
    const auto mesh = some_mesh(false); // each face is a chart of its own, a unit square or a regular polygon
    std::vector<std::array<double, 3>> texture;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t k = 0; k < mesh.face(f).size(); ++k)
            texture.push_back({double(f), double(k == 1 or k == 2), double(k >= 2)});
    std::vector<std::size_t> face(mesh.face_count());
    for (std::size_t f = 0; f < face.size(); ++f)
        face[f] = f;
    auto with = kith::with_fields(kith::catmull_clark{}, kith::on_corners(texture), kith::on_faces(face));
    const auto fine = kith::refine_with_fields(mesh, with, 1);
    for (std::size_t f = 0; f < fine.face_count(); ++f) {
        const std::size_t root = with.field<1>()[f];
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(with.field<0>()[4 * f + k][0], double(root));
        if (mesh.face(root).size() == 4) {
            const std::size_t corner = f - 4 * root; // if all faces before are quads, too
            const auto& first = with.field<0>()[4 * f];
            if (mesh.topology().degree == 4) {
                EXPECT_EQ(first, texture[4 * root + corner]);
            }
            double u = 0, v = 0; // the square of the child is a quarter of that of the parent
            for (std::size_t k = 0; k < 4; ++k) {
                const auto &a = with.field<0>()[4 * f + k], &b = with.field<0>()[4 * f + (k + 1) % 4];
                u += (a[1] + b[1]) * (b[2] - a[2]) / 2;
                v = std::max(v, std::abs(b[1] - a[1]) + std::abs(b[2] - a[2]));
            }
            EXPECT_EQ(u, 0.25);
            EXPECT_EQ(v, 0.5);
        }
    }
}

TEST(field, changes_no_bit_of_the_points_and_is_the_same_by_refine_and_by_hierarchy)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if (mesh.face_count() >= 40)
            return;
        const auto given = some_fields::with_some_fields(scheme, mesh);
        auto last = given;
        const auto fine = kith::refine_with_fields(mesh, last, 2);
        EXPECT_TRUE(same_bits(fine, kith::refine(mesh, scheme, 2)));
        EXPECT_TRUE(same_bits(kith::refine(mesh, given, 2), fine));
        kith::hierarchy levels(mesh, given);
        levels.refine(1);
        levels.refine(1);
        EXPECT_TRUE(same_bits(levels.finest(), fine));
        EXPECT_EQ(some_fields::difference(levels.scheme(2), last), "");
        const auto& points = last.template field<5>();
        for (std::size_t v = 0; v < fine.vertex_count(); ++v)
            EXPECT_TRUE(same_points(points[v], fine.point(v)));
    });
}

TEST(field, goes_beside_a_scheme_too)
{
    const auto mesh = some_mesh(true);
    for (const auto last_level : {kith::connect::everything, kith::connect::faces}) {
        auto with = some_fields::with_some_fields(kith::catmull_clark{}, mesh);
        auto material = with.field<0>();
        auto weight = with.field<4>();
        auto texture = with.field<6>();
        kith::refine_with_fields(mesh, with, 2);
        const auto fine = kith::refine_with_fields(
            mesh, kith::catmull_clark{}, 2, std::tie(material, weight, texture), {last_level});
        EXPECT_EQ(fine.topology().faces_only(), last_level == kith::connect::faces);
        EXPECT_TRUE(same_bits(fine, kith::refine(mesh, kith::catmull_clark{}, 2, {last_level})));
        EXPECT_TRUE(std::ranges::equal(material.values(), with.field<0>().values()));
        EXPECT_TRUE(std::ranges::equal(weight.values(), with.field<4>().values()));
        EXPECT_TRUE(std::ranges::equal(texture.values(), with.field<6>().values()));
    }
    auto sharpness = some_fields::with_some_fields(kith::catmull_clark{}, mesh).field<2>();
    EXPECT_THROW(kith::refine_with_fields(mesh, kith::catmull_clark{}, 1, std::tie(sharpness), {kith::connect::faces}),
                 kith::mesh_error);
    EXPECT_EQ(sharpness.size(), mesh.edge_count());
}

TEST(field, is_added_to_a_hierarchy_afterwards)
{
    const auto mesh = some_mesh(true);
    auto with = some_fields::with_some_fields(kith::doo_sabin{}, mesh);
    kith::hierarchy levels(mesh, kith::doo_sabin{});
    levels.refine(2);
    const auto first = with;
    kith::refine_with_fields(mesh, with, 2);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        const auto same = [&](const auto& a, const auto& b) { return std::ranges::equal(a.values(), b.values()); };
        EXPECT_TRUE((same(levels.carry(0, 2, first.template field<I>()), with.template field<I>()) and ...));
        EXPECT_TRUE((
            same(levels.carry(1, 2, levels.carry(0, 1, first.template field<I>())), with.template field<I>()) and ...));
    }(std::make_index_sequence<some_fields::count>());
    EXPECT_THROW((void)levels.carry(2, 1, first.field<0>()), kith::mesh_error);
    EXPECT_THROW((void)levels.carry(1, 2, first.field<0>()), kith::mesh_error);
}

TEST(field, goes_through_tiles_bit_for_bit)
{
    const auto run = [](const auto& scheme, const mesh3d& mesh) {
        SCOPED_TRACE(name_of(scheme));
        const auto given = some_fields::with_some_fields(scheme, mesh);
        auto whole = given;
        const auto fine = kith::refine_with_fields(mesh, whole, 2);
        for (const std::size_t parts : {std::size_t(3), std::size_t(6)}) {
            const auto part_of = parts == 3 ? partitions::scattered(mesh.face_count(), parts, 2)
                                            : partitions::blocks(mesh.face_count(), parts);
            EXPECT_EQ(tiles_differ(mesh, given, 2, part_of, parts, 1), "");
            kith::tiled_refinement refinement(mesh, given, 2, {part_of, parts}, 1);
            for (std::size_t p = 0; p < parts; ++p) {
                kith::phase_seconds seconds;
                const auto job = refinement.refine_job(p, kith::connect::everything, seconds);
                EXPECT_EQ(some_fields::difference_in_tile(job.part, job.scheme, whole), "");
            }
        }
    };
    for (const bool open : {false, true}) {
        const auto mesh = some_mesh(open);
        run(kith::catmull_clark{}, mesh);
        run(kith::doo_sabin{}, mesh);
        run(kith::linear{}, mesh);
        run(kith::nasri_hasbini{}, mesh);
        run(kith::mid_edge{}, mesh);
        const auto triangles = native(
            shapes::triangulated(open ? shapes::shaken(shapes::grid(4, 5)) : shapes::shaken(shapes::torus(6, 6))));
        run(kith::loop{}, triangles);
        run(kith::butterfly{}, triangles);
        run(kith::sqrt3{}, triangles);
        run(kith::four_eight{}, kith::tri_quad(mesh));
    }
}

TEST(field, of_another_mesh_is_refused_where_tiles_are_cut)
{
    const auto mesh = native(shapes::torus(4, 5));
    for (const std::size_t values : {3, 1000}) {
        const auto scheme = kith::with_fields(kith::catmull_clark{}, kith::on_faces(std::vector<int>(values)));
        EXPECT_EQ(error_text<kith::mesh_error>(
                      [&] { kith::tiled_refinement(mesh, scheme, 1, {partitions::blocks(mesh.face_count(), 2), 2}); }),
                  "a field has " + std::to_string(values) + " values, the level has 20 faces; give it one for each");
    }
}

TEST(field, comes_out_of_a_message_as_it_went_in)
{
    const auto mesh = some_mesh(true);
    const auto given = some_fields::with_some_fields(kith::catmull_clark{}, mesh);
    const auto job = kith::tile_cutter(mesh, given, partitions::blocks(mesh.face_count(), 3), 3).cut(1, 1);
    const auto bytes = kith::pack(job);
    const auto other = kith::unpack<shapes::point, std::uint32_t>(bytes, some_fields::without_values(given));
    EXPECT_EQ(kith::pack(other), bytes);
    EXPECT_EQ(some_fields::difference(other.scheme, job.scheme), "");
}

TEST(field, takes_functions_that_capture_values_that_are_no_numbers_and_fields_without_values)
{
    const auto mesh = some_mesh(true);
    const std::vector<std::string> names(mesh.face_count(), "old");
    const std::string more = "er";
    auto with = kith::with_fields(
        kith::doo_sabin{},
        kith::on_faces(names,
                       kith::from_parent{.inherit = [more](const std::string& s) { return s + more; }, .born = "new"}),
        kith::field<kith::field_on::edges, double, kith::along_edges<>>());
    const auto fine = kith::refine_with_fields(mesh, with, 2);
    EXPECT_EQ(with.field<0>().size(), fine.face_count());
    EXPECT_EQ(with.field<0>()[0], "olderer");
    EXPECT_EQ(with.field<0>()[fine.face_count() - 1], "new");
    EXPECT_TRUE(with.field<1>().empty());
}

TEST(field, of_another_number_of_values_is_refused_and_changes_nothing)
{
    const auto mesh = some_mesh(true);
    auto with = kith::with_fields(kith::catmull_clark{}, kith::on_faces(std::vector<int>(3, 1)));
    try {
        kith::refine_with_fields(mesh, with, 1);
        FAIL();
    } catch (const kith::mesh_error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "a field has 3 values, the level has " + std::to_string(mesh.face_count()) +
                      " faces; give it one for each");
    }
    EXPECT_EQ(with.field().size(), 3U);
    auto few = kith::on_faces(std::vector<int>(3, 1));
    for (const int levels : {0, 1})
        EXPECT_THROW(kith::refine_with_fields(mesh, kith::catmull_clark{}, levels, std::tie(few)), kith::mesh_error);
    EXPECT_THROW(kith::hierarchy(mesh, with), kith::mesh_error);
    EXPECT_THROW((void)kith::tile_cutter(mesh, with, partitions::blocks(mesh.face_count(), 2), 2).cut(1, 1),
                 kith::mesh_error);
}

TEST(field, is_a_member_of_a_scheme_that_reads_it)
{
    const auto mesh = some_mesh(false);
    drawn scheme;
    scheme.pull = kith::on_faces(std::vector<double>(mesh.face_count(), 0.25));
    const auto expected = kith::refine(mesh, scheme, 2);
    const auto fine = kith::refine_with_fields(mesh, scheme, 2);
    EXPECT_TRUE(same_bits(fine, expected));
    EXPECT_EQ(scheme.pull.size(), fine.face_count());
    EXPECT_EQ(scheme.pull[fine.face_count() - 1], 0.25);
}

TEST(field, of_another_number_of_values_is_refused_before_its_scheme_reads_it)
{
    const auto mesh = some_mesh(false);
    drawn scheme;
    scheme.pull = kith::on_faces(std::vector<double>(3, 0.25));
    const std::string fault = "a field has 3 values, the level has " + std::to_string(mesh.face_count()) +
                              " faces; give it one for each";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { (void)kith::refine(mesh, scheme, 1); }), fault);
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { (void)kith::refine(mesh, scheme, 2, {.last_level = kith::connect::faces}); }),
              fault);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { (void)kith::refine_with_fields(mesh, scheme, 1); }), fault);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { (void)kith::hierarchy(mesh, scheme); }), fault);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { (void)kith::evaluator(mesh, scheme, 1); }), fault);
}

TEST(sparse_values, are_set_removed_cut_and_joined)
{
    kith::sparse_values<int> sparse;
    for (const std::size_t element : {7U, 2U, 9U, 4U})
        sparse.set(element, int(10 * element));
    sparse.set(9, 0);
    sparse.set(4, 5);
    using list = std::vector<std::pair<std::size_t, int>>;
    EXPECT_EQ(sparse.list(), (list{{2, 20}, {4, 5}, {7, 70}}));
    EXPECT_EQ(sparse[4], 5);
    EXPECT_EQ(sparse[3], 0);
    const std::vector<std::uint32_t> some{1, 2, 2, 3, 7}, others{2, 4};
    const auto part = sparse.of_part(std::span(some)); // a vertex with two fans occurs twice
    EXPECT_EQ(part.list(), (list{{1, 20}, {2, 20}, {4, 70}}));
    auto joined = decltype(sparse)();
    joined.add_part(part, std::span(some));
    joined.add_part(sparse.of_part(std::span(others)), std::span(others));
    EXPECT_EQ(joined.list(), sparse.list());
    kith::packer out;
    sparse.pack(out);
    const auto bytes = out.take();
    kith::unpacker in(bytes);
    joined.unpack(in);
    EXPECT_EQ(joined.list(), sparse.list());
}

TEST(sparse_values, are_found_whatever_order_a_message_has_them_in)
{
    const auto bytes =
        kith::packer().add(std::uint64_t(2)).add(std::uint64_t(7)).add(70).add(std::uint64_t(2)).add(20).take();
    kith::unpacker in(bytes);
    kith::sparse_values<int> sparse;
    sparse.unpack(in);
    EXPECT_EQ(sparse[2], 20);
    EXPECT_EQ(sparse[7], 70);
}

TEST(field, can_be_assigned_where_what_its_rule_captures_cannot)
{
    struct captured {
        int factor;
        explicit captured(int f) : factor(f) {}
        captured(const captured&) = default;
        captured& operator=(const captured&) = delete;
    };
    const auto times = [](captured by) { return kith::detail::assignable([by](int x) { return by.factor * x; }); };
    auto kept = times(captured(2));
    const auto given = times(captured(3));
    EXPECT_EQ((*kept)(7), 14);
    kept = given;
    EXPECT_EQ((*kept)(7), 21);
    auto moved = std::move(kept);
    EXPECT_EQ((*moved)(7), 21);
    EXPECT_EQ((*given)(7), 21);
}
