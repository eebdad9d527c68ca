// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stitch.hpp"
#include "vtu_layout.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// A file per tile (.vtu) and an index of them (.pvtu), for who wants each part by itself: the faces that the tile owns and
/// their vertices, no ghosts. Vertices between tiles are in several files, with the number in the whole mesh that says so
/// (GlobalPointIds, GlobalCellIds). Cell data as in vtu_file.
class vtu_pieces : public stitched_file {
public:
    /// Pieces are written to `directory`, which exists, and looked for in `source`, as seen from the index.
    vtu_pieces(std::string directory, const std::string& source, std::uint64_t tiles, int level, bool with_origin)
        : directory_(std::move(directory)), level_(level), with_origin_(with_origin)
    {
        const auto array = [](const std::string& type, const std::string& name) {
            return "<PDataArray type=\"" + type + "\" Name=\"" + name + "\"/>\n";
        };
        index_ =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n"
            "<PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n</PPoints>\n"
            "<PPointData GlobalIds=\"GlobalPointIds\">\n" +
            array("Int64", "GlobalPointIds") + "</PPointData>\n<PCellData GlobalIds=\"GlobalCellIds\">\n" +
            array("Int64", "GlobalCellIds") + array("Int64", "parent") + array("UInt8", "level");
        if (with_origin)
            index_ += array("UInt32", "tile") + array("UInt32", "rank");
        index_ += "</PCellData>\n";
        for (std::uint64_t tile = 0; tile < tiles; ++tile)
            index_ += "<Piece Source=\"" + source + "/" + name(tile) + "\"/>\n";
        index_ += "</PUnstructuredGrid>\n</VTKFile>\n";
        size_ = index_.size();
    }

    /// The index.
    void write_frame(offset_file& file) const override { file.write(0, index_.data(), index_.size()); }
    /// The piece, in a file of its own, which is on the disk then.
    void write_tile(offset_file&, const tile<std::array<double, 3>>& part, cell_origin origin) const override
    {
        constexpr std::size_t none = SIZE_MAX;
        std::vector<std::size_t> faces, vertices, number(part.mesh.vertex_count(), none);
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
        vtu_layout layout;
        layout.open("Points");
        const auto points = layout.add(vertices.size() * 24, "type=\"Float64\" NumberOfComponents=\"3\"");
        layout.close("Points").open("Cells");
        const auto connectivity = layout.add(corners * 8, "type=\"Int64\" Name=\"connectivity\"");
        const auto offsets = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"offsets\"");
        const auto types = layout.add(faces.size(), "type=\"UInt8\" Name=\"types\"");
        layout.close("Cells").open("PointData GlobalIds=\"GlobalPointIds\"");
        const auto point_ids = layout.add(vertices.size() * 8, "type=\"Int64\" Name=\"GlobalPointIds\"");
        layout.close("PointData").open("CellData GlobalIds=\"GlobalCellIds\"");
        const auto cell_ids = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"GlobalCellIds\"");
        const auto parents = layout.add(faces.size() * 8, "type=\"Int64\" Name=\"parent\"");
        const auto levels = layout.add(faces.size(), "type=\"UInt8\" Name=\"level\"");
        const std::size_t tiles = with_origin_ ? layout.add(faces.size() * 4, "type=\"UInt32\" Name=\"tile\"") : none;
        const std::size_t ranks = with_origin_ ? layout.add(faces.size() * 4, "type=\"UInt32\" Name=\"rank\"") : none;
        layout.close("CellData").finish(vertices.size(), faces.size());

        auto file = offset_file::create(directory_ + "/" + name(origin.tile), layout.size());
        layout.write_frame(file);
        const auto write = [&](std::size_t array, const std::vector<std::size_t>& elements, const auto& value) {
            joined_writes out(file);
            std::uint64_t at = layout.offset(array);
            for (const std::size_t element : elements) {
                const auto bytes = value(element);
                out.put(at, bytes);
                at += sizeof bytes;
            }
            out.flush();
        };
        write(points, vertices, [&](std::size_t v) { return part.mesh.point(v); });
        write(point_ids, vertices, [&](std::size_t v) { return std::int64_t(part.vertex_ids[v]); });
        joined_writes out(file);
        std::uint64_t at = layout.offset(connectivity);
        for (const std::size_t f : faces)
            for (const auto v : part.mesh.face(f)) {
                out.put(at, std::int64_t(number[v]));
                at += 8;
            }
        out.flush();
        std::int64_t corner = 0;
        write(offsets, faces, [&](std::size_t f) { return corner += std::int64_t(part.mesh.face(f).size()); });
        write(types, faces, [&](std::size_t f) { return vtk_cell_type(part.mesh.face(f).size()); });
        write(cell_ids, faces, [&](std::size_t f) { return std::int64_t(part.face_ids[f]); });
        write(parents, faces, [&](std::size_t f) { return std::int64_t(part.root(f)); });
        write(levels, faces, [&](std::size_t) { return std::uint8_t(level_); });
        if (with_origin_) {
            write(tiles, faces, [&](std::size_t) { return origin.tile; });
            write(ranks, faces, [&](std::size_t) { return origin.rank; });
        }
        file.flush();
        file.close();
    }
    [[nodiscard]] bool is_there(std::uint64_t tile) const override
    {
        return std::filesystem::exists(directory_ + "/" + name(tile));
    }

private:
    static std::string name(std::uint64_t tile) { return std::to_string(tile) + ".vtu"; }

    std::string directory_, index_;
    int level_;
    bool with_origin_;
};

} // namespace kith
