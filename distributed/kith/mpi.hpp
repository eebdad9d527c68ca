// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Surfaces in tiles on the ranks of an MPI job.
#include "refine_by_exchange.hpp"
#include "refine_on_ranks.hpp"

#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/ranks/field_exchange.hpp>
#include <kith/mpi/ranks/gather.hpp>
#include <kith/mpi/ranks/repartition.hpp>
#include <kith/mpi/ranks/write_level.hpp>
#include <kith/mpi/session.hpp>
#include <kith/mpi/slices/tiles_of_slices.hpp>
