// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/ternary_split.hpp>
#include <kith/tiles/part/reach.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// User-defined schemes with per-level state, which refine, tiles and ranks must hand on.
namespace own_state {

/// A scheme with Catmull-Clark as a member, under a name that the library does not know.
struct wrapped {
    kith::catmull_clark inner;

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "wrapped",
                                   .reach = [](const wrapped& s, int rings) { return reach_of(s.inner, rings); },
                                   .state = &wrapped::inner};
    }
    static constexpr auto columns() { return kith::catmull_clark::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        inner(r);
    }
};

/// A number at each face and each vertex of a level, which children inherit halved, and the count of levels so far.
class numbers {
public:
    std::vector<double> at_vertex, at_face;
    int levels = 0;

    [[nodiscard]] double of_vertex(std::size_t v) const { return v < at_vertex.size() ? at_vertex[v] : 0; }
    [[nodiscard]] double of_face(std::size_t f) const { return f < at_face.size() ? at_face[f] : 0; }

    template <class Level, class Numbering>
    [[nodiscard]] numbers after(const Level& coarse, const Numbering& ids) const
    {
        numbers result;
        result.levels = levels + 1;
        result.at_vertex.resize(ids.vertices.total());
        result.at_face.resize(ids.faces.total());
        for (const auto v : coarse.vertices())
            result.at_vertex[ids.vertices.template id<kith::tuple_kind::v>(v.index())] = of_vertex(v.index()) / 2;
        for (const auto c : coarse.corners())
            result.at_face[ids.faces.template id<kith::tuple_kind::vf>(c.index())] = of_face(c.f().index()) / 2;
        return result;
    }
    template <class Index>
    [[nodiscard]] numbers of_part(const kith::part_numbers<Index>& part) const
    {
        numbers result;
        result.levels = levels;
        for (const Index v : part.vertices)
            result.at_vertex.push_back(of_vertex(v));
        for (const Index f : part.faces)
            result.at_face.push_back(of_face(f));
        return result;
    }
    template <class Index>
    void add_part(const numbers& more, const kith::part_numbers<Index>& part)
    {
        const auto add = [](const std::vector<double>& from, std::span<const Index> where, std::vector<double>& to) {
            for (std::size_t i = 0; i < where.size(); ++i) {
                to.resize(std::max(to.size(), std::size_t(where[i]) + 1));
                to[where[i]] = from[i];
            }
        };
        add(more.at_vertex, part.vertices, at_vertex);
        add(more.at_face, part.faces, at_face);
    }
    template <class Out>
    void pack(Out& out) const
    {
        out.add(levels).add_array(at_vertex).add_array(at_face);
    }
    template <class In>
    void unpack(In& in)
    {
        levels = in.template get<int>();
        at_vertex = in.template get_array<std::vector<double>>();
        at_face = in.template get_array<std::vector<double>>();
    }
};

/// A variant of Catmull-Clark with two states. The larger the number of a face, the nearer its point lies to the first
/// vertex; the larger the number of a vertex, the less it moves.
struct drawn {
    numbers kept;
    kith::creases sharp;

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "drawn",
                                   .reach = [](const drawn& s, int rings) { return s.sharp.reach(rings); },
                                   .state = [](auto& s) { return std::tie(s.kept, s.sharp); }};
    }
    static constexpr auto columns() { return kith::catmull_clark::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const double t = kept.of_face(f.index()) + 1. / 64 * kept.levels;
            assoc(f, V) = t * f.first_corner().v() + (1 - t) * average(f.vertices());
        });
        for_each(coarse.edges(), [&](auto e) {
            if (sharp.sharpness(e) > 0)
                assoc(e, V) = average(e.org(), e.dst());
            else
                assoc(e, V) = average(e.org(), e.dst(), assoc(e.lface(), V), assoc(e.rface(), V));
        });
        for_each(coarse.vertices(), [&](auto v) {
            const double t = kept.of_vertex(v.index());
            assoc(v, V) = t * v + (1 - t) * average(v.faces().map([&](const auto& f) { return assoc(f, V); }));
        });
        kith::quad_split::connect(r);
    }
};

inline kith::creases some_creases(const mesh3d& mesh, kith::crease_method method)
{
    kith::creases sharp(method);
    for (std::size_t e = 0; e < mesh.edge_count(); e += 3)
        sharp.sharpen_edge(e, e % 2 == 0 ? kith::infinitely_sharp : 0.4 * double(e % 7));
    sharp.sharpen_vertex(3, 1.5);
    return sharp;
}
inline wrapped some_wrapped(const mesh3d& mesh, kith::crease_method method)
{
    return {{.corners = kith::boundary_corner::smoothed, .sharpness = some_creases(mesh, method)}};
}
inline drawn some_drawn(const mesh3d& mesh)
{
    drawn result{{}, some_creases(mesh, kith::crease_method::uniform)};
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        result.kept.at_vertex.push_back(double(v % 5) / 8);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.kept.at_face.push_back(double(f % 7) / 16);
    return result;
}

/// Numbers at vertices, for a scheme that makes a vertex of each corner.
struct numbers_at_corners : numbers {
    numbers_at_corners() = default;
    numbers_at_corners(numbers of_level) : numbers(std::move(of_level)) {}

    template <class Level, class Numbering>
    [[nodiscard]] numbers_at_corners after(const Level& coarse, const Numbering& ids) const
    {
        numbers_at_corners result;
        result.at_vertex.resize(ids.vertices.total());
        for (const auto c : coarse.corners())
            result.at_vertex[ids.vertices.template id<kith::tuple_kind::vf>(c.index())] = of_vertex(c.v().index());
        return result;
    }
};

/// A dual scheme: corners become vertices, as in Doo-Sabin's scheme. A boundary vertex becomes a face if it has three
/// or more faces and a number that is not 0.
struct capped_dual {
    numbers_at_corners kept;

    static constexpr auto traits()
    {
        return kith::scheme_traits{
            .name = "capped dual", .reach = [](int rings) { return (rings + 1) / 2 + 1; }, .state = &capped_dual::kept};
    }
    template <class Vertex>
    [[nodiscard]] bool is_capped(const Vertex& v) const
    {
        return v.face_count() >= 3 and kept.of_vertex(v.index()) != 0;
    }
    [[nodiscard]] auto columns() const
    {
        using namespace kith;
        const auto capped = [this](const auto& v) { return is_capped(v); };
        const auto faces_around = [](const auto& v) { return v.face_count(); };
        return kith::columns(new_vertices(per_corner),
                             new_edges(per_side, per_end.inside(), per_vertex.on_boundary(capped)),
                             new_faces(per_face.of_degree(same_degree{}),
                                       quads(per_edge).inside(),
                                       per_vertex.inside_or(capped).of_degree(faces_around)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.corners(), [&](auto c) { assoc(c, V) = 1. / 2 * c.v() + 1. / 2 * average(c.f().vertices()); });
        kith::dual_split::connect(r, [this](const auto& v) { return is_capped(v); });
    }
};

/// The number of steps so far.
struct step_count {
    int steps = 0;

    [[nodiscard]] step_count after(const auto&, const auto&) const { return {steps + 1}; }
    [[nodiscard]] step_count of_part(const auto&) const { return *this; }
    void add_part(const step_count& more, const auto&) { steps = std::max(steps, more.steps); }
    void pack(auto& out) const { out.add(steps); }
    void unpack(auto& in) { steps = in.template get<int>(); }
    void for_each_place(const auto&) const {}
    friend bool operator==(const step_count&, const step_count&) = default;
};

/// A scheme that cuts edges into two parts in even steps and into three in odd ones. Its state counts the steps.
struct two_and_three {
    step_count count;

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "two and three",
                                   .faces = kith::face_shape::quads,
                                   .trusted = true,
                                   .reach = [](int rings) { return (rings + 1) / 2 + 1; },
                                   .state = &two_and_three::count,
                                   .ignores_numbers = [](const two_and_three&) { return true; }};
    }
    [[nodiscard]] auto columns() const
    {
        using namespace kith;
        const bool odd = count.steps % 2 != 0, even = not odd;
        return kith::columns(
            new_vertices(per_vertex, per_edge.when(even), per_end.when(odd), per_face.when(even), per_corner.when(odd)),
            new_edges(per_end, per_edge.when(odd), per_corner_side.when(odd), per_side),
            new_faces(quads(per_face.when(odd)), quads(per_side.when(odd)), quads(per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = 3. / 4 * v + 1. / 4 * average(v.neighbors()); });
        if (count.steps % 2 != 0) {
            for_each(coarse.edges(), [&](auto e) {
                assoc(e.org(), e, V) = 3. / 4 * e.org() + 1. / 4 * e.dst();
                assoc(e.dst(), e, V) = 1. / 4 * e.org() + 3. / 4 * e.dst();
            });
            for_each(coarse.corners(),
                     [&](auto c) { assoc(c, V) = 1. / 2 * c.v() + 1. / 2 * average(c.f().vertices()); });
            kith::ternary_split::connect(r);
        } else {
            for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
            for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
            kith::quad_split::connect(r);
        }
    }
};

/// A scheme whose vertex rule is given at run time. The rule may have captures, and so may not be assignable.
template <class Rule>
struct ruled {
    Rule rule;
    step_count count{};

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "ruled",
                                   .trusted = true,
                                   .reach = [](int rings) { return rings / 2 + 1; },
                                   .state = &ruled::count,
                                   .ignores_numbers = [](const ruled&) { return true; }};
    }
    static constexpr auto columns() { return kith::quad_split::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        subdivide(kith::quad_split(),
                  r,
                  kith::at_vertices(rule),
                  kith::at_edges([](auto e) { return average(e.org(), e.dst()); }),
                  kith::at_faces([](auto f) { return average(f.vertices()); }));
    }
};
template <class Rule>
ruled(Rule) -> ruled<Rule>;

} // namespace own_state
