// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/message.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/core/mask/ring_waves.hpp>
#include <kith/fields/sparse_values.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/numbering/step/refinement.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// The method by which sharpness decays from level to level. DeRose, Kass & Truong 1998, section 3 (Chaikin: 3.3).
enum class crease_method : unsigned char { uniform, chaikin };

/// The sharpness of an edge or vertex that stays sharp for ever. Others stay sharp for as many levels as their
/// sharpness.
inline constexpr double infinitely_sharp = std::numeric_limits<double>::infinity();

/// The sharp edges and vertices of a level. They are few, so they are stored as sorted lists of dense numbers.
/// Semantics as in OpenSubdiv, with a true infinity in place of "10 or more".
class creases {
public:
    crease_method method = crease_method::uniform;

    creases() = default;
    explicit creases(crease_method method) : method(method) {}
    friend bool operator==(const creases&, const creases&) = default;

    /// Sets the sharpness of an edge and replaces an earlier one. Precondition: sharpness >= 0.
    void sharpen_edge(std::size_t edge, double sharpness) { edges_.set(edge, sharpness > 0 ? sharpness : 0); }
    void sharpen_vertex(std::size_t vertex, double sharpness) { vertices_.set(vertex, sharpness > 0 ? sharpness : 0); }

    [[nodiscard]] bool empty() const { return edges_.empty() and vertices_.empty(); }
    [[nodiscard]] double of_edge(std::size_t edge) const { return edges_[edge]; }
    [[nodiscard]] double of_vertex(std::size_t vertex) const { return vertices_[vertex]; }
    /// Returns pairs of number and sharpness, sorted by number.
    [[nodiscard]] const auto& edges() const { return edges_.list(); }
    [[nodiscard]] const auto& vertices() const { return vertices_.list(); }

    /// Returns the reach of a scheme with creases whose smooth masks reach one ring. Chaikin's method reaches further:
    /// the sharpness of an edge, and with it its point, depends on the edges around both of its ends.
    [[nodiscard]] int reach(int rings) const { return (method == crease_method::chaikin ? rings + 1 : rings) / 2 + 1; }

    /// Returns the sharpness of an edge; boundary edges are infinitely sharp.
    template <edge_element Edge>
    [[nodiscard]] double sharpness(const Edge& e) const
    {
        return e.is_boundary() ? infinitely_sharp : of_edge(e.index());
    }

    /// The semi-sharp edges of a vertex with more than longest_row edges. They are summed once, since Chaikin's method
    /// reads all edges of a vertex for each of them.
    struct large_fan {
        std::size_t vertex, count;
        double total; ///< sum of their sharpness
    };
    /// Returns the large fans at the ends of sharp edges, by vertex; none for a method that does not need them. Cost:
    /// O(edges around these ends).
    template <level Level>
    [[nodiscard]] std::vector<large_fan> large_fans(const Level& level) const
    {
        std::vector<large_fan> result;
        if (method != crease_method::chaikin)
            return result;
        std::vector<std::size_t> ends;
        for (const auto& [edge, s] : edges())
            for (const auto& v : {level.edges()[edge].org(), level.edges()[edge].dst()})
                ends.push_back(v.index());
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        for (const std::size_t end : ends) {
            large_fan fan{end, 0, 0};
            std::size_t edges = 0;
            for (const auto& e : level.vertices()[end].edges()) {
                ++edges;
                if (const double s = sharpness(e); 0 < s and s < infinitely_sharp)
                    fan.total += s, ++fan.count;
            }
            if (edges > longest_row)
                result.push_back(fan);
        }
        return result;
    }

    /// Returns the sharpness, on the next level, of the half of e that ends at v. `large` is the result of large_fans.
    template <vertex_element Vertex, edge_element Edge>
    [[nodiscard]] double child_sharpness(const Vertex& v, const Edge& e, std::span<const large_fan> large = {}) const
    {
        const double s = sharpness(e);
        if (s == infinitely_sharp or s == 0)
            return s;
        double others = 0;
        std::size_t count = 0;
        if (const large_fan* fan = find(large, v.index())) {
            others = fan->total - s;
            count = fan->count - 1;
        } else if (method == crease_method::chaikin) {
            for (const auto& other : v.edges())
                if (const double t = sharpness(other); not(other == e) and 0 < t and t < infinitely_sharp)
                    others += t, ++count;
        }
        return std::max((count == 0 ? s : 3. / 4 * s + 1. / 4 * (others / double(count))) - 1, 0.);
    }

    /// Throws mesh_error for a sharp element that the level does not have.
    template <level Level>
    void require_one_each(const Level& level) const
    {
        require_below(edges(), level.edge_count(), "edge");
        require_below(vertices(), level.vertex_count(), "vertex");
    }

    /// Returns the sharp elements of the next level, from the numbering of the step. Elements that the step keeps, as
    /// `selected` does beside the faces that it splits, keep their sharpness. Cost: O(s log s) for s sharp elements,
    /// and O(edges around sharp vertices).
    template <level Level, level_numbering Numbering>
    [[nodiscard]] creases after(const Level& coarse, const Numbering& ids) const
    {
        creases result(method);
        const auto large = large_fans(coarse);
        for (const auto& [edge, s] : edges()) {
            const auto e = coarse.edges()[edge];
            if (is_cut(ids, e)) {
                for (const auto& v : {e.org(), e.dst()})
                    // Boundary edges are sharp anyway; a sharpness given to one decays by one per level.
                    if (const double child = e.is_boundary() ? s - 1 : child_sharpness(v, e, large); child > 0)
                        result.edges_.append(ids.edges.template id<tuple_kind::ve>(index_tuple(v, e).value), child);
            } else if constexpr (keeps_edges<Numbering>) {
                if (const auto kept = ids.edges.template id<tuple_kind::e>(edge); kept != ids.edges.none)
                    result.edges_.append(kept, s);
            }
        }
        for (const auto& [vertex, s] : vertices())
            if (const double next = is_moved(ids, coarse.vertices()[vertex]) ? s - 1 : s; next > 0)
                result.vertices_.append(ids.vertices.template id<tuple_kind::v>(vertex), next);
        result.edges_.sort();
        return result;
    }

    /// Calls f(tuple_kind, number, sharpness) for each sharp element.
    template <class F>
    void for_each_place(const F& f) const
    {
        for (const auto& [edge, sharpness] : edges())
            f(tuple_kind::e, edge, sharpness);
        for (const auto& [vertex, sharpness] : vertices())
            f(tuple_kind::v, vertex, sharpness);
    }

    /// Returns the creases of a part of the level.
    template <std::unsigned_integral Index>
    [[nodiscard]] creases of_part(const part_numbers<Index>& part) const
    {
        creases result(method);
        result.vertices_ = vertices_.of_part(part.vertices);
        result.edges_ = edges_.of_part(part.edges);
        return result;
    }
    /// Adds the creases of a part. Cost: O(s log s) for s sharp elements.
    template <std::unsigned_integral Index>
    void add_part(const creases& sharp, const part_numbers<Index>& part)
    {
        vertices_.add_part(sharp.vertices_, part.vertices);
        edges_.add_part(sharp.edges_, part.edges);
    }
    /// Writes the creases to a message; unpack reads them.
    template <message_writer Out>
    void pack(Out& out) const
    {
        out.add(method);
        edges_.pack(out);
        vertices_.pack(out);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        method = in.template get<crease_method>();
        edges_.unpack(in);
        vertices_.unpack(in);
    }

private:
    template <class List>
    static void require_below(const List& sharp, std::size_t count, const char* kind)
    {
        if (not sharp.empty() and sharp.back().first >= count)
            throw mesh_error("creases: " + std::string(kind) + " " + std::to_string(sharp.back().first) +
                             " does not exist, there are " + std::to_string(count) +
                             "; make the creases for this mesh and level");
    }

    template <level_numbering Numbering>
    static constexpr bool keeps_edges = decltype(Numbering::edges)::template has<tuple_kind::e>;
    template <level_numbering Numbering, edge_element Edge>
    static bool is_cut(const Numbering& ids, const Edge& e)
    {
        if constexpr (keeps_edges<Numbering>)
            return ids.edges.template id<tuple_kind::ve>(2 * e.index()) != ids.edges.none;
        else
            return true;
    }
    template <level_numbering Numbering, vertex_element Vertex>
    static bool is_moved(const Numbering& ids, const Vertex& v)
    {
        if constexpr (keeps_edges<Numbering>) {
            for (const auto& e : v.edges())
                if (is_cut(ids, e))
                    return true;
            return false;
        } else {
            return true;
        }
    }

    static const large_fan* find(std::span<const large_fan> fans, std::size_t vertex)
    {
        const auto fan = std::ranges::lower_bound(fans, vertex, {}, &large_fan::vertex);
        return fan != fans.end() and fan->vertex == vertex ? &*fan : nullptr;
    }

    sparse_values<double> edges_, vertices_;
};

/// Requirements of a scheme with creases: a member `sharpness` of class creases, which is its state.
template <class S>
concept scheme_with_creases = scheme<S> and requires(S& s) {
    { s.sharpness } -> std::same_as<creases&>;
};
/// Requirements of a scheme whose points follow sharp_rules: it also has a member `corners`. face_varying and
/// crease_limits need such a scheme.
template <class S>
concept scheme_with_sharp_rules = scheme_with_creases<S> and requires(const S& s) {
    { s.corners } -> std::convertible_to<boundary_corner>;
};

/// Returns the member `boundary` of a scheme; boundary_curve::cubic if it has none.
template <scheme_with_sharp_rules Scheme>
constexpr boundary_curve boundary_curve_of(const Scheme& scheme)
{
    if constexpr (requires {
                      { scheme.boundary } -> std::convertible_to<boundary_curve>;
                  })
        return scheme.boundary;
    else
        return boundary_curve::cubic;
}

} // namespace kith
