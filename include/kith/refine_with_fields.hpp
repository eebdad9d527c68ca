// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <kith/field/values_in_patches.hpp>
#include <kith/field/with_fields.hpp>

#include <concepts>
#include <cstdint>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

/// Makes fields those of the next level, and the scheme, too.
template <class Fields, scheme Scheme, level Level, level_numbering Numbering, mesh Fine>
void advance_with_fields(Fields& fields, Scheme& scheme, const Level& coarse, int generation, const Numbering& ids,
                         const Fine& fine)
{
    const made_step<Scheme, Level, Numbering, Fine> step{scheme, coarse, generation, ids, fine};
    std::apply([&](auto&... each) { ((each = each.after(step)), ...); }, fields);
    advance(scheme, coarse, generation, ids, fine);
}

/// Errors: mesh_error for a field that has another number of values than the level has elements.
template <level Level, class Fields>
void require_fields(const Level& level, const Fields& fields)
{
    std::apply([&](const auto&... each) { (each.require_one_each(level), ...); }, fields);
}

/// Refines a native mesh and makes scheme and fields those of the last level.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Fields>
basic_mesh<Point, Index> refine_with(basic_mesh<Point, Index> mesh, Scheme& scheme, Fields& fields, int levels,
                                     connect last_level)
{
    numbering_of<Scheme, Index> ids;
    for (int level = 1; level <= levels; ++level) {
        auto fine = level == levels and last_level == connect::faces
                        ? refine_mesh<connect::faces>(mesh, scheme, ids)
                        : refine_mesh<connect::everything>(mesh, scheme, ids);
        advance_with_fields(fields, scheme, level_of<basic_mesh<Point, Index>>(mesh), mesh.generation(), ids, fine);
        mesh = std::move(fine);
    }
    return mesh;
}

#ifdef KITH_HAS_LANES
/// Refines a native mesh and makes fields those of the last level. Where it is a gain the last steps are made at once.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Fields>
basic_mesh<Point, Index> refine_with_in_patches(basic_mesh<Point, Index> mesh, Scheme scheme, Fields& fields,
                                                int levels, connect last_level)
{
    patch_refinement<Point, Index, Scheme> patches(mesh, scheme, levels, last_level);
    if (not patches.is_worth_looking())
        return refine_with(std::move(mesh), scheme, fields, levels, last_level);
    const int begin = patches.begin();
    mesh = refine_with(std::move(mesh), scheme, fields, begin, connect::everything);
    const fields_in_patches in_patches(mesh.topology(), mesh.generation(), scheme, patches.plan(), last_level);
    const bool are_taken = std::apply([&](const auto&... each) { return (in_patches.can_take(each) and ...); }, fields);
    auto fine = are_taken ? patches.refine_from(mesh, scheme) : std::nullopt;
    if (not fine)
        return refine_with(std::move(mesh), scheme, fields, levels - begin, last_level);
    std::apply([&](auto&... each) { ((each = in_patches.last(each)), ...); }, fields);
    return std::move(*fine);
}
#endif

/// `refine` that makes scheme and fields those of the last level, as far as it got.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Fields>
basic_mesh<Point, Index> refine_with(const basic_mesh<Point, Index>& mesh, Scheme& scheme, Fields& fields, int levels,
                                     const refine_options& options)
{
    validate(mesh).require_ok();
    auto control = with_edges(mesh);
    require_refinable(control, scheme, levels, options);
    require_fields(level_of<basic_mesh<Point, Index>>(control), fields);
#ifdef KITH_HAS_LANES
    if constexpr (patchable_scheme<Scheme, Point, Index> and go_in_patches<Fields, Scheme, Index>)
        return refine_with_in_patches(std::move(control), scheme, fields, levels, options.last_level);
#endif
    return refine_with(std::move(control), scheme, fields, levels, options.last_level);
}
template <mesh M, scheme Scheme, class Fields>
M refine_with(const M& mesh, Scheme& scheme, Fields& fields, int levels, const refine_options& options)
{
    auto control = lift_valid(mesh);
    with_numbers_of(mesh, scheme, generation_of(mesh), [&] {
        return require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    });
    require_fields(level_of<decltype(control)>(control), fields);
    if (levels == 0)
        return build_like(mesh, std::move(control));
    const auto coarse = refine_with(std::move(control), scheme, fields, levels - 1, connect::everything);
    numbering_of<Scheme, std::uint32_t> ids;
    M fine = refine_mesh_like(mesh, coarse, scheme, ids);
    advance_with_fields(
        fields, scheme, level_of<std::remove_const_t<decltype(coarse)>>(coarse), coarse.generation(), ids, fine);
    return fine;
}

} // namespace detail

/// `refine`, to the same bits, with fields of the mesh, which become those of the mesh that is returned, by its dense
/// numbers: refine_with_fields(mesh, loop{}, 3, std::tie(material, uv)).
/// Errors: as `refine`, and mesh_error for a field of another number of values, and for one on edges where the last
/// level has none; the fields are as before then. Cost: that of `refine` and of the rules of the fields.
template <refinable_mesh M, scheme Scheme, class... Fields>
M refine_with_fields(const M& mesh, const Scheme& scheme, int levels, std::tuple<Fields&...> fields,
                     const refine_options& options = {})
{
    Scheme last = scheme;
    std::tuple<Fields...> next = fields;
    M fine = detail::refine_with(mesh, last, next, levels, options);
    fields = std::move(next);
    return fine;
}

/// The same with the fields, and all other state (creases), that the scheme has; it becomes the scheme of the last
/// level.
template <refinable_mesh M, scheme Scheme>
M refine_with_fields(const M& mesh, Scheme& scheme, int levels, const refine_options& options = {})
{
    Scheme last = scheme;
    std::tuple<> none;
    M fine = detail::refine_with(mesh, last, none, levels, options);
    swap_states(scheme, last);
    return fine;
}

} // namespace kith
