// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
// Vectors of OpenMesh have no values at first, of which g++ warns where properties of colors grow by one.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <kith/mesh/foreign_level.hpp>
#include <kith/base/large_blocks.hpp>
#include <kith/mesh/basic_mesh.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace kith {

template <class Scalar, int N>
struct affine<OpenMesh::VectorT<Scalar, N>> : coordinates_affine<Scalar, std::size_t(N)> {
    using point = OpenMesh::VectorT<Scalar, N>;
    using typename coordinates_affine<Scalar, std::size_t(N)>::sum;
    static constexpr bool is_array = std::floating_point<Scalar>;

    static sum load(const point& p)
    {
        sum result;
        for (int i = 0; i < N; ++i)
            result[std::size_t(i)] = p[i];
        return result;
    }
    static point store(const sum& total)
    {
        point result;
        for (int i = 0; i < N; ++i)
            result[i] = total[std::size_t(i)];
        return result;
    }
};

/// Colours, and other vectors of integers.
template <std::integral Scalar, int N>
struct affine<OpenMesh::VectorT<Scalar, N>> : rounded_affine<OpenMesh::VectorT<Scalar, N>, Scalar, std::size_t(N)> {};

namespace detail {

/// The elements of OpenMesh's meshes, through the part of these that their traits say nothing of.
struct openmesh_connectivity {
    using kernel = OpenMesh::PolyConnectivity;

protected:
    template <class Handle>
    static auto alive(const kernel& m, std::size_t bound, bool has_status)
    {
        const auto is_removed = [&m, has_status](Handle x) { return has_status and m.status(x).deleted(); };
        return numbered_handles<Handle, int, decltype(is_removed)>(int(bound), is_removed);
    }

public:
    using vertex = OpenMesh::VertexHandle;
    using edge = OpenMesh::EdgeHandle;
    using face = OpenMesh::FaceHandle;
    using halfedge = OpenMesh::HalfedgeHandle;

    static auto vertices(const kernel& m) { return alive<vertex>(m, m.n_vertices(), m.has_vertex_status()); }
    static auto edges(const kernel& m) { return alive<edge>(m, m.n_edges(), m.has_edge_status()); }
    static auto faces(const kernel& m) { return alive<face>(m, m.n_faces(), m.has_face_status()); }
    template <class Handle>
    static std::size_t index(const kernel&, Handle x)
    {
        return std::size_t(x.idx());
    }
    // These count deleted elements, too: they are bounds.
    static std::size_t vertex_bound(const kernel& m) { return m.n_vertices(); }
    static std::size_t edge_bound(const kernel& m) { return m.n_edges(); }
    static std::size_t face_bound(const kernel& m) { return m.n_faces(); }
    static std::size_t halfedge_bound(const kernel& m) { return m.n_halfedges(); }

    static halfedge next(const kernel& m, halfedge h) { return m.next_halfedge_handle(h); }
    static halfedge prev(const kernel& m, halfedge h) { return m.prev_halfedge_handle(h); }
    static halfedge opposite(const kernel& m, halfedge h) { return m.opposite_halfedge_handle(h); }
    static bool is_boundary(const kernel& m, halfedge h) { return m.is_boundary(h); }
    static vertex source(const kernel& m, halfedge h) { return m.from_vertex_handle(h); }
    static edge edge_of(const kernel& m, halfedge h) { return m.edge_handle(h); }
    static face face_of(const kernel& m, halfedge h) { return m.face_handle(h); }
    static halfedge halfedge_of(const kernel& m, vertex v) { return m.halfedge_handle(v); }
    static halfedge halfedge_of(const kernel& m, edge e) { return m.halfedge_handle(e, 0); }
    static halfedge halfedge_of(const kernel& m, face f) { return m.halfedge_handle(f); }
    static bool is_isolated(const kernel& m, vertex v) { return m.is_isolated(v); }
    static vertex target(const kernel& m, halfedge h) { return m.to_vertex_handle(h); }

    /// Errors: mesh_error for more edges than OpenMesh can number.
    static void require_room(std::size_t edges)
    {
        if (edges > std::size_t(std::numeric_limits<int>::max()) / 2)
            throw mesh_error("OpenMesh numbers half-edges with int, the next level has " + std::to_string(edges) +
                             " edges; refine fewer times");
    }
    [[noreturn]] static void refuse_degree(int face, std::size_t degree)
    {
        throw mesh_error("OpenMesh's TriMesh holds triangles only, face " + std::to_string(face) + " has " +
                         std::to_string(degree) + " vertices; refine a PolyMesh instead");
    }
    template <class Handle>
    static Handle at(std::size_t i)
    {
        return Handle(int(i));
    }
    static void set_side(kernel& m, halfedge h, face f, vertex target, halfedge next)
    {
        m.set_face_handle(h, f);
        m.set_vertex_handle(h, target);
        m.set_next_halfedge_handle(h, next);
    }
    /// A boundary vertex must name the half-edge without face that leaves it.
    static void set_boundary_side(kernel& m, halfedge h, vertex target, halfedge next)
    {
        m.set_boundary(h);
        m.set_vertex_handle(h, target);
        m.set_next_halfedge_handle(h, next);
        m.set_halfedge_handle(m.to_vertex_handle(m.opposite_halfedge_handle(h)), h);
    }
    static void set_start(kernel& m, face f, halfedge h, std::size_t) { m.set_halfedge_handle(f, h); }
    static void set_start(kernel& m, vertex v, halfedge leaving) { m.set_halfedge_handle(v, leaving); }

    static constexpr const char* odd_generation = "kith:odd_generation"; ///< the name of a property of the mesh
    static void mark_odd_generation(kernel& m)
    {
        OpenMesh::MPropHandleT<bool> odd;
        m.add_property(odd, odd_generation);
        m.property(odd) = true;
    }
    static int generation(const kernel& m)
    {
        OpenMesh::MPropHandleT<bool> odd;
        return m.get_property_handle(odd, odd_generation) ? 1 : 0;
    }
};

} // namespace detail

/// Meshes of OpenMesh's array kernel, polygons or triangles, any traits, classes derived from them included.
/// A refined mesh has the attributes of its source, in traits or by request: status, normals, colors, texture
/// coordinates and the texture index. Their values are zero and properties of the user's own are left out;
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
        require_room(edges);
        if (faces != 0) {
            m.reserve(vertices, edges, faces);
            m.resize(1, 1, 1); // so that the arrays can be seen before their pages are touched
            advise_large_pages(&m.vertex(vertex(0)), vertices);
            advise_large_pages(&m.edge(edge(0)), edges);
            advise_large_pages(&m.face(face(0)), faces);
            advise_large_pages(points(m), vertices);
        }
        m.resize(vertices, edges, faces);
        clear_attributes(m);
    }
    /// Makes the attributes of all elements zero.
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

    /// What elements may have beside points: how to ask whether they do, to ask for it, and where it is.
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
    /// A vector of OpenMesh is made without values.
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

#ifdef KITH_COMPILED_OPENMESH // where kith::compiled_openmesh is linked
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
