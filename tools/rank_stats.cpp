// SPDX-License-Identifier: BSD-3-Clause
#include "rank_stats.hpp"

#include "errors.hpp"
#include "json.hpp"

#include <cstdint>
#include <fstream>
#include <span>

#include <sys/resource.h>

namespace kith::tool {

namespace {

/// The most memory this process has had, in bytes.
std::uint64_t peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

std::string stats_line(int rank, const mpi::work_done& done, const mpi::traffic& traffic)
{
    return json_object()
               .add("rank", rank)
               .add("tiles", done.tiles)
               .add("owned_faces", done.owned_faces)
               .add("kept_faces", done.kept_faces)
               .add("useful_faces", done.useful_faces)
               .add("bytes_sent", traffic.bytes_sent)
               .add("messages_sent", traffic.messages_sent)
               .add("bytes_received", traffic.bytes_received)
               .add("messages_received", traffic.messages_received)
               .add("peak_bytes", peak_memory())
               .text() +
           "\n";
}

} // namespace

void write_stats(mpi::communicator& comm, const std::string& path, const mpi::work_done& done)
{
    std::string lines = stats_line(comm.rank(), done, comm.sent_and_received());
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root()) {
            comm.send(std::as_bytes(std::span(lines)), 0);
            return;
        }
        for (int rank = 1; rank < comm.size(); ++rank) {
            int from = rank;
            const auto bytes = comm.receive(from);
            lines.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        }
        std::ofstream out(path);
        if (not(out << lines).flush())
            throw file_error(path + ": cannot be written");
    });
}

} // namespace kith::tool
