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
/// for points. Several threads may use an object at once: shapes do not depend on which thread makes them.
template <std::unsigned_integral Index, parametric_scheme Scheme>
class surface_shapes {
public:
    using shape = surface_shape<Index, Scheme>;

    explicit surface_shapes(const Scheme& scheme) : rings_(rings_of_surface(scheme)) {}

    /// Returns the shape of a part, and for each of its control points the vertex of the part.
    std::pair<shape*, std::vector<Index>> of_part(const connectivity<Index>& part, int generation, const Scheme& scheme,
                                                  Index face)
    {
        const std::scoped_lock lock(mutex_);
        return add_part(part, generation, scheme, face);
    }

    /// Makes what a shape leads to.
    void look(shape& here)
    {
        if (here.is_decided.load(std::memory_order_acquire))
            return;
        const std::scoped_lock lock(mutex_);
        decide(here);
    }

    /// Follows a place down to the piece of the surface that it lies in: calls descend(k) for each child on the way.
    /// Returns the polynomial over the control points of the last shape. `cell` is the sub-face of the place if the face
    /// has sub-faces, and `at` becomes the parameters in the piece.
    /// Cost: O(depth); a shape that is met for the first time costs a step.
    template <class Descend>
    const surface_polynomial* find(shape& root, std::size_t cell, face_parameters& at, const Descend& descend)
    {
        shape* here = &root;
        int steps_without = 0; // with no polynomial to come
        for (int depth = 0;; ++depth) {
            look(*here);
            if (here->polynomials[cell])
                return here->polynomials[cell].get();
            if (const auto corner = std::ranges::find(domain::corners, std::array{at.s, at.t});
                corner != domain::corners.end() and here->in_domain.degree == domain::sides)
                if (const auto& limit = here->at_corners[std::size_t(corner - domain::corners.begin())]) {
                    at = {0, 0};
                    return limit.get();
                }
            steps_without += here->leads_to_polynomials ? 0 : 1;
            if (depth == most_steps or steps_without > domain::steps)
                return here->at_end.get();
            const child_cell next = domain::descend(here->in_domain, cell, at);
            descend(next.child);
            here = here->children[next.child].of;
            cell = next.cell;
        }
    }

private:
    using domain = domain_of<Scheme>;
    using mesh_type = typename shape::mesh_type;

    std::pair<shape*, std::vector<Index>> add_part(const connectivity<Index>& part, int generation,
                                                   const Scheme& scheme, Index face)
    {
        auto canonical = make_canonical(part, generation, scheme, face);
        const auto add = [&] {
            shapes_.push_back(std::make_unique<shape>(mesh_of_units(std::move(canonical.mesh), generation),
                                                      std::move(canonical.scheme),
                                                      canonical.face,
                                                      not canonical.key.empty()));
            return shapes_.back().get();
        };
        if (canonical.key.empty())
            return {add(), std::move(canonical.vertex_from)};
        shape*& known = by_key_[canonical.key];
        if (known == nullptr)
            known = add();
        return {known, std::move(canonical.vertex_from)};
    }
    static mesh_type mesh_of_units(connectivity<Index> topology, int generation)
    {
        const auto units = unit_rows(topology.vertices);
        return {storage<stencil_row>(units), std::move(topology), generation};
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
        Scheme scheme = here.scheme;
        advance(scheme, level_of<mesh_type>(here.mesh), here.mesh.generation(), ids, fine);
        submesh_cutter<stencil_row, Index> cutter(fine);
        for (std::size_t k = 0; k < domain::children(here.in_domain); ++k) {
            const std::array<Index, 1> seed{Index(domain::child(here.mesh.topology(), ids, here.face, k))};
            const auto part = cutter.cut(cutter.faces_around(seed, rings_));
            Scheme of_part_scheme = scheme;
            take_part(of_part_scheme, scheme, part.numbers());
            const auto place = std::ranges::lower_bound(part.face_from, seed[0]) - part.face_from.begin();
            auto [child, vertex_from] = add_part(part.mesh.topology(), fine.generation(), of_part_scheme, Index(place));
            std::vector<stencil_row> rows;
            for (const Index v : vertex_from)
                rows.push_back(part.mesh.point(v));
            here.children.push_back({child, make_matrix(rows, here.vertices)});
        }
    }

    int rings_;
    shape_polynomials<shape> polynomials_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<shape>> shapes_;
    std::vector<shape*> open_; // that a search has met and not decided
    std::size_t last_number_ = 0;
    std::unordered_map<std::u32string, shape*> by_key_;
};

} // namespace detail

} // namespace kith
