// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ply_header.hpp"

#include <kith/base/error.hpp>
#include <kith/part/tile.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace kith {

/// Some faces of a control mesh and, independently, some of its vertices: what one rank reads of a file.
template <class Point>
struct mesh_slice {
    global_id vertices = 0, faces = 0; ///< of the whole mesh
    int degree = 0;                    ///< of all faces
    global_id first_face = 0, first_vertex = 0;
    std::vector<global_id> corners; ///< the vertices of the faces, `degree` each
    std::vector<Point> points;
};

/// A binary little-endian PLY file of triangles only or of quads only, so that its records have places that can be
/// told; vertices and faces may have numbers beside places and corners.
/// Errors of all members: mesh_error, which names the file. Local.
class sliced_ply {
public:
    /// Reads the header. Cost: that, and a sweep over the bytes behind the faces if there are lists among them.
    explicit sliced_ply(std::string path) : path_(std::move(path))
    {
        static_assert(std::endian::native == std::endian::little, "the file is read as it lies");
        require_readable(path_);
        in_.open(path_, std::ios::binary);
        read_header();
    }
    /// Throws the reason of the system if there is no file at this path that can be read, or a directory.
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

    [[nodiscard]] global_id vertices() const { return header_.vertices; }
    [[nodiscard]] global_id faces() const { return header_.faces; }
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] const ply_header& header() const { return header_; }
    /// Of faces and vertices, so far.
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

    /// Faces [first_face, end_face) and vertices [first_vertex, end_vertex). Cost: reading those bytes.
    [[nodiscard]] mesh_slice<std::array<double, 3>> read(global_id first_face, global_id end_face,
                                                         global_id first_vertex, global_id end_vertex)
    {
        mesh_slice<std::array<double, 3>> result{vertices(), faces(), degree_, first_face, first_vertex, {}, {}};
        const auto records_of_faces = bytes(faces_at_ + std::streamoff(first_face * face_bytes()),
                                            (end_face - first_face) * face_bytes());
        const ply_property& list = corner_list();
        for (global_id f = first_face; f < end_face; ++f) {
            const char* record = records_of_faces.data() + (f - first_face) * face_bytes() + before_corners_;
            require_degree(f, list.count.whole(record));
            for (int k = 0; k < degree_; ++k) {
                const std::int64_t v = list.value.whole(record + list.count.bytes + list.value.bytes * std::size_t(k));
                if (v < 0 or global_id(v) >= vertices())
                    refuse("face " + std::to_string(f) + ": vertex " + std::to_string(v) +
                           " does not exist, there are " + std::to_string(vertices()) + "; correct the index");
                result.corners.push_back(global_id(v));
            }
        }
        const auto records = bytes(vertices_at_ + std::streamoff(first_vertex * vertex_bytes_),
                                   (end_vertex - first_vertex) * vertex_bytes_);
        for (std::size_t i = 0; i < end_vertex - first_vertex; ++i) {
            const char* record = records.data() + i * vertex_bytes_;
            auto& point = result.points.emplace_back();
            for (std::size_t x = 0; x < 3; ++x) {
                point[x] = places_[x].type.value(record + places_[x].at);
                if (not std::isfinite(point[x]))
                    refuse("vertex " + std::to_string(first_vertex + i) +
                           ": a coordinate is not a finite number; give finite coordinates");
            }
        }
        return result;
    }

    /// The numbers that some vertices or faces have in a property of theirs that is no list. Precondition: the numbers
    /// of the elements increase. Cost: reading their bytes.
    [[nodiscard]] std::vector<double> values_of_vertices(std::size_t property, std::span<const global_id> vertices)
    {
        return values({vertices_at_, vertex_bytes_}, header_.elements[0], property, vertices);
    }
    [[nodiscard]] std::vector<double> values_of_faces(std::size_t property, std::span<const global_id> faces)
    {
        return values({faces_at_, face_bytes()}, header_.elements[1], property, faces);
    }

private:
    struct place {
        std::size_t at;
        ply_number type;
    };

    [[noreturn]] void refuse(const std::string& problem) const { throw mesh_error(path_ + ": " + problem); }
    void require(bool condition, const std::string& problem) const
    {
        if (not condition)
            refuse(problem);
    }
    /// Records of one size, one behind the other.
    struct records {
        std::streamoff at;
        std::size_t size;
    };
    [[nodiscard]] std::vector<double> values(const records& all, const ply_element& element, std::size_t property,
                                             std::span<const global_id> numbers)
    {
        std::size_t offset = 0;
        for (std::size_t p = 0; p < property; ++p)
            offset += element.properties[p].is_list() ? corner_bytes() : element.properties[p].value.bytes;
        std::vector<double> result;
        for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
            while (end < numbers.size() and numbers[end] - numbers[begin] == end - begin)
                ++end;
            const auto run = bytes(all.at + std::streamoff(numbers[begin] * all.size), (end - begin) * all.size);
            for (std::size_t i = 0; i < end - begin; ++i)
                result.push_back(element.properties[property].value.value(run.data() + i * all.size + offset));
        }
        return result;
    }
    [[nodiscard]] std::vector<char> bytes(std::streamoff at, std::size_t size)
    {
        std::vector<char> result(size);
        in_.seekg(at);
        in_.read(result.data(), std::streamsize(size));
        require(bool(in_), "ends too early");
        bytes_read_ += size;
        return result;
    }
    [[nodiscard]] const ply_property& corner_list() const
    {
        return header_.elements[1].properties[header_.elements[1].corner_list()];
    }
    [[nodiscard]] std::size_t corner_bytes() const
    {
        return corner_list().count.bytes + corner_list().value.bytes * std::size_t(degree_);
    }
    [[nodiscard]] std::size_t face_bytes() const { return corner_bytes() + beside_corners_; }

    /// The first bytes of the file, up to the end of the header and beyond.
    [[nodiscard]] std::string first_bytes()
    {
        constexpr std::size_t block = 4096, most = std::size_t(1) << 24;
        std::string result;
        while (in_ and result.size() < most) {
            const std::size_t before = result.size();
            result.resize(before + block);
            in_.read(result.data() + before, std::streamsize(block));
            result.resize(before + std::size_t(in_.gcount()));
            if (not result.starts_with("ply") and not result.starts_with(byte_order_mark))
                break;
            if (holds_end_of_header(result, before < 16 ? 0 : before - 16))
                break;
        }
        in_.clear();
        return result;
    }
    void read_header()
    {
        const std::string first = first_bytes();
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
                places_[std::size_t(x - place_of.begin())] = {vertex_bytes_, type};
            }
            vertex_bytes_ += type.bytes;
        }
        vertices_at_ = std::streamoff(mark + header_.data_begin);
        find_places();
    }
    /// Where vertices and faces lie. The numbers in the header are not believed before the file is as long as they say.
    void find_places()
    {
        in_.seekg(0, std::ios::end);
        auto left = std::uint64_t(in_.tellg() - vertices_at_);
        const auto too_short = [&] {
            return "is too short for " + std::to_string(vertices()) + " vertices and " + std::to_string(faces()) +
                   " faces of one degree";
        };
        require(vertices() <= left / vertex_bytes_, too_short());
        left -= vertices() * vertex_bytes_;
        faces_at_ = vertices_at_ + std::streamoff(vertices() * vertex_bytes_);
        require(left >= before_corners_ + corner_list().count.bytes, too_short());
        const std::int64_t degree = degree_of(0);
        require(degree == 3 or degree == 4,
                "has faces of " + std::to_string(degree) +
                    " vertices; files of triangles or of quads can be read in slices");
        degree_ = int(degree);
        require(faces() <= left / face_bytes(), too_short());
        left -= faces() * face_bytes();
        in_.seekg(faces_at_ + std::streamoff(faces() * face_bytes()));
        for (std::size_t e = 2; e < header_.elements.size(); ++e)
            skip(header_.elements[e], left);
        if (left != 0) // as it does behind a face of more vertices than the first one
            for (global_id f = 0; f < faces(); ++f)
                require_degree(f, degree_of(f));
        require(left == 0,
                "goes on for " + std::to_string(left) + (left == 1 ? " byte" : " bytes") + " after its last element");
        in_.clear();
    }
    /// Reads how many vertices a face has. Precondition: all faces before it have degree_.
    [[nodiscard]] std::int64_t degree_of(global_id face)
    {
        const ply_number& type = corner_list().count;
        std::array<char, 8> stored{};
        in_.seekg(faces_at_ + std::streamoff(face * face_bytes() + before_corners_));
        in_.read(stored.data(), std::streamsize(type.bytes));
        return type.whole(stored.data());
    }
    void require_degree(global_id face, std::int64_t degree) const
    {
        if (degree != degree_)
            refuse("has face " + std::to_string(face) + " of another degree than face 0; read it on one rank");
    }
    /// Goes behind the elements of a kind that is not read.
    void skip(const ply_element& element, std::uint64_t& left)
    {
        const std::size_t least = element.least_bytes();
        require(element.count == 0 or element.count <= left / least, "ends within its elements '" + element.name + "'");
        if (not element.has_lists()) {
            left -= element.count * least;
            in_.seekg(std::streamoff(element.count * least), std::ios::cur);
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
                    in_.read(reinterpret_cast<char*>(&length), std::streamsize(property.count.bytes));
                    require(not property.count.is_signed or length >> (8 * property.count.bytes - 1) == 0,
                            "has a list of negative length in element '" + element.name + "'");
                }
                take(length * property.value.bytes);
                in_.ignore(std::streamsize(length * property.value.bytes));
            }
    }

    static constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

    std::string path_;
    std::ifstream in_;
    ply_header header_;
    int degree_ = 0;
    std::size_t before_corners_ = 0, beside_corners_ = 0; ///< bytes of a face
    std::uint64_t bytes_read_ = 0;
    std::size_t vertex_bytes_ = 0;
    std::array<place, 3> places_{};
    std::streamoff vertices_at_ = 0, faces_at_ = 0;
};

} // namespace kith
