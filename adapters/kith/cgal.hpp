// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <kith/core/base/large_blocks.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/foreign_level.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace kith {

/// A guard that keeps the numbers of exact kernels lazy, as CGAL does, in the thread that makes it and for its
/// lifetime. New points then cost no exact arithmetic until their exact values are requested, but the expressions of
/// all levels stay in memory. Values are equal either way; converted to doubles they may differ in the last digits.
class lazy_numbers {
public:
    lazy_numbers() { ++count(); }
    lazy_numbers(const lazy_numbers&) = delete;
    lazy_numbers& operator=(const lazy_numbers&) = delete;
    ~lazy_numbers() { --count(); }

    [[nodiscard]] static bool are_kept() { return count() != 0; }

private:
    static int& count()
    {
        thread_local int result = 0;
        return result;
    }
};

/// The arithmetic of the points of every CGAL kernel. Over exact kernels each new point is evaluated at once, unless
/// `lazy_numbers` are kept, because a lazy expression tree grows with every level.
template <class Kernel>
struct affine<CGAL::Point_3<Kernel>> : coordinates_affine<typename Kernel::FT, 3> {
    using point = CGAL::Point_3<Kernel>;
    using typename coordinates_affine<typename Kernel::FT, 3>::sum;
    static constexpr bool is_array = std::floating_point<typename Kernel::FT>; // except for kernels of handles

    static sum load(const point& p) { return {p.x(), p.y(), p.z()}; }
    static point store(const sum& total)
    {
        point result(total[0], total[1], total[2]);
        if constexpr (requires { exact(result); })
            if (not lazy_numbers::are_kept())
                exact(result);
        return result;
    }
};

namespace detail {

template <class Point>
CGAL::Surface_mesh<Point> surface_mesh_below(const CGAL::Surface_mesh<Point>*);

} // namespace detail

/// A CGAL::Surface_mesh, or a class derived from one.
template <class M>
concept surface_mesh_or_derived = requires(const M* mesh) { detail::surface_mesh_below(mesh); };
/// The Surface_mesh that M is or has as its base class.
template <surface_mesh_or_derived M>
using surface_mesh_of = decltype(detail::surface_mesh_below(std::declval<const M*>()));

/// The mesh traits of CGAL::Surface_mesh and of classes derived from it. The default constructor makes a refined mesh
/// of a derived class. A refined mesh has points and no other property maps; cgal_properties.hpp carries the property
/// maps of the source.
template <surface_mesh_or_derived M>
struct mesh_traits<M> {
    using mesh_type = surface_mesh_of<M>;
    using Point = typename mesh_type::Point; // NOLINT(readability-identifier-naming): as CGAL calls it
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
    /// Returns true if a half-edge has no face, or if its face was removed: CGAL then leaves the half-edge as it is.
    static bool is_boundary(const mesh_type& m, halfedge h)
    {
        return m.is_border(h) or (m.number_of_removed_faces() != 0 and std::size_t(m.face(h)) < m.num_faces() and
                                  m.is_removed(m.face(h)));
    }
    static vertex source(const mesh_type& m, halfedge h) { return m.source(h); }
    static edge edge_of(const mesh_type& m, halfedge h) { return m.edge(h); }
    static face face_of(const mesh_type& m, halfedge h) { return m.face(h); }
    static halfedge halfedge_of(const mesh_type& m, vertex v) { return m.opposite(m.halfedge(v)); } // CGAL's comes in
    // An edge of CGAL remembers the half-edge by which it was requested; here every edge must begin with the same one.
    static halfedge halfedge_of(const mesh_type&, edge e) { return halfedge(2 * e.idx()); }
    static halfedge halfedge_of(const mesh_type& m, face f) { return m.halfedge(f); }
    static bool is_isolated(const mesh_type& m, vertex v) { return m.is_isolated(v); }
    static const Point& point_of(const mesh_type& m, vertex v) { return m.point(v); }

    static M build(basic_mesh<Point, std::uint32_t>&& fine) { return fill<M>(fine); }

    static void make_room(mesh_type& m, std::size_t vertices, std::size_t edges, std::size_t faces)
    {
        // malloc keeps freed arrays up to 32 MiB, and CGAL fills reserved ones more slowly than new ones.
        constexpr std::size_t of_edge = 8 * sizeof(size), most_kept = std::size_t(32) << 20;
        if (edges * of_edge > most_kept)
            reserve_in_large_pages([&] { m.reserve(size(vertices), size(edges), size(faces)); });
        m.resize(size(vertices), size(edges), size(faces));
    }
    static Point* points(mesh_type& m) { return m.is_empty() ? nullptr : &m.point(vertex(0)); }
    template <class Handle>
    static Handle at(std::size_t i)
    {
        return Handle(size(i));
    }
    static vertex target(const mesh_type& m, halfedge h) { return m.target(h); }
    static void set_side(mesh_type& m, halfedge h, face f, vertex target, halfedge next)
    {
        m.set_face(h, f);
        m.set_target(h, target);
        m.set_next(h, next);
    }
    static void set_boundary_side(mesh_type& m, halfedge h, vertex target, halfedge next)
    {
        m.set_face(h, mesh_type::null_face()); // the half-edge may have had one in a mesh that is overwritten
        m.set_target(h, target);
        m.set_next(h, next);
    }
    static void set_start(mesh_type& m, face f, halfedge h, std::size_t) { m.set_halfedge(f, h); }
    static void set_start(mesh_type& m, vertex v, halfedge leaving) { m.set_halfedge(v, m.opposite(leaving)); }
    static constexpr const char* odd_generation = "f:kith:odd_generation"; ///< the name of a map
    static void mark_odd_generation(mesh_type& m) { m.template add_property_map<face, bool>(odd_generation, true); }
    static void forget_generation(mesh_type& m)
    {
        if (generation(m) != 0) {
            auto odd = m.template add_property_map<face, bool>(odd_generation).first;
            m.remove_property_map(odd);
        }
    }
    static int generation(const mesh_type& m)
    {
        const auto odd = m.template property_map<face, bool>(odd_generation);
        if constexpr (requires { odd.has_value(); }) // from CGAL 6 on
            return odd.has_value() ? 1 : 0;
        else
            return odd.second ? 1 : 0;
    }

private:
    using size = typename mesh_type::size_type;

    template <class Handle>
    static auto alive(const mesh_type& m, std::size_t bound)
    {
        const auto is_removed = [&m](Handle x) { return m.is_removed(x); };
        return numbered_handles<Handle, size, decltype(is_removed)>(size(bound), is_removed);
    }
};

} // namespace kith

#ifdef KITH_COMPILED_CGAL_MESHES // where kith::compiled_cgal is linked

namespace CGAL {

template <class Number>
struct Simple_cartesian;
class Epick;

} // namespace CGAL

namespace kith {

template <>
inline constexpr bool is_compiled_mesh<CGAL::Surface_mesh<CGAL::Point_3<CGAL::Simple_cartesian<double>>>> = true;
template <>
inline constexpr bool is_compiled_mesh<CGAL::Surface_mesh<CGAL::Point_3<CGAL::Epick>>> = true;
/// The view of a class derived from a Surface_mesh: the Surface_mesh itself.
template <surface_mesh_or_derived M>
    requires(not std::same_as<M, surface_mesh_of<M>>)
struct compiled_view<M> {
    using type = surface_mesh_of<M>;
    static const type& of(const M& mesh) { return mesh; }
};

} // namespace kith

#endif
