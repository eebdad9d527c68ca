// SPDX-License-Identifier: BSD-3-Clause
#include <kith/output_file.hpp>

#include <kith/io/text/file_error.hpp>

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kith::io {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view mark_of_unfinished = ".incomplete-";
constexpr std::string_view mark_of_directory = ".pieces";

/// The list of all files that a signal has to remove. It leads through the files themselves, so that adding and
/// removing one cannot fail. It is never destroyed, because a signal may come while the program ends.
struct unfinished_files {
    std::recursive_mutex mutex;
    unfinished_file* first = nullptr;
};

unfinished_files& unfinished()
{
    static auto* const all = new unfinished_files;
    return *all;
}

/// A directory that is open until the end of a scope.
struct open_directory {
    explicit open_directory(const char* path) : stream(::opendir(path)) {}
    open_directory(const open_directory&) = delete;
    open_directory& operator=(const open_directory&) = delete;
    ~open_directory()
    {
        if (stream != nullptr)
            ::closedir(stream);
    }
    /// Returns the name of the next entry, or null after the last one.
    [[nodiscard]] const char* next() const
    {
        const dirent* const entry = stream == nullptr ? nullptr : ::readdir(stream);
        return entry == nullptr ? nullptr : entry->d_name;
    }

    DIR* stream;
};

/// Removes a directory and the files in it. Returns false if something of it is left. Makes no object on the heap,
/// because it is also called when memory has run out.
bool remove_directory(const char* path) noexcept
{
    {
        const open_directory directory(path);
        if (directory.stream == nullptr)
            return errno == ENOENT;
        while (const char* const name = directory.next())
            ::unlinkat(::dirfd(directory.stream), name, 0);
    }
    return ::rmdir(path) == 0;
}

sigset_t ending_signals()
{
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) == 0 and now.sa_handler != SIG_IGN) // as under nohup
            sigaddset(&signals, signal);
    }
    return signals;
}

std::chrono::milliseconds patience_without_work{};
void (*before_removing)() = nullptr;

void* wait_for_signal(void*)
{
    const sigset_t signals = ending_signals();
    int signal = 0;
    if (sigwait(&signals, &signal) != 0)
        return nullptr;
    auto& all = unfinished();
    all.mutex.lock(); // for ever: nothing is begun or gets its name any more
    if (before_removing != nullptr)
        before_removing();
    for (const unfinished_file* file = all.first; file != nullptr; file = file->next())
        file->remove_for_good();
    if (all.first == nullptr)
        std::this_thread::sleep_for(patience_without_work);
    struct sigaction otherwise = {};
    otherwise.sa_handler = SIG_DFL;
    sigaction(signal, &otherwise, nullptr);
    kill(getpid(), signal);
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    return nullptr;
}

/// Opens a file for writing and locks it. Returns -1 on an error, or if another process holds the lock; errno has the
/// reason.
int open_locked(const std::string& path, int flags)
{
    for (;;) {
        const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0666);
        if (descriptor < 0)
            return -1;
        const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
        const int reason = errno;
        const bool has_locks = locked or reason == EWOULDBLOCK;
        struct stat mine = {}, there = {};
        const bool is_same = ::fstat(descriptor, &mine) == 0 and ::stat(path.c_str(), &there) == 0 and
                             mine.st_ino == there.st_ino and mine.st_dev == there.st_dev;
        if ((locked and is_same) or (not has_locks and (flags & O_CREAT) != 0))
            return descriptor;
        ::close(descriptor);
        errno = reason;
        if (not locked or (flags & O_CREAT) == 0)
            return -1;
        // Another process mistook the new file for one that was left behind, and removed it.
    }
}

/// Removes the files that killed processes have left of the same output.
void remove_stale(const std::string& target)
{
    const fs::path place(target);
    const std::string prefix = place.filename().string().append(mark_of_unfinished);
    const fs::path parent = place.has_parent_path() ? place.parent_path() : ".";
    std::vector<std::string> found;
    // Not std::filesystem's iterator, whose steps end the program when an allocation fails (libstdc++ 12).
    const open_directory directory(parent.c_str());
    while (const char* const entry = directory.next()) {
        const std::string_view name = entry;
        if (name.size() > prefix.size() and name.starts_with(prefix) and
            name.find_first_not_of("0123456789", prefix.size()) == std::string::npos)
            found.push_back((parent / name).string());
    }
    for (const auto& path : found) {
        const std::string pieces = path + std::string(mark_of_directory);
        struct stat status = {};
        if (::lstat(path.c_str(), &status) != 0 or not S_ISREG(status.st_mode))
            continue;
        if (const int descriptor = open_locked(path, 0); descriptor >= 0) {
            remove_directory(pieces.c_str());
            ::unlink(path.c_str());
            ::close(descriptor);
        }
    }
}

} // namespace

void remove_unfinished_when_interrupted(std::chrono::milliseconds patience, void (*before)())
{
    patience_without_work = patience;
    before_removing = before;
    const sigset_t signals = ending_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    pthread_attr_t settings;
    pthread_attr_init(&settings);
    pthread_attr_setdetachstate(&settings, PTHREAD_CREATE_DETACHED);
    constexpr std::size_t small_stack = std::size_t(256) << 10; // address space may be limited
    pthread_attr_setstacksize(&settings, small_stack);
    pthread_t thread;
    if (pthread_create(&thread, &settings, wait_for_signal, nullptr) != 0)
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr); // signals can then at least end the program
    pthread_attr_destroy(&settings);
}

std::unique_lock<std::recursive_mutex> hold_interruptions()
{
    return std::unique_lock(unfinished().mutex);
}

std::string target_of(const std::string& path)
{
    fs::path result(path);
    std::error_code failed;
    for (int links = 0; fs::is_symlink(result, failed); ++links) {
        constexpr int most_links = 40; // as Linux
        if (links == most_links)
            throw file_error(path + ": cannot be written: its symbolic links lead in a circle");
        const fs::path next = fs::read_symlink(result, failed);
        if (failed)
            throw file_error(path + ": cannot be written: " + failed.message());
        result = result.parent_path() / next;
    }
    return result.string();
}

std::string unfinished_name(const std::string& target, unsigned long process)
{
    return target + std::string(mark_of_unfinished) + std::to_string(process);
}

void give_name(const std::string& finished, const std::string& target)
{
    const auto lock = hold_interruptions();
    std::error_code failed;
    if (const auto before = fs::status(target, failed); fs::exists(before))
        fs::permissions(finished, before.permissions(), failed);
    fs::rename(finished, target, failed);
    if (failed)
        throw file_error(target + ": the finished temporary file could not be renamed: " + failed.message());
}

unfinished_file::unfinished_file(const std::string& path) : unfinished_file() // so that its destructor tidies up
{
    path_ = path;
    target_ = target_of(path);
    std::error_code failed;
    const fs::file_status before = fs::status(target_, failed);
    const bool exists = fs::exists(before);
    if (fs::is_directory(before))
        refuse("is a directory, not a file");
    if (exists and ::access(target_.c_str(), W_OK) != 0)
        refuse(std::string("cannot be written: ") + std::strerror(errno));
    if (exists and not fs::is_regular_file(before)) {
        name_ = target_;
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
        if (descriptor_ < 0)
            refuse(std::string("cannot be written: ") + std::strerror(errno));
        return;
    }
    remove_stale(target_);
    name_ = unfinished_name(target_, static_cast<unsigned long>(::getpid()));
    create();
    if (exists)
        ::fchmod(descriptor_, mode_t(before.permissions())); // before the first byte, as the file may be secret
}

void unfinished_file::create()
{
    const auto lock = hold_interruptions();
    descriptor_ = open_locked(name_, O_CREAT);
    if (descriptor_ < 0)
        refuse(std::string("cannot be written: ") +
               (errno == EWOULDBLOCK ? "another process with the same number writes it" : std::strerror(errno)));
    next_ = std::exchange(unfinished().first, this);
    if (::ftruncate(descriptor_, 0) != 0)
        refuse(std::string("cannot be written: ") + std::strerror(errno));
}

unfinished_file::~unfinished_file()
{
    remove();
}

void unfinished_file::remove() noexcept
{
    if (descriptor_ < 0)
        return;
    if (not is_direct()) {
        const auto lock = hold_interruptions();
        if (not directory_.empty())
            remove_directory(directory_.c_str());
        ::unlink(name_.c_str()); // if that cannot be removed either, the error has been reported already
        forget();
    }
    ::close(std::exchange(descriptor_, -1)); // this also releases the lock
}

void unfinished_file::remove_for_good() const
{
    for (int attempt = 0; attempt < 100; ++attempt) {
        // The directory first: the file tells later processes that it is there.
        if ((directory_.empty() or remove_directory(directory_.c_str())) and
            (::unlink(name_.c_str()) == 0 or errno == ENOENT))
            return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

void unfinished_file::forget() noexcept
{
    unfinished_file** link = &unfinished().first;
    while (*link != this)
        link = &(*link)->next_;
    *link = next_;
}

void unfinished_file::make_directory(const std::string& directory)
{
    const auto lock = hold_interruptions();
    directory_ = directory;
    remove_directory(directory_.c_str());
    if (::mkdir(directory_.c_str(), 0777) != 0)
        throw file_error(directory + ": cannot be created: " + std::strerror(errno));
}

void unfinished_file::commit()
{
    if (not is_direct()) {
        const auto lock = hold_interruptions();
        try {
            give_name(name_, target_);
        } catch (...) {
            remove();
            throw;
        }
        forget();
    }
    ::close(std::exchange(descriptor_, -1));
}

void unfinished_file::refuse(const std::string& what) const
{
    throw file_error(path_ + ": " + what);
}

output_file::output_file(const std::string& path)
    : path_(path), file_(path), buffer_(file_.descriptor()), stream_(&buffer_)
{
}

void output_file::commit()
{
    const bool written = stream_.good();
    const int error = buffer_.finish();
    if (not written or error != 0)
        throw file_error(
            path_ + ": could not be written completely: " + (error != 0 ? std::strerror(error) : "no reason given"));
    file_.commit();
}

output_file::buffer::buffer(int file)
    : bytes_(std::size_t(1) << 20), descriptor_(::dup(file)), error_(descriptor_ < 0 ? errno : 0)
{
    setp(bytes_.data(), bytes_.data() + bytes_.size());
}

output_file::buffer::~buffer()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

int output_file::buffer::finish()
{
    write_out();
    if (descriptor_ >= 0 and ::close(std::exchange(descriptor_, -1)) != 0 and error_ == 0)
        error_ = errno;
    return error_;
}

output_file::buffer::int_type output_file::buffer::overflow(int_type c)
{
    if (not write_out())
        return traits_type::eof();
    if (not traits_type::eq_int_type(c, traits_type::eof()))
        sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
}

bool output_file::buffer::write_out()
{
    const char* from = pbase();
    while (error_ == 0 and from != pptr()) {
        const ssize_t count = ::write(descriptor_, from, std::size_t(pptr() - from));
        if (count >= 0)
            from += count;
        else if (errno != EINTR)
            error_ = errno;
    }
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return error_ == 0;
}

} // namespace kith::io
