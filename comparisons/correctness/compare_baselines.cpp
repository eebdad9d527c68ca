// SPDX-License-Identifier: BSD-3-Clause
#include "verdicts.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/loop.hpp>
#include <kith/presets.hpp>
#include <kith/read_mesh.hpp>
#include <kith/refine.hpp>
#include <kith/tags_of_creases.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace kith::comparison;
namespace io = kith::io;

/// The tolerance for baselines: the files have nine digits, and their refinement was computed in floats.
constexpr double their_precision = 5e-6;

/// A baseline: NAME_ref_after<n>.obj is OpenSubdiv's refinement of NAME.obj by n levels.
struct baseline {
    std::filesystem::path result;
    std::filesystem::path control;
    int levels;
};

std::vector<baseline> baselines_in(const std::filesystem::path& folder)
{
    constexpr std::string_view mark = "_ref_after";
    std::vector<baseline> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        const auto at = name.find(mark);
        if (at != name.npos and entry.path().extension() == ".obj")
            found.push_back(
                {entry.path(), folder / (name.substr(0, at) + ".obj"), std::stoi(name.substr(at + mark.size()))});
    }
    std::ranges::sort(found, {}, &baseline::result);
    return found;
}

template <class Scheme>
void compare_with(const baseline& base, verdicts& verdicts)
{
    const std::string name = base.result.filename().string();
    const auto soup = io::read_mesh_file(base.control.string());
    const control_mesh control{name, kith::make_mesh(soup.points, soup.faces)};
    auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
    scheme.corners = soup.tags.corners.value_or(scheme.corners);
    scheme.sharpness = io::creases_of(soup.tags, control.mesh);
    verdicts.compare(control,
                     kith::scheme_name<Scheme>(),
                     io::read_mesh_file(base.result.string()),
                     {{"native", soup_of(refine(control.mesh, scheme, base.levels))}},
                     their_precision);
}

} // namespace

int main(int count, char** words)
{
    const std::filesystem::path folder = count == 2 ? words[1] : "";
    if (not std::filesystem::is_directory(folder)) {
        std::cout << "skipped: there is no folder '" << folder.string()
                  << "'; give one with OpenSubdiv's baselines, NAME.obj and NAME_ref_after<n>.obj\n";
        return 77;
    }
    const auto found = baselines_in(folder);
    if (found.empty()) {
        std::cout << "skipped: " << folder.string() << " has no files NAME_ref_after<n>.obj\n";
        return 77;
    }
    verdicts verdicts;
    for (const auto& base : found)
        try {
            if (base.control.filename().string().starts_with("loop"))
                compare_with<kith::loop>(base, verdicts);
            else
                compare_with<kith::catmull_clark>(base, verdicts);
        } catch (const std::exception& error) {
            verdicts.different(base.result.filename().string(), "", error.what());
        }
    return verdicts.summary() ? 0 : 1;
}
