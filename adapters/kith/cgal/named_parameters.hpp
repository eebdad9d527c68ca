// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/version.h>

#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <type_traits>

namespace kith::cgal {

/// CGAL's named parameters, and parameters that CGAL does not have. The latter come first in a chain:
/// parameters::edge_sharpness_map(sharp).number_of_iterations(3).
namespace parameters {

using namespace CGAL::parameters;

enum edge_sharpness_t { edge_sharpness };
enum vertex_sharpness_t { vertex_sharpness };

/// Returns a named parameter: the map of the sharpness of edges, or of vertices. A number is the count of levels on
/// which an element stays sharp; infinitely_sharp keeps it sharp for ever. `more` is the chain of parameters that this
/// one is added to, if there is one.
template <class Map, class... More>
auto edge_sharpness_map(const Map& map, const More&... more)
{
    return CGAL::Named_function_parameters<Map, edge_sharpness_t, More...>(map, more...);
}
template <class Map, class... More>
auto vertex_sharpness_map(const Map& map, const More&... more)
{
    return CGAL::Named_function_parameters<Map, vertex_sharpness_t, More...>(map, more...);
}

#if CGAL_VERSION_NR >= 1060101000
using do_not_modify_geometry_t = CGAL::internal_np::do_not_modify_geometry_t;
inline constexpr auto do_not_modify_geometry_tag = CGAL::internal_np::do_not_modify_geometry;
#else
enum do_not_modify_geometry_t { do_not_modify_geometry_tag };

/// Returns a named parameter, which CGAL has from 6.1 on. If it is true, elements are split and no point moves.
template <class... More>
auto do_not_modify_geometry(bool b, const More&... more)
{
    return CGAL::Named_function_parameters<bool, do_not_modify_geometry_t, More...>(b, more...);
}
#endif

} // namespace parameters

/// A number of steps. CGAL before version 5 took one after the mesh; functions of this dialect take it or named
/// parameters.
template <class Np>
concept steps = std::integral<Np>;

namespace detail {

template <class Np, class Tag>
inline constexpr bool is_given = not CGAL::parameters::is_default_parameter<Np, Tag>::value;

/// Returns true if values can be put into a map of this type.
template <class Map>
constexpr bool is_writable()
{
    using traits = boost::property_traits<Map>;
    using category = typename traits::category;
    constexpr bool refers_to_constants = std::is_convertible_v<category, boost::lvalue_property_map_tag> and
                                         std::is_const_v<std::remove_reference_t<typename traits::reference>>;
    return std::is_convertible_v<category, boost::writable_property_map_tag> and not refers_to_constants;
}

/// Returns the parameter, or the object that it refers to if it was passed by std::ref.
template <class T>
decltype(auto) unwrapped(T& parameter)
{
    if constexpr (requires { parameter.get(); })
        return parameter.get();
    else
        return (parameter);
}

/// Tells the visitor how much of the work is done. Returns false if the visitor asks to stop.
template <class Visitor>
bool tell(Visitor& visitor, double done)
{
    auto& told = unwrapped(visitor);
    if constexpr (std::is_void_v<decltype(told.progress(done))>) {
        told.progress(done);
        return true;
    } else {
        return bool(told.progress(done));
    }
}

} // namespace detail

} // namespace kith::cgal
