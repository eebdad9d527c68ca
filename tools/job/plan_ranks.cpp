// SPDX-License-Identifier: BSD-3-Clause
#include "plan_ranks.hpp"

#include "job_memory.hpp"
#include "tile_attributes.hpp"
#include "cli/errors.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/plan.hpp>
#include <kith/tiles/part/reach.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <algorithm>
#include <string>
#include <variant>

namespace kith::tool {

namespace {

/// Returns the bytes of a tile after its last step: points, face lists, and the global numbers of vertices and faces.
double bytes_of_tile(double vertices, double faces, double corners)
{
    constexpr double vertex = 24 + 8 + 1, face = 8 + 4 + 1, corner = 4;
    return vertex * vertices + face * faces + corner * corners;
}

/// Returns the bytes of a part of the output: coordinates, normals if there are any, faces, and their cell data; see
/// vtu_file.
double bytes_of_output(double vertices, double faces, double corners, bool with_normals)
{
    const double vertex = with_normals ? 24 + 24 : 24;
    constexpr double face = 8 + 1 + 8 + 1, corner = 8;
    return vertex * vertices + face * faces + corner * corners;
}

/// Returns the bytes of the attributes of an element in a file.
double bytes_in_file(const std::vector<io::attribute>& attributes)
{
    double result = 0;
    for (const io::attribute& a : attributes)
        result += double(a.type.bytes);
    return result;
}

template <class Scheme>
planned_ranks plan_by(const Scheme& scheme, const tile_request& request, const partition& parts, std::uint64_t ranks)
{
    const auto& control = request.control;
    const int levels = request.levels;
    const auto last = plan(count(control.topology()), scheme, levels, control.generation(), 24, 8).back().counts;
    const int rings = ring_schedule(scheme, levels, last_rings(request).value_or(0))[0];
    planned_ranks result{rings,
                         tiled_job_bytes(request.scheme, control, levels, parts, tiling_of(request)),
                         std::vector<planned_rank>(ranks)};
    const double of_vertex = bytes_in_file(request.kinds.vertices), of_face = bytes_in_file(request.kinds.faces);
    tile_cutter cutter(control, scheme, parts.part_of, parts.parts);
    for (std::size_t t = 0; t < parts.parts; ++t) {
        const auto job = cutter.cut(t, rings);
        double corners = 0;
        for (const auto f : cutter.faces(t))
            corners += double(control.face(f).size());
        const double share = corners / double(control.corner_count());
        const double vertices_here = share * double(last.vertices), faces_here = share * double(last.faces);
        const double corners_here = share * double(last.corners());
        planned_rank& rank = result.ranks[t % ranks];
        ++rank.tiles;
        rank.faces += cutter.faces(t).size();
        rank.ghosts += job.part.mesh.face_count() - cutter.faces(t).size();
        rank.message_bytes += pack(job).size();
        rank.last_faces += std::uint64_t(faces_here + 0.5);
        rank.tile_bytes = std::max(rank.tile_bytes,
                                   std::uint64_t(bytes_of_tile(vertices_here, faces_here, corners_here)));
        rank.output_bytes += std::uint64_t(bytes_of_output(vertices_here, faces_here, corners_here, request.limit) +
                                           of_vertex * vertices_here + of_face * faces_here);
    }
    return result;
}

} // namespace

planned_ranks plan_ranks(const tile_request& request, const partition& parts, std::uint64_t ranks)
{
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) -> planned_ranks {
            if constexpr (reaching_scheme<Scheme>)
                return plan_by(with_fields(scheme, request.attributes), request, parts, ranks);
            else
                throw usage_error("--ranks: " + not_in_tiles(scheme_name<Scheme>(), needs_closed<Scheme>) +
                                  "; plan without ranks");
        },
        request.scheme);
}

} // namespace kith::tool
