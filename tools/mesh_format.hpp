// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.hpp"

#include <kith/mesh_format.hpp>
