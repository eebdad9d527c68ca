// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ply_words.hpp"
#include "stitch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Returns PLY's name of a type of numbers given in VTK's notation. Errors: mesh_error for a type that PLY lacks.
inline std::string ply_word(const file_array& array)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> words{{{"Int8", "char"},
                                                                                  {"UInt8", "uchar"},
                                                                                  {"Int16", "short"},
                                                                                  {"UInt16", "ushort"},
                                                                                  {"Int32", "int"},
                                                                                  {"UInt32", "uint"},
                                                                                  {"Float32", "float"},
                                                                                  {"Float64", "double"}}};
    const auto found = std::ranges::find(words, array.type, &std::pair<std::string_view, std::string_view>::first);
    if (found == words.end())
        throw mesh_error("the field \"" + array.name + "\" has numbers of type " + array.type +
                         ", which PLY has not; write .vtu");
    return std::string(found->second);
}

/// Returns true if one of the numbers of a value is NaN.
inline bool has_nan(const file_array& array, const std::byte* value)
{
    const auto any = [&]<class Number>(Number number) {
        for (std::size_t i = 0; i < array.numbers; ++i) {
            std::memcpy(&number, value + i * sizeof(Number), sizeof(Number));
            if (std::isnan(number))
                return true;
        }
        return false;
    };
    return array.type == "Float32" ? any(0.F) : array.type == "Float64" and any(0.);
}

} // namespace detail

/// A binary PLY file with the bytes that io::write_mesh writes for the whole mesh. It holds at most 2^31 - 1 vertices.
/// Fields on vertices and faces are properties. A field on corners is a list of each face, after its vertices. If
/// numbers of faces stand for words, comments give the words.
class ply_file : public stitched_file {
public:
    /// Lays out the file. With normals, of vertices or of corners, the tiles must have them. `largest_degree` is that
    /// of the faces of the whole mesh (kith::largest_degree); it determines the type of the corner counts. Errors:
    /// mesh_error for more vertices than the format can number; for numbers of a type that PLY lacks; for several
    /// numbers in a value of a vertex or face; for two fields on corners; and for a name that is taken.
    explicit ply_file(const global_counts& counts, bool with_normals = false, std::vector<file_array> arrays = {},
                      const std::vector<std::string>& file_lines = {}, std::uint64_t largest_degree = 4,
                      bool with_corner_normals = false)
        : counts_(counts)
        , with_normals_(with_normals)
        , with_corner_normals_(with_corner_normals)
        , arrays_(std::move(arrays))
        , corners_of_face_(ply_count::of(largest_degree))
        , normals_of_face_(ply_count::of(3 * largest_degree))
    {
        if (counts.vertices > std::numeric_limits<std::int32_t>::max())
            throw mesh_error("PLY numbers " + std::to_string(std::numeric_limits<std::int32_t>::max()) +
                             " vertices at most, there are " + std::to_string(counts.vertices) + "; write .vtu");
        std::string of_vertices, of_faces, of_corners, comments = ply_file_lines(file_lines);
        property_names names;
        if (with_normals)
            names.of_vertices.insert({"nx", "ny", "nz"});
        if (with_corner_normals)
            names.of_faces.emplace(ply_corner_normals_name);
        place_of_ = std::vector<std::uint64_t>(arrays_.size());
        bytes_of_vertex_ = with_normals ? 48 : 24;
        for (std::size_t i = 0; i < arrays_.size(); ++i) {
            const file_array& array = arrays_[i];
            const std::string word = detail::ply_word(array);
            const bool at_corners = array.on == field_on::corners;
            if (at_corners ? corners_.has_value() : array.numbers != 1)
                throw mesh_error("the field \"" + array.name +
                                 "\" has no place in PLY, which has numbers at vertices and faces and one list for " +
                                 "corners; write .vtu");
            const std::string name = ply_name(array.name);
            names.add(array);
            comments += ply_word_lines(array.name, array.words);
            if (at_corners) {
                corners_ = i;
                values_of_face_ = ply_count::of(array.numbers * largest_degree);
                of_corners = "property list " + std::string(values_of_face_.word) + " " + word + " " + name + "\n";
            } else {
                const bool at_vertices = array.on == field_on::vertices;
                (at_vertices ? of_vertices : of_faces) += "property " + word + " " + name + "\n";
                place_of_[i] = std::exchange(at_vertices ? bytes_of_vertex_ : bytes_of_values_,
                                             (at_vertices ? bytes_of_vertex_ : bytes_of_values_) + array.bytes);
            }
        }
        bytes_of_corner_ = 4 + (corners_ ? arrays_[*corners_].bytes : 0) + (with_corner_normals ? 24 : 0);
        bytes_of_face_ = corners_of_face_.bytes + (corners_ ? values_of_face_.bytes : 0) +
                         (with_corner_normals ? normals_of_face_.bytes : 0) + bytes_of_values_;
        if (with_corner_normals)
            of_corners += ply_corner_normals(normals_of_face_);
        head_ = ply_head(true,
                         {counts.vertices,
                          counts.faces,
                          with_normals,
                          largest_degree,
                          comments,
                          of_vertices,
                          of_corners + of_faces});
        size_ = face_at(counts.faces, counts.corners);
    }

    void write_frame(placed_bytes& file) const override { file.write(0, head_.data(), head_.size()); }
    void write_tile(placed_bytes& file, const tile<std::array<double, 3>>& part, cell_origin,
                    std::span<const value_bytes> values = {}) const override
    {
        detail::require_finite(part);
        require_values(part, arrays_, values);
        put_tile(file, part, values);
    }
    [[nodiscard]] std::optional<std::string> difference(offset_file& file, const tile<std::array<double, 3>>& part,
                                                        std::uint32_t,
                                                        std::span<const value_bytes> values = {}) const override
    {
        require_values(part, arrays_, values);
        compared_bytes compared(file);
        put_tile(compared, part, values);
        return detail::named_difference(file, compared);
    }

private:
    /// The names of the properties of vertices and faces so far.
    struct property_names {
        std::set<std::string> of_vertices{"x", "y", "z"}, of_faces{"vertex_indices"};

        /// Adds the name of an array. Errors: mesh_error for a name that is empty or taken.
        void add(const file_array& array)
        {
            const std::string name = ply_name(array.name);
            if (name.empty() or not(array.on == field_on::vertices ? of_vertices : of_faces).insert(name).second)
                throw mesh_error("a field cannot be named \"" + array.name +
                                 "\": the name is empty, or another property of the file has it; give it another "
                                 "one");
        }
    };
    [[nodiscard]] std::uint64_t face_at(std::uint64_t face, std::uint64_t corner) const
    {
        return head_.size() + bytes_of_vertex_ * counts_.vertices + bytes_of_face_ * face + bytes_of_corner_ * corner;
    }
    /// Writes the values of an element one after the other from `at` on.
    void put_values(joined_writes& out, std::uint64_t at, field_on where, std::size_t element,
                    std::span<const value_bytes> values) const
    {
        for (std::size_t i = 0; i < values.size(); ++i)
            if (arrays_[i].on == where)
                out.put(at + place_of_[i], values[i].data() + arrays_[i].bytes * element, arrays_[i].bytes);
    }
    void put_tile(placed_bytes& file, const tile<std::array<double, 3>>& part,
                  std::span<const value_bytes> values) const
    {
        joined_writes out(file);
        const bool has_points_alone = bytes_of_vertex_ == 24;
        const bool has_corners_alone = bytes_of_corner_ == 4 and bytes_of_face_ == 1; // the corner count has one byte
        for_each_owned_run(part.vertex_ids, part.vertex_marks, [&](std::size_t first, global_id id, std::size_t run) {
            std::uint64_t at = head_.size() + bytes_of_vertex_ * id;
            if (has_points_alone)
                return out.put(at, part.mesh.points().data() + first, 24 * run);
            for (std::size_t v = first; v < first + run; ++v, at += bytes_of_vertex_) {
                out.put(at, part.mesh.point(v));
                if (with_normals_)
                    out.put(at + 24, part.normals[v]);
                put_values(out, at, field_on::vertices, v, values);
            }
        });
        out.flush();
        const int degree = part.mesh.topology().degree;
        for_each_owned_run(part.face_ids, part.face_marks, [&](std::size_t first, global_id id, std::size_t run) {
            const std::uint64_t at = face_at(id, part.corner_id(first, 0));
            if (has_corners_alone and degree == 3)
                put_alike_faces<3>(out, at, part, first, run);
            else if (has_corners_alone and degree == 4)
                put_alike_faces<4>(out, at, part, first, run);
            else
                put_faces(out, at, part, first, run, values);
        });
        out.flush();
    }
    /// Writes faces of this degree that have only their vertices, after a corner count of one byte.
    template <std::size_t Degree>
    static void put_alike_faces(joined_writes& out, std::uint64_t at, const tile<std::array<double, 3>>& part,
                                std::size_t first, std::size_t run)
    {
        const std::uint32_t* const vertices = part.mesh.topology().corner_vertex.data() + Degree * first;
        out.store_each<1 + 4 * Degree>(at, run, [&](std::size_t i, char* to) {
            to[0] = char(Degree);
            for (std::size_t k = 0; k < Degree; ++k) {
                const auto number = std::int32_t(part.vertex_ids[vertices[Degree * i + k]]);
                std::memcpy(to + 1 + 4 * k, &number, 4);
            }
        });
    }
    void put_faces(joined_writes& out, std::uint64_t at, const tile<std::array<double, 3>>& part, std::size_t first,
                   std::size_t run, std::span<const value_bytes> values) const
    {
        std::size_t corner = part.mesh.topology().first_corner(first);
        for (std::size_t f = first; f < first + run; ++f) {
            const auto face = part.mesh.face(f);
            require_room(part, f);
            at = put_count(out, at, corners_of_face_, face.size());
            out.put_each(at, face.size(), [&](std::size_t k) { return std::int32_t(part.vertex_ids[face[k]]); });
            at += 4 * face.size();
            if (corners_)
                at = put_corners(out, at, part, f, corner, values[*corners_]);
            if (with_corner_normals_) {
                at = put_count(out, at, normals_of_face_, 3 * face.size());
                out.put(at, part.corner_normals.data() + corner, 24 * face.size());
                at += 24 * face.size();
            }
            put_values(out, at, field_on::faces, f, values);
            at += bytes_of_values_;
            corner += face.size();
        }
    }
    /// Writes the length of a list and returns the offset behind it.
    static std::uint64_t put_count(joined_writes& out, std::uint64_t at, const ply_count& type, std::uint64_t entries)
    {
        static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");
        out.put(at, &entries, type.bytes);
        return at + type.bytes;
    }
    /// Writes the values at the corners of a face and returns the offset behind them.
    std::uint64_t put_corners(joined_writes& out, std::uint64_t at, const tile<std::array<double, 3>>& part,
                              std::size_t face, std::size_t first, value_bytes values) const
    {
        const file_array& array = arrays_[*corners_];
        const std::size_t degree = part.mesh.face(face).size();
        at = put_count(out, at, values_of_face_, array.numbers * degree);
        for (std::size_t c = first; c < first + degree; ++c)
            if (detail::has_nan(array, values.data() + array.bytes * c))
                throw mesh_error("face " + std::to_string(part.face_ids[face]) + " would have no " + array.name +
                                 "; the numbers of the input are too large");
        out.put(at, values.data() + array.bytes * first, array.bytes * degree);
        return at + array.bytes * degree;
    }
    /// Throws mesh_error for a face that is too large for the length types of its lists.
    void require_room(const tile<std::array<double, 3>>& part, std::size_t face) const
    {
        const std::uint64_t in_values = corners_ ? values_of_face_.most / arrays_[*corners_].numbers : UINT64_MAX;
        const std::uint64_t in_normals = with_corner_normals_ ? normals_of_face_.most / 3 : UINT64_MAX;
        const std::uint64_t most = std::min({corners_of_face_.most, in_values, in_normals});
        if (const std::size_t degree = part.mesh.face(face).size(); degree > most)
            throw mesh_error("face " + std::to_string(part.face_ids[face]) + " has " + std::to_string(degree) +
                             " corners, the lists of this file count " + std::to_string(most) +
                             "; give ply_file the largest degree of all faces");
    }

    global_counts counts_;
    bool with_normals_, with_corner_normals_;
    std::vector<file_array> arrays_;
    ply_count corners_of_face_, normals_of_face_, values_of_face_{}; // types of the lengths of lists
    std::vector<std::uint64_t> place_of_; // offset of each array within the values of an element
    std::optional<std::size_t> corners_;  // index of the array on corners
    std::uint64_t bytes_of_vertex_ = 0, bytes_of_values_ = 0, bytes_of_corner_ = 0, bytes_of_face_ = 0;
    std::string head_;
};

} // namespace kith
