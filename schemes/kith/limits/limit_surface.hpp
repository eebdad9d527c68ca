// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_search.hpp"
#include "regular_limits.hpp"

#include <kith/core/base/platform.hpp>
#include <kith/core/level/for_each.hpp>
#include <kith/hierarchy.hpp>
#ifdef KITH_COMPILED_SCHEMES
#include <kith/compiled_schemes.hpp>
#endif

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The unit normal at a corner of a face, by the number of the corner.
struct corner_normal {
    std::size_t corner;
    normal_vector normal;

    friend bool operator==(const corner_normal&, const corner_normal&) = default;
};

/// The vertices of a level at their limit positions, with the unit normals there, outward for counter-clockwise faces.
/// At infinitely sharp edges the faces of each side have their own normal at a vertex, in `corner_normals` by
/// increasing corner. The normal of such a vertex is their mean, each weighed by one minus the cosine of the angle of
/// its side.
template <class Point>
struct limit_surface {
    storage<Point> positions;
    storage<normal_vector> normals;              ///< per vertex
    std::vector<corner_normal> corner_normals{}; ///< of corners at such vertices; others have their vertex's normal
};

/// Returns the normals of all corners of the faces of a mesh, given the limits of its vertices. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
storage<normal_vector> normals_of_corners(const basic_mesh<Point, Index>& mesh, const limit_surface<Point>& limits)
{
    storage<normal_vector> result(mesh.corner_count());
    for (std::size_t c = 0; c < result.size(); ++c)
        result[c] = limits.normals[mesh.topology().corner_vertex[c]];
    for (const auto& [corner, normal] : limits.corner_normals)
        result[corner] = normal;
    return result;
}

/// Returns how many rings around some faces limit_surface_around reads for the limits of their vertices.
template <searchable_scheme Scheme>
int rings_for_limits(const Scheme& scheme)
{
    int most = 0;
    const detail::limit_rings rings(scheme, detail::few_steps);
    for (int step = 0; step <= detail::few_steps; ++step)
        most = std::max(most, rings.at(step));
    return most + 2; // the neighbours of their vertices, and the faces at these
}

namespace detail {

/// Returns a flag for each vertex, set if its limit position is needed. These are the vertices of all faces with a
/// marked vertex, since the normals need them.
template <class Point, std::unsigned_integral Index>
std::vector<unsigned char> needed_vertices(const basic_mesh<Point, Index>& mesh, std::span<const unsigned char> marks)
{
    std::vector<unsigned char> result(mesh.vertex_count(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (std::ranges::any_of(mesh.face(f), [&](Index v) { return marks[v] != 0; }))
            for (const Index v : mesh.face(f))
                result[v] = 1;
    return result;
}

/// Gives the marked vertices the mean normals of their faces at these positions and removes their marks. Vertices whose
/// faces shrink to a point, or have no area, keep their marks.
template <class Point, std::unsigned_integral Index>
void fill_normals(const basic_mesh<Point, Index>& mesh, std::span<const Point> positions,
                  std::vector<unsigned char>& marks, storage<normal_vector>& normals)
{
    if (std::ranges::all_of(marks, std::logical_not<>()))
        return;
    const auto means = mean_face_normals(mesh, positions, std::span<const unsigned char>(marks));
    for (std::size_t v = 0; v < marks.size(); ++v)
        if (marks[v] != 0 and means[v] != normal_vector{}) {
            normals[v] = means[v];
            marks[v] = 0;
        }
}

/// The limits of the vertices of a mesh while they are searched for.
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
class wanted_limits {
public:
    using search_type = limit_search<Point, Index, Scheme>;

    /// Takes the positions until limits are found. These are searched for at marked vertices, or all without marks.
    wanted_limits(storage<Point> positions, std::span<const unsigned char> marks)
        : surface_{std::move(positions), {}}, has_no_normal_(surface_.positions.size(), marks.empty() ? 1 : 0)
    {
        surface_.normals = storage<normal_vector>(has_no_normal_.size());
        if (not marks.empty()) // vertices without a mark have no normals
            std::ranges::fill(surface_.normals, normal_vector{});
        std::ranges::copy(marks, has_no_normal_.begin());
    }
    /// Finds the limits of regular vertices, removes their marks. Precondition: all limits are searched for.
    void find_regular([[maybe_unused]] const basic_mesh<Point, Index>& mesh, [[maybe_unused]] const Scheme& scheme,
                      [[maybe_unused]] std::vector<unsigned char>& is_open)
    {
#ifdef KITH_HAS_LANES
        if constexpr (std::same_as<Point, std::array<double, 3>>)
            make_regular_limits(
                mesh,
                scheme,
                search_type::patience() > 0,
                {surface_.positions.data(), surface_.normals.data(), has_no_normal_.data(), is_open.data()});
#endif
    }

    void keep(std::size_t v, const typename search_type::found& limit)
    {
        if (limit.position)
            surface_.positions[v] = *limit.position;
        if (has_no_normal_[v] != 0 and limit.sides.size() > 1) {
            const std::lock_guard lock(sides_are_added_);
            sides_.emplace_back(v, limit.sides);
        }
        if (limit.normal and has_no_normal_[v] != 0) {
            surface_.normals[v] = *limit.normal;
            has_no_normal_[v] = 0;
        }
    }
    /// Returns true if the position of the vertex is finite.
    [[nodiscard]] bool is_placed(std::size_t v) const
    {
        return is_finite(scaled(affine<Point>::load(surface_.positions[v]), 0));
    }
    /// Returns true if a normal may be known after further steps. The second overload also asks the rules of the level.
    [[nodiscard]] bool awaits_normal(std::size_t v) const
    {
        return search_type::patience() > 0 and has_no_normal_[v] != 0;
    }
    template <vertex_element Vertex, class Rules>
    [[nodiscard]] bool awaits_normal(const Vertex& v, const Rules& rules) const
    {
        return awaits_normal(v.index()) and not limit_rules<Scheme>::never_has_tangents(rules, v);
    }
    /// Returns true if each vertex whose normal is searched for has one.
    [[nodiscard]] bool has_normals() const { return std::ranges::all_of(has_no_normal_, std::logical_not<>()); }

    /// Finds the limits of open vertices, which increase, and returns the surface. Errors: as limit_surface_of.
    limit_surface<Point> complete(const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                                  std::span<const Index> open, bool is_part) &&
    {
        if (not open.empty())
            search_type(mesh, scheme).complete(open, is_part, [&](std::size_t v, const auto& limit) {
                keep(v, limit);
            });
        for (std::size_t v = 0; v < has_no_normal_.size(); ++v)
            if (has_no_normal_[v] != 0)
                surface_.normals[v] = {};
        const auto places = std::as_const(surface_.positions).data();
        fill_normals(mesh, std::span<const Point>(places, mesh.vertex_count()), has_no_normal_, surface_.normals);
        fill_normals(mesh, std::span<const Point>(mesh.points()), has_no_normal_, surface_.normals);
        if constexpr (has_limit_sides<Scheme,
                                      vertex<level_of<basic_mesh<Point, Index>>>,
                                      level_of<basic_mesh<Point, Index>>>)
            list_corners(mesh, scheme);
        return std::move(surface_);
    }
    /// Returns the surface. Precondition: has_normals().
    limit_surface<Point> take() && { return std::move(surface_); }

private:
    /// Lists the normals of the corners on the sides that were found.
    void list_corners(const basic_mesh<Point, Index>& mesh, const Scheme& scheme)
    {
        if (sides_.empty())
            return;
        std::ranges::sort(sides_, {}, [](const auto& of_vertex) { return of_vertex.first; });
        const level_of<basic_mesh<Point, Index>> level(mesh);
        const auto& rules = limit_rules<Scheme>::on(scheme, level);
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const auto& [v, sides] = sides_[i];
            if (i != 0 and sides_[i - 1].first == v) // it was added twice
                continue;
            auto side = sides.begin();
            limit_rules<Scheme>::sectors(rules, level.vertices()[v], [&](const auto& part) {
                const auto& normal = (side++)->normal;
                std::size_t faces = 0;
                for (const auto& c : part.first.fan_from_here()) {
                    if (not normal or faces++ == part.faces)
                        break;
                    surface_.corner_normals.push_back({c.index(), *normal});
                }
            });
        }
        std::ranges::sort(surface_.corner_normals, {}, &corner_normal::corner);
    }

    limit_surface<Point> surface_;
    std::vector<unsigned char> has_no_normal_;
    std::vector<std::pair<std::size_t, std::vector<limit_side>>> sides_; // of vertices, in any order
    mutex sides_are_added_;
};

} // namespace detail

/// Returns the limits of the marked vertices (all without marks), as limit_surface_of. Other vertices stay, except for
/// those in a face with a marked one. Precondition: a mark per vertex, or none.
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
limit_surface<Point> limit_surface_around(const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                                          std::span<const unsigned char> marks)
{
    using wanted = detail::wanted_limits<Point, Index, Scheme>;
    require_edges(mesh);
    wanted limits(marks.empty() ? storage<Point>(mesh.vertex_count()) : storage<Point>(mesh.points()), marks);
    auto is_open = marks.empty() ? std::vector<unsigned char>(mesh.vertex_count(), 1)
                                 : detail::needed_vertices(mesh, marks); // some limit is not known yet
    with_native_level<Scheme>(mesh, [&](const auto& level) {
        const auto& rules = limit_rules<Scheme>::on(scheme, level);
        if (marks.empty())
            limits.find_regular(mesh, scheme, is_open);
        if (std::ranges::none_of(is_open, std::identity()))
            return;
        for_each(level.vertices(), [&](const auto& v) {
            if (is_open[v.index()] == 0)
                return;
            typename wanted::search_type::found limit;
            wanted::search_type::take(v, rules, limit, 0);
            limits.keep(v.index(), limit);
            is_open[v.index()] = not limit.position or limits.awaits_normal(v, rules);
        });
    });
    std::vector<Index> open;
    for (std::size_t v = 0; v < is_open.size(); ++v)
        if (is_open[v] != 0)
            open.push_back(Index(v));
    return std::move(limits).complete(mesh, scheme, open, not marks.empty());
}

/// Returns the limits of all vertices of a mesh under infinite refinement. They are given by closed-form masks or, if
/// there is none, by refining the neighbourhood until it has a mask or is a point; docs/schemes.md, Limit. A normal is
/// that of the limit surface if it is known at once or a few steps on; it is then the same on all levels. At infinitely
/// sharp edges each side has a normal, in corner_normals. Otherwise the normal is the mean of the faces' normals,
/// weighed by area: at their limit positions or, if these have none, at their places. If there is none it is zero.
/// `scheme` is that of this level and has its creases. For points of three coordinates. Errors: mesh_error for a mesh
/// without edges, faces that the scheme does not take, and creases of another level; also if the neighbourhood of a
/// vertex does not shrink to one point, or the scheme leaves nothing of it. Cost: O(corners), and for each vertex
/// without a mask usually a few refinements of its neighbourhood.
template <class Point, std::unsigned_integral Index, searchable_scheme Scheme>
limit_surface<Point> limit_surface_of(const basic_mesh<Point, Index>& mesh, const Scheme& scheme)
{
    return limit_surface_around(mesh, scheme, {});
}

/// Returns the same for a level of a hierarchy on any kind of mesh. Errors: mesh_error for a missing level; as above.
template <mesh M, searchable_scheme Scheme>
auto limit_surface_of(const hierarchy<M, Scheme>& levels, int level)
{
    return limit_surface_of(native_of(levels[level], levels.elements(level), generation_of(levels[0]) + level),
                            levels.scheme(level));
}

/// Declares or defines, by `How`, the limits of points of doubles of a scheme, which kith::compiled_schemes has.
#define KITH_LIMITS(How, Scheme)                                                                                       \
    How limit_surface<std::array<double, 3>> limit_surface_around(                                                     \
        const basic_mesh<>&, const Scheme&, std::span<const unsigned char>);

/// Declares or defines, by `How`, the parts that the limits of all schemes share.
#define KITH_LIMIT_PARTS(How)                                                                                          \
    How std::vector<normal_vector> mean_face_normals(                                                                  \
        const basic_mesh<>&, std::span<const std::array<double, 3>>, std::span<const unsigned char>);                  \
    KITH_REGULAR_LIMITS(How)
#ifdef KITH_HAS_LANES
#define KITH_REGULAR_LIMITS(How)                                                                                       \
    How std::vector<unsigned char> detail::irregular_vertices(                                                         \
        const connectivity<std::uint32_t>&, state_marks<std::uint32_t>, std::size_t, std::size_t, int);                \
    How void detail::fill_regular_limits(                                                                              \
        const basic_mesh<>&, const regular_masks&, const std::vector<unsigned char>&, const limit_places&);
#else
#define KITH_REGULAR_LIMITS(How)
#endif

#ifdef KITH_COMPILED_SCHEMES
KITH_LIMIT_PARTS(extern template)
#define KITH_LIMITS_IN_LIBRARY(type, header, numbers, paper) KITH_LIMITS(extern template, type)
KITH_SCHEMES(KITH_LIMITS_IN_LIBRARY)
#undef KITH_LIMITS_IN_LIBRARY
#endif

} // namespace kith
