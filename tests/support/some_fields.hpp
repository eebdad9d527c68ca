// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "same_mesh.hpp"

#include <kith/fields/with_fields.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Fields of all kinds for tests, and functions that compare them.
namespace some_fields {

/// A user-defined type of values.
struct label {
    std::int32_t group = -1;
    bool is_marked = false;

    friend bool operator==(const label&, const label&) = default;
};

struct less_one {
    double operator()(double sharpness) const { return std::max(sharpness - 1, 0.); }
};
/// A rule: a face that is born by an edge or a vertex takes the smallest group of the faces around.
struct smallest_around {
    template <class Element>
    label operator()(const Element& x, std::span<const label> values) const
    {
        label result{std::numeric_limits<std::int32_t>::max(), true};
        const auto look_at = [&](const auto& f) { result.group = std::min(result.group, values[f.index()].group); };
        if constexpr (requires { x.lface(); }) {
            look_at(x.lface());
            if (not x.is_boundary())
                look_at(x.rface());
        } else {
            for (const auto& f : x.faces())
                look_at(f);
        }
        return result;
    }
};

/// Returns the scheme with seven fields: material, label, sharpness, marks of vertices, weight, points and texture
/// coordinates with seams.
template <class Scheme, class M>
auto with_some_fields(const Scheme& scheme, const M& mesh)
{
    using namespace kith;
    const level_of<M> level(mesh);
    using point = typename level_of<M>::point_type;
    std::vector<int> material;
    std::vector<label> labels;
    for (const auto f : level.faces()) {
        material.push_back(int(f.index() % 5));
        labels.push_back({std::int32_t(7 * f.index() % 11), f.index() % 2 == 0});
    }
    std::vector<double> sharpness, weight;
    for (const auto e : level.edges())
        sharpness.push_back(double(e.index() % 4) * 0.75);
    storage<bool> marks(level.vertex_count());
    std::vector<point> points;
    for (const auto v : level.vertices()) {
        marks[v.index()] = v.index() % 3 == 0;
        weight.push_back(1 / double(v.index() + 3));
        points.push_back(v.point());
    }
    std::vector<std::array<float, 2>> texture;
    for (const auto c : level.corners()) {
        const bool is_other_chart = c.f().index() % 3 == 0;
        texture.push_back({float(c.v().index()) / 7 + float(is_other_chart), float(c.index()) / 3});
    }
    return with_fields(scheme,
                       on_faces(material),
                       on_faces(labels, from_parent<std::identity, smallest_around>()),
                       on_edges(sharpness, along_edges<less_one, double>{.inherit = less_one(), .born = -1.}),
                       on_vertices(marks, from_vertex{}),
                       on_vertices(weight),
                       on_vertices(points, by_mask{}),
                       on_corners(texture));
}
inline constexpr std::size_t count = 7;

/// Returns the scheme with the same rules, but without values.
template <class Scheme>
auto without_values(const Scheme& scheme)
{
    return kith::detail::scheme_of_part(scheme, kith::part_numbers<std::uint32_t>());
}

/// Returns the first place at which the fields of two schemes of one type differ, or "". `number<field_on>(i)` maps the
/// number i of an element in `ours` to its number in `theirs`.
template <class Scheme, class Number>
std::string difference(const Scheme& ours, const Scheme& theirs, const Number& number)
{
    std::string result;
    const auto look_at = [&]<std::size_t I>() {
        const auto &a = ours.template field<I>(), &b = theirs.template field<I>();
        for (std::size_t i = 0; i < a.size() and result.empty(); ++i) {
            const auto there = number.template operator()<std::remove_cvref_t<decltype(a)>::where>(i);
            if (there >= b.size() or not(a[i] == b[there]))
                result = "field " + std::to_string(I) + " differs at " + std::to_string(there);
        }
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (look_at.template operator()<I>(), ...);
    }(std::make_index_sequence<count>());
    return result;
}
template <class Scheme>
std::string difference(const Scheme& ours, const Scheme& theirs)
{
    std::string sizes;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((ours.template field<I>().size() == theirs.template field<I>().size() ? 0
                                                                               : (sizes += " " + std::to_string(I), 0)),
         ...);
    }(std::make_index_sequence<count>());
    if (not sizes.empty())
        return "sizes differ of fields" + sizes;
    return difference(ours, theirs, []<kith::field_on>(std::size_t i) { return i; });
}

/// Returns the first difference between the fields of a tile and those of the whole mesh, or "".
template <class Tile, class Scheme>
std::string difference_in_tile(const Tile& part, const Scheme& ours, const Scheme& whole)
{
    std::vector<std::uint64_t> corners;
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        for (std::size_t k = 0; k < part.mesh.face(f).size(); ++k)
            corners.push_back(part.corner_id(f, k));
    const std::array sizes{part.mesh.face_count(),
                           part.mesh.face_count(),
                           part.mesh.edge_count(),
                           part.mesh.vertex_count(),
                           part.mesh.vertex_count(),
                           part.mesh.vertex_count(),
                           corners.size()};
    std::string wrong;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((ours.template field<I>().size() == sizes[I] ? 0 : (wrong += " " + std::to_string(I), 0)), ...);
    }(std::make_index_sequence<count>());
    if (not wrong.empty())
        return "sizes in the tile are wrong of fields" + wrong;
    return difference(ours, whole, [&]<kith::field_on Where>(std::size_t i) -> std::size_t {
        if constexpr (Where == kith::field_on::vertices)
            return part.vertex_ids[i];
        else if constexpr (Where == kith::field_on::edges)
            return part.edge_ids[i];
        else if constexpr (Where == kith::field_on::faces)
            return part.face_ids[i];
        else
            return corners[i];
    });
}

} // namespace some_fields
