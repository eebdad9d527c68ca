// SPDX-License-Identifier: BSD-3-Clause
#include "compare_files.hpp"

#include "../../tests/support/all_shapes.hpp"
#include "arguments.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>

#include <exception>
#include <iostream>
#include <optional>
#include <utility>

namespace kith::comparison {

namespace {

/// Reads the control mesh of a file. Returns no mesh, and reports why, if the file cannot be used.
std::optional<control_mesh> read(const std::filesystem::path& file, std::size_t max_faces, verdicts& verdicts)
{
    const std::string name = file.filename().string();
    io::polygon_soup soup;
    try {
        soup = io::read_mesh_file(file.string());
    } catch (const io::file_error& error) {
        verdicts.skip(name, "", "no readable mesh: " + std::string(error.what()));
        return std::nullopt;
    }
    if (soup.faces.size() > max_faces) {
        verdicts.skip(name, "", "too large: " + std::to_string(soup.faces.size()) + " faces");
        return std::nullopt;
    }
    try {
        return control_mesh{name, make_mesh(soup.points, soup.faces)};
    } catch (const mesh_error& error) {
        const std::string text = error.what();
        verdicts.skip(name, "", "no manifold: " + text.substr(0, text.find('\n')));
        return std::nullopt;
    }
}

} // namespace

int compare_files(int count, char** words, const std::string& what_it_does,
                  const std::function<void(const control_mesh&, int levels, verdicts&)>& compare)
{
    std::optional<arguments> arguments;
    try {
        arguments = parse(count, words, what_it_does);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    if (not arguments)
        return 0;
    verdicts verdicts;
    for (const auto& [name, shape] : shapes::all_shapes())
        compare({name, make_mesh(shape.points, shape.faces)}, arguments->levels, verdicts);
    for (const auto& file : arguments->files)
        if (const auto mesh = read(file, arguments->max_faces, verdicts))
            compare(*mesh, arguments->levels, verdicts);
    const bool all_the_same = verdicts.summary();
    if (not all_the_same)
        return 1;
    if (not arguments->files.empty())
        return 0;
    std::cout << "There are no OFF files in the data folder; only meshes made here were compared.\n";
    return 77;
}

} // namespace kith::comparison
