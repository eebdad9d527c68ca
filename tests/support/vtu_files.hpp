// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

/// Functions that read and change VTU files.
namespace vtu_files {

namespace fs = std::filesystem;

/// A reader of the arrays of a VTU file. It finds them by the offsets in the head, like any reader of the format.
class vtu_reader {
public:
    explicit vtu_reader(const fs::path& path)
    {
        std::ifstream in(path, std::ios::binary);
        bytes_.assign(std::istreambuf_iterator<char>(in), {});
        const std::string mark = "<AppendedData encoding=\"raw\">\n_";
        begin_ = bytes_.find(mark);
        if (begin_ == std::string::npos)
            throw std::runtime_error(path.string() + " has no data");
        head_ = bytes_.substr(0, begin_);
        begin_ += mark.size();
    }
    [[nodiscard]] std::string head() const { return head_; }
    /// Returns the array whose XML element has this attribute.
    template <class T>
    [[nodiscard]] std::vector<T> array(const std::string& attribute) const
    {
        const std::size_t at = head_.find("offset=\"", head_.find(attribute)) + 8;
        const std::size_t offset = begin_ + std::stoul(head_.substr(at));
        std::uint64_t size = 0;
        std::memcpy(&size, bytes_.data() + offset, sizeof size);
        std::vector<T> result(size / sizeof(T));
        if (size != 0)
            std::memcpy(result.data(), bytes_.data() + offset + sizeof size, size);
        return result;
    }

private:
    std::string bytes_, head_;
    std::size_t begin_ = 0;
};

/// A temporary directory, which the destructor removes.
struct directory {
    fs::path path = fs::temp_directory_path() / ("kith_files_" + std::to_string(getpid()));

    directory() { fs::create_directory(path); }
    ~directory() { fs::remove_all(path); }
};

inline std::string bytes_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Changes each byte of a range of a file and restores it. Calls changed(place, true) after a change and
/// changed(place, false) after the byte is restored.
template <class Changed>
void for_each_changed_byte(const fs::path& path, std::size_t begin, std::size_t end, const Changed& changed)
{
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    for (std::size_t at = begin; at < end; ++at) {
        file.seekg(std::streamoff(at));
        const char before = char(file.get());
        for (const char now : {char(before ^ 0x10), before}) {
            file.seekp(std::streamoff(at));
            file.put(now).flush();
            changed(at, now != before);
        }
    }
}

} // namespace vtu_files
