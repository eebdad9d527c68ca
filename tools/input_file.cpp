// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.hpp"

#include "errors.hpp"
#include "mesh_format.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace kith::tool {

namespace {

std::string read_all(std::istream& in, const std::string& path)
{
    std::string bytes;
    constexpr std::size_t block = std::size_t(1) << 20;
    while (in) {
        const std::size_t size = bytes.size();
        bytes.resize(size + block);
        in.read(bytes.data() + size, block);
        bytes.resize(size + std::size_t(in.gcount()));
    }
    if (in.bad())
        throw file_error(path + ": cannot be read: " + std::strerror(errno));
    return bytes;
}

} // namespace

std::string read_bytes(const std::string& path)
{
    if (path == standard_stream)
        return read_all(std::cin, "standard input");
    if (std::filesystem::is_directory(path))
        throw file_error(path + ": is a directory, not a file");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (not in)
        throw file_error(path + ": cannot be opened: " + std::strerror(errno));
    return read_all(in, path);
}

} // namespace kith::tool
