// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_part.hpp"
#include "template_assembler.hpp"

#include <kith/level/native_level.hpp>
#include <kith/neighbourhood/placed_state.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// Makes templates of a scheme for the faces of one level.
template <scheme Scheme, class Point, std::unsigned_integral Index>
class template_maker {
    using scalar = scalar_of<Point>;
    using value = recorded<scalar>;
    using numbering = numbering_of<Scheme, Index>;
    static constexpr int degree = int(numbering::common_degree);
    static constexpr double cost_of_cut = 0; // what is written down costs more

public:
    /// For the level of a mesh, which has its edges and, if there is one, the degree of refined faces and must outlive
    /// this, and one step for each of the bases, by the scheme of the level.
    template_maker(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, std::span<const column_bases> bases)
        : mesh_(mesh)
        , scheme_(scheme)
        , plain_(without_state(scheme))
        , bases_(bases)
        , rings_(rings_before_steps(scheme, bases.size()))
    {
    }

    /// Of the face that was walked around last; nothing where it is too large to be numbered.
    [[nodiscard]] std::optional<patch_template<scalar, Index>> make(const face_walk<Index>& walk)
    {
        std::vector<Index> faces(walk.faces().begin(), walk.faces().end());
        std::ranges::sort(faces);
        if (not cutter_)
            cutter_.emplace(mesh_);
        const auto part = cutter_->cut(faces);
        const sources_of_part<Index> sources(
            part.mesh.topology(), std::size_t(degree), part.face_from, part.edge_is_turned, walk.faces());

        auto numbers = sources.numbers();
        storage<value> points(part.mesh.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = value(std::uint32_t(v));
        tape_.restart(points.size());
        const recording<scalar> here(tape_);
        const auto refine = [&](const basic_mesh<value, Index>& mesh, const Scheme& of_level, numbering& ids) {
            if constexpr (degree == 0)
                return refine_mesh<connect::everything>(mesh, of_level, ids);
            else
                return refine_level<connect::everything>(
                    level_elements<native_level<value, Index, degree>>(mesh), of_level, mesh.generation(), ids);
        };
        Scheme scheme = plain_;
        take_state_of_part(scheme, scheme_, part.numbers());
        const auto before_last = refine_part(
            basic_mesh<value, Index>(std::move(points), part.mesh.topology(), mesh_.generation()),
            scheme,
            numbers,
            bases_,
            rings_,
            [&](const affine_number<Index>& face) { return sources.is_owned(face.source); },
            cost_of_cut,
            refine);
        numbering ids;
        const auto fine = refine(before_last, scheme, ids);
        numbers = numbers.next(before_last.topology(), ids, bases_.back());
        return assembler_.assemble(walk, sources, numbers, fine, tape_);
    }

private:
    const basic_mesh<Point, Index>& mesh_;
    const Scheme& scheme_;
    Scheme plain_; // without its state
    std::span<const column_bases> bases_;
    std::vector<int> rings_;
    std::optional<submesh_cutter<Point, Index>> cutter_; // from the first template on: often all are kept ones
    tape<scalar> tape_;                                  // of one template after the other
    template_assembler<scalar, Index> assembler_;
};

} // namespace kith
