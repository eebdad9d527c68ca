// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "control_numbers.hpp"
#include "corners_at_vertices.hpp"
#include "global_numbering.hpp"

#include <kith/core/base/error.hpp>
#include <kith/hierarchy/parent_of.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The ancestors and descendants in a whole mesh that no rank holds, over any number of levels. It gives the answers of
/// `hierarchy` from the numbers of elements alone. It holds no elements, so it is the same on all ranks and for all
/// tiles, wherever they lie. Local.
/// Errors of all functions: mesh_error for levels and elements that do not exist.
template <declared_columns Columns>
class global_lineage {
public:
    /// Takes `counts` and `corners` of each level, `steps` from each level to the next, and the numbers of the control
    /// mesh.
    global_lineage(std::vector<global_counts> counts, std::vector<global_numbering<Columns>> steps,
                   std::vector<corners_at_vertices> corners, control_numbers control)
        : counts_(std::move(counts))
        , steps_(std::move(steps))
        , corners_(std::move(corners))
        , control_(std::move(control))
    {
        if (steps_.empty() or control_.marked_edges.empty())
            return;
        const auto marks = std::make_shared<const prefix_sums>(std::move(control_.marked_edges));
        steps_[0].vertices.tell_marks(marks);
        steps_[0].edges.tell_marks(marks);
        steps_[0].faces.tell_marks(marks);
    }

    /// Returns the number of the last level.
    [[nodiscard]] int depth() const { return int(steps_.size()); }
    [[nodiscard]] const global_counts& counts(int level) const
    {
        require_level(level);
        return counts_[std::size_t(level)];
    }

    /// Returns the tuple of elements of level-1 from which an element of `level` was made. Errors: also for level 0.
    /// Cost: O(log n).
    [[nodiscard]] global_tuple origin(int level, const numbered_element& x) const
    {
        require(level, x);
        detail::require_origins(level);
        return origin_of(level, x);
    }
    /// Returns the element of a coarser level from which an element of `level` descends, by the rule of
    /// hierarchy::ancestor. Errors: unless coarser <= level. Cost: O(log n) per level; O(log^2 n) if vertices determine
    /// the degrees of faces.
    [[nodiscard]] numbered_element ancestor(int level, numbered_element x, int coarser) const
    {
        require(level, x);
        require_finer(level, coarser);
        for (; level > coarser; --level) {
            const global_tuple from = origin_of(level, x);
            x = {parent_kind(from.kind),
                 parent_by(from.kind, from.id, [&](global_id corner) { return face_of(level - 1, corner); })};
        }
        return x;
    }
    /// Returns the elements of a finer level whose ancestor is this element of `level`, as ranges of numbers. Errors:
    /// unless level <= finer. Cost: O(log n) per range and level; ranges are few.
    [[nodiscard]] element_ranges descendants(int level, const numbered_element& x, int finer) const
    {
        require(level, x);
        require_finer(finer, level);
        auto ranges = only(x);
        for (; level < finer; ++level)
            ranges = detail::children_by(
                steps_[std::size_t(level)], ranges, [&](global_id face) { return first_corner(level, face); });
        return ranges;
    }

private:
    [[nodiscard]] global_tuple origin_of(int level, const numbered_element& x) const
    {
        const auto& step = steps_[std::size_t(level - 1)];
        switch (x.kind) {
        case element_kind::vertex: return step.vertices.origin(x.number);
        case element_kind::edge: return step.edges.origin(x.number);
        default: return step.faces.origin(x.number);
        }
    }
    /// Returns the first corner of a face, or for the number of faces the number of corners.
    [[nodiscard]] global_id first_corner(int level, global_id face) const
    {
        if (face == counts_[std::size_t(level)].faces)
            return counts_[std::size_t(level)].corners;
        if (level == 0)
            return control_.corners_of_faces.before(face);
        return steps_[std::size_t(level - 1)].faces.first_corner(face, corners_before_tuple(level - 1));
    }
    [[nodiscard]] global_id face_of(int level, global_id corner) const
    {
        if (level == 0)
            return control_.corners_of_faces.holder(corner);
        return steps_[std::size_t(level - 1)].faces.face_of(corner, corners_before_tuple(level - 1));
    }
    /// Returns a function that gives the number of corners before a tuple (f) or (v) of a level.
    [[nodiscard]] auto corners_before_tuple(int level) const
    {
        return [this, level](const global_tuple& tuple) -> global_id {
            if (tuple.kind == tuple_kind::f)
                return first_corner(level, tuple.id);
            return level == 0 ? control_.faces_at_vertices.before(tuple.id)
                              : corners_[std::size_t(level)].before(tuple.id);
        };
    }

    void require_level(int level) const
    {
        if (level < 0 or level > depth())
            throw mesh_error("level " + std::to_string(level) + " does not exist, there are 0 to " +
                             std::to_string(depth()) + "; ask for one of them");
    }
    void require(int level, const numbered_element& x) const
    {
        require_level(level);
        const global_counts& here = counts_[std::size_t(level)];
        const auto [all, one, many] = x.kind == element_kind::vertex ? std::tuple(here.vertices, "vertex", " vertices")
                                      : x.kind == element_kind::edge ? std::tuple(here.edges, "edge", " edges")
                                                                     : std::tuple(here.faces, "face", " faces");
        if (x.number >= all)
            throw mesh_error(one + (" " + std::to_string(x.number)) + " does not exist on level " +
                             std::to_string(level) + ", which has " + std::to_string(all) + many +
                             "; take numbers from tiles of level " + std::to_string(level));
    }
    void require_finer(int finer, int coarser) const
    {
        require_level(finer);
        require_level(coarser);
        detail::require_finer(finer, coarser);
    }

    std::vector<global_counts> counts_;
    std::vector<global_numbering<Columns>> steps_;
    std::vector<corners_at_vertices> corners_;
    control_numbers control_;
};

} // namespace kith
