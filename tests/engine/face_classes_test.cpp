// SPDX-License-Identifier: BSD-3-Clause
#include <kith/engine/neighbourhood/face_classes.hpp>

#include <kith/catmull_clark.hpp>
#include <kith/core/base/sequence_numbers.hpp>
#include <kith/loop.hpp>
#include <kith/refine.hpp>

#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"
#include "support/thread_count.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace {

using classes_of_faces = kith::face_classes<std::uint32_t>;

/// Expects that two faces have one class if and only if the walks around them have equal keys. Faces are left out if
/// their neighbourhood is no disk.
template <class Scheme>
void expect_classes_of_walks(const mesh3d& mesh, int rings, const Scheme& scheme)
{
    const auto& topology = mesh.topology();
    kith::state_marks<std::uint32_t> marks(topology, scheme);
    const classes_of_faces classes(topology, rings, marks);
    kith::face_walk<std::uint32_t> walk(topology, rings);
    std::map<std::u16string, std::size_t> class_of_key;
    std::map<std::size_t, std::u16string> key_of_class;
    for (std::size_t f = 0; f < topology.faces; ++f) {
        walk.around(f);
        const auto c = classes.of_faces()[f];
        ASSERT_LT(c, classes.count());
        if (not walk.is_disk())
            continue;
        const auto& key = marks.key(walk);
        EXPECT_EQ(class_of_key.try_emplace(key, c).first->second, c) << f;
        EXPECT_EQ(key_of_class.try_emplace(c, key).first->second, key) << f;
    }
}

TEST(face_classes, are_those_of_walks_around_the_faces)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = refine(native(shape), kith::catmull_clark{}, 1);
        for (const int rings : {1, 2})
            expect_classes_of_walks(mesh, rings, kith::catmull_clark{});
        for (const int rings : {1, 2, 3}) // with faces of several degrees
            expect_classes_of_walks(native(shape), rings, kith::catmull_clark{});
    }
    for (const auto& [name, shape] : shapes::triangle_shapes()) {
        SCOPED_TRACE(name);
        for (const int rings : {1, 2, 3})
            expect_classes_of_walks(native(shape), rings, kith::loop{});
    }
    const auto shuffled = native(shapes::shuffled(shapes::torus(20, 30), 3));
    expect_classes_of_walks(shuffled, 1, kith::catmull_clark{});
    expect_classes_of_walks(shuffled, 2, kith::catmull_clark{});
}

TEST(face_classes, tell_apart_what_the_state_of_a_scheme_says)
{
    const auto torus = native(shapes::torus(20, 30));
    const std::size_t plain = classes_of_faces(torus.topology(), 1, {torus.topology(), kith::catmull_clark{}}).count();
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(400, 2.);
    scheme.sharpness.sharpen_edge(700, 2.);
    scheme.sharpness.sharpen_vertex(90, 1.);
    expect_classes_of_walks(torus, 1, scheme);
    const std::size_t alike = classes_of_faces(torus.topology(), 1, {torus.topology(), scheme}).count();
    EXPECT_GT(alike, plain);
    scheme.sharpness.sharpen_edge(700, 2.5);
    expect_classes_of_walks(torus, 1, scheme);
    EXPECT_GT(classes_of_faces(torus.topology(), 1, {torus.topology(), scheme}).count(), alike);
}

TEST(face_classes, are_the_same_on_any_number_of_threads)
{
    const auto mesh = native(shapes::shuffled(shapes::torus(70, 90), 3)); // enough for several threads
    const auto one = [&] {
        const thread_count count(1);
        return classes_of_faces(mesh.topology(), 1, {mesh.topology(), kith::catmull_clark{}});
    }();
    for (const int threads : {2, 5}) {
        const thread_count count(threads);
        const classes_of_faces several(mesh.topology(), 1, {mesh.topology(), kith::catmull_clark{}});
        EXPECT_EQ(several.count(), one.count());
        std::map<std::size_t, std::size_t> number;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            EXPECT_EQ(number.try_emplace(several.of_faces()[f], one.of_faces()[f]).first->second, one.of_faces()[f]);
    }
}

TEST(face_classes, have_few_classes_in_a_sample_where_faces_are_alike)
{
    const auto share = [](const shapes::shape& shape, int rings) {
        return kith::share_of_classes(native(shape).topology(), rings);
    };
    for (const int rings : {1, 2}) {
        EXPECT_LT(share(shapes::torus(60, 80), rings), .1);
        EXPECT_LT(share(shapes::triangulated(shapes::torus(60, 80)), rings), .1);
        EXPECT_GT(share(shapes::with_flips(shapes::triangulated(shapes::torus(30, 30)), 3, 2000), rings), .5);
    }
    EXPECT_EQ(share(shapes::house(), 1), 1);
}

TEST(face_classes, are_told_by_walks_where_a_neighbourhood_meets_itself)
{
    const auto is_disk = [](const mesh3d& mesh, int rings) {
        kith::face_walk<std::uint32_t> walk(mesh.topology(), rings);
        walk.around(0);
        return walk.is_disk();
    };
    EXPECT_TRUE(is_disk(native(shapes::torus(9, 9)), 1));
    EXPECT_TRUE(is_disk(native(shapes::torus(9, 9)), 3));
    EXPECT_FALSE(is_disk(native(shapes::torus(9, 9)), 4));
    EXPECT_TRUE(is_disk(native(shapes::torus(4, 9)), 1));
    EXPECT_FALSE(is_disk(native(shapes::torus(3, 9)), 1)); // the walk reaches a vertex from both sides
    EXPECT_FALSE(is_disk(native(shapes::torus(4, 9)), 2));
    EXPECT_TRUE(is_disk(native(shapes::grid(4, 5)), 3)); // a boundary does not count as another side
    EXPECT_TRUE(
        is_disk(native(shapes::tetrahedron()), 1)); // all faces, around a vertex in the middle of which nobody asks
    EXPECT_FALSE(is_disk(native(shapes::tetrahedron()), 2));
    const auto cube = refine(native(shapes::tetrahedron()), kith::catmull_clark{}, 2);
    EXPECT_TRUE(is_disk(cube, 1));
}

TEST(sequence_numbers, are_the_same_for_equal_sequences)
{
    kith::sequence_numbers numbers;
    kith::sequence_numbers::reader a(numbers), b(numbers);
    const std::u32string once(1, U'\0'), twice(2, U'\0');
    EXPECT_EQ(a(twice).sequence, 0U);
    EXPECT_EQ(a(twice).first_item, 0U);
    EXPECT_EQ(b(once).sequence, 1U);
    EXPECT_EQ(b(once).first_item, 2U);
    EXPECT_EQ(a(U"xyz").sequence, 2U);
    EXPECT_EQ(a(U"xyz").first_item, 3U);
    EXPECT_EQ(b(twice).sequence, 0U);
    EXPECT_EQ(a(once).sequence, 1U);
    EXPECT_EQ(a(U"").sequence, 3U);
    EXPECT_EQ(numbers.count(), 4U);
    for (char32_t i = 0; i < 5000; ++i) // more than are remembered best
        EXPECT_EQ(a(std::u32string{i, 7}).sequence, 4 + i);
    for (char32_t i = 0; i < 5000; ++i)
        EXPECT_EQ(b(std::u32string{i, 7}).first_item, 6 + 2 * i);
}

} // namespace
