// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_input.hpp"

#include "errors.hpp"
#include "mesh_file.hpp"

namespace kith::tool {

control_mesh read_mesh(const std::string& path)
{
    const polygon_soup soup = read_mesh_file(path);
    try {
        return {make_mesh(soup.points, soup.faces), soup.tags};
    } catch (const mesh_error& error) {
        throw file_error(path + ":\n" + error.what());
    }
}

} // namespace kith::tool
