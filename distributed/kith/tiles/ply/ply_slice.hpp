// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ply_layout.hpp"

#include <kith/core/base/error.hpp>
#include <kith/tiles/part/tile.hpp>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>
#include <vector>

namespace kith {

/// Some faces of a control mesh and, independently, some of its vertices, as one rank reads them from a file.
template <class Point>
struct mesh_slice {
    global_id vertices = 0, faces = 0; ///< of the whole mesh
    int degree = 0;                    ///< of all faces
    global_id first_face = 0, first_vertex = 0;
    std::vector<global_id> corners; ///< the vertices of the faces, `degree` each
    std::vector<Point> points;
};

/// A PLY file with a ply_layout, of which ranges of faces and vertices are read.
/// Errors of all members: mesh_error, which names the file. Local.
class sliced_ply {
public:
    /// Reads the header. Cost: that of ply_layout.
    explicit sliced_ply(const std::string& path) : in_(opened(path)), layout_(path, in_) {}
    /// Throws mesh_error with the system's reason if the file at this path cannot be read, or if it is a directory.
    static void require_readable(const std::string& path)
    {
        std::error_code failed;
        if (std::filesystem::is_directory(path, failed))
            throw mesh_error(path + ": is a directory, not a file");
        errno = 0;
        if (not std::ifstream(path, std::ios::binary))
            throw mesh_error(
                path + ": cannot be opened: " + (errno != 0 ? std::strerror(errno) : "the system tells no reason"));
    }

    [[nodiscard]] global_id vertices() const { return layout_.vertices(); }
    [[nodiscard]] global_id faces() const { return layout_.faces(); }
    [[nodiscard]] int degree() const { return layout_.degree(); }
    [[nodiscard]] const ply_header& header() const { return layout_.header(); }
    /// Returns the number of bytes read so far for faces and vertices.
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

    /// Returns faces [first_face, end_face) and vertices [first_vertex, end_vertex). Cost: reading their bytes.
    [[nodiscard]] mesh_slice<std::array<double, 3>> read(global_id first_face, global_id end_face,
                                                         global_id first_vertex, global_id end_vertex)
    {
        mesh_slice<std::array<double, 3>> result{vertices(), faces(), degree(), first_face, first_vertex, {}, {}};
        const ply_records all_faces = layout_.face_records(), all_vertices = layout_.vertex_records();
        const auto records_of_faces = bytes(all_faces, first_face, end_face);
        const ply_property& list = layout_.corner_list();
        for (global_id f = first_face; f < end_face; ++f) {
            const char* record = records_of_faces.data() + (f - first_face) * all_faces.size + layout_.before_corners();
            layout_.require_degree(f, list.count.whole(record));
            for (int k = 0; k < degree(); ++k) {
                const std::int64_t v = list.value.whole(record + list.count.bytes + list.value.bytes * std::size_t(k));
                if (v < 0 or global_id(v) >= vertices())
                    layout_.refuse("face " + std::to_string(f) + ": vertex " + std::to_string(v) +
                                   " does not exist, there are " + std::to_string(vertices()) + "; correct the index");
                result.corners.push_back(global_id(v));
            }
        }
        const auto records = bytes(all_vertices, first_vertex, end_vertex);
        for (std::size_t i = 0; i < end_vertex - first_vertex; ++i) {
            const char* record = records.data() + i * all_vertices.size;
            auto& point = result.points.emplace_back();
            for (std::size_t x = 0; x < 3; ++x) {
                const auto& [at, type] = layout_.coordinate_of(x);
                point[x] = type.value(record + at);
                if (not std::isfinite(point[x]))
                    layout_.refuse("vertex " + std::to_string(first_vertex + i) +
                                   ": a coordinate is not a finite number; give finite coordinates");
            }
        }
        return result;
    }

    /// Returns the values of a property, which is no list, at these vertices or faces. Precondition: the numbers of the
    /// elements increase. Cost: reading their bytes.
    [[nodiscard]] std::vector<double> values_of_vertices(std::size_t property, std::span<const global_id> vertices)
    {
        return values(layout_.vertex_records(), header().elements[0], property, vertices);
    }
    [[nodiscard]] std::vector<double> values_of_faces(std::size_t property, std::span<const global_id> faces)
    {
        return values(layout_.face_records(), header().elements[1], property, faces);
    }

private:
    [[nodiscard]] static std::ifstream opened(const std::string& path)
    {
        require_readable(path);
        return std::ifstream(path, std::ios::binary);
    }
    [[nodiscard]] std::vector<double> values(const ply_records& all, const ply_element& element, std::size_t property,
                                             std::span<const global_id> numbers)
    {
        const std::size_t offset = layout_.offset(element, property);
        std::vector<double> result;
        for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
            while (end < numbers.size() and numbers[end] - numbers[begin] == end - begin)
                ++end;
            const auto run = bytes(all, numbers[begin], numbers[begin] + (end - begin));
            for (std::size_t i = 0; i < end - begin; ++i)
                result.push_back(element.properties[property].value.value(run.data() + i * all.size + offset));
        }
        return result;
    }
    [[nodiscard]] std::vector<char> bytes(const ply_records& all, global_id begin, global_id end)
    {
        std::vector<char> result((end - begin) * all.size);
        in_.seekg(all.at(begin));
        in_.read(result.data(), std::streamsize(result.size()));
        layout_.require(bool(in_), "ends too early");
        bytes_read_ += result.size();
        return result;
    }

    std::ifstream in_;
    ply_layout layout_;
    std::uint64_t bytes_read_ = 0;
};

} // namespace kith
