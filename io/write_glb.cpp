// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <kith/io/text/file_error.hpp>

#ifdef KITH_HAS_JSON
#include <nlohmann/json.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

using float_point = std::array<float, 3>;

/// The values in which the corners at a vertex may differ: a texture coordinate and a normal.
using corner_values = std::array<double, 5>;

/// The vertices of a file of glTF. They are the vertices of the mesh under their numbers, then copies of those whose
/// corners have different values.
struct glb_vertices {
    std::vector<std::uint32_t> of_corners; ///< the vertex of each corner
    std::vector<std::size_t> corners;      ///< a corner of each vertex
};

/// Returns the vertices of a file in which all corners at a vertex are alike. Cost: O(corners).
glb_vertices same_vertices(const basic_mesh<>& mesh)
{
    const auto& vertex_of = mesh.topology().corner_vertex;
    glb_vertices result{{vertex_of.begin(), vertex_of.end()}, std::vector<std::size_t>(mesh.vertex_count())};
    for (std::size_t corner = 0; corner < mesh.corner_count(); ++corner)
        result.corners[vertex_of[corner]] = corner;
    return result;
}
/// Returns the vertices of a file if values_of(corner) are the values of a corner of the mesh. Cost: O(corners log
/// corners).
template <class Values>
glb_vertices split_vertices(const basic_mesh<>& mesh, const Values& values_of)
{
    const auto& vertex_of = mesh.topology().corner_vertex;
    std::vector<std::size_t> sorted(mesh.corner_count());
    std::iota(sorted.begin(), sorted.end(), std::size_t(0));
    const auto key = [&](std::size_t corner) { return std::pair(vertex_of[corner], values_of(corner)); };
    std::ranges::stable_sort(sorted, {}, key);
    glb_vertices result{std::vector<std::uint32_t>(sorted.size()), std::vector<std::size_t>(mesh.vertex_count())};
    std::uint32_t vertex = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const std::size_t corner = sorted[i];
        if (i == 0 or vertex_of[sorted[i - 1]] != vertex_of[corner]) {
            vertex = vertex_of[corner];
            result.corners[vertex] = corner;
        } else if (key(sorted[i - 1]) != key(corner)) {
            vertex = std::uint32_t(result.corners.size());
            result.corners.push_back(corner);
        }
        result.of_corners[corner] = vertex;
    }
    return result;
}

/// Returns the value of an attribute as a finite number: 0 where there is none.
double number_of(const attribute& a, std::size_t element)
{
    return std::isnan(a.values[element]) ? 0 : a.values[element];
}

/// Returns a channel of a colour in proportion to the light, as glTF has it, not to its perception (sRGB).
float linear_light(double channel)
{
    const double bounded = std::clamp(channel, 0., 1.);
    return float(bounded <= 0.04045 ? bounded / 12.92 : std::pow((bounded + 0.055) / 1.055, 2.4));
}

/// Returns a vector of length 1 in the direction of another one, or upward if that is zero: glTF has no other normals.
float_point unit_vector(const std::array<double, 3>& n)
{
    const double length = std::hypot(n[0], n[1], n[2]);
    return length > 0 ? float_point{float(n[0] / length), float(n[1] / length), float(n[2] / length)}
                      : float_point{0, 0, 1};
}

#ifdef KITH_HAS_JSON

constexpr std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max(); // lengths have 32 bits

/// A writer of glTF's binary files: a head in JSON that says where each array begins, then the arrays.
class glb_writer {
public:
    glb_writer(std::ostream& out, const written_mesh& what)
        : out_(out)
        , what_(what)
        , held_(held_by(mesh_format::glb, what))
        , vertices_(has_corner_normals() or not held_.corner_textures.empty()
                        ? split_vertices(what.mesh, [&](std::size_t corner) { return values_at(corner); })
                        : same_vertices(what.mesh))
    {
    }

    void write()
    {
        sort_triangles();
        describe();
        std::string head = json_.dump();
        head.resize((head.size() + 3) / 4 * 4, ' ');
        const std::uint64_t bytes = 12 + 8 + head.size() + 8 + bytes_;
        if (bytes > most_bytes)
            throw file_error("would have " + std::to_string(bytes) + " bytes, more than .glb can hold; choose .ply");
        constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
        out_ << text_block().raw(magic).raw(version).raw(std::uint32_t(bytes)).text();
        out_ << text_block().raw(std::uint32_t(head.size())).raw(json_chunk).text() << head;
        out_ << text_block().raw(std::uint32_t(bytes_)).raw(binary_chunk).text();
        write_arrays();
    }

private:
    using json = nlohmann::ordered_json;

    [[nodiscard]] corner_values values_at(std::size_t corner) const
    {
        corner_values result{};
        for (std::size_t i = 0; i < held_.corner_textures.size(); ++i)
            result[i] = number_of(*held_.corner_textures[i], corner);
        for (std::size_t i = 0; i < held_.corner_normals.size(); ++i)
            result[2 + i] = number_of(*held_.corner_normals[i], corner);
        if (not what_.corner_normals.empty())
            std::ranges::copy(what_.corner_normals[corner], result.begin() + 2);
        return result;
    }
    [[nodiscard]] std::size_t mesh_vertex(std::size_t vertex) const
    {
        return what_.mesh.topology().corner_vertex[vertices_.corners[vertex]];
    }
    [[nodiscard]] bool has_corner_normals() const
    {
        return not what_.corner_normals.empty() or not held_.corner_normals.empty();
    }
    [[nodiscard]] bool has_normals() const
    {
        return has_corner_normals() or not what_.normals.empty() or not held_.normals.empty();
    }
    [[nodiscard]] bool has_textures() const { return not held_.corner_textures.empty() or not held_.textures.empty(); }

    [[nodiscard]] float_point point(std::size_t vertex) const
    {
        const auto& p = what_.mesh.point(mesh_vertex(vertex));
        return {float(p[0]), float(p[1]), float(p[2])};
    }
    [[nodiscard]] float_point normal(std::size_t vertex) const
    {
        if (has_corner_normals()) {
            const corner_values values = values_at(vertices_.corners[vertex]);
            return unit_vector({values[2], values[3], values[4]});
        }
        const std::size_t v = mesh_vertex(vertex);
        if (not what_.normals.empty())
            return unit_vector(what_.normals[v]);
        return unit_vector(
            {number_of(*held_.normals[0], v), number_of(*held_.normals[1], v), number_of(*held_.normals[2], v)});
    }
    /// Returns the texture coordinate of a vertex. In glTF the second one grows downward, in all other formats upward.
    [[nodiscard]] std::array<float, 2> texture(std::size_t vertex) const
    {
        const bool is_of_corners = not held_.corner_textures.empty();
        const attribute_list& list = is_of_corners ? held_.corner_textures : held_.textures;
        const std::size_t element = is_of_corners ? vertices_.corners[vertex] : mesh_vertex(vertex);
        return {float(number_of(*list[0], element)), float(1 - number_of(*list[1], element))};
    }
    [[nodiscard]] std::array<float, 4> color(std::size_t vertex) const
    {
        const std::size_t v = mesh_vertex(vertex);
        std::array<float, 4> result{0, 0, 0, 1};
        for (std::size_t i = 0; i < held_.colors.size(); ++i) {
            const double channel = number_of(*held_.colors[i], v) / color_unit(held_.colors[i]->type);
            result[i] = i < 3 ? linear_light(channel) : float(std::clamp(channel, 0., 1.));
        }
        return result;
    }

    /// Lists the faces of each material, one after the other, and counts their triangles.
    void sort_triangles()
    {
        const auto& mesh = what_.mesh;
        const std::size_t materials = held_.labels.empty() ? 1 : held_.labels[0]->labels.size();
        const auto material_of = [&](std::size_t face) {
            return held_.labels.empty() ? 0 : std::size_t(number_of(*held_.labels[0], face));
        };
        faces_.resize(mesh.face_count());
        std::iota(faces_.begin(), faces_.end(), std::size_t(0));
        if (materials > 1)
            std::ranges::stable_sort(faces_, {}, material_of);
        triangles_.assign(materials, 0);
        for (std::size_t face = 0; face < mesh.face_count(); ++face)
            triangles_[material_of(face)] += mesh.face(face).size() - 2;
    }

    /// Adds an array of `count` elements of numbers of 4 bytes to the head. Returns the number of its accessor.
    std::size_t add_array(const char* type, std::size_t numbers, std::size_t count, bool is_of_indices,
                          const json& more = json::object())
    {
        constexpr int unsigned_int = 5125, real = 5126, array_buffer = 34962, element_array_buffer = 34963;
        const std::uint64_t size = std::uint64_t(4) * numbers * count;
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", bytes_},
                                        {"byteLength", size},
                                        {"target", is_of_indices ? element_array_buffer : array_buffer}});
        json accessor{{"bufferView", json_["bufferViews"].size() - 1},
                      {"componentType", is_of_indices ? unsigned_int : real},
                      {"count", count},
                      {"type", type}};
        accessor.update(more);
        json_["accessors"].push_back(std::move(accessor));
        bytes_ += size;
        return json_["accessors"].size() - 1;
    }
    [[nodiscard]] json bounds() const
    {
        float_point least = point(0), most = least;
        for (std::size_t v = 1; v < vertices_.corners.size(); ++v)
            for (std::size_t i = 0; i < 3; ++i) {
                least[i] = std::min(least[i], point(v)[i]);
                most[i] = std::max(most[i], point(v)[i]);
            }
        return {{"min", least}, {"max", most}};
    }
    /// Makes the head, with a part of the mesh for each material that faces have.
    void describe()
    {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "kith"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", {0}}}}},
                 {"nodes", {{{"mesh", 0}}}}};
        if (what_.mesh.face_count() == 0)
            return;
        const std::size_t vertices = vertices_.corners.size();
        json attributes{{"POSITION", add_array("VEC3", 3, vertices, false, bounds())}};
        if (has_normals())
            attributes["NORMAL"] = add_array("VEC3", 3, vertices, false);
        if (has_textures())
            attributes["TEXCOORD_0"] = add_array("VEC2", 2, vertices, false);
        if (not held_.colors.empty())
            attributes["COLOR_0"] = add_array("VEC4", 4, vertices, false);
        json parts = json::array();
        for (std::size_t material = 0; material < triangles_.size(); ++material) {
            if (triangles_[material] == 0)
                continue;
            json part{{"attributes", attributes}, {"indices", add_array("SCALAR", 1, 3 * triangles_[material], true)}};
            if (material != 0) {
                json_["materials"].push_back({{"name", held_.labels[0]->labels[material]}, {"doubleSided", true}});
                part["material"] = json_["materials"].size() - 1;
            }
            parts.push_back(std::move(part));
        }
        json_["meshes"] = {{{"primitives", std::move(parts)}}};
        json_["buffers"] = {{{"byteLength", bytes_}}};
    }

    void write_arrays()
    {
        const std::size_t vertices = vertices_.corners.size();
        write_blocks(out_, vertices, [&](text_block& bytes, std::size_t v) { bytes.raw(point(v)); });
        if (has_normals())
            write_blocks(out_, vertices, [&](text_block& bytes, std::size_t v) { bytes.raw(normal(v)); });
        if (has_textures())
            write_blocks(out_, vertices, [&](text_block& bytes, std::size_t v) { bytes.raw(texture(v)); });
        if (not held_.colors.empty())
            write_blocks(out_, vertices, [&](text_block& bytes, std::size_t v) { bytes.raw(color(v)); });
        const auto& mesh = what_.mesh;
        write_blocks(out_, faces_.size(), [&](text_block& bytes, std::size_t i) {
            const std::uint32_t* const corners = vertices_.of_corners.data() + mesh.topology().first_corner(faces_[i]);
            for (std::size_t k = 2; k < mesh.face(faces_[i]).size(); ++k)
                bytes.raw(corners[0]).raw(corners[k - 1]).raw(corners[k]);
        });
    }

    std::ostream& out_;
    const written_mesh& what_;
    held_attributes held_;
    glb_vertices vertices_;
    std::vector<std::size_t> faces_;     // material by material
    std::vector<std::size_t> triangles_; // of each material; number 0 is that of faces without a material
    json json_;
    std::uint64_t bytes_ = 0; // of the arrays
};

void write_glb(std::ostream& out, const written_mesh& what)
{
    glb_writer(out, what).write();
}

#else

void write_glb(std::ostream&, const written_mesh&)
{
    throw file_error("this library was built without nlohmann-json, which .glb needs; choose .ply, or build it again");
}

#endif

void require_for_glb(const written_mesh& what)
{
    require_float_points(what, ".glb; write .vtp, .off, .obj or .ply");
    require_finite_normals(what);
    require_finite_corner_normals(what);
    require_finite_values(mesh_format::glb, what);
}

held_attributes held_by_glb(const mesh_attributes& all, bool)
{
    held_attributes result;
    result.colors = held_list(all.vertices, color_names, 3, 4);
    result.corner_normals = held_list(all.corners, normal_names, 3, 3);
    result.corner_textures = held_list(all.corners, texture_names, 2, 2);
    if (result.corner_normals.empty())
        result.normals = held_list(all.vertices, normal_names, 3, 3);
    if (result.corner_textures.empty())
        result.textures = held_list(all.vertices, texture_names, 2, 2);
    result.labels = held_if(all.faces, [](const attribute& a) { return shared_name(a.name) == "material"; });
    return result;
}

element_attributes zeros_in_glb(const mesh_attributes&, const held_attributes& held)
{
    element_attributes result{held.colors, {}};
    result.vertices.insert(result.vertices.end(), held.textures.begin(), held.textures.end());
    return result;
}

} // namespace

extern const file_format glb_format{.format = mesh_format::glb,
                                    .extension = ".glb",
                                    .contents = {.corner_normals = true, .isolated_points = false},
                                    .write = write_glb,
                                    .require = require_for_glb,
                                    .held = held_by_glb,
                                    .zeros = zeros_in_glb};

} // namespace kith::io
