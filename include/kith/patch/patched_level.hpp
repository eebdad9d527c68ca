// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_clusters.hpp"
#include "kept_templates.hpp"
#include "patch_filler.hpp"
#include "patch_plan.hpp"
#include "template_maker.hpp"

#include <kith/base/for_parts.hpp>
#include <kith/neighbourhood/face_classes.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// When patches are worth while: what a final face costs in each of the ways to make it, level by level being 1. Measured
/// with the schemes of the library.
struct patch_costs {
    double in_patch = .45;           ///< .3 (Butterfly) to .6
    double in_patch_with_edges = .5; ///< with all connectivity: .5 (Butterfly) to .8 (Loop)
    double among_few = 6;            ///< of few faces with their rings, where making a template is not worth it
    double of_template = 400;        ///< of making one, in final faces: half of what it takes, since templates are kept
    double of_face_in_template = 25; ///< the same for each face of its patch: 15 (Butterfly) to 50 (sqrt(3))
    double of_look = 3;              ///< of finding the class of a face, per ring, in final faces
    double most_of_looks = .4;       ///< nobody looks where that costs more of the whole
    double share_if_alike = .3;      ///< so few kinds has a sample of faces of a control mesh whose faces are alike
    double to_be_cheaper = .9;       ///< patches must come to less than so much
    double least_faces = 16e6;       ///< of the last level times those of a patch; for fewer nobody looks

    /// The same where the faces of the control mesh are unlike and lie in no order: level by level takes two to three times
    /// as long there, making a template does not, and who looks reads from all over the memory.
    [[nodiscard]] patch_costs if_unlike() const
    {
        patch_costs costs = *this;
        costs.of_template /= 2;
        costs.of_face_in_template /= 2;
        costs.most_of_looks /= 3;
        return costs;
    }
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

    /// Of the level that the plan begins with, with its classes by the rings of the plan and the scheme there, to make faces or all
    /// connectivity; nothing where it is no gain. Cost: O(faces), and that of the templates.
    static std::optional<patched_level> make(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes,
                                             const Scheme& scheme, const patch_plan& plan, const patch_costs& costs,
                                             bool with_edges = false)
    {
        const double in_patch = with_edges ? costs.in_patch_with_edges : costs.in_patch;
        std::vector<std::size_t> members(classes.count(), 0);
        for (const class_number c : classes.of_faces())
            ++members[c];
        const double of_template = costs.of_template + costs.of_face_in_template * plan.faces_of_patch();
        const auto gains = [&](class_number c) {
            return double(members[c]) * plan.faces_of_patch() * (costs.among_few - in_patch) > of_template;
        };
        const auto is_gain = [&](const auto& has_template) {
            double cost = 0;
            std::size_t in_templates = 0;
            for (class_number c = 0; c < members.size(); ++c)
                if (has_template(c)) {
                    cost += of_template + double(members[c]) * plan.faces_of_patch() * in_patch;
                    in_templates += members[c];
                }
            cost += double(mesh.face_count() - in_templates) * plan.faces_of_patch() * costs.among_few;
            return cost <= costs.to_be_cheaper * double(plan.last().faces);
        };
        if (not is_gain(gains))
            return {};
        face_walk<Index> walk(mesh.topology(), plan.rings);
        const auto models = models_of(classes, walk, gains);
        if (not is_gain([&](class_number c) { return models[c] != no_face; }))
            return {};
        return patched_level(mesh, classes, models, walk, scheme, plan);
    }

    /// Makes the points of the last level, and of its connectivity what there is room for. The mesh is that of `make`, or one with other
    /// points. Cost: that of the programs, and of refining the faces that have no template.
    void fill(const basic_mesh<Point, Index>& mesh, const output& to) const
    {
        constexpr std::size_t at_once = patch_filler<Point, Index, degree>::at_once;
        constexpr std::size_t cached_bytes = std::size_t(4) << 20;
        const bool past_caches = vertices_ * sizeof(Point) > cached_bytes;
        detail::for_parts(
            mesh.face_count(),
            true,
            [&](std::size_t begin, std::size_t end) {
                patch_filler<Point, Index, degree> filler(mesh, to, past_caches);
                std::vector<Index> waiting(templates_.size() * at_once);
                std::vector<std::uint8_t> count(templates_.size(), 0);
                const auto flush = [&](std::size_t c) {
                    filler.fill(*templates_[c], bases_[c], std::span(waiting).subspan(c * at_once, count[c]));
                    count[c] = 0;
                };
                for (std::size_t f = begin; f < end; ++f) {
                    const class_number c = template_of_face_[f];
                    if (c == none)
                        continue;
                    waiting[c * at_once + count[c]++] = Index(f);
                    if (count[c] == at_once)
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
    static constexpr class_number none = std::numeric_limits<class_number>::max();
    static constexpr Index no_face = std::numeric_limits<Index>::max();
    static constexpr std::size_t degree = numbering::common_degree;

    /// For each class that gains by a template a face for which it can be made: one of the first faces of the class, if the
    /// neighbourhood of one of them is a disk.
    template <class Gains>
    static std::vector<Index> models_of(const face_classes<Index>& classes, face_walk<Index>& walk, const Gains& gains)
    {
        constexpr unsigned char most_looks = 8;
        std::vector<Index> models(classes.count(), no_face);
        std::vector<unsigned char> looks_left(classes.count(), most_looks);
        std::size_t left = classes.count(); // of which a face is looked for
        for (class_number c = 0; c < classes.count(); ++c)
            if (not gains(c)) {
                looks_left[c] = 0;
                --left;
            }
        for (std::size_t f = 0; left != 0 and f < classes.of_faces().size(); ++f)
            if (const class_number c = classes.of_faces()[f]; looks_left[c] != 0) {
                --looks_left[c];
                walk.around(f);
                if (walk.is_disk()) {
                    models[c] = Index(f);
                    looks_left[c] = 0;
                }
                left -= looks_left[c] == 0;
            }
        return models;
    }

    patched_level(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes,
                  const std::vector<Index>& models, face_walk<Index>& walk, const Scheme& scheme,
                  const patch_plan& plan)
        : vertices_(plan.last().vertices), template_of_face_(mesh.face_count())
    {
        const auto kept = templates::of(without_state(scheme), mesh.generation(), plan.rings, plan.bases.size());
        template_maker<Scheme, Point, Index> maker(mesh, scheme, plan.bases);
        state_marks<Index> marks(mesh.topology(), scheme);
        std::vector<class_number> template_of_class(classes.count(), none);
        for (std::size_t c = 0; c < models.size(); ++c)
            if (models[c] != no_face)
                template_of_class[c] = find_template(*kept, maker, walk, marks, plan.bases, models[c]);
        detail::for_parts(mesh.face_count(), true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f)
                template_of_face_[f] = template_of_class[classes.of_faces()[f]];
        });
        if (std::ranges::find(template_of_class, none) == template_of_class.end())
            return;
        std::vector<Index> without_template;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (template_of_face_[f] == none)
                without_template.push_back(Index(f));
        clusters_.emplace(scheme, plan.bases, std::move(without_template));
    }

    /// Its number; none for a face around which there is too much to be numbered.
    class_number find_template(templates& kept, template_maker<Scheme, Point, Index>& maker, face_walk<Index>& walk,
                               state_marks<Index>& marks, std::span<const column_bases> bases, std::size_t face)
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
        std::vector<Index>& bases_here = bases_.emplace_back();
        for (const auto& m : found->multiples)
            bases_here.push_back(patch_numbers<Index>::base(m, bases, degree));
        templates_.push_back(std::move(found));
        return class_number(templates_.size() - 1);
    }

    std::size_t vertices_; // of the last level
    std::vector<typename templates::pointer> templates_;
    std::vector<std::vector<Index>> bases_; // of the multiples of each
    storage<class_number> template_of_face_;
    std::optional<face_clusters<Point, Index, Scheme>> clusters_; // of the faces without a template
};

#endif

} // namespace kith
