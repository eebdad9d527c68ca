// SPDX-License-Identifier: BSD-3-Clause
// Lets every allocation of tiles fail, once and from then on. std::bad_alloc must come out, and the next call must
// succeed.
#include "support/failing_allocations.hpp"

#include "support/native_shape.hpp"
#include "support/shapes.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/limits_of_tile.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace {

namespace fails = failing_allocations;

using labels = decltype(kith::on_faces(std::vector<int>()));
using scheme = kith::with_fields<kith::catmull_clark, labels>;
using tiles = kith::tiled_refinement<std::array<double, 3>, std::uint32_t, scheme>;
using bytes = std::vector<std::byte>;

const mesh3d house = native(shapes::shaken(shapes::open_house()));

/// Returns Catmull-Clark with creases that stay and decay, and with a number on each face.
scheme scheme_with_state()
{
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(1, 1.5);
    creased.sharpness.sharpen_edge(4, kith::infinitely_sharp);
    std::vector<int> numbers(house.face_count());
    std::iota(numbers.begin(), numbers.end(), 0);
    return scheme(creased, kith::on_faces(numbers));
}

tiles house_in_tiles(int last_rings = 0)
{
    return tiles(house, scheme_with_state(), 2, kith::block_partition(house, 2), last_rings);
}

auto refined(tiles& of, std::size_t part)
{
    kith::phase_seconds seconds;
    return of.refine_job(part, kith::connect::everything, seconds);
}

/// Expects std::bad_alloc or the right bytes, and after either case the right bytes from the same object.
template <class Object, class Make>
void expect_right_bytes_or_none(Object& object, const Make& make, long step = 1)
{
    const bytes right = make(object);
    bytes made;
    long failed = 0;
    fails::try_all([&] { made.clear(); },
                   [&] { made = make(object); },
                   [&](const fails::trial& trial) {
                       SCOPED_TRACE(trial.text());
                       EXPECT_EQ(trial.other, "");
                       EXPECT_EQ(made, trial.has_thrown ? bytes() : right);
                       EXPECT_EQ(make(object), right);
                       failed += trial.has_failed;
                   },
                   step);
    EXPECT_GT(failed, 3);
}

} // namespace

TEST(failed_allocations_in_tiles, a_surface_is_cut_into_tiles_or_not)
{
    int nothing = 0;
    expect_right_bytes_or_none(
        nothing,
        [](int) {
            auto of = house_in_tiles();
            return kith::pack(refined(of, 1));
        },
        3);
}

TEST(failed_allocations_in_tiles, a_tile_that_failed_is_refined_by_the_next_call)
{
    auto of = house_in_tiles();
    for (const std::size_t part : {0U, 1U})
        expect_right_bytes_or_none(of, [part](tiles& from) { return kith::pack(refined(from, part)); });
}

TEST(failed_allocations_in_tiles, levels_of_a_tile_are_kept)
{
    auto of = house_in_tiles(1);
    expect_right_bytes_or_none(of, [](tiles& from) {
        bytes all;
        from.refine_levels(0, [&](auto kept) {
            const bytes more = kith::pack(kith::tile_job{std::move(kept.part), std::move(kept.scheme)});
            all.insert(all.end(), more.begin(), more.end());
        });
        return all;
    });
}

TEST(failed_allocations_in_tiles, a_message_is_read_whole_or_not_at_all)
{
    auto of = house_in_tiles();
    const bytes message = kith::pack(refined(of, 0));
    expect_right_bytes_or_none(message, [](const bytes& from) {
        return kith::pack(kith::unpack<std::array<double, 3>, std::uint32_t>(from, scheme_with_state()));
    });
}

TEST(failed_allocations_in_tiles, limits_are_all_or_none)
{
    kith::tiled_refinement of(house, scheme_with_state().plain(), 1, kith::block_partition(house, 2), 3);
    kith::phase_seconds seconds;
    const auto job = of.refine_job(0, kith::connect::everything, seconds);
    expect_right_bytes_or_none(job, [](const auto& from) {
        const auto limits = kith::limit_surface_of(from.part, from.scheme);
        kith::packer out;
        out.add_array(limits.surface.positions).add_array(limits.surface.normals);
        return out.take();
    });
}
