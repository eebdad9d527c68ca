// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <kith/basic_mesh.hpp>
#include <kith/for_parts.hpp>

#include <cstddef>
#include <cstdint>
#include <ranges>
#include <type_traits>
#include <vector>

namespace kith {

/// Points of every CGAL kernel. Over exact kernels each new point is evaluated at once, since a lazy expression tree
/// would grow with every level.
template <class Kernel>
struct affine<CGAL::Point_3<Kernel>> : coordinates_affine<typename Kernel::FT, 3> {
    using point = CGAL::Point_3<Kernel>;
    using typename coordinates_affine<typename Kernel::FT, 3>::sum;

    static sum load(const point& p) { return {p.x(), p.y(), p.z()}; }
    static point store(const sum& total)
    {
        point result(total[0], total[1], total[2]);
        if constexpr (requires { exact(result); })
            exact(result);
        return result;
    }
};

template <class Point>
struct mesh_traits<CGAL::Surface_mesh<Point>> {
    using mesh_type = CGAL::Surface_mesh<Point>;
    using vertex = typename mesh_type::Vertex_index;
    using edge = typename mesh_type::Edge_index;
    using face = typename mesh_type::Face_index;
    using halfedge = typename mesh_type::Halfedge_index;
    using point = Point;

    static auto vertices(const mesh_type& m) { return alive<vertex>(m, m.num_vertices()); }
    static auto edges(const mesh_type& m) { return alive<edge>(m, m.num_edges()); }
    static auto faces(const mesh_type& m) { return alive<face>(m, m.num_faces()); }
    template <class Handle>
    static std::size_t index(const mesh_type&, Handle x)
    {
        return std::size_t(x.idx());
    }
    // These count removed elements, too: they are bounds.
    static std::size_t vertex_bound(const mesh_type& m) { return m.num_vertices(); }
    static std::size_t edge_bound(const mesh_type& m) { return m.num_edges(); }
    static std::size_t face_bound(const mesh_type& m) { return m.num_faces(); }
    static std::size_t halfedge_bound(const mesh_type& m) { return m.num_halfedges(); }

    static halfedge next(const mesh_type& m, halfedge h) { return m.next(h); }
    static halfedge prev(const mesh_type& m, halfedge h) { return m.prev(h); }
    static halfedge opposite(const mesh_type& m, halfedge h) { return m.opposite(h); }
    static bool is_boundary(const mesh_type& m, halfedge h) { return m.is_border(h); }
    static vertex source(const mesh_type& m, halfedge h) { return m.source(h); }
    static edge edge_of(const mesh_type& m, halfedge h) { return m.edge(h); }
    static face face_of(const mesh_type& m, halfedge h) { return m.face(h); }
    static halfedge halfedge_of(const mesh_type& m, vertex v) { return m.opposite(m.halfedge(v)); } // CGAL's comes in
    // An edge of CGAL remembers the half-edge it was asked by; every edge has to start with the same one here.
    static halfedge halfedge_of(const mesh_type&, edge e) { return halfedge(2 * e.idx()); }
    static halfedge halfedge_of(const mesh_type& m, face f) { return m.halfedge(f); }
    static bool is_isolated(const mesh_type& m, vertex v) { return m.is_isolated(v); }
    static const Point& point_of(const mesh_type& m, vertex v) { return m.point(v); }

    /// In bulk, through the half-edge primitives: half-edge 2e+s of the one mesh is half-edge 2e+s of the other.
    static mesh_type build(basic_mesh<Point, std::uint32_t>&& fine)
    {
        using size = typename mesh_type::size_type;
        const auto& t = fine.topology();
        mesh_type m;
        m.resize(size(t.vertices), size(t.edges()), size(t.faces));
        detail::for_parts(t.vertices, std::is_trivially_copyable_v<Point>, [&](std::size_t begin, std::size_t last) {
            for (std::size_t v = begin; v < last; ++v) {
                m.point(vertex(size(v))) = fine.point(v);
                m.set_halfedge(vertex(size(v)), halfedge(t.corner_halfedge[t.vertex_corner[v]] ^ 1));
            }
        });
        detail::for_parts(t.faces, true, [&](std::size_t begin, std::size_t last) {
            for (std::size_t f = begin; f < last; ++f) {
                const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
                m.set_halfedge(face(size(f)), halfedge(t.corner_halfedge[first]));
                for (std::size_t c = first; c < end; ++c) {
                    const std::size_t next = c + 1 == end ? first : c + 1;
                    const halfedge h(t.corner_halfedge[c]);
                    m.set_face(h, face(size(f)));
                    m.set_target(h, vertex(t.corner_vertex[next]));
                    m.set_next(h, halfedge(t.corner_halfedge[next]));
                }
            }
        });
        close_boundary(m, t);
        // Only a boundary between two steps of sqrt(3) or 4-8 needs this to be remembered.
        if (fine.generation() % 2 != 0 and not m.is_empty() and t.corners() != 2 * t.edges())
            m.template add_property_map<face, std::uint8_t>(odd_generation, 1);
        return m;
    }
    static int generation(const mesh_type& m)
    {
        const auto odd = m.template property_map<face, std::uint8_t>(odd_generation);
        if constexpr (requires { odd.has_value(); }) // from CGAL 6 on
            return odd.has_value() ? 1 : 0;
        else
            return odd.second ? 1 : 0;
    }

private:
    static constexpr const char* odd_generation = "f:kith:odd_generation";

    template <class Handle>
    static auto alive(const mesh_type& m, std::size_t bound)
    {
        using size = typename mesh_type::size_type;
        return std::views::iota(size(0), size(bound)) | std::views::transform([](size i) { return Handle(i); }) |
               std::views::filter([&m](Handle x) { return not m.is_removed(x); });
    }
    /// Half-edges without a face run along the boundary the other way; each boundary vertex has one that leaves it.
    static void close_boundary(mesh_type& m, const connectivity<std::uint32_t>& t)
    {
        std::vector<halfedge> boundary;
        for (std::size_t h = 1; h < 2 * t.edges(); h += 2)
            if (t.halfedge_corner[h] == t.none)
                boundary.push_back(halfedge(typename mesh_type::size_type(h)));
        if (boundary.empty())
            return;
        std::vector<halfedge> leaving(t.vertices);
        for (const halfedge h : boundary) {
            m.set_face(h, mesh_type::null_face());
            m.set_target(h, vertex(t.corner_vertex[t.halfedge_corner[h ^ 1]]));
            leaving[m.target(m.opposite(h))] = h;
        }
        for (const halfedge h : boundary)
            m.set_next(h, leaving[m.target(h)]);
    }
};

} // namespace kith
