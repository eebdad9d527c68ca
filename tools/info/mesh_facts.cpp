// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_facts.hpp"

#include "job/mesh_input.hpp"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace kith::tool {

namespace {

using side = std::pair<std::size_t, std::size_t>; ///< the vertices of a corner of a face and of the next corner

std::vector<side> sorted_sides(const face_list& faces)
{
    std::vector<side> result;
    result.reserve(faces.vertices.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto face = faces[f];
        for (std::size_t i = 0; i < face.size(); ++i)
            result.emplace_back(face[i], face[i + 1 == face.size() ? 0 : i + 1]);
    }
    std::ranges::sort(result);
    return result;
}

std::vector<side> edges_of(std::vector<side> sides)
{
    std::erase_if(sides, [](const side& s) { return s.first == s.second; });
    for (auto& [a, b] : sides)
        if (a > b)
            std::swap(a, b);
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return sides;
}

std::size_t components_of(std::size_t vertices, const face_list& faces)
{
    boost::disjoint_sets_with_storage<> sets(vertices);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const std::size_t v : faces[f])
            sets.union_set(faces[f][0], v);
    std::vector<bool> seen(vertices, false);
    std::size_t result = 0;
    for (const std::size_t v : faces.vertices) {
        const std::size_t root = sets.find_set(v);
        result += not seen[root];
        seen[root] = true;
    }
    return result;
}

/// Returns the number of boundary loops. Precondition: a valid mesh. There each boundary vertex has one incoming and
/// one outgoing side without an opposite side in another face.
std::size_t boundary_loops_of(std::size_t vertices, const std::vector<side>& sides)
{
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> next(vertices, none);
    for (const auto& [a, b] : sides)
        if (not std::ranges::binary_search(sides, side(b, a)))
            next[a] = b;
    std::size_t result = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        result += next[v] != none;
        for (std::size_t here = v; next[here] != none;)
            here = std::exchange(next[here], none);
    }
    return result;
}

auto box_of(std::span<const std::array<double, 3>> points)
{
    std::pair result(points[0], points[0]);
    for (const auto& p : points)
        for (std::size_t i = 0; i < 3; ++i) {
            result.first[i] = std::min(result.first[i], p[i]);
            result.second[i] = std::max(result.second[i], p[i]);
        }
    return result;
}

} // namespace

mesh_facts facts_of(const io::polygon_soup& soup, const mesh_report& report)
{
    const std::size_t vertices = soup.points.size();
    mesh_facts result{.vertices = vertices, .faces = soup.faces.size()};
    for (std::size_t f = 0; f < soup.faces.size(); ++f)
        ++result.degrees[soup.faces[f].size()];
    result.isolated = std::size_t(std::ranges::count(vertices_with_faces(soup), false));
    if (vertices != 0)
        result.box = box_of(soup.points);

    const std::vector<side> sides = sorted_sides(soup.faces);
    const std::vector<side> edges = edges_of(sides);
    result.edges = edges.size();
    result.components = components_of(vertices, soup.faces);
    result.euler_characteristic = std::ptrdiff_t(vertices) - std::ptrdiff_t(result.edges) +
                                  std::ptrdiff_t(result.faces);
    if (report.ok())
        result.boundary_loops = boundary_loops_of(vertices, sides);

    std::vector<std::size_t> valence(vertices, 0);
    for (const auto& [a, b] : edges) {
        ++valence[a];
        ++valence[b];
    }
    std::vector<std::size_t> faces_at(vertices, 0);
    for (std::size_t f = 0; f < soup.faces.size(); ++f)
        for (const std::size_t v : soup.faces[f])
            if (v < vertices)
                ++faces_at[v];
    for (std::size_t v = 0; v < vertices; ++v) {
        ++result.valences[valence[v]];
        result.between_two_faces += valence[v] == 2 and faces_at[v] == 2;
    }
    return result;
}

} // namespace kith::tool
