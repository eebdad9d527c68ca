// SPDX-License-Identifier: BSD-3-Clause
#include "partition_options.hpp"

#include "errors.hpp"

#include <kith/metis_partition.hpp>

#include <fstream>

namespace kith::tool {

partition make_partition(const std::string& partitioner, const basic_mesh<>& mesh, std::size_t parts)
{
    const std::string from_file = "file:";
    if (partitioner == "metis")
        return metis_partition(mesh, parts);
    if (partitioner == "block")
        return block_partition(mesh, parts);
    if (not partitioner.starts_with(from_file))
        throw usage_error("--partitioner: '" + partitioner + "' is not one of metis, block, file:PATH");
    const std::string path = partitioner.substr(from_file.size());
    std::ifstream in(path);
    if (not in)
        throw file_error(path + ": cannot be read");
    try {
        return read_partition(in, mesh);
    } catch (const mesh_error& error) {
        throw file_error(path + ": " + error.what());
    }
}

} // namespace kith::tool
