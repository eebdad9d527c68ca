// SPDX-License-Identifier: BSD-3-Clause
#include "refine_tiles.hpp"

#include "errors.hpp"
#include "journal.hpp"
#include "tile_output.hpp"

#include <kith/refine_in_tiles.hpp>

#include <charconv>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include <unistd.h>

namespace kith::tool {

namespace {

template <class Scheme>
tiled_result refine_by(const Scheme& scheme, const tile_request& request, const recipe& kept,
                       const std::string& journal, const tile_range& range)
{
    tiled_refinement refinement(request.control, scheme, request.levels, kept.parts);
    tiled_result result{refinement.whole().counts(request.levels), refinement.tiles(), 0, {}};
    tile_output file(request.output,
                     result.counts,
                     result.tiles,
                     request.levels,
                     request.with_origin,
                     place_of(journal, kept),
                     std::uint64_t(getpid()));
    begin_journal(journal, kept, request.output);
    try {
        file.begin();
        const auto finished = file.finished();
        std::uint64_t faces = 0;
        for (std::size_t t = 0; t < refinement.tiles(); ++t) {
            const bool is_finished = not finished.empty() and finished[t];
            if (not is_finished and (t < range.first or t > range.last))
                continue;
            const finished_tile tile = is_finished ? *finished[t]
                                                   : file.write(refinement.refine(t), {std::uint32_t(t), 0});
            result.checksum += tile.checksum;
            faces += tile.faces;
            ++result.finished_tiles;
        }
        file.close();
        if (result.finished_tiles == result.tiles) {
            if (faces != result.counts.faces)
                throw std::logic_error("the tiles have " + std::to_string(faces) + " faces, not " +
                                       std::to_string(result.counts.faces) + "; this is an error in kith");
            file.commit();
        }
    } catch (...) {
        file.abandon();
        throw;
    }
    return result;
}

} // namespace

tile_range tile_range_from(const std::string& text)
{
    tile_range range;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, range.first);
    range.last = range.first;
    if (read.ec == std::errc() and std::string_view(read.ptr, end).starts_with(".."))
        read = std::from_chars(read.ptr + 2, end, range.last);
    if (read.ec != std::errc() or read.ptr != end or range.last < range.first)
        throw usage_error("--only: '" + text + "' are no tiles such as 100..199 or 7");
    return range;
}

void require_reach(const tile_request& request)
{
    const auto check = []<class Scheme>(const Scheme&) {
        if constexpr (not reaching_scheme<Scheme>)
            throw usage_error("--tiles: " + std::string(scheme_name<Scheme>()) + " has no reach; refine without tiles");
    };
    std::visit(check, request.scheme);
}

tiled_result refine_tiles(const tile_request& request, const std::string& journal,
                          const std::optional<tile_range>& only, const std::function<partition()>& make_parts)
{
    require_reach(request);
    const recipe kept = journal.empty() ? recipe{.parts = make_parts()} : recipe_for(journal, request, make_parts);
    const tile_range range = only.value_or(tile_range{0, kept.parts.parts - 1});
    if (range.last >= kept.parts.parts)
        throw usage_error("--only: there is no tile " + std::to_string(range.last) + ", there are " +
                          std::to_string(kept.parts.parts) + ", numbered from 0");
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) -> tiled_result {
            if constexpr (reaching_scheme<Scheme>)
                return refine_by(scheme, request, kept, journal, range);
            else
                return {};
        },
        request.scheme);
}

} // namespace kith::tool
