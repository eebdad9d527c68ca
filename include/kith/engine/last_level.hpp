// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/engine/patch/patched_level.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/numbering/step/surface_order.hpp>

#include <concepts>
#include <utility>

namespace kith {

/// The last level of a refinement as a native mesh, with as much connectivity as is wanted.
template <class Point, std::unsigned_integral Index>
class native_last_level {
public:
    explicit native_last_level(connect wanted) : wanted_(wanted) {}

    [[nodiscard]] connect wanted() const { return wanted_; }
    /// Returns the level after it has been made.
    [[nodiscard]] basic_mesh<Point, Index> take() { return std::move(mesh_); }

    /// Takes a mesh that is not refined.
    void keep(basic_mesh<Point, Index>&& mesh) { mesh_ = std::move(mesh); }
    /// Makes the level by one step, which advances the scheme and the carried values to it. Returns false if `carried`
    /// stops the refinement.
    template <scheme Scheme, class Carried>
    bool step(basic_mesh<Point, Index>&& mesh, Scheme& scheme, Carried& carried)
    {
        mesh_ = std::move(mesh);
        return wanted_ == connect::faces ? make_next_level<connect::faces>(mesh_, scheme, carried)
                                         : make_next_level<connect::everything>(mesh_, scheme, carried);
    }
    /// Makes the level by one step from a mesh. Nothing is carried along.
    template <scheme Scheme>
    void step(const basic_mesh<Point, Index>& mesh, const Scheme& scheme)
    {
        numbering_of<Scheme, Index> ids;
        mesh_ = wanted_ == connect::faces ? refine_mesh<connect::faces>(mesh, scheme, ids)
                                          : refine_mesh<connect::everything>(mesh, scheme, ids);
    }
    /// Makes the level by one step from the elements of the level before.
    template <level Level, scheme Scheme>
    void step(const Level& coarse, int generation, const Scheme& scheme)
    {
        numbering_of<Scheme, Index> ids;
        mesh_ = wanted_ == connect::faces ? refine_level<connect::faces>(coarse, scheme, generation, ids)
                                          : refine_level<connect::everything>(coarse, scheme, generation, ids);
    }
#ifdef KITH_HAS_LANES
    /// Makes the level in patches of the faces of an earlier level. `numbers` are the numbers of its elements, if it is
    /// in another order.
    template <class Patches>
    void fill(const basic_mesh<Point, Index>& level, const Patches& patches, const patch_plan& plan,
              const element_numbers<Index>* numbers)
    {
        const counts& last = plan.last();
        storage<Point> points(last.vertices);
        connectivity<Index> fine;
        fine.vertices = last.vertices;
        allocate_faces(fine, level.topology(), plan.bases);
        if (wanted_ == connect::everything) {
            fine.corner_halfedge = storage<Index>(fine.corners());
            fine.halfedge_corner = storage<Index>(2 * last.edges);
            fine.vertex_corner = storage<Index>(last.vertices);
        }
        patches.fill(level,
                     {.points = points.data(),
                      .corner_vertex = fine.corner_vertex.data(),
                      .corner_halfedge = fine.corner_halfedge.data(),
                      .halfedge_corner = fine.halfedge_corner.data(),
                      .vertex_corner = fine.vertex_corner.data(),
                      .coarse_numbers = numbers});
        mesh_ = basic_mesh<Point, Index>(
            std::move(points), std::move(fine), level.generation() + int(plan.bases.size()));
    }
#endif

private:
    connect wanted_;
    basic_mesh<Point, Index> mesh_;
};

/// The last level of a refinement as a mesh of another library, with all connectivity. Errors: those of `make_room`.
template <class Point, std::unsigned_integral Index>
class written_last_level {
public:
    explicit written_last_level(level_writer<Point, Index>& fine) : fine_(fine) {}

    [[nodiscard]] static constexpr connect wanted() { return connect::everything; }

    /// Writes a mesh that is not refined.
    void keep(const basic_mesh<Point, Index>& mesh) { write_level(fine_, mesh); }
    /// Writes the level by one step from a mesh. Nothing is carried along.
    template <scheme Scheme>
    void step(const basic_mesh<Point, Index>& mesh, const Scheme& scheme)
    {
        numbering_of<Scheme, Index> ids;
        refine_mesh_into(fine_, mesh, scheme, ids);
    }
#ifdef KITH_HAS_LANES
    /// Writes the level in patches of the faces of an earlier level. `numbers` are the numbers of its elements, if it
    /// is in another order.
    template <class Patches>
    void fill(const basic_mesh<Point, Index>& level, const Patches& patches, const patch_plan& plan,
              const element_numbers<Index>* numbers)
    {
        const counts& last = plan.last();
        fine_.make_room(last.vertices, last.edges, last.faces, last.boundary_edges == 0);
        patches.fill(level, {.points = fine_.points(), .writer = &fine_, .coarse_numbers = numbers});
        fine_.finish(level.generation() + int(plan.bases.size()));
    }
#endif

private:
    level_writer<Point, Index>& fine_;
};

/// A last level of which nothing is kept, for callers that only ask how it would be made.
class no_last_level {
public:
    explicit no_last_level(connect wanted) : wanted_(wanted) {}

    [[nodiscard]] connect wanted() const { return wanted_; }
    static void fill(const auto&...) {}

private:
    connect wanted_;
};

#ifdef KITH_HAS_LANES
/// The values at the vertices of the last level of a refinement, which follow the masks of points.
template <class T>
class last_values {
public:
    /// Returns the values after they have been made.
    [[nodiscard]] storage<T> take() { return std::move(values_); }

    /// Makes the values in patches of the faces of an earlier level, whose points are the values at its vertices.
    template <std::unsigned_integral Index, class Patches>
    void fill(const basic_mesh<T, Index>& level, const Patches& patches, const patch_plan& plan,
              const element_numbers<Index>* numbers)
    {
        values_ = storage<T>(plan.last().vertices);
        patches.fill(level, {.points = values_.data(), .coarse_numbers = numbers});
    }

private:
    storage<T> values_;
};
#endif

} // namespace kith
