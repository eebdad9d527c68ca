// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::detail {

/// A choice of diagonals for quads such that no two edges join the same two vertices. Each pair of opposite corners is
/// a place that at most one quad may take, none if an edge has it; a quad needs one of its two places. This is a graph
/// whose nodes are places and whose edges are quads. Each edge is directed to one of its ends, and each node is reached
/// at most once. So a component must have as many nodes as edges or one more. Quads choose in the order of their
/// vertices and take the place with the smallest one if they may. So the result does not depend on the order of the
/// faces.
class diagonal_choice {
public:
    /// A quad and its two places: `places[0]` of its even and `places[1]` of its odd corners. A place that no other
    /// quad wants is `own`.
    struct quad {
        std::size_t face;
        std::array<std::size_t, 4> vertices; ///< beginning with the smallest one
        int smallest;                        ///< the index of the place with the smallest vertex
        std::array<std::size_t, 2> places{own, own};
        int taken = -1;
    };
    static constexpr std::size_t own = std::numeric_limits<std::size_t>::max();

    diagonal_choice(std::vector<quad> quads, std::vector<bool> place_is_taken)
        : quads_(std::move(quads)), is_taken_(std::move(place_is_taken))
    {
        std::ranges::sort(quads_, {}, &quad::vertices);
        for (quad& q : quads_)
            for (std::size_t& place : q.places)
                if (place == own)
                    place = is_taken_.size(), is_taken_.push_back(false);
        at_place_.resize(is_taken_.size());
        for (std::size_t i = 0; i < quads_.size(); ++i)
            for (const std::size_t place : quads_[i].places)
                at_place_[place].push_back(i);
    }

    /// Returns the quads, each with the place that it has taken. Errors: mesh_error for a quad without a free place.
    /// Cost: O(n log n) for n quads.
    [[nodiscard]] std::vector<quad> solve() &&
    {
        for (std::size_t place = 0; place < is_taken_.size(); ++place)
            if (is_taken_[place])
                leave(place);
        settle();
        take_leaves();
        for (quad& q : quads_)
            if (q.taken < 0) {
                take(q, q.smallest);
                settle();
            }
        return std::move(quads_);
    }

private:
    [[nodiscard]] bool is_open(const quad& q) const { return q.taken < 0; }
    void take(quad& q, int which)
    {
        q.taken = which;
        is_taken_[q.places[which]] = true;
        leave(q.places[which]);
    }
    /// Queues the quads that wanted a place which is now taken: they must take their other place.
    void leave(std::size_t place)
    {
        for (const std::size_t i : at_place_[place])
            if (is_open(quads_[i]))
                pushed_.push_back(i);
    }
    void settle()
    {
        while (not pushed_.empty()) {
            quad& q = quads_[pushed_.back()];
            pushed_.pop_back();
            if (not is_open(q))
                continue;
            const int free = is_taken_[q.places[0]] ? 1 : 0;
            if (is_taken_[q.places[free]])
                refuse(q);
            take(q, free);
        }
    }
    /// Takes places that only one quad wants, in components with as many quads as places. There every place is needed,
    /// so that quad must take it.
    void take_leaves()
    {
        std::vector<std::size_t> parent(is_taken_.size());
        std::iota(parent.begin(), parent.end(), std::size_t(0));
        const auto root = [&](std::size_t place) {
            while (parent[place] != place)
                place = parent[place] = parent[parent[place]];
            return place;
        };
        std::vector<std::size_t> wanted_by(is_taken_.size(), 0);
        for (const quad& q : quads_)
            if (is_open(q)) {
                parent[root(q.places[0])] = root(q.places[1]);
                ++wanted_by[q.places[0]], ++wanted_by[q.places[1]];
            }
        std::vector<std::size_t> places(is_taken_.size(), 0), quads(is_taken_.size(), 0);
        for (std::size_t place = 0; place < is_taken_.size(); ++place)
            ++places[root(place)];
        for (const quad& q : quads_)
            if (is_open(q) and ++quads[root(q.places[0])] > places[root(q.places[0])])
                refuse(q);
        std::vector<std::size_t> leaves;
        const auto note = [&](std::size_t place) {
            if (wanted_by[place] == 1 and quads[root(place)] == places[root(place)])
                leaves.push_back(place);
        };
        for (std::size_t place = 0; place < is_taken_.size(); ++place)
            note(place);
        while (not leaves.empty()) {
            const std::size_t place = leaves.back();
            leaves.pop_back();
            for (const std::size_t i : at_place_[place])
                if (quad& q = quads_[i]; is_open(q)) {
                    const int which = q.places[0] == place ? 0 : 1;
                    q.taken = which; // no other quad wants it
                    is_taken_[place] = true;
                    --wanted_by[q.places[1 - which]];
                    note(q.places[1 - which]);
                }
        }
    }
    [[noreturn]] static void refuse(const quad& q)
    {
        const auto pair = [&](int i) {
            const auto [a, b] = std::minmax(q.vertices[i], q.vertices[i + 2]);
            return std::to_string(a) + "-" + std::to_string(b);
        };
        throw mesh_error(
            "4-8: face " + std::to_string(q.face) + " cannot be cut along a diagonal, since " + pair(0) + " and " +
            pair(1) +
            " are edges already or diagonals of other faces; refine the mesh once by the linear scheme first");
    }

    std::vector<quad> quads_;
    std::vector<bool> is_taken_;
    std::vector<std::vector<std::size_t>> at_place_;
    std::vector<std::size_t> pushed_;
};

/// The places that several quads want, or that an edge has.
class wanted_places {
public:
    struct claim {
        std::size_t face, which, place;
    };

    /// Takes a level of quads. Cost: O(corners log valence).
    template <level Level>
    explicit wanted_places(const Level& level)
    {
        std::vector<other_end> ends;
        for (const auto v : level.vertices()) {
            list_other_ends(v, ends);
            for (auto run = ends.begin(); run != ends.end();) {
                const auto end = std::find_if(run, ends.end(), [&](const auto& x) { return x.vertex != run->vertex; });
                if (end - run > 1)
                    add_place(level, {run, end});
                run = end;
            }
        }
        std::ranges::sort(claims_, {}, [](const claim& x) { return std::pair(x.face, x.which); });
    }

    /// Returns the claims, sorted by the face that wants a place.
    [[nodiscard]] const std::vector<claim>& claims() const { return claims_; }
    /// Returns a flag for each place, true if an edge has it.
    [[nodiscard]] const std::vector<bool>& is_taken() const { return is_taken_; }

private:
    static constexpr std::size_t edge = diagonal_choice::own;
    struct other_end {
        std::size_t vertex, corner; ///< the other end of the diagonal from this corner, or of an edge, which has none
        bool operator<(const other_end& other) const
        {
            return std::pair(vertex, corner) < std::pair(other.vertex, other.corner);
        }
    };

    /// Lists the edges and diagonals from v that lead to a vertex with a larger number.
    template <vertex_element Vertex>
    static void list_other_ends(const Vertex& v, std::vector<other_end>& ends)
    {
        ends.clear();
        const auto add = [&](std::size_t other, std::size_t corner) {
            if (other > v.index())
                ends.push_back({other, corner});
        };
        for (const auto u : v.neighbors())
            add(u.index(), edge);
        for (const auto c : v.corners())
            add(c.next().next().v().index(), c.index());
        std::sort(ends.begin(), ends.end());
    }
    /// Adds one place, with all quads that want it.
    template <level Level>
    void add_place(const Level& level, std::span<const other_end> wanted)
    {
        for (const auto& x : wanted)
            if (x.corner != edge) {
                const auto c = level.corners()[x.corner];
                claims_.push_back({c.f().index(), (x.corner - c.f().first_corner().index()) % 2, is_taken_.size()});
            }
        is_taken_.push_back(wanted.back().corner == edge);
    }

    std::vector<claim> claims_;
    std::vector<bool> is_taken_;
};

/// Returns a flag for each face of a level of quads: true if its diagonal joins its second and fourth corner rather
/// than the first and third. The diagonal is that with the smallest vertex, unless another edge joins the same two
/// vertices. Errors: mesh_error if there is no choice without such edges. Cost: O(corners log valence).
template <level Level>
std::vector<unsigned char> choose_diagonals(const Level& level)
{
    std::vector<unsigned char> is_odd(level.face_count(), 0);
    const auto quad_of = [](const auto& f) {
        diagonal_choice::quad q{.face = f.index(), .vertices = {}, .smallest = 0};
        std::size_t i = 0;
        for (const auto v : f.vertices())
            q.vertices[i++] = v.index();
        const auto smallest = std::ranges::min_element(q.vertices);
        q.smallest = int(smallest - q.vertices.begin()) % 2;
        std::ranges::rotate(q.vertices, smallest);
        return q;
    };
    for (const auto f : level.faces())
        is_odd[f.index()] = quad_of(f).smallest == 1;

    const wanted_places wanted(level);
    if (wanted.claims().empty())
        return is_odd;
    std::vector<diagonal_choice::quad> quads;
    for (const auto& x : wanted.claims()) {
        if (quads.empty() or quads.back().face != x.face)
            quads.push_back(quad_of(level.faces()[x.face]));
        quads.back().places[x.which] = x.place;
    }
    for (const auto& q : diagonal_choice(std::move(quads), wanted.is_taken()).solve())
        is_odd[q.face] = q.taken == 1;
    return is_odd;
}

} // namespace kith::detail
