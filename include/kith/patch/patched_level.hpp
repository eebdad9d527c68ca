// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_classes.hpp"
#include "face_clusters.hpp"
#include "kept_templates.hpp"
#include "patch_filler.hpp"
#include "patch_plan.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// When patches are worth while: what a final face costs in each of the ways to make it, level by level being 1. Measured
/// with the schemes of the library; a template takes 2500 (Butterfly) to 9300 (sqrt(3)) final faces.
struct patch_costs {
    double in_patch = .5;            ///< .3 (Butterfly) to .6
    double in_patch_with_edges = .6; ///< with all connectivity: .5 (Butterfly) to .8 (Loop)
    double among_few = 6;            ///< of few faces with their rings, where making a template is not worth it
    double of_template = 3000;       ///< of making one, in final faces
    double of_walk = 3;          ///< of each face that is met in a walk around one of the first level to find its class
    double share_of_walks = .05; ///< nobody looks where all walks cost more than this share of the whole
    double share_if_alike = .15; ///< the same for face lists, where most faces of a sample are alike
    double alike = .85;          ///< so many of them
    double to_be_cheaper = .9;   ///< patches must come to less than so much
    std::size_t least_faces = 4096; ///< of the level whose faces own patches; for fewer nobody looks
};

template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patched_level;

#ifdef KITH_HAS_LANES

/// A level whose faces own patches of the last one, with a template for each class of faces that is worth it. Faces of other
/// classes are refined as meshes of their own.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patched_level {
public:
    using output = patch_output<Point, Index>;

    /// Of a mesh whose faces have these classes and the scheme of its level, to make faces or all connectivity; nothing where it is
    /// no gain. Cost: that of the templates.
    static std::optional<patched_level> make(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes,
                                             const Scheme& scheme, const patch_plan& plan, const patch_costs& costs,
                                             bool with_edges = false)
    {
        const double in_patch = with_edges ? costs.in_patch_with_edges : costs.in_patch;
        std::vector<std::size_t> members(classes.count(), 0);
        for (const class_number c : classes.of_faces())
            if (c != classes.unlike)
                ++members[c];
        const double faces_of_patch = double(plan.last().faces) / double(mesh.face_count());
        const auto gains = [&](std::size_t count) {
            return double(count) * faces_of_patch * (costs.among_few - in_patch) > costs.of_template;
        };
        double cost = 0;
        std::size_t in_templates = 0;
        for (const std::size_t count : members)
            if (gains(count)) {
                cost += costs.of_template + double(count) * faces_of_patch * in_patch;
                in_templates += count;
            }
        cost += double(mesh.face_count() - in_templates) * faces_of_patch * costs.among_few;
        if (cost > costs.to_be_cheaper * double(plan.last().faces))
            return {};
        return patched_level(mesh, classes, scheme, plan, [&](class_number c) { return gains(members[c]); });
    }

    /// Makes the points of the last level, and of its connectivity what there is room for. The mesh is that of `make`, or one with other
    /// points. Cost: that of the programs, and of refining the faces that have no template.
    void fill(const basic_mesh<Point, Index>& mesh, const output& to) const
    {
        constexpr std::size_t width = patch_filler<Point, Index, degree>::width;
        constexpr std::size_t cached_bytes = std::size_t(8) << 20;
        const bool past_caches = vertices_ * sizeof(Point) > cached_bytes;
        detail::for_parts(
            mesh.face_count(),
            true,
            [&](std::size_t begin, std::size_t end) {
                patch_filler<Point, Index, degree> filler(mesh, to, past_caches);
                std::vector<Index> waiting(templates_.size() * width);
                std::vector<std::uint8_t> count(templates_.size(), 0);
                const auto flush = [&](std::size_t c) {
                    filler.fill(*templates_[c], std::span(waiting).subspan(c * width, count[c]));
                    count[c] = 0;
                };
                for (std::size_t f = begin; f < end; ++f) {
                    const class_number c = template_of_face_[f];
                    if (c == none)
                        continue;
                    waiting[c * width + count[c]++] = Index(f);
                    if (count[c] == width)
                        flush(c);
                }
                for (std::size_t c = 0; c < count.size(); ++c)
                    if (count[c] != 0)
                        flush(c);
                publish();
            },
            1);
        if (clusters_)
            clusters_->fill(mesh, to);
    }

private:
    using numbering = numbering_of<Scheme, Index>;
    using templates = kept_templates<Scheme, scalar_of<Point>, Index>;
    using class_number = typename face_classes<Index>::number;
    static constexpr class_number none = face_classes<Index>::unlike;
    static constexpr std::size_t degree = numbering::common_degree;

    template <class Gains>
    patched_level(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes, const Scheme& scheme,
                  const patch_plan& plan, const Gains& gains)
        : vertices_(plan.last().vertices), template_of_face_(mesh.face_count())
    {
        const auto kept = templates::of(without_state(scheme), mesh.generation(), plan.rings, plan.bases);
        template_maker<Scheme, Point, Index> maker(mesh, scheme, plan.bases);
        state_marks<Index> marks(mesh.topology(), scheme);
        face_walk<Index> walk(mesh.topology(), classes.rings());
        constexpr class_number unknown = none - 1;
        std::vector<Index> without_template;
        std::vector<class_number> template_of_class(classes.count(), unknown);
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            class_number made = none;
            if (const class_number c = classes.of_faces()[f]; c != classes.unlike) {
                if (template_of_class[c] == unknown)
                    template_of_class[c] = gains(c) ? find_template(*kept, maker, walk, marks, f) : none;
                made = template_of_class[c];
            }
            template_of_face_[f] = made;
            if (made == none)
                without_template.push_back(Index(f));
        }
        if (not without_template.empty())
            clusters_.emplace(scheme, plan.bases, std::move(without_template));
    }

    /// Its number; none for a face around which there is too much to be numbered.
    class_number find_template(templates& kept, template_maker<Scheme, Point, Index>& maker, face_walk<Index>& walk,
                               state_marks<Index>& marks, std::size_t face)
    {
        walk.around(face);
        const std::u16string& key = marks.key(walk);
        auto found = kept.find(key);
        if (found == nullptr) {
            auto made = maker.make(walk);
            if (not made)
                return none;
            found = kept.keep(key, std::move(*made));
        }
        templates_.push_back(std::move(found));
        return class_number(templates_.size() - 1);
    }

    std::size_t vertices_; // of the last level
    std::vector<typename templates::pointer> templates_;
    storage<class_number> template_of_face_;
    std::optional<face_clusters<Point, Index, Scheme>> clusters_; // of the faces without a template
};

#endif

} // namespace kith
