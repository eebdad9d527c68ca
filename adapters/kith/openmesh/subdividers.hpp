// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subdivider.hpp"
#include "triangulated_midpoints.hpp"

#include <kith/in_place/compiled.hpp>
#include <kith/presets.hpp>
#include <kith/quad_tri.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace kith::openmesh {

namespace detail {

template <scheme Scheme>
Scheme openmesh_scheme()
{
    return like<Scheme>(library::openmesh);
}
template <scheme Scheme>
Scheme own_scheme()
{
    return {};
}

/// A subdivider that starts with OpenMesh's options, or with those of kith for schemes that OpenMesh does not have.
template <subdividable_mesh Mesh, class RealType, scheme Scheme, Scheme (*Options)()>
class subdivider_with : public subdivider<Mesh, Scheme, RealType> {
    using base = subdivider<Mesh, Scheme, RealType>;

public:
    subdivider_with() : base(Options()) {}
    explicit subdivider_with(Mesh& mesh) : base(mesh, Options()) {}
    explicit subdivider_with(Scheme scheme) : base(std::move(scheme)) {}
};

template <subdividable_mesh Mesh, class RealType, scheme Scheme>
using as_openmesh = subdivider_with<Mesh, RealType, Scheme, openmesh_scheme<Scheme>>;
template <subdividable_mesh Mesh, class RealType, scheme Scheme>
using as_kith = subdivider_with<Mesh, RealType, Scheme, own_scheme<Scheme>>;

} // namespace detail

// Named like OpenMesh's classes, so that one changed line takes a program from OpenMesh to kith. The second argument is
// that of OpenMesh's base class; numbers have the type that the mesh has.
// NOLINTBEGIN(readability-identifier-naming)

/// The subdivider OpenMesh::Subdivider::Uniform::LoopT, with the same surface, boundaries included.
template <subdividable_mesh Mesh, class RealType = double>
using LoopT = detail::as_openmesh<Mesh, RealType, loop>;

/// OpenMesh's CatmullClarkT, with the same surface. If old points are not updated it is the linear split, as in
/// OpenMesh.
template <subdividable_mesh Mesh, class RealType = double>
using CatmullClarkT = detail::as_openmesh<Mesh, RealType, catmull_clark>;

/// OpenMesh's Sqrt3T, with the same surface. Unlike in OpenMesh, old points that are not updated stay.
template <subdividable_mesh Mesh, class RealType = double>
using Sqrt3T = detail::as_openmesh<Mesh, RealType, sqrt3>;

/// OpenMesh's ModifiedButterflyT, with the same surface.
template <subdividable_mesh Mesh, class RealType = double>
using ModifiedButterflyT = detail::as_openmesh<Mesh, RealType, butterfly>;

/// OpenMesh's InterpolatingSqrt3LGT, with the same surface, on closed meshes; other meshes are refused.
template <subdividable_mesh Mesh, class RealType = double>
using InterpolatingSqrt3LGT = detail::as_openmesh<Mesh, RealType, interpolatory_sqrt3>;

/// OpenMesh's MidpointT, with the same surface on closed meshes. On other meshes it does not drop faces at the
/// boundary. On a TriMesh each step cuts the faces into triangles, as in OpenMesh, but always in fans around the first
/// corner.
template <subdividable_mesh Mesh, class RealType = double>
using MidpointT =
    std::conditional_t<std::derived_from<Mesh, OpenMesh::TriConnectivity>, triangulated_midpoints<Mesh, RealType>,
                       detail::as_openmesh<Mesh, RealType, mid_edge>>;

// Schemes that OpenMesh does not have.

/// The Doo-Sabin scheme, with the options of kith, like all schemes below.
template <subdividable_mesh Mesh, class RealType = double>
using DooSabinT = detail::as_kith<Mesh, RealType, doo_sabin>;

/// Kobbelt's interpolating scheme; quads.
template <subdividable_mesh Mesh, class RealType = double>
using KobbeltT = detail::as_kith<Mesh, RealType, kobbelt>;

/// The 4-8 scheme of Velho and Zorin. Any mesh, also a TriMesh, is first made a tri-quad mesh, as by `tri_quad`.
/// Exceptions are meshes whose triangles agree on their first edges, as they do after an earlier call.
template <subdividable_mesh Mesh, class RealType = double>
using FourEightT = detail::as_kith<Mesh, RealType, four_eight>;

/// Stam and Loop's quad-triangle scheme.
template <subdividable_mesh Mesh, class RealType = double>
using QuadTriT = detail::as_kith<Mesh, RealType, quad_tri>;

/// Nasri and Hasbini's ternary scheme.
template <subdividable_mesh Mesh, class RealType = double>
using NasriHasbiniT = detail::as_kith<Mesh, RealType, nasri_hasbini>;

/// Zorin and Schroeder's unified family; closed meshes. `scheme().degree` is its bidegree, 1 to 9.
template <subdividable_mesh Mesh, class RealType = double>
using UnifiedT = detail::as_kith<Mesh, RealType, unified>;

/// The linear split of polygons into quads.
template <subdividable_mesh Mesh, class RealType = double>
using LinearT = detail::as_kith<Mesh, RealType, linear>;

/// The linear split of triangles into triangles.
template <subdividable_mesh Mesh, class RealType = double>
using LinearTrianglesT = detail::as_kith<Mesh, RealType, linear_triangles>;

// NOLINTEND(readability-identifier-naming)

} // namespace kith::openmesh
