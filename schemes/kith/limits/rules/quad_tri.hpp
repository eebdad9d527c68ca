// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "catmull_clark.hpp"
#include "loop.hpp"

#include <kith/core/base/exact_cos.hpp>
#include <kith/core/base/platform.hpp>
#include <kith/quad_tri.hpp>
#include <kith/schemes/kernel/ring_matrix.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

namespace kith {

namespace detail {

/// The limit masks of a smooth vertex between quads and triangles: weights of the vertex, of its n neighbours, and of
/// the n vertices opposite in its faces. In triangles the latter are zero.
struct masks_between {
    std::vector<double> position;
    std::array<std::vector<double>, 2> tangents;
};

/// Returns the masks, given for each face around the vertex if it is a quad. They are left eigenvectors of the
/// subdivision matrix of the vertex. The tangents are those of the second and third largest eigenvalue, which may
/// differ; in a ring of equal angles, one points along the first edge and the other a quarter of a turn further. Cost:
/// up to 40 000 products.
inline masks_between find_masks_between(const std::vector<bool>& is_quad)
{
    const std::size_t n = is_quad.size();
    const auto edge = [n](std::size_t j) { return 1 + j % n; };
    const auto opposite = [n](std::size_t j) { return 1 + n + j % n; };
    std::vector<ring_matrix::row> matrix(1 + 2 * n);
    const auto add_face = [&](std::size_t row, std::size_t j, double weight) {
        for (const std::size_t point : {std::size_t(0), edge(j), opposite(j), edge(j + 1)})
            matrix[row].emplace_back(point, weight);
    };
    std::size_t others = 0;
    for (const bool quad : is_quad)
        others += quad;
    const double w = quad_tri::weight(n, others);
    matrix[0].emplace_back(0, 1 - w * double(n + others));
    for (std::size_t j = 0; j < n; ++j) {
        matrix[0].emplace_back(edge(j), w);
        for (const std::size_t point : {std::size_t(0), edge(j)})
            matrix[edge(j)].emplace_back(point, 1. / 4);
        if (is_quad[j]) {
            add_face(0, j, w / 4);
            add_face(opposite(j), j, 1. / 4);
        }
        for (const auto& [row, far] : {std::pair(edge(j), edge(j + 1)), std::pair(edge(j + 1), edge(j))}) {
            if (is_quad[j])
                add_face(row, j, 1. / 16);
            else
                for (const auto& [point, weight] : {std::pair(std::size_t(0), 1.), std::pair(row, 1.), {far, 2.}})
                    matrix[row].emplace_back(point, weight / 16);
        }
    }
    const ring_matrix repeated(std::move(matrix));
    masks_between result{repeated.limit(), {}};
    std::array<std::vector<double>, 2> flat; // the coordinates of a ring of equal angles
    for (std::size_t axis = 0; axis < 2; ++axis) {
        flat[axis].assign(1 + 2 * n, 0);
        for (std::size_t j = 0; j < n; ++j) {
            const auto wave = [&](std::size_t k) {
                return axis == 0 ? exact_cos(std::int64_t(k), std::int64_t(2 * n))
                                 : sin_turn(std::int64_t(k), std::int64_t(2 * n));
            };
            flat[axis][edge(j)] = wave(2 * j);
            if (is_quad[j])
                flat[axis][opposite(j)] = 1.5 * wave(2 * j + 1);
        }
    }
    result.tangents = flat;
    repeated.repeat(result.tangents, [&flat](auto& rows) {
        std::array<std::array<double, 2>, 2> on_flat{};
        for (std::size_t k = 0; k < 2; ++k) {
            double sum = 0;
            for (const double weight : rows[k])
                sum += weight;
            rows[k][0] -= sum;
            for (std::size_t axis = 0; axis < 2; ++axis)
                for (std::size_t x = 0; x < rows[k].size(); ++x)
                    on_flat[k][axis] += rows[k][x] * flat[axis][x];
        }
        const double determinant = on_flat[0][0] * on_flat[1][1] - on_flat[0][1] * on_flat[1][0];
        for (std::size_t x = 0; x < rows[0].size(); ++x) {
            const double a = rows[0][x], b = rows[1][x];
            rows[0][x] = (on_flat[1][1] * a - on_flat[0][1] * b) / determinant;
            rows[1][x] = (on_flat[0][0] * b - on_flat[1][0] * a) / determinant;
        }
    });
    return result;
}

/// Returns the same, found once for each pattern of quads. Several threads may call it at once.
inline const masks_between& masks_between_faces(const std::vector<bool>& is_quad)
{
    static detail::mutex mutex;
    static std::map<std::vector<bool>, masks_between> found;
    const std::lock_guard lock(mutex);
    const auto place = found.find(is_quad);
    return place != found.end() ? place->second : found.emplace(is_quad, find_masks_between(is_quad)).first->second;
}

} // namespace detail

/// A level of quad_tri as one of Catmull-Clark and one of Loop, with the same creases.
template <level Level>
struct quad_tri_level {
    quad_tri_level(const quad_tri& s, const Level& level)
        : catmull_clark_scheme{.corners = s.corners, .sharpness = s.sharpness}
        , loop_scheme{.corners = s.corners, .sharpness = s.sharpness}
        , quads(limit_rules<catmull_clark>::on(catmull_clark_scheme, level))
        , triangles(limit_rules<loop>::on(loop_scheme, level))
    {
    }
    quad_tri_level(const quad_tri_level&) = delete;
    void operator=(const quad_tri_level&) = delete;

    catmull_clark catmull_clark_scheme;
    loop loop_scheme;
    creased_scheme<catmull_clark, Level> quads;
    creased_scheme<loop, Level> triangles;
};

/// The limit rules of quad_tri: those of Catmull-Clark at vertices whose faces are all quads, those of Loop at vertices
/// of triangles. Smooth vertices between quads and triangles have masks by iteration.
template <>
struct limit_rules<quad_tri> : limit_defaults {
    static constexpr bool are_alike_where_regular = true;
    static constexpr int rings(const quad_tri&) { return 0; }
    static int reach(const quad_tri& s, int rings) { return s.sharpness.reach(rings); }
    template <level Level>
    static quad_tri_level<Level> on(const quad_tri& s, const Level& level)
    {
        return {s, level};
    }

    template <level Level, class Use>
    static void position(const quad_tri_level<Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (has_triangles_only(v))
            return limit_rules<loop>::position(s.triangles, v, use);
        limit_rules<catmull_clark>::position(s.quads, v, use);
        with_masks_between(s, v, [&](const detail::masks_between& masks) {
            const auto row = row_of(v, masks.position);
            use(weighted(row));
        });
    }
    template <level Level, class Use>
    static void tangents(const quad_tri_level<Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (has_triangles_only(v))
            return limit_rules<loop>::tangents(s.triangles, v, use);
        limit_rules<catmull_clark>::tangents(s.quads, v, use);
        with_masks_between(s, v, [&](const detail::masks_between& masks) {
            const auto first = row_of(v, masks.tangents[0]), second = row_of(v, masks.tangents[1]);
            use(weighted(first), weighted(second));
        });
    }
    template <level Level, class Use>
    static void sides(const quad_tri_level<Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (has_triangles_only(v))
            limit_rules<loop>::sides(s.triangles, v, use);
        else
            limit_rules<catmull_clark>::sides(s.quads, v, use);
    }
    template <level Level, class Use>
    static void sectors(const quad_tri_level<Level>& s, const vertex<Level>& v, const Use& use)
    {
        crease_limits::sectors(s.quads, v, use);
    }
    template <level Level>
    static bool never_has_tangents(const quad_tri_level<Level>& s, const vertex<Level>& v)
    {
        return has_triangles_only(v) ? limit_rules<loop>::never_has_tangents(s.triangles, v)
                                     : limit_rules<catmull_clark>::never_has_tangents(s.quads, v);
    }

private:
    template <vertex_element Vertex>
    static bool has_triangles_only(const Vertex& v)
    {
        for (const auto& c : v.corners())
            if (not is_in_triangle(c))
                return false;
        return true;
    }
    /// Calls use(masks) if the vertex is smooth and lies between triangles and quads, and between no other faces.
    template <level Level, class Use>
    [[gnu::noinline]] static void with_masks_between(const quad_tri_level<Level>& s, const vertex<Level>& v,
                                                     const Use& use)
    {
        if (has_quads_only(v) or not s.quads.sharp.is_smooth(v))
            return;
        std::vector<bool> is_quad;
        for (const auto& c : v.corners()) {
            if (c.f().degree() > 4 or is_quad.size() == longest_row)
                return;
            is_quad.push_back(not is_in_triangle(c));
        }
        use(detail::masks_between_faces(is_quad));
    }
    template <level Level>
    static mask_row<Level> row_of(const vertex<Level>& v, const std::vector<double>& weights)
    {
        mask_row<Level> row{{v, weights[0]}};
        const std::size_t n = weights.size() / 2;
        std::size_t j = 0;
        for (const auto& c : v.corners()) {
            row.emplace_back(c.next().v(), weights[1 + j]);
            if (not is_in_triangle(c))
                row.emplace_back(c.next().next().v(), weights[1 + n + j]);
            ++j;
        }
        return row;
    }
};

} // namespace kith
