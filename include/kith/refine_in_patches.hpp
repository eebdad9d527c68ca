// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/patched_level.hpp>

#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

namespace kith {

#ifdef KITH_HAS_LANES

/// The last steps of a refinement, face by face: a face of the level before them owns a patch of the last
/// level. Faces with alike neighbourhoods share a template, which is replayed in SIMD lanes; the few others are refined as
/// meshes of their own. The numbers and the bits are those of refining level by level.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patch_refinement {
public:
    /// `levels` steps from a control mesh that has its edges. Cost: O(levels).
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                     const patch_costs& costs = {})
        : scheme_(scheme)
        , costs_(costs)
        , levels_(levels)
        , plan_(plan_patches(count(control.topology()), control.topology().degree == int(degree), scheme, levels,
                             control.generation()))
    {
    }

    /// Whether there are so many faces that it may be worth while.
    [[nodiscard]] bool is_worth_looking() const
    {
        return has_lanes() and plan_ and plan_->of_begin().faces >= costs_.least_faces and
               costs_.of_walk * double(plan_->faces_of_walk(degree) * plan_->levels[std::size_t(plan_->first)].faces) <=
                   costs_.share_of_walks * double(plan_->last().faces);
    }

    /// What refining level by level makes, to the bit; of the last level what is asked for. Precondition: is_worth_looking().
    [[nodiscard]] basic_mesh<Point, Index> refine(basic_mesh<Point, Index> mesh, connect last_level) const
    {
        face_classes<Index> classes(plan_->rings);
        numbering ids;
        for (int level = 0; level < plan_->begin; ++level) {
            if (level == plan_->first)
                classes.look_at(mesh.topology());
            auto fine = refine_mesh<connect::everything>(mesh, scheme_, ids);
            if (level >= plan_->first)
                classes.follow(ids, degree, fine.topology());
            mesh = std::move(fine);
        }
        if (plan_->begin == plan_->first)
            classes.look_at(mesh.topology());
        if (const auto patches = patched_level<Point, Index, Scheme>::make(
                mesh, classes, scheme_, *plan_, costs_, last_level == connect::everything))
            return filled(mesh, *patches, last_level);
        for (int level = plan_->begin; level + 1 < levels_; ++level)
            mesh = refine_mesh<connect::everything>(mesh, scheme_, ids);
        return last_level == connect::faces ? refine_mesh<connect::faces>(mesh, scheme_, ids)
                                            : refine_mesh<connect::everything>(mesh, scheme_, ids);
    }

private:
    using numbering = numbering_of<Scheme, Index>;
    static constexpr std::size_t degree = numbering::common_degree;

    [[nodiscard]] basic_mesh<Point, Index> filled(const basic_mesh<Point, Index>& mesh,
                                                  const patched_level<Point, Index, Scheme>& patches,
                                                  connect last_level) const
    {
        const counts& last = plan_->last();
        storage<Point> points(last.vertices);
        connectivity<Index> fine;
        fine.vertices = last.vertices;
        fine.allocate_faces(last.faces, int(degree), [](std::size_t) { return degree; });
        if (last_level == connect::everything) {
            fine.corner_halfedge = storage<Index>(fine.corners());
            fine.halfedge_corner = storage<Index>(2 * last.edges);
            fine.vertex_corner = storage<Index>(last.vertices);
        }
        patches.fill(mesh,
                     {points.data(),
                      fine.corner_vertex.data(),
                      fine.corner_halfedge.data(),
                      fine.halfedge_corner.data(),
                      fine.vertex_corner.data()});
        const int generation = mesh.generation() + levels_ - plan_->begin;
        return basic_mesh<Point, Index>(std::move(points), std::move(fine), generation);
    }

    Scheme scheme_;
    patch_costs costs_;
    int levels_;
    std::optional<patch_plan> plan_;
};

#endif

} // namespace kith
