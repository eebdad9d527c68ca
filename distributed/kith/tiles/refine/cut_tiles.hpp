// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_job.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/numbering/step/submesh.hpp>
#include <kith/tiles/number/column_facts.hpp>
#include <kith/tiles/number/control_numbers.hpp>
#include <kith/tiles/number/global_counts.hpp>
#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/part/reach.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// A cutter of tiles out of a control mesh that lies in memory as a whole. A mesh of another library is first converted
/// by `to_native`; global numbers are then those of that library without removed elements.
template <class Point, std::unsigned_integral Index, scheme Scheme>
class tile_cutter {
public:
    using job_type = tile_job<tile<Point, Index>, Scheme>;

    /// Takes a mesh and the part of each face: `part_of[f]` is the part of face f, below `parts`. Parts may be empty,
    /// and need not be connected. Preconditions: `refine` takes the mesh, which has its edges, and the mesh outlives
    /// this object. Errors: mesh_error for a partition of another mesh; for a part that does not exist; for more parts
    /// than can be held; and for state of the scheme (creases, fields) of another mesh. Cost: O(elements).
    tile_cutter(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, std::span<const std::uint32_t> part_of,
                std::size_t parts)
        : mesh_(mesh), level_(mesh), scheme_(scheme), cutter_(mesh), first_(checked(parts, mesh) + 1, 0)
    {
        if (part_of.size() != mesh.face_count())
            throw mesh_error("the partition has " + std::to_string(part_of.size()) + " faces, the mesh has " +
                             std::to_string(mesh.face_count()) + "; make it for this mesh");
        for (std::size_t f = 0; f < part_of.size(); ++f) {
            if (part_of[f] >= parts)
                throw mesh_error("face " + std::to_string(f) + " is in part " + std::to_string(part_of[f]) + " of " +
                                 std::to_string(parts) + "; number the parts from 0");
            ++first_[part_of[f] + 1];
        }
        for (std::size_t p = 0; p < parts; ++p)
            first_[p + 1] += first_[p];
        detail::require_states_of(level_, scheme_);
        faces_.resize(part_of.size());
        auto next = first_;
        for (std::size_t f = 0; f < part_of.size(); ++f)
            faces_[next[part_of[f]]++] = Index(f);
        is_ours_.assign(part_of.size(), 0);
        if constexpr (numbers_corners_at_vertices<Scheme>)
            count_corners();
        if constexpr (marks_edges<Scheme>)
            count_marks();
    }

    [[nodiscard]] std::size_t parts() const { return first_.size() - 1; }
    [[nodiscard]] std::span<const Index> faces(std::size_t part) const
    {
        return std::span(faces_).subspan(first_[part], first_[part + 1] - first_[part]);
    }
    /// Returns the number of faces and of corners of the part with the most corners, which makes the most new faces.
    /// Cost: O(faces).
    [[nodiscard]] std::array<std::uint64_t, 2> largest() const
    {
        std::array<std::uint64_t, 2> result{0, 0};
        for (std::size_t part = 0; part < parts(); ++part) {
            std::uint64_t corners = 0;
            for (const Index f : faces(part))
                corners += mesh_.face(f).size();
            if (corners > result[1])
                result = {faces(part).size(), corners};
        }
        return result;
    }
    [[nodiscard]] global_counts counts() const
    {
        return {mesh_.vertex_count(),
                mesh_.edge_count(),
                mesh_.face_count(),
                mesh_.corner_count(),
                marked_before_.empty() ? 0 : marked_before_.back()};
    }

    /// Returns the numbers of the mesh for which there is no formula; see global_lineage. Cost: O(elements).
    [[nodiscard]] control_runs runs() const { return control_runs_of<Scheme>(mesh_); }

    /// Returns part `part` with `rings` rings of ghosts, and its scheme. Cost: O(n log n) for its n elements.
    [[nodiscard]] job_type cut(std::size_t part, int rings) { return cut_around(faces(part), rings); }

    /// Returns the tile of all faces that touch the boundary, for global_levels. It is empty if the scheme does not
    /// need it (numbers_boundary).
    [[nodiscard]] job_type cut_rim(int rings)
    {
        if constexpr (not numbers_boundary<Scheme>)
            return cut_around({}, rings);
        const auto& t = mesh_.topology();
        std::vector<unsigned char> at_boundary(mesh_.vertex_count(), 0);
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (t.is_boundary(e))
                for (const Index v : t.ends(e))
                    at_boundary[v] = 1;
        std::vector<Index> seeds;
        for (std::size_t f = 0; f < mesh_.face_count(); ++f)
            if (std::ranges::any_of(mesh_.face(f), [&](Index v) { return at_boundary[v] != 0; }))
                seeds.push_back(Index(f));
        return cut_around(seeds, rings);
    }

private:
    static std::size_t checked(std::size_t parts, const basic_mesh<Point, Index>& mesh)
    {
        detail::require_parts(parts, mesh.face_count());
        return parts;
    }
    void count_corners()
    {
        corners_before_.assign(mesh_.vertex_count() + 1, 0);
        for (const Index v : mesh_.topology().corner_vertex)
            ++corners_before_[v + 1];
        for (std::size_t v = 0; v < mesh_.vertex_count(); ++v)
            corners_before_[v + 1] += corners_before_[v];
    }

    void count_marks()
    {
        static_assert(detail::is_said<decltype(traits_of<Scheme>.is_marked)>,
                      "a scheme whose columns pick edges by marks needs .is_marked = [](const auto& edge) {...} in its "
                      "traits(), to be refined in tiles");
        marked_before_.assign(mesh_.edge_count() + 1, 0);
        for (const auto e : level_.edges())
            marked_before_[e.index() + 1] = marked_before_[e.index()] + (traits_of<Scheme>.is_marked(e) ? 1 : 0);
    }

    job_type cut_around(std::span<const Index> seeds, int rings)
    {
        auto part = cutter_.cut(cutter_.faces_around(seeds, rings));
        if (std::exchange(is_marked_, true)) // an earlier call has ended by an exception
            std::ranges::fill(is_ours_, 0);
        for (const Index f : seeds)
            is_ours_[f] = 1;
        tile<Point, Index> result;
        fill_vertices(part, result);
        fill_edges(part, result);
        fill_faces(part, result);
        for (const Index f : seeds)
            is_ours_[f] = 0;
        is_marked_ = false;
        auto scheme = detail::scheme_of_part(scheme_, part.numbers());
        result.mesh = std::move(part.mesh);
        return {std::move(result), std::move(scheme)};
    }
    void fill_vertices(const submesh<Point, Index>& part, tile<Point, Index>& result) const
    {
        result.vertex_ids = storage<global_id>(part.vertex_from);
        result.vertex_marks = storage<unsigned char>(part.vertex_from.size());
        for (std::size_t v = 0; v < part.vertex_from.size(); ++v)
            result.vertex_marks[v] = is_mine(tuple_kind::v, part.vertex_from[v]) and not part.is_copy(v) ? owned_mark
                                                                                                         : 0;
        if constexpr (numbers_corners_at_vertices<Scheme>)
            result.corners_before = of_each(part.vertex_from, corners_before_);
    }
    void fill_edges(const submesh<Point, Index>& part, tile<Point, Index>& result) const
    {
        result.edge_ids = storage<global_id>(part.edge_from);
        result.edge_marks = storage<unsigned char>(part.edge_from.size());
        for (std::size_t e = 0; e < part.edge_from.size(); ++e)
            result.edge_marks[e] = static_cast<unsigned char>(
                (is_mine(tuple_kind::e, part.edge_from[e]) ? owned_mark : 0) |
                (part.edge_is_new_rim[e] != 0 ? cut_mark : 0) | (part.edge_is_turned[e] != 0 ? turned_mark : 0));
        if constexpr (marks_edges<Scheme>)
            result.marked_before = of_each(part.edge_from, marked_before_);
    }
    /// Returns true if the tile owns an element, which belongs to the face with the smallest number among the faces at
    /// it.
    [[nodiscard]] bool is_mine(tuple_kind kind, std::size_t element) const
    {
        return is_ours_[parent_face(level_, kind, element)] != 0;
    }
    static storage<global_id> of_each(const std::vector<Index>& elements, const std::vector<global_id>& values)
    {
        storage<global_id> result(elements.size());
        std::ranges::transform(elements, result.begin(), [&](Index x) { return values[x]; });
        return result;
    }
    void fill_faces(const submesh<Point, Index>& part, tile<Point, Index>& result) const
    {
        const std::size_t size = part.face_from.size();
        const bool mixed = mesh_.topology().degree == 0;
        result.face_ids = storage<global_id>(size);
        result.face_marks = storage<unsigned char>(size);
        result.root_of = storage<Index>(size);
        result.roots = storage<global_id>(size);
        if (mixed)
            result.first_corner_ids = storage<global_id>(size);
        for (std::size_t f = 0; f < size; ++f) {
            const Index old = part.face_from[f];
            result.face_ids[f] = result.roots[f] = old;
            result.root_of[f] = Index(f);
            result.face_marks[f] = is_ours_[old] != 0 ? owned_mark : 0;
            if (mixed)
                result.first_corner_ids[f] = mesh_.topology().first_corner(old);
        }
    }

    const basic_mesh<Point, Index>& mesh_;
    level_of<basic_mesh<Point, Index>> level_;
    Scheme scheme_;
    submesh_cutter<Point, Index> cutter_;
    std::vector<std::size_t> first_;
    std::vector<Index> faces_;
    bool is_marked_ = false; // true while is_ours_ contains marks
    std::vector<unsigned char> is_ours_;
    std::vector<global_id> corners_before_, marked_before_; // sums before each vertex or edge, and the total
};

} // namespace kith
