// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "openmesh.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

namespace openmesh {

/// A mesh of OpenMesh of any traits: its elements, its properties and its points as arrays. It is a view, so that
/// reading a mesh is compiled once for floats and once for doubles. Isolated vertices are left out, as deleted ones.
template <std::floating_point Scalar>
class kernel_view {
public:
    using point = std::array<Scalar, 3>;

    /// The mesh and the points must outlive the view; `hidden` are properties without values.
    kernel_view(OpenMesh::PolyConnectivity& mesh, const point* points,
                std::vector<const OpenMesh::BaseProperty*> hidden = {})
        : mesh_(&mesh), points_(points), hidden_(std::move(hidden))
    {
    }

    operator const OpenMesh::PolyConnectivity&() const { return *mesh_; }
    [[nodiscard]] OpenMesh::PolyConnectivity& mesh() const { return *mesh_; }
    [[nodiscard]] const point& at(OpenMesh::VertexHandle v) const { return points_[v.idx()]; }
    [[nodiscard]] bool is_hidden(const OpenMesh::BaseProperty* property) const
    {
        for (const auto* each : hidden_)
            if (each == property)
                return true;
        return false;
    }

private:
    OpenMesh::PolyConnectivity* mesh_;
    const point* points_;
    std::vector<const OpenMesh::BaseProperty*> hidden_;
};

} // namespace openmesh

template <class Scalar>
struct mesh_traits<openmesh::kernel_view<Scalar>> : detail::openmesh_connectivity {
    using mesh_type = openmesh::kernel_view<Scalar>;
    using point = typename mesh_type::point;

    static auto vertices(const mesh_type& m)
    {
        const kernel& all = m.mesh();
        const auto is_left_out = [&all, has_status = all.has_vertex_status()](vertex v) {
            return all.is_isolated(v) or (has_status and all.status(v).deleted());
        };
        return numbered_handles<vertex, int, decltype(is_left_out)>(int(all.n_vertices()), is_left_out);
    }
    static const point& point_of(const mesh_type& m, vertex v) { return m.at(v); }
};

#ifdef KITH_COMPILED_OPENMESH // where kith::compiled_openmesh is linked
template <>
inline constexpr bool is_compiled_mesh<openmesh::kernel_view<float>> = true;
template <>
inline constexpr bool is_compiled_mesh<openmesh::kernel_view<double>> = true;
#endif

} // namespace kith
