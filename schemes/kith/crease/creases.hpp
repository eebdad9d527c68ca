// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/level/lift.hpp>
#include <kith/mask/ring_waves.hpp>
#include <kith/step/level_state.hpp>
#include <kith/step/refinement.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// How sharpness decays from level to level. DeRose, Kass & Truong 1998, section 3 (Chaikin: 3.3).
enum class crease_method : unsigned char { uniform, chaikin };

/// An edge or vertex of this sharpness stays sharp for ever; others are sharp for as many levels as their number says.
inline constexpr double infinitely_sharp = std::numeric_limits<double>::infinity();

/// The sharp edges and vertices of a level; few among many, so they are kept as sorted lists of their dense numbers.
/// Semantics as in OpenSubdiv, with a true infinity in place of "10 or more".
class creases {
public:
    crease_method method = crease_method::uniform;

    creases() = default;
    explicit creases(crease_method method) : method(method) {}

    /// Precondition: sharpness >= 0. Setting anew replaces.
    void sharpen_edge(std::size_t edge, double sharpness) { set(edges_, edge, sharpness); }
    void sharpen_vertex(std::size_t vertex, double sharpness) { set(vertices_, vertex, sharpness); }

    [[nodiscard]] bool empty() const { return edges_.empty() and vertices_.empty(); }
    [[nodiscard]] double of_edge(std::size_t edge) const { return get(edges_, edge); }
    [[nodiscard]] double of_vertex(std::size_t vertex) const { return get(vertices_, vertex); }
    /// Pairs of number and sharpness, by number.
    [[nodiscard]] const auto& edges() const { return edges_; }
    [[nodiscard]] const auto& vertices() const { return vertices_; }

    /// The reach of a scheme with creases whose smooth masks reach one ring: Chaikin's sharpness of an edge, and with it its
    /// point, depends on the edges around both of its ends.
    [[nodiscard]] int reach(int rings) const { return (method == crease_method::chaikin ? rings + 1 : rings) / 2 + 1; }

    /// Boundary edges are sharp by nature.
    template <class Edge>
    [[nodiscard]] double sharpness(const Edge& e) const
    {
        return e.is_boundary() ? infinitely_sharp : of_edge(e.index());
    }

    /// Of a vertex with more than longest_row edges the semi-sharp ones: Chaikin's method looks at all edges for each.
    struct large_fan {
        std::size_t vertex, count;
        double total; ///< of their sharpness
    };
    /// Those at the ends of sharp edges, by vertex; none for a method that does not ask. Cost: O(edges around these ends).
    template <class Level>
    [[nodiscard]] std::vector<large_fan> large_fans(const Level& level) const
    {
        std::vector<large_fan> result;
        if (method != crease_method::chaikin)
            return result;
        std::vector<std::size_t> ends;
        for (const auto& [edge, s] : edges_)
            for (const auto& v : {level.edges()[edge].org(), level.edges()[edge].dst()})
                ends.push_back(v.index());
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        for (const std::size_t end : ends) {
            large_fan fan{end, 0, 0};
            std::size_t edges = 0;
            for (const auto& e : level.vertices()[end].edges()) {
                ++edges;
                if (const double s = sharpness(e); 0 < s and s < infinitely_sharp)
                    fan.total += s, ++fan.count;
            }
            if (edges > longest_row)
                result.push_back(fan);
        }
        return result;
    }

    /// The sharpness of the piece of e that ends at v on the next level; `large` is that of large_fans.
    template <class Vertex, class Edge>
    [[nodiscard]] double child_sharpness(const Vertex& v, const Edge& e, std::span<const large_fan> large = {}) const
    {
        const double s = sharpness(e);
        if (s == infinitely_sharp or s == 0)
            return s;
        double others = 0;
        std::size_t count = 0;
        if (const auto fan = find(large, v.index()); fan != large.end() and fan->vertex == v.index()) {
            others = fan->total - s;
            count = fan->count - 1;
        } else if (method == crease_method::chaikin) {
            for (const auto& other : v.edges())
                if (const double t = sharpness(other); not(other == e) and 0 < t and t < infinitely_sharp)
                    others += t, ++count;
        }
        return std::max((count == 0 ? s : 3. / 4 * s + 1. / 4 * (others / double(count))) - 1, 0.);
    }

    /// The sharp elements of the next level, from the numbering of the step. Cost: O(sharp elements log of them).
    template <class Level, class Numbering>
    [[nodiscard]] creases after(const Level& coarse, const Numbering& ids) const
    {
        creases result(method);
        const auto large = large_fans(coarse);
        for (const auto& [edge, s] : edges_) {
            const auto e = coarse.edges()[edge];
            for (const auto& v : {e.org(), e.dst()})
                if (const double child = child_sharpness(v, e, large); child > 0)
                    result.edges_.emplace_back(ids.edges.template id<tuple_kind::ve>(index_tuple(v, e).value), child);
        }
        for (const auto& [vertex, s] : vertices_)
            if (s > 1)
                result.vertices_.emplace_back(ids.vertices.template id<tuple_kind::v>(vertex), s - 1);
        std::sort(result.edges_.begin(), result.edges_.end());
        return result;
    }

    /// The creases of a part of the level.
    template <class Index>
    [[nodiscard]] creases of_part(const part_numbers<Index>& part) const
    {
        creases result(method);
        const auto take = [](const list& all, std::span<const Index> numbers, list& taken) {
            auto sharp = all.begin();
            for (std::size_t i = 0; i < numbers.size() and sharp != all.end(); ++i) {
                while (sharp != all.end() and sharp->first < numbers[i])
                    ++sharp;
                if (sharp != all.end() and sharp->first == numbers[i])
                    taken.emplace_back(i, sharp->second);
            }
        };
        take(vertices_, part.vertices, result.vertices_);
        take(edges_, part.edges, result.edges_);
        return result;
    }
    /// Takes over the creases of a part. Cost: O(sharp elements log of them).
    template <class Index>
    void add_part(const creases& sharp, const part_numbers<Index>& part)
    {
        const auto add = [](const list& more, std::span<const Index> numbers, list& all) {
            for (const auto& [element, sharpness] : more)
                all.emplace_back(numbers[element], sharpness);
            std::ranges::sort(all);
            const auto twice = std::ranges::unique(all, {}, &list::value_type::first);
            all.erase(twice.begin(), twice.end());
        };
        add(sharp.vertices_, part.vertices, vertices_);
        add(sharp.edges_, part.edges, edges_);
    }
    /// As a message, and from one.
    template <class Out>
    void pack(Out& out) const
    {
        out.add(method);
        for (const list* sharp : {&edges_, &vertices_}) {
            out.add(std::uint64_t(sharp->size()));
            for (const auto& [element, sharpness] : *sharp)
                out.add(std::uint64_t(element)).add(sharpness);
        }
    }
    template <class In>
    void unpack(In& in)
    {
        method = in.template get<crease_method>();
        for (list* sharp : {&edges_, &vertices_}) {
            sharp->clear();
            for (auto left = in.template get<std::uint64_t>(); left > 0; --left) {
                const auto element = in.template get<std::uint64_t>();
                set(*sharp, element, in.template get<double>());
            }
        }
    }

private:
    using list = std::vector<std::pair<std::size_t, double>>;

    static auto find(std::span<const large_fan> fans, std::size_t vertex)
    {
        return std::lower_bound(
            fans.begin(), fans.end(), vertex, [](const large_fan& fan, std::size_t x) { return fan.vertex < x; });
    }
    static auto find(auto& sharp, std::size_t element)
    {
        return std::lower_bound(
            sharp.begin(), sharp.end(), element, [](const auto& entry, std::size_t x) { return entry.first < x; });
    }
    static void set(list& sharp, std::size_t element, double sharpness)
    {
        auto place = find(sharp, element);
        const bool is_there = place != sharp.end() and place->first == element;
        if (sharpness > 0 and is_there)
            place->second = sharpness;
        else if (sharpness > 0)
            sharp.emplace(place, element, sharpness);
        else if (is_there)
            sharp.erase(place);
    }
    static double get(const list& sharp, std::size_t element)
    {
        const auto place = find(sharp, element);
        return place != sharp.end() and place->first == element ? place->second : 0;
    }

    list edges_, vertices_;
};

} // namespace kith
