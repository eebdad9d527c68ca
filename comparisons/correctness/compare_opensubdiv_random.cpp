// SPDX-License-Identifier: BSD-3-Clause
#include "exit_code.hpp"
#include "opensubdiv_numbers.hpp"
#include "random_meshes.hpp"
#include "random_runs.hpp"

#include <kith/hierarchy.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/presets.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace kith::comparison;
using kith::basic_mesh;
using kith::crease_method;
using kith::infinitely_sharp;

/// The counts of what has been compared, and the largest distances, relative to the size of the mesh.
struct tally {
    std::map<std::string, std::size_t> count;
    double exact = 0, rounded = 0;
};

/// A comparison of OpenSubdiv's refinement with kith's, vertex by vertex on each level. Each step of OpenSubdiv starts
/// from kith's points, so a difference is reported on the level where it arises.
template <class Scheme>
class random_comparison {
public:
    random_comparison(const basic_mesh<>& control, const Scheme& scheme, int levels, float_sharpness kind)
        : ours_(control, scheme), theirs_(opensubdiv_peer::make(control, scheme)), numbers_(ours_, theirs_), kind_(kind)
    {
        if (not theirs_)
            throw std::runtime_error("OpenSubdiv refuses the mesh");
        for (const auto& p : control.points())
            size_ = std::max({size_, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
        ours_.refine(levels);
        opensubdiv_peer::refine(theirs_, levels, true);
    }

    void run(tally& sum)
    {
        for (; numbers_.level() < ours_.depth(); numbers_.go_to_next_level()) {
            compare_sharpness(sum);
            compare_step(sum);
        }
    }

private:
    using level_type = kith::level_of<basic_mesh<>>;

    [[nodiscard]] double tolerance() const { return (kind_ == float_sharpness::rounded ? 1e-6 : 1e-12) * size_; }
    [[nodiscard]] const kith::creases& creases() const { return ours_.scheme(numbers_.level()).sharpness; }

    /// Compares the creases of the current level: the elements and their sharpness must be equal.
    void compare_sharpness(tally& sum) const
    {
        const auto& coarse = numbers_.elements();
        const auto their_level = numbers_.their_level();
        const auto same = [&](double ours, float theirs, bool infinite) {
            if (infinite or ours == infinitely_sharp)
                return infinite and ours == infinitely_sharp;
            return std::abs(ours - double(theirs)) <= (kind_ == float_sharpness::rounded ? 1e-6 : 0);
        };
        for (const auto e : coarse.edges()) {
            const double sharpness = creases().sharpness(e);
            const int their = numbers_.of(e);
            if (not same(sharpness, their_level.GetEdgeSharpness(their), their_level.IsEdgeInfSharp(their)))
                numbers_.fail("edge " + std::to_string(e.index()) + " has sharpness " + std::to_string(sharpness) +
                              ", with OpenSubdiv " + std::to_string(their_level.GetEdgeSharpness(their)));
            if (not e.is_boundary() and sharpness > 0)
                ++sum.count[sharpness == infinitely_sharp ? "infinitely sharp edges"
                            : sharpness < 1               ? "edges below 1"
                                                          : "edges from 1 on"];
        }
        for (const auto v : coarse.vertices()) {
            const double sharpness = creases().of_vertex(v.index());
            const int their = numbers_.of(v);
            const bool kept = v.is_boundary() and v.face_count() == 1 and
                              ours_.scheme(numbers_.level()).corners == kith::boundary_corner::kept;
            if (not same(kept ? infinitely_sharp : sharpness,
                         their_level.GetVertexSharpness(their),
                         their_level.IsVertexInfSharp(their)))
                numbers_.fail("vertex " + std::to_string(v.index()) + " has sharpness " + std::to_string(sharpness) +
                              ", with OpenSubdiv " + std::to_string(their_level.GetVertexSharpness(their)));
            if (sharpness > 0)
                ++sum.count["sharp vertices"];
            std::size_t sharp_edges = 0;
            for (const auto e : v.edges())
                sharp_edges += creases().sharpness(e) > 0;
            if (sharp_edges != 0 and not v.is_boundary())
                ++sum.count[sharp_edges == 1 ? "darts" : sharp_edges == 2 ? "creases" : "corners"];
            if (v.is_boundary())
                ++sum.count[sharp_edges == 2 ? "boundary vertices" : "boundary vertices where creases end"];
        }
    }

    /// Compares the vertices of the next level with OpenSubdiv's.
    void compare_step(tally& sum) const
    {
        const int level = numbers_.level();
        const auto& fine = ours_[level + 1];
        std::vector<opensubdiv_point<double>> source(ours_[level].vertex_count()), made(fine.vertex_count());
        for (const auto v : numbers_.elements().vertices())
            source[std::size_t(numbers_.of(v))].at = v.point();
        OpenSubdiv::Far::PrimvarRefinerReal<double>(*theirs_).Interpolate(level + 1, source, made);

        numbers_.for_parents([&](const char* kind, const auto& x) {
            const auto expected = expected_point(x, fine, sum);
            for (std::size_t i = 0; i < 3; ++i) {
                const double distance = std::abs(expected[i] - made[std::size_t(numbers_.child_of(x))].at[i]);
                if (not(distance <= tolerance()))
                    numbers_.fail(kind + std::to_string(x.index()) + ": its point is off by " +
                                  std::to_string(distance));
                double& largest = kind_ == float_sharpness::rounded ? sum.rounded : sum.exact;
                largest = std::max(largest, distance / size_);
            }
            ++sum.count["points"];
        });
    }
    template <kith::element Element>
    [[nodiscard]] shapes::point expected_point(const Element& x, const basic_mesh<>& fine, tally& sum) const
    {
        if constexpr (kith::edge_element<Element>)
            if (opensubdiv_overshoots(x)) {
                ++sum.count["edge points where OpenSubdiv overshoots"];
                return overshot(x);
            }
        return fine.point(numbers_.our_child_of(x));
    }

    /// Returns true if OpenSubdiv overshoots: under Chaikin's method the edge is sharper than 1 and one of its halves
    /// becomes smooth. OpenSubdiv then takes s midpoint + (1 - s) smooth instead of the midpoint, although s > 1. See
    /// docs/schemes.md.
    [[nodiscard]] bool opensubdiv_overshoots(const kith::edge<level_type>& e) const
    {
        const double s = creases().sharpness(e);
        return creases().method == crease_method::chaikin and s > 1 and s < infinitely_sharp and
               (creases().child_sharpness(e.org(), e) == 0 or creases().child_sharpness(e.dst(), e) == 0);
    }
    [[nodiscard]] shapes::point overshot(const kith::edge<level_type>& e) const
    {
        auto scheme = ours_.scheme(numbers_.level());
        scheme.sharpness = {};
        kith::hierarchy without_creases(ours_[numbers_.level()], scheme);
        without_creases.refine();
        const auto smooth = without_creases[1].point(without_creases.assoc(0, e.handle(), kith::targets::V).value);
        const double s = creases().sharpness(e);
        shapes::point result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = s * (e.org().point()[i] + e.dst().point()[i]) / 2 + (1 - s) * smooth[i];
        return result;
    }

    kith::hierarchy<basic_mesh<>, Scheme> ours_;
    opensubdiv_peer::mesh theirs_;
    opensubdiv_numbers<Scheme> numbers_;
    float_sharpness kind_;
    double size_ = 0;
};

/// Compares all options on one mesh, with different creases for each.
template <class Scheme>
void compare_options(const shapes::shape& shape, int levels, random_numbers& random, tally& sum)
{
    const auto control = kith::make_mesh(shape.points, shape.faces);
    for (const auto corners : {kith::boundary_corner::kept, kith::boundary_corner::smoothed})
        for (const auto method : {crease_method::uniform, crease_method::chaikin})
            for (const auto kind : {float_sharpness::alike, float_sharpness::few, float_sharpness::rounded}) {
                auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
                scheme.corners = corners;
                scheme.sharpness = random_creases(control, kind, method, random);
                try {
                    random_comparison<Scheme>(control, scheme, levels, kind).run(sum);
                } catch (const std::exception& error) {
                    throw std::runtime_error(
                        std::string(kith::scheme_name<Scheme>()) +
                        (corners == kith::boundary_corner::kept ? ", EDGE_AND_CORNER" : ", EDGE_ONLY") +
                        (method == crease_method::uniform ? ", uniform" : ", Chaikin") + ", creases of kind " +
                        std::to_string(int(kind)) + ": " + error.what());
                }
            }
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        auto runs = parse_random_runs(
            count, words, "Random meshes with random creases, refined with OpenSubdiv and with kith");
        if (not runs)
            return;
        tally sum;
        runs->attempt_seeds([&](random_numbers& random) {
            compare_options<kith::catmull_clark>(random_polygons(random), runs->levels, random, sum);
            compare_options<kith::loop>(random_triangles(random), runs->levels, random, sum);
        });
        for (const auto& [what, number] : sum.count)
            std::cout << what << ": " << number << '\n';
        std::cout << opensubdiv_peer::version() << ", " << runs->count << " meshes for each scheme, "
                  << runs->different() << " different; largest distance " << sum.exact << " of the mesh, "
                  << sum.rounded << " where OpenSubdiv rounds sharpness to floats\n";
        runs->require_same();
    });
}
