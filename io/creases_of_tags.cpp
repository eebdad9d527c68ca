// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tags_of_creases.hpp>

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <map>
#include <string>

namespace kith::io {

creases creases_of(const mesh_tags& tags, const basic_mesh<>& mesh)
{
    creases result(tags.method.value_or(crease_method::uniform));
    for (const auto& [vertex, sharpness] : tags.vertices) {
        if (vertex >= mesh.vertex_count())
            throw mesh_error("corner " + std::to_string(vertex) + ": there is no such vertex; correct the tag");
        result.sharpen_vertex(vertex, sharpness);
    }
    if (tags.edges.empty())
        return result;
    std::map<std::pair<std::size_t, std::size_t>, double> wanted;
    for (const auto& [from, to, sharpness] : tags.edges)
        wanted[std::minmax(from, to)] = sharpness;
    const level_of<basic_mesh<>> level(mesh);
    for (const auto e : level.edges()) {
        const auto found = wanted.find(std::minmax(e.org().index(), e.dst().index()));
        if (found == wanted.end())
            continue;
        result.sharpen_edge(e.index(), found->second);
        wanted.erase(found);
    }
    if (not wanted.empty()) {
        const auto& [from, to] = wanted.begin()->first;
        throw mesh_error("crease " + std::to_string(from) + "-" + std::to_string(to) +
                         ": there is no such edge; correct the tag");
    }
    return result;
}

} // namespace kith::io
