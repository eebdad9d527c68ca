// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/same_mesh.hpp"
#include "on_ranks.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/kobbelt.hpp>
#include <kith/mpi/slices/tiles_of_slices.hpp>
#include <kith/refine_by_exchange.hpp>

#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

namespace {

template <class T>
void put(std::ostream& out, T value)
{
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A file that all ranks see as long as this object lives.
class shared_file {
public:
    explicit shared_file(const std::function<void(std::ostream&)>& write)
    {
        if (world().is_root()) {
            std::ofstream out(path(), std::ios::binary);
            write(out);
        }
        world().agree("");
    }
    ~shared_file()
    {
        world().agree("");
        if (world().is_root())
            std::remove(path().c_str());
    }
    static std::string path() { return "read_tiles_" + std::to_string(world().size()) + ".ply"; }
};

template <class Real>
void write_ply(std::ostream& out, const shapes::shape& shape)
{
    out << "ply\nformat binary_little_endian 1.0\ncomment a test\nelement vertex " << shape.points.size() << '\n';
    for (const char* name : {"x", "y"})
        out << "property " << (sizeof(Real) == 4 ? "float " : "double ") << name << '\n';
    out << "property uchar red\nproperty " << (sizeof(Real) == 4 ? "float" : "double") << " z\nelement face "
        << shape.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& p : shape.points) {
        put(out, Real(p[0]));
        put(out, Real(p[1]));
        put(out, std::uint8_t(7));
        put(out, Real(p[2]));
    }
    for (const auto& face : shape.faces) {
        put(out, std::uint8_t(face.size()));
        for (const std::size_t v : face)
            put(out, std::int32_t(v));
    }
}

/// Compares the tiles that are read with tiles that are cut out of the whole mesh. Their refined surface must be that
/// of the whole mesh.
template <class Real, class Scheme>
void expect_same(const shapes::shape& shape, const Scheme& scheme)
{
    const shared_file file([&](std::ostream& out) { write_ply<Real>(out, shape); });
    auto rounded = shape;
    for (auto& p : rounded.points)
        for (auto& x : p)
            x = double(Real(x));
    const auto mesh = native(rounded);
    const auto parts = kith::block_partition(mesh, std::size_t(world().size()));
    for (const int rings : {1, 2, 3}) {
        const auto read = kith::mpi::read_tiles(world(), shared_file::path(), rings);
        ASSERT_EQ(read.tiles.size(), 1U);
        kith::tile_cutter cutter(mesh, scheme, parts.part_of, parts.parts);
        EXPECT_EQ(read.counts, cutter.counts());
        const auto expected = cutter.cut(std::size_t(world().rank()), rings).part;
        const auto& part = read.tiles[0].part;
        EXPECT_EQ(read.tiles[0].number, std::uint64_t(world().rank()));
        EXPECT_TRUE(same_bits(part.mesh, expected.mesh)) << rings;
        for (const auto kind : {kith::element_kind::vertex, kith::element_kind::edge, kith::element_kind::face}) {
            EXPECT_TRUE(std::ranges::equal(ids_of(part, kind), ids_of(expected, kind))) << rings;
            EXPECT_TRUE(std::ranges::equal(marks_of(part, kind), marks_of(expected, kind))) << rings;
        }
        EXPECT_TRUE(std::ranges::equal(part.roots, expected.roots));
        EXPECT_TRUE(std::ranges::equal(part.root_of, expected.root_of));
        if (not expected.corners_before.empty()) {
            EXPECT_TRUE(std::ranges::equal(part.corners_before, expected.corners_before)) << rings;
        }
        const std::uint64_t file_bytes = shape.points.size() * (3 * sizeof(Real) + 1) +
                                         shape.faces.size() * (1 + 4 * shape.faces[0].size());
        EXPECT_LE(read.bytes_read, file_bytes / std::uint64_t(world().size()) + 100); // no more than its share
        EXPECT_EQ(world().sum(std::array{read.bytes_read})[0], file_bytes);
    }
    auto read = kith::mpi::read_tiles(world(), shared_file::path(), reach_of(scheme, 1));
    kith::mpi::exchanging_refinement refinement(
        world(), std::move(read.tiles), read.counts, scheme, reach_of(scheme, 1));
    refinement.refine();
    refinement.refine();
    const auto whole = kith::refine(mesh, scheme, 2);
    std::vector<int> vertices(whole.vertex_count()), edges(whole.edge_count()), faces(whole.face_count());
    for (const auto& [number, part] : refinement.tiles())
        EXPECT_EQ(difference(part, whole, vertices, edges, faces), "");
    for (const auto n : world().sum(std::vector<std::uint64_t>(faces.begin(), faces.end())))
        EXPECT_EQ(n, 1U);
}

std::string error_of(const std::function<void(std::ostream&)>& write)
{
    const shared_file file(write);
    return error_text<kith::mpi::phase_error>([] { kith::mpi::read_tiles(world(), shared_file::path(), 1); });
}

} // namespace

TEST(read_tiles, equals_tiles_that_are_cut_from_the_whole_mesh)
{
    auto torus = shapes::shaken(shapes::torus(6, 9));
    for (std::size_t f = 0; f < torus.faces.size(); ++f) // faces are stored from any corner on
        std::ranges::rotate(torus.faces[f], torus.faces[f].begin() + std::ptrdiff_t(f % 4));
    expect_same<double>(torus, kith::doo_sabin{});
    expect_same<float>(shapes::shaken(shapes::grid(6, 7)), kith::doo_sabin{});
    expect_same<float>(shapes::with_flips(shapes::shaken(shapes::triangulated(shapes::torus(5, 7))), 1),
                       kith::doo_sabin{});
    expect_same<double>(shapes::shaken(shapes::triangulated(shapes::ring())), kith::doo_sabin{});
}

TEST(read_tiles, leaves_room_for_numbers_beside_places_and_corners)
{
    const auto torus = shapes::shaken(shapes::torus(6, 9));
    for (const bool wide : {false, true}) {
        const shared_file file([&](std::ostream& out) {
            out << "ply\nformat binary_little_endian 1.0\nelement vertex 54\nproperty short id\nproperty double x\n"
                   "property float weight\nproperty double y\nproperty double z\nproperty double twice\nelement face "
                   "54\n"
                   "property char mark\nproperty uint key\nproperty list "
                << (wide ? "int ushort" : "uchar int")
                << " vertex_indices\nproperty ushort far\n"
                   "property double area\nend_header\n";
            for (std::size_t v = 0; v < 54; ++v) {
                const auto& p = torus.points[v];
                put(out, std::int16_t(-int(v)));
                put(out, p[0]);
                put(out, float(v) / 4);
                put(out, p[1]);
                put(out, p[2]);
                put(out, 2 * double(v));
            }
            for (std::size_t f = 0; f < 54; ++f) {
                put(out, std::int8_t(-int(f)));
                put(out, std::uint32_t(4294967295U - f));
                wide ? put(out, std::int32_t(4)) : put(out, std::uint8_t(4));
                for (const std::size_t v : torus.faces[f])
                    wide ? put(out, std::uint16_t(v)) : put(out, std::int32_t(v));
                put(out, std::uint16_t(65535 - f));
                put(out, 1 / double(f + 1));
            }
        });
        const auto mesh = native(torus);
        const auto parts = kith::block_partition(mesh, std::size_t(world().size())); // the blocks of the file
        kith::tile_cutter cutter(mesh, kith::doo_sabin{}, parts.part_of, parts.parts);
        const auto expected = cutter.cut(std::size_t(world().rank()), 2).part;
        const auto read = kith::mpi::read_tiles(world(), shared_file::path(), 2);
        EXPECT_TRUE(same_bits(read.tiles[0].part.mesh, expected.mesh));

        kith::sliced_ply slices(shared_file::path());
        const std::vector<kith::global_id> some{0, 1, 2, 7, 9, 10, 53};
        const auto expect = [&](const std::vector<double>& values, const auto& value) {
            ASSERT_EQ(values.size(), some.size());
            for (std::size_t i = 0; i < some.size(); ++i)
                EXPECT_EQ(values[i], value(double(some[i]))) << some[i];
        };
        expect(slices.values_of_vertices(0, some), [](double v) { return -v; });
        expect(slices.values_of_vertices(2, some), [](double v) { return v / 4; });
        expect(slices.values_of_vertices(5, some), [](double v) { return 2 * v; });
        expect(slices.values_of_faces(0, some), [](double f) { return -f; });
        expect(slices.values_of_faces(1, some), [](double f) { return 4294967295. - f; });
        expect(slices.values_of_faces(3, some), [](double f) { return 65535 - f; });
        expect(slices.values_of_faces(4, some), [](double f) { return 1 / (f + 1); });
        EXPECT_TRUE(slices.values_of_faces(4, {}).empty());
    }
}

TEST(read_tiles, says_what_is_wrong_with_a_file)
{
    auto cube = shapes::cube();
    const auto ply = [&](std::ostream& out) { write_ply<float>(out, cube); };
    EXPECT_EQ(error_of(ply), "no error");
    EXPECT_NE(error_of([](std::ostream& out) { out << "OFF\n"; }).find("is not a PLY file"), std::string::npos);
    EXPECT_NE(error_of([](std::ostream& out) { out << "ply\nformat ascii 1.0\n"; }).find("'end_header' should be"),
              std::string::npos);
    std::ranges::reverse(cube.faces[3]);
    const std::string file = shared_file::path() + ": ";
    EXPECT_TRUE(error_of(ply).starts_with(file + "edge ")) << error_of(ply);
    EXPECT_NE(error_of(ply).find("in the same direction; reverse one of them"), std::string::npos) << error_of(ply);
    cube = shapes::cube();
    cube.points.push_back({9, 9, 9});
    EXPECT_EQ(error_of(ply), file + "vertex 8: belongs to no face; remove it or give it a face");
    cube = shapes::cube();
    cube.faces[4][1] = cube.faces[4][0];
    EXPECT_EQ(error_of(ply), file + "face 4 contains a vertex twice; remove the repeated corner or the face");
    cube = shapes::cube();
    cube.faces[5][2] = 77;
    EXPECT_EQ(error_of(ply), file + "face 5: vertex 77 does not exist, there are 8; correct the index");
    cube.faces[5][2] = std::size_t(-1);
    EXPECT_EQ(error_of(ply), file + "face 5: vertex -1 does not exist, there are 8; correct the index");
    cube = shapes::cube();
    cube.faces[2].push_back(0);
    EXPECT_NE(error_of(ply).find("face 2 of another degree than face 0"), std::string::npos) << error_of(ply);
    cube = shapes::cube();
    const auto with = [&](const std::string& old_words, const std::string& words) {
        std::ostringstream whole;
        ply(whole);
        std::string bytes = whole.str();
        bytes.replace(bytes.find(old_words), old_words.size(), words);
        return error_of([&](std::ostream& out) { out << bytes; });
    };
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find("read_tiles_"), std::string::npos) << text; // the file is named
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    for (const char* before :
         {"comment ", "comment x end_header ", "comment end_header\ncomment ", "obj_info \tend_header "})
        EXPECT_EQ(with("comment a test", before + std::string(9000, 'x')), "no error") << before;
    EXPECT_EQ(with("end_header", "comment " + std::string(4096, 'x') + "\n \tend_header"), "no error");
    for (const char* list : {"list uint8 short", "list uchar int16"}) // the numbers then are others
        expect(with("list uchar int", list), "of another degree than face 0");
    EXPECT_NE(with("list uchar int", "list int int"), "no error");
    EXPECT_EQ(with("end_header", "element tristrips 0\nproperty list int int vertex_indices\nend_header"), "no error");
    expect(with("end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header"),
           "has strips of triangles ('tristrips'), which cannot be read in slices; read it on one rank");
    for (const char* list : {"list uchar float", "uint"})
        expect(with("list uchar int", list), "the faces have no list 'vertex_indices' of whole numbers");
    for (const char* name : {"corners", "vertex_indices_2"})
        expect(with("vertex_indices", name), "the faces have no list 'vertex_indices' of whole numbers");
    expect(with("vertex_indices", ""), "the property has no name");
    EXPECT_EQ(with("vertex_indices", "vertex_index"), "no error");
    for (const char* format : {"ascii", "binary_big_endian"})
        expect(with("binary_little_endian", format), "is not binary_little_endian");
    expect(with("format binary_little_endian 1.0\n", ""), "the header has no line 'format'");
    expect(with("format binary_little_endian 1.0", "comment binary"), "the header has no line 'format'");
    expect(with("element face 6", "element face 0"), "has no faces; nothing can be refined");
    expect(with("element vertex 8", "element vertex -5"),
           "the number of elements 'vertex' should be a whole number, it is '-5'");
    expect(with("element face 6", "element face"), "the number of elements 'face' should be a whole number, it is ''");
    expect(with("element face 6", "element face 6x"),
           "the number of elements 'face' should be a whole number, it is '6x'");
    expect(with("element face 6", "element vertex 6"),
           "must have one element 'vertex' and one element 'face' or 'tristrips'");
    expect(with("element vertex 8", "element edge 0\nelement vertex 8"), "has element edge out of place");
    expect(with("end_header", "element vertex 9\nend_header"), "the elements 'vertex' have no property");
    expect(with("element face 6", "element face 7"), "is too short for 8 vertices and 7 faces");
    for (const char* many : {"99", "18446744073709551615"}) {
        expect(with("element vertex 8", std::string("element vertex ") + many), "is too short for");
        expect(with("element face 6", std::string("element face ") + many), "is too short for");
    }
    expect(with("end_header", "element edge 9\nend_header"), "the elements 'edge' have no property");
    EXPECT_EQ(with("end_header", "element edge 0\nproperty uchar a\nend_header"), "no error");
    expect(with("end_header", "element edge 9\nproperty uchar a\nend_header"), "ends within its elements 'edge'");
    const auto with_tail = [&](const std::string& properties, const std::string& tail) {
        std::ostringstream whole;
        ply(whole);
        std::string bytes = whole.str();
        bytes.insert(bytes.find("end_header"), properties);
        return error_of([&](std::ostream& out) { out << bytes << tail; });
    };
    expect(with_tail("", "!"), "goes on for 1 byte after its last element");
    EXPECT_EQ(with_tail("element edge 2\nproperty short a\n", "abcd"), "no error");
    expect(with_tail("element edge 2\nproperty short a\n", "abcde"), "goes on for 1 byte after its last element");
    EXPECT_EQ(with_tail("element edge 2\nproperty list char short a\n", std::string("\1ab\0", 4)), "no error");
    expect(with_tail("element edge 2\nproperty list char short a\n", "\1ab\1a"), "ends within its elements 'edge'");
    expect(with_tail("element edge 1\nproperty list char short a\n", "\377"), "has a list of negative length");
}

TEST(read_tiles, says_why_a_file_cannot_be_read_and_on_which_rank)
{
    const auto text = [](const std::string& path, int rings) {
        return error_text<kith::mpi::phase_error>([&] { kith::mpi::read_tiles(world(), path, rings); });
    };
    EXPECT_EQ(text("missing.ply", 1), "missing.ply: cannot be opened: No such file or directory");
    EXPECT_EQ(text(".", 1), ".: is a directory, not a file");
    const shared_file file([](std::ostream& out) { write_ply<double>(out, shapes::torus(5, 7)); });
    EXPECT_EQ(text(shared_file::path(), 0),
              shared_file::path() + ": tiles with 0 rings of ghosts were asked for; ask for 1 or more");
    const int last = world().size() - 1;
    const std::string some = text(world().rank() == last ? "missing.ply" : shared_file::path(), 1);
    EXPECT_TRUE(some.starts_with("missing.ply: cannot be opened: No such file or directory")) << some;
    if (last != 0) {
        EXPECT_NE(some.find(" on rank " + std::to_string(last) + " of " + std::to_string(last + 1) + ", "),
                  std::string::npos)
            << some;
        EXPECT_TRUE(some.ends_with("; put the file where all ranks see it")) << some;
    }
}

TEST(read_tiles, with_one_ring_is_enough_for_any_number_of_levels)
{
    const auto shape = shapes::shaken(shapes::torus(6, 7));
    const shared_file file([&](std::ostream& out) { write_ply<double>(out, shape); });
    auto read = kith::mpi::read_tiles(world(), shared_file::path(), 1);
    kith::mpi::rank_refinement refinement(world(), std::move(read.tiles), read.counts, kith::kobbelt{}, 3, 1);
    tiles3d refined;
    refinement.refine(kith::mpi::sharing::spmd,
                      [&](std::uint64_t number, tile3d&& part) { refined.push_back({number, std::move(part)}); });
    ::expect_same(refined, kith::refine(native(shape), kith::kobbelt{}, 3));
}
