// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/base/message.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// The relation of a side of a face to its green face. A green face lies beside split ones: it has not been split
/// itself, but has vertices on its sides. In a green polygon these vertices are corners of its own; a green triangle is
/// cut in two.
enum class side_kind : unsigned char {
    whole,       ///< a whole side, as all sides of other faces
    first_half,  ///< the half of a cut side up to the vertex on it
    second_half, ///< the half behind that vertex
    inner,       ///< the side between the two triangles of a cut one
};

/// The faces of a level that are split, and those that keep the next level conforming: red-green refinement, Bank,
/// Sherman & Weiser 1983. Chosen faces are red, that is, split by the rule of the scheme. A face becomes red, too, if
/// at most one of its sides stays whole. A green face becomes red if one of its parts is chosen or a half of its side
/// is cut. It is then split as if it had never been green, so that no face is ever made of a part of a green one. Every
/// other face with a cut side is green. This is the least set with these properties and does not depend on the order.
/// It is state of a level. `Split` defines the parts of the faces.
template <class Split>
class closure {
public:
    /// Returns true if all faces are split and none is green. The level and the next one are then those of the scheme
    /// alone.
    [[nodiscard]] bool is_everything() const { return red_.empty(); }

    /// Returns one flag per face, set for chosen faces; none if all faces are chosen.
    [[nodiscard]] std::span<const unsigned char> chosen() const { return chosen_; }

    template <face_element Face>
    [[nodiscard]] bool is_red(const Face& f) const
    {
        return red_.empty() or red_[f.index()] != 0;
    }
    template <edge_element Edge>
    [[nodiscard]] bool is_cut(const Edge& e) const
    {
        return cut_.empty() or cut_[e.index()] != 0;
    }
    /// Returns the kind of the side from a corner to the next one.
    template <corner_element Corner>
    [[nodiscard]] side_kind side(const Corner& c) const
    {
        return sides_.empty() ? side_kind::whole : sides_[c.index()];
    }
    /// Returns true if the corner is a vertex on a side of a green polygon.
    template <corner_element Corner>
    [[nodiscard]] bool lies_on_side(const Corner& c) const
    {
        return Split::makes_polygons and side(c) == side_kind::second_half;
    }
    /// Returns true if two triangles are a green pair, which is split as one face.
    template <face_element Face>
    [[nodiscard]] bool is_pair(const Face& f, const Face& g) const
    {
        for (const auto& c : f.corners())
            if (side(c) == side_kind::inner and c.across().f() == g)
                return true;
        return false;
    }
    /// Returns a flag for each vertex, set if a face around it is green; no flags if no face is green or
    /// `are_asked_for` is false. Cost: O(level).
    template <level Level>
    [[nodiscard]] std::vector<unsigned char> vertices_of_green(const Level& level, bool are_asked_for) const
    {
        if (sides_.empty() or not are_asked_for)
            return {};
        std::vector<unsigned char> result(level.vertex_count(), 0);
        for (const auto& f : level.faces()) {
            bool is_green = false;
            for (const auto& c : f.corners())
                is_green = is_green or side(c) != side_kind::whole;
            if (is_green)
                for (const auto& c : f.corners())
                    result[c.v().index()] = 1;
        }
        return result;
    }
    /// Returns true if an edge at the vertex is cut. The vertex then follows the scheme's rule; all other vertices
    /// stay.
    template <vertex_element Vertex>
    [[nodiscard]] bool is_moved(const Vertex& v) const
    {
        if (cut_.empty())
            return true;
        for (const auto& e : v.edges())
            if (is_cut(e))
                return true;
        return false;
    }

    /// Chooses faces by a flag for each. Errors: mesh_error unless there is one per face. Cost: O(level).
    template <level Level>
    void select(const Level& level, std::span<const unsigned char> chosen)
    {
        if (chosen.size() != level.face_count())
            throw mesh_error("a selection has " + std::to_string(chosen.size()) + " flags, the level has " +
                             std::to_string(level.face_count()) + " faces; give one flag per face");
        chosen_.assign(chosen.begin(), chosen.end());
        if (std::ranges::find(chosen_, 0) == chosen_.end())
            chosen_.clear();
        close(level);
    }

    /// Throws mesh_error unless this is a closure of the given level. Cost: O(level).
    template <level Level>
    void require_one_each(const Level& level) const
    {
        const auto fits = [](const auto& flags, std::size_t count) { return flags.empty() or flags.size() == count; };
        bool is_of_level = fits(chosen_, level.face_count()) and fits(sides_, level.corner_count());
        if (is_of_level and not sides_.empty())
            for (const auto& c : level.corners())
                is_of_level = is_of_level and side(c) <= side_kind::inner and
                              (side(c) != side_kind::inner or not c.next_edge().is_boundary());
        if (is_of_level) {
            closure again = *this;
            again.close(level);
            is_of_level = again.red_ == red_ and again.cut_ == cut_;
        }
        if (not is_of_level)
            throw mesh_error(
                "the selected faces and the green ones beside them belong to another level; select faces of "
                "this level, which has " +
                std::to_string(level.face_count()) + " faces");
    }

    /// Returns the closure of the next level, with its green faces. All of its faces are chosen.
    template <finished_step Step>
    [[nodiscard]] closure after(const Step& step) const
    {
        closure result;
        if (is_everything())
            return result;
        const auto fine = step.fine();
        std::vector<side_kind> sides(fine.corner_count(), side_kind::whole);
        bool is_green = false;
        Split::for_each_part_of_side(
            step.coarse, step.ids, *this, [&](std::size_t face, std::size_t k, side_kind kind) {
                sides[fine.faces()[face].first_corner().index() + k] = kind;
                is_green = true;
            });
        if (is_green) {
            result.sides_ = std::move(sides);
            result.close(fine);
        }
        return result;
    }

    /// Writes the flags of the faces and edges and the kinds of sides to a message; unpack reads them.
    template <message_writer Out>
    void pack(Out& out) const
    {
        for (const auto* bytes : {&chosen_, &red_, &cut_})
            out.add_array(*bytes);
        out.add_array(sides_);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        for (auto* bytes : {&chosen_, &red_, &cut_})
            *bytes = in.template get_array<std::vector<unsigned char>>();
        sides_ = in.template get_array<std::vector<side_kind>>();
    }

private:
    template <level Level>
    void close(const Level& level)
    {
        red_.clear();
        cut_.clear();
        if (chosen_.empty() and sides_.empty())
            return;
        std::vector<unsigned char> red(level.face_count(), 0), cut(level.edge_count(), 0);
        std::vector<typename Level::index_type> whole_sides(level.face_count(), 0);
        for (const auto& c : level.corners())
            whole_sides[c.f().index()] += side(c) == side_kind::whole;
        std::vector<std::size_t> waiting; // red faces with sides that may have to be cut
        const auto redden = [&](const auto& f) {
            if (red[f.index()] == 0) {
                red[f.index()] = 1;
                waiting.push_back(f.index());
            }
        };
        const auto cut_side = [&](const auto& c) { // for the face on one side of the edge
            if (side(c) != side_kind::whole or --whole_sides[c.f().index()] <= 1)
                redden(c.f());
        };
        for (const auto& f : level.faces()) {
            if (chosen_.empty() or chosen_[f.index()] != 0)
                redden(f);
            while (not waiting.empty()) {
                const auto here = level.faces()[waiting.back()];
                waiting.pop_back();
                for (const auto& c : here.corners()) {
                    const auto e = c.next_edge();
                    if (side(c) == side_kind::inner)
                        redden(c.across().f());
                    if (side(c) != side_kind::whole or cut[e.index()] != 0)
                        continue;
                    cut[e.index()] = 1;
                    cut_side(e.lcorner());
                    if (not e.is_boundary())
                        cut_side(e.rcorner());
                }
            }
        }
        red_ = std::move(red);
        cut_ = std::move(cut);
    }

    std::vector<unsigned char> chosen_, red_, cut_; // by face, face, edge; empty if all are set
    std::vector<side_kind> sides_;                  // by corner; empty if all are whole
};

} // namespace kith
