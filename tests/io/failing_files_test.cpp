// SPDX-License-Identifier: BSD-3-Clause
#include "support/failing_allocations.hpp"
#include "support/vtu_files.hpp"
#include "files.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/output_file.hpp>
#include <kith/read_mesh.hpp>
#include <kith/saved_levels.hpp>
#include <kith/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Lets memory allocation fail while files are read and written: once, or from then on.

namespace {

using namespace kith;
using failing_allocations::trial;
using failing_allocations::try_all;
using io::mesh_format;
using vtu_files::bytes_of;
namespace fs = std::filesystem;

/// A directory that is used by one test.
struct test_directory : vtu_files::directory {
    void clear() const
    {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    [[nodiscard]] std::vector<std::string> names() const
    {
        std::vector<std::string> result;
        for (const auto& entry : fs::directory_iterator(path))
            result.push_back(entry.path().filename().string());
        std::ranges::sort(result);
        return result;
    }
};

void write(const fs::path& path, const std::string& text)
{
    std::ofstream(path) << text;
}

std::ptrdiff_t open_files()
{
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
}

io::polygon_soup tetrahedron_with_values()
{
    return io::read_mesh(mesh_format::ply, files::ply);
}

const std::string vtu =
    "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><PointData>"
    "<DataArray type=\"Float64\" Name=\"heat\">1 2 3</DataArray></PointData><Points><DataArray type=\"Float32\" "
    "NumberOfComponents=\"3\" format=\"binary\">JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==</DataArray>"
    "</Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int8\" "
    "Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\">5</DataArray></Cells></Piece>"
    "</UnstructuredGrid></VTKFile>";

/// Expects that a trial failed with std::bad_alloc or succeeded with the same result.
void expect_memory_error_only(const trial& trial)
{
    EXPECT_EQ(trial.other, "") << trial.text();
}

void expect_written_or_untouched(const std::string& name, bool exists)
{
    SCOPED_TRACE(name + (exists ? ", which replaces a file" : ""));
    const test_directory directory;
    const fs::path path = directory.path / name;
    const auto soup = tetrahedron_with_values();
    const basic_mesh<> mesh = make_mesh(soup.points, soup.faces);
    const io::written_mesh what{.mesh = mesh, .tags = &soup.tags, .attributes = &soup.attributes};
    io::write_mesh_file(path, what);
    const std::string whole = bytes_of(path), before = exists ? "as it was" : "";

    const std::string text = path.string();
    std::ptrdiff_t open_before = 0;
    try_all(
        [&] {
            directory.clear();
            if (exists)
                write(path, before);
            open_before = open_files();
        },
        [&] { io::write_mesh_file(text, what); },
        [&](const trial& trial) {
            SCOPED_TRACE(trial.text());
            expect_memory_error_only(trial);
            const bool is_written = not trial.has_thrown;
            EXPECT_EQ(fs::exists(path), exists or is_written);
            EXPECT_EQ(bytes_of(path), is_written ? whole : before);
            EXPECT_EQ(directory.names().size(), exists or is_written ? 1 : 0);
            EXPECT_EQ(open_files(), open_before);
            io::write_mesh_file(text, what); // a failed attempt does not leave the file locked
            EXPECT_EQ(bytes_of(path), whole);
        });
}

} // namespace

TEST(failing_files, a_file_is_written_whole_or_not_at_all)
{
    expect_written_or_untouched("a.off", false);
    for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"})
        expect_written_or_untouched(name, true);
}

TEST(failing_files, a_directory_goes_with_its_file)
{
    const test_directory directory;
    const std::string target = directory.path / "index", pieces = directory.path / "pieces";
    const std::ptrdiff_t open_before = open_files();
    try_all([&] { directory.clear(); },
            [&] {
                io::unfinished_file file(target);
                file.make_directory(pieces);
                std::string piece = pieces + "/a piece with a name of more letters than fit into a string";
                write(piece, "text");
            },
            [&](const trial& trial) {
                SCOPED_TRACE(trial.text());
                expect_memory_error_only(trial);
                EXPECT_EQ(directory.names(), std::vector<std::string>());
                EXPECT_EQ(open_files(), open_before);
            });
}

TEST(failing_files, what_a_killed_process_left_is_removed_by_the_next_one)
{
    const test_directory directory;
    const std::string target = directory.path / "a.off", left = io::unfinished_name(target, 1);
    try_all(
        [&] {
            directory.clear();
            write(left, "half of it");
            fs::create_directory(left + ".pieces");
            write(left + ".pieces/0.vtu", "half of a piece");
        },
        [&] { io::output_file file(target); },
        [&](const trial& trial) {
            SCOPED_TRACE(trial.text());
            expect_memory_error_only(trial);
            const io::output_file again(target);
            EXPECT_EQ(directory.names().size(), 1); // the file that was just begun
        });
}

TEST(failing_files, reading_throws_or_yields_the_mesh)
{
    const std::vector<std::pair<mesh_format, std::string>> inputs{
        {mesh_format::off, files::off},
        {mesh_format::obj, files::obj},
        {mesh_format::ply, files::ply},
        {mesh_format::stl, files::stl},
        {mesh_format::stl, files::binary_stl()},
        {mesh_format::ply, files::binary_ply<float, std::uint8_t, int>("float", "uchar", "int", false)},
        {mesh_format::vtu, vtu}};
    for (const auto& [format, bytes] : inputs) {
        const auto expected = io::read_mesh(format, bytes);
        io::polygon_soup soup;
        try_all(
            [&] { soup = {}; },
            [&] { soup = io::read_mesh(format, bytes); },
            [&](const trial& trial) {
                SCOPED_TRACE(trial.text());
                expect_memory_error_only(trial);
                if (trial.has_thrown)
                    return;
                EXPECT_EQ(soup.points, expected.points);
                EXPECT_EQ(soup.faces.vertices, expected.faces.vertices);
                EXPECT_EQ(soup.not_kept, expected.not_kept);
                EXPECT_EQ(soup.notes, expected.notes);
                ASSERT_EQ(soup.attributes.vertices.size(), expected.attributes.vertices.size());
                for (std::size_t i = 0; i < soup.attributes.vertices.size(); ++i)
                    EXPECT_TRUE(std::ranges::equal(
                        soup.attributes.vertices[i].values, expected.attributes.vertices[i].values, [](auto x, auto y) {
                            return x == y or (std::isnan(x) and std::isnan(y)); // an element without a value
                        }));
            });
    }
}

TEST(failing_files, saved_levels_are_read_whole_or_not_at_all)
{
    hierarchy levels(make_mesh(files::corners, files::triangles), loop());
    levels.refine(2);
    std::vector points(levels[1].points().begin(), levels[1].points().end());
    points[3][1] += .5;
    levels.move_points(1, points);
    std::ostringstream out;
    io::write_levels(out, levels);
    const std::string bytes = out.str();
    std::istringstream in;
    std::optional<hierarchy<basic_mesh<>, loop>> again;
    try_all(
        [&] {
            again.reset();
            in = std::istringstream(bytes);
            in.exceptions(std::ios::badbit); // by default a stream hides memory errors
        },
        [&] { again = io::read_levels<basic_mesh<>>(in, loop()); },
        [&](const trial& trial) {
            SCOPED_TRACE(trial.text());
            expect_memory_error_only(trial);
            if (trial.has_thrown)
                return;
            ASSERT_EQ(again->depth(), 2);
            EXPECT_TRUE(std::ranges::equal((*again)[2].points(), levels[2].points()));
        });
}
