// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Parts for writing a scheme: columns, elements and masks, rules for elements, weights by valence.

#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/choose.hpp>
#include <kith/core/mask/mask_expressions.hpp>
#include <kith/numbering/association/association.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme.hpp>
