// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_tree.hpp"
#include "cell_place.hpp"

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <queue>
#include <vector>

namespace kith::detail {

/// Runs body(parts) on threads for `count` searches, as `for_shared_parts` does.
template <class Body>
void for_searches(std::size_t count, const Body& body)
{
    constexpr std::size_t searches_of_part = 16, faces_as_much_work_as_a_search = 50;
    for_shared_parts(count, searches_of_part, is_worth_threads(count * faces_as_much_work_as_a_search), body);
}

/// A best-first search (branch and bound) of the cells of a surface. It takes the cell with the least bound and lets a
/// query solve it; if the query cannot, the cell is cut into parts. The order is the same on every run. A thread may
/// use an object for one query after the other.
///
/// A query has a coordinate system of its own, and these members:
///   to_local(point)          the coordinates of a point
///   bound_of(points)         a bound: no answer in the convex hull of these points is better
///   limit()                  answers beyond it are useless; it falls as answers are found
///   is_tiny(points)          true if their extent does not matter
///   accept(points, place)    takes the place as an answer
///   solve(patch, place)      finds the best answer in a patch, or that there is none; else returns a bound of the
///                            patch, which is then cut
template <class Cells>
class best_first {
    using vector = typename Cells::vector;
    using patch = typename Cells::patch;
    using cell = typename Cells::cell;
    using place = typename Cells::place;

public:
    explicit best_first(const Cells& all) : all_(&all) {}

    /// Searches the surface.
    template <class Query>
    void run(Query& query)
    {
        queue_ = {};
        patches_.clear();
        made_.clear();
        pushed_ = 0;
        if (not all_->tree().nodes().empty())
            add_node(query, 0);
        while (not queue_.empty() and queue_.top().bound <= query.limit()) {
            const item next = queue_.top();
            queue_.pop();
            switch (next.what) {
            case kind::node: search_node(query, all_->tree().nodes()[next.index]); break;
            case kind::net: search_net(query, *next.net); break;
            case kind::patch: search_patch(query, next.index); break;
            }
        }
    }

private:
    enum class kind : unsigned char { node, net, patch };
    struct item {
        double bound;
        std::size_t number; // in the order of arrival
        kind what;
        const cell* net;
        std::size_t index; // of a node or a patch

        friend bool operator<(const item& a, const item& b) // the greatest comes first
        {
            return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
        }
    };
    struct placed_patch {
        place at;
        patch points;
    };

    void push(double bound, kind what, const cell* net, std::size_t index)
    {
        queue_.push({bound, pushed_++, what, net, index});
    }
    template <class Query>
    void add_node(const Query& query, std::size_t number)
    {
        auto corners = all_->tree().nodes()[number].box.corners();
        for (vector& corner : corners)
            corner = query.to_local(corner);
        if (const double bound = query.bound_of(corners); bound <= query.limit())
            push(bound, kind::node, nullptr, number);
    }
    template <class Query>
    void add_cell(const Query& query, const cell& c)
    {
        to_local(query, c);
        const double bound = query.bound_of(local_);
        if (not(bound <= query.limit()))
            return;
        if (c.of != nullptr)
            return push(bound, kind::net, &c, 0);
        patches_.push_back({c.at, {}});
        std::ranges::copy(local_, patches_.back().points.points.begin());
        push(bound, kind::patch, nullptr, patches_.size() - 1);
    }
    template <class Query>
    void search_node(const Query& query, const box_tree::node& node)
    {
        if (node.first == 0)
            return add_cell(query, all_->root(node.item));
        add_node(query, node.first);
        add_node(query, node.second);
    }
    template <class Query>
    void to_local(const Query& query, const cell& c)
    {
        local_.clear();
        for (const vector& p : c.points)
            local_.push_back(query.to_local(p));
    }

    template <class Query>
    void search_net(Query& query, const cell& net)
    {
        to_local(query, net);
        if (query.is_tiny(local_)) {
            query.accept(local_, net.at.at({1. / 3, 1. / 3}));
            return;
        }
        for (const cell& child : all_->children_of(net, made_))
            add_cell(query, child);
    }
    template <class Query>
    void search_patch(Query& query, std::size_t number)
    {
        const placed_patch whole = patches_[number];
        const std::optional<double> bound_of_whole = query.solve(whole.points, whole.at);
        if (not bound_of_whole)
            return;
        const std::size_t side = whole.points.longest_side();
        const auto places = whole.at.halves(side);
        const auto [first, second] = whole.points.halves(side);
        std::size_t slot = number;
        const auto add_half = [&](const place& at, const patch& half) {
            const double bound = std::max(query.bound_of(half.points), *bound_of_whole);
            if (not(bound <= query.limit()))
                return;
            if (slot == patches_.size())
                patches_.emplace_back();
            patches_[slot] = {at, half};
            push(bound, kind::patch, nullptr, slot);
            slot = patches_.size();
        };
        add_half(places[0], first);
        add_half(places[1], second);
    }

    const Cells* all_;
    std::priority_queue<item> queue_;
    std::vector<placed_patch> patches_;
    std::deque<typename Cells::cell_list> made_;
    std::vector<vector> local_;
    std::size_t pushed_ = 0;
};

} // namespace kith::detail
