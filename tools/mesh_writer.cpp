// SPDX-License-Identifier: BSD-3-Clause
#include "errors.hpp"
#include "mesh_file.hpp"

#include <kith/output_file.hpp>

#include <iostream>

namespace kith::tool {

void write_mesh_file(const std::string& path, const io::written_mesh& what)
{
    const mesh_format format = output_format_of(path);
    try {
        require_writable(format, what);
    } catch (const file_error& error) {
        throw file_error(path + ": " + error.what());
    }
    if (path == standard_stream) {
        write_mesh(std::cout, format, what);
        if (not std::cout.flush())
            throw file_error("standard output: could not be written completely");
        return;
    }
    io::output_file file(path);
    write_mesh(file.stream(), format, what);
    file.commit();
}

} // namespace kith::tool
