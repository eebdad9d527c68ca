// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Parts of a scheme of one's own: columns, elements and masks, rules for them, weights by valence.

#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/choose.hpp>
#include <kith/core/mask/mask_expressions.hpp>
#include <kith/numbering/association/association.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme.hpp>
