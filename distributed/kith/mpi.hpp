// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The little of MPI 3.1 that kith needs, with errors as exceptions and messages of any size.
#include "communicator.hpp"
#include "in_agreement.hpp"
#include "session.hpp"
