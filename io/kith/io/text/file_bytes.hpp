// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace kith::io {

/// The bytes of a file, in memory of this process, which no other process can change.
class file_bytes {
public:
    /// Reads the file at this path, or standard input for "-". Errors: file_error, which begins with the path.
    explicit file_bytes(const std::string& path);

    [[nodiscard]] std::string_view view() const { return {bytes_.get(), size_}; }

private:
    void read_all(int descriptor, const std::string& name);
    void reserve(std::size_t capacity);

    std::unique_ptr<char[]> bytes_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace kith::io
