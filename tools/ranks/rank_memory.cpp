// SPDX-License-Identifier: BSD-3-Clause
#include "rank_memory.hpp"

#include "job/available_memory.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kith::tool {

memory_limit memory_of_ranks(mpi::communicator& comm, const rank_request& request)
{
    const std::uint64_t host = std::hash<std::string>()(mpi::host_name());
    const auto hosts = comm.to_each(std::vector<std::uint64_t>(std::size_t(comm.size()), host));
    const double share = double(available_memory()) / double(std::ranges::count(hosts, host));
    const double least = comm.minimum(std::array{share})[0];
    if (request.memory_per_rank != 0)
        return {request.memory_per_rank, true};
    return {std::uint64_t(least) / 10 * 9, false};
}

} // namespace kith::tool
