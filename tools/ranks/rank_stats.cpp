// SPDX-License-Identifier: BSD-3-Clause
#include "rank_stats.hpp"

#include "cli/json.hpp"
#include "cli/run_stats.hpp"
#include "job/available_memory.hpp"

#include <kith/output_file.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace kith::tool {

namespace {

std::string stats_line(int rank, const mpi::work_done& done, const mpi::traffic& traffic, const phase_seconds& seconds)
{
    return text_of({{"rank", rank},
                    {"tiles", done.tiles},
                    {"owned_faces", done.owned_faces},
                    {"kept_faces", done.kept_faces},
                    {"useful_faces", done.useful_faces},
                    {"bytes_sent", traffic.bytes_sent},
                    {"messages_sent", traffic.messages_sent},
                    {"bytes_received", traffic.bytes_received},
                    {"messages_received", traffic.messages_received},
                    {"peak_bytes", peak_memory()},
                    {"processor_seconds", processor_seconds()},
                    {"seconds", json_of(seconds)}}) +
           "\n";
}

std::string summary(const std::vector<phase_seconds>& ranks)
{
    auto phases = json::object();
    for (std::size_t p = 0; p < phase_names.size(); ++p) {
        double least = std::numeric_limits<double>::max(), most = 0, sum = 0;
        for (const auto& rank : ranks) {
            const double seconds = rank.all()[p];
            least = std::min(least, seconds), most = std::max(most, seconds), sum += seconds;
        }
        phases[std::string(phase_names[p])] = {
            {"minimum", least}, {"mean", sum / double(ranks.size())}, {"maximum", most}};
    }
    return text_of({{"ranks", ranks.size()}, {"seconds", phases}}) + "\n";
}

} // namespace

void write_rank_stats(mpi::communicator& comm, const std::string& path, const mpi::work_done& done,
                      const phase_seconds& seconds)
{
    std::string lines = stats_line(comm.rank(), done, comm.sent_and_received(), seconds);
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root()) {
            comm.send(std::as_bytes(std::span(&seconds, 1)), 0);
            comm.send(std::as_bytes(std::span(lines)), 0);
            return;
        }
        std::vector<phase_seconds> ranks{seconds};
        for (int rank = 1; rank < comm.size(); ++rank) {
            int from = rank;
            auto bytes = comm.receive(from);
            std::memcpy(&ranks.emplace_back(), bytes.data(), sizeof(phase_seconds));
            bytes = comm.receive(from);
            lines.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        }
        io::output_file file(path);
        file.stream() << lines << summary(ranks);
        file.commit();
    });
}

} // namespace kith::tool
