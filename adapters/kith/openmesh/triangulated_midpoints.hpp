// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overwritten_mesh.hpp"

#include <kith/in_place/cut_into_triangles.hpp>
#include <kith/mid_edge.hpp>

#include <OpenMesh/Tools/Subdivider/Uniform/SubdividerT.hh>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace kith::openmesh {

/// The mid-edge scheme on a triangle mesh; each step cuts the new faces into triangles. As with OpenMesh's MidpointT no
/// vertex stays, and it does not matter whether points are to be updated. Values are carried as by `subdivider`.
/// After an exception, also when memory runs out, the mesh is unchanged, except where OpenMesh computes normals of
/// half-edges.
template <subdividable_mesh Mesh, class RealType = double>
class triangulated_midpoints : public OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType> {
public:
    using parent_t = OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType>;

    triangulated_midpoints() = default;
    explicit triangulated_midpoints(Mesh& mesh) { parent_t::attach(mesh); }
    triangulated_midpoints(const triangulated_midpoints&) = delete;
    triangulated_midpoints& operator=(const triangulated_midpoints&) = delete;
    ~triangulated_midpoints() override { parent_t::detach(); }

    [[nodiscard]] const char* name() const override { return "mid-edge, triangulated"; }
    /// Returns which properties the last refinement carried, and which it left out, with the reason.
    [[nodiscard]] const property_report& report() const { return report_; }

protected:
    bool prepare(Mesh&) override { return true; }
    bool cleanup(Mesh&) override { return true; }
    /// Refines the mesh n times. Errors: as `subdivider`.
    bool subdivide(Mesh& mesh, std::size_t n, const bool = true) override
    {
        using view = typename overwritten_mesh<Mesh>::view_type;
        report_ = {};
        if (n == 0 or mesh.faces_sbegin() == mesh.faces_end())
            return true;
        overwritten_mesh<Mesh> whole(mesh);
        in_place::refined<typename view::point> surface{to_native_valid(whole.view()), true};
        in_place::carried_properties<view> carried(whole.view());
        mid_edge scheme;
        for (std::size_t i = 0; i < n; ++i) {
            kith::detail::require_refinable(surface.mesh, scheme, 1, {});
            in_place::step(surface, scheme, carried.values(), false);
            in_place::cut_into_triangles(surface, carried.values());
        }
        property_report report = carried.report(numbering_of<mid_edge, std::uint32_t>::has_edges);
        whole.overwrite(surface, carried);
        report_ = std::move(report);
        whole.make_normals();
        return true;
    }

private:
    property_report report_;
};

} // namespace kith::openmesh
