// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/step/scheme_traits.hpp>

#include <string>
#include <string_view>

namespace kith {

/// Libraries whose conventions a scheme can follow: `loop::like(library::cgal)`. docs/schemes.md lists the differences.
enum class library : unsigned char { kith, cgal, openmesh, opensubdiv, libigl };

/// Thrown by `like` when that library does not have the scheme.
template <class Scheme>
[[noreturn]] void refuse_preset(std::string_view who_has_it)
{
    throw mesh_error(std::string(scheme_name<Scheme>()) + ": that library does not have it; it is in " +
                     std::string(who_has_it));
}

} // namespace kith
