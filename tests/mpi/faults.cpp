// SPDX-License-Identifier: BSD-3-Clause
// Lets one write of one rank fail. The environment variable KITH_FAULT has the form "RANK:N:KIND", where the N-th write
// of the rank fails. The kinds: "throw" throws an exception, "odd" throws an object that is no std::exception. "kill"
// ends the process at once, "full" reports a full disk, and "slow" takes a long time.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include <dlfcn.h>
#include <unistd.h>

namespace {

bool is_next()
{
    static long writes = 0;
    const char* const fault = std::getenv("KITH_FAULT");
    const char* const rank = std::getenv("OMPI_COMM_WORLD_RANK");
    if (fault == nullptr or rank == nullptr)
        return false;
    char* rest = nullptr;
    const bool here = std::strtol(fault, &rest, 10) == std::atol(rank);
    return here and ++writes == std::strtol(rest + 1, nullptr, 10);
}

} // namespace

extern "C" ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset)
{
    if (is_next()) {
        const std::string kind = std::strrchr(std::getenv("KITH_FAULT"), ':') + 1;
        if (kind == "throw")
            throw std::runtime_error("a write failed on purpose");
        if (kind == "odd")
            throw 1;
        if (kind == "kill")
            std::raise(SIGKILL);
        if (kind == "slow")
            sleep(60);
        if (kind == "full") {
            errno = ENOSPC;
            return -1;
        }
    }
    using function = ssize_t (*)(int, const void*, std::size_t, off_t);
    static const auto next = reinterpret_cast<function>(dlsym(RTLD_NEXT, "pwrite"));
    return next(file, bytes, size, offset);
}
