// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "openmesh_kernel.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/foreign_level.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace kith {

/// The mesh traits of OpenMesh's array kernel, of polygons or triangles, with any traits, and of classes derived from
/// these meshes. A refined mesh has the attributes of its source, in traits or by request: status, normals, colors,
/// texture coordinates and the texture index. Their values are zero and properties of the user's own are left out;
/// openmesh_properties.hpp carries them.
template <std::derived_from<OpenMesh::PolyConnectivity> M>
struct mesh_traits<M> : detail::openmesh_connectivity {
    using point = typename M::Point;

    static const point& point_of(const M& m, vertex v) { return m.point(v); }

    static M build(basic_mesh<point, std::uint32_t>&& fine) { return fill<M>(fine); }

    static void request_like(M& m, const M& source)
    {
        for_each_attribute([&](auto has, auto request, auto) {
            if ((source.*has)() and not(m.*has)())
                (m.*request)();
        });
    }

    static void make_room(M& m, std::size_t vertices, std::size_t edges, std::size_t faces)
    {
        detail::openmesh_connectivity::make_room(m, vertices, edges, faces);
        clear_attributes(m);
    }
    /// Sets the attributes of all elements to zero.
    static void clear_attributes(M& m)
    {
        for_each_attribute([&](auto has, auto, auto property) {
            if ((m.*has)())
                for (auto& value : m.property((m.*property)()).data_vector())
                    set_zero(value);
        });
    }
    static point* points(M& m) { return m.property(m.points_pph()).data_vector().data(); }
    using detail::openmesh_connectivity::set_start;
    static void set_start(M& m, face f, halfedge h, std::size_t degree)
    {
        if (M::is_trimesh() and degree != 3)
            refuse_degree(f.idx(), degree);
        m.set_halfedge_handle(f, h);
    }

    /// Calls f(has, request, property) for each attribute that elements may have beside points. These member functions
    /// of M test for the attribute, request it, and return its property handle.
    template <class F>
    static void for_each_attribute(const F& f)
    {
        f(&M::has_vertex_status, &M::request_vertex_status, &M::vertex_status_pph);
        f(&M::has_halfedge_status, &M::request_halfedge_status, &M::halfedge_status_pph);
        f(&M::has_edge_status, &M::request_edge_status, &M::edge_status_pph);
        f(&M::has_face_status, &M::request_face_status, &M::face_status_pph);
        f(&M::has_vertex_normals, &M::request_vertex_normals, &M::vertex_normals_pph);
        f(&M::has_halfedge_normals, &M::request_halfedge_normals, &M::halfedge_normals_pph);
        f(&M::has_face_normals, &M::request_face_normals, &M::face_normals_pph);
        f(&M::has_vertex_colors, &M::request_vertex_colors, &M::vertex_colors_pph);
        f(&M::has_halfedge_colors, &M::request_halfedge_colors, &M::halfedge_colors_pph);
        f(&M::has_edge_colors, &M::request_edge_colors, &M::edge_colors_pph);
        f(&M::has_face_colors, &M::request_face_colors, &M::face_colors_pph);
        f(&M::has_vertex_texcoords1D, &M::request_vertex_texcoords1D, &M::vertex_texcoords1D_pph);
        f(&M::has_vertex_texcoords2D, &M::request_vertex_texcoords2D, &M::vertex_texcoords2D_pph);
        f(&M::has_vertex_texcoords3D, &M::request_vertex_texcoords3D, &M::vertex_texcoords3D_pph);
        f(&M::has_halfedge_texcoords1D, &M::request_halfedge_texcoords1D, &M::halfedge_texcoords1D_pph);
        f(&M::has_halfedge_texcoords2D, &M::request_halfedge_texcoords2D, &M::halfedge_texcoords2D_pph);
        f(&M::has_halfedge_texcoords3D, &M::request_halfedge_texcoords3D, &M::halfedge_texcoords3D_pph);
        f(&M::has_face_texture_index, &M::request_face_texture_index, &M::face_texture_index_pph);
    }

private:
    /// Sets a value to zero; a new vector of OpenMesh has no value.
    template <class Scalar, int N>
    static void set_zero(OpenMesh::VectorT<Scalar, N>& value)
    {
        value.vectorize(Scalar(0));
    }
    template <class Value>
    static void set_zero(Value& value)
    {
        value = Value();
    }
};

#ifdef KITH_COMPILED_OPENMESH_MESHES // where kith::compiled_openmesh is linked
/// The view through which meshes of any traits are read, if their points are three floats or doubles.
template <std::derived_from<OpenMesh::PolyConnectivity> M>
    requires(std::same_as<typename native_point<typename M::Point>::type, std::array<float, 3>> or
             std::same_as<typename native_point<typename M::Point>::type, std::array<double, 3>>)
struct compiled_view<M> {
    using type = openmesh::kernel_view<scalar_of<typename M::Point>>;
    static type of(const M& m) { return {m, reinterpret_cast<const typename type::point*>(m.points())}; }
};

template <>
inline constexpr bool is_compiled_mesh<OpenMesh::PolyMesh_ArrayKernelT<>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::TriMesh_ArrayKernelT<>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>> = true;
template <>
inline constexpr bool is_compiled_mesh<OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>> = true;
#endif

} // namespace kith
