// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kept_templates.hpp"
#include "patch_plan.hpp"
#include "template_assembler.hpp"

#include <kith/lane/tape.hpp>
#include <kith/level/native_level.hpp>
#include <kith/neighbourhood/placed_state.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// Tells what patches make for the vertices of the last level: their points, or other values in the place of points,
/// such as limits.
template <class Point, std::unsigned_integral Index, class Scheme>
struct patch_output_kind {
    using is_wanted = std::function<bool(std::size_t)>;
    /// Puts the values of wanted vertices in the place of their points, in a part of the last level.
    template <class Value>
    using replace = std::function<void(basic_mesh<Value, Index>& last, const Scheme&, const is_wanted&)>;

    std::size_t key = 0;             ///< a distinct constant per kind; it is part of the key of the template cache
    replace<Point> replace_points{}; ///< empty for points
    replace<recorded<scalar_of<Point>>> replace_recorded{}; ///< same, but for values that are recorded

    [[nodiscard]] bool are_points() const { return key == 0; }
};

/// A part of the last level, and the numbers of its elements in the whole mesh.
template <class Value, std::unsigned_integral Index, inherited_number Number>
struct refined_part {
    basic_mesh<Value, Index> mesh;
    part_of_whole<Number> numbers;
};

/// Refines parts of the level whose faces own patches up to the last level, whatever the scheme is. It is the bridge
/// from the text of a scheme, which is a template, to the code of patches, which is compiled once for all schemes. Its
/// virtual functions are called once per part, never per element.
template <class Point, std::unsigned_integral Index>
class part_refiner {
public:
    using scalar = scalar_of<Point>;
    using owned_part = refined_part<Point, Index, owned_number<Index>>;
    using recorded_part = refined_part<recorded<scalar>, Index, affine_number<Index>>;

    virtual ~part_refiner() = default;
    part_refiner(const part_refiner&) = delete;
    part_refiner& operator=(const part_refiner&) = delete;

    /// Returns the degree of the faces of all refined levels; 0 if they have several.
    [[nodiscard]] std::size_t degree() const { return degree_; }
    /// Returns how many rings a part must have around the faces that are wanted.
    [[nodiscard]] int rings() const { return rings_.front(); }
    /// Returns true if points are made, not other values in their place.
    [[nodiscard]] virtual bool makes_points() const = 0;
    /// Returns what the state of the scheme says of the elements of the level, which must outlive the result.
    [[nodiscard]] virtual state_marks<Index> marks_on(const connectivity<Index>& level) const = 0;
    /// Returns the templates that are kept of this scheme for these steps.
    [[nodiscard]] const kept_templates<scalar, Index>& templates() const { return templates_; }

    /// Refines a part over points. `numbers` are those of its elements; an owned face is wanted. Edges of the last level
    /// are made if they are asked for or needed. Errors and cost: those of the steps.
    [[nodiscard]] virtual owned_part refine(submesh<Point, Index> part, part_of_whole<owned_number<Index>> numbers,
                                            bool with_edges) const = 0;
    /// Refines a part over what records the text of the scheme on the tape of this thread. `from` tells which elements
    /// of the level the part has. A face is wanted if a model owns it. Errors and cost: those of the steps.
    [[nodiscard]] virtual recorded_part record(basic_mesh<recorded<scalar>, Index> part,
                                               const part_numbers<Index>& from,
                                               const sources_of_part<Index>& sources) const = 0;

protected:
    part_refiner(std::size_t degree, std::vector<int> rings, std::vector<column_bases> bases,
                 kept_templates<scalar, Index> templates)
        : degree_(degree), rings_(std::move(rings)), bases_(std::move(bases)), templates_(std::move(templates))
    {
    }

    std::size_t degree_;
    std::vector<int> rings_;          // before each step
    std::vector<column_bases> bases_; // of each step
    kept_templates<scalar, Index> templates_;
};

namespace detail {

/// The part refiner of a scheme.
template <scheme Scheme, class Point, std::unsigned_integral Index>
class part_refiner_of final : public part_refiner<Point, Index> {
    using base = part_refiner<Point, Index>;
    using numbering = numbering_of<Scheme, Index>;
    using typename base::owned_part;
    using typename base::recorded_part;
    using typename base::scalar;

public:
    using output_kind = patch_output_kind<Point, Index, Scheme>;

    /// For the level of this generation that a plan begins with, and the scheme there.
    part_refiner_of(const Scheme& scheme, const patch_plan& plan, int generation, output_kind kind)
        : base(numbering::common_degree, rings_before_steps(scheme, plan.bases.size(), plan.last_rings), plan.bases,
               kept_templates<scalar, Index>::of(without_state(scheme), generation, plan.rings, plan.bases.size(),
                                                 kind.key))
        , scheme_(scheme)
        , plain_(without_state(scheme))
        , kind_(std::move(kind))
    {
    }

    [[nodiscard]] bool makes_points() const override { return kind_.are_points(); }
    [[nodiscard]] state_marks<Index> marks_on(const connectivity<Index>& level) const override
    {
        return {level, scheme_};
    }
    [[nodiscard]] owned_part refine(submesh<Point, Index> part, part_of_whole<owned_number<Index>> numbers,
                                    bool with_edges) const override
    {
        // As measured: where few steps are left, or a part is compact, rings that are made in vain cost less than
        // cutting them off.
        constexpr double cost_of_cut = 16;
        const auto from = part.numbers();
        return last_of(
            std::move(part.mesh),
            from,
            std::move(numbers),
            [](const owned_number<Index>& element) { return element.owned; },
            cost_of_cut,
            with_edges or not makes_points(),
            kind_.replace_points);
    }
    [[nodiscard]] recorded_part record(basic_mesh<recorded<scalar>, Index> part, const part_numbers<Index>& from,
                                       const sources_of_part<Index>& sources) const override
    {
        constexpr double cost_of_cut = 0; // what is written down costs more
        return last_of(
            std::move(part),
            from,
            sources.numbers(),
            [&](const affine_number<Index>& element) { return sources.owner(element.source) != sources.no_model; },
            cost_of_cut,
            true,
            kind_.replace_recorded);
    }

private:
    /// Makes a step. A level that is recorded has faces of the degree of refined ones, if these have one.
    template <connect Connect, class Value>
    static basic_mesh<Value, Index> step(const basic_mesh<Value, Index>& mesh, const Scheme& scheme, numbering& ids)
    {
        constexpr int degree = int(numbering::common_degree);
        if constexpr (std::same_as<Value, recorded<scalar>> and degree != 0)
            return refine_level<connect::everything>(
                level_elements<native_level<Value, Index, degree>>(mesh), scheme, mesh.generation(), ids);
        else
            return refine_mesh<Connect>(mesh, scheme, ids);
    }

    /// Makes all steps of a part. `is_own` tells by the number of an element whether it is wanted. After a step all is
    /// cut off that no wanted face needs, where that costs less than refining it: for a wanted face as much as making
    /// `cost_of_cut` faces. Precondition: the rings of the first step are there.
    template <class Value, inherited_number Number, class IsOwn, class Replace>
    refined_part<Value, Index, Number> last_of(basic_mesh<Value, Index> part, const part_numbers<Index>& from,
                                               part_of_whole<Number> numbers, const IsOwn& is_own, double cost_of_cut,
                                               bool with_edges, const Replace& replace) const
    {
        const std::vector<column_bases>& bases = this->bases_;
        Scheme scheme = plain_;
        take_state_of_part(scheme, scheme_, from);
        numbering ids;
        for (std::size_t i = 0; i + 1 < bases.size(); ++i) {
            auto fine = step<connect::everything>(part, scheme, ids);
            advance(scheme, level_of<basic_mesh<Value, Index>>(part), part.generation(), ids, fine);
            numbers = numbers.next(part.topology(), ids, bases[i]);
            const double made_of_each = std::pow(double(fine.face_count()) / double(part.face_count()),
                                                 bases.size() - i - 1);
            part = std::move(fine);
            std::vector<Index> own;
            for (std::size_t f = 0; f < numbers.faces.size(); ++f)
                if (is_own(numbers.faces[f]))
                    own.push_back(Index(f));
            if (double(part.face_count() - own.size()) * made_of_each <= cost_of_cut * double(own.size()))
                continue;
            submesh_cutter<Value, Index> cutter(part);
            auto cut = cutter.cut(cutter.faces_around(own, this->rings_[i + 1]));
            numbers = numbers.template of_part<Index>(cut.vertex_from, cut.edge_from, cut.face_from);
            take_state_of_part(scheme, scheme, cut.numbers());
            part = std::move(cut.mesh);
        }
        auto fine = with_edges ? step<connect::everything>(part, scheme, ids) : step<connect::faces>(part, scheme, ids);
        numbers = numbers.next(part.topology(), ids, bases.back(), with_edges);
        if (not kind_.are_points()) {
            advance(scheme, level_of<basic_mesh<Value, Index>>(part), part.generation(), ids, fine);
            replace(fine, scheme, [&](std::size_t v) { return is_own(numbers.vertices[v]); });
        }
        return {std::move(fine), std::move(numbers)};
    }

    Scheme scheme_, plain_; // of the level; without its state
    output_kind kind_;
};

} // namespace detail

} // namespace kith
