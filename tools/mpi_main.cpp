// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "holes.hpp"
#include "json.hpp"
#include "mesh_input.hpp"
#include "partition_options.hpp"
#include "scheme_options.hpp"
#include "tile_output.hpp"

#include <kith/refine.hpp>
#include <kith/refine_on_ranks.hpp>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <sys/resource.h>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::tool {

namespace {

namespace po = boost::program_options;

constexpr verb refine_verb{"refine", "Refines a mesh in tiles, on all ranks of an MPI job.", nullptr};

struct rank_request {
    std::string input, output, scheme_name, partitioner = "metis", stats;
    any_scheme scheme;
    scheme_words words;
    int levels = 0;
    std::uint64_t tiles_per_rank = 1, memory_per_rank = 0, threads = 1;
    mpi::sharing sharing = mpi::sharing::spmd;
    bool verify = false, with_origin = false;
};

std::uint64_t count_of(const po::variables_map& values, const char* option, std::uint64_t otherwise)
{
    if (values.count(option) == 0)
        return otherwise;
    const auto count = values[option].as<std::int64_t>();
    if (count < 1)
        throw usage_error("--" + std::string(option) + ": " + std::to_string(count) +
                          " were asked for; ask for 1 or more");
    return std::uint64_t(count);
}

mpi::sharing sharing_named(const std::string& name)
{
    if (name == "spmd")
        return mpi::sharing::spmd;
    if (name == "manager")
        return mpi::sharing::manager;
    throw usage_error("--mode: '" + name + "' is not one of spmd, manager");
}

po::options_description options_of_refine()
{
    po::options_description options("Options");
    add_scheme_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the file to write: .vtu or .ply");
    add_option<std::string>(options, "mode", "MODE", "spmd: tiles are dealt out; manager: rank 0 hands them out");
    add_option<std::int64_t>(options, "tiles-per-rank", "K", "cut the mesh into so many tiles per rank");
    add_option<std::string>(options, "memory-per-rank", "BYTES", "cut it into as many tiles as this needs, e.g. 2G");
    add_option<std::string>(
        options, "partitioner", "P", "metis, block or file:PATH (a part per face, as METIS writes)");
    add_option<std::int64_t>(options, "threads", "N", "threads of each rank; 1 unless told, as ranks fill the machine");
    add_flag(options, "cell-origin", "write tile and rank of every cell; the file then depends on the ranks");
    add_flag(options, "verify", "refine on one rank as well and compare the checksums");
    add_option<std::string>(options, "stats", "FILE", "write what each rank did, a JSON object a line");
    return options;
}

std::optional<rank_request> request_from(const std::vector<std::string>& arguments)
{
    const auto values = parse(refine_verb, options_of_refine(), {"IN"}, arguments);
    if (not values)
        return std::nullopt;
    const auto text = [&](const char* option, std::string otherwise) {
        return values->count(option) != 0 ? required(*values, option) : otherwise;
    };
    rank_request request;
    request.input = required(*values, "IN");
    request.output = required(*values, "output");
    require_stitched_format(request.output);
    request.scheme_name = required(*values, "scheme");
    request.words = scheme_words_of(*values);
    request.scheme = make_scheme(request.scheme_name, request.words);
    request.levels = levels_of(*values);
    request.sharing = sharing_named(text("mode", "spmd"));
    request.tiles_per_rank = count_of(*values, "tiles-per-rank", 1);
    request.threads = count_of(*values, "threads", 1);
    request.memory_per_rank = values->count("memory-per-rank") != 0 ? bytes_from(text("memory-per-rank", "")) : 0;
    request.partitioner = text("partitioner", request.partitioner);
    require_partitioner(request.partitioner);
    request.stats = text("stats", "");
    request.verify = values->count("verify") != 0;
    request.with_origin = values->count("cell-origin") != 0;
    return request;
}

/// The most memory this process has had, in bytes.
std::uint64_t peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

/// How many tiles there must be so that refining one stays within the memory of a rank: the last level twice, once with
/// what shadows add to it and once with its ids.
template <class Scheme>
std::uint64_t tiles_for(const rank_request& request, const Scheme& scheme, const basic_mesh<>& control)
{
    const auto levels = plan(count(control.topology()), scheme, request.levels, control.generation());
    const double bytes_of_tile = 2.5 * double(levels.back().least_bytes);
    return std::uint64_t(
        std::clamp(bytes_of_tile / double(request.memory_per_rank) + 1, 1., double(control.face_count())));
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

void write_stats(mpi::communicator& comm, const std::string& path, std::string line)
{
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root()) {
            comm.send(std::as_bytes(std::span(line)), 0);
            return;
        }
        for (int rank = 1; rank < comm.size(); ++rank) {
            int from = rank;
            const auto bytes = comm.receive(from);
            line.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        }
        std::ofstream out(path);
        if (not(out << line).flush())
            throw file_error(path + ": cannot be written");
    });
}

template <class Scheme>
void refine_on_ranks(mpi::communicator& comm, rank_request& request, const Scheme& scheme, const basic_mesh<>& control)
{
    partition parts;
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            return;
        auto tiles = request.tiles_per_rank * std::uint64_t(comm.size());
        if (request.memory_per_rank != 0)
            tiles = std::max(tiles, tiles_for(request, scheme, control));
        parts = make_partition(request.partitioner, control, tiles);
    });
    mpi::rank_refinement refinement(comm, control, scheme, request.levels, parts);
    const whole_counts counts = refinement.whole().counts(request.levels);

    tile_output output(request.output, counts, request.levels, request.with_origin);
    mpi::work_done done, all;
    try {
        mpi::in_agreement(comm, [&] { comm.is_root() ? output.begin() : void(); });
        mpi::in_agreement(comm, [&] { output.open(); });
        done = refinement.refine(request.sharing, [&](std::uint64_t number, const auto& part) {
            output.write(part, {std::uint32_t(number), std::uint32_t(comm.rank())});
        });
        mpi::in_agreement(comm, [&] { output.close(); });
        const auto sums = comm.sum(
            std::array{done.owned_faces, done.kept_faces, done.useful_faces, done.checksum.bits});
        all = {.owned_faces = sums[0], .kept_faces = sums[1], .useful_faces = sums[2], .checksum = {sums[3]}};
        mpi::in_agreement(comm, [&] {
            if (all.owned_faces != counts.faces)
                throw std::logic_error("the tiles have " + std::to_string(all.owned_faces) + " faces, not " +
                                       std::to_string(counts.faces) + "; this is an error in kith");
            if (comm.is_root() and request.verify and
                checksum(refine(control, scheme, request.levels, {connect::faces})) != all.checksum)
                throw std::logic_error("the checksum differs from that of one rank; this is an error in kith");
            if (comm.is_root())
                output.commit();
        });
    } catch (...) {
        if (comm.is_root())
            output.abandon();
        throw;
    }
    if (not request.stats.empty())
        write_stats(comm, request.stats, stats_line(comm.rank(), done, comm.sent_and_received()));
    if (comm.is_root())
        std::cout << request.output << ": " << counts.vertices << " vertices, " << counts.edges << " edges, "
                  << counts.faces << " faces, checksum " << std::hex << all.checksum.bits << std::dec
                  << (request.verify ? ", verified" : "") << '\n';
}

void run_on_ranks(mpi::communicator& comm, rank_request& request)
{
    control_mesh control;
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            return;
        control = read_mesh(request.input);
        give_creases(request.scheme, control, request.words);
        require_no_holes(control);
        control.mesh = prepared(request.scheme, std::move(control.mesh));
        std::visit([&]<class Scheme>(const Scheme&) { require_input<Scheme>(level_of<basic_mesh<>>(control.mesh)); },
                   request.scheme);
    });
    std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            if constexpr (reaching_scheme<Scheme>)
                refine_on_ranks(comm, request, scheme, control.mesh);
            else
                mpi::in_agreement(comm, [] {
                    throw usage_error(std::string(kith::scheme_name<Scheme>()) +
                                      " has no reach, so no tiles; use kith refine");
                });
        },
        request.scheme);
}

/// Exit codes as `kith`; what goes wrong is told once, by rank 0.
int run(mpi::communicator& comm, const std::vector<std::string>& arguments)
{
    const auto tell = [&](const std::string& text) {
        if (comm.is_root())
            std::cerr << "kith-mpi: " << text << '\n';
    };
    try {
        if (arguments.empty() or arguments[0] != refine_verb.name)
            throw usage_error("the verb is missing; there is refine");
        if (not comm.is_root())
            std::cout.setstate(std::ios::failbit); // --help is answered once
        auto request = request_from({arguments.begin() + 1, arguments.end()});
        if (request) {
#if defined(_OPENMP)
            omp_set_num_threads(int(request->threads));
#endif
            run_on_ranks(comm, *request);
        }
        return 0;
    } catch (const usage_error& error) {
        tell(error.what());
        return 2;
    } catch (const mpi::phase_error& error) {
        tell((error.rank == 0 ? "" : "rank " + std::to_string(error.rank) + ": ") + error.what());
        return 1;
    }
}

} // namespace

} // namespace kith::tool

int main(int count, char** arguments)
{
    kith::mpi::session session(count, arguments);
    try {
        kith::mpi::communicator comm(MPI_COMM_WORLD);
        return kith::tool::run(comm, {arguments + 1, arguments + count});
    } catch (const std::exception& error) {
        kith::mpi::session::abort(std::string("kith-mpi: ") + error.what());
    }
}
