// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overwritten_mesh.hpp"

#include <kith/in_place/split_long_edges.hpp>

#include <OpenMesh/Tools/Subdivider/Uniform/SubdividerT.hh>

#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>

namespace kith::openmesh {

// NOLINTBEGIN(readability-identifier-naming): named as OpenMesh's

/// A subdivider like OpenMesh::Subdivider::Uniform::LongestEdgeT. It splits the longest edge of a triangle mesh in its
/// middle until no edge is longer than set_max_edge_length(). Of edges of equal length, the edge between the smaller
/// vertices comes first. As in OpenMesh, the number of steps is ignored. Old vertices keep their handles. Values of new
/// vertices, and of corners, are linear along the split edges; faces and edges inherit from those in which they lie.
/// Normals are recomputed.
/// After an exception, also when memory runs out, the mesh is unchanged, except where OpenMesh computes normals of
/// half-edges.
template <subdividable_mesh Mesh, class RealType = float>
class LongestEdgeT : public OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType> {
    static_assert(std::derived_from<Mesh, OpenMesh::TriConnectivity>,
                  "kith::openmesh::LongestEdgeT splits triangles; use a TriMesh");

public:
    using parent_t = OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType>;

    LongestEdgeT() = default;
    explicit LongestEdgeT(Mesh& mesh) { parent_t::attach(mesh); }
    LongestEdgeT(const LongestEdgeT&) = delete;
    LongestEdgeT& operator=(const LongestEdgeT&) = delete;
    ~LongestEdgeT() override { parent_t::detach(); }

    [[nodiscard]] const char* name() const override { return "longest edge"; }
    /// Sets the largest length that an edge may have. It is infinite by default: nothing is split.
    void set_max_edge_length(double length) { length_ = length; }
    /// Returns which properties the last refinement carried, and which it left out, with the reason.
    [[nodiscard]] const property_report& report() const { return report_; }

protected:
    bool prepare(Mesh&) override { return true; }
    bool cleanup(Mesh&) override { return true; }
    /// Splits the long edges. Errors: mesh_error with everything that `validate` finds, and for a length that is not
    /// above 0.
    bool subdivide(Mesh& mesh, std::size_t, const bool = true) override
    {
        report_ = {};
        if (mesh.faces_sbegin() == mesh.faces_end())
            return true;
        overwritten_mesh<Mesh> whole(mesh);
        auto& all = whole.view();
        const auto control = to_native_valid(all);
        in_place::long_edge_splitter splitter(control, length_);
        if (not splitter.has_long_edges())
            return true;
        const auto fine = splitter.run();
        in_place::carried_properties<typename overwritten_mesh<Mesh>::view_type> carried(all);
        splitter.carry(fine.mesh, carried.values());
        property_report report = carried.report(true);
        whole.overwrite(fine, carried);
        report_ = std::move(report);
        whole.make_normals();
        return true;
    }

private:
    double length_ = std::numeric_limits<double>::infinity();
    property_report report_;
};

// NOLINTEND(readability-identifier-naming)

} // namespace kith::openmesh
