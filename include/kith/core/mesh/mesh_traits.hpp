// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ranges>
#include <utility>

namespace kith {

template <class Point, std::unsigned_integral Index>
class basic_mesh;

/// The interface of a mesh type to kith. Specialise it once per mesh library: static functions over simple handles.
/// Each is O(1), and nothing is added to the mesh. `examples/own_mesh.cpp` adapts a home-made mesh in one page.
///
///   vertex, edge, face, halfedge   small regular handles, valid as long as the mesh is not changed
///   point                          the coordinates of a vertex; needs an `affine<point>`
///
///   vertices(m) edges(m) faces(m)  ranges of handles without removed elements, always in the same order
///   index(m, x)                    a number of x (all four kinds), unique among its kind ...
///   vertex_bound(m) edge_bound(m) face_bound(m) halfedge_bound(m)
///                                  ... and below this bound
///   next(m, h) prev(m, h)          around the face of h, counter-clockwise
///   opposite(m, h)                 the other half-edge of the edge of h
///   is_boundary(m, h)              h has no face; only next, prev and face_of need not work then
///   source(m, h) edge_of(m, h) face_of(m, h)
///   halfedge_of(m, v)              any half-edge that leaves v; the library finds the boundary itself
///   halfedge_of(m, e)              the half-edge that directs e
///   halfedge_of(m, f)              the half-edge at which f starts
///   is_isolated(m, v)              v has no edge
///   point_of(m, v)
///   build(basic_mesh<point, uint32_t>&&) -> M
///                                  the mesh with these elements, in this order and direction (optional: without it a
///                                  mesh can be read, not written)
///
///   build(basic_mesh<point, uint32_t>&&, const M& source) -> M
///                                  the mesh with these elements that was refined from `source`, of which it may keep
///                                  more than elements (optional)
///
///   points(m)                      the array of all points, by index (optional: without it vertices cannot be moved)
///
///   The following functions are for meshes that several threads may write. `fill` then replaces `build`, and `refine`
///   writes the last level directly into the mesh:
///
///   request_like(m, source)        gives an empty m the attributes that `source` has (optional; called first)
///   make_room(m, vertices, edges, faces)
///                                  gives an empty m these numbers of elements, not joined yet; throws mesh_error for
///                                  more than it can number
///   at<Handle>(i)                  the vertex, edge, half-edge or face whose index is i; half-edges 2i and 2i+1 are
///                                  edge i
///   set_side(m, h, f, v, next)     h lies in face f, leads to v and is followed by `next`
///   set_boundary_side(m, h, v, next)
///                                  h lies in no face, leads to v and is followed by `next`
///   set_start(m, f, h, degree)     f starts at h; throws mesh_error for faces of a degree that it cannot hold
///   set_start(m, v, h)             v starts at h, which leaves it; called before set_boundary_side
///   target(m, h)                   the vertex that was set as the one that h leads to
///   mark_odd_generation(m)         stores that `generation` is odd
///
///   generation(m)                  the number of steps since the control mesh, as given to `build` (optional; 0)
///
/// The order in which a mesh starts its vertices, edges and faces is the order of the operands of a mask, so it is
/// part of the promise "same mesh, same bits"; `build` keeps it.
template <class M>
struct mesh_traits;

/// A range that `vertices`, `edges` and `faces` may return if handles are made of numbers from 0 on. It skips all
/// handles for which is_removed(handle) is true.
template <class Handle, std::integral Number, class IsRemoved>
class numbered_handles {
public:
    class iterator {
    public:
        using value_type = Handle;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::forward_iterator_tag;

        iterator() = default;
        iterator(const numbered_handles& all, Number number) : all_(&all), number_(number) { skip_removed(); }
        Handle operator*() const { return Handle(number_); }
        iterator& operator++()
        {
            ++number_;
            skip_removed();
            return *this;
        }
        iterator operator++(int)
        {
            const iterator before = *this;
            ++*this;
            return before;
        }
        friend bool operator==(const iterator& a, const iterator& b) { return a.number_ == b.number_; }

    private:
        void skip_removed()
        {
            while (number_ != all_->end_ and all_->is_removed_(Handle(number_)))
                ++number_;
        }

        const numbered_handles* all_ = nullptr;
        Number number_{};
    };

    numbered_handles(Number end, IsRemoved is_removed) : end_(end), is_removed_(std::move(is_removed)) {}

    [[nodiscard]] iterator begin() const { return {*this, 0}; }
    [[nodiscard]] iterator end() const { return {*this, end_}; }

private:
    Number end_;
    IsRemoved is_removed_;
};

/// A range whose elements convert to T.
template <class R, class T>
concept range_of = std::ranges::input_range<R> and std::convertible_to<std::ranges::range_reference_t<R>, T>;

/// A mesh that kith can read; see mesh_traits for the meaning of each line.
template <class M, class T = mesh_traits<M>>
concept mesh = std::regular<typename T::vertex> and std::regular<typename T::edge> and
               std::regular<typename T::face> and std::regular<typename T::halfedge> and
               affine_value<typename T::point> and
               requires(const M& m, typename T::vertex v, typename T::edge e, typename T::face f,
                        typename T::halfedge h) {
                   { T::vertices(m) } -> range_of<typename T::vertex>;
                   { T::edges(m) } -> range_of<typename T::edge>;
                   { T::faces(m) } -> range_of<typename T::face>;
                   { T::index(m, v) } -> std::convertible_to<std::size_t>;
                   { T::index(m, e) } -> std::convertible_to<std::size_t>;
                   { T::index(m, f) } -> std::convertible_to<std::size_t>;
                   { T::index(m, h) } -> std::convertible_to<std::size_t>;
                   { T::vertex_bound(m) } -> std::convertible_to<std::size_t>;
                   { T::edge_bound(m) } -> std::convertible_to<std::size_t>;
                   { T::face_bound(m) } -> std::convertible_to<std::size_t>;
                   { T::halfedge_bound(m) } -> std::convertible_to<std::size_t>;
                   { T::next(m, h) } -> std::convertible_to<typename T::halfedge>;
                   { T::prev(m, h) } -> std::convertible_to<typename T::halfedge>;
                   { T::opposite(m, h) } -> std::convertible_to<typename T::halfedge>;
                   { T::is_boundary(m, h) } -> std::convertible_to<bool>;
                   { T::source(m, h) } -> std::convertible_to<typename T::vertex>;
                   { T::edge_of(m, h) } -> std::convertible_to<typename T::edge>;
                   { T::face_of(m, h) } -> std::convertible_to<typename T::face>;
                   { T::halfedge_of(m, v) } -> std::convertible_to<typename T::halfedge>;
                   { T::halfedge_of(m, e) } -> std::convertible_to<typename T::halfedge>;
                   { T::halfedge_of(m, f) } -> std::convertible_to<typename T::halfedge>;
                   { T::is_isolated(m, v) } -> std::convertible_to<bool>;
                   { T::point_of(m, v) } -> std::convertible_to<typename T::point>;
               };

/// The handle of a vertex, an edge or a face of M.
template <class H, class M>
concept handle_of = std::convertible_to<H, typename mesh_traits<M>::vertex> or
                    std::convertible_to<H, typename mesh_traits<M>::edge> or
                    std::convertible_to<H, typename mesh_traits<M>::face>;

/// A mesh whose vertices kith can move.
template <class M, class T = mesh_traits<M>>
concept movable_mesh = mesh<M, T> and requires(M& m) {
    { T::points(m) } -> std::same_as<typename T::point*>;
};

/// A mesh that kith can also make.
template <class M, class T = mesh_traits<M>>
concept refinable_mesh = mesh<M, T> and requires(basic_mesh<typename T::point, std::uint32_t>&& fine) {
    { T::build(std::move(fine)) } -> std::convertible_to<M>;
};

namespace detail {

/// Calls f(half-edge) for each side of a face in its order, from its first side on. Returns true if the walk came back
/// to the first side. In a mesh that was joined by hand, half-edges may lead anywhere. The walk then stops at a
/// half-edge that is not in the mesh, or after as many sides as there are half-edges. Cost: O(sides).
template <mesh M, class F>
bool for_each_side(const M& mesh, typename mesh_traits<M>::face face, const F& f)
{
    using traits = mesh_traits<M>;
    const std::size_t bound = traits::halfedge_bound(mesh);
    const typename traits::halfedge first = traits::halfedge_of(mesh, face);
    typename traits::halfedge h = first;
    for (std::size_t left = bound; left != 0 and std::size_t(traits::index(mesh, h)) < bound; --left) {
        f(h);
        h = traits::next(mesh, h);
        if (h == first)
            return true;
    }
    return false;
}

/// Returns true if a half-edge belongs to the mesh.
template <mesh M>
bool has_halfedge(const M& mesh, typename mesh_traits<M>::halfedge h)
{
    return std::size_t(mesh_traits<M>::index(mesh, h)) < mesh_traits<M>::halfedge_bound(mesh);
}

/// Returns true if the half-edge at which a vertex starts leaves that vertex.
template <mesh M>
bool starts_at_its_own(const M& mesh, typename mesh_traits<M>::vertex v)
{
    using traits = mesh_traits<M>;
    const auto start = traits::halfedge_of(mesh, v);
    return has_halfedge(mesh, start) and traits::index(mesh, traits::source(mesh, start)) == traits::index(mesh, v);
}

/// Returns true if a half-edge names the given face as its own and is the one before its next.
template <mesh M>
bool is_side_of(const M& mesh, typename mesh_traits<M>::halfedge h, typename mesh_traits<M>::face face)
{
    using traits = mesh_traits<M>;
    const auto next = traits::next(mesh, h);
    return not traits::is_boundary(mesh, h) and
           traits::index(mesh, traits::face_of(mesh, h)) == traits::index(mesh, face) and has_halfedge(mesh, next) and
           traits::index(mesh, traits::prev(mesh, next)) == traits::index(mesh, h);
}

} // namespace detail

/// The flag of mesh types whose reading and making code is in a library that the program links, such as
/// kith::compiled_cgal. Adapters set it.
template <class M>
inline constexpr bool is_compiled_mesh = false;

/// The compiled mesh type as which meshes of another type are read, such as the base of a class. It has `type`, and
/// of(mesh), which returns a view or a reference of that type. Adapters define it.
template <class M>
struct compiled_view {};
template <class M>
concept mesh_with_compiled_view = requires(const M& mesh) {
    { compiled_view<M>::of(mesh) } -> std::convertible_to<const typename compiled_view<M>::type&>;
    requires is_compiled_mesh<typename compiled_view<M>::type>;
};

} // namespace kith
