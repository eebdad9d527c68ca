// SPDX-License-Identifier: BSD-3-Clause
#include "exit_code.hpp"
#include "opensubdiv_numbers.hpp"
#include "random_corner_values.hpp"
#include "random_runs.hpp"

#include <kith/face_varying.hpp>
#include <kith/presets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace kith::comparison;
using kith::basic_mesh;
using kith::crease_method;
using kith::face_varying_linear;

using rule = opensubdiv_corners::rule;
using point = std::array<double, 3>;

struct choice {
    const char* name;
    face_varying_linear ours;
    rule theirs;
};
constexpr std::array choices{
    choice{"NONE", face_varying_linear::none, rule::FVAR_LINEAR_NONE},
    choice{"CORNERS_ONLY", face_varying_linear::corners_only, rule::FVAR_LINEAR_CORNERS_ONLY},
    choice{"CORNERS_PLUS1", face_varying_linear::corners_plus1, rule::FVAR_LINEAR_CORNERS_PLUS1},
    choice{"CORNERS_PLUS2", face_varying_linear::corners_plus2, rule::FVAR_LINEAR_CORNERS_PLUS2},
    choice{"BOUNDARIES", face_varying_linear::boundaries, rule::FVAR_LINEAR_BOUNDARIES},
    choice{"ALL", face_varying_linear::all, rule::FVAR_LINEAR_ALL},
};

/// The counts of what has been compared, and the largest difference of two values; control values lie between -1 and 1.
struct tally {
    std::map<std::string, std::size_t> count;
    double largest = 0;
};

/// The values that OpenSubdiv computes from the values of the control mesh, level by level.
class their_values {
public:
    their_values(const opensubdiv_peer::mesh& theirs, const std::vector<point>& control) : theirs_(theirs)
    {
        for (const point& p : control)
            values_.push_back({p});
    }
    /// Returns the value at a corner of a face on the current level, in OpenSubdiv's order of corners.
    [[nodiscard]] point at(int level, int face, int corner) const
    {
        return values_[std::size_t(theirs_->GetLevel(level).GetFaceFVarValues(face)[corner])].at;
    }
    void go_to_level(int level)
    {
        std::vector<opensubdiv_point<double>> next(std::size_t(theirs_->GetLevel(level).GetNumFVarValues()));
        OpenSubdiv::Far::PrimvarRefinerReal<double>(*theirs_).InterpolateFaceVarying(level, values_, next);
        values_ = std::move(next);
    }

private:
    const opensubdiv_peer::mesh& theirs_;
    std::vector<opensubdiv_point<double>> values_;
};

template <class Field, class Numbers>
void compare_level(const Field& ours, const their_values& theirs, const Numbers& numbers, tally& sum)
{
    std::size_t corners = 0;
    for (const auto f : numbers.elements().faces()) {
        const int their_face = numbers.of(f);
        const auto vertices = numbers.their_level().GetFaceVertices(their_face);
        for (const auto c : f.corners()) {
            const int place = vertices.FindIndex(numbers.of(c.v()));
            const point expected = theirs.at(numbers.level(), their_face, place);
            for (std::size_t i = 0; i < 3; ++i) {
                const double distance = std::abs(expected[i] - ours[c.index()][i]);
                if (not(distance <= 1e-12))
                    numbers.fail("corner " + std::to_string(c.index()) + " at vertex " + std::to_string(c.v().index()) +
                                 ": its value is off by " + std::to_string(distance));
                sum.largest = std::max(sum.largest, distance);
            }
            ++corners;
        }
    }
    sum.count["corners"] += corners;
}

/// Compares all choices of linear interpolation on one mesh.
template <class Scheme>
void compare_choices(const basic_mesh<>& control, const Scheme& scheme, const numbered_corners& corners,
                     random_numbers& random, int depth, tally& sum)
{
    std::vector<point> values;
    for (int i = 0; i < corners.count; ++i)
        values.push_back({random.coordinate(), random.coordinate(), random.coordinate()});
    std::vector<point> at_corners;
    for (const int i : corners.numbers)
        at_corners.push_back(values[std::size_t(i)]);
    kith::hierarchy levels(control, scheme);
    levels.refine(depth);
    for (const auto& [name, ours, theirs] : choices)
        try {
            const auto mesh = opensubdiv_peer::make(control, scheme, {corners.numbers, corners.count, theirs});
            if (not mesh)
                throw std::runtime_error("OpenSubdiv refuses the mesh");
            opensubdiv_peer::refine(mesh, depth, true);
            opensubdiv_numbers<Scheme> numbers(levels, mesh);
            their_values expected(mesh, values);
            auto field = kith::on_corners(at_corners, kith::face_varying{ours});
            while (numbers.level() < depth) {
                field = levels.carry(numbers.level(), numbers.level() + 1, field);
                numbers.go_to_next_level();
                expected.go_to_level(numbers.level());
                compare_level(field, expected, numbers, sum);
            }
        } catch (const std::exception& error) {
            throw std::runtime_error(std::string(kith::scheme_name<Scheme>()) + ", " + name + ", " +
                                     (scheme.corners == kith::boundary_corner::kept ? "EDGE_AND_CORNER" : "EDGE_ONLY") +
                                     ": " + error.what());
        }
}

/// Compares without creases, with creases that OpenSubdiv's floats hold exactly, and with Chaikin's creases.
template <class Scheme>
void compare_creases(const shapes::shape& shape, std::size_t one_seam_in, random_numbers& random, int depth, tally& sum)
{
    const auto control = kith::make_mesh(shape.points, shape.faces);
    const auto corners = cut_along(control, marked_edges(control, one_seam_in, random), random, sum.count);
    auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
    for (const auto corner : {kith::boundary_corner::kept, kith::boundary_corner::smoothed}) {
        scheme.corners = corner;
        const auto run = [&](kith::creases creases) {
            scheme.sharpness = std::move(creases);
            compare_choices(control, scheme, corners, random, depth, sum);
        };
        run({});
        run(random_creases(
            control, random.one_in(2) ? float_sharpness::few : float_sharpness::alike, crease_method::uniform, random));
        run(random_creases(control, float_sharpness::alike, crease_method::chaikin, random));
    }
}

/// The densities of seams: one edge in this number is a seam; 0 means no seam.
constexpr std::array<std::size_t, 6> densities{1, 2, 4, 8, 16, 0};

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        auto runs = parse_random_runs(
            count,
            words,
            "Values at corners with random seams, with all choices of OpenSubdiv's face-varying linear "
            "interpolation, refined with OpenSubdiv and with kith: on the shapes of the tests, and on "
            "random meshes with random creases");
        if (not runs)
            return;
        const int levels = runs->levels;
        tally sum;
        const auto of_shapes = [&](const auto& shapes, const auto& compare) {
            for (const auto& [name, shape] : shapes)
                for (const std::size_t density : densities)
                    runs->attempt(name, [&] {
                        random_numbers random(density);
                        compare(shape, density, random);
                    });
        };
        of_shapes(shapes::all_shapes(), [&](const auto& shape, std::size_t density, random_numbers& random) {
            compare_creases<kith::catmull_clark>(shape, density, random, levels, sum);
        });
        of_shapes(shapes::triangle_shapes(), [&](const auto& shape, std::size_t density, random_numbers& random) {
            compare_creases<kith::loop>(shape, density, random, levels, sum);
        });
        runs->attempt_seeds([&](random_numbers& random) {
            const std::size_t density = densities[random.below(densities.size())];
            compare_creases<kith::catmull_clark>(random_polygons(random), density, random, levels, sum);
            compare_creases<kith::loop>(random_triangles(random), density, random, levels, sum);
        });
        for (const auto& [what, number] : sum.count)
            std::cout << what << ": " << number << '\n';
        std::cout << opensubdiv_peer::version() << ", " << runs->count
                  << " random meshes for each scheme and the shapes of the tests, " << runs->different()
                  << " different; largest distance " << sum.largest << " of values between -1 and 1\n";
        runs->require_same();
    });
}
