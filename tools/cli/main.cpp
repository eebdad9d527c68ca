// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "terminal.hpp"
#include "word_list.hpp"

#include <kith/output_file.hpp>

#include <array>
#include <csignal>
#include <exception>
#include <iomanip>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace kith::tool {

namespace {

constexpr int good = 0;
constexpr int bad_input = 1;
constexpr int wrong_use = 2;

constexpr std::array verbs{
    verb{"refine",
         "Refines a mesh and writes the result.",
         run_refine,
         "Examples:\n"
         "  kith refine cow.off -s loop -n 3 -o fine.ply --binary\n"
         "  kith refine house.obj -s loop --triangulate -n 4 -o fine.obj --limit\n"
         "  kith refine cow.off -s loop -n 9 -o fine.vtu --tiles 500     # for results larger than memory\n"
         "The extension of a file selects OFF, OBJ, PLY, STL, VTP or VTU; - is standard input or output, as OFF.\n"
         "IN may be .pvtu or .pvtp, too; OUT may be .glb, or .vtu or .pvtu, which need no --tiles.\n"
         "With tiles, the output is .vtu, .pvtu or .ply, and always binary.\n"},
    verb{"tessellate",
         "Writes triangles on the limit surface of a mesh, as fine as asked for.",
         run_tessellate,
         "Examples:\n"
         "  kith tessellate cow.off -s loop --chord-error 0.001 -o cow.ply\n"
         "  kith tessellate house.obj -s catmull-clark --segments 8 -o house.obj\n"},
    verb{"picture",
         "Draws the limit surface of a mesh, or its levels, as PNG or SVG.",
         run_picture,
         "Examples:\n"
         "  kith picture cow.off -s loop --wire 1 -o cow.png\n"
         "  kith picture house.obj -s catmull-clark --color gaussian --view 30,20 --up y -o house.png\n"
         "  kith picture house.obj -s catmull-clark,doo-sabin -n 0,1,2,3 --color parent -o levels.svg\n"},
    verb{"view",
         "Writes a page for browsers in which meshes are refined, turned, picked and changed.",
         run_view,
         "Examples:\n"
         "  kith view cow.off -s loop -n 2 -o cow.html\n"
         "  kith view cube.obj torus.obj -s catmull-clark,doo-sabin --up y -o gallery.html\n"},
    verb{"info",
         "Reports the contents and the problems of a mesh file; exit code 1 if it has problems.",
         run_info,
         "Examples:\n"
         "  kith info cow.off\n"
         "  kith info cow.off --json\n"},
    verb{"compare",
         "Compares two meshes, in any numbering or bit by bit; exit code 1 if they differ.",
         run_compare,
         "Examples:\n"
         "  kith compare a.off b.ply --tolerance 1e-9\n"
         "  kith compare a.off b.ply --bitwise\n"},
    verb{"plan",
         "Predicts the size of each level and the work of each rank, without refining.",
         run_plan,
         "Examples:\n"
         "  kith plan cow.off -s loop -n 9\n"
         "  kith plan cow.off -s loop -n 9 --ranks 64 --tiles-per-rank 4\n"},
    verb{"schemes",
         "Lists the subdivision schemes, the faces that they accept and their options.",
         run_schemes,
         "Examples:\n"
         "  kith schemes --json\n"},
};

void print_help(std::ostream& out)
{
    out << "kith VERB [arguments]: subdivision surfaces\n\n";
    for (const auto& verb : verbs)
        out << "  " << std::left << std::setw(12) << verb.name << verb.summary << '\n';
    out << "\n`kith VERB --help` lists the options of a verb, with examples. The extension of a file selects\n"
           "OFF, OBJ, PLY, STL or VTU; `-` is standard input or output, as OFF.\n"
           "Only `kith refine` writes VTU (.vtu, .pvtu).\n"
           "Exit codes: 0 success, 1 bad input or a difference, 2 wrong use.\n";
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.empty()) {
        print_help(std::cerr);
        return wrong_use;
    }
    if (arguments[0] == "--help" or arguments[0] == "-h") {
        print_help(std::cout);
        return good;
    }
    if (arguments[0] == "--version") {
        print_version();
        return good;
    }
    for (const auto& verb : verbs)
        if (verb.name == arguments[0])
            return verb.run(verb, {arguments.begin() + 1, arguments.end()});
    std::string known;
    for (const auto& verb : verbs)
        append_to_list(known, verb.name);
    throw usage_error("'" + arguments[0] + "' is not a verb; the verbs are " + known);
}

int run_and_report(const std::vector<std::string>& arguments)
{
    try {
        const int result = run(arguments);
        if (not std::cout.flush())
            throw file_error("standard output: cannot be written");
        return result;
    } catch (const usage_error& error) {
        std::cerr << "kith: " << error.what() << "\nSee `kith --help`.\n";
        return wrong_use;
    } catch (const std::bad_alloc&) {
        std::cerr << "kith: there is not enough memory\n";
    } catch (const std::exception& error) {
        std::cerr << "kith: " << error.what() << '\n';
    }
    return bad_input;
}

} // namespace

} // namespace kith::tool

int main(int count, char** arguments)
{
    kith::io::remove_unfinished_when_interrupted({}, kith::tool::erase_progress);
    // A write that fails is then reported like any other, and what was begun is removed.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // A refined mesh may go to standard output, and as fast as it can.
    const bool may_write_mesh = count > 1 and (std::string_view(arguments[1]) == "refine" or
                                               std::string_view(arguments[1]) == "tessellate");
    const kith::tool::printable_output printable(not may_write_mesh);
    return kith::tool::run_and_report({arguments + 1, arguments + count});
}
