// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/hierarchy/next_in_patches.hpp>
#include <kith/hierarchy/retrieve.hpp>
#include <kith/hierarchy/selection.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/step.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Throws mesh_error unless 0 <= n <= there_are, the number of levels that can be taken back, or made again.
inline void require_between(int n, int there_are, const char* done)
{
    if (n < 0 or n > there_are)
        throw mesh_error(std::to_string(n) + " levels cannot be " + done + ", there are " + std::to_string(there_are) +
                         "; ask for 0 to " + std::to_string(there_are));
}

} // namespace detail

/// The levels of a surface, each made from the one before, of which some are in memory. A level follows from the level
/// before and the scheme there, so it may be dropped and made again.
template <mesh M, scheme Scheme>
class level_store {
    using traits = mesh_traits<M>;
    using level_type = level_of<M>;
    using numbering_type = numbering_of<Scheme, typename level_type::index_type>;

    struct held_mesh {
        /// Makes the mesh in place: meshes of OpenMesh cannot be moved.
        explicit held_mesh(const auto& make_mesh) : mesh(make_mesh()) {}

        M mesh;
        mutable std::optional<level_type> view;
        mutable std::once_flag viewed;
    };

    struct entry {
        explicit entry(Scheme here_scheme) : scheme(std::move(here_scheme)) {}
        void hold(const auto& make_mesh) { here = std::make_unique<held_mesh>(make_mesh); }

        std::unique_ptr<held_mesh> here; ///< none if the level was dropped
        Scheme scheme;                   ///< of the step to the next level
        numbering_type ids;              ///< of the next level
        bool is_moved = false;           ///< its points are no longer those that the step before has made
    };

public:
    /// Takes level 0. Precondition: the mesh is valid and has its edges.
    level_store(M&& control, Scheme scheme) : generation_(generation_of(control))
    {
        levels_.push_back(std::make_unique<entry>(std::move(scheme)));
        levels_[0]->hold([&] { return std::move(control); });
    }

    [[nodiscard]] int depth() const { return depth_; }
    /// Returns how many levels have been undone and may be redone.
    [[nodiscard]] int undone() const { return int(levels_.size()) - 1 - depth_; }
    /// Returns the steps from the control mesh of all to this level, as far as level 0 remembers them.
    [[nodiscard]] int generation(int level) const { return generation_ + level; }
    /// Returns how many of the last levels are kept.
    [[nodiscard]] int kept() const { return kept_; }

    /// Adds n levels, drops those that are kept no longer, and gives up undone levels with their selections. Calls
    /// go_on(i) after the i-th of them. Returns false if a call has returned false. Then, and after an error, all is as
    /// before the call. Errors: those of a step and of go_on.
    template <std::predicate<int> GoOn>
    bool add(int n, const GoOn& go_on)
    {
        const int before = depth_;
        entry& last = *levels_[std::size_t(before)];
        std::vector<std::unique_ptr<entry>> given_up(levels_.size() - 1 - std::size_t(before));
        std::optional<Scheme> scheme; // as it was, where it is to be changed
        if (not given_up.empty())
            scheme.emplace(last.scheme);
        auto ids = std::move(last.ids);
        std::move(levels_.begin() + before + 1, levels_.end(), given_up.begin());
        levels_.resize(std::size_t(before) + 1);
        const auto go_back = [&] {
            levels_.resize(std::size_t(before) + 1);
            depth_ = before;
            if (scheme)
                swap_states(last.scheme, *scheme);
            last.ids = std::move(ids);
            for (auto& each : given_up)
                levels_.push_back(std::move(each)); // there is room, since they were there before
        };
        try {
            if (scheme)
                choose_all(last.scheme, elements(before));
            for (int i = 1; i <= n; ++i) {
                take_step();
                drop_old(before + 1); // the levels of before are kept for go_back
                if (not go_on(i)) {
                    go_back();
                    return false;
                }
            }
        } catch (...) {
            go_back();
            throw;
        }
        drop_old();
        return true;
    }
    /// Adds a level after change(scheme, elements) has changed the scheme of the last level. Errors: those of a step
    /// and of `change`; all is as before the call then.
    template <class Change>
    void add_by(const Change& change)
    {
        change_last([&](Scheme& scheme) {
            change(scheme, elements(depth_));
            take_step();
        });
        drop_old();
    }
    /// Takes back the last n levels. Their schemes stay, and so do points that were moved. Precondition: 0 <= n <=
    /// depth(). Errors: those of `restore`; nothing is taken back then.
    void undo(int n)
    {
        if (levels_[std::size_t(depth_ - n)]->here == nullptr)
            restore(depth_ - n);
        for (; n > 0; --n, --depth_)
            if (not levels_[std::size_t(depth_)]->is_moved)
                levels_[std::size_t(depth_)]->here.reset();
    }
    /// Makes the next n levels again, the same bits. Precondition: 0 <= n <= undone(). Errors: those of a step; all is
    /// as before the call then.
    void redo(int n)
    {
        const int before = depth_;
        try {
            for (; n > 0; --n, ++depth_)
                if (not levels_[std::size_t(depth_ + 1)]->here)
                    make_next(depth_);
        } catch (...) {
            undo(depth_ - before);
            throw;
        }
        drop_old();
    }
    /// Gives up the undone levels. Errors: std::bad_alloc; they stay then.
    void forget_undone()
    {
        if (undone() > 0)
            change_last([&](Scheme& scheme) { choose_all(scheme, elements(depth_)); });
        levels_.resize(std::size_t(depth_) + 1);
    }
    void keep_last(int count)
    {
        kept_ = count;
        drop_old();
    }
    /// Makes a dropped level again, from the last level before it that is in memory. Errors: those of a step; all is as
    /// before then.
    void restore(int level)
    {
        static_cast<void>(entry_at(level));
        int from = level;
        while (not levels_[std::size_t(from)]->here)
            --from;
        int made = from;
        const auto drop_between = [&] {
            if (made != from)
                levels_[std::size_t(made)]->here.reset();
        };
        try {
            for (; made < level; ++made) {
                make_next(made);
                drop_between();
            }
        } catch (...) {
            drop_between();
            throw;
        }
    }

    /// Returns the mesh of a level, to be changed. Precondition: the level is in memory.
    [[nodiscard]] M& mesh(int level) { return levels_[std::size_t(level)]->here->mesh; }
    /// Notes whether the points of a level are no longer those that the step before has made.
    void set_moved(int level, bool is_moved) { levels_[std::size_t(level)]->is_moved = is_moved; }

    /// Returns a level, in memory or not. Errors: mesh_error if there is none.
    [[nodiscard]] const entry& entry_at(int level) const
    {
        if (level < 0 or level > depth())
            throw mesh_error("level " + std::to_string(level) + " does not exist, there are 0 to " +
                             std::to_string(depth()) + "; ask for one of them, or refine() first");
        return *levels_[std::size_t(level)];
    }
    /// Returns a level that is in memory. Errors: mesh_error if it was dropped, or does not exist.
    [[nodiscard]] const entry& at(int level) const
    {
        const entry& result = entry_at(level);
        if (not result.here)
            throw mesh_error("level " + std::to_string(level) + " was dropped, as only the last " +
                             std::to_string(kept_) + " are kept; restore(" + std::to_string(level) +
                             ") makes it again");
        return result;
    }
    [[nodiscard]] const level_type& elements(int level) const
    {
        const auto& here = *at(level).here;
        std::call_once(here.viewed, [&] { here.view.emplace(here.mesh); });
        return *here.view;
    }
    /// Returns the element of a level with this handle. Errors: mesh_error if there is none.
    [[nodiscard]] auto at(int level, typename traits::vertex v) const
    {
        return element_at<vertex<level_type>>(level, v);
    }
    [[nodiscard]] auto at(int level, typename traits::edge e) const { return element_at<edge<level_type>>(level, e); }
    [[nodiscard]] auto at(int level, typename traits::face f) const { return element_at<face<level_type>>(level, f); }

private:
    template <element Element, element_handle Handle>
    Element element_at(int level, Handle x) const
    {
        return Element(require_element(elements(level), at(level).here->mesh, x, level), x);
    }
    /// Chooses all faces: a selection for a level that is given up does not count for the next one.
    static void choose_all([[maybe_unused]] Scheme& scheme, [[maybe_unused]] const level_type& elements)
    {
        if constexpr (selecting_scheme<Scheme, level_type>)
            scheme.select(elements, std::vector<unsigned char>(elements.face_count(), 1));
    }
    /// Calls change(scheme) with the scheme of the last level. After an error the state of the scheme is as before.
    template <class Change>
    void change_last(const Change& change)
    {
        Scheme &scheme = levels_[std::size_t(depth_)]->scheme, before = scheme;
        try {
            change(scheme);
        } catch (...) {
            swap_states(scheme, before);
            throw;
        }
    }
    /// Adds the next level in place of those that were undone. After an error all is as before.
    void take_step()
    {
        levels_.reserve(std::size_t(depth_) + 2);
        entry& last = *levels_[std::size_t(depth_)];
        numbering_type ids;
        auto next = std::make_unique<entry>(last.scheme);
        next->hold([&] { return refined(depth_, ids); });
        advance(next->scheme, elements(depth_), generation(depth_), ids, next->here->mesh);
        last.ids = std::move(ids);
        levels_.resize(std::size_t(depth_) + 1);
        levels_.push_back(std::move(next));
        ++depth_;
    }
    /// Makes the mesh of the level after this one again. After an error all is as before.
    void make_next(int level)
    {
        numbering_type ids;
        levels_[std::size_t(level) + 1]->hold([&] { return refined(level, ids); });
        levels_[std::size_t(level)]->ids = std::move(ids);
    }
    /// Returns the mesh of the next level, and in `ids` the numbering of the step to it.
    M refined(int level, numbering_type& ids) const
    {
        const entry& coarse = *levels_[std::size_t(level)];
        if constexpr (requires { coarse.here->mesh.topology(); }) {
            auto fine = next_in_patches<M, Scheme>(*this, level, ids);
            return fine ? std::move(*fine) : refine_mesh<connect::everything>(coarse.here->mesh, coarse.scheme, ids);
        } else {
            return refine_level_like(coarse.here->mesh, elements(level), coarse.scheme, generation(level), ids);
        }
    }

    /// Drops the levels from `first` on that are kept no longer.
    void drop_old(int first = 1)
    {
        for (int level = first; level <= depth() - kept_; ++level)
            if (not levels_[std::size_t(level)]->is_moved)
                levels_[std::size_t(level)]->here.reset();
    }

    int generation_ = 0, depth_ = 0;
    int kept_ = std::numeric_limits<int>::max();
    std::vector<std::unique_ptr<entry>> levels_;
};

} // namespace kith
