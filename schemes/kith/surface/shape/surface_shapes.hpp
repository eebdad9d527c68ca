// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canonical_part.hpp"
#include "refined_part.hpp"
#include "shape_polynomials.hpp"

#include <kith/core/base/platform.hpp>
#include <kith/core/mask/stencil.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <concepts>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// The shapes of the parts of a mesh around its faces, and of those around the faces that steps make of them. Parts of
/// one shape have the same polynomials. The scheme itself refines a part of each shape once, with rows of weights for
/// points. If a rule is given, this rule refines rows for values at corners instead. Several threads may use an object
/// at once: shapes do not depend on which thread makes them.
template <std::unsigned_integral Index, parametric_scheme Scheme, class Rule = as_points>
class surface_shapes {
public:
    using shape = surface_shape<Index, Scheme, Rule>;

    /// A part of a mesh around a face.
    struct part {
        const connectivity<Index>& mesh;
        int generation;
        const Scheme& scheme;
        Index face;
        std::vector<Index> first_alike{}; ///< for each corner the first one at its vertex with the same value; for
                                          ///< for each corner the first one at its vertex with the same value; for
                                          ///< values at corners only
        storage<typename Rule::mark_type> marks{};
    };

    explicit surface_shapes(const Scheme& scheme, const Rule& rule = Rule())
        : rings_(rings_of_surface(scheme)), rule_(rule), polynomials_(degree_of_polynomials(scheme))
    {
    }

    /// Returns the shape of a part, and for each input of the shape a corner of the part that has it.
    std::pair<shape*, std::vector<Index>> of_part(const part& around)
    {
        const std::lock_guard lock(mutex_);
        return add_part(around);
    }

    /// Makes the children and polynomials of a shape and of all shapes that it leads to.
    void look(shape& here)
    {
        if (here.is_decided.load(std::memory_order_acquire))
            return;
        const std::lock_guard lock(mutex_);
        try {
            decide(here);
        } catch (...) { // open shapes can be decided again
            for (shape* const open : open_)
                open->number = 0;
            open_.clear();
            throw;
        }
    }

    /// Follows a place down to the piece of the surface in which it lies: calls descend(k) for each child on the way.
    /// Returns the polynomial over the inputs of the last shape, or nullptr if a boundary cuts off the place. `corner`
    /// is the sub-face of the place if the face has sub-faces, and `at` becomes the parameters in the piece. Cost:
    /// O(depth); a shape that is met for the first time costs a step.
    template <class Descend>
    const surface_polynomial* find(shape& root, std::size_t corner, face_parameters& at, const Descend& descend)
    {
        std::size_t cell = domain::enter(root.in_domain, corner, at);
        shape* here = &root;
        int steps_without = 0; // steps after which no polynomial follows
        for (int depth = 0;; ++depth) {
            look(*here);
            if (here->polynomials[cell])
                return here->polynomials[cell].get();
            if (here->has_corner_limits)
                if (const auto* limit = limit_at_corner(*here, cell, at)) {
                    at = {0, 0};
                    return limit;
                }
            if constexpr (not domain::has_polynomials_at_boundaries)
                if (depth >= domain::steps and here->at_walls[cell] and
                    (domain::is_at_wall(here->in_domain, cell, at) or
                     domain::corner_at(here->in_domain, cell, {at.s, at.t}) != domain::sides))
                    return here->at_walls[cell].get();
            steps_without += here->leads_to_polynomials ? 0 : 1;
            if (depth == domain::most_steps or steps_without > domain::steps)
                return here->at_end.get();
            const child_cell next = detail::descend(*here, cell, at);
            here = here->children[next.child].of;
            if (here == nullptr)
                return nullptr;
            descend(next.child);
            cell = next.cell;
        }
    }

private:
    using domain = domain_of<Scheme>;
    using mesh_type = typename shape::mesh_type;

    /// Returns the limit at a corner of the face, if a place is there and has one.
    static const surface_polynomial* limit_at_corner(const shape& here, std::size_t cell, const face_parameters& at)
    {
        const std::size_t corner = domain::corner_at(here.in_domain, cell, {at.s, at.t});
        return corner == domain::sides ? nullptr : here.at_corners[corner].get();
    }
    std::pair<shape*, std::vector<Index>> add_part(const part& around)
    {
        auto canonical = make_canonical(
            around.mesh, around.generation, around.scheme, around.face, domain::keeps_first_corners);
        std::vector<Index> input_from;
        auto values = number_inputs(around, canonical, input_from);
        const auto add = [&] {
            shapes_.push_back(std::make_unique<shape>(mesh_of_units(std::move(canonical.mesh), around.generation),
                                                      std::move(values),
                                                      input_from.size(),
                                                      std::move(canonical.scheme),
                                                      canonical.face,
                                                      not canonical.key.empty()));
            return shapes_.back().get();
        };
        if (canonical.key.empty())
            return {add(), std::move(input_from)};
        shape*& known = by_key_[canonical.key];
        if (known == nullptr)
            known = add();
        return {known, std::move(input_from)};
    }
    /// Numbers the inputs by canonical corners, which are listed by vertices. Appends the differences between parts to
    /// the key.
    static typename shape::corner_values number_inputs(const part& around, canonical_part<Index, Scheme>& canonical,
                                                       std::vector<Index>& input_from)
    {
        const auto& from = canonical.corner_from;
        if constexpr (shape::has_points) {
            input_from.resize(canonical.mesh.vertices);
            for (std::size_t c = from.size(); c-- > 0;)
                input_from[canonical.mesh.corner_vertex[c]] = from[c];
            return {};
        } else {
            constexpr Index none = connectivity<Index>::none;
            typename shape::corner_values values{std::vector<Index>(from.size())};
            std::vector<Index> input_of(from.size(), none);
            for (std::size_t c = 0; c < from.size(); ++c) {
                Index& input = input_of[around.first_alike[from[c]]];
                if (input == none) {
                    input = Index(input_from.size());
                    input_from.push_back(from[c]);
                }
                values.inputs[c] = input;
            }
            if (not around.marks.empty()) {
                values.marks = storage<typename Rule::mark_type>(from.size());
                for (std::size_t c = 0; c < from.size(); ++c)
                    values.marks[c] = around.marks[from[c]];
            }
            if (not canonical.key.empty()) {
                for (const Index input : values.inputs)
                    canonical.key += char32_t(input);
                for (const auto& mark : values.marks)
                    for (const std::byte b : std::bit_cast<std::array<std::byte, sizeof(mark)>>(mark))
                        canonical.key += char32_t(b);
            }
            return values;
        }
    }
    static mesh_type mesh_of_units(connectivity<Index> topology, int generation)
    {
        if constexpr (shape::has_points) {
            const auto units = unit_rows(topology.vertices);
            return {storage<stencil_row>(units), std::move(topology), generation};
        } else {
            return {storage<double>(topology.vertices, 0), std::move(topology), generation};
        }
    }

    /// Decides a shape, and all shapes that it leads to. Shapes that lead to one another are decided together, after
    /// all others: Tarjan 1972.
    void decide(shape& here)
    {
        if (here.is_decided)
            return;
        split(here);
        here.number = here.oldest = ++last_number_;
        open_.push_back(&here);
        if (here.has_key) // other shapes have new children on every level
            for (const auto& child : here.children) {
                if (child.of == nullptr)
                    continue;
                if (child.of->number == 0)
                    decide(*child.of);
                if (not child.of->is_decided)
                    here.oldest = std::min(here.oldest, child.of->oldest);
            }
        if (here.oldest != here.number)
            return;
        const auto first = std::ranges::find(open_, &here);
        polynomials_.decide(std::span(first, open_.end()));
        open_.erase(first, open_.end());
    }

    /// Makes the children of a shape: the parts around the faces that steps make of its face.
    void split(shape& here)
    {
        if (not here.children.empty())
            return;
        auto fine = refined_part<shape>::of(here);
        for (int step = 0; step < domain::steps_at_once; ++step)
            fine = fine.refined(rule_);
        submesh_cutter<typename mesh_type::point_type, Index> cutter(fine.mesh);
        std::vector<typename shape::child> children;
        for (std::size_t k = 0; k < fine.faces.size(); ++k)
            children.push_back(make_child(here, fine, cutter, k));
        here.children = std::move(children);
    }
    /// Makes child k of a shape.
    template <class Cutter>
    typename shape::child make_child(const shape& parent, const refined_part<shape>& fine, Cutter& cutter,
                                     std::size_t k)
    {
        const Index f = fine.faces[k];
        if (f == connectivity<Index>::none)
            return {nullptr, {}, 0};
        const auto cut = cutter.cut(domain::faces_around(cutter, fine.mesh.topology(), f, rings_));
        Scheme of_part = fine.scheme;
        restrict_state(of_part, fine.scheme, cut.numbers());
        const auto place = std::ranges::lower_bound(cut.face_from, f) - cut.face_from.begin();
        part around{cut.mesh.topology(), fine.mesh.generation(), of_part, Index(place)};
        const auto corners = corners_of(fine.mesh.topology(), around.mesh, std::span<const Index>(cut.face_from));
        if constexpr (not shape::has_points) {
            around.first_alike = first_alike(
                around.mesh, [&](Index a, Index b) { return fine.rows[corners[a]] == fine.rows[corners[b]]; });
            around.marks = storage<typename Rule::mark_type>(fine.marks.empty() ? 0 : corners.size());
            for (std::size_t c = 0; c < around.marks.size(); ++c)
                around.marks[c] = fine.marks[corners[c]];
        }
        const auto [child, input_from] = add_part(around);
        std::vector<stencil_row> rows;
        for (const Index corner : input_from)
            if constexpr (shape::has_points)
                rows.push_back(fine.mesh.point(fine.mesh.topology().corner_vertex[corners[corner]]));
            else
                rows.push_back(fine.rows[corners[corner]]);
        const auto face = fine.mesh.face(f);
        const auto first = std::size_t(std::ranges::find(face, fine.first[k]) - face.begin()) % face.size();
        return {child, make_matrix(rows, parent.inputs), first};
    }

    int rings_;
    [[no_unique_address]] Rule rule_;
    shape_polynomials<shape> polynomials_;
    mutex mutex_;
    std::vector<std::unique_ptr<shape>> shapes_;
    std::vector<shape*> open_; // met by a search and not decided
    std::size_t last_number_ = 0;
    std::unordered_map<std::u32string, shape*> by_key_;
};

} // namespace detail

} // namespace kith
