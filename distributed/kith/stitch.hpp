// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "offset_file.hpp"
#include "tile.hpp"
#include "whole_numbering.hpp"

#include <kith/error.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace kith {

/// Where a cell came from, beside its parent face.
struct cell_origin {
    std::uint32_t tile = 0;
    std::uint32_t rank = 0;
};

/// One file of the whole refined mesh, stitched by association: the number of a vertex or a face says where in the file it
/// stands, so tiles write what they own in any order, at the same time, on any rank, and no vertex is there twice. The
/// bytes do not depend on the tiles.
class stitched_file {
public:
    virtual ~stitched_file() = default;
    [[nodiscard]] std::uint64_t size() const { return size_; }

    /// What is not of any tile; one writes it.
    virtual void write_frame(offset_file& file) const = 0;
    /// The vertices and faces that a tile owns. Local. Errors: write_error. Cost: O(corners), and a write for each run of
    /// consecutive numbers.
    virtual void write_tile(offset_file& file, const tile<std::array<double, 3>>& part, cell_origin origin) const = 0;

protected:
    std::uint64_t size_ = 0;
};

/// VTK's unstructured grid, raw binary appended, which ParaView opens. Cell data: the parent face on level 0 and the
/// level; tile and rank, which depend on how the work was shared out, only where asked for.
class vtu_file : public stitched_file {
public:
    vtu_file(const whole_counts& counts, int level, bool with_origin) : level_(level), with_origin_(with_origin)
    {
        static_assert(std::endian::native == std::endian::little, "the file says it is little-endian");
        const std::string cells = std::to_string(counts.faces);
        std::string arrays;
        std::uint64_t offset = 0;
        const auto add = [&](array_place& place, std::uint64_t bytes, const std::string& attributes) {
            place = {offset + sizeof(std::uint64_t), bytes};
            arrays += "<DataArray " + attributes + " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
            offset += sizeof(std::uint64_t) + bytes;
        };
        arrays += "<Points>\n";
        add(points_, counts.vertices * 24, "type=\"Float64\" NumberOfComponents=\"3\"");
        arrays += "</Points>\n<Cells>\n";
        add(connectivity_, counts.corners * 8, "type=\"Int64\" Name=\"connectivity\"");
        add(offsets_, counts.faces * 8, "type=\"Int64\" Name=\"offsets\"");
        add(types_, counts.faces, "type=\"UInt8\" Name=\"types\"");
        arrays += "</Cells>\n<CellData>\n";
        add(parents_, counts.faces * 8, "type=\"Int64\" Name=\"parent\"");
        add(levels_, counts.faces, "type=\"UInt8\" Name=\"level\"");
        if (with_origin) {
            add(tiles_, counts.faces * 4, "type=\"UInt32\" Name=\"tile\"");
            add(ranks_, counts.faces * 4, "type=\"UInt32\" Name=\"rank\"");
        }
        arrays += "</CellData>\n";
        head_ =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
            std::to_string(counts.vertices) + "\" NumberOfCells=\"" + cells + "\">\n" + arrays +
            "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
        tail_ = "\n</AppendedData>\n</VTKFile>\n";
        for (array_place* place : {&points_, &connectivity_, &offsets_, &types_, &parents_, &levels_, &tiles_, &ranks_})
            place->offset += head_.size();
        size_ = head_.size() + offset + tail_.size();
    }

    void write_frame(offset_file& file) const override
    {
        file.write(0, head_.data(), head_.size());
        file.write(size_ - tail_.size(), tail_.data(), tail_.size());
        for (const array_place* place : {&points_, &connectivity_, &offsets_, &types_, &parents_, &levels_})
            file.write(place->offset - sizeof place->bytes, &place->bytes, sizeof place->bytes);
        if (with_origin_)
            for (const array_place* place : {&tiles_, &ranks_})
                file.write(place->offset - sizeof place->bytes, &place->bytes, sizeof place->bytes);
    }
    void write_tile(offset_file& file, const tile<std::array<double, 3>>& part, cell_origin origin) const override
    {
        const auto for_owned_faces = [&](const array_place& place, std::uint64_t bytes, const auto& value) {
            joined_writes out(file);
            for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
                if (part.owns_face(f))
                    out.put(place.offset + bytes * part.face_ids[f], value(f));
            out.flush();
        };
        joined_writes points(file);
        for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
            if (part.owns_vertex(v))
                points.put(points_.offset + 24 * part.vertex_ids[v], part.mesh.point(v));
        points.flush();
        joined_writes corners(file);
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
            if (part.owns_face(f))
                for (std::size_t k = 0; k < part.mesh.face(f).size(); ++k)
                    corners.put(connectivity_.offset + 8 * part.corner_id(f, k),
                                std::int64_t(part.vertex_ids[part.mesh.face(f)[k]]));
        corners.flush();
        for_owned_faces(
            offsets_, 8, [&](std::size_t f) { return std::int64_t(part.corner_id(f, part.mesh.face(f).size())); });
        for_owned_faces(types_, 1, [&](std::size_t f) {
            constexpr std::uint8_t triangle = 5, polygon = 7, quad = 9; // VTK's numbers
            const std::size_t degree = part.mesh.face(f).size();
            return degree == 3 ? triangle : degree == 4 ? quad : polygon;
        });
        for_owned_faces(parents_, 8, [&](std::size_t f) { return std::int64_t(part.root(f)); });
        for_owned_faces(levels_, 1, [&](std::size_t) { return std::uint8_t(level_); });
        if (with_origin_) {
            for_owned_faces(tiles_, 4, [&](std::size_t) { return origin.tile; });
            for_owned_faces(ranks_, 4, [&](std::size_t) { return origin.rank; });
        }
    }

private:
    struct array_place {
        std::uint64_t offset = 0;
        std::uint64_t bytes = 0;
    };

    int level_;
    bool with_origin_;
    std::string head_, tail_;
    array_place points_, connectivity_, offsets_, types_, parents_, levels_, tiles_, ranks_;
};

/// Binary PLY. Faces of up to 255 corners, and as many vertices as 32 bits can number.
class ply_file : public stitched_file {
public:
    /// Errors: mesh_error for more vertices than the format can number.
    explicit ply_file(const whole_counts& counts) : counts_(counts)
    {
        if (counts.vertices > std::numeric_limits<std::int32_t>::max())
            throw mesh_error("PLY numbers " + std::to_string(std::numeric_limits<std::int32_t>::max()) +
                             " vertices at most, there are " + std::to_string(counts.vertices) + "; write .vtu");
        head_ = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(counts.vertices) +
                "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                std::to_string(counts.faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
        size_ = head_.size() + 24 * counts.vertices + counts.faces + 4 * counts.corners;
    }

    void write_frame(offset_file& file) const override { file.write(0, head_.data(), head_.size()); }
    void write_tile(offset_file& file, const tile<std::array<double, 3>>& part, cell_origin) const override
    {
        joined_writes points(file);
        for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
            if (part.owns_vertex(v))
                points.put(head_.size() + 24 * part.vertex_ids[v], part.mesh.point(v));
        points.flush();
        joined_writes faces(file);
        const std::uint64_t begin = head_.size() + 24 * counts_.vertices;
        for (std::size_t f = 0; f < part.mesh.face_count(); ++f) {
            if (not part.owns_face(f))
                continue;
            const auto face = part.mesh.face(f);
            if (face.size() > std::numeric_limits<std::uint8_t>::max())
                throw mesh_error("face " + std::to_string(part.face_ids[f]) + " has " + std::to_string(face.size()) +
                                 " corners, PLY holds 255 at most; write .vtu");
            std::uint64_t at = begin + part.face_ids[f] + 4 * part.corner_id(f, 0);
            faces.put(at, std::uint8_t(face.size()));
            ++at;
            for (const auto v : face) {
                faces.put(at, std::int32_t(part.vertex_ids[v]));
                at += 4;
            }
        }
        faces.flush();
    }

private:
    whole_counts counts_;
    std::string head_;
};

} // namespace kith
