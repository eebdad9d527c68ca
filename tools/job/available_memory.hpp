// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace kith::tool {

/// Returns the number of bytes that this process may have in total, including those that it has already. They are the
/// memory that the system can give without swapping (MemAvailable), limited by the control groups of the process.
/// Groups of both versions count, each with the groups above it. Returns the total memory of the machine if the system
/// reports nothing. `root` is the directory of the system's files.
std::uint64_t available_memory(const std::string& root = "");

/// Makes the allocator return freed arrays to the system instead of leaving gaps, since tiles need arrays of other
/// sizes.
void give_back_what_is_freed();

/// Returns the bytes of memory that this process has had at most (peak_memory) or has now (resident_memory).
std::uint64_t peak_memory();
std::uint64_t resident_memory(const std::string& root = "");

} // namespace kith::tool
