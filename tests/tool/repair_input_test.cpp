// SPDX-License-Identifier: BSD-3-Clause
#include "job/repair_input.hpp"

#include "cli/errors.hpp"
#include "job/mesh_input.hpp"
#include "support/error_text.hpp"

#include <kith/read_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace {

using kith::io::attribute;
using kith::io::mesh_format;
using kith::io::polygon_soup;
using kith::tool::input_repair;
using texts = std::vector<std::string>;

struct mended {
    polygon_soup soup;
    std::string report;
    texts notes;
};
mended mend(const polygon_soup& soup, const input_repair& repair)
{
    mended result;
    kith::repair_report report;
    result.soup = kith::tool::repaired_soup(soup, repair, report, result.notes);
    result.report = report.text();
    return result;
}
mended mend(const polygon_soup& soup, std::string_view words)
{
    return mend(soup, kith::tool::repair_named(words));
}
polygon_soup obj(std::string_view text)
{
    return kith::io::read_mesh(mesh_format::obj, text);
}
const std::vector<double>& values(const std::vector<attribute>& attributes, std::string_view name)
{
    static const std::vector<double> none;
    const auto found = std::ranges::find(attributes, name, &attribute::name);
    return found == attributes.end() ? none : found->values;
}
std::vector<std::array<double, 3>> sharp_edges(const polygon_soup& soup)
{
    std::vector<std::array<double, 3>> result;
    for (const auto& [from, to, sharpness] : soup.tags.edges)
        result.push_back({double(from), double(to), sharpness});
    return result;
}

const std::string two_fans = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n"
                             "vt 0 0\nvt 1 0\nvt 0 1\nvt .5 .5\n"
                             "f 1/1 2/2 3/3\nf 1/4 4/2 5/3\n";

} // namespace

TEST(repair_input, words_are_read_and_written)
{
    for (const std::string words : {"drop", "split,orient", "drop,split,orient,weld", "weld=0.25", "orient,weld=0"})
        EXPECT_EQ(kith::tool::words_of(kith::tool::repair_named(words)), words);
    EXPECT_TRUE(kith::tool::repair_named("").empty());
    for (const std::string words : {"mend", "drop split", "weld=", "weld=-1", "weld=nan", "drop,,split"})
        EXPECT_NE(error_text<kith::tool::usage_error>([&] { kith::tool::repair_named(words); }), "no error") << words;
}

TEST(repair_input, what_belongs_to_a_split_vertex_belongs_to_its_copies)
{
    auto soup = obj(two_fans + "t corner 1/1/0 0 7\nt crease 2/1/0 0 1 2\nt crease 2/1/0 0 4 3\nt hole 1/0/0 1\n");
    soup.attributes.vertices.push_back({"quality", {}, {10, 11, 12, 13, 14}});
    const auto [fine, report, notes] = mend(soup, "split");
    EXPECT_EQ(report, "vertex 1: split into 2 vertices, one for each fan of faces"); // as OBJ counts
    EXPECT_EQ(notes, texts());
    EXPECT_EQ(fine.points.size(), 6U);
    EXPECT_EQ(values(fine.attributes.vertices, "quality"), (std::vector<double>{10, 11, 12, 13, 14, 10}));
    EXPECT_EQ(values(fine.attributes.corners, "u"), (std::vector<double>{0, 1, 0, .5, 1, 0}));
    EXPECT_EQ(fine.tags.vertices, (std::vector<std::pair<std::size_t, double>>{{0, 7}, {5, 7}}));
    EXPECT_EQ(sharp_edges(fine), (std::vector<std::array<double, 3>>{{0, 1, 2}, {4, 5, 3}}));
    EXPECT_EQ(fine.tags.holes, std::vector<std::size_t>{1});
    EXPECT_EQ(fine.first_number, 1U);
}

TEST(repair_input, what_belongs_to_a_face_that_is_left_out_goes_with_it)
{
    auto soup = obj(two_fans + "t corner 2/2/0 3 2 7 5\nt crease 2/1/0 3 4 2\nt crease 2/1/0 1 2 3\nt hole 1/0/0 1\n");
    soup.attributes.faces.push_back({"red", {}, {1, 2}});
    const auto [fine, report, notes] = mend(soup, "drop");
    EXPECT_EQ(report,
              "face 2: left out, as it does not join the larger fan of faces at vertex 1\n"
              "vertex 4: left out, it belongs to no face\nvertex 5: left out, it belongs to no face");
    EXPECT_EQ(notes,
              (texts{"1 crease is lost with the elements that the repair removes",
                     "1 sharp vertex is lost with the elements that the repair removes",
                     "1 hole is lost with the elements that the repair removes"}));
    EXPECT_EQ(values(fine.attributes.faces, "red"), std::vector<double>{1});
    EXPECT_EQ(values(fine.attributes.corners, "u"), (std::vector<double>{0, 1, 0}));
    EXPECT_EQ(sharp_edges(fine), (std::vector<std::array<double, 3>>{{1, 2, 3}}));
    EXPECT_EQ(fine.tags.vertices, (std::vector<std::pair<std::size_t, double>>{{2, 5}}));
    EXPECT_TRUE(fine.tags.holes.empty());
}

TEST(repair_input, corners_are_turned_with_their_face)
{
    const auto soup = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\n"
                          "f 1/1 2/2 3/3\nf 1/1 2/2 4/4\n");
    const auto [fine, report, notes] = mend(soup, "orient");
    EXPECT_EQ(report, "face 2: turned round");
    EXPECT_EQ(fine.faces.vertices, (std::vector<std::size_t>{0, 1, 2, 0, 3, 1}));
    EXPECT_EQ(values(fine.attributes.corners, "u"), (std::vector<double>{1, 2, 3, 1, 4, 2}));
}

TEST(repair_input, creases_and_corners_of_joined_vertices_go_to_those_that_stay)
{
    const auto soup = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
                          "f 1 2 3 4\nf 5 6 7 8\nt crease 2/1/0 7 4 2\nt crease 2/1/0 5 4 1\nt corner 2/2/0 4 1 3 4\n");
    const auto [fine, report, notes] = mend(soup, "weld");
    EXPECT_EQ(report, "vertex 5: joined with vertex 2\nvertex 8: joined with vertex 3");
    EXPECT_EQ(sharp_edges(fine), (std::vector<std::array<double, 3>>{{1, 2, 2}, {1, 4, 1}}));
    EXPECT_EQ(fine.tags.vertices, (std::vector<std::pair<std::size_t, double>>{{1, 4}})); // the larger of both
    EXPECT_EQ(notes, texts());
}

TEST(repair_input, a_seam_of_texture_coordinates_at_vertices_becomes_one_at_corners)
{
    auto soup = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4\nf 5 6 7 8\n");
    soup.attributes.vertices.push_back({"s", {4, true, true}, {0, 1, 1, 0, 0, 1, 1, 0}});
    soup.attributes.vertices.push_back({"t", {4, true, true}, {0, 0, 1, 1, 0, 0, 1, 1}});
    soup.attributes.vertices.push_back({"red", {1, false, false}, {1, 2, 3, 4, 2, 6, 7, 9}});
    const auto [fine, report, notes] = mend(soup, "weld=0");
    EXPECT_EQ(values(fine.attributes.corners, "u"), (std::vector<double>{0, 1, 1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(values(fine.attributes.corners, "v"), (std::vector<double>{0, 0, 1, 1, 0, 0, 1, 1}));
    ASSERT_EQ(fine.attributes.vertices.size(), 1U);
    EXPECT_EQ(values(fine.attributes.vertices, "red"), (std::vector<double>{1, 2, 3, 4, 6, 7}));
    EXPECT_EQ(notes, texts{"colours: 1 joined vertex had other values than the vertex that is kept"});
    // Without a seam, attributes stay at vertices.
    soup.attributes.vertices[0].values = {0, 1, 1, 0, 1, 2, 2, 1};
    EXPECT_EQ(mend(soup, "weld=0").soup.attributes.vertices.size(), 3U);
}

TEST(repair_input, tags_of_elements_that_do_not_exist_are_refused)
{
    for (const auto& [tag, text] :
         {std::pair("t crease 2/1/0 0 3 1", "crease 0-3: there is no such edge; correct the tag"),
          std::pair("t corner 1/1/0 9 1", "corner 9: there is no such vertex; correct the tag"),
          std::pair("t hole 1/0/0 2", "hole 2: there is no such face; correct the tag")}) {
        const auto soup = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 3 2\n" + std::string(tag) + "\n");
        EXPECT_EQ(error_text<kith::mesh_error>([&] { mend(soup, "drop"); }), text);
    }
}

TEST(repair_input, cracks_are_found_and_the_options_named_that_mend_what_is_wrong)
{
    const auto soup = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1e-9 0 1\nv 0 1e-17 1\n"
                          "f 1 3 2\nf 1 2 4\nf 2 3 5\nf 3 1 6\n");
    const auto cracks = kith::tool::cracks_of(soup);
    EXPECT_EQ(cracks.equal.size(), 0U);
    EXPECT_EQ(cracks.rounded, (std::vector<std::pair<std::size_t, std::size_t>>{{4, 3}, {5, 3}}));
    EXPECT_NEAR(cracks.distance, 1e-6 * std::sqrt(3), 1e-12);
    EXPECT_TRUE(kith::tool::remedies(soup, kith::tool::report_of(soup)).empty()); // three leaves that stand open
    EXPECT_EQ(mend(soup, "weld").soup.points.size(), 4U);

    auto pinched = soup;
    pinched.points.push_back({9, 9, 9}), pinched.points.push_back({9, 9, 8});
    pinched.faces.push_back(std::array{0, 6, 7});
    EXPECT_EQ(
        kith::tool::remedies(pinched, kith::tool::report_of(pinched)),
        (texts{"vertex 5 coincides with vertex 4, one of 2 such vertices at the boundary; --weld joins such vertices, "
               "try it first",
               "--repair changes such faces: split (gives each sheet an edge of its own and each fan a vertex of its "
               "own), drop (removes faces)"}));
    const auto bad = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 2 3 4\n");
    EXPECT_EQ(
        kith::tool::remedies(bad, kith::tool::report_of(bad)),
        texts{"--repair changes such faces: orient (reverses faces), split (gives each sheet an edge of its own and "
              "each fan a vertex of its own), drop (removes faces)"});
}
