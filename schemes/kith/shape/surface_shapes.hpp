// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canonical_part.hpp"
#include "shape_polynomials.hpp"

#include <kith/mask/stencil.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

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
/// one shape have the same polynomials. The scheme's own text refines a part of each shape once, with rows of weights
/// for points. If a rule is given, this rule refines rows for values at corners instead. Several threads may use an
/// object at once: shapes do not depend on which thread makes them.
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
                                          ///< values at corners only
        storage<typename Rule::mark_type> marks{};
    };

    explicit surface_shapes(const Scheme& scheme, const Rule& rule = Rule())
        : rings_(rings_of_surface(scheme)), rule_(rule)
    {
    }

    /// Returns the shape of a part, and for each of its inputs a corner of the part that has it.
    std::pair<shape*, std::vector<Index>> of_part(const part& around)
    {
        const std::scoped_lock lock(mutex_);
        return add_part(around);
    }

    /// Makes what a shape leads to.
    void look(shape& here)
    {
        if (here.is_decided.load(std::memory_order_acquire))
            return;
        const std::scoped_lock lock(mutex_);
        try {
            decide(here);
        } catch (...) { // what was open can be decided again
            for (shape* const open : open_)
                open->number = 0;
            open_.clear();
            throw;
        }
    }

    /// Follows a place down to the piece of the surface that it lies in: calls descend(k) for each child on the way.
    /// Returns the polynomial over the inputs of the last shape. `corner` is the sub-face of the place if the face has
    /// sub-faces, and `at` becomes the parameters in the piece.
    /// Cost: O(depth); a shape that is met for the first time costs a step.
    template <class Descend>
    const surface_polynomial* find(shape& root, std::size_t corner, face_parameters& at, const Descend& descend)
    {
        std::size_t cell = domain::enter(root.in_domain.degree, corner, at);
        shape* here = &root;
        int steps_without = 0; // with no polynomial to come
        for (int depth = 0;; ++depth) {
            look(*here);
            if (here->polynomials[cell])
                return here->polynomials[cell].get();
            if (here->has_corner_limits)
                if (const auto* limit = limit_at_corner(*here, at)) {
                    at = {0, 0};
                    return limit;
                }
            steps_without += here->leads_to_polynomials ? 0 : 1;
            if (depth == most_steps or steps_without > domain::steps)
                return here->at_end.get();
            const child_cell next = detail::descend(*here, cell, at);
            descend(next.child);
            here = here->children[next.child].of;
            cell = next.cell;
        }
    }

private:
    using domain = domain_of<Scheme>;
    using mesh_type = typename shape::mesh_type;

    /// Returns the limit at a corner of the face, if a place is there and has one.
    static const surface_polynomial* limit_at_corner(const shape& here, const face_parameters& at)
    {
        const auto corner = std::ranges::find(domain::corners, std::array{at.s, at.t});
        return corner == domain::corners.end() ? nullptr
                                               : here.at_corners[std::size_t(corner - domain::corners.begin())].get();
    }
    std::pair<shape*, std::vector<Index>> add_part(const part& around)
    {
        auto canonical = make_canonical(around.mesh, around.generation, around.scheme, around.face);
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
    /// Numbers the inputs by canonical corners, which are listed by vertices. Adds what tells parts apart to the key.
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

    /// Decides a shape, and all that it leads to. Those that lead to one another are decided together, after all
    /// others: Tarjan 1972.
    void decide(shape& here)
    {
        if (here.is_decided)
            return;
        split(here);
        here.number = here.oldest = ++last_number_;
        open_.push_back(&here);
        if (here.has_key) // the children of all others are new ones for ever
            for (const auto& child : here.children) {
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

    /// Makes the children of a shape: the parts around the faces that a step makes of its face.
    void split(shape& here)
    {
        if (not here.children.empty())
            return;
        numbering_of<Scheme, Index> ids;
        const auto fine = refine_mesh<connect::everything>(here.mesh, here.scheme, ids);
        const level_of<mesh_type> coarse(here.mesh);
        [[maybe_unused]] const auto fine_values = values_after(
            here,
            made_step<Scheme, level_of<mesh_type>, decltype(ids), mesh_type>{
                here.scheme, coarse, here.mesh.generation(), ids, fine});
        Scheme scheme = here.scheme;
        advance(scheme, coarse, here.mesh.generation(), ids, fine);
        submesh_cutter<typename mesh_type::point_type, Index> cutter(fine);
        std::vector<typename shape::child> children;
        for (std::size_t k = 0; k < domain::children(here.in_domain); ++k) {
            const std::array<Index, 1> seed{Index(domain::child(here.mesh.topology(), ids, here.face, k))};
            const auto cut = cutter.cut(cutter.faces_around(seed, rings_));
            Scheme of_part = scheme;
            take_part(of_part, scheme, cut.numbers());
            const auto place = std::ranges::lower_bound(cut.face_from, seed[0]) - cut.face_from.begin();
            part around{cut.mesh.topology(), fine.generation(), of_part, Index(place)};
            const auto corners = corners_of(fine.topology(), around.mesh, std::span<const Index>(cut.face_from));
            if constexpr (not shape::has_points) {
                const auto& [fine_rows, fine_marks] = fine_values;
                around.first_alike = first_alike(
                    around.mesh, [&](Index a, Index b) { return fine_rows[corners[a]] == fine_rows[corners[b]]; });
                around.marks = storage<typename Rule::mark_type>(fine_marks.empty() ? 0 : corners.size());
                for (std::size_t c = 0; c < around.marks.size(); ++c)
                    around.marks[c] = fine_marks[corners[c]];
            }
            const auto [child, input_from] = add_part(around);
            std::vector<stencil_row> rows;
            for (const Index corner : input_from)
                if constexpr (shape::has_points)
                    rows.push_back(fine.point(fine.topology().corner_vertex[corners[corner]]));
                else
                    rows.push_back(fine_values.first[corners[corner]]);
            const auto face = fine.face(seed[0]);
            const std::size_t vertex = domain::vertex_of_child(here.mesh.topology(), ids, here.face, k);
            const auto first = std::size_t(std::ranges::find(face, vertex) - face.begin()) % face.size();
            children.push_back({child, make_matrix(rows, here.inputs), first});
        }
        here.children = std::move(children);
    }
    /// Returns rows and marks of the corners after a step.
    template <class Step>
    auto values_after(const shape& here, const Step& step) const
    {
        if constexpr (shape::has_points) {
            return 0;
        } else {
            const auto units = unit_rows(here.inputs);
            storage<stencil_row> rows(here.values.inputs.size());
            for (std::size_t c = 0; c < rows.size(); ++c)
                rows[c] = units[here.values.inputs[c]];
            return rule_.template after<stencil_row>(
                std::span<const stencil_row>(rows.data(), rows.size()),
                std::span<const typename Rule::mark_type>(here.values.marks.data(), here.values.marks.size()),
                step);
        }
    }

    int rings_;
    [[no_unique_address]] Rule rule_;
    shape_polynomials<shape> polynomials_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<shape>> shapes_;
    std::vector<shape*> open_; // that a search has met and not decided
    std::size_t last_number_ = 0;
    std::unordered_map<std::u32string, shape*> by_key_;
};

} // namespace detail

} // namespace kith
