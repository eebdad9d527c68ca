// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace kith::tool {

/// The bytes that this process may have in all, what it has already included: what the system can give without swapping
/// (MemAvailable), but no more than the control groups it runs in leave it, those of both versions, each with the
/// groups above it. The machine's total where the system tells nothing. `root` is where the files of the system lie.
std::uint64_t available_memory(const std::string& root = "");

/// Arrays that are freed then go back to the system instead of leaving gaps: tiles need others of other sizes.
void give_back_what_is_freed();

/// The most bytes of memory that this process has had, and those it has now.
std::uint64_t peak_memory();
std::uint64_t resident_memory(const std::string& root = "");

} // namespace kith::tool
