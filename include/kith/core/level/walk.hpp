// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level.hpp"

#include <cstddef>
#include <utility>

namespace kith {

namespace detail {

/// A step: the position of a walk, which `advance` moves from element to element until it is done().
template <walkable_level Level>
struct fan_step {
    typename Level::corner_handle first;
    typename Level::corner_handle here = first;

    // This is the innermost loop of most schemes. Without the attribute g++ makes it a call in rules that walk around a
    // vertex in several places.
    [[gnu::always_inline]] void advance(const Level& level)
    {
        here = level.across(level.prev(here));
        if (here == first)
            here = Level::no_corner;
    }
    [[nodiscard]] bool done() const { return here == Level::no_corner; }
    [[nodiscard]] corner<Level> get(const Level& level) const { return {level, here}; }
};

template <walkable_level Level>
struct spoke_step {
    typename Level::corner_handle first;
    typename Level::corner_handle here = first;
    bool last = false; ///< `here` is the half-edge that comes in along the last boundary edge

    void advance(const Level& level)
    {
        if (last) {
            here = Level::no_corner;
            return;
        }
        const auto p = level.prev(here);
        here = level.across(p);
        if (here == Level::no_corner) {
            here = p;
            last = true;
        } else if (here == first) {
            here = Level::no_corner;
        }
    }
    [[nodiscard]] bool done() const { return here == Level::no_corner; }
    [[nodiscard]] auto get(const Level& level) const
    {
        struct spoke {
            kith::edge<Level> edge;
            vertex<Level> end;
        };
        const corner<Level> c{level, here};
        return spoke{c.next_edge(), last ? c.v() : c.next().v()};
    }
};

/// The number of corners of every face of a level if it is known at compile time, else 0.
template <walkable_level Level>
inline constexpr std::size_t degree_of_all_faces = 0;
template <walkable_level Level>
    requires requires { Level::face_degree; }
inline constexpr std::size_t degree_of_all_faces<Level> = Level::face_degree;

template <walkable_level Level>
struct face_step {
    typename Level::corner_handle first;
    typename Level::corner_handle here = first;

    void advance(const Level& level)
    {
        here = level.next(here);
        if (here == first)
            here = Level::no_corner;
    }
    [[nodiscard]] bool done() const { return here == Level::no_corner; }
    [[nodiscard]] corner<Level> get(const Level& level) const { return {level, here}; }
};
/// A step that counts, so that the loop over a face is unrolled.
template <walkable_level Level>
    requires(degree_of_all_faces<Level> != 0)
struct face_step<Level> {
    typename Level::corner_handle here;
    std::size_t left = degree_of_all_faces<Level>;

    void advance(const Level& level)
    {
        here = level.next(here);
        --left;
    }
    [[nodiscard]] bool done() const { return left == 0; }
    [[nodiscard]] corner<Level> get(const Level& level) const { return {level, here}; }
};

template <class Step, class Keep>
struct filtered_step {
    Step step;
    Keep keep;

    template <walkable_level Level>
    filtered_step(const Level& level, Step first, Keep keep_step) : step(first), keep(keep_step)
    {
        settle(level);
    }
    template <walkable_level Level>
    void advance(const Level& level)
    {
        step.advance(level);
        settle(level);
    }
    template <walkable_level Level>
    void settle(const Level& level)
    {
        while (not step.done() and not keep(level, step))
            step.advance(level);
    }
    [[nodiscard]] bool done() const { return step.done(); }
    template <walkable_level Level>
    [[nodiscard]] auto get(const Level& level) const
    {
        return step.get(level);
    }
};

struct identity {
    template <class T>
    T operator()(T x) const
    {
        return x;
    }
};

} // namespace detail

/// A lazy range over neighbouring elements: it consists of a step and a map, and stores no elements.
template <walkable_level Level, class Step, class Map>
class mapped_walk {
public:
    struct sentinel {};
    class iterator {
    public:
        using value_type = decltype(std::declval<const Map&>()(
            std::declval<const Step&>().get(std::declval<const Level&>())));

        iterator(const mapped_walk& range) : level_(range.level_), step_(range.step_), map_(range.map_) {}
        value_type operator*() const { return map_(step_.get(*level_)); }
        iterator& operator++()
        {
            step_.advance(*level_);
            return *this;
        }
        friend bool operator==(const iterator& i, sentinel) { return i.step_.done(); }

    private:
        const Level* level_;
        Step step_;
        [[no_unique_address]] Map map_;
    };

    mapped_walk(const Level& level, Step step, Map map) : level_(&level), step_(step), map_(map) {}

    [[nodiscard]] iterator begin() const { return *this; }
    [[nodiscard]] sentinel end() const { return {}; }

    /// Returns the same walk with `f` applied to each of its elements.
    template <class F>
    [[nodiscard]] auto map(F f) const
    {
        return kith::mapped_walk(*level_, step_, [f, map = map_](const auto& x) { return f(map(x)); });
    }

    /// Returns the walk over those elements for which `keep` is true.
    template <class Keep>
    [[nodiscard]] auto only(Keep keep) const
    {
        const auto keep_step = [keep, map = map_](const Level& level, const Step& step) {
            return keep(map(step.get(level)));
        };
        return kith::mapped_walk(*level_, detail::filtered_step(*level_, step_, keep_step), map_);
    }

private:
    const Level* level_;
    Step step_;
    [[no_unique_address]] Map map_;
};

/// A walk over the elements that its step returns.
template <walkable_level Level, class Step>
class walk : public mapped_walk<Level, Step, detail::identity> {
public:
    walk(const Level& level, Step step) : mapped_walk<Level, Step, detail::identity>(level, step, {}) {}
};

} // namespace kith
