// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <kith/field/with_fields.hpp>

#include <cstdint>
#include <utility>

namespace kith {

/// `refine`, to the same bits, which makes `scheme` the scheme of the last level: its fields are those of the mesh that is
/// returned, by its dense numbers, and so is all other state (creases). The last level has its edges, whatever the options say.
/// Errors: as `refine`, and mesh_error for a field of another number of values; the scheme is as before then. Cost: that of
/// `refine` and of the rules of the fields.
template <class Point, class Index, scheme Scheme>
basic_mesh<Point, Index> refine_with_fields(const basic_mesh<Point, Index>& mesh, Scheme& scheme, int levels,
                                            const refine_options& options = {})
{
    validate(mesh).require_ok();
    auto control = detail::with_edges(mesh);
    detail::require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    Scheme last = scheme;
    auto fine = detail::refine_on(std::move(control), last, levels);
    scheme = std::move(last);
    return fine;
}

template <refinable_mesh M, scheme Scheme>
M refine_with_fields(const M& mesh, Scheme& scheme, int levels, const refine_options& options = {})
{
    auto control = lift_valid(mesh);
    detail::require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    if (levels == 0)
        return build_like(mesh, std::move(control));
    Scheme last = scheme;
    const auto coarse = detail::refine_on(std::move(control), last, levels - 1);
    numbering_of<Scheme, std::uint32_t> ids;
    M fine = with_native_level<Scheme>(
        coarse, [&](const auto& level) { return refine_level_like(mesh, level, last, coarse.generation(), ids); });
    advance(last, level_of<std::remove_const_t<decltype(coarse)>>(coarse), coarse.generation(), ids, fine);
    scheme = std::move(last);
    return fine;
}

} // namespace kith
