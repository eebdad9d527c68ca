// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

// Only the C functions of MPI are used; its obsolete C++ bindings would need a library of their own.
#if !defined(OMPI_SKIP_MPICXX)
#define OMPI_SKIP_MPICXX 1
#endif
#if !defined(MPICH_SKIP_MPICXX)
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>
