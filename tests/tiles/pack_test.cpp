// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/tiles.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/schemes/crease/creases.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using tile_type = kith::tile<shapes::point, std::uint32_t>;
using job_type = kith::tile_job<tile_type, kith::catmull_clark>;

job_type a_job()
{
    const auto mesh = native(shapes::torus(5, 7));
    kith::creases sharp;
    sharp.sharpen_edge(4, 1.5);
    sharp.sharpen_vertex(2, kith::infinitely_sharp);
    const kith::catmull_clark scheme{.corners = {}, .sharpness = sharp};
    return kith::tile_cutter(mesh, scheme, partitions::blocks(mesh.face_count(), 3), 3).cut(0, 1);
}

job_type sent(const job_type& job)
{
    return kith::unpack<shapes::point, std::uint32_t>(kith::pack(job), kith::catmull_clark{});
}

std::string refusal(const job_type& job)
{
    return error_text<kith::pack_error>([&] { sent(job); });
}

/// Returns the error message for a job after `break_it` has changed the topology of its mesh.
template <class Break>
std::string refusal_of_broken(job_type job, const Break& break_it)
{
    auto& mesh = job.part.mesh;
    auto topology = mesh.topology();
    break_it(topology);
    mesh = {kith::storage<shapes::point>(mesh.points()), std::move(topology), mesh.generation()};
    return refusal(job);
}

std::string refusal_because(const std::string& fault)
{
    return "a message holds a tile that " + fault + "; its sender is at fault";
}

/// Makes a job whose tile has triangles and quads.
job_type a_mixed_job()
{
    const auto mesh = native(shapes::open_house());
    return kith::tile_cutter(mesh, kith::catmull_clark(), partitions::blocks(mesh.face_count(), 2), 2).cut(0, 1);
}

} // namespace

TEST(pack, comes_out_as_it_went_in)
{
    const auto job = a_job();
    const auto other = sent(job);
    EXPECT_EQ(kith::pack(other), kith::pack(job));
    ASSERT_EQ(other.part.mesh.face_count(), job.part.mesh.face_count());
    for (std::size_t f = 0; f < job.part.mesh.face_count(); ++f) {
        EXPECT_EQ(other.part.face_ids[f], job.part.face_ids[f]);
        EXPECT_TRUE(std::ranges::equal(other.part.mesh.face(f), job.part.mesh.face(f)));
    }
    for (std::size_t v = 0; v < job.part.mesh.vertex_count(); ++v)
        EXPECT_EQ(other.part.mesh.point(v), job.part.mesh.point(v));
    EXPECT_EQ(other.scheme.sharpness.vertices(), job.scheme.sharpness.vertices());
}

TEST(pack, keeps_the_normals_of_vertices_and_corners)
{
    auto job = a_job();
    job.part.normals = kith::storage<shapes::point>(job.part.mesh.vertex_count());
    job.part.corner_normals = kith::storage<shapes::point>(job.part.mesh.corner_count());
    for (auto* normals : {&job.part.normals, &job.part.corner_normals})
        for (std::size_t i = 0; i < normals->size(); ++i)
            (*normals)[i] = {double(i), 0, 1};
    const auto other = sent(job);
    EXPECT_TRUE(std::ranges::equal(other.part.normals, job.part.normals));
    EXPECT_TRUE(std::ranges::equal(other.part.corner_normals, job.part.corner_normals));
    job.part.corner_normals = kith::storage<shapes::point>(3);
    EXPECT_EQ(refusal(job), refusal_because("has more or fewer normals of corners than corners"));
}

TEST(pack, notices_damage)
{
    const auto good = kith::pack(a_job());
    const auto refused = [](const std::vector<std::byte>& bytes) {
        return error_text<kith::pack_error>(
            [&] { kith::unpack<shapes::point, std::uint32_t>(bytes, kith::catmull_clark{}); });
    };
    for (std::size_t i = 0; i < good.size(); i += 97) {
        auto bad = good;
        bad[i] ^= std::byte(1);
        EXPECT_EQ(refused(bad), "a message was damaged in transfer; its checksum is wrong") << i;
    }
    auto cut = good;
    cut.resize(good.size() / 2);
    EXPECT_EQ(refused(cut), "a message was damaged in transfer; its checksum is wrong");
    EXPECT_EQ(refused({}), "a message is too short");
    EXPECT_EQ(error_text<kith::pack_error>(
                  [&] { kith::unpack<std::array<float, 3>, std::uint32_t>(good, kith::catmull_clark{}); }),
              "a message comes from another program, version or kind of machine");
}

TEST(pack, refuses_a_tile_in_another_order)
{
    auto job = a_job();
    std::swap(job.part.face_ids[1], job.part.face_ids[2]);
    EXPECT_EQ(
        refusal(job),
        "a message holds a tile that has faces that are not in the order of their numbers; its sender is at fault");
    job = a_job();
    std::swap(job.part.vertex_ids[0], job.part.vertex_ids[4]);
    EXPECT_EQ(
        refusal(job),
        "a message holds a tile that has vertices that are not in the order of their numbers; its sender is at fault");
    job = a_job();
    job.part.edge_ids[3] = job.part.edge_ids[2];
    EXPECT_EQ(
        refusal(job),
        "a message holds a tile that has edges that are not in the order of their numbers; its sender is at fault");
}

TEST(pack, refuses_arrays_that_do_not_fit)
{
    auto job = a_job();
    job.part.edge_marks = kith::storage<unsigned char>(3);
    EXPECT_EQ(refusal(job), "a message holds a tile that has arrays of the wrong sizes; its sender is at fault");
    job = a_job();
    job.part.root_of[0] = std::uint32_t(job.part.roots.size());
    EXPECT_EQ(refusal(job),
              "a message holds a tile that refers to elements that it does not have; its sender is at fault");
}

TEST(pack, refuses_faces_whose_corners_are_not_contiguous)
{
    const auto good = a_mixed_job();
    ASSERT_EQ(good.part.mesh.topology().degree, 0);
    ASSERT_GE(good.part.mesh.face_count(), 3U);
    EXPECT_EQ(refusal(good), "no error");
    const auto fault = refusal_because("has faces whose corners are not contiguous");
    EXPECT_EQ(refusal_of_broken(good, [](auto& t) { std::swap(t.face_corner[1], t.face_corner[2]); }), fault);
    EXPECT_EQ(refusal_of_broken(good, [](auto& t) { t.face_corner[0] = 1; }), fault);
    EXPECT_EQ(refusal_of_broken(good, [](auto& t) { --t.face_corner[t.faces]; }), fault);
    EXPECT_EQ(refusal_of_broken(good, [](auto& t) { t.face_corner[1] = 2; }), fault);
}

TEST(pack, refuses_corners_that_do_not_refer_to_their_faces)
{
    EXPECT_EQ(refusal_of_broken(a_mixed_job(), [](auto& t) { t.corner_face[0] = 1; }),
              refusal_because("has corners that do not refer to their faces"));
}

TEST(pack, refuses_corners_and_half_edges_that_do_not_refer_to_each_other)
{
    const auto fault = refusal_because("has corners and half-edges that do not refer to each other");
    for (const auto& good : {a_job(), a_mixed_job()}) {
        EXPECT_EQ(refusal_of_broken(good, [](auto& t) { t.corner_halfedge[1] = t.corner_halfedge[0]; }), fault);
        EXPECT_EQ(refusal_of_broken(good, [](auto& t) { t.halfedge_corner[t.corner_halfedge[1]] = 0; }), fault);
        EXPECT_EQ(refusal_of_broken(good,
                                    [](auto& t) {
                                        for (std::size_t e = 0; e < t.edges(); ++e)
                                            if (t.is_boundary(e)) // its corner has another edge
                                                t.halfedge_corner[2 * e + 1] = 0;
                                    }),
                  fault);
    }
}

TEST(pack, refuses_edges_without_a_first_side)
{
    const auto turn_cut_edges = [](auto& t) {
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (t.is_boundary(e)) {
                t.set_side(t.halfedge_corner[2 * e], std::uint32_t(2 * e + 1));
                t.halfedge_corner[2 * e] = t.none;
            }
    };
    for (const auto& good : {a_job(), a_mixed_job()})
        EXPECT_EQ(refusal_of_broken(good, turn_cut_edges),
                  refusal_because("has edges whose first half-edge has no face"));
}

TEST(pack, refuses_edges_whose_half_edges_join_different_vertices)
{
    const auto change_sides = [](auto& t) {
        const auto first = t.corner_halfedge[0], second = t.corner_halfedge[1];
        t.set_side(0, second);
        t.set_side(1, first);
    };
    for (const auto& good : {a_job(), a_mixed_job()})
        EXPECT_EQ(refusal_of_broken(good, change_sides),
                  refusal_because("has edges whose two half-edges join different vertices"));
}

TEST(pack, refuses_first_corners_of_another_vertex)
{
    for (const auto& good : {a_job(), a_mixed_job()})
        EXPECT_EQ(refusal_of_broken(good, [](auto& t) { std::swap(t.vertex_corner[0], t.vertex_corner[1]); }),
                  refusal_because("has vertices whose first corner belongs to another vertex"));
}

TEST(pack, takes_texts)
{
    const auto bytes = kith::packer().add_array(std::string("a word")).add_array(std::string()).take();
    kith::unpacker in(bytes);
    EXPECT_EQ(in.get_array<std::string>(), "a word");
    EXPECT_EQ(in.get_array<std::string>(), "");
    EXPECT_TRUE(in.is_at_end());
}
