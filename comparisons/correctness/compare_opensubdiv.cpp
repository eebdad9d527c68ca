// SPDX-License-Identifier: BSD-3-Clause
#include "compare_files.hpp"
#include "peers/opensubdiv_peer.hpp"

#include <kith/presets.hpp>
#include <kith/refine.hpp>

#include <cstddef>
#include <exception>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace kith::comparison;

/// The tolerance for creases: OpenSubdiv stores sharpness in floats, so weights computed from sharpness carry their
/// rounding error.
constexpr double float_sharpness = 1e-8;

/// Sharpens some edges and a few vertices with values from `sharpness`; always the same edges and vertices.
kith::creases random_creases(const kith::basic_mesh<>& mesh, const std::vector<double>& sharpness,
                             kith::crease_method method)
{
    std::minstd_rand random(1);
    kith::creases result(method);
    for (std::size_t e = 0; e < mesh.edge_count(); ++e)
        if (random() % 5 == 0)
            result.sharpen_edge(e, sharpness[random() % sharpness.size()]);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (random() % 40 == 0)
            result.sharpen_vertex(v, sharpness[random() % sharpness.size()]);
    return result;
}

template <class Scheme>
void compare_scheme(const control_mesh& control, const Scheme& scheme, const char* options, int levels,
                    verdicts& verdicts)
{
    const std::string name = std::string(kith::scheme_name<Scheme>()) + options;
    if (kith::needs_triangles<Scheme> and not control.is_triangles())
        return verdicts.skip(control.name, name, "not only triangles");
    try {
        const auto theirs = opensubdiv_peer::make(control.mesh, scheme);
        if (not theirs)
            return verdicts.different(control.name, name, "OpenSubdiv refuses a mesh that kith takes");
        opensubdiv_peer::refine(theirs, levels, false);
        const auto control_points = opensubdiv_peer::points_of<double>(control.mesh);
        const auto points = opensubdiv_peer::interpolate<double>(theirs, control_points);
        verdicts.compare(control,
                         name,
                         opensubdiv_peer::soup(theirs, points),
                         {{"native", soup_of(refine(control.mesh, scheme, levels))}},
                         scheme.sharpness.empty() ? verdicts::rounding : float_sharpness);
    } catch (const kith::mesh_error& error) {
        verdicts.skip(control.name, name, std::string("kith refuses it: ") + error.what());
    } catch (const std::exception& error) {
        verdicts.different(control.name, name, error.what());
    }
}

template <class Scheme>
void compare_options(const control_mesh& control, int levels, verdicts& verdicts)
{
    auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
    compare_scheme(control, scheme, "", levels, verdicts);
    scheme.corners = kith::boundary_corner::smoothed;
    compare_scheme(control, scheme, ", EDGE_ONLY", levels, verdicts);
    scheme.sharpness = random_creases(
        control.mesh, {0.25, 0.5, 1, 1.375, 2, 3.5, kith::infinitely_sharp}, kith::crease_method::uniform);
    compare_scheme(control, scheme, ", creases", levels, verdicts);
    // No two values below and above 1 on any level: there OpenSubdiv's weights leave the range from 0 to 1.
    scheme.sharpness = random_creases(control.mesh, {1.5, 1.625, 1.75}, kith::crease_method::chaikin);
    compare_scheme(control, scheme, ", Chaikin creases", levels, verdicts);
}

} // namespace

int main(int count, char** words)
{
    return compare_files(count,
                         words,
                         "Refines meshes with OpenSubdiv and with kith and compares the results.",
                         [](const control_mesh& control, int levels, verdicts& verdicts) {
                             compare_options<kith::catmull_clark>(control, levels, verdicts);
                             compare_options<kith::loop>(control, levels, verdicts);
                         });
}
