// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <kith/basic_mesh.hpp>
#include <kith/for_parts.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <string>
#include <type_traits>
#include <vector>

namespace kith {

template <class Scalar, int N>
struct affine<OpenMesh::VectorT<Scalar, N>> : coordinates_affine<Scalar, std::size_t(N)> {
    using point = OpenMesh::VectorT<Scalar, N>;
    using typename coordinates_affine<Scalar, std::size_t(N)>::sum;

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

/// Meshes of OpenMesh's array kernel, polygons or triangles, any traits, classes derived from them included.
template <std::derived_from<OpenMesh::PolyConnectivity> M>
struct mesh_traits<M> {
    using vertex = OpenMesh::VertexHandle;
    using edge = OpenMesh::EdgeHandle;
    using face = OpenMesh::FaceHandle;
    using halfedge = OpenMesh::HalfedgeHandle;
    using point = typename M::Point;

    static auto vertices(const M& m) { return alive<vertex>(m, m.n_vertices(), m.has_vertex_status()); }
    static auto edges(const M& m) { return alive<edge>(m, m.n_edges(), m.has_edge_status()); }
    static auto faces(const M& m) { return alive<face>(m, m.n_faces(), m.has_face_status()); }
    template <class Handle>
    static std::size_t index(const M&, Handle x)
    {
        return std::size_t(x.idx());
    }
    // These count deleted elements, too: they are bounds.
    static std::size_t vertex_bound(const M& m) { return m.n_vertices(); }
    static std::size_t edge_bound(const M& m) { return m.n_edges(); }
    static std::size_t face_bound(const M& m) { return m.n_faces(); }
    static std::size_t halfedge_bound(const M& m) { return m.n_halfedges(); }

    static halfedge next(const M& m, halfedge h) { return m.next_halfedge_handle(h); }
    static halfedge prev(const M& m, halfedge h) { return m.prev_halfedge_handle(h); }
    static halfedge opposite(const M& m, halfedge h) { return m.opposite_halfedge_handle(h); }
    static bool is_boundary(const M& m, halfedge h) { return m.is_boundary(h); }
    static vertex source(const M& m, halfedge h) { return m.from_vertex_handle(h); }
    static edge edge_of(const M& m, halfedge h) { return m.edge_handle(h); }
    static face face_of(const M& m, halfedge h) { return m.face_handle(h); }
    static halfedge halfedge_of(const M& m, vertex v) { return m.halfedge_handle(v); }
    static halfedge halfedge_of(const M& m, edge e) { return m.halfedge_handle(e, 0); }
    static halfedge halfedge_of(const M& m, face f) { return m.halfedge_handle(f); }
    static bool is_isolated(const M& m, vertex v) { return m.is_isolated(v); }
    static const point& point_of(const M& m, vertex v) { return m.point(v); }

    /// In bulk, through the kernel's primitives: half-edge 2e+s of the one mesh is half-edge 2e+s of the other.
    static M build(basic_mesh<point, std::uint32_t>&& fine)
    {
        const auto& t = fine.topology();
        if constexpr (M::is_trimesh())
            for (std::size_t f = 0; f < t.faces; ++f)
                if (t.first_corner(f + 1) - t.first_corner(f) != 3)
                    throw mesh_error("OpenMesh's TriMesh holds triangles only, face " + std::to_string(f) + " has " +
                                     std::to_string(t.first_corner(f + 1) - t.first_corner(f)) +
                                     " vertices; refine a PolyMesh instead");
        M m;
        m.resize(t.vertices, t.edges(), t.faces);
        detail::for_parts(t.vertices, std::is_trivially_copyable_v<point>, [&](std::size_t begin, std::size_t last) {
            for (std::size_t v = begin; v < last; ++v) {
                m.set_point(vertex(int(v)), fine.point(v));
                m.set_halfedge_handle(vertex(int(v)), halfedge(int(t.corner_halfedge[t.vertex_corner[v]])));
            }
        });
        detail::for_parts(t.faces, true, [&](std::size_t begin, std::size_t last) {
            for (std::size_t f = begin; f < last; ++f) {
                const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
                m.set_halfedge_handle(face(int(f)), halfedge(int(t.corner_halfedge[first])));
                for (std::size_t c = first; c < end; ++c) {
                    const std::size_t next = c + 1 == end ? first : c + 1;
                    const halfedge h(int(t.corner_halfedge[c]));
                    m.set_face_handle(h, face(int(f)));
                    m.set_vertex_handle(h, vertex(int(t.corner_vertex[next])));
                    m.set_next_halfedge_handle(h, halfedge(int(t.corner_halfedge[next])));
                }
            }
        });
        close_boundary(m, t);
        // Only a boundary between two steps of sqrt(3) or 4-8 needs this to be remembered.
        if (fine.generation() % 2 != 0 and t.corners() != 2 * t.edges()) {
            OpenMesh::MPropHandleT<bool> odd;
            m.add_property(odd, odd_generation);
            m.property(odd) = true;
        }
        return m;
    }
    static int generation(const M& m)
    {
        OpenMesh::MPropHandleT<bool> odd;
        return m.get_property_handle(odd, odd_generation) ? 1 : 0;
    }

private:
    static constexpr const char* odd_generation = "kith:odd_generation";

    template <class Handle>
    static auto alive(const M& m, std::size_t bound, bool has_status)
    {
        return std::views::iota(0, int(bound)) | std::views::transform([](int i) { return Handle(i); }) |
               std::views::filter([&m, has_status](Handle x) { return not has_status or not m.status(x).deleted(); });
    }
    /// Half-edges without a face run along the boundary the other way. A boundary vertex must name the one that leaves it.
    static void close_boundary(M& m, const connectivity<std::uint32_t>& t)
    {
        std::vector<halfedge> boundary;
        for (std::size_t h = 1; h < 2 * t.edges(); h += 2)
            if (t.halfedge_corner[h] == t.none)
                boundary.push_back(halfedge(int(h)));
        for (const halfedge h : boundary) {
            m.set_boundary(h);
            m.set_vertex_handle(h, vertex(int(t.corner_vertex[t.halfedge_corner[std::size_t(h.idx()) ^ 1]])));
            m.set_halfedge_handle(m.to_vertex_handle(m.opposite_halfedge_handle(h)), h);
        }
        for (const halfedge h : boundary)
            m.set_next_halfedge_handle(h, m.halfedge_handle(m.to_vertex_handle(h)));
    }
};

} // namespace kith
