// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kept_templates.hpp"
#include "patch_plan.hpp"
#include "template_assembler.hpp"

#include <kith/core/level/native_level.hpp>
#include <kith/engine/lane/tape.hpp>
#include <kith/engine/neighbourhood/face_children.hpp>
#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/numbering/step/submesh.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace kith {

/// The kind of output of patches at the vertices of the last level: their points, or other values in the place of
/// points, such as limits.
template <std::floating_point Scalar, std::unsigned_integral Index, class Scheme>
struct patch_output_kind {
    using is_wanted = std::function<bool(std::size_t)>;

    std::size_t key = 0; ///< a distinct constant per kind; it is part of the key of the template cache
    /// Writes the values of wanted vertices in the place of their points, in a part of the last level. The function is
    /// empty if the output is points.
    std::function<void(basic_mesh<recorded<Scalar>, Index>& last, const Scheme&, const is_wanted&)> replace_points{};

    [[nodiscard]] bool are_points() const { return key == 0; }
};

/// A part of the last level over recorded values, and the numbers of its elements in the whole mesh.
template <std::floating_point Scalar, std::unsigned_integral Index, inherited_number Number>
struct recorded_part {
    basic_mesh<recorded<Scalar>, Index> mesh;
    part_of_whole<Number> numbers;
};

/// A recorder of what some steps of any scheme make of parts of the level whose faces own patches. It connects the code
/// of a scheme, a C++ template, with the code of patches. The latter is compiled once for all schemes and numbers of
/// components. Virtual functions are called once per part, never per element.
template <std::floating_point Scalar, std::unsigned_integral Index>
class part_recorder {
public:
    using affine_part = recorded_part<Scalar, Index, affine_number<Index>>;
    using owned_part = recorded_part<Scalar, Index, owned_number<Index>>;

    virtual ~part_recorder() = default;
    part_recorder(const part_recorder&) = delete;
    part_recorder& operator=(const part_recorder&) = delete;

    /// Returns the degree of the faces of all refined levels; 0 if they have several.
    [[nodiscard]] std::size_t degree() const { return degree_; }
    /// Returns how many rings a part must have around the wanted faces.
    [[nodiscard]] int rings() const { return rings_.front(); }
    /// Returns the kept templates of this scheme for these steps.
    [[nodiscard]] const kept_templates<Scalar, Index>& templates() const { return templates_; }
    /// Returns the marks of the scheme's state on the level, which must outlive the result.
    [[nodiscard]] virtual state_marks<Index> marks_on(const connectivity<Index>& level) const = 0;

    /// Records the steps of a part of the level on the tape of this thread, to which the values of the part belong.
    /// `from` lists the elements of the level that the part has. A face is wanted if a model owns it, or if its number
    /// is owned. Errors and cost: those of the steps.
    [[nodiscard]] virtual affine_part record(basic_mesh<recorded<Scalar>, Index> part, const part_numbers<Index>& from,
                                             const sources_of_part<Index>& sources) const = 0;
    [[nodiscard]] virtual owned_part record(basic_mesh<recorded<Scalar>, Index> part, const part_numbers<Index>& from,
                                            part_of_whole<owned_number<Index>> numbers) const = 0;
    /// Returns the faces that a step makes of each face of a level, or nothing if these come from other faces, too.
    /// Precondition: the level has faces, and they have the degree of refined faces. Cost: O(elements), and a step
    /// around a face.
    [[nodiscard]] virtual std::optional<face_children> children_of_faces(const connectivity<Index>& level,
                                                                         int generation) const = 0;

protected:
    part_recorder(std::size_t degree, std::vector<int> rings, std::vector<column_bases> bases,
                  kept_templates<Scalar, Index> templates)
        : degree_(degree), rings_(std::move(rings)), bases_(std::move(bases)), templates_(std::move(templates))
    {
    }

    std::size_t degree_;
    std::vector<int> rings_;          // before each step
    std::vector<column_bases> bases_; // of each step
    kept_templates<Scalar, Index> templates_;
};

namespace detail {

/// The part recorder of a scheme.
template <scheme Scheme, std::floating_point Scalar, std::unsigned_integral Index>
class part_recorder_of final : public part_recorder<Scalar, Index> {
    using base = part_recorder<Scalar, Index>;
    using mesh = basic_mesh<recorded<Scalar>, Index>;
    using numbering = numbering_of<Scheme, Index>;
    using typename base::affine_part;
    using typename base::owned_part;

public:
    using output_kind = patch_output_kind<Scalar, Index, Scheme>;

    /// Takes the scheme at the level with which a plan begins, and the generation of that level.
    part_recorder_of(const Scheme& scheme, const patch_plan& plan, int generation, output_kind kind)
        : base(numbering::common_degree, rings_before_steps(scheme, plan.bases.size(), plan.last_rings), plan.bases,
               kept_templates<Scalar, Index>::of(without_state(scheme), generation, plan.rings, plan.bases.size(),
                                                 kind.key))
        , scheme_(scheme)
        , plain_(without_state(scheme))
        , kind_(std::move(kind))
    {
    }

    [[nodiscard]] state_marks<Index> marks_on(const connectivity<Index>& level) const override
    {
        return {level, scheme_};
    }
    [[nodiscard]] affine_part record(mesh part, const part_numbers<Index>& from,
                                     const sources_of_part<Index>& sources) const override
    {
        return last_of(std::move(part), from, sources.numbers(), [&](const affine_number<Index>& element) {
            return sources.owner(element.source) != sources.no_model;
        });
    }
    [[nodiscard]] owned_part record(mesh part, const part_numbers<Index>& from,
                                    part_of_whole<owned_number<Index>> numbers) const override
    {
        return last_of(std::move(part), from, std::move(numbers), [](const owned_number<Index>& element) {
            return element.owned;
        });
    }
    [[nodiscard]] std::optional<face_children> children_of_faces(const connectivity<Index>& level,
                                                                 int generation) const override
    {
        const mesh whole(storage<recorded<Scalar>>(level.vertices), connectivity<Index>(level), generation);
        submesh_cutter<recorded<Scalar>, Index> cutter(whole);
        auto part = cutter.cut(cutter.faces_around(std::vector<Index>{0}, 1)).mesh;
        for (std::size_t v = 0; v < part.vertex_count(); ++v)
            part.points()[v] = recorded<Scalar>(std::uint32_t(v));
        tape<Scalar> unused;
        unused.restart(part.vertex_count());
        const recording<Scalar> here(unused);
        numbering ids;
        const mesh fine = step(part, plain_, ids);
        return children_of_face(part.topology(), 0, fine.topology(), ids);
    }

private:
    /// Makes one step. If refined faces have one degree, the faces of `part` must have that degree.
    static mesh step(const mesh& part, const Scheme& scheme, numbering& ids)
    {
        constexpr int degree = int(numbering::common_degree);
        if constexpr (degree == 0 and wrapped_scheme<Scheme>)
            return refine_mesh<connect::everything>(part, scheme, ids);
        else
            return refine_level<connect::everything>(
                level_elements<native_level<recorded<Scalar>, Index, degree>>(part), scheme, part.generation(), ids);
    }
    /// Makes all steps and returns the last level. is_own(number) tells whether an element is wanted. After each step
    /// the faces that no wanted face needs are cut off, since recording them would cost more. Precondition: the part
    /// has the rings of the first step.
    template <inherited_number Number, class IsOwn>
    recorded_part<Scalar, Index, Number> last_of(mesh part, const part_numbers<Index>& from,
                                                 part_of_whole<Number> numbers, const IsOwn& is_own) const
    {
        const std::vector<column_bases>& bases = this->bases_;
        Scheme scheme = plain_;
        take_state_of_part(scheme, scheme_, from);
        numbering ids;
        for (std::size_t i = 0; i + 1 < bases.size(); ++i) {
            mesh fine = step(part, scheme, ids);
            advance(scheme, level_of<mesh>(part), part.generation(), ids, fine);
            numbers = numbers.next(part.topology(), ids, bases[i]);
            std::vector<Index> own;
            for (std::size_t f = 0; f < numbers.faces.size(); ++f)
                if (is_own(numbers.faces[f]))
                    own.push_back(Index(f));
            part = std::move(fine);
            if (own.size() == part.face_count())
                continue;
            submesh_cutter<recorded<Scalar>, Index> cutter(part);
            auto cut = cutter.cut(cutter.faces_around(own, this->rings_[i + 1]));
            numbers = numbers.template of_part<Index>(cut.vertex_from, cut.edge_from, cut.face_from);
            take_state_of_part(scheme, scheme, cut.numbers());
            part = std::move(cut.mesh);
        }
        mesh fine = step(part, scheme, ids);
        numbers = numbers.next(part.topology(), ids, bases.back());
        if (not kind_.are_points()) {
            advance(scheme, level_of<mesh>(part), part.generation(), ids, fine);
            kind_.replace_points(fine, scheme, [&](std::size_t v) { return is_own(numbers.vertices[v]); });
        }
        return {std::move(fine), std::move(numbers)};
    }

    Scheme scheme_, plain_; // with the state of the level; without state
    output_kind kind_;
};

} // namespace detail

/// Returns the recorder of a scheme for the level of this generation with which a plan begins, or nullptr for a scheme
/// without patches.
template <std::floating_point Scalar, std::unsigned_integral Index, scheme Scheme>
std::shared_ptr<const part_recorder<Scalar, Index>>
recorder_of([[maybe_unused]] const Scheme& scheme, [[maybe_unused]] const patch_plan& plan,
            [[maybe_unused]] int generation, [[maybe_unused]] const patch_output_kind<Scalar, Index, Scheme>& kind)
{
    if constexpr (patchable_scheme<Scheme, Scalar, Index>)
        return std::make_shared<const detail::part_recorder_of<Scheme, Scalar, Index>>(scheme, plan, generation, kind);
    else
        return nullptr;
}

} // namespace kith
