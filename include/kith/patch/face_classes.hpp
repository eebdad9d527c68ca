// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_walk.hpp"
#include "placed_state.hpp"

#include <kith/association/numbering.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace kith {

/// Which faces of a mesh have alike neighbourhoods, with what the state of the scheme says there, level by level. Around the
/// control faces one walks; from there on the class of a face follows from that of its parent and its place in it, so that one
/// child of each class is looked at.
template <std::unsigned_integral Index>
class face_classes {
public:
    using number = std::uint32_t;
    /// Of faces whose neighbourhood is too large to compare.
    static constexpr number unlike = std::numeric_limits<number>::max();

    explicit face_classes(int rings) : rings_(rings) {}

    [[nodiscard]] std::size_t count() const { return key_.size(); }
    /// The class of each face of the level at hand.
    [[nodiscard]] const storage<number>& of_faces() const { return of_face_; }
    [[nodiscard]] int rings() const { return rings_; }

    /// The share of some faces of the mesh that have alike others among them. Precondition: as look_at. Cost: O(elements), an
    /// eighth of the walks.
    [[nodiscard]] double share_of_alike(const connectivity<Index>& mesh, state_marks<Index> marks) const
    {
        const std::size_t some = std::max(std::size_t(256), mesh.faces / 8);
        face_walk<Index> walk(mesh, rings_);
        std::unordered_map<std::u16string, std::size_t> count;
        std::size_t looked_at = 0, alone = 0;
        const std::size_t step = mesh.faces / some | 1; // odd: of the four children of a face not always the same one
        for (std::size_t f = 0; f < mesh.faces; f += step, ++looked_at) {
            walk.around(f);
            ++count[marks.key(walk)];
        }
        for (const auto& [key, members] : count)
            alone += members == 1;
        return looked_at == 0 ? 0. : 1 - double(alone) / double(looked_at);
    }

    /// Of the faces of a mesh of one degree, which has its edges. Cost: O(faces), that of a walk for each.
    void look_at(const connectivity<Index>& mesh, state_marks<Index> marks)
    {
        face_walk<Index> walk(mesh, rings_);
        of_face_ = storage<number>(mesh.faces);
        for (std::size_t f = 0; f < mesh.faces; ++f)
            of_face_[f] = look_at(walk, marks, f);
    }
    /// Of the next level, which a step has made of the one at hand, whose faces have this degree. Precondition: the faces of a
    /// level give birth to those of the next. Cost: O(faces), and a walk for each kind of child.
    template <level_numbering Numbering>
    void follow(const Numbering& ids, std::size_t degree, const connectivity<Index>& fine, state_marks<Index> marks)
    {
        face_walk<Index> walk(fine, rings_);
        storage<number> next(fine.faces);
        constexpr std::size_t kinds = 7;
        const std::size_t of_kind = 2 * degree, places = kinds * of_kind;
        constexpr number unknown = unlike - 1;
        std::vector<number> child(key_.size() * places, unknown);
        for (std::size_t f = 0; f < fine.faces; ++f) {
            const auto [kind, tuple] = ids.faces.origin(f);
            const std::size_t each = tuples_per_element(kind) * (kind == tuple_kind::f ? 1 : degree);
            const number parent = of_face_[tuple / each];
            if (parent == unlike) {
                next[f] = look_at(walk, marks, f);
                continue;
            }
            number& known = child[places * parent + of_kind * std::size_t(kind) + tuple % each];
            if (known == unknown)
                known = look_at(walk, marks, f);
            next[f] = known;
        }
        of_face_ = std::move(next);
    }

private:
    number look_at(face_walk<Index>& walk, state_marks<Index>& marks, std::size_t face)
    {
        walk.around(face);
        const std::u16string& key = marks.key(walk);
        return key.empty() ? unlike : key_.try_emplace(key, number(key_.size())).first->second;
    }

    int rings_;
    std::unordered_map<std::u16string, number> key_;
    storage<number> of_face_;
};

} // namespace kith
