// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "class_faces.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith::tool {

/// A matching of the vertices of two meshes by the faces around them. It is needed if vertices of one mesh lie within
/// the tolerance of one another. Classes are split as long as the faces around their vertices, written in classes,
/// differ. If vertices are still alike when no class can be split, one vertex is given a partner and splitting
/// continues. On a surface one pair decides for its whole component. So a pair is only undone if it leads to a
/// contradiction at once.
class coinciding_vertices {
public:
    using id = vertex_classes::id;

    /// Joins the two meshes: the numbers of the vertices of b follow those of a.
    coinciding_vertices(std::span<const point3> a, const face_list& faces_a, std::span<const point3> b,
                        const face_list& faces_b, const vertex_classes& classes, double tolerance)
        : points_{a, b}
        , faces_{&faces_a, &faces_b}
        , tolerance_(tolerance)
        , class_of_(classes.of_a)
        , members_(classes.count)
        , waiting_(classes.count, false)
    {
        class_of_.insert(class_of_.end(), classes.of_b.begin(), classes.of_b.end());
        for (std::size_t v = 0; v < class_of_.size(); ++v)
            members_[class_of_[v]].push_back(v);
        for (std::size_t v = 0; v < class_of_.size(); ++v)
            if (is_open(class_of_[v]))
                corners_[v]; // may have no face
        for (int mesh = 0; mesh < 2; ++mesh)
            for (std::size_t f = 0; f < faces_[mesh]->size(); ++f)
                for (std::size_t i = 0; i < (*faces_[mesh])[f].size(); ++i)
                    if (const std::size_t v = number(mesh, (*faces_[mesh])[f][i]); is_open(class_of_[v]))
                        corners_[v].push_back({mesh, f, i});
    }

    /// Returns the largest distance between partners, or nothing if the vertices cannot be paired such that the faces
    /// agree.
    /// Preconditions: as cycles of classes the faces agree; each class has as many vertices of a as of b.
    [[nodiscard]] std::optional<double> match()
    {
        for (std::size_t c = 0; c < members_.size(); ++c)
            wait_for(id(c));
        if (not split_all())
            return std::nullopt;
        for (std::size_t c = 0; c < members_.size(); ++c)
            while (is_open(id(c)))
                if (not pair_by_hand(id(c)))
                    return std::nullopt;
        double result = 0;
        for (const auto& pair : members_)
            result = std::max(result, distance(point(pair[0]), point(pair[1])));
        return result;
    }

private:
    struct corner {
        int mesh;
        std::size_t face;
        std::size_t position;
    };
    struct split_record {
        id from, made;
    };

    [[nodiscard]] std::size_t number(int mesh, std::size_t vertex) const
    {
        return vertex + (mesh == 0 ? 0 : points_[0].size());
    }
    [[nodiscard]] bool in_a(std::size_t v) const { return v < points_[0].size(); }
    [[nodiscard]] const point3& point(std::size_t v) const
    {
        return in_a(v) ? points_[0][v] : points_[1][v - points_[0].size()];
    }
    [[nodiscard]] bool is_open(id c) const { return members_[c].size() > 2; }

    void wait_for(id c)
    {
        if (corners_.contains(members_[c][0]) and not waiting_[c]) {
            waiting_[c] = true;
            queue_.push_back(c);
        }
    }
    /// Returns the faces around a vertex as words of classes, each beginning at the vertex. The words are sorted, so
    /// the order of the faces does not matter.
    [[nodiscard]] std::vector<std::vector<id>> surroundings(std::size_t v) const
    {
        std::vector<std::vector<id>> result;
        for (const auto& [mesh, f, position] : corners_.at(v)) {
            const auto face = (*faces_[mesh])[f];
            auto& word = result.emplace_back();
            for (std::size_t i = 0; i < face.size(); ++i)
                word.push_back(class_of_[number(mesh, face[(position + i) % face.size()])]);
        }
        std::ranges::sort(result);
        return result;
    }
    /// Returns true if a class has as many vertices of a as of b and, if it is one pair, lies within the tolerance.
    [[nodiscard]] bool is_sound(id c) const
    {
        const auto& all = members_[c];
        return 2 * std::size_t(std::ranges::count_if(all, [this](std::size_t v) { return in_a(v); })) == all.size() and
               (is_open(c) or distance(point(all[0]), point(all[1])) <= tolerance_);
    }
    /// Moves some vertices from their class to a new class, and returns the new class.
    id set_apart(id from, const std::vector<std::size_t>& vertices)
    {
        const id made = id(members_.size());
        members_.push_back(vertices);
        waiting_.push_back(false);
        for (const std::size_t v : vertices)
            class_of_[v] = made;
        std::erase_if(members_[from], [&](std::size_t v) { return class_of_[v] != from; });
        log_.push_back({from, made});
        wait_for(from);
        wait_for(made);
        for (const id changed : {from, made})
            for (const std::size_t v : members_[changed])
                for (const auto& [mesh, f, position] : corners_.at(v))
                    for (const std::size_t neighbor : (*faces_[mesh])[f])
                        wait_for(class_of_[number(mesh, neighbor)]);
        return made;
    }
    /// Splits a class by the surroundings of its vertices. Returns false if a and b differ there. A class of one pair
    /// is checked as well, whenever something around it has changed.
    [[nodiscard]] bool split(id c)
    {
        std::map<std::vector<std::vector<id>>, std::vector<std::size_t>> alike;
        for (const std::size_t v : members_[c])
            alike[surroundings(v)].push_back(v);
        for (auto part = std::next(alike.begin()); part != alike.end(); ++part)
            if (not is_sound(set_apart(c, part->second)))
                return false;
        return is_sound(c);
    }
    [[nodiscard]] bool split_all()
    {
        bool sound = true;
        while (not queue_.empty()) {
            const id c = queue_.front();
            queue_.pop_front();
            waiting_[c] = false;
            sound = sound and split(c);
        }
        return sound;
    }
    void take_back(std::size_t log_size)
    {
        for (; log_.size() > log_size; log_.pop_back()) {
            const auto [from, made] = log_.back();
            for (const std::size_t v : members_[made]) {
                class_of_[v] = from;
                members_[from].push_back(v);
            }
            members_.pop_back();
            waiting_.pop_back();
        }
    }
    [[nodiscard]] bool pair_by_hand(id c)
    {
        const std::size_t a = *std::ranges::find_if(members_[c], [this](std::size_t v) { return in_a(v); });
        std::vector<std::size_t> partners;
        for (const std::size_t v : members_[c])
            if (not in_a(v) and distance(point(a), point(v)) <= tolerance_)
                partners.push_back(v);
        std::ranges::sort(partners, {}, [&](std::size_t v) { return std::pair(distance(point(a), point(v)), v); });
        for (const std::size_t partner : partners) {
            const std::size_t before = log_.size();
            set_apart(c, {a, partner});
            if (split_all() and is_sound(c))
                return true;
            take_back(before);
        }
        return false;
    }

    std::array<std::span<const point3>, 2> points_;
    std::array<const face_list*, 2> faces_;
    double tolerance_;
    std::vector<id> class_of_;
    std::vector<std::vector<std::size_t>> members_;
    std::unordered_map<std::size_t, std::vector<corner>> corners_; // of vertices that were not alone in their class
    std::deque<id> queue_;
    std::vector<bool> waiting_;
    std::vector<split_record> log_;
};

} // namespace kith::tool
