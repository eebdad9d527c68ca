// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
// New vectors of OpenMesh have no values; g++ warns of this where properties of colors grow by one.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/base/large_blocks.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

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

/// The arithmetic of colours and of other vectors of integers.
template <std::integral Scalar, int N>
struct affine<OpenMesh::VectorT<Scalar, N>> : rounded_affine<OpenMesh::VectorT<Scalar, N>, Scalar, std::size_t(N)> {};

namespace detail {

/// The elements of OpenMesh's meshes, through their base class that does not depend on traits.
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

    /// Throws mesh_error for more edges than OpenMesh can number.
    static void require_room(std::size_t edges)
    {
        if (edges > std::size_t(std::numeric_limits<int>::max()) / 2)
            throw mesh_error("OpenMesh numbers half-edges with int, the next level has " + std::to_string(edges) +
                             " edges; refine fewer times");
    }
    /// Makes these numbers of elements, without attributes. Errors: as require_room, and std::bad_alloc.
    static void make_room(kernel& m, std::size_t vertices, std::size_t edges, std::size_t faces)
    {
        require_room(edges);
        if (edges * sizeof(OpenMesh::ArrayItems::Edge) >= 4 * huge_page)
            reserve_in_large_pages([&] { m.reserve(vertices, edges, faces); });
        m.resize(vertices, edges, faces);
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
    /// Sets a half-edge without face, and makes it the half-edge of its source vertex, as OpenMesh requires at the
    /// boundary.
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

namespace openmesh {

/// A view of a mesh of OpenMesh with any traits: its elements, its properties, and its points as arrays. Thanks to the
/// view, reading a mesh is compiled once for floats and once for doubles.
template <std::floating_point Scalar>
class kernel_view {
public:
    using point = std::array<Scalar, 3>;

    /// Makes a view for callers that overwrite the mesh: isolated vertices are left out, like deleted ones. The mesh
    /// and the points must outlive the view; `hidden` are properties without values.
    kernel_view(OpenMesh::PolyConnectivity& mesh, const point* points,
                std::vector<const OpenMesh::BaseProperty*> hidden)
        : mesh_(&mesh), points_(points), hidden_(std::move(hidden)), leaves_out_isolated_(true)
    {
    }
    /// Makes a view for callers that only read the elements.
    kernel_view(const OpenMesh::PolyConnectivity& mesh, const point* points)
        : mesh_(const_cast<OpenMesh::PolyConnectivity*>(&mesh)), points_(points), leaves_out_isolated_(false)
    {
    }

    operator const OpenMesh::PolyConnectivity&() const { return *mesh_; }
    [[nodiscard]] OpenMesh::PolyConnectivity& mesh() const { return *mesh_; }
    [[nodiscard]] const point& at(OpenMesh::VertexHandle v) const { return points_[v.idx()]; }
    [[nodiscard]] bool leaves_out(OpenMesh::VertexHandle v) const
    {
        return (leaves_out_isolated_ and mesh_->is_isolated(v)) or
               (mesh_->has_vertex_status() and mesh_->status(v).deleted());
    }
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
    bool leaves_out_isolated_;
};

} // namespace openmesh

template <class Scalar>
struct mesh_traits<openmesh::kernel_view<Scalar>> : detail::openmesh_connectivity {
    using mesh_type = openmesh::kernel_view<Scalar>;
    using point = typename mesh_type::point;

    static auto vertices(const mesh_type& m)
    {
        const auto is_left_out = [&m](vertex v) { return m.leaves_out(v); };
        return numbered_handles<vertex, int, decltype(is_left_out)>(int(m.mesh().n_vertices()), is_left_out);
    }
    static const point& point_of(const mesh_type& m, vertex v) { return m.at(v); }
};

#ifdef KITH_COMPILED_OPENMESH_MESHES // where kith::compiled_openmesh is linked
template <>
inline constexpr bool is_compiled_mesh<openmesh::kernel_view<float>> = true;
template <>
inline constexpr bool is_compiled_mesh<openmesh::kernel_view<double>> = true;
#endif

} // namespace kith
