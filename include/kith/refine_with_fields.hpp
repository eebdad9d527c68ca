// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <kith/fields/values_in_patches.hpp>
#include <kith/fields/with_fields.hpp>

#include <concepts>
#include <optional>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

/// The part of a scheme's data that becomes that of the last level.
enum class carried : bool { fields, fields_and_scheme };

/// The fields that a refinement carries along: a std::tuple of references or values. They become those of the last
/// level, and the scheme may, too.
template <class Fields, scheme Scheme, std::unsigned_integral Index>
class carried_fields {
public:
    carried_fields(Fields& fields, carried what) : fields_(fields), what_(what) {}

    [[nodiscard]] bool needs_scheme() const { return what_ == carried::fields_and_scheme; }
    template <finished_step Step, mesh Fine>
    bool advance(const Step& step, Fine&)
    {
        std::apply([&](auto&... each) { ((each = each.after(step)), ...); }, fields_);
        return true;
    }

    [[nodiscard]] static constexpr bool may_go_in_patches() { return has_none or go_in_patches<Fields, Scheme, Index>; }
    template <class Mesh, class Plan>
    bool enter_patches([[maybe_unused]] const Mesh& level, [[maybe_unused]] const Scheme& scheme,
                       [[maybe_unused]] const Plan& plan, [[maybe_unused]] connect last_level)
    {
#ifdef KITH_HAS_LANES
        if constexpr (may_go_in_patches() and not has_none) {
            in_patches_.emplace(level.topology(), level.generation(), scheme, plan, last_level);
            return std::apply([&](const auto&... each) { return (in_patches_->can_take(each) and ...); }, fields_);
        }
#endif
        return true;
    }
    bool leave_patches()
    {
#ifdef KITH_HAS_LANES
        if constexpr (may_go_in_patches() and not has_none)
            std::apply([&](auto&... each) { ((each = in_patches_->last(each)), ...); }, fields_);
#endif
        return true;
    }

private:
    static constexpr bool has_none = std::tuple_size_v<Fields> == 0;

    Fields& fields_;
    carried what_;
#ifdef KITH_HAS_LANES
    std::optional<fields_in_patches<Index, Scheme>> in_patches_;
#endif
};

/// Throws mesh_error for a field whose number of values is not the number of elements of the level.
template <level Level, class Fields>
void require_fields(const Level& level, const Fields& fields)
{
    std::apply([&](const auto&... each) { (each.require_one_each(level), ...); }, fields);
}

/// Refines a native mesh that the scheme accepts. What is carried becomes that of the last level.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Fields>
basic_mesh<Point, Index> refine_with_fields_along(basic_mesh<Point, Index> control, Scheme& scheme, Fields& fields,
                                                  carried what, int levels, connect last_level)
{
    require_fields(level_of<basic_mesh<Point, Index>>(control), fields);
    using carried_type = carried_fields<Fields, Scheme, Index>;
    carried_type along(fields, what);
    native_last_level<Point, Index> last(last_level);
    refinement_run<Point, Index, Scheme, carried_type>(std::move(control), scheme, levels, along).make(last);
    return last.take();
}

/// Refines as `refine` does. What is carried becomes that of the last level.
template <class Point, std::unsigned_integral Index, scheme Scheme, class Fields>
basic_mesh<Point, Index> refine_with(const basic_mesh<Point, Index>& mesh, Scheme& scheme, Fields& fields, carried what,
                                     int levels, const refine_options& options)
{
    validate(mesh).require_ok();
    auto control = with_edges(mesh);
    require_refinable(control, scheme, levels, options);
    return refine_with_fields_along(std::move(control), scheme, fields, what, levels, options.last_level);
}
template <mesh M, scheme Scheme, class Fields>
M refine_with(const M& mesh, Scheme& scheme, Fields& fields, carried what, int levels, const refine_options& options)
{
    auto control = to_native_valid(mesh);
    with_numbers_of(mesh, scheme, generation_of(mesh), [&] {
        return require_refinable(control, scheme, levels, {connect::everything, options.memory_limit});
    });
    return build_like(mesh,
                      refine_with_fields_along(std::move(control), scheme, fields, what, levels, connect::everything));
}

} // namespace detail

/// Refines as `refine` does, to the same bits, and carries fields of the mesh along. They become the fields of the
/// returned mesh, in its dense numbers: refine_with_fields(mesh, loop{}, 3, std::tie(material, uv)).
/// Errors: as `refine`; mesh_error for a field with another number of values, and for a field on edges if the last
/// level has none. After an error the fields are as before. Cost: that of `refine` and of the rules of the fields.
template <refinable_mesh M, scheme Scheme, class... Fields>
M refine_with_fields(const M& mesh, const Scheme& scheme, int levels, std::tuple<Fields&...> fields,
                     const refine_options& options = {})
{
    Scheme last = scheme;
    std::tuple<Fields...> next = fields;
    M fine = detail::refine_with(mesh, last, next, detail::carried::fields, levels, options);
    fields = std::move(next);
    return fine;
}

/// Refines and carries along the fields and all other state (creases) of the scheme, which becomes the scheme of the
/// last level.
template <refinable_mesh M, scheme Scheme>
M refine_with_fields(const M& mesh, Scheme& scheme, int levels, const refine_options& options = {})
{
    Scheme last = scheme;
    std::tuple<> none;
    M fine = detail::refine_with(mesh, last, none, detail::carried::fields_and_scheme, levels, options);
    swap_states(scheme, last);
    return fine;
}
template <refinable_mesh M, scheme Plain, class... Fields>
M refine_with_fields(const M& mesh, with_fields<Plain, Fields...>& scheme, int levels,
                     const refine_options& options = {})
{
    Plain last = scheme.plain();
    std::tuple<Fields...> next = scheme.fields();
    M fine = detail::refine_with(mesh, last, next, detail::carried::fields_and_scheme, levels, options);
    swap_states(static_cast<Plain&>(scheme), last);
    scheme.fields() = std::move(next);
    return fine;
}

} // namespace kith
