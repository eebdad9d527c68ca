// SPDX-License-Identifier: BSD-3-Clause
#include <kith/saved_levels.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/marks_and_parity.hpp"
#include "support/same_mesh.hpp"
#include "support/some_fields.hpp"
#include "support/some_selections.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/selected.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace kith;

namespace {

using points3d = std::vector<std::array<double, 3>>;

template <class Levels>
std::string saved(const Levels& levels)
{
    std::ostringstream out;
    io::write_levels(out, levels);
    return out.str();
}

template <class Scheme>
hierarchy<mesh3d, Scheme> loaded(const std::string& bytes, Scheme scheme)
{
    std::istringstream in(bytes);
    return io::read_levels<mesh3d>(in, std::move(scheme));
}

/// A house with creases and four levels, of which levels 0 and 2 were moved.
struct moved_house {
    catmull_clark scheme;
    hierarchy<mesh3d, catmull_clark> levels;

    moved_house() : scheme(creased()), levels(native(shapes::shaken(shapes::house())), scheme)
    {
        levels.refine(3);
        move(0), move(2);
    }
    static catmull_clark creased()
    {
        catmull_clark result;
        result.sharpness.sharpen_edge(4, 1.5);
        result.sharpness.sharpen_vertex(2, 2.5);
        return result;
    }
    void move(int level)
    {
        points3d points(levels[level].points().begin(), levels[level].points().end());
        points[5][1] += .75;
        levels.move_points(level, points);
    }
};

} // namespace

TEST(saved_levels, levels_with_chosen_faces_are_made_again)
{
    hierarchy levels(native(shapes::shaken(shapes::house())), selected(catmull_clark()));
    refine_some(levels, 3, 13, 5);
    points3d points(levels[2].points().begin(), levels[2].points().end());
    points[3][1] += .5;
    levels.move_points(2, points);
    auto again = loaded(saved(levels), selected(catmull_clark()));
    for (int level = 0; level <= 3; ++level)
        EXPECT_TRUE(same_bits(again[level], levels[level]));
    again.refine();
    levels.refine();
    EXPECT_TRUE(same_bits(again.finest(), levels.finest()));
}

TEST(saved_levels, what_was_undone_is_not_chosen)
{
    hierarchy levels(native(shapes::shaken(shapes::house())), selected(catmull_clark()));
    levels.refine_if([](auto f) { return f.value == 0; });
    levels.undo(1);
    auto again = loaded(saved(levels), selected(catmull_clark()));
    again.refine();
    levels.refine();
    EXPECT_TRUE(same_bits(again.finest(), levels.finest()));
}

TEST(saved_levels, are_those_that_were_saved)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        const auto again = loaded(saved(levels), scheme);
        ASSERT_EQ(again.depth(), 2);
        for (int level = 0; level <= 2; ++level)
            EXPECT_TRUE(same_bits(again[level], levels[level]));
    });
}

TEST(saved_levels, start_from_a_mesh_that_was_refined_before)
{
    const auto mesh = refine(native(shapes::tetrahedron()), sqrt3(), 1); // the scheme numbers the edges of this mesh
    hierarchy levels(mesh, sqrt3());
    levels.refine(2);
    const auto again = loaded(saved(levels), sqrt3());
    EXPECT_TRUE(same_bits(again[0], mesh));
    EXPECT_TRUE(same_bits(again[2], levels[2]));
}

TEST(saved_levels, have_their_creases_and_moved_points)
{
    const moved_house h;
    const auto again = loaded(saved(h.levels), catmull_clark());
    for (int level = 0; level <= 3; ++level) {
        EXPECT_TRUE(same_bits(again[level], h.levels[level]));
        for (const auto e : again.elements(level).edges())
            EXPECT_EQ(again.scheme(level).sharpness.of_edge(e.index()),
                      h.levels.scheme(level).sharpness.of_edge(e.index()));
    }
    EXPECT_TRUE(again.is_moved(2));
    EXPECT_FALSE(again.is_moved(1));
}

TEST(saved_levels, have_their_fields)
{
    const auto mesh = native(shapes::house());
    std::vector<int> labels(mesh.face_count());
    for (std::size_t f = 0; f < labels.size(); ++f)
        labels[f] = int(10 + f);
    std::vector<std::array<double, 2>> texture(mesh.corner_count());
    for (std::size_t c = 0; c < texture.size(); ++c)
        texture[c] = {double(c), 1. / double(c + 1)};
    hierarchy levels(mesh, with_fields(catmull_clark(), on_faces(labels), on_corners(texture)));
    levels.refine(2);
    const auto nothing = with_fields(
        catmull_clark(), on_faces(std::vector<int>()), on_corners(std::vector<std::array<double, 2>>()));
    const auto again = loaded(saved(levels), nothing);
    for (int level = 0; level <= 2; ++level) {
        const auto &ours = again.scheme(level), &theirs = levels.scheme(level);
        ASSERT_EQ(ours.template field<0>().size(), levels[level].face_count());
        for (std::size_t f = 0; f < levels[level].face_count(); ++f)
            EXPECT_EQ(ours.template field<0>()[f], theirs.template field<0>()[f]);
        for (std::size_t c = 0; c < levels[level].corner_count(); ++c)
            EXPECT_EQ(ours.template field<1>()[c], theirs.template field<1>()[c]);
    }
}

TEST(saved_levels, have_marks_and_parity_as_fields)
{
    const auto halved = marks_and_parity::some_tri_quad(true), triangles = marks_and_parity::some_triangles(true);
    hierarchy bisected(halved, marks_and_parity::with_marks(halved));
    hierarchy tripled(triangles, marks_and_parity::with_parity(triangles, false));
    bisected.refine(3), tripled.refine(3);
    const auto marks = loaded(saved(bisected), some_fields::without_values(bisected.scheme(0)));
    const auto parity = loaded(saved(tripled), some_fields::without_values(tripled.scheme(0)));
    for (int level = 0; level <= 3; ++level) {
        EXPECT_EQ(marks_and_parity::wrong_marks(marks[level], marks.scheme(level)), "");
        EXPECT_EQ(marks_and_parity::wrong_parity(parity[level], parity.scheme(level), level), "");
    }
}

TEST(saved_levels, keep_as_many_levels_as_before)
{
    moved_house h;
    h.levels.keep_last(1);
    auto again = loaded(saved(h.levels), catmull_clark());
    EXPECT_FALSE(again.holds(1));
    EXPECT_TRUE(again.holds(2)) << "it was moved";
    EXPECT_TRUE(same_bits(again[3], h.levels[3]));
    again.refine();
    h.levels.refine();
    EXPECT_TRUE(same_bits(again[4], h.levels[4]));
}

TEST(saved_levels, refuse_other_schemes_options_and_types)
{
    hierarchy levels(native(shapes::grid(3, 3)), catmull_clark());
    levels.refine(1);
    const auto bytes = saved(levels);
    EXPECT_EQ(error_text<io::file_error>([&] { loaded(bytes, doo_sabin()); }),
              "saved levels: they are of the scheme catmull-clark, not of doo-sabin");
    EXPECT_EQ(error_text<io::file_error>([&] { loaded(bytes, catmull_clark{.corners = boundary_corner::smoothed}); }),
              "saved levels: the scheme makes other points of them; give it the options that it had");
    EXPECT_EQ(error_text<io::file_error>([&] {
                  std::istringstream in(bytes);
                  io::read_levels<basic_mesh<std::array<float, 3>>, catmull_clark>(in);
              }),
              "saved levels: they are of another type of mesh, version or kind of machine");
    EXPECT_EQ(error_text<io::file_error>([&] { loaded("kith", catmull_clark()); }),
              "saved levels: there are 4 bytes, too few to hold any");
}

TEST(saved_levels, refuse_other_fields)
{
    const auto mesh = native(shapes::grid(3, 3));
    const std::vector<int> labels(mesh.face_count(), 7);
    const std::vector<float> weights(mesh.face_count(), 1.5F);
    const std::vector<std::array<int, 2>> pairs(mesh.face_count());
    const std::vector<std::array<float, 2>> places(mesh.face_count());
    const auto refused = [&](const auto& written, const auto& read) {
        hierarchy levels(mesh, written);
        levels.refine(1);
        const auto bytes = saved(levels);
        EXPECT_NO_THROW(loaded(bytes, written));
        EXPECT_EQ(
            error_text<io::file_error>([&] { loaded(bytes, read); }),
            "saved levels: their scheme has other fields; give it those that it had, of the same types and in the "
            "same order");
    };
    const auto one = with_fields(catmull_clark(), on_faces(labels));
    refused(one, with_fields(catmull_clark(), on_faces(weights)));
    const std::vector<double> at_corners(mesh.corner_count());
    refused(one, with_fields(catmull_clark(), on_corners(at_corners)));
    refused(one, catmull_clark());
    refused(catmull_clark(), one);
    refused(with_fields(catmull_clark(), on_faces(labels), on_faces(weights)), one);
    refused(with_fields(catmull_clark(), on_faces(pairs)), with_fields(catmull_clark(), on_faces(places)));
}

/// Returns the saved form of an unrefined control mesh, with the state of a scheme that may belong to another mesh.
template <class Scheme>
std::string saved_with(const mesh3d& control, const Scheme& scheme)
{
    packer bytes;
    bytes.add(io::detail::kind_of_levels<std::array<double, 3>, std::uint32_t>);
    bytes.add_array(scheme_name<Scheme>());
    bytes.add_array(io::detail::kinds_of_state(scheme));
    bytes.add(0).add(1);
    io::pack_mesh(bytes, control);
    kith::detail::pack_state(bytes, scheme);
    bytes.add(io::detail::checksum_of(io::detail::points_of(level_of<mesh3d>(control))));
    const auto all = bytes.take();
    const std::uint64_t sum = kith::detail::checksum_of_bytes(all);
    std::string text(all.size() + sizeof sum, ' ');
    std::memcpy(text.data(), all.data(), all.size());
    std::memcpy(text.data() + all.size(), &sum, sizeof sum);
    return text;
}

TEST(saved_levels, refuse_the_state_of_another_mesh)
{
    const auto house = native(shapes::house()), torus = native(shapes::torus(4, 5));
    hierarchy levels(torus, selected(catmull_clark()));
    levels.refine_if([](auto f) { return f.value % 3 == 0; });
    const auto chosen = levels.scheme(0), with_green_faces = levels.scheme(1);
    EXPECT_EQ(loaded(saved_with(torus, chosen), selected(catmull_clark())).depth(), 0);
    EXPECT_EQ(loaded(saved_with(levels[1], with_green_faces), selected(catmull_clark())).depth(), 0);
    for (const auto& text :
         {saved_with(house, chosen), saved_with(torus, with_green_faces), saved_with(levels[1], chosen)})
        EXPECT_NE(error_text<io::file_error>([&] {
                      loaded(text, selected(catmull_clark()));
                  }).find("select faces of this level"),
                  std::string::npos);

    catmull_clark creased;
    creased.sharpness.sharpen_edge(39, 2);
    EXPECT_EQ(error_text<io::file_error>([&] { loaded(saved_with(house, creased), catmull_clark()); }),
              "saved levels: their control mesh and its state do not fit: creases: edge 39 does not exist, there are " +
                  std::to_string(house.edge_count()) + "; make the creases for this mesh and level");
}

TEST(saved_levels, refuse_damage_anywhere)
{
    hierarchy levels(native(shapes::tetrahedron()), loop());
    levels.refine(1);
    const auto bytes = saved(levels);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        auto damaged = bytes;
        damaged[i] = char(damaged[i] ^ 4);
        EXPECT_THROW(loaded(damaged, loop()), io::file_error) << i;
        EXPECT_THROW(loaded(bytes.substr(0, i), loop()), io::file_error) << i;
    }
    EXPECT_THROW(loaded(bytes + "x", loop()), io::file_error);
}
