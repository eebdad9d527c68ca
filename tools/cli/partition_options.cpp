// SPDX-License-Identifier: BSD-3-Clause
#include "partition_options.hpp"

#include "errors.hpp"

#include <kith/metis_partition.hpp>

#include <fstream>
#include <string_view>

namespace kith::tool {

namespace {

constexpr std::string_view from_file = "file:";

} // namespace

std::string partitioner_from(const boost::program_options::variables_map& values)
{
    const std::string partitioner = values.count("partitioner") != 0 ? required(values, "partitioner") : "metis";
    if (partitioner != "metis" and partitioner != "block" and not partitioner.starts_with(from_file))
        throw usage_error("--partitioner: '" + partitioner + "' is not one of metis, block, file:PATH");
    return partitioner;
}

partition make_partition(const std::string& partitioner, const basic_mesh<>& mesh, std::size_t parts)
{
    if (partitioner == "metis")
        return metis_partition(mesh, parts);
    if (partitioner == "block")
        return block_partition(mesh, parts);
    const std::string path = partitioner.substr(from_file.size());
    std::ifstream in(path);
    if (not in)
        throw file_error(path + ": cannot be read");
    try {
        return read_partition(in, mesh);
    } catch (const mesh_error& error) {
        throw file_error(
            path + ": " + error.what() +
            "; these are the faces that `kith plan` counts on level 0 (4-8 first cuts faces into triangles)");
    }
}

} // namespace kith::tool
