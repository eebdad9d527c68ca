// SPDX-License-Identifier: BSD-3-Clause
#include "available_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

namespace kith::tool {

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

/// Returns the number that a file holds, or nothing for "max" or a missing file.
std::optional<std::uint64_t> number_in_file(const std::string& path)
{
    std::ifstream in(path);
    std::uint64_t number = 0;
    if (in >> number)
        return number;
    return std::nullopt;
}

/// Returns the number after the word `wanted` at the beginning of a line of a file.
std::optional<std::uint64_t> number_after(const std::string& path, const std::string& wanted)
{
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string word;
        std::uint64_t number = 0;
        if (words >> word and word == wanted and words >> number)
            return number;
    }
    return std::nullopt;
}

/// The names in a version of control groups: the limit, the memory in use, and the part of it that is given back on
/// demand.
struct group_files {
    std::string_view limit, usage, cache;
};

/// Returns the bytes that a control group and every group above it leave, up to the mount point.
std::uint64_t left_in_groups(const std::string& mount, const std::string& group, const group_files& names)
{
    std::uint64_t left = unlimited;
    for (auto path = std::filesystem::path(group).relative_path();; path = path.parent_path()) {
        const std::string here = mount + "/" + path.string() + "/";
        const auto limit = number_in_file(here + std::string(names.limit));
        const auto usage = number_in_file(here + std::string(names.usage));
        if (limit and usage) {
            const auto cache = number_after(here + "memory.stat", std::string(names.cache)).value_or(0);
            const std::uint64_t used = *usage - std::min(*usage, cache);
            left = std::min(left, *limit - std::min(*limit, used));
        }
        if (path.empty())
            return left;
    }
}

std::uint64_t left_in_all_groups(const std::string& root)
{
    std::uint64_t left = unlimited;
    std::ifstream in(root + "/proc/self/cgroup"); // lines such as 0::/user.slice or 4:memory:/jobs
    for (std::string line; std::getline(in, line);) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const std::string group = line.substr(second + 1), mount = root + "/sys/fs/cgroup";
        if (controllers == ",,")
            left = std::min(left, left_in_groups(mount, group, {"memory.max", "memory.current", "inactive_file"}));
        else if (controllers.find(",memory,") != std::string::npos)
            left = std::min(left,
                            left_in_groups(mount + "/memory",
                                           group,
                                           {"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"}));
    }
    return left;
}

std::uint64_t page_size()
{
    return std::uint64_t(sysconf(_SC_PAGE_SIZE));
}

} // namespace

std::uint64_t available_memory(const std::string& root)
{
    const std::uint64_t total = std::uint64_t(sysconf(_SC_PHYS_PAGES)) * page_size();
    const auto kilobytes = number_after(root + "/proc/meminfo", "MemAvailable:");
    const std::uint64_t left = std::min(kilobytes ? *kilobytes * 1024 : unlimited, left_in_all_groups(root));
    return left == unlimited ? total : left + resident_memory(root);
}

void give_back_what_is_freed()
{
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 256 << 10);
#endif
}

std::uint64_t peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

std::uint64_t resident_memory(const std::string& root)
{
    std::ifstream in(root + "/proc/self/statm");
    std::uint64_t size = 0, resident = 0;
    return in >> size >> resident ? resident * page_size() : 0;
}

} // namespace kith::tool
