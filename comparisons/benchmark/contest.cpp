// SPDX-License-Identifier: BSD-3-Clause
#include "contest.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <utility>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::comparison {

namespace {

/// Returns the value of a line of /proc/self/status such as "VmHWM:  1234 kB", in bytes.
std::uint64_t memory(std::string_view name)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
        if (word == name) {
            std::uint64_t kibibytes = 0;
            status >> kibibytes;
            return 1024 * kibibytes;
        }
    throw std::runtime_error("/proc/self/status does not tell " + std::string(name));
}

/// Returns the processor time of this process so far, in user mode and in the kernel.
double processor_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Calls f and returns its result and the seconds that it took.
auto timed(const work& f)
{
    const auto start = std::chrono::steady_clock::now();
    auto result = f();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    return std::pair(std::move(result), time.count());
}

measurement measure(const contestant& contestant)
{
    work refine = contestant.prepare();
    std::ofstream("/proc/self/clear_refs") << 5; // the peak so far is forgotten
    const std::uint64_t before = memory("VmRSS:");
    const double processor_start = processor_seconds();
    auto [result, seconds] = timed(refine);
    measurement run{seconds, 0, processor_seconds() - processor_start, memory("VmHWM:") - before};
    result.reset();
    refine = nullptr; // contestants that refine in place hold their result in `refine`
    refine = contestant.prepare();
    run.seconds_again = timed(refine).second;
    return run;
}

/// Makes the system hand out this much memory and take it back. A virtual machine may have lent the memory to other
/// machines; getting it back costs many times as much as an ordinary page. Without this call the first contestant that
/// needs the memory would pay for it.
void touch_memory(std::size_t bytes)
{
    const pid_t child = fork();
    if (child == 0) {
        void* const block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (block == MAP_FAILED)
            _exit(1);
        madvise(block, bytes, MADV_HUGEPAGE);
        for (std::size_t i = 0; i < bytes; i += 4096)
            static_cast<volatile char*>(block)[i] = 1;
        _exit(0);
    }
    if (child > 0)
        waitpid(child, nullptr, 0);
}

measurement measure_in_child(const contestant& contestant)
{
    int ends[2];
    if (pipe(ends) != 0)
        throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("no process");
    if (child == 0) {
        int code = 1;
        try {
#if defined(_OPENMP)
            omp_set_num_threads(std::max(1, contestant.threads));
#endif
            const measurement result = measure(contestant);
            if (write(ends[1], &result, sizeof(result)) == ssize_t(sizeof(result)))
                code = 0;
        } catch (const std::exception& error) {
            std::cerr << contestant.name << ": " << error.what() << std::endl;
        }
        _exit(code);
    }
    close(ends[1]);
    measurement result{};
    const bool complete = read(ends[0], &result, sizeof(result)) == ssize_t(sizeof(result));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (not complete)
        throw std::runtime_error(contestant.name + ": a run ended without a result");
    return result;
}

} // namespace

void run(contest& contest, int repeats)
{
    constexpr std::size_t most_bytes_per_face = 640; // no peer needs more
    for (int i = 0; i < repeats; ++i)
        for (auto& contestant : contest.contestants) {
            touch_memory(most_bytes_per_face * contest.faces);
            contestant.runs.push_back(measure_in_child(contestant));
        }
}

double median(const std::vector<measurement>& runs, const std::function<double(const measurement&)>& value)
{
    std::vector<double> values;
    std::ranges::transform(runs, std::back_inserter(values), value);
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

} // namespace kith::comparison
