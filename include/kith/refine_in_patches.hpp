// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/patched_level.hpp>

#include <algorithm>
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
    /// `levels` steps from a control mesh that has its edges. Cost: O(levels), and that of a look at some of its faces.
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                     const patch_costs& costs = {})
        : scheme_(scheme)
        , costs_(costs)
        , levels_(levels)
        , generation_(control.generation())
        , plan_(plan_patches(count(control.topology()), control.topology().degree == int(degree), scheme, levels,
                             control.generation()))
    {
        if (is_worth_looking())
            look_at(control.topology());
    }

    /// Whether there are so many faces that it may be worth while. Cost: O(1).
    [[nodiscard]] bool is_worth_looking() const
    {
        return has_lanes() and plan_ and plan_->of_begin().faces >= costs_.least_faces and
               costs_.of_look * plan_->rings <= costs_.most_of_looks * plan_->faces_of_patch();
    }

    /// What refining level by level makes, to the bit; of the last level what is asked for. Precondition: is_worth_looking().
    [[nodiscard]] basic_mesh<Point, Index> refine(basic_mesh<Point, Index> mesh, connect last_level) const
    {
        Scheme scheme = scheme_;
        if (const auto made = patches_after(mesh, scheme, last_level))
            return filled(mesh, *made, last_level);
        mesh = before_last(std::move(mesh), scheme);
        numbering ids;
        return last_level == connect::faces ? refine_mesh<connect::faces>(mesh, scheme, ids)
                                            : refine_mesh<connect::everything>(mesh, scheme, ids);
    }
    /// The same into a mesh of another library. Precondition: is_worth_looking(). Errors: those of `make_room`.
    void refine_into(level_writer<Point, Index>& fine, basic_mesh<Point, Index> mesh) const
    {
        Scheme scheme = scheme_;
        if (const auto made = patches_after(mesh, scheme, connect::everything)) {
            const counts& last = plan_->last();
            fine.make_room(last.vertices, last.edges, last.faces, last.boundary_edges == 0);
            made->fill(mesh, {.points = fine.points(), .writer = &fine});
            return fine.finish(generation_ + levels_);
        }
        mesh = before_last(std::move(mesh), scheme);
        numbering ids;
        refine_mesh_into(fine, mesh, scheme, ids);
    }

private:
    using numbering = numbering_of<Scheme, Index>;
    using patches = patched_level<Point, Index, Scheme>;
    static constexpr std::size_t degree = numbering::common_degree;

    /// Where edges run and fans start in no order, as in many files, nearly each face of a control mesh is of a kind of its own. After as
    /// many steps as there are rings around a patch there are many of most kinds, if the mesh is large; patches begin there.
    void look_at(const connectivity<Index>& control)
    {
        const double share = share_of_kinds(control, plan_->rings);
        if (share <= costs_.share_if_alike)
            return;
        if (plan_->rings < levels_)
            plan_->begin_at(std::max(plan_->begin, plan_->rings), scheme_, generation_);
        const double kinds = std::min(costs_.most_kinds, share * double(control.corners()));
        if (plan_->begin < plan_->rings or plan_->faces_of_patch() < costs_.least_patch_if_unlike or
            double(plan_->of_begin().faces) < costs_.least_of_kind * kinds)
            plan_.reset();
    }
    /// A step with all connectivity, and the scheme becomes that of the next level.
    static basic_mesh<Point, Index> next(const basic_mesh<Point, Index>& mesh, Scheme& scheme, numbering& ids)
    {
        auto fine = refine_mesh<connect::everything>(mesh, scheme, ids);
        advance(scheme, level_of<basic_mesh<Point, Index>>(mesh), mesh.generation(), ids, fine);
        return fine;
    }
    /// Makes of the mesh the level whose faces own patches, and of the scheme that of this level; nothing where they are no gain.
    [[nodiscard]] std::optional<patches> patches_after(basic_mesh<Point, Index>& mesh, Scheme& scheme,
                                                       connect last_level) const
    {
        numbering ids;
        for (int level = 0; level < plan_->begin; ++level)
            mesh = next(mesh, scheme, ids);
        const face_classes<Index> classes(mesh.topology(), plan_->rings, state_marks<Index>(mesh.topology(), scheme));
        return patches::make(mesh, classes, scheme, *plan_, costs_, last_level == connect::everything);
    }
    /// Where patches are no gain: the level before the last one, level by level.
    [[nodiscard]] basic_mesh<Point, Index> before_last(basic_mesh<Point, Index> mesh, Scheme& scheme) const
    {
        numbering ids;
        while (mesh.generation() + 1 < generation_ + levels_)
            mesh = next(mesh, scheme, ids);
        return mesh;
    }
    [[nodiscard]] basic_mesh<Point, Index> filled(const basic_mesh<Point, Index>& mesh, const patches& made,
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
        made.fill(mesh,
                  {points.data(),
                   fine.corner_vertex.data(),
                   fine.corner_halfedge.data(),
                   fine.halfedge_corner.data(),
                   fine.vertex_corner.data()});
        return basic_mesh<Point, Index>(std::move(points), std::move(fine), generation_ + levels_);
    }

    Scheme scheme_;
    patch_costs costs_;
    int levels_, generation_; // of the control mesh
    std::optional<patch_plan> plan_;
};

#endif

} // namespace kith
