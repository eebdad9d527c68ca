// SPDX-License-Identifier: BSD-3-Clause
#include "job/available_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

using kith::tool::available_memory;

namespace {

constexpr std::uint64_t mega = 1 << 20;

/// A system that consists of a few files. The process has two pages.
class files {
public:
    files()
    {
        add("proc/self/statm", "10 2 1 1 0 1 0\n");
        add("proc/meminfo", "MemTotal:       8000000 kB\nMemFree:         100 kB\nMemAvailable:    1048576 kB\n");
    }
    files(const files&) = delete;
    files& operator=(const files&) = delete;
    ~files() { std::filesystem::remove_all(root_); }

    void add(const std::string& name, const std::string& text)
    {
        const auto path = std::filesystem::path(root_) / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }
    void remove(const std::string& name) { std::filesystem::remove_all(std::filesystem::path(root_) / name); }
    /// Returns the available memory without the two pages of the process.
    [[nodiscard]] std::uint64_t left() const
    {
        return available_memory(root_) - 2 * std::uint64_t(sysconf(_SC_PAGE_SIZE));
    }

private:
    std::string root_ = testing::TempDir() + "available_memory_" + std::to_string(getpid());
};

} // namespace

TEST(available_memory, is_what_the_system_says)
{
    files system;
    EXPECT_EQ(system.left(), 1024 * mega);
}

TEST(available_memory, is_no_more_than_a_group_of_version_2_leaves)
{
    files system;
    system.add("proc/self/cgroup", "0::/user.slice/job\n");
    system.add("sys/fs/cgroup/user.slice/job/memory.max", "max\n");
    system.add("sys/fs/cgroup/user.slice/job/memory.current", "1048576\n");
    EXPECT_EQ(system.left(), 1024 * mega);
    system.add("sys/fs/cgroup/user.slice/job/memory.max", std::to_string(500 * mega));
    EXPECT_EQ(system.left(), 499 * mega);
    system.add("sys/fs/cgroup/user.slice/job/memory.stat", "anon 5\ninactive_file 524288\nactive_file 9\n");
    EXPECT_EQ(system.left(), 499 * mega + mega / 2);
    // The parent group has less memory.
    system.add("sys/fs/cgroup/user.slice/memory.max", std::to_string(300 * mega));
    system.add("sys/fs/cgroup/user.slice/memory.current", std::to_string(100 * mega));
    EXPECT_EQ(system.left(), 200 * mega);
    // More memory is in use than the limit allows.
    system.add("sys/fs/cgroup/user.slice/memory.current", std::to_string(301 * mega));
    EXPECT_EQ(system.left(), 0U);
}

TEST(available_memory, is_no_more_than_a_group_of_version_1_leaves)
{
    files system;
    system.add("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/docker/1\n0::/\n");
    system.add("sys/fs/cgroup/memory/docker/1/memory.limit_in_bytes", std::to_string(64 * mega));
    system.add("sys/fs/cgroup/memory/docker/1/memory.usage_in_bytes", std::to_string(60 * mega));
    system.add("sys/fs/cgroup/memory/docker/1/memory.stat", "cache 1\ntotal_inactive_file 1048576\n");
    EXPECT_EQ(system.left(), 5 * mega);
    // In a container the path of the group is that of the host; the files of the group lie at the top.
    system.remove("sys/fs/cgroup/memory/docker");
    system.add("sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(32 * mega));
    system.add("sys/fs/cgroup/memory/memory.usage_in_bytes", "0");
    EXPECT_EQ(system.left(), 32 * mega);
}

TEST(available_memory, is_found_in_a_container_with_groups_of_its_own)
{
    files system;
    system.add("proc/self/cgroup", "0::/\n");
    system.add("sys/fs/cgroup/memory.max", std::to_string(16 * mega));
    system.add("sys/fs/cgroup/memory.current", std::to_string(mega));
    EXPECT_EQ(system.left(), 15 * mega);
}

TEST(available_memory, is_that_of_the_machine_where_nothing_is_told)
{
    EXPECT_EQ(available_memory(testing::TempDir() + "no_such_system"),
              std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGE_SIZE)));
}

TEST(available_memory, of_this_machine_is_not_more_than_all)
{
    EXPECT_GT(available_memory(), mega);
    EXPECT_LE(available_memory(),
              std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGE_SIZE)) +
                  kith::tool::resident_memory());
    EXPECT_GE(kith::tool::peak_memory(), kith::tool::resident_memory() / 2);
}
