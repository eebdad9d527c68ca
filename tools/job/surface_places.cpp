// SPDX-License-Identifier: BSD-3-Clause
#include "surface_places.hpp"

#include "cli/errors.hpp"

#include <kith/surface.hpp>

#include <string>
#include <variant>

namespace kith::tool {

namespace {

template <class Scheme>
constexpr bool takes_places = parametric_scheme<Scheme> and scheme_with_creases<Scheme>;

/// Returns use(scheme) in the type of the scheme. Errors: usage_error.
template <class Result, class Use>
Result with_places(const any_scheme& scheme, std::string_view task, const Use& use)
{
    return std::visit(
        [&]<class Scheme>(const Scheme& s) -> Result {
            if constexpr (takes_places<Scheme>)
                return use(s);
            else
                throw usage_error(std::string(task) + ": '" + std::string(scheme_name<Scheme>()) +
                                  "' is not possible here; the schemes are catmull-clark and loop");
        },
        scheme);
}

} // namespace

surface_triangles tessellate_with(const any_scheme& scheme, std::string_view task, const basic_mesh<>& control,
                                  const tessellation_options& options)
{
    return with_places<surface_triangles>(scheme, task, [&](const auto& s) { return tessellate(control, s, options); });
}

located_places locate_with(const any_scheme& scheme, std::string_view task, const basic_mesh<>& control,
                           std::span<const surface_place> places)
{
    return with_places<located_places>(
        scheme, task, [&](const auto& s) { return surface_locator(control, s).locate(places); });
}

bool has_places(const any_scheme& scheme)
{
    return std::visit([]<class Scheme>(const Scheme&) { return takes_places<Scheme>; }, scheme);
}

} // namespace kith::tool
