// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <chrono>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace kith::io {

/// Lets a signal that ends the program (SIGTERM, SIGINT, SIGHUP, unless they are ignored) first remove what is
/// unfinished: a thread of its own waits for the signals, removes, and ends the program by the signal. Called once, at
/// the beginning of main, since all threads that are started later must leave these signals to that one. A process that
/// has nothing to remove ends so much later, for those that have: mpirun kills all ranks as soon as one has ended.
/// `before` is called first, on the waiting thread.
void remove_unfinished_when_interrupted(std::chrono::milliseconds patience = {}, void (*before)() = nullptr);

/// While it is held, a signal waits: what is several steps is done as one.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hold_interruptions();

/// The file that a path leads to when symbolic links are followed, whether it is there or not. Errors: file_error for
/// links that lead in a circle.
std::string target_of(const std::string& path);

/// The name of what is unfinished, next to the target, for the process with this number.
std::string unfinished_name(const std::string& target, unsigned long process);

/// Gives a finished file the name of its target, with the permissions of a file that is replaced. Errors: file_error.
void give_name(const std::string& finished, const std::string& target);

/// A file under another name, until `commit` gives it its own. Without `commit`, or when that fails, nothing is left
/// and a file that was there before is untouched. It has the permissions of the file that it will replace. Symbolic
/// links are followed. What is no regular file (a device, a pipe) is written directly.
/// The process that makes it holds a lock (flock) on it, so what was left by a process that was killed is recognised,
/// on any host, and removed by the next one that writes the same output; not on a file system without locks. Errors:
/// file_error.
class unfinished_file {
public:
    /// Makes the file, or opens the device. Errors: file_error for a path that cannot be written, which it begins with.
    explicit unfinished_file(const std::string& path);
    unfinished_file(const unfinished_file&) = delete;
    unfinished_file& operator=(const unfinished_file&) = delete;
    ~unfinished_file();

    [[nodiscard]] const std::string& target() const { return target_; }
    /// Its name for now, the target itself for a device.
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool is_direct() const { return name_ == target_; }
    /// Open for writing, empty, until this object ends.
    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// A directory that belongs to it: made now, removed like the file, left alone by `commit`. Errors: file_error.
    void make_directory(const std::string& directory);
    /// Gives the file its name. Precondition: what was to be written is in it. Errors: file_error; nothing is left
    /// then.
    void commit();

    /// For the thread that waits for signals, with interruptions held: removes the file and its directory, and tries
    /// again for a second, since others may be putting more into the directory.
    void remove_for_good() const;
    /// The unfinished file that was begun before this one.
    [[nodiscard]] const unfinished_file* next() const { return next_; }

private:
    unfinished_file() = default;
    void create();
    void remove() noexcept;
    void forget() noexcept;
    [[noreturn]] void refuse(const std::string& what) const;

    std::string path_;   ///< for messages
    std::string target_; ///< with symbolic links followed
    std::string name_;
    std::string directory_;
    int descriptor_ = -1;
    unfinished_file* next_ = nullptr; ///< in the list of all that a signal has to remove
};

/// A file that appears under its name only when it is complete, written as a stream. Errors: file_error.
class output_file {
public:
    /// Errors: as unfinished_file.
    explicit output_file(const std::string& path);

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// Writes what is left and gives the file its name. Errors: file_error for what could not be written, to the stream
    /// before as well; nothing is left then.
    void commit();

private:
    /// Writes large chunks; flushing is left to `finish`, since some writers flush after every line.
    class buffer : public std::streambuf {
    public:
        /// For another descriptor of a file that is open; closing it tells what could not be written.
        explicit buffer(int file);
        ~buffer() override;
        /// Writes the rest and closes. Returns the error (errno), or 0.
        int finish();

    protected:
        int_type overflow(int_type c) override;
        int sync() override { return 0; }

    private:
        bool write_out();

        std::vector<char> bytes_; // the only allocation comes first
        int descriptor_;
        int error_ = 0;
    };

    std::string path_;
    unfinished_file file_;
    buffer buffer_;
    std::ostream stream_;
};

} // namespace kith::io
