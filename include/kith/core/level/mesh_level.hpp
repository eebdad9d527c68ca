// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validate.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/dense_numbers.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace kith {

/// A mesh of any type as a scheme sees it: the walk uses the user's own handles through mesh_traits. The constructor
/// computes what a half-edge library does not provide: dense numbers (meshes may hold removed elements), the position
/// of each corner in its face, and the start of each fan.
template <mesh M>
class mesh_level {
public:
    using mesh_type = M;
    using traits = mesh_traits<M>;
    using point_type = typename traits::point;
    using index_type = std::uint32_t;
    using vertex_handle = typename traits::vertex;
    using edge_handle = typename traits::edge;
    using face_handle = typename traits::face;

    /// A half-edge that has a face. It is a type of its own, since libraries may use one handle type for several kinds.
    struct corner_handle {
        typename traits::halfedge halfedge{};
        bool exists = true;

        friend bool operator==(const corner_handle&, const corner_handle&) = default;
    };
    /// The flag that allows arithmetic on these points on several threads.
    static constexpr bool parallel = std::is_trivially_copyable_v<point_type>;
    static inline const corner_handle no_corner{typename traits::halfedge(), false};

    /// Reads a mesh, which must outlive the view. Errors: mesh_error with the text of `validate` unless the handles
    /// form a mesh. Points, and whether a vertex has several fans, are not checked. Cost: O(elements) time and memory.
    explicit mesh_level(const M& mesh)
        : mesh_(&mesh)
        , vertices_(mesh, traits::vertices(mesh), traits::vertex_bound(mesh))
        , edges_(mesh, traits::edges(mesh), traits::edge_bound(mesh))
        , faces_(mesh, traits::faces(mesh), traits::face_bound(mesh))
    {
        corner_number_.assign(traits::halfedge_bound(mesh), none);
        face_corner_.reserve(faces_.size() + 1);
        face_corner_.push_back(0);
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const bool is_closed = detail::for_each_side(mesh, faces_[i], [&](const auto& h) {
                index_type& corner = corner_number_[traits::index(mesh, h)];
                if (corner != none or not detail::is_side_of(mesh, h, faces_[i]) or
                    not edges_.has(mesh, traits::edge_of(mesh, h)) or not vertices_.has(mesh, traits::source(mesh, h)))
                    detail::refuse_mesh(mesh);
                corner = index_type(corners_.size());
                corners_.push_back(h);
            });
            if (not is_closed)
                detail::refuse_mesh(mesh);
            face_corner_.push_back(index_type(corners_.size()));
        }
        for (std::size_t i = 0; i < edges_.size() and not is_closed(); ++i) {
            const auto h = traits::halfedge_of(mesh, edges_[i]);
            std::size_t faces = 0;
            for (const auto side : {h, typename traits::halfedge(traits::opposite(mesh, h))})
                if (corner_number_[traits::index(mesh, side)] != none)
                    ++faces;
                else if (not traits::is_boundary(mesh, side))
                    detail::refuse_mesh(mesh);
            if (faces == 0)
                detail::refuse_mesh(mesh);
        }
        fan_start_.reserve(vertices_.size());
        std::size_t turns = corners_.size() + vertices_.size();
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const auto v = vertices_[i];
            fan_start_.emplace_back();
            if (traits::is_isolated(mesh, v) or not detail::starts_at_its_own(mesh, v) or
                not find_start_of_fan(traits::halfedge_of(mesh, v), fan_start_.back(), turns))
                detail::refuse_mesh(mesh);
        }
    }

    [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
    [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }
    [[nodiscard]] std::size_t face_count() const { return faces_.size(); }
    [[nodiscard]] std::size_t corner_count() const { return corners_.size(); }
    [[nodiscard]] bool is_closed() const { return corner_count() == 2 * edge_count(); }
    [[nodiscard]] kith::counts counts() const
    {
        kith::counts result{.vertices = vertex_count(), .edges = edge_count(), .faces = face_count()};
        result.boundary_edges = 2 * edge_count() - corner_count();
        for (std::size_t f = 0; f < face_count(); ++f)
            result.triangles += face_corner_[f + 1] - face_corner_[f] == 3;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const vertex_handle v = vertices_[i];
            if (across(first(v)) != no_corner)
                continue;
            std::uint64_t fan = 0;
            for (corner_handle c = first(v); c != no_corner; c = across(prev(c)))
                ++fan;
            result.add_boundary_fan(fan);
        }
        return result;
    }

    [[nodiscard]] vertex_handle vertex_at(std::size_t i) const { return vertices_[i]; }
    [[nodiscard]] edge_handle edge_at(std::size_t i) const { return edges_[i]; }
    [[nodiscard]] face_handle face_at(std::size_t i) const { return faces_[i]; }
    [[nodiscard]] corner_handle corner_at(std::size_t i) const { return {corners_[i]}; }

    /// Returns true if a handle belongs to an element of this level: it is valid, and the element has not been removed.
    [[nodiscard]] bool has(vertex_handle v) const { return vertices_.has(*mesh_, v); }
    [[nodiscard]] bool has(edge_handle e) const { return edges_.has(*mesh_, e); }
    [[nodiscard]] bool has(face_handle f) const { return faces_.has(*mesh_, f); }

    [[nodiscard]] std::size_t index(vertex_handle v) const { return vertices_.number(*mesh_, v); }
    [[nodiscard]] std::size_t index(edge_handle e) const { return edges_.number(*mesh_, e); }
    [[nodiscard]] std::size_t index(face_handle f) const { return faces_.number(*mesh_, f); }
    [[nodiscard]] std::size_t index(corner_handle c) const { return corner_number_[traits::index(*mesh_, c.halfedge)]; }
    [[nodiscard]] std::size_t halfedge(corner_handle c) const
    {
        const edge_handle e = edge_of(c);
        return 2 * index(e) + (first(e) == c ? 0 : 1);
    }

    /// Returns the number that the mesh itself gives to an element. Removed elements may be counted in it.
    template <handle_of<M> Handle>
    [[nodiscard]] std::size_t number_in_mesh(Handle x) const
    {
        return traits::index(*mesh_, x);
    }

    [[nodiscard]] corner_handle first(vertex_handle v) const { return {fan_start_[index(v)]}; }
    [[nodiscard]] corner_handle first(edge_handle e) const
    {
        const auto h = traits::halfedge_of(*mesh_, e);
        return {traits::is_boundary(*mesh_, h) ? traits::opposite(*mesh_, h) : h};
    }
    [[nodiscard]] corner_handle second(edge_handle e) const { return across(first(e)); }
    [[nodiscard]] corner_handle first(face_handle f) const { return {traits::halfedge_of(*mesh_, f)}; }
    [[nodiscard]] std::size_t degree(face_handle f) const
    {
        const std::size_t i = index(f);
        return face_corner_[i + 1] - face_corner_[i];
    }

    [[nodiscard]] corner_handle next(corner_handle c) const { return {traits::next(*mesh_, c.halfedge)}; }
    [[nodiscard]] corner_handle prev(corner_handle c) const { return {traits::prev(*mesh_, c.halfedge)}; }
    [[nodiscard]] corner_handle across(corner_handle c) const
    {
        const auto h = traits::opposite(*mesh_, c.halfedge);
        return traits::is_boundary(*mesh_, h) ? no_corner : corner_handle{h};
    }
    [[nodiscard]] vertex_handle vertex_of(corner_handle c) const { return traits::source(*mesh_, c.halfedge); }
    [[nodiscard]] edge_handle edge_of(corner_handle c) const { return traits::edge_of(*mesh_, c.halfedge); }
    [[nodiscard]] face_handle face_of(corner_handle c) const { return traits::face_of(*mesh_, c.halfedge); }
    [[nodiscard]] decltype(auto) point(vertex_handle v) const { return traits::point_of(*mesh_, v); }

private:
    static constexpr index_type none = std::numeric_limits<index_type>::max();

    /// Finds the half-edge at which a fan starts. At the boundary its opposite has no face; inside, it is `out`, the
    /// start given by the mesh. Returns true if the half-edges lead to the start; all vertices together may take `left`
    /// turns. Precondition: `out` is a half-edge of the mesh.
    bool find_start_of_fan(typename traits::halfedge out, typename traits::halfedge& start, std::size_t& left) const
    {
        start = out;
        do {
            const auto o = traits::opposite(*mesh_, start);
            if (left == 0 or not detail::has_halfedge(*mesh_, o))
                return false;
            --left;
            if (traits::is_boundary(*mesh_, o))
                break;
            start = traits::next(*mesh_, o);
        } while (start != out);
        return not traits::is_boundary(*mesh_, start);
    }

    const M* mesh_;
    dense_numbers<M, vertex_handle> vertices_;
    dense_numbers<M, edge_handle> edges_;
    dense_numbers<M, face_handle> faces_;
    std::vector<typename traits::halfedge> corners_;
    std::vector<index_type> corner_number_;
    std::vector<index_type> face_corner_; // faces+1: the first corner of each face in corners_
    std::vector<typename traits::halfedge> fan_start_;
};

} // namespace kith
