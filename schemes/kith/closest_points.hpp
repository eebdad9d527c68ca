// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/surface_locator.hpp>
#include <kith/tessellation/parametric_faces.hpp>
#include <kith/tessellation/tessellation_rates.hpp>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras_point_box.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The point of a limit surface that is nearest to a given point.
struct closest_point {
    surface_place place;
    std::array<double, 3> point;
    double distance;
};

/// Finds the nearest points of a limit surface. Its faces are cut into cells, which turn by about a quarter of a
/// radian. Boost.Geometry has an R-tree of their boxes. Newton's method starts in each cell whose box comes near
/// enough. So a result is exact to about 1e-11 of the size of the surface. It is the nearest one unless a single cell
/// has two local ones. For points of three coordinates. One thread at a time may use an object.
template <parametric_scheme Scheme, std::unsigned_integral Index = std::uint32_t>
class closest_points {
    using vector = std::array<double, 3>;

public:
    /// Takes the limit surface of a mesh, which need not outlive this object. Errors: those of `surface_locator`.
    /// Cost: that of some hundred evaluations for each face, and more where the face is curved.
    template <class Point, std::same_as<Index> I>
    explicit closest_points(const basic_mesh<Point, I>& mesh, const Scheme& scheme = Scheme())
        : surface_(mesh, scheme), faces_(detail::parametric_faces::of(mesh.topology(), scheme))
    {
        for (const Point& p : mesh.points()) {
            const auto& x = affine<Point>::load(p);
            control_.push_back({double(x[0]), double(x[1]), double(x[2])});
            for (const double coordinate : control_.back())
                rounding_ = std::max(rounding_, 1e-15 * std::abs(coordinate));
        }
        make_cells();
    }
    template <mesh M>
    explicit closest_points(const M& mesh, const Scheme& scheme = Scheme()) : closest_points(lift_valid(mesh), scheme)
    {
    }

    /// Returns the nearest point for each of some points. Errors: mesh_error for a point that is not finite.
    /// Cost: for each point O(log cells), and some evaluations of the surface for each cell that is near enough.
    [[nodiscard]] std::vector<closest_point> of(std::span<const vector> points)
    {
        std::vector<closest_point> result(points.size(), {{}, {}, std::numeric_limits<double>::infinity()});
        std::vector<search> searches = begin_searches(points);
        constexpr int most_steps = 40;
        for (int step = 0; step < most_steps and not searches.empty(); ++step) {
            std::vector<surface_place> places;
            for (const search& s : searches)
                places.push_back(s.place);
            const auto values = surface_.locate(places).evaluate(std::span<const vector>(control_),
                                                                 derivatives::second);
            std::size_t left = 0;
            for (std::size_t i = 0; i < searches.size(); ++i) {
                search s = searches[i];
                const vector off = detail::difference(values.points[i], points[s.query]);
                const double distance = detail::length_of(off);
                // Later steps are nearer, even if rounding hides it.
                if (closest_point& best = result[s.query]; distance <= best.distance + rounding_)
                    best = {s.place, values.points[i], distance};
                if (go_on(s, off, distance, values, i))
                    searches[left++] = s;
            }
            searches.resize(left);
        }
        return result;
    }

private:
    using tree_point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
    using tree_box = boost::geometry::model::box<tree_point>;
    using tree = boost::geometry::index::rtree<std::pair<tree_box, std::size_t>, boost::geometry::index::rstar<16>>;
    using parameters = std::array<double, 2>;

    /// A part of a face, and the point in its middle.
    struct cell {
        surface_place middle;
        vector point;
        bool is_in_triangle;
    };
    /// A place on its way to a nearest one, and the one before.
    struct search {
        std::size_t query;
        surface_place place, before;
        double distance_before;
        bool is_in_triangle;
    };

    void make_cells()
    {
        constexpr std::size_t samples = 3; // of a cell, in each direction
        const std::span<const vector> control(control_);
        const detail::tessellation_rates rates(faces_, surface_, control, {.segments = 2, .angle = .25});
        std::vector<surface_place> places;
        for (std::size_t f = 0; f < faces_.faces().size(); ++f) {
            const auto& face = faces_.faces()[f];
            const bool is_triangle = face.sides.size() == 3;
            const double by_u = 1 / double(rates.of_faces[f].u), by_v = 1 / double(rates.of_faces[f].v);
            for (std::size_t i = 0; i < rates.of_faces[f].u; ++i)
                for (std::size_t j = 0; j < rates.of_faces[f].v; ++j) {
                    if (is_triangle and i + j >= rates.of_faces[f].u)
                        break;
                    for (std::size_t k = 0; k < samples * samples; ++k)
                        places.push_back(detail::place_in(face,
                                                          (double(i) + double(k / samples) / 2) * by_u,
                                                          (double(j) + double(k % samples) / 2) * by_v));
                    cells_.push_back({places[places.size() - 5], {}, is_triangle});
                }
        }
        const auto points = detail::points_at(surface_, control, places);
        std::vector<std::pair<tree_box, std::size_t>> boxes;
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            const vector* const p = points.data() + c * samples * samples;
            cells_[c].point = p[4];
            boxes.emplace_back(box_of(p), c);
        }
        tree_ = tree(boxes);
    }
    /// Returns a box around a cell, of which nine points are given. It is larger by as much as these points bend.
    static tree_box box_of(const vector* p)
    {
        vector least = p[0], most = p[0];
        double bend = 0;
        for (std::size_t k = 0; k < 9; ++k)
            for (std::size_t x = 0; x < 3; ++x) {
                least[x] = std::min(least[x], p[k][x]);
                most[x] = std::max(most[x], p[k][x]);
                for (const auto& [first, middle, last] : lines)
                    bend = std::max(bend, std::abs(p[first][x] - 2 * p[middle][x] + p[last][x]));
            }
        return {tree_point(least[0] - bend, least[1] - bend, least[2] - bend),
                tree_point(most[0] + bend, most[1] + bend, most[2] + bend)};
    }
    static constexpr std::array<std::array<std::size_t, 3>, 8> lines{
        {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8}, {0, 4, 8}, {2, 4, 6}}};

    /// Begins in the middle of each cell that may have the nearest point.
    [[nodiscard]] std::vector<search> begin_searches(std::span<const vector> points) const
    {
        namespace index = boost::geometry::index;
        std::vector<search> result;
        for (std::size_t q = 0; q < points.size(); ++q) {
            const auto& [x, y, z] = points[q];
            if (not(std::isfinite(x) and std::isfinite(y) and std::isfinite(z)))
                throw mesh_error("point " + std::to_string(q) + " is not finite; correct it");
            const tree_point here(x, y, z);
            double nearest = std::numeric_limits<double>::infinity();
            for (auto i = tree_.qbegin(index::nearest(here, unsigned(tree_.size()))); i != tree_.qend(); ++i) {
                if (boost::geometry::distance(here, i->first) > nearest)
                    break;
                const cell& c = cells_[i->second];
                nearest = std::min(nearest, detail::length_of(detail::difference(c.point, points[q])));
                result.push_back({q, c.middle, c.middle, std::numeric_limits<double>::infinity(), c.is_in_triangle});
            }
        }
        return result;
    }

    /// Moves a search by Newton's method, within its face. Returns false if it has arrived.
    [[nodiscard]] bool go_on(search& s, const vector& off, double distance, const surface_values<vector>& values,
                             std::size_t i) const
    {
        if (distance > s.distance_before + rounding_) { // too far: half of the way
            s.place.u = (s.place.u + s.before.u) / 2;
            s.place.v = (s.place.v + s.before.v) / 2;
            return std::abs(s.place.u - s.before.u) + std::abs(s.place.v - s.before.v) > smallest_move;
        }
        const vector &du = values.du[i], &dv = values.dv[i];
        const parameters slope{detail::dot(du, off), detail::dot(dv, off)};
        std::array<double, 3> first{
            detail::dot(du, du), detail::dot(du, dv), detail::dot(dv, dv)}; // a matrix by its upper half
        const std::array<double, 3> second{
            detail::dot(off, values.duu[i]), detail::dot(off, values.duv[i]), detail::dot(off, values.dvv[i])};
        std::array<double, 3> matrix{first[0] + second[0], first[1] + second[1], first[2] + second[2]};
        const auto is_definite = [](const auto& m) { return m[0] > 0 and m[0] * m[2] - m[1] * m[1] > 0; };
        if (not is_definite(matrix)) // also if the second derivatives are no numbers
            matrix = first;
        if (not is_definite(matrix))
            return false;
        const parameters move = move_within(s, slope, matrix);
        if (not(std::abs(move[0]) + std::abs(move[1]) > smallest_move))
            return false;
        s.before = s.place;
        s.distance_before = distance;
        s.place.u = at_side(s.place.u + move[0], 1);
        s.place.v = at_side(s.place.v + move[1], s.is_in_triangle ? 1 - s.place.u : 1);
        return true;
    }
    /// Returns a parameter from 0 to `most`, and one of these where only rounding is between.
    static double at_side(double x, double most)
    {
        constexpr double rounding = 1e-14;
        return x < rounding ? 0 : x > most - rounding ? most : x;
    }
    /// Returns Newton's move. It goes along a side of the face where it would leave it.
    static parameters move_within(const search& s, const parameters& slope, const std::array<double, 3>& matrix)
    {
        const double u = s.place.u, v = s.place.v;
        const double determinant = matrix[0] * matrix[2] - matrix[1] * matrix[1];
        parameters move{(-slope[0] * matrix[2] + slope[1] * matrix[1]) / determinant,
                        (slope[0] * matrix[1] - slope[1] * matrix[0]) / determinant};
        const auto keep_inside = [&](bool is_there, const parameters& outward) {
            if (not is_there or move[0] * outward[0] + move[1] * outward[1] <= 0)
                return;
            const parameters along{-outward[1], outward[0]};
            const double bend = along[0] * along[0] * matrix[0] + 2 * along[0] * along[1] * matrix[1] +
                                along[1] * along[1] * matrix[2];
            const double t = -(slope[0] * along[0] + slope[1] * along[1]) / bend;
            move = {t * along[0], t * along[1]};
        };
        keep_inside(u <= 0, {-1, 0});
        keep_inside(v <= 0, {0, -1});
        if (s.is_in_triangle) {
            keep_inside(u + v >= 1, {1, 1});
        } else {
            keep_inside(u >= 1, {1, 0});
            keep_inside(v >= 1, {0, 1});
        }
        // No further than to the first side.
        double share = 1;
        const auto stop_at = [&](double value, double by) { // where value + t * by is 0
            if (by < 0 and value >= 0)
                share = std::min(share, value / -by);
        };
        stop_at(u, move[0]);
        stop_at(v, move[1]);
        if (s.is_in_triangle) {
            stop_at(1 - u - v, -move[0] - move[1]);
        } else {
            stop_at(1 - u, -move[0]);
            stop_at(1 - v, -move[1]);
        }
        return {share * move[0], share * move[1]};
    }

    static constexpr double smallest_move = 1e-14;

    surface_locator<Scheme, Index> surface_;
    detail::parametric_faces faces_;
    std::vector<vector> control_;
    double rounding_ = 0; // of a distance
    std::vector<cell> cells_;
    tree tree_;
};

template <mesh M, parametric_scheme Scheme>
closest_points(const M&, const Scheme&) -> closest_points<Scheme>;
template <class Point, std::unsigned_integral Index, parametric_scheme Scheme>
closest_points(const basic_mesh<Point, Index>&, const Scheme&) -> closest_points<Scheme, Index>;

} // namespace kith
