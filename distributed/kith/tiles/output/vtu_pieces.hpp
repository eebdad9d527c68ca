// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stitch.hpp"
#include "vtu_layout.hpp"

#include <kith/tiles/part/checksum.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace kith {

/// A file per tile (.vtu) and an index of them (.pvtu), for readers that need each part by itself. A piece has the
/// faces that the tile owns and their vertices, without ghosts. Vertices between tiles are in several pieces, with
/// their global number (GlobalPointIds, GlobalCellIds). Cell data are those of vtu_file.
class vtu_pieces : public stitched_file {
public:
    /// Lays out the index. Pieces are written to `directory`, which exists; the index refers to them in `source`,
    /// relative to itself. Errors: as vtu_file.
    vtu_pieces(std::string directory, const std::string& source, std::uint64_t tiles, int level, bool with_origin,
               bool with_normals = false, std::vector<file_array> arrays = {})
        : directory_(std::move(directory))
        , level_(level)
        , with_origin_(with_origin)
        , with_normals_(with_normals)
        , arrays_(std::move(arrays))
    {
        const auto array = [](const std::string& type, const std::string& name) {
            return "<PDataArray type=\"" + type + "\" Name=\"" + name + "\"/>\n";
        };
        index_ =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n"
            "<PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n</PPoints>\n"
            "<PPointData GlobalIds=\"GlobalPointIds\"" +
            std::string(with_normals ? " Normals=\"Normals\"" : "") + ">\n" + array("Int64", "GlobalPointIds") +
            (with_normals ? "<PDataArray " + std::string(detail::vtu_normals) + "/>\n" : "") +
            arrays_.declarations(field_on::vertices) + "</PPointData>\n<PCellData GlobalIds=\"GlobalCellIds\">\n" +
            array("Int64", "GlobalCellIds") + array("Int64", "parent") + array("UInt8", "level");
        if (with_origin)
            index_ += array("UInt32", "tile") + array("UInt32", "rank");
        index_ += arrays_.declarations(field_on::faces) + "</PCellData>\n";
        for (std::uint64_t tile = 0; tile < tiles; ++tile)
            index_ += "<Piece Source=\"" + detail::xml_text(source + "/" + name(tile)) + "\"/>\n";
        index_ += "</PUnstructuredGrid>\n</VTKFile>\n";
        size_ = index_.size();
    }

    /// Writes the index.
    void write_frame(placed_bytes& file) const override { file.write(0, index_.data(), index_.size()); }
    /// Writes the piece of a tile to a file of its own, which is on the disk when this returns.
    void write_tile(placed_bytes&, const tile<std::array<double, 3>>& part, cell_origin origin,
                    std::span<const value_bytes> values = {}) const override
    {
        detail::require_finite(part);
        require_values(part, arrays_.list(), values);
        const piece out(part, with_origin_, with_normals_, arrays_);
        auto file = offset_file::create(path(origin.tile), out.layout.size());
        put_piece(file, part, out, origin.tile, with_origin_ ? std::optional(origin.rank) : std::nullopt);
        put_values(file, out, values);
        file.flush();
        file.close();
    }
    [[nodiscard]] std::optional<std::string> difference(offset_file&, const tile<std::array<double, 3>>& part,
                                                        std::uint32_t tile,
                                                        std::span<const value_bytes> values = {}) const override
    {
        require_values(part, arrays_.list(), values);
        const piece expected(part, with_origin_, with_normals_, arrays_);
        auto file = offset_file::open(path(tile)); // throws if the piece does not exist
        std::error_code error;
        if (std::filesystem::file_size(path(tile), error) != expected.layout.size() or error)
            return "the size of " + path(tile);
        compared_bytes compared(file);
        put_piece(compared, part, expected, tile, std::nullopt);
        put_values(compared, expected, values);
        return detail::named_difference(file, compared);
    }
    [[nodiscard]] bool is_there(std::uint64_t tile) const override { return std::filesystem::exists(path(tile)); }
    /// Returns the sum of the piece of a tile, or that of no bytes if the piece does not exist. Errors: write_error.
    [[nodiscard]] byte_sum sum_of_own_file(std::uint64_t tile) const override
    {
        std::error_code error;
        const std::uint64_t size = std::filesystem::file_size(path(tile), error);
        if (error)
            return {};
        auto file = offset_file::open(path(tile));
        detail::word_hash hash(tile); // so that exchanged pieces are noticed
        hash.add(size);
        hash.add(sum_of_bytes(file, 0, size).bits);
        return {hash.bits()};
    }

private:
    static constexpr std::size_t none = SIZE_MAX;

    /// The contents of a piece and their layout.
    struct piece {
        std::vector<std::size_t> faces, vertices, number; ///< of the tile; the numbers of its vertices in the piece
        vtu_layout layout;
        std::size_t points, connectivity, offsets, types, point_ids, cell_ids, parents, levels, normals = 0, tiles = 0,
                                                                                                ranks = 0;
        std::vector<std::size_t> values; ///< numbers of the arrays of fields

        piece(const tile<std::array<double, 3>>& part, bool with_origin, bool with_normals,
              const detail::vtu_arrays& arrays)
            : number(part.mesh.vertex_count(), none)
        {
            std::uint64_t corners = 0;
            for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
                if (part.owns_face(f)) {
                    faces.push_back(f);
                    corners += part.mesh.face(f).size();
                    for (const auto v : part.mesh.face(f))
                        number[v] = 0;
                }
            for (std::size_t v = 0; v < number.size(); ++v)
                if (number[v] != none) {
                    number[v] = vertices.size();
                    vertices.push_back(v);
                }
            layout.open("Points");
            points = layout.add(vertices.size() * 24, "type=\"Float64\" NumberOfComponents=\"3\"");
            layout.close("Points").open("Cells");
            connectivity = layout.add(corners * 8, "type=\"Int64\" Name=\"connectivity\"");
            offsets = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"offsets\"");
            types = layout.add(faces.size(), "type=\"UInt8\" Name=\"types\"");
            layout.close("Cells").open("PointData GlobalIds=\"GlobalPointIds\"" +
                                       std::string(with_normals ? " Normals=\"Normals\"" : ""));
            point_ids = layout.add(vertices.size() * 8, "type=\"Int64\" Name=\"GlobalPointIds\"");
            if (with_normals)
                normals = layout.add(vertices.size() * 24, detail::vtu_normals);
            arrays.add_to(layout, field_on::vertices, vertices.size(), values);
            layout.close("PointData").open("CellData GlobalIds=\"GlobalCellIds\"");
            cell_ids = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"GlobalCellIds\"");
            parents = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"parent\"");
            levels = layout.add(faces.size(), "type=\"UInt8\" Name=\"level\"");
            if (with_origin) {
                tiles = layout.add(faces.size() * 4, "type=\"UInt32\" Name=\"tile\"");
                ranks = layout.add(faces.size() * 4, "type=\"UInt32\" Name=\"rank\"");
            }
            arrays.add_to(layout, field_on::faces, faces.size(), values);
            layout.close("CellData").finish(vertices.size(), faces.size());
        }
    };

    void put_piece(placed_bytes& file, const tile<std::array<double, 3>>& part, const piece& p, std::uint32_t number,
                   std::optional<std::uint32_t> rank) const
    {
        p.layout.write_frame(file);
        const auto write = [&](std::size_t array, const std::vector<std::size_t>& elements, const auto& value) {
            joined_writes out(file);
            out.put_each(p.layout.offset(array), elements.size(), [&](std::size_t i) { return value(elements[i]); });
            out.flush();
        };
        write(p.points, p.vertices, [&](std::size_t v) { return part.mesh.point(v); });
        write(p.point_ids, p.vertices, [&](std::size_t v) { return std::int64_t(part.vertex_ids[v]); });
        if (with_normals_)
            write(p.normals, p.vertices, [&](std::size_t v) { return part.normals[v]; });
        joined_writes out(file);
        std::uint64_t at = p.layout.offset(p.connectivity);
        for (const std::size_t f : p.faces)
            for (const auto v : part.mesh.face(f)) {
                out.put(at, std::int64_t(p.number[v]));
                at += 8;
            }
        out.flush();
        std::int64_t corner = 0;
        write(p.offsets, p.faces, [&](std::size_t f) { return corner += std::int64_t(part.mesh.face(f).size()); });
        write(p.types, p.faces, [&](std::size_t f) { return vtk_cell_type(part.mesh.face(f).size()); });
        write(p.cell_ids, p.faces, [&](std::size_t f) { return std::int64_t(part.face_ids[f]); });
        write(p.parents, p.faces, [&](std::size_t f) { return std::int64_t(part.root(f)); });
        write(p.levels, p.faces, [&](std::size_t) { return std::uint8_t(level_); });
        if (with_origin_)
            write(p.tiles, p.faces, [&](std::size_t) { return number; });
        if (rank)
            write(p.ranks, p.faces, [&](std::size_t) { return *rank; });
    }
    void put_values(placed_bytes& file, const piece& p, std::span<const value_bytes> values) const
    {
        joined_writes out(file);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t bytes = arrays_.list()[i].bytes;
            std::uint64_t at = p.layout.offset(p.values[i]);
            for (const std::size_t x : arrays_.list()[i].on == field_on::vertices ? p.vertices : p.faces) {
                out.put(at, values[i].data() + bytes * x, bytes);
                at += bytes;
            }
            out.flush();
        }
    }
    [[nodiscard]] std::string path(std::uint64_t tile) const { return directory_ + "/" + name(tile); }
    static std::string name(std::uint64_t tile) { return std::to_string(tile) + ".vtu"; }

    std::string directory_, index_;
    int level_;
    bool with_origin_, with_normals_;
    detail::vtu_arrays arrays_;
};

} // namespace kith
