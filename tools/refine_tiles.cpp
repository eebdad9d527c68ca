// SPDX-License-Identifier: BSD-3-Clause
#include "refine_tiles.hpp"

#include "errors.hpp"
#include "partition_options.hpp"
#include "tile_output.hpp"

#include <kith/refine_in_tiles.hpp>

#include <variant>

namespace kith::tool {

tiled_result refine_tiles(const basic_mesh<>& control, const refine_request& request, std::uint64_t tiles,
                          const std::string& partitioner, const std::string& output)
{
    const auto refine_by = [&]<class Scheme>(const Scheme& scheme) -> tiled_result {
        if constexpr (reaching_scheme<Scheme>) {
            const partition parts = make_partition(partitioner, control, tiles);
            tiled_refinement refinement(control, scheme, request.levels, parts);
            tiled_result result{refinement.whole().counts(request.levels), {}};
            tile_output file(output, result.counts, request.levels, false);
            try {
                file.begin();
                for (std::size_t t = 0; t < refinement.tiles(); ++t) {
                    const auto part = refinement.refine(t);
                    file.write(part, {std::uint32_t(t), 0});
                    result.checksum += checksum(part);
                }
                file.close();
                file.commit();
            } catch (...) {
                file.abandon();
                throw;
            }
            return result;
        } else {
            throw usage_error("--tiles: " + std::string(scheme_name<Scheme>()) + " has no reach; refine without tiles");
        }
    };
    return std::visit(refine_by, request.scheme);
}

} // namespace kith::tool
