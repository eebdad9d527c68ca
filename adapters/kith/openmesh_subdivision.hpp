// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What OpenMesh's Subdivider::Uniform has, under the same names in namespace kith::openmesh; and all schemes of kith
/// in that shape. docs/start/openmesh.md.
#include <kith/openmesh/longest_edge.hpp>
#include <kith/openmesh/subdividers.hpp>
