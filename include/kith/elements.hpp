// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mask.hpp"

#include <cstddef>
#include <iterator>

namespace kith {

template <class Level> class vertex;
template <class Level> class edge;
template <class Level> class face;
template <class Level> class corner;
template <class Level, class Step> class walk;

namespace detail {
template <class Level> struct fan_step;
template <class Level> struct spoke_step;
template <class Level> struct face_step;
} // namespace detail

/// A vertex in a face, and the half-edge that leaves the vertex inside the face. Thesis 4.1: the tuple (v, f).
template <class Level>
class corner {
public:
    using handle_type = typename Level::corner_handle;

    corner(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    /// The number of the half-edge: 2 * edge + side.
    [[nodiscard]] std::size_t halfedge() const { return level_->halfedge(handle_); }

    [[nodiscard]] vertex<Level> v() const { return {*level_, level_->vertex_of(handle_)}; }
    [[nodiscard]] face<Level> f() const { return {*level_, level_->face_of(handle_)}; }
    [[nodiscard]] corner next() const { return {*level_, level_->next(handle_)}; }
    [[nodiscard]] corner prev() const { return {*level_, level_->prev(handle_)}; }
    /// The edge to the next vertex of the face, and the edge from the previous one, each seen from this face.
    [[nodiscard]] edge<Level> next_edge() const { return {*level_, level_->edge_of(handle_), handle_}; }
    [[nodiscard]] edge<Level> prev_edge() const { return prev().next_edge(); }
    /// Nothing lies across the next edge; as a tuple the corner is at the boundary then.
    [[nodiscard]] bool is_boundary() const { return level_->across(handle_) == Level::no_corner; }
    /// The corner whose half-edge runs the other way along the next edge. Precondition: not is_boundary().
    [[nodiscard]] corner across() const { return {*level_, level_->across(handle_)}; }

    /// The corners around the vertex, counter-clockwise from this one. At the boundary those before it are left out.
    [[nodiscard]] auto fan_from_here() const { return walk(*level_, detail::fan_step<Level>{handle_}); }
    /// The vertices of the face, counter-clockwise from this corner's.
    [[nodiscard]] auto vertices_from_here() const
    {
        return walk(*level_, detail::face_step<Level>{handle_}).map([](const corner& c) { return c.v(); });
    }

    friend bool operator==(const corner& a, const corner& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
};

/// An edge; `lface` lies to the left of org -> dst. A boundary edge has its face on the left.
template <class Level>
class edge {
public:
    using handle_type = typename Level::edge_handle;
    using corner_handle = typename Level::corner_handle;

    edge(const Level& level, handle_type handle) : edge(level, handle, level.first(handle)) {}
    edge(const Level& level, handle_type handle, corner_handle seen_from)
        : level_(&level), handle_(handle), seen_from_(seen_from)
    {
    }

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    [[nodiscard]] bool is_boundary() const { return level_->second(handle_) == Level::no_corner; }

    [[nodiscard]] vertex<Level> org() const { return lcorner().v(); }
    [[nodiscard]] vertex<Level> dst() const { return lcorner().next().v(); }
    [[nodiscard]] face<Level> lface() const { return lcorner().f(); }
    /// Precondition: not is_boundary().
    [[nodiscard]] face<Level> rface() const { return rcorner().f(); }
    /// The corner of org in lface; the corner of dst in rface (precondition: not is_boundary()).
    [[nodiscard]] corner<Level> lcorner() const { return {*level_, left()}; }
    [[nodiscard]] corner<Level> rcorner() const { return {*level_, level_->second(handle_)}; }
    /// The corner through which this edge was reached: from a face, its half-edge in that face; else lcorner().
    [[nodiscard]] corner<Level> seen_from() const { return {*level_, seen_from_}; }

    friend bool operator==(const edge& a, const edge& b) { return a.handle_ == b.handle_; }

private:
    [[nodiscard]] corner_handle left() const { return level_->first(handle_); }

    const Level* level_;
    handle_type handle_;
    corner_handle seen_from_;
};

/// A vertex. Its fan is the cycle of its corners, counter-clockwise; at the boundary from boundary edge to boundary edge.
template <class Level>
class vertex : public mask_base {
public:
    using handle_type = typename Level::vertex_handle;

    vertex(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    [[nodiscard]] decltype(auto) point() const { return level_->point(handle_); }
    [[nodiscard]] bool is_boundary() const { return first_corner().is_boundary(); }

    [[nodiscard]] corner<Level> first_corner() const { return {*level_, level_->first(handle_)}; }
    [[nodiscard]] auto corners() const { return walk(*level_, detail::fan_step<Level>{level_->first(handle_)}); }
    [[nodiscard]] auto faces() const
    {
        return corners().map([](const corner<Level>& c) { return c.f(); });
    }
    /// The edges counter-clockwise, the last boundary edge included; each seen from the face to its left or,
    /// for that last one, from its only face.
    [[nodiscard]] auto edges() const
    {
        return spokes().map([](const auto& spoke) { return spoke.edge; });
    }
    /// The other ends of edges(), in the same order.
    [[nodiscard]] auto neighbors() const
    {
        return spokes().map([](const auto& spoke) { return spoke.end; });
    }
    /// In each face the vertex after the next, counter-clockwise: in quads the one opposite this vertex.
    [[nodiscard]] auto opposites() const
    {
        return corners().map([](const corner<Level>& c) { return c.next().next().v(); });
    }
    /// The number of edges, and the number of faces: one less at the boundary.
    [[nodiscard]] std::size_t valence() const { return face_count() + (is_boundary() ? 1 : 0); }
    [[nodiscard]] std::size_t face_count() const
    {
        std::size_t result = 0;
        for ([[maybe_unused]] const auto& c : corners())
            ++result;
        return result;
    }
    /// The corner before the boundary: its prev_edge() is the last of edges(). Precondition: is_boundary().
    [[nodiscard]] corner<Level> last_corner() const
    {
        auto last = first_corner();
        for (auto p = last.prev(); not p.is_boundary(); p = last.prev())
            last = p.across();
        return last;
    }
    /// The two neighbours along the boundary, first and last of neighbors(). Precondition: is_boundary().
    [[nodiscard]] vertex first_rim() const { return first_corner().next().v(); }
    [[nodiscard]] vertex last_rim() const { return last_corner().prev().v(); }

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        return values.coarse(*this);
    }

    friend bool operator==(const vertex& a, const vertex& b) { return a.handle_ == b.handle_; }

private:
    [[nodiscard]] auto spokes() const { return walk(*level_, detail::spoke_step<Level>{level_->first(handle_)}); }

    const Level* level_;
    handle_type handle_;
};

/// A face; its corners and vertices are counter-clockwise from the first corner.
template <class Level>
class face {
public:
    using handle_type = typename Level::face_handle;

    face(const Level& level, handle_type handle) : level_(&level), handle_(handle) {}

    [[nodiscard]] handle_type handle() const { return handle_; }
    [[nodiscard]] std::size_t index() const { return level_->index(handle_); }
    /// The number of corners.
    [[nodiscard]] std::size_t degree() const { return level_->degree(handle_); }
    /// One of its edges is a boundary edge.
    [[nodiscard]] bool is_boundary() const
    {
        for (const auto& c : corners())
            if (c.is_boundary())
                return true;
        return false;
    }

    [[nodiscard]] corner<Level> first_corner() const { return {*level_, level_->first(handle_)}; }
    [[nodiscard]] auto corners() const { return walk(*level_, detail::face_step<Level>{level_->first(handle_)}); }
    [[nodiscard]] auto vertices() const
    {
        return corners().map([](const corner<Level>& c) { return c.v(); });
    }
    [[nodiscard]] auto edges() const
    {
        return corners().map([](const corner<Level>& c) { return c.next_edge(); });
    }

    friend bool operator==(const face& a, const face& b) { return a.handle_ == b.handle_; }

private:
    const Level* level_;
    handle_type handle_;
};

namespace detail {

/// A step goes from element to element of a walk; it is at the end when its corner is no_corner.
template <class Level>
struct fan_step {
    typename Level::corner_handle first;
    typename Level::corner_handle here = first;

    void advance(const Level& level)
    {
        here = level.across(level.prev(here));
        if (here == first)
            here = Level::no_corner;
    }
    [[nodiscard]] bool done() const { return here == Level::no_corner; }
    [[nodiscard]] corner<Level> get(const Level& level) const { return {level, here}; }
};

template <class Level>
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

/// The number of corners that all faces of a level have when it is known while compiling, else 0.
template <class Level>
inline constexpr std::size_t degree_of_all_faces = 0;
template <class Level>
    requires requires { Level::face_degree; }
inline constexpr std::size_t degree_of_all_faces<Level> = Level::face_degree;

template <class Level>
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
/// Counts, so that the loop over a face is unrolled.
template <class Level>
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

    template <class Level>
    filtered_step(const Level& level, Step first, Keep keep_step) : step(first), keep(keep_step)
    {
        settle(level);
    }
    template <class Level>
    void advance(const Level& level)
    {
        step.advance(level);
        settle(level);
    }
    template <class Level>
    void settle(const Level& level)
    {
        while (not step.done() and not keep(level, step))
            step.advance(level);
    }
    [[nodiscard]] bool done() const { return step.done(); }
    template <class Level>
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

/// A lazy range over neighbouring elements: a step and a map, no storage.
template <class Level, class Step, class Map>
class mapped_walk {
public:
    struct sentinel {};
    class iterator {
    public:
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::input_iterator_tag;
        using value_type = decltype(std::declval<const Map&>()(
            std::declval<const Step&>().get(std::declval<const Level&>())));

        iterator(const mapped_walk& range) : range_(&range), step_(range.step_) {}
        value_type operator*() const { return range_->map_(step_.get(*range_->level_)); }
        iterator& operator++()
        {
            step_.advance(*range_->level_);
            return *this;
        }
        void operator++(int) { ++*this; }
        friend bool operator==(const iterator& i, sentinel) { return i.step_.done(); }

    private:
        const mapped_walk* range_;
        Step step_;
    };

    mapped_walk(const Level& level, Step step, Map map) : level_(&level), step_(step), map_(map) {}

    [[nodiscard]] iterator begin() const { return *this; }
    [[nodiscard]] sentinel end() const { return {}; }

    /// The same walk with `f` applied to what it gives.
    template <class F>
    [[nodiscard]] auto map(F f) const
    {
        return kith::mapped_walk(*level_, step_, [f, map = map_](const auto& x) { return f(map(x)); });
    }

    /// The same walk without what `keep` refuses.
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

template <class Level, class Step>
class walk : public mapped_walk<Level, Step, detail::identity> {
public:
    walk(const Level& level, Step step) : mapped_walk<Level, Step, detail::identity>(level, step, {}) {}
};

/// All elements of one kind of a level, for loops: `for (auto v : coarse.vertices())` or `for_each`.
template <class Level, class Element>
class all_elements {
public:
    class iterator {
    public:
        using difference_type = std::ptrdiff_t;
        using value_type = Element;
        iterator(const Level& level, std::size_t i) : level_(&level), i_(i) {}
        Element operator*() const { return all_elements::at(*level_, i_); }
        iterator& operator++()
        {
            ++i_;
            return *this;
        }
        void operator++(int) { ++i_; }
        friend bool operator==(const iterator& a, const iterator& b) { return a.i_ == b.i_; }

    private:
        const Level* level_;
        std::size_t i_;
    };

    all_elements(const Level& level, std::size_t size) : level_(&level), size_(size) {}

    [[nodiscard]] const Level& level() const { return *level_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Element operator[](std::size_t i) const { return at(*level_, i); }
    [[nodiscard]] iterator begin() const { return {*level_, 0}; }
    [[nodiscard]] iterator end() const { return {*level_, size_}; }

private:
    static Element at(const Level& level, std::size_t i)
    {
        if constexpr (std::same_as<Element, vertex<Level>>)
            return {level, level.vertex_at(i)};
        else if constexpr (std::same_as<Element, edge<Level>>)
            return {level, level.edge_at(i)};
        else if constexpr (std::same_as<Element, face<Level>>)
            return {level, level.face_at(i)};
        else
            return {level, level.corner_at(i)};
    }

    const Level* level_;
    std::size_t size_;
};

/// A level with its element ranges: what a scheme calls `coarse`.
template <class Level>
class level_elements : public Level {
public:
    using Level::Level;
    using vertex_type = vertex<level_elements>;
    using edge_type = edge<level_elements>;
    using face_type = face<level_elements>;
    using corner_type = corner<level_elements>;

    [[nodiscard]] auto vertices() const
    {
        return all_elements<level_elements, vertex_type>(*this, this->vertex_count());
    }
    [[nodiscard]] auto edges() const { return all_elements<level_elements, edge_type>(*this, this->edge_count()); }
    [[nodiscard]] auto faces() const { return all_elements<level_elements, face_type>(*this, this->face_count()); }
    [[nodiscard]] auto corners() const
    {
        return all_elements<level_elements, corner_type>(*this, this->corner_count());
    }
};

} // namespace kith
