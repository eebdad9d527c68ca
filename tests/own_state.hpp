// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/part/reach.hpp>
#include <kith/step/level_state.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// Schemes of a user's own with state of a level, such as refine, tiles and ranks must hand on.
namespace own_state {

/// Catmull-Clark as a part of another scheme, under a name that nobody knows.
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

/// A number at each face and each vertex of a level, inherited and halved, and how many levels there have been.
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

/// A scheme with two states of its own: Catmull-Clark whose face points are drawn to the vertex of the largest number, and
/// whose vertices stay where their number is large.
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

} // namespace own_state
