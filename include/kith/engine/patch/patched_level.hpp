// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_clusters.hpp"
#include "kept_templates.hpp"
#include "part_recorder.hpp"
#include "patch_filler.hpp"
#include "patch_plan.hpp"
#include "template_maker.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/engine/neighbourhood/face_classes.hpp>
#include <kith/engine/strategy/patch_estimate.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

#ifdef KITH_HAS_LANES

/// A level whose faces own patches of the last level, with a template for each class of faces that is worth it. Faces
/// of other classes are refined as meshes of their own. The scheme is known only by its part_recorder.
template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
class patched_level {
public:
    using output = patch_output<Point, Index>;
    using recorder_pointer = std::shared_ptr<const part_recorder<scalar_of<Point>, Index>>;

    /// Returns the patches of the level with which the plan begins, or nothing if they are no gain. `classes` are by
    /// its rings; patches make all connectivity if `with_edges`, else faces. Cost: O(faces), and that of the templates.
    static std::optional<patched_level> make(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes,
                                             recorder_pointer recorder, const patch_plan& plan,
                                             const strategy_costs& costs, bool with_edges);

    /// Returns the number of classes that have a template.
    [[nodiscard]] std::size_t template_count() const { return templates_.size(); }

    /// Keeps where the points and numbers lie that templates read, so that `fill` need not find them: some hundred
    /// bytes per face.
    /// Cost: O(faces).
    void keep_what_is_found(const basic_mesh<Point, Index>& mesh);

    /// Writes the points of the last level, or values in their place, and as much connectivity as `to` has arrays for.
    /// The mesh is the one given to `make`, or has other points. Cost: that of the programs, and of refining the faces
    /// that have no template.
    void fill(const basic_mesh<Point, Index>& mesh, const output& to) const;

private:
    using templates = kept_templates<scalar_of<Point>, Index>;
    using filler = patch_filler<Point, Index>;
    using class_number = typename face_classes<Index>::number;
    static constexpr std::size_t batches_at_once = 8; // that a thread takes: some ten microseconds
    static constexpr class_number none = std::numeric_limits<class_number>::max();
    static constexpr Index no_face = std::numeric_limits<Index>::max();

    /// A batch of faces with one template, which are filled together.
    struct batch {
        class_number of; ///< the template
        Index first;     ///< of its faces in `faces_`
        Index count;
        std::size_t found = 0; ///< where the numbers found for them begin
    };

    /// Returns a face for each class that may have a template, to make it from, or no_face. It is one of the first
    /// faces of its class, and its neighbourhood is a disk. Calls found(class) after walking around it.
    template <class MayHaveOne, class Found>
    static std::vector<Index> models_of(const face_classes<Index>& classes, face_walk<Index>& walk,
                                        const MayHaveOne& may_have_one, const Found& found)
    {
        constexpr unsigned char most_looks = 8;
        std::vector<Index> models(classes.count(), no_face);
        std::vector<unsigned char> looks_left(classes.count(), most_looks);
        std::size_t left = classes.count(); // classes for which a face is looked for
        for (class_number c = 0; c < classes.count(); ++c)
            if (not may_have_one(c)) {
                looks_left[c] = 0;
                --left;
            }
        for (std::size_t f = 0; left != 0 and f < classes.of_faces().size(); ++f)
            if (const class_number c = classes.of_faces()[f]; c != classes.none and looks_left[c] != 0) {
                --looks_left[c];
                walk.around(f);
                if (walk.is_disk()) {
                    models[c] = Index(f);
                    looks_left[c] = 0;
                    found(c);
                }
                left -= looks_left[c] == 0;
            }
        return models;
    }

    /// Takes the template of each class, or nullptr for a class without one.
    patched_level(const face_classes<Index>& classes, std::vector<typename templates::pointer> of_class,
                  recorder_pointer recorder, const patch_plan& plan)
        : vertices_(plan.last().vertices), is_worth_threads_(detail::is_worth_threads(plan.last().faces))
    {
        std::vector<class_number> template_of_class(of_class.size(), none);
        for (std::size_t c = 0; c < of_class.size(); ++c)
            if (of_class[c] != nullptr) {
                template_of_class[c] = class_number(templates_.size());
                std::vector<Index>& bases = bases_.emplace_back();
                for (const auto& m : of_class[c]->multiples)
                    bases.push_back(patch_numbers<Index>::base(m, plan.bases, recorder->degree()));
                templates_.push_back(std::move(of_class[c]));
            }
        auto without_template = put_into_batches(classes, template_of_class);
        if (not without_template.empty())
            clusters_.emplace(std::move(recorder), std::move(without_template));
    }

    /// Collects the faces of each template in batches, in their order. Returns the faces without a template.
    std::vector<Index> put_into_batches(const face_classes<Index>& classes,
                                        std::span<const class_number> template_of_class)
    {
        std::vector<Index> without_template, waiting(templates_.size() * filler::at_once);
        std::vector<std::uint8_t> count(templates_.size(), 0);
        faces_.reserve(classes.of_faces().size());
        batches_.reserve(classes.of_faces().size() / filler::at_once + templates_.size());
        const auto flush = [&](class_number t) {
            const auto first = waiting.begin() + std::ptrdiff_t(t * filler::at_once);
            batches_.push_back({t, Index(faces_.size()), count[t]});
            faces_.insert(faces_.end(), first, first + count[t]);
            count[t] = 0;
        };
        for (std::size_t f = 0; f < classes.of_faces().size(); ++f) {
            const class_number c = classes.of_faces()[f];
            if (c == classes.none)
                continue;
            const class_number t = template_of_class[c];
            if (t == none) {
                without_template.push_back(Index(f));
                continue;
            }
            waiting[t * filler::at_once + count[t]++] = Index(f);
            if (count[t] == filler::at_once)
                flush(t);
        }
        for (std::size_t t = 0; t < count.size(); ++t)
            if (count[t] != 0)
                flush(class_number(t));
        return without_template;
    }

    [[nodiscard]] std::span<const Index> faces_of(const batch& b) const
    {
        return std::span(faces_).subspan(b.first, b.count);
    }
    [[nodiscard]] std::span<Index> found_of(const batch& b)
    {
        return std::span(found_).subspan(b.found, filler::numbers_found(*templates_[b.of]));
    }
    [[nodiscard]] std::span<const Index> found_of(const batch& b) const
    {
        return std::span(found_).subspan(b.found, filler::numbers_found(*templates_[b.of]));
    }

    std::size_t vertices_; // of the last level
    bool is_worth_threads_;
    std::vector<typename templates::pointer> templates_;
    std::vector<std::vector<Index>> bases_; // of the multiples of each template
    std::vector<batch> batches_;
    std::vector<Index> faces_;                            // batch after batch
    storage<Index> found_;                                // batch after batch; empty if nothing is kept
    std::optional<face_clusters<Point, Index>> clusters_; // of the faces without a template
};

// Defined outside of the class, so that files that declare it `extern template` do not compile them.

template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
std::optional<patched_level<Point, Index>>
patched_level<Point, Index>::make(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes,
                                  recorder_pointer recorder, const patch_plan& plan, const strategy_costs& costs,
                                  bool with_edges)
{
    const patch_estimate estimate(costs, plan.sizes(), classes.sizes(), with_edges);
    const templates& kept = recorder->templates();
    const bool may_be_kept = not kept.empty() and
                             double(classes.count()) * costs.least_of_classes <= double(mesh.face_count());
    if (not may_be_kept and not estimate.is_gain_without_kept())
        return {};
    face_walk<Index> walk(mesh.topology(), plan.rings);
    state_marks<Index> marks = recorder->marks_on(mesh.topology());
    std::vector<typename templates::pointer> of_class(classes.count());
    std::vector<template_choice> choices(classes.count(), template_choice::none);
    const auto models = models_of(
        classes,
        walk,
        [&](class_number c) { return may_be_kept or estimate.gains(c); },
        [&](class_number c) {
            of_class[c] = kept.find(marks.key(walk));
            choices[c] = of_class[c] != nullptr ? template_choice::kept
                         : estimate.gains(c)    ? template_choice::made
                                                : template_choice::none;
        });
    if (not estimate.is_gain(choices))
        return {};
    std::vector<class_number> wanted;
    std::vector<Index> models_of_wanted;
    for (class_number c = 0; c < classes.count(); ++c)
        if (choices[c] == template_choice::made) {
            wanted.push_back(c);
            models_of_wanted.push_back(models[c]);
        }
    constexpr std::size_t worth_threads = 8;
    detail::for_parts(
        wanted.size(),
        detail::is_worth_threads(plan.last().faces),
        [&](std::size_t begin, std::size_t end) {
            if (begin == end) // often all templates are kept ones
                return;
            template_maker<Point, Index> maker(mesh, *recorder, plan.rings);
            maker.make(std::span(models_of_wanted).subspan(begin, end - begin),
                       [&](std::size_t i, const std::u16string& key, auto&& made) {
                           of_class[wanted[begin + i]] = kept.keep(key, std::move(made));
                       });
        },
        worth_threads);
    return patched_level(classes, std::move(of_class), std::move(recorder), plan);
}

template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
void patched_level<Point, Index>::keep_what_is_found(const basic_mesh<Point, Index>& mesh)
{
    std::size_t size = 0;
    for (batch& b : batches_) {
        b.found = size;
        size += filler::numbers_found(*templates_[b.of]);
    }
    found_ = storage<Index>(size);
    detail::for_parts(batches_.size(), is_worth_threads_, [&](std::size_t begin, std::size_t end) {
        filler finder(mesh, {}, false);
        for (std::size_t i = begin; i < end; ++i)
            finder.find(*templates_[batches_[i].of], faces_of(batches_[i]), found_of(batches_[i]));
    });
}

template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
void patched_level<Point, Index>::fill(const basic_mesh<Point, Index>& mesh, const output& to) const
{
    constexpr std::size_t cached_bytes = std::size_t(4) << 20;
    const bool past_caches = vertices_ * sizeof(Point) > cached_bytes;
    detail::for_shared_parts(batches_.size(), batches_at_once, is_worth_threads_, [&](detail::parts_to_do parts) {
        filler one(mesh, to, past_caches);
        storage<Index> here;
        parts.for_each([&](std::size_t begin, std::size_t end) {
            for (const batch& b : std::span(batches_).subspan(begin, end - begin)) {
                const auto& t = *templates_[b.of];
                std::span<const Index> found;
                if (found_.size() != 0) {
                    found = found_of(b);
                } else {
                    ensure_size(here, filler::numbers_found(t));
                    one.find(t, faces_of(b), here);
                    found = here;
                }
                one.call_for(t, found);
                one.fill(t, bases_[b.of], found, b.count);
            }
        });
        publish();
    });
    if (clusters_)
        clusters_->fill(mesh, to, is_worth_threads_);
}

/// Returns the patches of a level with this scheme, or nothing if they are no gain. Returns nothing, too, if the counts
/// of the level are not those of the plan. Cost: O(faces), and that of the templates.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
std::optional<patched_level<Point, Index>>
make_patches(const basic_mesh<Point, Index>& mesh, const face_classes<Index>& classes, const Scheme& scheme,
             const patch_plan& plan, const strategy_costs& costs, bool with_edges = false,
             const patch_output_kind<scalar_of<Point>, Index, Scheme>& kind = {})
{
    if (not plan.has_counts_of(mesh.topology(), scheme, mesh.generation()))
        return {};
    return patched_level<Point, Index>::make(
        mesh, classes, recorder_of(scheme, plan, mesh.generation(), kind), plan, costs, with_edges);
}

#endif

} // namespace kith
