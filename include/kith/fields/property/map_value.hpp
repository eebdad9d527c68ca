// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace kith::detail {

/// Returns the value of an element from a function, a property map (`get(map, handle)`) or anything that takes handles
/// in brackets.
template <class Source, class Handle>
decltype(auto) map_value(const Source& source, const Handle& x)
{
    if constexpr (std::invocable<const Source&, const Handle&>)
        return source(x);
    else if constexpr (requires { get(source, x); })
        return get(source, x);
    else
        return source[x];
}
/// Sets the value of an element in a property map, or in anything that takes handles in brackets.
template <class Target, class Handle, class T>
void put_value(Target& target, const Handle& x, const T& value)
{
    if constexpr (requires { put(target, x, value); })
        put(target, x, value);
    else
        target[x] = value;
}
/// The type of the values of a map. For bits, a map may return an object that stands for one; its value_type is used
/// then.
template <class Source, class Handle>
struct map_value_type {
    using type = std::remove_cvref_t<decltype(map_value(std::declval<const Source&>(), std::declval<const Handle&>()))>;
};
template <class Source, class Handle>
    requires requires { typename Source::value_type; }
struct map_value_type<Source, Handle> {
    using type = typename Source::value_type;
};

} // namespace kith::detail
