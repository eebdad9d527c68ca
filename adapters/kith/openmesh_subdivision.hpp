// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The classes of OpenMesh's Subdivider::Uniform, under the same names in namespace kith::openmesh. All other schemes
/// of kith have classes of the same form. See docs/start/openmesh.md.
#include <kith/openmesh/longest_edge.hpp>
#include <kith/openmesh/subdividers.hpp>
