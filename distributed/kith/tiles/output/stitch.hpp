// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "offset_file.hpp"
#include "vtu_arrays.hpp"
#include "vtu_layout.hpp"

#include <kith/core/base/error.hpp>
#include <kith/tiles/number/global_numbering.hpp>
#include <kith/tiles/part/tile.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// The tile and the rank that made a cell.
struct cell_origin {
    std::uint32_t tile = 0;
    std::uint32_t rank = 0;
};

/// A file of the whole refined mesh, stitched by association: the global number of a vertex or face gives its place in
/// the file. So tiles write their owned elements in any order, at the same time, on any rank, and no vertex is written
/// twice. The bytes do not depend on the tiles.
class stitched_file {
public:
    virtual ~stitched_file() = default;
    [[nodiscard]] std::uint64_t size() const { return size_; }

    /// Writes the bytes that belong to no tile; one process calls this.
    virtual void write_frame(placed_bytes& file) const = 0;
    /// Writes the vertices and faces that a tile owns, with values for the arrays of the file, in their order. Local.
    /// Errors: write_error; mesh_error for a vertex without finite coordinates, and unless each element has a value.
    /// Cost: O(corners), and a write for each run of consecutive numbers.
    virtual void write_tile(placed_bytes& file, const tile<std::array<double, 3>>& part, cell_origin origin,
                            std::span<const value_bytes> values = {}) const = 0;

    /// Compares the file with what write_tile writes for this tile, on any rank, and names a byte that differs: "byte
    /// 302 of out.vtu". Local. Errors: write_error. Cost: as write_tile.
    [[nodiscard]] virtual std::optional<std::string> difference(offset_file& file,
                                                                const tile<std::array<double, 3>>& part,
                                                                std::uint32_t tile,
                                                                std::span<const value_bytes> values = {}) const = 0;

    /// Returns true if the bytes of a tile that lie outside this file have been written. Local.
    [[nodiscard]] virtual bool is_there(std::uint64_t) const { return true; }
    /// Returns a sum of the bytes of a tile that lie outside this file, as they are on the disk now. Local.
    [[nodiscard]] virtual byte_sum sum_of_own_file(std::uint64_t) const { return {}; }

protected:
    std::uint64_t size_ = 0;
};

namespace detail {

/// Throws mesh_error, which names the vertex, if coordinates have overflowed; they are never written.
inline void require_finite(const tile<std::array<double, 3>>& part)
{
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
        if (not std::ranges::all_of(part.mesh.point(v), [](double x) { return std::isfinite(x); }))
            throw mesh_error("vertex " + std::to_string(part.vertex_ids[v]) +
                             " would not have finite coordinates; the coordinates of the input are too large");
}

inline constexpr const char* vtu_normals = "type=\"Float64\" Name=\"Normals\" NumberOfComponents=\"3\"";

inline std::optional<std::string> named_difference(const offset_file& file, const compared_bytes& compared)
{
    if (const auto at = compared.difference())
        return "byte " + std::to_string(*at) + " of " + file.path();
    return std::nullopt;
}

} // namespace detail

/// The common degree of all cells of a file, and the number of tiles that write it. Some arrays then follow from the
/// numbers of cells alone. Each tile writes an equal share of these arrays, since the runs of its own numbers are
/// short.
struct alike_cells {
    std::uint64_t degree, tiles;
};

/// A VTK unstructured grid, raw binary appended, which ParaView opens. Cell data are the parent face on level 0 and the
/// level. Tile and rank, which depend on how the work was shared, are written only on request.
class vtu_file : public stitched_file {
public:
    /// Lays out the file. With normals, which are point data, the tiles must have them. Values of fields are point or
    /// cell data, see arrays_of. With `alike`, tiles are numbered from 0 on, and the file is complete when all tiles
    /// have been written. Errors: mesh_error for a field whose name is taken, and for one on edges or corners.
    vtu_file(const global_counts& counts, int level, bool with_origin, bool with_normals = false,
             std::vector<file_array> arrays = {}, std::optional<alike_cells> alike = std::nullopt)
        : cells_(counts.faces)
        , alike_(alike)
        , level_(level)
        , with_origin_(with_origin)
        , with_normals_(with_normals)
        , arrays_(std::move(arrays))
    {
        KITH_ASSERT(not alike or counts.corners == alike->degree * counts.faces);
        layout_.open("Points");
        points_ = layout_.add(counts.vertices * 24, "type=\"Float64\" NumberOfComponents=\"3\"");
        layout_.close("Points").open("Cells");
        connectivity_ = layout_.add(counts.corners * 8, "type=\"Int64\" Name=\"connectivity\"");
        offsets_ = layout_.add(counts.faces * 8, "type=\"Int64\" Name=\"offsets\"");
        types_ = layout_.add(counts.faces, "type=\"UInt8\" Name=\"types\"");
        layout_.close("Cells");
        if (with_normals or arrays_.any_on(field_on::vertices)) {
            layout_.open(with_normals ? "PointData Normals=\"Normals\"" : "PointData");
            if (with_normals)
                normals_ = layout_.add(counts.vertices * 24, detail::vtu_normals);
            arrays_.add_to(layout_, field_on::vertices, counts.vertices, values_);
            layout_.close("PointData");
        }
        layout_.open("CellData");
        parents_ = layout_.add(counts.faces * 8, "type=\"Int64\" Name=\"parent\"");
        levels_ = layout_.add(counts.faces, "type=\"UInt8\" Name=\"level\"");
        if (with_origin) {
            tiles_ = layout_.add(counts.faces * 4, "type=\"UInt32\" Name=\"tile\"");
            ranks_ = layout_.add(counts.faces * 4, "type=\"UInt32\" Name=\"rank\"");
        }
        arrays_.add_to(layout_, field_on::faces, counts.faces, values_);
        layout_.close("CellData").finish(counts.vertices, counts.faces);
        size_ = layout_.size();
    }

    void write_frame(placed_bytes& file) const override { layout_.write_frame(file); }
    void write_tile(placed_bytes& file, const tile<std::array<double, 3>>& part, cell_origin origin,
                    std::span<const value_bytes> values = {}) const override
    {
        detail::require_finite(part);
        require_values(part, arrays_.list(), values);
        put_tile(file, part, origin.tile, with_origin_ ? std::optional(origin.rank) : std::nullopt);
        put_values(file, part, values);
    }
    [[nodiscard]] std::optional<std::string> difference(offset_file& file, const tile<std::array<double, 3>>& part,
                                                        std::uint32_t tile,
                                                        std::span<const value_bytes> values = {}) const override
    {
        require_values(part, arrays_.list(), values);
        compared_bytes compared(file);
        put_tile(compared, part, tile, std::nullopt);
        put_values(compared, part, values);
        return detail::named_difference(file, compared);
    }

private:
    void put_tile(placed_bytes& file, const tile<std::array<double, 3>>& part, std::uint32_t number,
                  std::optional<std::uint32_t> rank) const
    {
        joined_writes out(file);
        const auto put_vertices = [&](std::size_t array, const auto& values) {
            for_each_owned_run(
                part.vertex_ids, part.vertex_marks, [&](std::size_t first, global_id id, std::size_t run) {
                    out.put(layout_.offset(array) + 24 * id, values.data() + first, 24 * run);
                });
            out.flush();
        };
        put_vertices(points_, part.mesh.points());
        if (with_normals_)
            put_vertices(normals_, part.normals);
        const auto& t = part.mesh.topology();
        for_each_owned_run(part.face_ids, part.face_marks, [&](std::size_t first, global_id, std::size_t run) {
            const std::size_t corner = t.first_corner(first);
            out.put_each(layout_.offset(connectivity_) + 8 * part.corner_id(first, 0),
                         t.first_corner(first + run) - corner,
                         [&](std::size_t i) { return std::int64_t(part.vertex_ids[t.corner_vertex[corner + i]]); });
        });
        out.flush();
        const auto put_faces = [&](std::size_t array, const auto& value) {
            using type = std::invoke_result_t<decltype(value), std::size_t>;
            for_each_owned_run(part.face_ids, part.face_marks, [&](std::size_t first, global_id id, std::size_t run) {
                out.put_each(
                    layout_.offset(array) + sizeof(type) * id, run, [&](std::size_t i) { return value(first + i); });
            });
            out.flush();
        };
        put_faces(parents_, [&](std::size_t f) { return std::int64_t(part.root(f)); });
        if (alike_) {
            put_share(
                out, number, offsets_, [&](std::uint64_t cell) { return std::int64_t(alike_->degree * (cell + 1)); });
            put_share(out, number, types_, [&](std::uint64_t) { return vtk_cell_type(alike_->degree); });
            put_share(out, number, levels_, [&](std::uint64_t) { return std::uint8_t(level_); });
        } else {
            const auto degree = [&](std::size_t f) { return std::size_t(t.first_corner(f + 1) - t.first_corner(f)); };
            put_faces(offsets_, [&](std::size_t f) { return std::int64_t(part.corner_id(f, degree(f))); });
            put_faces(types_, [&](std::size_t f) { return vtk_cell_type(degree(f)); });
            put_faces(levels_, [&](std::size_t) { return std::uint8_t(level_); });
        }
        if (with_origin_)
            put_faces(tiles_, [&](std::size_t) { return number; });
        if (rank)
            put_faces(ranks_, [&](std::size_t) { return *rank; });
    }
    /// Writes the tile's share of an array of all cells: value(cell).
    template <class F>
    void put_share(joined_writes& out, std::uint64_t tile, std::size_t array, const F& value) const
    {
        using type = std::invoke_result_t<const F&, std::uint64_t>;
        const std::uint64_t begin = begin_of_share(cells_, tile, alike_->tiles),
                            end = begin_of_share(cells_, tile + 1, alike_->tiles);
        out.put_each(layout_.offset(array) + sizeof(type) * begin, std::size_t(end - begin), [&](std::size_t i) {
            return value(begin + i);
        });
        out.flush();
    }
    void put_values(placed_bytes& file, const tile<std::array<double, 3>>& part,
                    std::span<const value_bytes> values) const
    {
        joined_writes out(file);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto& array = arrays_.list()[i];
            detail::for_each_owned_value(part, array, values[i], [&](global_id id, const std::byte* value) {
                out.put(layout_.offset(values_[i]) + array.bytes * id, value, array.bytes);
            });
            out.flush();
        }
    }

    std::uint64_t cells_;
    std::optional<alike_cells> alike_;
    int level_;
    bool with_origin_, with_normals_;
    detail::vtu_arrays arrays_;
    std::vector<std::size_t> values_; // numbers of the arrays of fields in layout_
    vtu_layout layout_;
    std::size_t points_, connectivity_, offsets_, types_, parents_, levels_; // numbers of the arrays in layout_
    std::size_t normals_ = 0, tiles_ = 0, ranks_ = 0;
};

} // namespace kith
