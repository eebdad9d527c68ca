// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fan_lookup.hpp"
#include "slice_ranges.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/mpi/all_to_all.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/tiles/refine/known_faces.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::mpi {

namespace detail {

/// The edges, fans and neighbours of the faces that a rank has read. They are computed on the ranks that are
/// responsible for the vertices. The numbers are those of `match`: edges in the order of (smaller vertex, larger
/// vertex).
template <class Point>
class slice_links {
    using known = known_faces<Point>;

public:
    /// Computes the links. Collective. Errors: phase_error for edges of three or more faces, for faces of opposite
    /// orientation, and for vertices without a face or with several fans.
    slice_links(communicator& comm, const std::string& path, const mesh_slice<Point>& slice, const slice_ranges& ranges)
        : comm_(comm), path_(path), slice_(slice), ranges_(ranges), degree_(std::size_t(slice.degree))
    {
        number_edges();
        start_fans();
    }
    [[nodiscard]] global_id edges() const { return edges_; }

    /// Returns the faces of this rank. Collective.
    known own_faces()
    {
        known result;
        const auto asked = all_to_all(comm_, [&] {
            std::vector<std::vector<global_id>> questions(ranks());
            for (std::size_t f = 0; f < slice_.corners.size() / degree_; ++f) {
                const global_id face = slice_.first_face + f;
                result.faces.push_back({face, face * degree_, face, degree_});
            }
            for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
                result.corners.push_back({slice_.corners[c], ends_[c].end, ends_[c].has_other});
                questions[ranges_.rank_of_vertex(slice_.corners[c])].push_back(slice_.corners[c]);
            }
            return questions;
        });
        const auto came = all_to_all(comm_, [&] {
            std::vector<std::vector<typename known::vertex>> answers(ranks());
            for (std::size_t r = 0; r < ranks(); ++r)
                for (const global_id v : asked[r])
                    answers[r].push_back(facts_[v - slice_.first_vertex]);
            return answers;
        });
        collective_phase(comm_, [&] {
            std::vector<std::size_t> next(ranks(), 0);
            for (const global_id v : slice_.corners) {
                const std::size_t r = ranges_.rank_of_vertex(v);
                result.vertices.push_back(came[r][next[r]++]);
            }
        });
        return result;
    }

    /// Returns the faces of other ranks that share a vertex with the faces of this rank, by rank. Collective.
    std::vector<std::vector<global_id>> faces_around()
    {
        const auto asked = all_to_all(comm_, [&] {
            std::vector<std::vector<global_id>> questions(ranks());
            auto vertices = slice_.corners;
            std::ranges::sort(vertices);
            vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
            for (const global_id v : vertices)
                questions[ranges_.rank_of_vertex(v)].push_back(v);
            return questions;
        });
        const auto came = all_to_all(comm_, [&] {
            std::vector<std::vector<global_id>> answers(ranks());
            for (std::size_t r = 0; r < ranks(); ++r)
                for (const global_id v : asked[r])
                    for (const fan_corner& c : std::ranges::equal_range(fans_, v, {}, &fan_corner::vertex))
                        if (ranges_.rank_of_face(c.corner / degree_) != r)
                            answers[r].push_back(c.corner / degree_);
            return answers;
        });
        return collective_phase(comm_, [&] {
            std::vector<std::vector<global_id>> result(ranks());
            for (const auto& list : came)
                for (const global_id face : list)
                    result[ranges_.rank_of_face(face)].push_back(face);
            for (auto& list : result) {
                std::ranges::sort(list);
                list.erase(std::ranges::unique(list).begin(), list.end());
            }
            return result;
        });
    }

private:
    struct half {
        global_id low, high, corner, is_forward;
    };
    struct half_end {
        global_id end, has_other;
    };
    struct fan_corner {
        global_id vertex, corner, next, prev; // the vertices after and before `vertex` in the face
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

    /// Returns the sum of a number over the ranks before this one, and over all ranks. Collective.
    std::pair<global_id, global_id> before_and_all(global_id mine)
    {
        auto of_rank = collective_phase(comm_, [&] { return std::vector<std::uint64_t>(ranks(), 0); });
        of_rank[std::size_t(comm_.rank())] = mine;
        of_rank = comm_.sum(std::move(of_rank));
        const auto here = of_rank.begin() + comm_.rank();
        const global_id before = std::accumulate(of_rank.begin(), here, global_id(0));
        return {before, std::accumulate(here, of_rank.end(), before)};
    }
    [[noreturn]] void refuse(const std::string& problem) const { throw mesh_error(path_ + ": " + problem); }

    void number_edges()
    {
        std::vector<std::size_t> rank_of;
        const auto came = all_to_all(comm_, [&] {
            std::vector<std::vector<half>> to(ranks());
            for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
                const global_id here = slice_.corners[c], low = std::min(here, after(c)),
                                high = std::max(here, after(c));
                rank_of.push_back(ranges_.rank_of_vertex(low));
                to[rank_of.back()].push_back({low, high, slice_.first_face * degree_ + c, here == low});
            }
            return to;
        });
        global_id mine = 0;
        auto answers = collective_phase(comm_, [&] {
            std::vector<std::vector<half_end>> result(ranks());
            for (std::size_t r = 0; r < ranks(); ++r)
                result[r].resize(came[r].size());
            mine = number_edges_among(came, result);
            return result;
        });
        const auto [first_edge, all] = before_and_all(mine);
        edges_ = all;
        for (auto& list : answers)
            for (half_end& answer : list)
                answer.end += 2 * first_edge;
        const auto answered = all_to_all(comm_, std::move(answers));
        collective_phase(comm_, [&] {
            std::vector<std::size_t> next(ranks(), 0);
            for (const std::size_t r : rank_of)
                ends_.push_back(answered[r][next[r]++]);
        });
    }
    /// Numbers the edges of these half-edges from 0 on, and returns their count. Errors: mesh_error.
    global_id number_edges_among(const std::vector<std::vector<half>>& came,
                                 std::vector<std::vector<half_end>>& answers)
    {
        std::vector<std::pair<std::size_t, std::size_t>> order; // places in came, edge by edge
        for (std::size_t r = 0; r < ranks(); ++r)
            for (std::size_t i = 0; i < came[r].size(); ++i)
                order.emplace_back(r, i);
        const auto at = [&](const auto& place) -> const half& { return came[place.first][place.second]; };
        std::ranges::sort(order, {}, [&](const auto& p) { return std::tuple(at(p).low, at(p).high, at(p).corner); });
        global_id edges = 0;
        for (std::size_t i = 0, end = 0; i < order.size(); i = end, ++edges) {
            const half& first = at(order[i]);
            while (end < order.size() and at(order[end]).low == first.low and at(order[end]).high == first.high)
                ++end;
            const auto name = [&] { return "edge " + std::to_string(first.low) + "-" + std::to_string(first.high); };
            if (end - i > 2)
                refuse(name() + ": " + std::to_string(end - i) + " faces; split the edge or remove faces");
            if (end - i == 2 and first.is_forward == at(order[i + 1]).is_forward)
                refuse(name() + ": faces " + std::to_string(first.corner / degree_) + " and " +
                       std::to_string(at(order[i + 1]).corner / degree_) +
                       " run through it in the same direction; reverse one of them");
            for (std::size_t j = i; j < end; ++j) // side 0 starts at the smaller vertex, or is the only side
                answers[order[j].first][order[j].second] = {
                    2 * edges + (end - i == 2 and at(order[j]).is_forward == 0 ? 1 : 0), end - i == 2};
        }
        return edges;
    }

    void start_fans()
    {
        const auto came = all_to_all(comm_, [&] {
            std::vector<std::vector<fan_corner>> to(ranks());
            for (std::size_t c = 0; c < slice_.corners.size(); ++c) {
                const global_id v = slice_.corners[c];
                to[ranges_.rank_of_vertex(v)].push_back({v, slice_.first_face * degree_ + c, after(c), before(c)});
            }
            return to;
        });
        collective_phase(comm_, [&] {
            for (const auto& list : came)
                fans_.insert(fans_.end(), list.begin(), list.end());
            std::ranges::sort(fans_, {}, [](const fan_corner& c) { return std::pair(c.vertex, c.corner); });
        });
        global_id corners_before = before_and_all(fans_.size()).first;
        collective_phase(comm_, [&] {
            for (std::size_t v = 0; v < slice_.points.size(); ++v) {
                const global_id id = slice_.first_vertex + v;
                const auto fan = std::ranges::equal_range(fans_, id, {}, &fan_corner::vertex);
                if (fan.empty())
                    refuse("vertex " + std::to_string(id) + ": belongs to no face; remove it or give it a face");
                const fan_lookup<std::remove_const_t<decltype(fan)>, &fan_corner::prev> at_prev(fan);
                const auto start = start_of(fan, at_prev);
                const global_id unknown = ~global_id(0); // at the boundary the start follows from the boundary edges
                const bool is_inner = at_prev(start->next) != fan.end();
                facts_.push_back({id,
                                  is_inner ? start->corner / degree_ : unknown,
                                  is_inner ? start->corner % degree_ : unknown,
                                  corners_before,
                                  slice_.points[v]});
                corners_before += fan.size();
            }
        });
    }
    /// Returns the first corner of a fan, as `match` chooses it: at the boundary the corner without a clockwise
    /// neighbour, inside the corner with the smallest next vertex. Errors: mesh_error for several fans.
    template <class Fan>
    auto start_of(const Fan& fan, const fan_lookup<Fan, &fan_corner::prev>& at_prev) const
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
            refuse("vertex " + std::to_string(fan.begin()->vertex) + ": its " + std::to_string(fan.size()) +
                   " faces form several fans; split the vertex, one copy per fan");
        return start;
    }

    communicator& comm_;
    std::string path_; // for messages
    const mesh_slice<Point>& slice_;
    const slice_ranges& ranges_;
    std::size_t degree_;
    global_id edges_ = 0;
    std::vector<half_end> ends_;                // of the corners of this rank
    std::vector<fan_corner> fans_;              // of the vertices of this rank, grouped by vertex
    std::vector<typename known::vertex> facts_; // of the vertices of this rank
};

} // namespace detail

} // namespace kith::mpi
