// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ply_header.hpp"

#include <kith/core/base/error.hpp>
#include <kith/tiles/part/tile.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

namespace kith {

/// Consecutive records of one size in a file.
struct ply_records {
    std::streamoff begin;
    std::size_t size;

    [[nodiscard]] std::streamoff at(std::uint64_t i) const { return begin + std::streamoff(i * size); }
};

/// The places of vertices and faces in a binary little-endian PLY file. All faces are triangles, or all are quads, so
/// that records have one size each. Vertices and faces may have numbers besides coordinates and corners.
/// Errors of all members: mesh_error, which names the file. Local.
class ply_layout {
public:
    /// A coordinate in the record of a vertex.
    struct coordinate {
        std::size_t at;
        ply_number type;
    };

    /// Reads the header and finds the records. Cost: that of the header, and of reading all elements after the faces if
    /// they have lists.
    ply_layout(std::string path, std::ifstream& in) : path_(std::move(path))
    {
        static_assert(std::endian::native == std::endian::little, "the file is read as it lies");
        read_header(in);
        find_records(in);
    }

    [[nodiscard]] global_id vertices() const { return header_.vertices; }
    [[nodiscard]] global_id faces() const { return header_.faces; }
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] const ply_header& header() const { return header_; }
    [[nodiscard]] ply_records vertex_records() const { return {vertices_at_, vertex_bytes_}; }
    [[nodiscard]] ply_records face_records() const { return {faces_at_, face_bytes()}; }
    [[nodiscard]] const coordinate& coordinate_of(std::size_t axis) const { return coordinates_[axis]; }
    /// Returns the list of the vertices of a face (corner_list), and its first byte in the record of a face
    /// (before_corners).
    [[nodiscard]] const ply_property& corner_list() const
    {
        return header_.elements[1].properties[header_.elements[1].corner_list()];
    }
    [[nodiscard]] std::size_t before_corners() const { return before_corners_; }
    /// Returns the first byte of a property in the record of a vertex or of a face.
    [[nodiscard]] std::size_t offset(const ply_element& element, std::size_t property) const
    {
        std::size_t result = 0;
        for (std::size_t p = 0; p < property; ++p)
            result += element.properties[p].is_list() ? corner_bytes() : element.properties[p].value.bytes;
        return result;
    }

    void require_degree(global_id face, std::int64_t degree) const
    {
        if (degree != degree_)
            refuse("has face " + std::to_string(face) + " of another degree than face 0; read it on one rank");
    }
    void require(bool condition, const std::string& problem) const
    {
        if (not condition)
            refuse(problem);
    }
    [[noreturn]] void refuse(const std::string& problem) const { throw mesh_error(path_ + ": " + problem); }

private:
    [[nodiscard]] std::size_t corner_bytes() const
    {
        return corner_list().count.bytes + corner_list().value.bytes * std::size_t(degree_);
    }
    [[nodiscard]] std::size_t face_bytes() const { return corner_bytes() + beside_corners_; }

    /// Returns the first bytes of the file, up to the end of the header or beyond.
    [[nodiscard]] static std::string first_bytes(std::ifstream& in)
    {
        constexpr std::size_t block = 4096, most = std::size_t(1) << 24;
        std::string result;
        while (in and result.size() < most) {
            const std::size_t before = result.size();
            result.resize(before + block);
            in.read(result.data() + before, std::streamsize(block));
            result.resize(before + std::size_t(in.gcount()));
            if (not result.starts_with("ply") and not result.starts_with(byte_order_mark))
                break;
            if (holds_end_of_header(result, before < 16 ? 0 : before - 16))
                break;
        }
        in.clear();
        return result;
    }
    void read_header(std::ifstream& in)
    {
        const std::string first = first_bytes(in);
        const std::size_t mark = first.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        require(std::string_view(first).substr(mark).starts_with("ply"), "is not a PLY file that can be read");
        try {
            header_ = read_ply_header(std::string_view(first).substr(mark));
        } catch (const mesh_error& error) {
            throw mesh_error(path_ + ": " + error.what());
        }
        require(header_.encoding == ply_encoding::little_endian,
                "is not binary_little_endian; only such files are read in slices");
        const auto& elements = header_.elements;
        require(std::ranges::none_of(elements, [](const auto& e) { return e.is_strips() and e.count != 0; }),
                "has strips of triangles ('tristrips'), which cannot be read in slices; read it on one rank");
        require(elements[0].is_vertex() and elements[1].is_face(),
                "has element " + (elements[0].is_vertex() ? elements[1] : elements[0]).name +
                    " out of place; vertices come first, then faces, then others");
        const auto list = std::ptrdiff_t(elements[1].corner_list());
        const auto& of_faces = elements[1].properties;
        require(not elements[0].has_lists() and std::ranges::count_if(of_faces, &ply_property::is_list) == 1,
                "needs faces with one list 'vertex_indices', and no other list; read it on one rank");
        const auto bytes_of = [](std::size_t sum, const ply_property& p) { return sum + p.value.bytes; };
        before_corners_ = std::accumulate(of_faces.begin(), of_faces.begin() + list, std::size_t(0), bytes_of);
        beside_corners_ = std::accumulate(of_faces.begin() + list + 1, of_faces.end(), before_corners_, bytes_of);
        require(faces() != 0, "has no faces; nothing can be refined");
        const auto place_of = elements[0].place();
        for (std::size_t p = 0; p < elements[0].properties.size(); ++p) {
            const ply_number& type = elements[0].properties[p].value;
            if (const auto x = std::ranges::find(place_of, p); x != place_of.end()) {
                require(type.floating, "has coordinates that are not floating-point numbers; read it on one rank");
                coordinates_[std::size_t(x - place_of.begin())] = {vertex_bytes_, type};
            }
            vertex_bytes_ += type.bytes;
        }
        vertices_at_ = std::streamoff(mark + header_.data_begin);
    }
    /// Finds the records of vertices and faces. Checks the counts of the header against the length of the file.
    void find_records(std::ifstream& in)
    {
        in.seekg(0, std::ios::end);
        auto left = std::uint64_t(in.tellg() - vertices_at_);
        const auto too_short = [&] {
            return "is too short for " + std::to_string(vertices()) + " vertices and " + std::to_string(faces()) +
                   " faces of one degree";
        };
        require(vertices() <= left / vertex_bytes_, too_short());
        left -= vertices() * vertex_bytes_;
        faces_at_ = vertices_at_ + std::streamoff(vertices() * vertex_bytes_);
        require(left >= before_corners_ + corner_list().count.bytes, too_short());
        const std::int64_t degree = degree_of(in, 0);
        require(degree == 3 or degree == 4,
                "has faces of " + std::to_string(degree) +
                    " vertices; files of triangles or of quads can be read in slices");
        degree_ = int(degree);
        require(faces() <= left / face_bytes(), too_short());
        left -= faces() * face_bytes();
        in.seekg(faces_at_ + std::streamoff(faces() * face_bytes()));
        for (std::size_t e = 2; e < header_.elements.size(); ++e)
            skip(in, header_.elements[e], left);
        if (left != 0) // for example after a face with more vertices than the first one
            for (global_id f = 0; f < faces(); ++f)
                require_degree(f, degree_of(in, f));
        require(left == 0,
                "goes on for " + std::to_string(left) + (left == 1 ? " byte" : " bytes") + " after its last element");
        in.clear();
    }
    /// Returns the number of vertices of a face. Precondition: all faces before it have degree_.
    [[nodiscard]] std::int64_t degree_of(std::ifstream& in, global_id face) const
    {
        const ply_number& type = corner_list().count;
        std::array<char, 8> stored{};
        in.seekg(faces_at_ + std::streamoff(face * face_bytes() + before_corners_));
        in.read(stored.data(), std::streamsize(type.bytes));
        return type.whole(stored.data());
    }
    /// Skips the elements of a kind that is not read.
    void skip(std::ifstream& in, const ply_element& element, std::uint64_t& left) const
    {
        const std::size_t least = element.least_bytes();
        require(element.count == 0 or element.count <= left / least, "ends within its elements '" + element.name + "'");
        if (not element.has_lists()) {
            left -= element.count * least;
            in.seekg(std::streamoff(element.count * least), std::ios::cur);
            return;
        }
        const auto take = [&](std::uint64_t size) {
            require(size <= left, "ends within its elements '" + element.name + "'");
            left -= size;
        };
        for (std::uint64_t item = 0; item < element.count; ++item)
            for (const auto& property : element.properties) {
                std::uint64_t length = 1;
                if (property.is_list()) {
                    take(property.count.bytes);
                    length = 0;
                    in.read(reinterpret_cast<char*>(&length), std::streamsize(property.count.bytes));
                    require(not property.count.is_signed or length >> (8 * property.count.bytes - 1) == 0,
                            "has a list of negative length in element '" + element.name + "'");
                }
                take(length * property.value.bytes);
                in.ignore(std::streamsize(length * property.value.bytes));
            }
    }

    static constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

    std::string path_;
    ply_header header_;
    int degree_ = 0;
    std::size_t before_corners_ = 0, beside_corners_ = 0; ///< bytes of a face's record
    std::size_t vertex_bytes_ = 0;
    std::array<coordinate, 3> coordinates_{};
    std::streamoff vertices_at_ = 0, faces_at_ = 0;
};

} // namespace kith
