// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_OPENMESH // where kith::compiled_openmesh is linked

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <kith/mesh/foreign_level.hpp>

namespace kith {

template <>
inline constexpr bool is_compiled_mesh<OpenMesh::PolyMesh_ArrayKernelT<>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::TriMesh_ArrayKernelT<>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>> = true;

} // namespace kith

#endif
