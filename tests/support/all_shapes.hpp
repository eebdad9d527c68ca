// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace shapes {

/// An edge flipper for triangle meshes. It looks half-edges up in a map, so that many flips of a large shape are fast.
class edge_flips {
public:
    explicit edge_flips(shape& s) : shape_(s)
    {
        for (std::size_t f = 0; f < s.faces.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                face_of_.emplace(std::pair(s.faces[f][i], s.faces[f][(i + 1) % 3]), f);
    }

    /// Flips the first edge of a triangle and returns true. Changes nothing and returns false if the edge lies on the
    /// boundary or the flipped edge exists already.
    bool flip(std::size_t face)
    {
        const std::size_t a = shape_.faces[face][0], b = shape_.faces[face][1], p = shape_.faces[face][2];
        auto* const right = turned_to(b, a);
        if (right == nullptr)
            return false;
        const std::size_t q = (*right)[2];
        if (p == q or turned_to(p, q) != nullptr or turned_to(q, p) != nullptr)
            return false;
        const std::size_t other = face_of_.at({b, a});
        face_of_.erase({a, b});
        face_of_.erase({b, a});
        set(face, {q, p, a}); // the two halves of the diamond a q b p
        set(other, {p, q, b});
        return true;
    }

private:
    /// Returns the triangle with half-edge a -> b, rotated to start at a; null if there is none.
    std::vector<std::size_t>* turned_to(std::size_t a, std::size_t b)
    {
        const auto found = face_of_.find({a, b});
        if (found == face_of_.end())
            return nullptr;
        auto& f = shape_.faces[found->second];
        std::ranges::rotate(f, std::ranges::find(f, a));
        return &f;
    }
    void set(std::size_t face, std::vector<std::size_t> vertices)
    {
        for (std::size_t i = 0; i < 3; ++i)
            face_of_[{vertices[i], vertices[(i + 1) % 3]}] = face;
        shape_.faces[face] = std::move(vertices);
    }

    shape& shape_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of_;
};

/// Returns a triangle mesh with edges flipped at random, so that many valences occur. The seed determines the result.
inline shape with_flips(shape s, std::uint32_t seed, int flips = 200)
{
    std::minstd_rand random(seed);
    edge_flips edges(s);
    for (int i = 0; i < flips; ++i)
        edges.flip(random() % s.faces.size());
    return s;
}

/// Returns a torus of n x n quads, in which the given quad is cut into two triangles.
inline shape torus_with_two_triangles(std::size_t n, std::size_t quad)
{
    shape result = torus(n, n);
    const auto f = result.faces[quad];
    result.faces[quad] = {f[0], f[1], f[2]};
    result.faces.insert(result.faces.begin() + std::ptrdiff_t(quad) + 1, {f[0], f[2], f[3]});
    return result;
}

/// Returns a torus of triangles that has vertices of all valences from 3 to 17.
inline shape torus_of_all_valences()
{
    shape s = triangulated(torus(20, 20));
    edge_flips edges(s);
    const auto faces_at = [&s](std::size_t v, std::size_t place) { // also rotates these faces so that v has this place
        std::vector<std::size_t> result;
        for (std::size_t f = 0; f < s.faces.size(); ++f)
            if (const auto at = std::ranges::find(s.faces[f], v); at != s.faces[f].end()) {
                std::ranges::rotate(s.faces[f], at);
                std::ranges::rotate(s.faces[f], s.faces[f].end() - std::ptrdiff_t(place));
                result.push_back(f);
            }
        return result;
    };
    for (std::size_t valence = 3; valence <= 17; ++valence) {
        const std::size_t i = valence - 2, v = 100 * (i / 4) + 5 * (i % 4); // five edges from the next such vertex
        for (std::size_t now = faces_at(v, 0).size(), turn = 0; now != valence; ++turn) {
            const auto faces = faces_at(v, now < valence ? 2 : 0); // flips an edge opposite to v, or one that ends at v
            edges.flip(faces[5 * turn % faces.size()]);
            now = faces_at(v, 0).size();
        }
    }
    return s;
}

/// Returns the surface with its vertices and faces in random order. The seed determines the result.
inline shape shuffled(const shape& s, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const auto any_order = [&random](auto& list) {
        for (std::size_t i = list.size(); i > 1; --i)
            std::swap(list[i - 1], list[random() % i]);
    };
    std::vector<std::size_t> new_number(s.points.size());
    for (std::size_t v = 0; v < new_number.size(); ++v)
        new_number[v] = v;
    any_order(new_number);
    shape result = s;
    for (std::size_t v = 0; v < s.points.size(); ++v)
        result.points[new_number[v]] = s.points[v];
    for (auto& f : result.faces)
        for (auto& v : f)
            v = new_number[v];
    any_order(result.faces);
    return result;
}

/// Returns the shape after attempts to merge random pairs of neighbouring faces. Faces are merged only if they share
/// one edge and no other vertex, and if both ends of this edge have at least four faces.
inline shape with_joins(shape s, std::uint32_t seed, int joins)
{
    std::minstd_rand random(seed);
    for (int i = 0; i < joins; ++i) {
        const std::size_t one = random() % s.faces.size(), other = random() % s.faces.size();
        auto &f = s.faces[one], &g = s.faces[other];
        const auto in_g = [&g](std::size_t v) { return std::ranges::count(g, v) != 0; };
        if (one == other or std::ranges::count_if(f, in_g) != 2)
            continue;
        for (std::size_t turn = 1; turn < f.size() and not(in_g(f[0]) and in_g(f[1])); ++turn)
            std::ranges::rotate(f, f.begin() + 1);
        if (not(in_g(f[0]) and in_g(f[1])))
            continue;
        std::ranges::rotate(g, std::ranges::find(g, f[1]));
        const auto faces_at = [&s](std::size_t v) {
            return std::ranges::count_if(s.faces, [v](const auto& face) { return std::ranges::count(face, v) != 0; });
        };
        if (g[1] != f[0] or faces_at(f[0]) < 4 or faces_at(f[1]) < 4)
            continue;
        f.insert(f.begin() + 1, g.begin() + 2, g.end());
        s.faces.erase(s.faces.begin() + std::ptrdiff_t(other));
    }
    return s;
}

using named_shape = std::pair<std::string, shape>;

inline std::vector<named_shape> triangle_shapes()
{
    return {{"one triangle", polygon(3)},
            {"tetrahedron", shaken(tetrahedron())},
            {"triangulated cube", shaken(triangulated(cube()))},
            {"triangulated grid", shaken(triangulated(grid()))},
            {"triangulated L", shaken(triangulated(l_shape()))},
            {"triangulated ring", shaken(triangulated(ring()))},
            {"umbrella of 3", shaken(umbrella(3))},
            {"umbrella of 9", shaken(umbrella(9))},
            {"torus of triangles", shaken(triangulated(torus(5, 7)))},
            {"flipped torus", with_flips(shaken(triangulated(torus(5, 7))), 1)},
            {"flipped grid", with_flips(shaken(triangulated(grid(5, 5))), 2)},
            {"two components", both(tetrahedron(), triangulated(grid(1, 2)))}};
}

inline std::vector<named_shape> all_shapes()
{
    auto result = triangle_shapes();
    const std::vector<named_shape> more{
        {"cube", shaken(cube())},
        {"torus", shaken(torus(5, 7))},
        {"grid", shaken(grid())},
        {"L", shaken(l_shape())},
        {"ring", shaken(ring())},
        {"house", shaken(house())},
        {"open house", shaken(open_house())},
        {"joined torus", with_joins(shaken(torus(6, 6)), 3, 100)},
        {"joined grid", with_joins(with_flips(shaken(triangulated(grid(6, 6))), 4), 5, 1000)},
        {"one quad", polygon(4)},
        {"one heptagon", polygon(7)},
        {"valence two", valence_two()},
        {"cube and triangle", both(cube(), polygon(3))}};
    result.insert(result.end(), more.begin(), more.end());
    return result;
}

/// Returns all shapes without an inner vertex of valence two, for schemes that make a face of every vertex.
inline std::vector<named_shape> shapes_without_valence_two()
{
    auto result = all_shapes();
    std::erase_if(result, [](const named_shape& s) { return s.first == "valence two"; });
    return result;
}

} // namespace shapes
