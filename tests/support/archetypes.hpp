// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/core/level/level_elements.hpp>
#include <kith/core/level/native_level.hpp>
#include <kith/core/mask/hash_value.hpp>
#include <kith/core/mesh/level_sink.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/association/polygon.hpp>
#include <kith/numbering/step/refinement.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <span>
#include <vector>

/// Archetypes: for each concept a class that has the members that the concept requires, and no others. Code that
/// compiles with an archetype requires no more than the concept.
namespace archetypes {

/// A base class that makes its derived classes neither copyable nor movable.
struct stays {
    stays() = default;
    stays(const stays&) = delete;
    stays& operator=(const stays&) = delete;
};

/// A weight, which can be made from a number and divided by another weight, and nothing else.
class weight {
public:
    explicit weight(double value) : value_(value) {}
    explicit weight(int value) : value_(value) {}
    friend weight operator/(const weight& a, const weight& b) { return weight(a.value_ / b.value_); }
    friend double value_of(const weight& w) { return w.value_; }

private:
    double value_;
};

/// A sum of a mask: the hash of the operands and weights that were added up.
class total {
public:
    explicit total(kith::hash_value value) : value_(value) {}
    friend kith::hash_value value_of(const total& t) { return t.value_; }

private:
    kith::hash_value value_;
};

/// A value space whose values are hashes of the operands.
struct space {
    using scalar = weight;
    using sum = total;

    static void add(total& sum, const total& more)
    {
        auto value = value_of(sum);
        kith::affine<kith::hash_value>::add(value, value_of(more));
        sum = total(value);
    }
    static void scale(total& sum, const weight& by)
    {
        auto value = value_of(sum);
        kith::affine<kith::hash_value>::scale(value, value_of(by));
        sum = total(value);
    }
};

/// Returns the hash that stands for a vertex of the coarse level.
inline kith::hash_value name_of(std::size_t vertex)
{
    return {kith::mix_bits(vertex + 1)};
}

/// The values of one step, which are hashes.
class values : public space, stays {
public:
    values() = default;

    template <class Level>
    [[nodiscard]] total coarse(const kith::vertex<Level>& v) const
    {
        return total(name_of(v.index()));
    }
    void allocate(std::size_t size) { made_.resize(size); }
    void assign(std::size_t n, const total& sum) { made_[n] = value_of(sum); }
    [[nodiscard]] total fine(std::size_t n) const { return total(made_[n]); }
    void append(const total& sum) { listed_.push_back(value_of(sum)); }
    [[nodiscard]] std::size_t listed_count() const { return listed_.size(); }
    [[nodiscard]] total listed(std::size_t n) const
    {
        return total(n < made_.size() ? made_[n] : listed_[n - made_.size()]);
    }
    [[nodiscard]] values another() const { return {}; }

    friend const std::vector<kith::hash_value>& made(const values& all) { return all.made_; }

private:
    std::vector<kith::hash_value> made_, listed_;
};

/// A handle, which can only be copied and compared.
template <class Kind>
class handle {
public:
    explicit handle(std::size_t number) : number_(number) {}
    friend bool operator==(const handle&, const handle&) = default;
    friend std::size_t number_of(const handle& h) { return h.number_; }

private:
    std::size_t number_;
};

/// A level with the elements of a native level, under handles of other types.
class level : stays {
    using native = kith::native_level<shapes::point, std::uint32_t, 0>;
    static constexpr std::size_t nowhere = kith::connectivity<std::uint32_t>::none;

public:
    using point_type = shapes::point;
    using index_type = std::uint32_t;
    using vertex_handle = handle<struct vertex_kind>;
    using edge_handle = handle<struct edge_kind>;
    using face_handle = handle<struct face_kind>;
    using corner_handle = handle<struct corner_kind>;

    static constexpr bool parallel = false;
    static inline const corner_handle no_corner{nowhere};

    explicit level(const mesh3d& mesh) : native_(mesh) {}

    [[nodiscard]] std::size_t vertex_count() const { return native_.vertex_count(); }
    [[nodiscard]] std::size_t edge_count() const { return native_.edge_count(); }
    [[nodiscard]] std::size_t face_count() const { return native_.face_count(); }
    [[nodiscard]] std::size_t corner_count() const { return native_.corner_count(); }
    [[nodiscard]] bool is_closed() const { return native_.is_closed(); }

    [[nodiscard]] vertex_handle vertex_at(std::size_t i) const { return vertex_handle(i); }
    [[nodiscard]] edge_handle edge_at(std::size_t i) const { return edge_handle(i); }
    [[nodiscard]] face_handle face_at(std::size_t i) const { return face_handle(i); }
    [[nodiscard]] corner_handle corner_at(std::size_t i) const { return corner_handle(i); }

    [[nodiscard]] std::size_t index(const vertex_handle& v) const { return number_of(v); }
    [[nodiscard]] std::size_t index(const edge_handle& e) const { return number_of(e); }
    [[nodiscard]] std::size_t index(const face_handle& f) const { return number_of(f); }
    [[nodiscard]] std::size_t index(const corner_handle& c) const { return number_of(c); }
    [[nodiscard]] std::size_t halfedge(const corner_handle& c) const { return native_.halfedge(of(c)); }

    [[nodiscard]] corner_handle first(const vertex_handle& v) const { return named(native_.first(of(v))); }
    [[nodiscard]] corner_handle first(const edge_handle& e) const { return named(native_.first(of(e))); }
    [[nodiscard]] corner_handle second(const edge_handle& e) const { return named(native_.second(of(e))); }
    [[nodiscard]] corner_handle first(const face_handle& f) const { return named(native_.first(of(f))); }
    [[nodiscard]] std::size_t degree(const face_handle& f) const { return native_.degree(of(f)); }

    [[nodiscard]] corner_handle next(const corner_handle& c) const { return named(native_.next(of(c))); }
    [[nodiscard]] corner_handle prev(const corner_handle& c) const { return named(native_.prev(of(c))); }
    [[nodiscard]] corner_handle across(const corner_handle& c) const { return named(native_.across(of(c))); }
    [[nodiscard]] vertex_handle vertex_of(const corner_handle& c) const
    {
        return vertex_handle(native_.index(native_.vertex_of(of(c))));
    }
    [[nodiscard]] edge_handle edge_of(const corner_handle& c) const
    {
        return edge_handle(native_.index(native_.edge_of(of(c))));
    }
    [[nodiscard]] face_handle face_of(const corner_handle& c) const
    {
        return face_handle(native_.index(native_.face_of(of(c))));
    }
    [[nodiscard]] const shapes::point& point(const vertex_handle& v) const { return native_.point(of(v)); }

private:
    static native::vertex_handle of(const vertex_handle& v) { return {std::uint32_t(number_of(v))}; }
    static native::edge_handle of(const edge_handle& e) { return {std::uint32_t(number_of(e))}; }
    static native::face_handle of(const face_handle& f) { return {std::uint32_t(number_of(f))}; }
    static native::corner_handle of(const corner_handle& c) { return {std::uint32_t(number_of(c))}; }
    static corner_handle named(native::corner_handle c) { return corner_handle(c.value); }

    native native_;
};

/// A sink, into which a step writes. It records the points, faces and starts that it receives.
class sink : stays {
public:
    using point_type = shapes::point;
    using index_type = std::uint32_t;

    explicit sink(std::size_t vertices) : points_(vertices) {}

    [[nodiscard]] shapes::point* points() { return points_.data(); }
    void set_face(std::uint32_t face, const auto& lines)
    {
        const std::lock_guard lock(writing_);
        for (const auto& line : lines)
            faces_[face].emplace_back(line.vertex, line.halfedge);
    }
    void set_start(std::uint32_t vertex, std::uint32_t leaving)
    {
        const std::lock_guard lock(writing_);
        starts_[vertex] = leaving;
    }
    void finish(int generation) { generation_ = generation; }

    friend const auto& points_of(const sink& s) { return s.points_; }
    friend const auto& faces_of(const sink& s) { return s.faces_; }
    friend const auto& starts_of(const sink& s) { return s.starts_; }
    friend int generation_of(const sink& s) { return s.generation_; }

private:
    std::vector<shapes::point> points_;
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> faces_;
    std::map<std::uint32_t, std::uint32_t> starts_;
    std::mutex writing_;
    int generation_ = -1;
};

/// A scheme of quads around new vertices. It declares no edges, so that they are found by matching.
class scheme {
public:
    explicit scheme(double pull) : pull_(pull) {}
    scheme(const scheme&) = default;
    scheme& operator=(const scheme&) = delete;

    [[nodiscard]] auto columns() const
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
                             kith::new_faces(quads(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& assoc = r.assoc;
        for (const auto f : r.coarse.faces())
            assoc(f, V) = average(f.vertices());
        for_each(r.coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(r.coarse.vertices(),
                 [&](auto v) { assoc(v, V) = (1 - pull_) * v + pull_ * average(assoc(v.faces(), V)); });
        for (const auto c : r.coarse.corners())
            assoc(c, F) = kith::polygon(
                assoc(c.v(), V), assoc(c.next_edge(), V), assoc(c.f(), V), assoc(c.prev_edge(), V));
    }

private:
    double pull_;
};

/// A scheme that can be given a selection of faces to refine.
class selecting_scheme : public scheme {
public:
    using scheme::scheme;

    template <class Level>
    void select(const Level&, std::span<const unsigned char> flags)
    {
        chosen_.assign(flags.begin(), flags.end());
    }
    [[nodiscard]] std::span<const unsigned char> chosen() const { return chosen_; }

private:
    std::vector<unsigned char> chosen_;
};

} // namespace archetypes
