// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.hpp"
#include "native_shape.hpp"
#include "tiles.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/crease/creases.hpp>
#include <kith/tile/pack.hpp>

#include <gtest/gtest.h>

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
        EXPECT_EQ(refused(bad), "a message was damaged on its way; its checksum is wrong") << i;
    }
    auto cut = good;
    cut.resize(good.size() / 2);
    EXPECT_EQ(refused(cut), "a message was damaged on its way; its checksum is wrong");
    EXPECT_EQ(refused({}), "a message is too short");
    EXPECT_EQ(error_text<kith::pack_error>(
                  [&] { kith::unpack<std::array<float, 3>, std::uint32_t>(good, kith::catmull_clark{}); }),
              "a message is of another program, version or kind of machine");
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
              "a message holds a tile that points at elements that it does not have; its sender is at fault");
}

TEST(pack, takes_texts)
{
    const auto bytes = kith::packer().add_array(std::string("a word")).add_array(std::string()).take();
    kith::unpacker in(bytes);
    EXPECT_EQ(in.get_array<std::string>(), "a word");
    EXPECT_EQ(in.get_array<std::string>(), "");
    EXPECT_TRUE(in.is_at_end());
}
