// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subdivider.hpp"

#include <kith/linear.hpp>
#include <kith/presets.hpp>

#include <utility>

namespace kith::openmesh {

namespace detail {

/// With OpenMesh's conventions unless told otherwise; those of kith where OpenMesh does not have the scheme.
template <class Mesh, class Scheme>
struct with_conventions : subdivider<Mesh, Scheme> {
    static constexpr bool has_preset = requires { like<Scheme>(library::openmesh); };

    with_conventions() : subdivider<Mesh, Scheme>(like<Scheme>(conventions())) {}
    explicit with_conventions(Mesh& mesh) : subdivider<Mesh, Scheme>(mesh, like<Scheme>(conventions())) {}
    explicit with_conventions(Scheme scheme) : subdivider<Mesh, Scheme>(std::move(scheme)) {}
};

} // namespace detail

} // namespace kith::openmesh
