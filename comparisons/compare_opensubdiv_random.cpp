// SPDX-License-Identifier: BSD-3-Clause
#include "opensubdiv_peer.hpp"
#include "random_meshes.hpp"

#include <kith/hierarchy.hpp>
#include <kith/presets.hpp>
#include <kith/step/scheme.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
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

/// What has been compared, and the largest distances, in the size of the mesh.
struct tally {
    std::map<std::string, std::size_t> count;
    double exact = 0, rounded = 0;
};

/// One run: OpenSubdiv's refinement and kith's, vertex by vertex on each level. Each step of OpenSubdiv starts from kith's
/// points, so that a difference is told on the level where it arises.
template <class Scheme>
class random_comparison {
public:
    random_comparison(const basic_mesh<>& control, const Scheme& scheme, int levels, float_sharpness kind)
        : ours_(control, scheme), theirs_(opensubdiv_peer::make(control, scheme)), kind_(kind)
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
        for (std::size_t v = 0; v < ours_[0].vertex_count(); ++v)
            number_.push_back(int(v));
        for (int level = 0; level < ours_.depth(); ++level) {
            compare_sharpness(level, sum);
            number_ = compare_step(level, sum);
        }
    }

private:
    using level_type = kith::level_of<basic_mesh<>>;

    [[nodiscard]] double tolerance() const { return (kind_ == float_sharpness::rounded ? 1e-6 : 1e-12) * size_; }
    [[noreturn]] static void fail(int level, const std::string& what)
    {
        throw std::runtime_error("level " + std::to_string(level) + ": " + what);
    }

    [[nodiscard]] int their_edge(int level, const kith::edge<level_type>& e) const
    {
        return theirs_->GetLevel(level).FindEdge(number_[e.org().index()], number_[e.dst().index()]);
    }
    [[nodiscard]] int their_face(int level, const kith::face<level_type>& f) const
    {
        const auto& their_level = theirs_->GetLevel(level);
        std::vector<int> vertices;
        for (const auto v : f.vertices())
            vertices.push_back(number_[v.index()]);
        const auto found = their_level.GetVertexFaces(vertices[0]);
        for (int i = 0; i < found.size(); ++i) {
            const auto theirs = their_level.GetFaceVertices(found[i]);
            if (std::is_permutation(vertices.begin(), vertices.end(), theirs.begin(), theirs.end()))
                return found[i];
        }
        fail(level, "OpenSubdiv has no such face");
    }

    /// The creases of a level are the same, in number and in sharpness.
    void compare_sharpness(int level, tally& sum) const
    {
        const auto& creases = ours_.scheme(level).sharpness;
        const auto& their_level = theirs_->GetLevel(level);
        const auto same = [&](double ours, float theirs, bool infinite) {
            if (infinite or ours == infinitely_sharp)
                return infinite and ours == infinitely_sharp;
            return std::abs(ours - double(theirs)) <= (kind_ == float_sharpness::rounded ? 1e-6 : 0);
        };
        for (const auto e : ours_.elements(level).edges()) {
            const double sharpness = creases.sharpness(e);
            const int their = their_edge(level, e);
            if (not same(sharpness, their_level.GetEdgeSharpness(their), their_level.IsEdgeInfSharp(their)))
                fail(level,
                     "edge " + std::to_string(e.index()) + " has sharpness " + std::to_string(sharpness) +
                         ", with OpenSubdiv " + std::to_string(their_level.GetEdgeSharpness(their)));
            if (not e.is_boundary() and sharpness > 0)
                ++sum.count[sharpness == infinitely_sharp ? "infinitely sharp edges"
                            : sharpness < 1               ? "edges below 1"
                                                          : "edges from 1 on"];
        }
        for (const auto v : ours_.elements(level).vertices()) {
            const double sharpness = creases.of_vertex(v.index());
            const int their = number_[v.index()];
            const bool kept = v.is_boundary() and v.face_count() == 1 and
                              ours_.scheme(level).corners == kith::boundary_corner::kept;
            if (not same(kept ? infinitely_sharp : sharpness,
                         their_level.GetVertexSharpness(their),
                         their_level.IsVertexInfSharp(their)))
                fail(level,
                     "vertex " + std::to_string(v.index()) + " has sharpness " + std::to_string(sharpness) +
                         ", with OpenSubdiv " + std::to_string(their_level.GetVertexSharpness(their)));
            if (sharpness > 0)
                ++sum.count["sharp vertices"];
            std::size_t sharp_edges = 0;
            for (const auto e : v.edges())
                sharp_edges += creases.sharpness(e) > 0;
            if (sharp_edges != 0 and not v.is_boundary())
                ++sum.count[sharp_edges == 1 ? "darts" : sharp_edges == 2 ? "creases" : "corners"];
            if (v.is_boundary())
                ++sum.count[sharp_edges == 2 ? "boundary vertices" : "boundary vertices where creases end"];
        }
    }

    /// The numbers that OpenSubdiv gives the vertices of the next level.
    std::vector<int> compare_step(int level, tally& sum) const
    {
        const auto& coarse = ours_.elements(level);
        const auto& fine = ours_[level + 1];
        const auto& their_level = theirs_->GetLevel(level);
        std::vector<opensubdiv_point<double>> source(number_.size()), made(fine.vertex_count());
        for (std::size_t v = 0; v < number_.size(); ++v)
            source[std::size_t(number_[v])].at = ours_[level].point(v);
        OpenSubdiv::Far::PrimvarRefinerReal<double>(*theirs_).Interpolate(level + 1, source, made);

        std::vector<int> numbers(fine.vertex_count(), -1);
        const auto compare = [&](const char* kind, const auto& x, int their, const shapes::point& expected) {
            const auto v = ours_.assoc(level, x.handle(), kith::targets::V).value;
            numbers[v] = their;
            for (std::size_t i = 0; i < 3; ++i) {
                const double distance = std::abs(expected[i] - made[std::size_t(their)].at[i]);
                if (not(distance <= tolerance()))
                    fail(level, kind + std::to_string(x.index()) + ": its point is off by " + std::to_string(distance));
                double& largest = kind_ == float_sharpness::rounded ? sum.rounded : sum.exact;
                largest = std::max(largest, distance / size_);
            }
            ++sum.count["points"];
        };
        const auto point_of = [&](const auto& x) {
            return fine.point(ours_.assoc(level, x.handle(), kith::targets::V).value);
        };
        for (const auto v : coarse.vertices())
            compare("vertex ", v, their_level.GetVertexChildVertex(number_[v.index()]), point_of(v));
        for (const auto e : coarse.edges()) {
            const bool overshoots = opensubdiv_overshoots(level, e);
            sum.count["edge points where OpenSubdiv overshoots"] += overshoots;
            compare("edge ",
                    e,
                    their_level.GetEdgeChildVertex(their_edge(level, e)),
                    overshoots ? overshot(level, e) : point_of(e));
        }
        if constexpr (std::same_as<Scheme, kith::catmull_clark>)
            for (const auto f : coarse.faces())
                compare("face ", f, their_level.GetFaceChildVertex(their_face(level, f)), point_of(f));
        return numbers;
    }

    /// Chaikin's method and an edge sharper than 1 one of whose halves gets smooth: OpenSubdiv does not take the midpoint
    /// but s midpoint + (1 - s) smooth, although s > 1. docs/schemes.md.
    [[nodiscard]] bool opensubdiv_overshoots(int level, const kith::edge<level_type>& e) const
    {
        const auto& creases = ours_.scheme(level).sharpness;
        const double s = creases.sharpness(e);
        return creases.method == crease_method::chaikin and s > 1 and s < infinitely_sharp and
               (creases.child_sharpness(e.org(), e) == 0 or creases.child_sharpness(e.dst(), e) == 0);
    }
    [[nodiscard]] shapes::point overshot(int level, const kith::edge<level_type>& e) const
    {
        auto scheme = ours_.scheme(level);
        scheme.sharpness = {};
        kith::hierarchy without_creases(ours_[level], scheme);
        without_creases.refine();
        const auto smooth = without_creases[1].point(without_creases.assoc(0, e.handle(), kith::targets::V).value);
        const double s = ours_.scheme(level).sharpness.sharpness(e);
        shapes::point result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = s * (e.org().point()[i] + e.dst().point()[i]) / 2 + (1 - s) * smooth[i];
        return result;
    }

    kith::hierarchy<basic_mesh<>, Scheme> ours_;
    opensubdiv_peer::mesh theirs_;
    float_sharpness kind_;
    double size_ = 0;
    std::vector<int> number_; ///< that OpenSubdiv gives the vertices of the level at hand
};

/// All options on one mesh, with other creases for each.
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
    namespace options = boost::program_options;
    options::options_description description(
        "Random meshes with random creases, refined with OpenSubdiv and with kith");
    description.add_options()("help", "this text")(
        "count", options::value<std::size_t>()->default_value(1000), "so many meshes for each scheme")(
        "seed", options::value<std::uint64_t>()->default_value(1), "of the first mesh; the next ones follow it")(
        "levels", options::value<int>()->default_value(3), "how often to refine");
    options::variables_map values;
    try {
        store(parse_command_line(count, words, description), values);
        notify(values);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    if (values.count("help")) {
        std::cout << description;
        return 0;
    }
    tally sum;
    std::size_t different = 0;
    const auto seed = values["seed"].as<std::uint64_t>();
    for (std::uint64_t i = seed; i < seed + values["count"].as<std::size_t>(); ++i) {
        random_numbers random(i);
        try {
            compare_options<kith::catmull_clark>(random_polygons(random), values["levels"].as<int>(), random, sum);
            compare_options<kith::loop>(random_triangles(random), values["levels"].as<int>(), random, sum);
        } catch (const std::exception& error) {
            std::cout << "seed " << i << ": DIFFERENT: " << error.what() << '\n';
            ++different;
        }
    }
    for (const auto& [what, number] : sum.count)
        std::cout << what << ": " << number << '\n';
    std::cout << opensubdiv_peer::version() << ", " << values["count"].as<std::size_t>() << " meshes for each scheme, "
              << different << " different; largest distance " << sum.exact << " of the mesh, " << sum.rounded
              << " where OpenSubdiv rounds sharpness to floats\n";
    return different == 0 ? 0 : 1;
}
