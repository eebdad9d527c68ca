// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit.hpp"
#include "limit_rings.hpp"
#include "limit_sides.hpp"

#include <kith/core/mesh/close_boundary_loops.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// A search for the limits of vertices without a closed-form mask. It refines only the neighbourhoods of these
/// vertices, until the descendant of each vertex has a mask or its neighbourhood is one point. The result depends on
/// the neighbourhood of the vertex alone.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class limit_search {
public:
    struct found {
        std::optional<Point> position;
        std::optional<normal_vector> normal;
        std::vector<limit_side> sides{}; ///< of a vertex whose normal follows from those of its sides
    };
    using mesh_type = basic_mesh<Point, Index>;
    using level_type = level_of<mesh_type>;

    /// Returns the number of steps for which a tangent is still looked for after the position is known. Beside
    /// irregular vertices tangents become known a step or two later.
    static constexpr int patience()
    {
        return has_limit_tangents<Scheme, vertex<level_type>, level_type> ? limit_rules<Scheme>::tangent_steps : 0;
    }

    /// Takes a mesh, which must outlive the search.
    limit_search(const mesh_type& mesh, const Scheme& scheme) : mesh_(mesh), scheme_(scheme), cutter_(mesh) {}

    /// Calls keep(vertex, limit) for each of some vertices, given by increasing number, with all limits that can be
    /// found. If the mesh is a part, the search reads no more rings than rings_for_limits returns. Errors: mesh_error
    /// if the neighbourhood of a vertex does not become a point.
    template <class Keep>
    void complete(std::span<const Index> all_vertices, bool is_part, const Keep& keep)
    {
        constexpr std::size_t at_once = 1 << 12; // so that the virtual meshes stay small
        const level_type level(mesh_);
        const auto& rules = limit_rules<Scheme>::on(scheme_, level);
        for (std::size_t first = 0; first < all_vertices.size(); first += at_once) {
            const auto vertices = all_vertices.subspan(first, std::min(at_once, all_vertices.size() - first));
            std::vector<found> limits(vertices.size());
            std::vector<seeker> left;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                take(level.vertices()[vertices[i]], rules, limits[i], 0);
                left.push_back({vertices[i], i, smallest_distance(vertices[i]), false, limits[i].position ? 0 : none});
            }
            const limit_rings rings(scheme_, few_steps);
            const int steps = rings.is_bounded() ? many_steps : few_steps;
            left = search(std::move(left), rings, steps, limits);
            if (not left.empty() and not rings.is_bounded() and not is_part)
                left = search(back_to_start(left, vertices), {scheme_, 10 * few_steps}, 10 * few_steps, limits);
            if (not left.empty())
                throw mesh_error(std::string(scheme_name<Scheme>()) + ": the faces around vertex " +
                                 std::to_string(vertices[left[0].place]) +
                                 " do not converge to one point, so it has no limit");
            for (std::size_t i = 0; i < vertices.size(); ++i)
                keep(vertices[i], limits[i]);
        }
    }

    /// Takes position, normal and sides of an element from the closed-form masks of the scheme, unless `limit` has them
    /// already.
    template <level Level, template <class> class Element>
        requires element<Element<Level>>
    static void take(const Element<Level>& x, const limit_rules_argument<Scheme, Level>& rules, found& limit, int step)
    {
        if constexpr (has_limit_positions<Scheme, Element<Level>, Level>)
            if (not limit.position)
                limit_rules<Scheme>::position(rules, x, [&](const auto& mask) {
                    limit.position = number::store(mask.evaluate(point_values<Level>()));
                });
        if constexpr (has_limit_tangents<Scheme, Element<Level>, Level>)
            if (not limit.normal and step <= last_normal)
                limit_rules<Scheme>::tangents(rules, x, [&](const auto& first, const auto& second) {
                    limit.normal = normal_of<Level>(first, second);
                });
        if constexpr (has_limit_sides<Scheme, Element<Level>, Level>)
            if (not limit.normal and limit.sides.empty() and step <= last_normal) {
                limit_rules<Scheme>::sides(rules, x, [&](const auto& part, bool is_half_turn, const auto&... masks) {
                    limit.sides.push_back(side_of(part, is_half_turn, masks...));
                });
                limit.normal = mean_normal(limit.sides);
            }
    }

private:
    using number = affine<Point>;
    static constexpr int none = std::numeric_limits<int>::max();

    struct seeker {
        Index element;     ///< the descendant of the vertex: a vertex or a face
        std::size_t place; ///< index among the searched vertices
        double same;       ///< points that are this near to each other count as one
        bool is_face = false;
        int known_at = none; ///< the step at which the position became known
    };

    /// The last step in which normals are computed. Later, differences of points have lost too many digits.
    static constexpr int last_normal = 24;

    static double largest(const Point& p)
    {
        const auto& x = number::load(p);
        return std::max({std::abs(double(x[0])), std::abs(double(x[1])), std::abs(double(x[2]))});
    }
    static double difference(const Point& p, const Point& q)
    {
        const auto &x = number::load(p), &y = number::load(q);
        double result = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = std::abs(double(x[i]) / 2 - double(y[i]) / 2);
            if (not(d <= result))
                result = d;
        }
        return result;
    }
    [[nodiscard]] double smallest_distance(Index v) const
    {
        double size = 0;
        const level_type level(mesh_);
        for (const auto f : level.vertices()[v].faces())
            for (const auto u : f.vertices())
                size = std::max(size, largest(u.point()));
        // Two units in the last place of such a number: coordinates need not come nearer than that.
        const auto last_place = double(std::numeric_limits<typename affine<Point>::scalar>::epsilon());
        return std::max(size * std::max(2 * last_place, std::scalbn(1., -51)),
                        8 * std::numeric_limits<double>::denorm_min());
    }
    std::vector<seeker> back_to_start(std::vector<seeker> left, std::span<const Index> vertices) const
    {
        for (auto& s : left)
            s.element = vertices[s.place], s.is_face = false;
        return left;
    }

    /// Returns the seekers whose positions are still unknown.
    std::vector<seeker> search(std::vector<seeker> left, const limit_rings& rings, int steps, std::span<found> limits)
    {
        Scheme scheme = scheme_;
        mesh_type fine;
        for (int step = 0; step < steps and not left.empty(); ++step) {
            auto part = step == 0 ? cut(mesh_, cutter_, left, rings.at(step)) : cut_anew(fine, left, rings.at(step));
            to_part(left, part);
            restrict_state(scheme, scheme, part.numbers());
            if constexpr (needs_closed<Scheme>)
                part.mesh = close_boundary_loops(part.mesh);
            numbering_of<Scheme, Index> ids;
            fine = refine_mesh<connect::everything>(part.mesh, scheme, ids);
            advance(scheme, level_type(part.mesh), part.mesh.generation(), ids, fine);
            std::erase_if(left, [&](seeker& s) {
                const bool is_lost = not to_child(s, ids);
                if (is_lost and s.known_at == none)
                    throw mesh_error(
                        std::string(scheme_name<Scheme>()) + ": after " + std::to_string(step) +
                        " steps the scheme makes neither a vertex nor a face of a vertex, so it has no limit");
                return is_lost;
            });
            look(fine, scheme, left, step + 1, limits);
            std::erase_if(left, [&](const seeker& s) {
                const bool is_known = s.known_at != none;
                return is_known and (limits[s.place].normal or step + 1 >= s.known_at + patience());
            });
        }
        std::erase_if(left, [](const seeker& s) { return s.known_at != none; });
        return left;
    }

    static submesh<Point, Index> cut(const mesh_type& mesh, submesh_cutter<Point, Index>& cutter,
                                     const std::vector<seeker>& seekers, int rings)
    {
        const level_type level(mesh);
        std::vector<Index> seeds;
        for (const auto& s : seekers)
            if (s.is_face)
                seeds.push_back(s.element);
            else
                for (const auto f : level.vertices()[s.element].faces())
                    seeds.push_back(Index(f.index()));
        std::ranges::sort(seeds);
        seeds.erase(std::ranges::unique(seeds).begin(), seeds.end());
        return cutter.cut(cutter.faces_around(seeds, rings));
    }
    static submesh<Point, Index> cut_anew(const mesh_type& mesh, const std::vector<seeker>& seekers, int rings)
    {
        submesh_cutter<Point, Index> cutter(mesh);
        return cut(mesh, cutter, seekers, rings);
    }
    static void to_part(std::vector<seeker>& seekers, const submesh<Point, Index>& part)
    {
        for (auto& s : seekers) {
            const auto& from = s.is_face ? part.face_from : part.vertex_from;
            s.element = Index(std::ranges::lower_bound(from, s.element) - from.begin());
        }
    }
    template <level_numbering Ids>
    static bool to_child(seeker& s, const Ids& ids)
    {
        const auto child = [&]<tuple_kind Kind>(const auto& column_ids) -> std::optional<Index> {
            using column = std::remove_cvref_t<decltype(column_ids)>;
            if constexpr (column::template has<Kind>)
                if (const auto id = column_ids.template id<Kind>(s.element); id != column::none)
                    return Index(id);
            return std::nullopt;
        };
        if (s.is_face) {
            if (const auto face = child.template operator()<tuple_kind::f>(ids.faces)) {
                s.element = *face;
                return true;
            }
        } else if (const auto v = child.template operator()<tuple_kind::v>(ids.vertices)) {
            s.element = *v;
            return true;
        } else if (const auto face = child.template operator()<tuple_kind::v>(ids.faces)) {
            s.element = *face;
            s.is_face = true;
            return true;
        }
        return false;
    }

    /// Takes the limits that masks give on this level, and positions of neighbourhoods that have become one point.
    void look(const mesh_type& fine, const Scheme& scheme, std::vector<seeker>& seekers, int step,
              std::span<found> limits) const
    {
        const level_type level(fine);
        const auto& rules = limit_rules<Scheme>::on(scheme, level);
        for (auto& s : seekers) {
            auto& limit = limits[s.place];
            if (s.is_face)
                take(level.faces()[s.element], rules, limit, step);
            else
                take(level.vertices()[s.element], rules, limit, step);
            if (not limit.position and is_one_point(level, s))
                limit.position = s.is_face ? center(level.faces()[s.element]) : level.vertices()[s.element].point();
            if (limit.position and s.known_at == none)
                s.known_at = step;
        }
    }
    template <element Element>
    static Point center(const Element& f)
    {
        return number::store(average(f.vertices()).evaluate(point_values<level_type>()));
    }
    static bool is_one_point(const level_type& level, const seeker& s)
    {
        const auto is_near = [&](const auto& p, const auto& q) {
            return difference(p, q) <= s.same;
        }; // false for points with NaN coordinates
        const auto face_is = [&](const auto& f, const Point& p) {
            for (const auto u : f.vertices())
                if (not is_near(u.point(), p))
                    return false;
            return true;
        };
        if (s.is_face)
            return face_is(level.faces()[s.element], level.faces()[s.element].first_corner().v().point());
        for (const auto f : level.vertices()[s.element].faces())
            if (not face_is(f, level.vertices()[s.element].point()))
                return false;
        return true;
    }

    const mesh_type& mesh_;
    Scheme scheme_;
    submesh_cutter<Point, Index> cutter_;
};

} // namespace detail

} // namespace kith
