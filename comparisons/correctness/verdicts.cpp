// SPDX-License-Identifier: BSD-3-Clause
#include "verdicts.hpp"

#include "compare/mesh_compare.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <ranges>
#include <sstream>

namespace kith::comparison {

double control_mesh::diagonal() const
{
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::ranges::minmax(mesh.points() |
                                                     std::views::transform([i](const auto& p) { return p[i]; }));
        square += (high - low) * (high - low);
    }
    return std::sqrt(square);
}

io::polygon_soup soup_of(const basic_mesh<>& mesh)
{
    return {{mesh.points().begin(), mesh.points().end()}, tool::faces_of(mesh)};
}

namespace {

std::ostream& line(std::string_view mesh, std::string_view scheme)
{
    return std::cout << std::left << std::setw(34) << mesh << ' ' << std::setw(31) << scheme << ' ';
}

std::string counts(const io::polygon_soup& soup)
{
    return std::to_string(soup.points.size()) + " vertices and " + std::to_string(soup.faces.size()) + " faces";
}

std::string describe(const io::polygon_soup& expected, const io::polygon_soup& found,
                     const tool::comparison& difference, double diagonal)
{
    std::ostringstream text;
    text << counts(found) << ", expected " << counts(expected) << "; " << difference.unmatched_vertices
         << " vertices and " << difference.unmatched_faces << " faces without partner, distance "
         << difference.largest_distance / diagonal << " of the diagonal";
    return text.str();
}

} // namespace

void verdicts::skip(std::string_view mesh, std::string_view scheme, std::string_view why)
{
    ++skipped_[std::string(why.substr(0, why.find(':')))];
    line(mesh, scheme) << "skipped: " << why << std::endl;
}

void verdicts::compare(const control_mesh& control, std::string_view scheme, const io::polygon_soup& expected,
                       const std::vector<result>& found, double tolerance)
{
    const double diagonal = control.diagonal();
    double worst = 0;
    for (const auto& [way, soup] : found) {
        const auto difference = tool::compare_meshes(
            expected.points, expected.faces, soup.points, soup.faces, tolerance * diagonal);
        if (not difference.equal())
            return different(control.name, scheme, way + ": " + describe(expected, soup, difference, diagonal));
        worst = std::max(worst, difference.largest_distance / diagonal);
    }
    same(control.name, scheme, counts(expected), worst);
}

void verdicts::same(std::string_view mesh, std::string_view scheme, std::string_view what, double distance)
{
    auto& sum = by_scheme_[std::string(scheme)];
    ++sum.same;
    if (distance >= sum.worst) {
        sum.worst = distance;
        sum.worst_mesh = mesh;
    }
    line(mesh, scheme) << "same, " << what << ", distance " << std::setprecision(2) << distance << std::endl;
}

void verdicts::different(std::string_view mesh, std::string_view scheme, std::string_view what)
{
    ++by_scheme_[std::string(scheme)].different;
    line(mesh, scheme) << "DIFFERENT: " << what << std::endl;
}

bool verdicts::summary() const
{
    std::size_t different = 0;
    std::cout << '\n';
    for (const auto& [scheme, sum] : by_scheme_) {
        different += sum.different;
        std::cout << scheme << ": " << sum.same << " the same, " << sum.different << " different";
        if (sum.same != 0)
            std::cout << "; largest distance " << std::setprecision(2) << sum.worst << " of the diagonal ("
                      << sum.worst_mesh << ')';
        std::cout << '\n';
    }
    for (const auto& [why, count] : skipped_)
        std::cout << "skipped, " << why << ": " << count << '\n';
    return different == 0;
}

} // namespace kith::comparison
