// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.hpp"

#include "errors.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace kith::tool {

namespace fs = std::filesystem;

namespace {

/// What a signal that ends the program must remove; the pointer is all that a handler may look at.
std::string removed_on_signal;
std::atomic<const char*> path_to_remove = nullptr;

extern "C" void remove_and_end(int signal)
{
    if (const char* const path = path_to_remove.load(); path != nullptr)
        unlink(path);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

} // namespace

void remove_when_interrupted(const std::string& path)
{
    keep_when_interrupted();
    removed_on_signal = path;
    path_to_remove = removed_on_signal.c_str();
    for (const int signal : {SIGHUP, SIGINT, SIGTERM})
        if (std::signal(signal, remove_and_end) == SIG_IGN)
            std::signal(signal, SIG_IGN); // as under nohup
}

void keep_when_interrupted() noexcept
{
    path_to_remove = nullptr;
}

output_file::output_file(const std::string& path) : path_(path), stream_(&buffer_)
{
    std::error_code failed;
    const bool exists = fs::exists(path, failed);
    target_ = exists ? fs::canonical(path).string() : path;
    if (fs::is_directory(target_, failed))
        refuse("is a directory, not a file");
    if (exists and access(target_.c_str(), W_OK) != 0)
        refuse(std::string("cannot be written: ") + std::strerror(errno));
    const bool direct = exists and not fs::is_regular_file(target_);
    written_ = direct ? target_ : target_ + ".incomplete-" + std::to_string(getpid());
    if (not direct)
        remove_when_interrupted(written_);
    errno = 0;
    if (buffer_.open(written_, std::ios::out | std::ios::binary | std::ios::trunc) == nullptr) {
        const std::string reason = std::strerror(errno);
        written_.clear();
        refuse("cannot be written: " + reason);
    }
}

output_file::~output_file()
{
    if (not written_.empty() and written_ != target_) {
        buffer_.close();
        std::error_code ignored; // what cannot be removed either has been reported already
        fs::remove(written_, ignored);
    }
    keep_when_interrupted();
}

void output_file::commit()
{
    errno = 0;
    const bool written = stream_.good();
    const bool closed = buffer_.close() != nullptr;
    if (not written or not closed)
        refuse(std::string("could not be written completely: ") +
               (errno != 0 ? std::strerror(errno) : "no reason given"));
    if (written_ == target_)
        return;
    std::error_code failed;
    if (fs::exists(target_, failed))
        fs::permissions(written_, fs::status(target_).permissions(), failed);
    fs::rename(written_, target_, failed);
    if (failed)
        refuse("could not be given its name: " + failed.message());
    written_.clear();
}

void output_file::refuse(const std::string& what) const
{
    throw file_error(path_ + ": " + what);
}

} // namespace kith::tool
