// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <ostream>
#include <string>

namespace kith::tool {

/// Lets a signal that ends the program remove this file, one at a time, until `keep_when_interrupted`.
void remove_when_interrupted(const std::string& path);
void keep_when_interrupted() noexcept;

/// A file that appears under its name only when it is complete: it is written next to it under another name and renamed
/// by `commit`. Without `commit`, or when that fails, nothing is left and a file that was there before is untouched.
/// What is no regular file (a device, a pipe) is written directly. One at a time, as the file is also removed when a signal
/// ends the program. Errors: file_error.
class output_file {
public:
    explicit output_file(const std::string& path);
    output_file(const output_file&) = delete;
    output_file& operator=(const output_file&) = delete;
    ~output_file();

    [[nodiscard]] std::ostream& stream() { return stream_; }
    void commit();

private:
    /// Some writers flush after every line; only the end of the file does here.
    struct buffer : std::filebuf {
        int sync() override { return 0; }
    };

    [[noreturn]] void refuse(const std::string& what) const;

    std::string path_;
    std::string target_;  ///< path_ with symbolic links followed
    std::string written_; ///< under which name the bytes go, target_ itself for a device
    buffer buffer_;
    std::ostream stream_;
};

} // namespace kith::tool
