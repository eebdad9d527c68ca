// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/patched_level.hpp>

#include <cmath>
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

    /// Whether there are so many faces that it may be worth while on any mesh.
    [[nodiscard]] bool is_worth_looking() const { return is_large() and share_of_walks() <= costs_.share_of_walks; }
    /// Whether it may be on this control mesh, for which this was made: face lists gain so much that walks may cost more where they will
    /// not be in vain. Cost: O(1), or O(elements) and that of some of the walks.
    [[nodiscard]] bool is_worth_looking(const basic_mesh<Point, Index>& control, connect last_level) const
    {
        return is_worth_looking() or (last_level == connect::faces and is_large() and
                                      share_of_walks() <= costs_.share_if_alike and is_alike(control));
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
            return fine.finish(mesh.generation() + levels_ - plan_->begin);
        }
        mesh = before_last(std::move(mesh), scheme);
        numbering ids;
        refine_mesh_into(fine, mesh, scheme, ids);
    }

private:
    using numbering = numbering_of<Scheme, Index>;
    using patches = patched_level<Point, Index, Scheme>;
    static constexpr std::size_t degree = numbering::common_degree;

    [[nodiscard]] bool is_large() const
    {
        return has_lanes() and plan_ and plan_->of_begin().faces >= costs_.least_faces;
    }
    /// What all walks cost of what refining level by level does.
    [[nodiscard]] double share_of_walks() const
    {
        const auto faces = double(plan_->levels[std::size_t(plan_->first)].faces);
        return costs_.of_walk * double(plan_->faces_of_walk(degree)) * faces / double(plan_->last().faces);
    }
    /// Whether so many creases are different that walks around the faces beside them cost too much: with each level there are about twice
    /// as many such faces.
    [[nodiscard]] bool is_in_vain(const face_classes<Index>& classes, int level) const
    {
        const double walks = std::ldexp(double(classes.count()), plan_->begin - level);
        return costs_.of_walk * double(plan_->faces_of_walk(degree)) * walks >
               costs_.share_of_walks * double(plan_->last().faces);
    }
    /// Whether the faces of a mesh that lie close together mostly look alike.
    [[nodiscard]] bool is_alike(const basic_mesh<Point, Index>& control) const
    {
        const connectivity<Index>& mesh = control.topology();
        return plan_->first == 0 and not is_scattered(mesh) and
               face_classes<Index>(plan_->rings).share_of_alike(mesh, {mesh, scheme_}) >= costs_.alike;
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
        face_classes<Index> classes(plan_->rings);
        numbering ids;
        bool gives_up = false;
        for (int level = 0; level < plan_->begin; ++level) {
            if (level == plan_->first)
                classes.look_at(mesh.topology(), {mesh.topology(), scheme});
            auto fine = next(mesh, scheme, ids);
            state_marks<Index> marks(fine.topology(), scheme);
            gives_up = gives_up or (level >= plan_->first and not marks.empty() and is_in_vain(classes, level));
            if (level >= plan_->first and not gives_up)
                classes.follow(ids, degree, fine.topology(), std::move(marks));
            mesh = std::move(fine);
        }
        if (gives_up)
            return {};
        if (plan_->begin == plan_->first)
            classes.look_at(mesh.topology(), {mesh.topology(), scheme});
        return patches::make(mesh, classes, scheme, *plan_, costs_, last_level == connect::everything);
    }
    /// Where patches are no gain: from there the level before the last one, level by level.
    [[nodiscard]] basic_mesh<Point, Index> before_last(basic_mesh<Point, Index> mesh, Scheme& scheme) const
    {
        numbering ids;
        for (int level = plan_->begin; level + 1 < levels_; ++level)
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
