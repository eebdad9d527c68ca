// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "all_shapes.hpp"
#include "native_shape.hpp"

#include <kith/core/level/to_native.hpp>

#include <gtest/gtest.h>

using level_type = kith::level_of<mesh3d>;

/// Calls test(level) for the native level of every shape.
template <class Test>
void for_each_level(const Test& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        test(level_type(mesh));
    }
}
