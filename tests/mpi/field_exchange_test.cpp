// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/shapes.hpp"
#include "on_ranks.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/mpi/ranks/field_exchange.hpp>

#include <map>

namespace {

using kith::element_kind;
constexpr std::array kinds{element_kind::vertex, element_kind::edge, element_kind::face};

/// A value that identifies the element to which it belongs.
struct label {
    kith::global_id id;
    float half;
    char kind;
    friend bool operator==(const label&, const label&) = default;
};

label label_of(kith::global_id id, element_kind kind)
{
    return {id, float(id) / 2, char('a' + int(kind))};
}

/// Gives owned elements their labels and checks the labels that ghosts receive. Returns the number of ghosts on all
/// ranks.
std::uint64_t exchange_labels(const tiles3d& tiles, element_kind kind)
{
    kith::mpi::field_exchange exchange(world(), std::span(tiles), kind);
    std::vector<std::vector<label>> fields;
    for (const auto& [number, part] : tiles) {
        const auto ids = kith::ids_of(part, kind);
        const auto marks = kith::marks_of(part, kind);
        auto& field = fields.emplace_back(ids.size(), label{});
        for (std::size_t x = 0; x < ids.size(); ++x)
            if ((marks[x] & kith::owned_mark) != 0)
                field[x] = label_of(ids[x], kind);
    }
    auto pending_exchange = exchange.begin(fields);
    exchange.finish(pending_exchange, fields);
    std::uint64_t ghosts = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const auto ids = kith::ids_of(tiles[t].part, kind);
        const auto marks = kith::marks_of(tiles[t].part, kind);
        for (std::size_t x = 0; x < ids.size(); ++x) {
            EXPECT_EQ(fields[t][x], label_of(ids[x], kind)) << "of element " << ids[x];
            ghosts += (marks[x] & kith::owned_mark) == 0;
        }
    }
    const auto [all, sent, received] = world().sum(
        std::array<std::uint64_t, 3>{ghosts, exchange.sent_values(), exchange.received_values()});
    EXPECT_EQ(sent, all);
    EXPECT_EQ(received, all);
    return all;
}

template <class Scheme>
void expect_labels(const mesh3d& mesh, const Scheme& scheme, const kith::partition& parts)
{
    for (const int rings : {0, 1, 2}) {
        const auto tiles = refined_tiles(mesh, scheme, 2, parts, rings);
        for (const auto kind : kinds) {
            const std::uint64_t ghosts = exchange_labels(tiles, kind);
            EXPECT_EQ(ghosts == 0, rings == 0 and kind == element_kind::face) << rings;
        }
    }
}

} // namespace

TEST(field_exchange, tells_all_ghosts_what_their_owners_have)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    expect_labels(house, kith::catmull_clark{}, in_blocks(house, 3));
    expect_labels(house, kith::catmull_clark{}, scattered(house, 9, 1)); // some parts are empty
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    expect_labels(torus, kith::catmull_clark{}, scattered(torus, 7, 2));
    expect_labels(torus, kith::doo_sabin{}, scattered(torus, 4, 3));
    const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::l_shape())));
    expect_labels(triangles, kith::doo_sabin{}, scattered(triangles, 5, 4));
}

TEST(field_exchange, finds_owners_though_most_elements_lie_inside)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 14)));
    for (const int rings : {0, 1, 3})
        for (const auto kind : kinds)
            exchange_labels(refined_tiles(torus, kith::catmull_clark{}, 3, in_blocks(torus, 3), rings), kind);
}

TEST(field_exchange, takes_any_way_of_sharing)
{
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    const auto tiles = refined_tiles(
        torus, kith::catmull_clark{}, 2, scattered(torus, 11, 5), 1, kith::mpi::sharing::manager);
    for (const auto kind : kinds)
        EXPECT_GT(exchange_labels(tiles, kind), 0U);
}

TEST(field_exchange, adds_what_ghosts_have_in_the_order_of_the_tiles)
{
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    const kith::catmull_clark scheme;
    const auto parts = scattered(torus, 6, 6);
    // A tile contributes to a vertex a number for each of its owned faces there; the sum of such numbers is rounded. A
    // tile without owned faces there contributes 0.
    const auto contributions = [](const tile3d& part) {
        std::vector<double> field(part.mesh.vertex_count(), 0);
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
            if (part.owns_face(f))
                for (const auto v : part.mesh.face(f))
                    field[v] += 1 / double(3 + part.face_ids[f]);
        return field;
    };
    // Computes the expected sums on this rank alone: the owner's value first, then those of ghosts in the order of the
    // tiles.
    std::map<kith::global_id, double> expected;
    {
        kith::tile_cutter cutter(torus, scheme, parts.part_of, parts.parts);
        auto rim = cutter.cut_rim(1);
        const kith::global_levels_of<kith::catmull_clark> whole(
            cutter.counts(), std::move(rim.part), std::move(rim.scheme), 2, 1);
        std::vector<tile3d> all;
        for (std::size_t p = 0; p < parts.parts; ++p) {
            auto job = cutter.cut(p, whole.rings(0));
            all.push_back(kith::refine(std::move(job.part), job.scheme, whole));
        }
        for (const bool owners : {true, false})
            for (const auto& part : all) {
                const auto field = contributions(part);
                for (std::size_t v = 0; v < field.size(); ++v)
                    if (part.owns_vertex(v) == owners)
                        expected[part.vertex_ids[v]] += field[v];
            }
    }
    const auto tiles = refined_tiles(torus, scheme, 2, parts, 1);
    kith::mpi::field_exchange exchange(world(), std::span(tiles), element_kind::vertex);
    std::vector<std::vector<double>> fields;
    for (const auto& [number, part] : tiles)
        fields.push_back(contributions(part));
    exchange.sum_to_owners(fields, std::plus<>());
    exchange.exchange(fields);
    for (std::size_t t = 0; t < tiles.size(); ++t)
        for (std::size_t v = 0; v < fields[t].size(); ++v)
            EXPECT_EQ(fields[t][v], expected.at(tiles[t].part.vertex_ids[v])); // equal to the last bit
}

TEST(field_exchange, says_when_a_tile_is_missing)
{
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    auto tiles = refined_tiles(torus, kith::catmull_clark{}, 1, in_blocks(torus, 6), 1);
    std::erase_if(tiles, [](const auto& tile) { return tile.number == 2; });
    const std::string text = error_text<kith::mpi::phase_error>([&] {
        kith::mpi::field_exchange(world(), std::span<const kith::numbered_tile<tile3d>>(tiles), element_kind::face);
    });
    EXPECT_NE(text.find("give all tiles of the level"), std::string::npos) << text;
}

TEST(field_exchange, refuses_values_of_other_sizes_on_all_ranks)
{
    const auto torus = native(shapes::torus(5, 7));
    const auto tiles = refined_tiles(torus, kith::catmull_clark{}, 1, scattered(torus, 6, 6), 1);
    kith::mpi::field_exchange exchange(world(), std::span(tiles), element_kind::vertex);
    const auto text = [&](std::size_t more_values, bool one_tile_less) {
        std::vector<std::vector<double>> fields;
        for (const auto& [number, part] : tiles)
            fields.emplace_back(part.mesh.vertex_count(), 1.);
        if (world().is_root() and one_tile_less)
            fields.pop_back();
        if (world().is_root() and more_values != 0)
            fields.back().resize(fields.back().size() + more_values);
        return error_text<kith::mpi::phase_error>([&] { exchange.exchange(fields); });
    };
    EXPECT_EQ(text(0, false), "no error");
    EXPECT_NE(text(0, true).find("; this rank has "), std::string::npos) << text(0, true);
    EXPECT_NE(text(2, false).find(" elements of this kind, ghosts included"), std::string::npos) << text(2, false);
    std::vector<std::vector<double>> fields;
    for (const auto& [number, part] : tiles)
        fields.emplace_back(part.mesh.vertex_count(), 1.);
    const auto add = [](double a, double b) { return world().is_root() ? throw std::runtime_error("no sum") : a + b; };
    EXPECT_EQ(error_text<kith::mpi::phase_error>([&] { exchange.sum_to_owners(fields, add); }), "no sum");
}
