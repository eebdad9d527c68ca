// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surfaces in tiles on the ranks of an MPI job.
#include "refine_by_exchange.hpp"
#include "refine_on_ranks.hpp"

#include <kith/mpi/in_agreement.hpp>
#include <kith/mpi/session.hpp>
#include <kith/ranks/field_exchange.hpp>
#include <kith/ranks/gather.hpp>
#include <kith/ranks/repartition.hpp>
#include <kith/ranks/write_level.hpp>
#include <kith/slices/tiles_of_slices.hpp>
