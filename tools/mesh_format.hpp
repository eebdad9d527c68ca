// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.hpp"

#include <kith/format/mesh_format.hpp>
