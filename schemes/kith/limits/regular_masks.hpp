// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit.hpp"
#include "regular_walk.hpp"

#include <kith/core/level/native_level.hpp>
#include <kith/engine/lane/lane_program_maker.hpp>
#include <kith/engine/lane/tape.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kith::detail {

/// The limit masks of a scheme at a vertex as recorded operations, and the values that are their results. The results
/// are a position and, if there are masks for them, two tangents; there are none without a mask for the position.
struct recorded_masks {
    tape<double> done;
    std::vector<std::uint32_t> results;
};

/// Records the limit masks at the vertex where a walk begins. Values are numbered in the order of the walk.
template <scheme Scheme>
recorded_masks record_masks(const Scheme& scheme, const basic_mesh<>& mesh, int generation, const regular_walk& around)
{
    using value = recorded<double>;
    constexpr int degree = int(numbering_of<Scheme, std::uint32_t>::common_degree);
    using level_type = level_elements<native_level<value, std::uint32_t, degree>>;
    storage<value> values(mesh.vertex_count(), value(std::uint32_t(mesh.vertex_count())));
    for (std::size_t i = 0; i < around.numbers.size(); ++i)
        values[around.numbers[i]] = value(std::uint32_t(i));
    recorded_masks result;
    result.done.restart(values.size() + 1);
    const recording<double> here(result.done);
    const basic_mesh<value, std::uint32_t> of_values(std::move(values), mesh.topology(), generation);
    const level_type level(of_values);
    const auto& rules = limit_rules<Scheme>::on(scheme, level);
    const auto v = level.vertices()[around.numbers[0]];
    const auto store = [&](const auto&... masks) {
        (result.results.push_back(affine<value>::store(masks.evaluate(point_values<level_type>())).value), ...);
    };
    limit_rules<Scheme>::position(rules, v, store);
    if constexpr (has_limit_tangents<Scheme, vertex<level_type>, level_type>)
        if (result.results.size() == 1)
            limit_rules<Scheme>::tangents(rules, v, store);
    return result;
}

/// The limit masks of a scheme at a regular vertex all of whose rings are regular: the way to the points that they
/// read, and a program.
class regular_masks {
public:
    /// Returns the masks on levels of this generation whose faces have this degree. The result is nothing if there is
    /// no mask for the position, or if the masks read more than their rings. Preconditions: the masks of the scheme are
    /// alike at regular vertices, and it has no state. Cost: that of some hundred masks.
    template <scheme Scheme>
    static std::optional<regular_masks> of(const Scheme& scheme, std::size_t degree, int generation)
    {
        constexpr std::size_t common_degree = numbering_of<Scheme, std::uint32_t>::common_degree;
        if ((degree != 3 and degree != 4) or (common_degree != 0 and degree != common_degree))
            return {};
        const int rings = limit_rules<Scheme>::rings(scheme);
        const auto size = std::size_t(2 * rings + 5); // one ring more than the masks may read
        const auto mesh = regular_torus(degree, size);
        const regular_walk walk(mesh.topology(), 0, rings);
        return made_of(record_masks(scheme, mesh, generation, walk), walk);
    }

    /// Returns the steps, each of which reaches one more corner, as the steps of a regular_walk do.
    [[nodiscard]] std::span<const corner_from> steps() const { return steps_; }
    /// Returns the number of corners of the vertex, which are reached first.
    [[nodiscard]] std::size_t valence() const { return valence_; }
    /// Returns the corners of the vertices whose points the program reads.
    [[nodiscard]] std::span<const corner_from> inputs() const { return inputs_; }
    [[nodiscard]] const lane_program<double>& program() const { return program_; }
    [[nodiscard]] bool have_tangents() const { return program_.outputs().size() == 3; }

private:
    static std::optional<regular_masks> made_of(const recorded_masks& masks, const regular_walk& walk);
    /// Takes the steps around the vertex and those that lead to the inputs.
    void take_ways(const regular_walk& walk);

    std::vector<corner_from> steps_, inputs_;
    std::size_t valence_ = 0;
    lane_program<double> program_;
};

#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY std::optional<regular_masks> regular_masks::made_of(const recorded_masks& masks,
                                                                    const regular_walk& walk)
{
    if (masks.results.size() != 1 and masks.results.size() != 3)
        return {};
    regular_masks result;
    result.program_ = lane_program_maker<double>().make(masks.done, masks.results);
    const auto is_outside = [&](std::uint32_t input) { return input >= walk.vertices.size(); };
    if (result.program_.is_too_long() or std::ranges::any_of(result.program_.inputs(), is_outside))
        return {};
    result.take_ways(walk);
    return result;
}
KITH_IN_LIBRARY void regular_masks::take_ways(const regular_walk& walk)
{
    valence_ = walk.valence;
    std::vector<std::uint16_t> number(walk.steps.size() + 1, 0); // of the reached corners; 0 if not needed
    for (std::size_t r = 1; r < valence_; ++r)
        number[r] = 1;
    for (const std::uint32_t input : program_.inputs())
        for (std::size_t r = walk.vertices[input].reached; r != 0; r = walk.steps[r - 1].reached)
            number[r] = 1;
    const auto renumbered = [&](const corner_from& c) { return corner_from{number[c.reached], c.on}; };
    for (std::size_t r = 1; r < number.size(); ++r)
        if (number[r] != 0) {
            steps_.push_back(renumbered(walk.steps[r - 1]));
            number[r] = std::uint16_t(steps_.size());
        }
    for (const std::uint32_t input : program_.inputs())
        inputs_.push_back(renumbered(walk.vertices[input]));
}
#endif

/// The arrays by vertex that limits are written into.
struct limit_places {
    std::array<double, 3>* positions;
    std::array<double, 3>* normals;
    unsigned char* has_no_normal;
    unsigned char* is_open; ///< set while the limits of a vertex are not made
};

} // namespace kith::detail
