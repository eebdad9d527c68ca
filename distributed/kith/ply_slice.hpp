// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile.hpp"

#include <kith/error.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>
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

/// A binary little-endian PLY file of triangles only or of quads only, so that its records have places that can be told.
/// Errors of all members: mesh_error, which names the file. Local.
class sliced_ply {
public:
    /// Reads the header.
    explicit sliced_ply(std::string path) : path_(std::move(path)), in_(path_, std::ios::binary)
    {
        static_assert(std::endian::native == std::endian::little, "the file is read as it lies");
        read_header();
    }

    [[nodiscard]] global_id vertices() const { return vertices_; }
    [[nodiscard]] global_id faces() const { return faces_; }
    [[nodiscard]] int degree() const { return degree_; }
    /// Of faces and vertices, so far.
    [[nodiscard]] std::uint64_t bytes_read() const { return bytes_read_; }

    /// Faces [first_face, end_face) and vertices [first_vertex, end_vertex). Cost: reading those bytes.
    [[nodiscard]] mesh_slice<std::array<double, 3>> read(global_id first_face, global_id end_face,
                                                         global_id first_vertex, global_id end_vertex)
    {
        mesh_slice<std::array<double, 3>> result{vertices_, faces_, degree_, first_face, first_vertex, {}, {}};
        const auto faces = bytes(faces_at_ + std::streamoff(first_face * face_bytes()),
                                 (end_face - first_face) * face_bytes());
        for (global_id f = first_face; f < end_face; ++f) {
            const char* record = faces.data() + (f - first_face) * face_bytes();
            require(int(static_cast<unsigned char>(record[0])) == degree_,
                    "has face " + std::to_string(f) + " of another degree than face 0; read it on one rank");
            for (int k = 0; k < degree_; ++k) {
                const auto v = value<std::uint32_t>(record + 1 + 4 * k);
                require(v < vertices_,
                        "has face " + std::to_string(f) + " at vertex " + std::to_string(v) + " of " +
                            std::to_string(vertices_));
                result.corners.push_back(v);
            }
        }
        const auto records = bytes(vertices_at_ + std::streamoff(first_vertex * vertex_bytes_),
                                   (end_vertex - first_vertex) * vertex_bytes_);
        for (std::size_t i = 0; i < end_vertex - first_vertex; ++i) {
            const char* record = records.data() + i * vertex_bytes_;
            auto& point = result.points.emplace_back();
            for (std::size_t x = 0; x < 3; ++x)
                point[x] = places_[x].is_double ? value<double>(record + places_[x].at)
                                                : double(value<float>(record + places_[x].at));
        }
        return result;
    }

private:
    struct place {
        std::size_t at;
        bool is_double;
    };

    void require(bool condition, const std::string& problem) const
    {
        if (not condition)
            throw mesh_error(path_ + ": " + problem);
    }
    template <class T>
    static T value(const char* bytes)
    {
        T result;
        std::memcpy(&result, bytes, sizeof(T));
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
    static std::size_t size_of(std::string_view type)
    {
        for (const auto& [name, size] : std::initializer_list<std::pair<std::string_view, std::size_t>>{{"char", 1},
                                                                                                        {"uchar", 1},
                                                                                                        {"int8", 1},
                                                                                                        {"uint8", 1},
                                                                                                        {"short", 2},
                                                                                                        {"ushort", 2},
                                                                                                        {"int16", 2},
                                                                                                        {"uint16", 2},
                                                                                                        {"int", 4},
                                                                                                        {"uint", 4},
                                                                                                        {"int32", 4},
                                                                                                        {"uint32", 4},
                                                                                                        {"float", 4},
                                                                                                        {"float32", 4},
                                                                                                        {"double", 8},
                                                                                                        {"float64", 8}})
            if (name == type)
                return size;
        return 0;
    }
    [[nodiscard]] std::size_t face_bytes() const { return 1 + 4 * std::size_t(degree_); }

    [[nodiscard]] global_id count_of(const std::string& element, const std::string& text) const
    {
        global_id count = 0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, count);
        require(error == std::errc() and rest == end, "has '" + text + "' for the number of element " + element);
        return count;
    }
    void read_header()
    {
        std::array<std::optional<place>, 3> found;
        int elements = 0, face_properties = 0; // so far
        bool has_format = false, has_corners = false;
        std::string line;
        require(bool(std::getline(in_, line)) and line.starts_with("ply"), "is no PLY file that can be read");
        while (std::getline(in_, line) and not line.starts_with("end_header")) {
            std::istringstream words(line);
            std::string word, type, name;
            words >> word >> type >> name;
            if (word == "format") {
                require(type == "binary_little_endian",
                        "is not binary_little_endian; only such files are read in slices");
                has_format = true;
            }
            if (word == "element") {
                ++elements;
                require((type == "vertex") == (elements == 1) and (type == "face") == (elements == 2),
                        "has element " + type + " out of place; vertices come first, then faces, then others");
                if (type == "vertex")
                    vertices_ = count_of(type, name);
                if (type == "face")
                    faces_ = count_of(type, name);
            } else if (word == "property" and elements == 1) {
                const std::size_t size = size_of(type);
                require(size != 0, "has a property of vertices of type " + type);
                for (std::size_t x = 0; x < 3; ++x)
                    if (name == std::array{"x", "y", "z"}[x]) {
                        require(type.starts_with("float") or type == "double", "has places of type " + type);
                        found[x] = {vertex_bytes_, size == 8};
                    }
                vertex_bytes_ += size;
            } else if (word == "property" and elements == 2) {
                std::string index, list;
                words >> index >> list;
                ++face_properties;
                has_corners = type == "list" and size_of(name) == 1 and size_of(index) == 4 and
                              index.find("int") != index.npos and (list == "vertex_indices" or list == "vertex_index");
            }
        }
        require(has_format, "has no line 'format' in its header; only binary_little_endian files are read in slices");
        require(
            bool(in_) and found[0] and found[1] and found[2] and has_corners and face_properties == 1,
            "needs vertices with x, y, z and faces with one list 'vertex_indices' of uchar and int, and nothing else");
        require(faces_ != 0, "has no faces; nothing can be refined");
        places_ = {*found[0], *found[1], *found[2]};
        find_places();
    }
    /// Where vertices and faces lie. The numbers in the header are not believed before the file is as long as they say.
    void find_places()
    {
        vertices_at_ = in_.tellg();
        in_.seekg(0, std::ios::end);
        auto left = std::uint64_t(in_.tellg() - vertices_at_);
        const auto too_short = [&] {
            return "is too short for " + std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
                   " faces of one degree";
        };
        require(vertices_ <= left / vertex_bytes_, too_short());
        left -= vertices_ * vertex_bytes_;
        faces_at_ = vertices_at_ + std::streamoff(vertices_ * vertex_bytes_);
        require(left > 0, too_short());
        in_.seekg(faces_at_);
        degree_ = in_.get();
        require(degree_ == 3 or degree_ == 4,
                "has faces of " + std::to_string(degree_) +
                    " vertices; files of triangles or of quads can be read in slices");
        require(faces_ <= left / face_bytes(), too_short());
    }

    std::string path_;
    std::ifstream in_;
    global_id vertices_ = 0, faces_ = 0;
    int degree_ = 0;
    std::uint64_t bytes_read_ = 0;
    std::size_t vertex_bytes_ = 0;
    std::array<place, 3> places_{};
    std::streamoff vertices_at_ = 0, faces_at_ = 0;
};

} // namespace kith
