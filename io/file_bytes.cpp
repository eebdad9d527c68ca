// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/text/file_bytes.hpp>

#include <kith/io/format/mesh_format.hpp>
#include <kith/io/text/file_error.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kith::io {

namespace {

constexpr std::size_t block = std::size_t(1) << 20;

/// A guard that closes a file at the end of a scope.
struct closed_at_end {
    int descriptor;
    ~closed_at_end() { close(descriptor); }
};

} // namespace

file_bytes::file_bytes(const std::string& path)
{
    if (path == standard_stream) {
        read_all(STDIN_FILENO, "standard input");
        return;
    }
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        throw file_error(path + ": cannot be opened: " + std::strerror(errno));
    const closed_at_end closing{descriptor};
    struct stat facts{};
    if (fstat(descriptor, &facts) == 0) {
        if (S_ISDIR(facts.st_mode))
            throw file_error(path + ": is a directory, not a file");
        if (S_ISREG(facts.st_mode))
            reserve(std::size_t(facts.st_size) + 1); // one more, so that the end is seen without growing
    }
    read_all(descriptor, path);
}

void file_bytes::reserve(std::size_t capacity)
{
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    std::copy_n(bytes_.get(), size_, larger.get());
    bytes_ = std::move(larger);
    capacity_ = capacity;
}

void file_bytes::read_all(int descriptor, const std::string& name)
{
    for (;;) {
        if (size_ == capacity_)
            reserve(std::max(2 * capacity_, block));
        const ssize_t count = read(descriptor, bytes_.get() + size_, std::min(capacity_ - size_, 64 * block));
        if (count == 0)
            return;
        if (count > 0)
            size_ += std::size_t(count);
        else if (errno != EINTR)
            throw file_error(name + ": cannot be read: " + std::strerror(errno));
    }
}

} // namespace kith::io
