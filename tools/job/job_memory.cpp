// SPDX-License-Identifier: BSD-3-Clause
#include "job_memory.hpp"

#include "available_memory.hpp"
#include "limit_surface.hpp"
#include "cli/command_line.hpp"
#include "cli/errors.hpp"
#include "cli/partition_options.hpp"
#include "cli/word_list.hpp"

#include <kith/engine/refine_in_surface_order.hpp>
#include <kith/tiles/number/column_facts.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>
#include <kith/tiles/refine/plan_tile.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>
#include <variant>

namespace kith::tool {

namespace {

/// The names of the mesh kinds, in the order of mesh_kind.
constexpr std::array<std::string_view, 3> names_of_kinds{"native", "cgal", "openmesh"};

double bytes_of(double vertices, double edges, double faces, const planned_level& level)
{
    const counts& c = level.counts;
    return vertices * double(c.vertices) + edges * double(c.edges) + faces * double(c.faces);
}

/// Returns the bytes of a level on the kind of mesh on which the job refines.
double bytes_on_mesh(const planned_level& level, mesh_kind mesh)
{
    switch (mesh) {
    case mesh_kind::native: break;
    case mesh_kind::cgal:
        return bytes_of(28.125, 32.125, 4.125, level);           // points, half-edges of 16 bytes, bits for removed
    case mesh_kind::openmesh: return bytes_of(29, 35, 5, level); // and a byte of properties for each element
    }
    return double(level.bytes);
}

/// Bytes of a vertex while its limit is evaluated: the limit position, a mark, the normal with the number of its
/// vertex, and the normal in order. An exponent and a length are needed while the normals are made.
constexpr double bytes_of_limit = 24 + 1 + 32 + 24 + 4 + 8;

/// Bytes of a corner: its normal, its numbers for the writer, and the line that it refers to.
constexpr double bytes_of_corner_normal = 24 + 24 + 12;

/// Bytes that a job on a mesh of another library takes, whatever its size: pages of code that only this job runs, and
/// blocks that the allocator of the other library begins.
constexpr double bytes_of_other_library = 2 << 20;

/// Returns the bytes of the corners, half-edges and starts of fans that are listed if a scheme runs on a mesh of
/// another library.
double bytes_of_view(const planned_level& level)
{
    return bytes_of(4, 8, 0, level) + 4 * double(level.counts.corners());
}

/// Returns the bytes of a refinement on meshes of another library that keeps each level and converts the last one to a
/// native mesh.
double bytes_of_hierarchy(const std::vector<planned_level>& levels, const job_kind& kind)
{
    double kept = bytes_of_other_library;
    for (const planned_level& level : levels)
        kept += bytes_on_mesh(level, kind.mesh) + bytes_of_view(level);
    const planned_level& last = levels.back();
    if (not kind.limit)
        return kept - bytes_of_view(last) + 2 * double(last.bytes);
    return kept + double(last.bytes) + std::max(double(last.bytes), bytes_of(bytes_of_limit, 0, 0, last));
}

/// Returns the bytes of a refinement of native meshes. It keeps two levels at once, and the last one has its edges if
/// limits or tags need them.
double bytes_of_two_levels(const std::vector<planned_level>& levels, const job_kind& kind)
{
    const bool has_edges = kind.limit or kind.tags;
    const double most = double(levels.front().bytes) + double(peak_bytes(levels, false, not has_edges));
    return kind.limit ? std::max(most, double(levels.back().bytes) + bytes_of(bytes_of_limit, 0, 0, levels.back()))
                      : most;
}

/// Returns the plan with the bytes of a 32-bit index, even if 32 bits cannot number all elements.
std::vector<planned_level> with_short_index(std::vector<planned_level> levels)
{
    for (planned_level& level : levels) {
        const std::uint64_t points = 24 * level.counts.vertices;
        level.bytes = points + (level.bytes - points) / 2;
        level.least_bytes = points + (level.least_bytes - points) / 2;
    }
    return levels;
}

template <class Scheme>
std::vector<planned_level> plan_of_tiles(const Scheme& scheme, const basic_mesh<>& control, int levels)
{
    return with_short_index(plan(count(control.topology()), scheme, levels, control.generation(), 24, 8));
}

/// Returns the bytes of the control mesh, twice since it is cut, and of its attributes, which are passed on with the
/// scheme. If the numbers depend on the boundary of the last level but one, its bytes are included.
template <class Scheme>
double bytes_beside_tiles(const std::vector<planned_level>& levels, const attribute_counts& attributes)
{
    double result = 2 * double(levels[0].bytes) + 4 * field_bytes(attributes).of(levels[0].counts, 1) +
                    8 * double(attributes.faces) * double(levels[0].counts.faces);
    if constexpr (numbers_boundary<Scheme>)
        result += 300 * double(levels[levels.size() < 2 ? 0 : levels.size() - 2].counts.boundary_edges);
    return result;
}

/// Returns the bytes that a tile with `faces` faces and a share of the corners needs at most.
template <class Scheme>
double bytes_of_tile(const Scheme& scheme, const std::vector<planned_level>& levels, double share, double faces,
                     const tiling_kind& kind)
{
    const double all = double(levels[0].counts.faces);
    const auto last_rings = rings_of_last_level(scheme, kind.limit, kind.attributes.any());
    const int rings = ring_schedule(scheme, int(levels.size()) - 1, last_rings.value_or(0))[0];
    const double ghosts = std::min(all - faces, ghosts_around(faces, rings)) / all;
    element_bytes last = written_bytes(kind.attributes);
    last.vertex += kind.limit ? bytes_of_limit : 0;
    last.corner += kind.corner_normals ? bytes_of_corner_normal : 0;
    return double(tile_bytes(levels, scheme, share, ghosts, last_rings, last, field_bytes(kind.attributes)));
}

template <class Scheme>
double bytes_of_tiles(const Scheme& scheme, const std::vector<planned_level>& levels, double share, double faces,
                      std::uint64_t at_once, const tiling_kind& kind)
{
    return bytes_beside_tiles<Scheme>(levels, kind.attributes) +
           double(at_once) * bytes_of_tile(scheme, levels, share, faces, kind);
}

/// Returns the approximate number of faces of the largest of so many tiles; parts differ in size.
double faces_of_largest(std::uint64_t faces, std::uint64_t tiles)
{
    return std::min(double(faces), std::ceil(1.1 * double(faces) / double(tiles)));
}
/// Returns a slightly larger number of tiles, the next one that a search tries.
std::uint64_t more_tiles(std::uint64_t tiles, std::uint64_t most)
{
    return std::min(most, tiles + 1 + tiles / 8);
}

/// Returns the number of tiles that are refined at once, as tiles_at_once does. Each rank has only a part of the tiles,
/// so the number there may be smaller.
std::uint64_t at_once(std::uint64_t tiles, std::uint64_t threads)
{
    return tiles < threads ? 1 : threads;
}

/// Returns the bytes of a job, computed with the tile that has the most corners, since new faces come from corners.
template <class Scheme>
double bytes_of_tiles(const Scheme& scheme, const std::vector<planned_level>& levels, const basic_mesh<>& control,
                      const partition& parts, const tiling_kind& kind)
{
    struct size {
        std::uint64_t corners = 0, faces = 0;
    };
    std::vector<size> sizes(parts.parts);
    for (std::size_t f = 0; f < control.face_count() and f < parts.part_of.size(); ++f) {
        sizes[parts.part_of[f]].corners += control.face(f).size();
        ++sizes[parts.part_of[f]].faces;
    }
    const size largest = *std::ranges::max_element(sizes, {}, &size::corners);
    const double share = double(largest.corners) / double(control.corner_count());
    return bytes_of_tiles(scheme, levels, share, double(largest.faces), at_once(parts.parts, kind.threads), kind);
}

/// Calls f with a scheme that can be refined in tiles. For other schemes the result is an empty value of the return
/// type of f.
template <class F>
auto with_reaching(const any_scheme& scheme, const F& f)
{
    return std::visit(
        [&]<class Scheme>(const Scheme& s) {
            if constexpr (reaching_scheme<Scheme>)
                return f(s);
            else
                return decltype(f(catmull_clark()))();
        },
        scheme);
}

std::uint64_t whole_number(double bytes)
{
    return std::uint64_t(std::min(bytes, 1e19));
}

/// Returns a number of bytes as text: "1024", "2147483648 (2.0 GiB)".
std::string bytes_text(std::uint64_t bytes)
{
    constexpr std::array units{"MiB", "GiB", "TiB", "PiB", "EiB"};
    std::string result = std::to_string(bytes);
    double value = double(bytes) / (1 << 20);
    if (value < 1)
        return result;
    std::size_t unit = 0;
    for (; value >= 1024; ++unit)
        value /= 1024;
    char text[32];
    (void)std::snprintf(text, sizeof text, " (%.1f ", value);
    return result + text + units[unit] + ")";
}

std::string name_of(const any_scheme& scheme)
{
    return std::visit([]<class Scheme>(const Scheme&) { return std::string(scheme_name<Scheme>()); }, scheme);
}

std::string too_much(const std::string& what, std::uint64_t bytes, const memory_limit& limit)
{
    return what + bytes_text(bytes) + " bytes at once, the limit is " + bytes_text(limit.bytes) +
           (limit.was_given ? "" : ", 9/10 of the available memory");
}

} // namespace

std::string mesh_kind_names()
{
    std::string result;
    for (const auto name : names_of_kinds)
        append_to_list(result, name);
    return result;
}

mesh_kind mesh_kind_from(const boost::program_options::variables_map& values)
{
    if (values.count("mesh") == 0)
        return mesh_kind::native;
    const std::string given = required(values, "mesh");
    const auto found = std::ranges::find(names_of_kinds, given);
    if (found == names_of_kinds.end())
        throw usage_error("--mesh: '" + given + "' is not one of " + mesh_kind_names());
    return mesh_kind(found - names_of_kinds.begin());
}

memory_limit memory_limit_from(const boost::program_options::variables_map& values)
{
    if (values.count("memory-limit") != 0)
        return {bytes_from(required(values, "memory-limit")), true};
    return {available_memory() / 10 * 9, false};
}

bool is_reordered(const any_scheme& scheme, const basic_mesh<>& control, int levels)
{
    return std::visit(
        [&]<class Scheme>(const Scheme& s) {
            if constexpr (orderable_scheme<Scheme, std::uint32_t>)
                return can_be_ordered(control.topology(), s, levels) and is_scattered(control.topology());
            else
                return false;
        },
        scheme);
}

std::uint64_t job_bytes(const std::vector<planned_level>& levels, const job_kind& kind, bool reordered)
{
    const planned_level &control = levels.front(), &last = levels.back();
    const bool is_native = kind.mesh == mesh_kind::native;
    double most = is_native ? bytes_of_two_levels(levels, kind) : bytes_of_hierarchy(levels, kind);
    double written = double(last.bytes);
    if (is_native and not kind.limit and not kind.tags) {
        written = double(last.least_bytes);
        if (reordered and
            levels.size() >
                1) // the control mesh in another order, and the numbers of all elements before the last step
            most += double(control.bytes) + bytes_of(4, 4, 4, levels[levels.size() - 2]);
    }
    if (kind.limit)
        written += bytes_of(24, 0, 0, last);
    if (kind.corner_normals)
        written += bytes_of_corner_normal * double(last.counts.corners());
    if (kind.holes) { // the holes of two levels; edges, corners and points of what is left
        most += bytes_of(0, 0, 2, last);
        written += bytes_of(52, 0, 4, last) + 16 * double(last.counts.corners());
    }
    const double attributes = bytes_of(kind.attributes, last.counts);
    return whole_number((std::max(most, written + bytes_of(24, 0, 0, last)) + attributes) * 1.05);
}

std::uint64_t tiled_job_bytes(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                              const tiling_kind& kind)
{
    return with_reaching(scheme, [&](const auto& s) {
        return whole_number(bytes_of_tiles(s, plan_of_tiles(s, control, levels), control, parts, kind));
    });
}

std::uint64_t tiles_that_fit(const any_scheme& scheme, const basic_mesh<>& control, int levels,
                             const std::string& partitioner, std::uint64_t limit, const tiling_kind& kind)
{
    const std::uint64_t most = control.face_count();
    return with_reaching(scheme, [&](const auto& s) -> std::uint64_t {
        const auto planned = plan_of_tiles(s, control, levels);
        const auto fits = [&](std::uint64_t tiles) {
            const double faces = faces_of_largest(most, tiles);
            const std::uint64_t together = at_once(tiles, kind.threads);
            return bytes_of_tiles(s, planned, faces / double(most), faces, together, kind) <= double(limit);
        };
        std::uint64_t tiles = 1;
        while (tiles < most and not fits(tiles))
            tiles = more_tiles(tiles, most);
        const std::string by = partitioner == "block" ? partitioner : "metis";
        const auto is_enough = [&] {
            return bytes_of_tiles(s, planned, control, make_partition(by, control, tiles), kind) <= double(limit);
        };
        while (not is_enough()) {
            if (tiles == most)
                return 0;
            tiles = std::min(most, tiles + 1 + tiles / 4);
        }
        return tiles;
    });
}

std::uint64_t usual_tiles(const any_scheme& scheme, const basic_mesh<>& control, int levels, const tiling_kind& kind)
{
    constexpr double usual_bytes = 128 << 20; // the time is about the same from a quarter to four times as much
    const std::uint64_t most = control.face_count();
    std::uint64_t tiles = 1;
    with_reaching(scheme, [&](const auto& s) {
        const auto planned = plan_of_tiles(s, control, levels);
        const auto is_usual = [&] {
            const double faces = faces_of_largest(most, tiles);
            return bytes_of_tile(s, planned, faces / double(most), faces, kind) <= usual_bytes;
        };
        while (tiles < most and not is_usual())
            tiles = more_tiles(tiles, most);
    });
    return tiles;
}

void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const job_kind& kind,
                    const memory_limit& limit)
{
    const partial_plan planned = std::visit(
        [&](const auto& s) { return plan_what_fits(count(control.topology()), s, levels, control.generation()); },
        scheme);
    const std::uint64_t need = job_bytes(planned.levels, kind);
    if (planned.problem.empty() and need <= limit.bytes)
        return;
    const std::string problem = planned.problem.empty()
                                    ? too_much(std::to_string(levels) + " levels need ", need, limit)
                                    : planned.problem;
    std::string in_tiles;
    const bool is_possible = not kind.holes and planned.problem.find("64 bits") == std::string::npos;
    for (const std::uint64_t threads : {std::uint64_t(tiles_at_once(SIZE_MAX)), std::uint64_t(1)}) {
        if (not is_possible or not in_tiles.empty())
            break;
        const auto tiles = tiles_that_fit(scheme,
                                          control,
                                          levels,
                                          "metis",
                                          limit.bytes,
                                          {.threads = threads,
                                           .limit = kind.limit,
                                           .corner_normals = kind.corner_normals,
                                           .attributes = kind.attributes});
        if (tiles != 0)
            in_tiles = ", or refine in tiles and write .vtu, .pvtu or .ply: --tiles " + std::to_string(tiles) +
                       (threads == 1 and tiles_at_once(SIZE_MAX) != 1 ? " --threads 1" : "");
    }
    throw mesh_error(name_of(scheme) + ": " + problem + "; refine fewer times" + in_tiles);
}

void require_memory(const any_scheme& scheme, const basic_mesh<>& control, int levels, const partition& parts,
                    const std::string& partitioner, const memory_limit& limit, const tiling_kind& kind,
                    const std::string& option, std::uint64_t times)
{
    const std::uint64_t need = tiled_job_bytes(scheme, control, levels, parts, kind);
    if (need <= limit.bytes)
        return;
    const std::uint64_t together = at_once(parts.parts, kind.threads);
    const std::uint64_t alone = tiled_job_bytes(
        scheme,
        control,
        levels,
        parts,
        {.limit = kind.limit, .corner_normals = kind.corner_normals, .attributes = kind.attributes});
    std::uint64_t threads = 0;
    if (together != 1 and alone <= limit.bytes)
        threads = 1 + std::uint64_t(double(limit.bytes - alone) / double(need - alone) * double(together - 1));
    const std::uint64_t tiles = tiles_that_fit(scheme, control, levels, partitioner, limit.bytes, kind);
    const std::string what = together == 1 ? "the largest tile needs "
                                           : std::to_string(together) + " tiles, one per thread, need ";
    std::string ways = "refine fewer times";
    if (threads != 0)
        ways += ", or use fewer threads: --threads " + std::to_string(threads);
    if (tiles != 0)
        ways += (tiles < parts.parts ? ", or use fewer tiles, one at a time: " : ", or use more tiles: ") + option +
                " " + std::to_string((tiles + times - 1) / times);
    if (threads == 0 and tiles == 0)
        ways += ", since not even one tile per face of the mesh would fit";
    throw mesh_error(name_of(scheme) + ": " + too_much(what, need, limit) + "; " + ways);
}

} // namespace kith::tool
