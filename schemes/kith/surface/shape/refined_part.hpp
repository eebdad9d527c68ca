// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_shape.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/core/mesh/close_boundary_loops.hpp>
#include <kith/numbering/step/step.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

namespace kith::detail {

/// The part of a shape after some steps, and the faces that these steps have made of its face.
template <class Shape>
struct refined_part {
    using mesh_type = typename Shape::mesh_type;
    using scheme_type = typename Shape::scheme_type;
    using index_type = typename Shape::index_type;
    using mark_type = typename Shape::rule_type::mark_type;
    using domain = typename Shape::domain;

    /// Returns the part before the first step. For schemes of closed meshes the part is closed, too far from the face
    /// to matter.
    static refined_part of(const Shape& here)
    {
        refined_part result{here.mesh, here.scheme, {}, {}, {here.face}};
        if constexpr (needs_closed<scheme_type>)
            result.mesh = close_boundary_loops(here.mesh);
        if constexpr (not Shape::has_points) {
            const auto& [inputs, marks] = here.values;
            const auto units = unit_rows(here.inputs);
            result.rows = storage<stencil_row>(result.mesh.corner_count());
            for (std::size_t c = 0; c < result.rows.size(); ++c)
                result.rows[c] = units[c < inputs.size() ? inputs[c] : 0];
            result.marks = storage<mark_type>(marks.empty() ? 0 : result.rows.size());
            for (std::size_t c = 0; c < result.marks.size(); ++c)
                result.marks[c] = c < marks.size() ? marks[c] : mark_type{};
        }
        return result;
    }
    /// Returns the part after a further step. `rule` refines values at corners.
    template <class Rule>
    [[nodiscard]] refined_part refined([[maybe_unused]] const Rule& rule) const
    {
        const auto& topology = mesh.topology();
        const int generation = mesh.generation();
        numbering_of<scheme_type, index_type> ids;
        refined_part result{refine_mesh<connect::everything>(mesh, scheme, ids), scheme};
        const level_of<mesh_type> coarse(mesh);
        if constexpr (not Shape::has_points)
            std::tie(result.rows, result.marks) = rule.template after<stencil_row>(
                std::span<const stencil_row>(rows.data(), rows.size()),
                std::span<const mark_type>(marks.data(), marks.size()),
                step_result<scheme_type, level_of<mesh_type>, decltype(ids), mesh_type>{
                    scheme, coarse, generation, ids, result.mesh});
        advance(result.scheme, coarse, generation, ids, result.mesh);
        for (const index_type f : faces) {
            const domain_face face = look_at(topology, scheme, generation, f);
            for (std::size_t k = 0; k < domain::children(face); ++k) {
                result.faces.push_back(index_type(domain::child(topology, ids, face, k)));
                result.first.push_back(domain::vertex_of_child(topology, ids, face, k));
            }
        }
        return result;
    }

    mesh_type mesh;
    scheme_type scheme;
    storage<stencil_row> rows{}; ///< of corners, if these have values
    storage<mark_type> marks{};
    std::vector<index_type> faces{};
    std::vector<std::size_t> first{}; ///< the vertices from which the cells of the faces are counted
};

} // namespace kith::detail
