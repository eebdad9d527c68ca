// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fan_lookup.hpp"
#include "ply_slice.hpp"

#include <kith/mpi/all_to_all.hpp>
#include <kith/mesh/connectivity.hpp>
#include <kith/part/partition.hpp>
#include <kith/tile/known_faces.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::mpi {

/// Which faces and vertices each rank reads: rank r the faces from face[r] up to but without face[r + 1], and the same
/// for vertices. The faces are those of block_partition.
struct slice_ranges {
    std::vector<global_id> face, vertex;

    slice_ranges(global_id vertices, global_id faces, int degree, int ranks)
    {
        const auto parts = std::size_t(ranks);
        for (std::size_t r = 0; r <= parts; ++r) {
            vertex.push_back(vertices / parts * r + std::min<global_id>(r, vertices % parts));
            global_id low = 0;
            for (global_id end = faces; low < end;) { // the first face of a part that is not smaller
                const global_id middle = low + (end - low) / 2;
                const auto part = kith::detail::block_of(
                    middle * global_id(degree), degree, faces * global_id(degree), parts);
                (part < r ? low = middle + 1 : end = middle);
            }
            face.push_back(low);
        }
        face.back() = faces;
    }
    [[nodiscard]] std::size_t rank_of_face(global_id f) const { return rank_of(face, f); }
    [[nodiscard]] std::size_t rank_of_vertex(global_id v) const { return rank_of(vertex, v); }

private:
    static std::size_t rank_of(const std::vector<global_id>& first, global_id x)
    {
        return std::size_t(std::ranges::upper_bound(first, x) - first.begin()) - 1;
    }
};

/// Lets each face start at its smallest vertex, as make_mesh does. Errors: mesh_error for a face that comes to a vertex
/// twice, and for places that are no numbers. Local.
template <class Point>
void start_at_smallest(mesh_slice<Point>& slice)
{
    const auto degree = std::ptrdiff_t(slice.degree);
    for (auto face = slice.corners.begin(); face != slice.corners.end(); face += degree) {
        std::rotate(face, std::min_element(face, face + degree), face + degree);
        auto sorted = std::vector<global_id>(face, face + degree);
        std::ranges::sort(sorted);
        if (std::ranges::adjacent_find(sorted) != sorted.end())
            throw mesh_error(
                "face " +
                std::to_string(slice.first_face + global_id(face - slice.corners.begin()) / global_id(degree)) +
                " comes to a vertex twice; remove the repeated corner or the face");
    }
    for (std::size_t v = 0; v < slice.points.size(); ++v)
        if (not std::ranges::all_of(slice.points[v], [](double x) { return std::isfinite(x); }))
            throw mesh_error("vertex " + std::to_string(slice.first_vertex + v) +
                             ": a coordinate is not a finite number; give it a place");
}

namespace detail {

/// The edges, the fans and the neighbours of the faces that a rank has read, found out from the ranks that look after
/// the vertices. The numbers are those of `match`: edges in the order of (smaller vertex, larger vertex).
template <class Point>
class slice_links {
    using known = known_faces<Point>;

public:
    /// Collective. Errors: phase_error for edges of three faces, faces that are turned, and vertices without a face or
    /// with several fans.
    slice_links(communicator& comm, const std::string& path, const mesh_slice<Point>& slice, const slice_ranges& ranges)
        : comm_(comm), path_(path), slice_(slice), ranges_(ranges), degree_(std::size_t(slice.degree))
    {
        number_edges();
        start_fans();
    }
    [[nodiscard]] global_id edges() const { return edges_; }

    /// Collective: the faces of this rank.
    known own_faces()
    {
        known result;
        std::vector<std::vector<global_id>> questions(ranks());
        for (std::size_t f = 0; f < slice_.corners.size() / degree_; ++f) {
            const global_id face = slice_.first_face + f;
            result.faces.push_back({face, face * degree_, face, degree_});
        }
        for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
            result.corners.push_back({slice_.corners[c], ends_[c].end, ends_[c].has_other});
            questions[ranges_.rank_of_vertex(slice_.corners[c])].push_back(slice_.corners[c]);
        }
        const auto asked = all_to_all(comm_, questions);
        std::vector<std::vector<typename known::vertex>> answers(ranks());
        for (std::size_t r = 0; r < ranks(); ++r)
            for (const global_id v : asked[r])
                answers[r].push_back(facts_[v - slice_.first_vertex]);
        const auto came = all_to_all(comm_, answers);
        std::vector<std::size_t> next(ranks(), 0);
        for (const global_id v : slice_.corners) {
            const std::size_t r = ranges_.rank_of_vertex(v);
            result.vertices.push_back(came[r][next[r]++]);
        }
        return result;
    }

    /// Collective: the faces of other ranks that share a vertex with those of this rank, by rank.
    std::vector<std::vector<global_id>> faces_around()
    {
        std::vector<std::vector<global_id>> questions(ranks());
        auto vertices = slice_.corners;
        std::ranges::sort(vertices);
        vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
        for (const global_id v : vertices)
            questions[ranges_.rank_of_vertex(v)].push_back(v);
        const auto asked = all_to_all(comm_, questions);
        std::vector<std::vector<global_id>> answers(ranks());
        for (std::size_t r = 0; r < ranks(); ++r)
            for (const global_id v : asked[r])
                for (const fan_corner& c : std::ranges::equal_range(fans_, v, {}, &fan_corner::vertex))
                    if (ranges_.rank_of_face(c.corner / degree_) != r)
                        answers[r].push_back(c.corner / degree_);
        std::vector<std::vector<global_id>> result(ranks());
        for (const auto& list : all_to_all(comm_, answers))
            for (const global_id face : list)
                result[ranges_.rank_of_face(face)].push_back(face);
        for (auto& list : result) {
            std::ranges::sort(list);
            list.erase(std::ranges::unique(list).begin(), list.end());
        }
        return result;
    }

private:
    struct half {
        global_id low, high, corner, is_forward;
    };
    struct half_end {
        global_id end, has_other;
    };
    struct fan_corner {
        global_id vertex, corner, next, prev; // the vertices after and before it in the face
    };

    [[nodiscard]] std::size_t ranks() const { return std::size_t(comm_.size()); }
    [[nodiscard]] global_id after(std::size_t corner) const
    {
        return slice_.corners[kith::detail::next_of_alike(corner, degree_)];
    }
    [[nodiscard]] global_id before(std::size_t corner) const
    {
        return slice_.corners[kith::detail::prev_of_alike(corner, degree_)];
    }

    void agree(const std::string& problem) { comm_.agree(problem.empty() ? problem : path_ + ": " + problem); }

    void number_edges()
    {
        std::vector<std::vector<half>> to(ranks());
        std::vector<std::size_t> rank_of;
        for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
            const global_id low = std::min(slice_.corners[c], after(c)), high = std::max(slice_.corners[c], after(c));
            rank_of.push_back(ranges_.rank_of_vertex(low));
            to[rank_of.back()].push_back({low, high, slice_.first_face * degree_ + c, slice_.corners[c] == low});
        }
        const auto came = all_to_all(comm_, to);
        std::vector<std::pair<std::size_t, std::size_t>> order; // places in came, edge by edge
        for (std::size_t r = 0; r < ranks(); ++r)
            for (std::size_t i = 0; i < came[r].size(); ++i)
                order.emplace_back(r, i);
        const auto at = [&](const auto& place) -> const half& { return came[place.first][place.second]; };
        std::ranges::sort(order, {}, [&](const auto& p) { return std::tuple(at(p).low, at(p).high, at(p).corner); });
        std::vector<std::vector<half_end>> answers(ranks());
        for (std::size_t r = 0; r < ranks(); ++r)
            answers[r].resize(came[r].size());
        global_id mine = 0;
        std::string problem;
        for (std::size_t i = 0, end = 0; i < order.size(); i = end, ++mine) {
            const half& first = at(order[i]);
            while (end < order.size() and at(order[end]).low == first.low and at(order[end]).high == first.high)
                ++end;
            const std::string name = "edge " + std::to_string(first.low) + "-" + std::to_string(first.high);
            if (end - i > 2)
                problem = name + ": " + std::to_string(end - i) + " faces; split the edge or remove faces";
            else if (end - i == 2 and first.is_forward == at(order[i + 1]).is_forward)
                problem = name + ": faces " + std::to_string(first.corner / degree_) + " and " +
                          std::to_string(at(order[i + 1]).corner / degree_) +
                          " run through it in the same direction; turn one of them round";
            for (std::size_t j = i; j < end; ++j) // side 0 leaves the smaller vertex, or is the only side there is
                answers[order[j].first][order[j].second] = {
                    2 * mine + (end - i == 2 and at(order[j]).is_forward == 0 ? 1 : 0), end - i == 2};
        }
        agree(problem);
        std::vector<std::uint64_t> edges_of(ranks(), 0);
        edges_of[std::size_t(comm_.rank())] = mine;
        edges_of = comm_.sum(std::move(edges_of));
        std::vector<global_id> first_edge(ranks() + 1, 0);
        for (std::size_t r = 0; r < ranks(); ++r)
            first_edge[r + 1] = first_edge[r] + edges_of[r];
        edges_ = first_edge.back();
        const auto answered = all_to_all(comm_, answers);
        std::vector<std::size_t> next(ranks(), 0);
        for (const std::size_t r : rank_of) {
            const half_end& answer = answered[r][next[r]++];
            ends_.push_back({answer.end + 2 * first_edge[r], answer.has_other});
        }
    }

    void start_fans()
    {
        std::vector<std::vector<fan_corner>> to(ranks());
        for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
            const global_id v = slice_.corners[c];
            to[ranges_.rank_of_vertex(v)].push_back({v, slice_.first_face * degree_ + c, after(c), before(c)});
        }
        for (const auto& list : all_to_all(comm_, to))
            fans_.insert(fans_.end(), list.begin(), list.end());
        std::ranges::sort(fans_, {}, [](const fan_corner& c) { return std::pair(c.vertex, c.corner); });
        std::vector<std::uint64_t> corners_of(ranks(), 0);
        corners_of[std::size_t(comm_.rank())] = fans_.size();
        corners_of = comm_.sum(std::move(corners_of));
        global_id corners_before = 0;
        for (std::size_t r = 0; r < std::size_t(comm_.rank()); ++r)
            corners_before += corners_of[r];
        std::string problem;
        for (std::size_t v = 0; v < slice_.points.size(); ++v) {
            const global_id id = slice_.first_vertex + v;
            const auto fan = std::ranges::equal_range(fans_, id, {}, &fan_corner::vertex);
            const fan_lookup<std::remove_const_t<decltype(fan)>, &fan_corner::prev> at_prev(fan);
            const auto start = start_of(fan, at_prev, problem);
            const global_id unknown = ~global_id(0); // at the boundary the rim tells it
            const bool is_inner = start != fan.end() and at_prev(start->next) != fan.end();
            facts_.push_back({id,
                              is_inner ? start->corner / degree_ : unknown,
                              is_inner ? start->corner % degree_ : unknown,
                              corners_before,
                              slice_.points[v]});
            corners_before += fan.size();
            if (fan.empty())
                problem = "vertex " + std::to_string(id) + ": belongs to no face; remove it or give it a face";
        }
        agree(problem);
    }
    /// As in match: at the boundary the corner without a neighbour clockwise, inside the one that looks at the
    /// smallest.
    template <class Fan>
    static auto start_of(const Fan& fan, const fan_lookup<Fan, &fan_corner::prev>& at_prev, std::string& problem)
    {
        const fan_lookup<Fan, &fan_corner::next> at_next(fan);
        auto start = fan.begin();
        for (auto c = fan.begin(); c != fan.end(); ++c) {
            const bool is_first = at_prev(c->next) == fan.end();
            if (is_first or (at_prev(start->next) != fan.end() and c->next < start->next))
                start = c;
        }
        std::size_t size = 0;
        for (auto c = start; c != fan.end() and size <= fan.size();) {
            ++size;
            c = at_next(c->prev);
            if (c == start)
                break;
        }
        if (size != fan.size())
            problem = "vertex " + std::to_string(fan.begin()->vertex) + ": its " + std::to_string(fan.size()) +
                      " faces form several fans; split the vertex, one copy per fan";
        return start;
    }

    communicator& comm_;
    std::string path_; // for messages
    const mesh_slice<Point>& slice_;
    const slice_ranges& ranges_;
    std::size_t degree_;
    global_id edges_ = 0;
    std::vector<half_end> ends_;                // of the corners of this rank
    std::vector<fan_corner> fans_;              // of the vertices of this rank, vertex by vertex
    std::vector<typename known::vertex> facts_; // of the vertices of this rank
};

} // namespace detail

} // namespace kith::mpi
