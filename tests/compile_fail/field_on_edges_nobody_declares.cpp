// SPDX-License-Identifier: BSD-3-Clause
// A field on edges beside a scheme whose edges are found by matching.
#include <kith/refine_with_fields.hpp>

#include <tuple>
#include <vector>

struct without_edges {
    static constexpr auto columns()
    {
        using namespace kith;
        return kith::columns(new_vertices(per_vertex, per_edge), new_faces(triangles(per_corner), triangles(per_face)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = 1. * v; });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
    }
};

void refine(const kith::basic_mesh<>& mesh)
{
    auto tags = kith::on_edges(std::vector<int>(mesh.edge_count(), 1));
    kith::refine_with_fields(mesh, without_edges{}, 1, std::tie(tags));
}
