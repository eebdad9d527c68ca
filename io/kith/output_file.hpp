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

/// Makes a signal that ends the program (SIGTERM, SIGINT, SIGHUP, unless it is ignored) first remove all unfinished
/// files. A thread waits for the signals, removes the files, and ends the program by the signal. Precondition: called
/// once, at the beginning of main, since all later threads must leave these signals to that thread. A process with
/// nothing to remove ends later by `patience`, so that other processes can remove their files: mpirun kills all ranks
/// as soon as one has ended. `before` is called first, on the waiting thread.
void remove_unfinished_when_interrupted(std::chrono::milliseconds patience = {}, void (*before)() = nullptr);

/// Returns a lock. Signals wait until it is released, so that several steps are done as one.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hold_interruptions();

/// Returns the path to which a path leads when symbolic links are followed, whether that file exists or not. Errors:
/// file_error for links that lead in a circle.
std::string target_of(const std::string& path);

/// Returns the name of the unfinished file, next to the target, of the process with this number.
std::string unfinished_name(const std::string& target, unsigned long process);

/// Renames a finished file to its target, with the permissions of a file that is replaced. Errors: file_error.
void give_name(const std::string& finished, const std::string& target);

/// A file under another name, until `commit` gives it its own. Without `commit`, or if that fails, nothing is left and
/// an earlier file is untouched. The file has the permissions of the file that it will replace. Symbolic links are
/// followed. A target that is no regular file (a device, a pipe) is written directly.
/// The process that makes the file holds a lock (flock) on it. A file that was left by a killed process, on any host,
/// is thus recognised; the next process that writes the same output removes it. This does not work on a file system
/// without locks. Errors: file_error.
class unfinished_file {
public:
    /// Makes the file, or opens the device. Errors: file_error for a path that cannot be written; it begins with the
    /// path.
    explicit unfinished_file(const std::string& path);
    unfinished_file(const unfinished_file&) = delete;
    unfinished_file& operator=(const unfinished_file&) = delete;
    ~unfinished_file();

    [[nodiscard]] const std::string& target() const { return target_; }
    /// Returns the present name of the file; for a device, the target itself.
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool is_direct() const { return name_ == target_; }
    /// Returns the descriptor of the file, which is empty and open for writing until this object ends.
    [[nodiscard]] int descriptor() const { return descriptor_; }

    /// Makes a directory that belongs to the file. It is removed with the file; `commit` leaves it as it is. Errors:
    /// file_error.
    void make_directory(const std::string& directory);
    /// Gives the file its name. Precondition: all content is written. Errors: file_error; nothing is left then.
    void commit();

    /// Removes the file and its directory, for the thread that waits for signals, with interruptions held. It tries
    /// again for a second, because others may still put files into the directory.
    void remove_for_good() const;
    /// Returns the unfinished file that was begun before this one.
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

/// A file that is written as a stream, and appears under its name only when it is complete. Errors: file_error.
class output_file {
public:
    /// Begins the file. Errors: as unfinished_file.
    explicit output_file(const std::string& path);

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// Writes the rest and gives the file its name. Errors: file_error if this or earlier output to the stream could
    /// not be written; nothing is left then.
    void commit();

private:
    /// A buffer that writes large chunks. Only `finish` flushes it, because some writers flush after every line.
    class buffer : public std::streambuf {
    public:
        /// Makes another descriptor of an open file. Closing that one reports an error if output could not be written.
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
