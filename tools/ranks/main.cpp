// SPDX-License-Identifier: BSD-3-Clause
#include "rank_request.hpp"
#include "refine_ranks.hpp"
#include "cli/errors.hpp"
#include "cli/terminal.hpp"

#include <kith/output_file.hpp>

#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::tool {

namespace {

constexpr verb refine_verb{"refine",
                           "Refines a mesh in tiles, on all ranks of an MPI job.",
                           nullptr,
                           "Examples:\n"
                           "  mpirun -n 64 kith-mpi refine cow.off -s loop -n 9 -o fine.vtu\n"
                           "  mpirun -n 64 kith-mpi refine cow.off -s loop -n 9 -o fine.ply --journal kept\n"
                           "  mpirun -n 16 kith-mpi refine --journal kept     # resumes the job above after a failure\n"
                           "The output has the same bytes on any number of ranks. All output formats are binary.\n",
                           "kith-mpi"};

void print_help()
{
    std::cout << "kith-mpi refine [IN] [options]: subdivision surfaces in tiles, on all ranks of an MPI job\n\n"
                 "`kith-mpi refine --help` lists the options, with examples. The extension of IN selects\n"
                 "OFF, OBJ, PLY, STL or VTU; the output is .vtu, .pvtu or .ply. The program kith has the other verbs,\n"
                 "see `kith --help`.\n"
                 "Exit codes: 0 success, 1 bad input, 2 wrong use, other codes if MPI ended the job.\n";
}

/// Runs the program on this rank and returns the exit code, as `kith` does. Rank 0 alone reports an error, once.
int run(mpi::communicator& comm, const std::vector<std::string>& arguments)
{
    const auto tell = [&](const std::string& text) {
        if (comm.is_root())
            std::cerr << "kith-mpi: " << text << '\n';
    };
    try {
        if (not comm.is_root()) {
            std::cout.setstate(std::ios::failbit); // --help is answered once
            erase_progress();
        }
        if (arguments.empty())
            throw usage_error("the verb is missing; use refine, see `kith-mpi --help`");
        if (arguments[0] == "--help" or arguments[0] == "-h") {
            print_help();
            return 0;
        }
        if (arguments[0] == "--version") {
            print_version(refine_verb.program);
            return 0;
        }
        if (arguments[0] != refine_verb.name)
            throw usage_error("'" + arguments[0] + "' is not a verb; use refine, see `kith-mpi --help`");
        std::optional<rank_request> request;
        try {
            request = rank_request_from(refine_verb, {arguments.begin() + 1, arguments.end()});
        } catch (const file_error& error) { // on all ranks, as they have the same arguments
            tell(error.what());
            return 1;
        }
        if (request) {
#if defined(_OPENMP)
            omp_set_num_threads(int(request->threads));
#endif
            refine_ranks(comm, *request);
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
    kith::io::remove_unfinished_when_interrupted(std::chrono::milliseconds(300), kith::tool::erase_progress);
    const kith::tool::printable_output printable(true);
    std::signal(SIGXFSZ, SIG_IGN); // a write beyond what is allowed is then reported like any other that fails
    kith::mpi::session session(count, arguments);
    try {
        kith::mpi::communicator comm(MPI_COMM_WORLD);
        return kith::tool::run(comm, {arguments + 1, arguments + count});
    } catch (const std::exception& error) {
        kith::mpi::session::abort(std::string("kith-mpi: ") + error.what());
    }
}
