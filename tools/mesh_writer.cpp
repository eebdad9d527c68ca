// SPDX-License-Identifier: BSD-3-Clause
#include "errors.hpp"
#include "mesh_file.hpp"
#include "mesh_format.hpp"

#include <kith/cgal.hpp>
#include <kith/output_file.hpp>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::tool {

namespace {

using point = CGAL::Simple_cartesian<double>::Point_3;
using vector = CGAL::Simple_cartesian<double>::Vector_3;
using normal_list = std::span<const std::array<double, 3>>;

/// The faces of a mesh in the form that CGAL's writers take.
class face_range {
public:
    using value_type = std::span<const std::uint32_t>;

    /// Keeps the face it points to, because some writers hold on to a reference.
    class const_iterator {
    public:
        using iterator_category = std::random_access_iterator_tag;
        using value_type = face_range::value_type;
        using difference_type = std::ptrdiff_t;
        using pointer = const value_type*;
        using reference = const value_type&;

        const_iterator(const basic_mesh<>& mesh, std::size_t face) : mesh_(&mesh), face_(face) {}
        reference operator*() const { return current_ = mesh_->face(face_); }
        const_iterator& operator++()
        {
            ++face_;
            return *this;
        }
        friend const_iterator operator+(const const_iterator& i, std::size_t n) { return {*i.mesh_, i.face_ + n}; }
        friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.face_ == b.face_; }

    private:
        const basic_mesh<>* mesh_;
        std::size_t face_;
        mutable value_type current_;
    };
    using iterator = const_iterator;

    explicit face_range(const basic_mesh<>& mesh) : mesh_(&mesh) {}
    [[nodiscard]] std::size_t size() const { return mesh_->face_count(); }
    [[nodiscard]] value_type operator[](std::size_t face) const { return mesh_->face(face); }
    [[nodiscard]] const_iterator begin() const { return {*mesh_, 0}; }
    [[nodiscard]] const_iterator end() const { return {*mesh_, size()}; }

private:
    const basic_mesh<>* mesh_;
};

/// Refuses faces that a format has no room for, and places that no format can tell, before anything is written.
void require_writable(mesh_format format, const basic_mesh<>& mesh, const std::string& path)
{
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (not std::ranges::all_of(mesh.point(v), [](double x) { return std::isfinite(x); }))
            throw file_error(path + ": vertex " + std::to_string(v) +
                             " would have no finite place; the coordinates of the input are too large");
    const std::size_t most = format == mesh_format::stl   ? 3
                             : format == mesh_format::ply ? std::numeric_limits<unsigned char>::max()
                                                          : mesh.vertex_count();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (mesh.face(f).size() > most)
            throw file_error(path + ": face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                             " corners, this format holds " + std::to_string(most) + " at most; choose .off or .obj");
}

bool write_by_format(mesh_format format, std::ostream& out, const basic_mesh<>& mesh)
{
    std::vector<point> points;
    points.reserve(mesh.vertex_count());
    for (const auto& p : mesh.points())
        points.emplace_back(p[0], p[1], p[2]);
    const face_range faces(mesh);
    switch (format) {
    case mesh_format::obj: return CGAL::IO::write_OBJ(out, points, faces);
    case mesh_format::ply: return CGAL::IO::write_PLY(out, points, faces);
    case mesh_format::stl: return CGAL::IO::write_STL(out, points, faces);
    default: return CGAL::IO::write_OFF(out, points, faces);
    }
}

/// CGAL's writer of OBJ, which does not say in the faces that the corners have normals.
struct obj_writer : CGAL::File_writer_wavefront {
    void write_facet_vertex_index(std::size_t index) { out() << ' ' << index + 1 << "//" << index + 1; }
};

template <class Writer>
void write_with_normals(Writer writer, std::ostream& out, const basic_mesh<>& mesh, normal_list normals)
{
    constexpr bool has_colors = false, has_normals = true;
    writer.write_header(out, mesh.vertex_count(), 0, mesh.face_count(), has_colors, has_normals);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto& p = mesh.point(v);
        const auto& n = normals[v];
        writer.write_vertex(p[0], p[1], p[2]);
        writer.write_vertex_normal(n[0], n[1], n[2]);
    }
    writer.write_facet_header();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        writer.write_facet_begin(mesh.face(f).size());
        for (const auto v : mesh.face(f))
            writer.write_facet_vertex_index(v);
        writer.write_facet_end();
    }
    writer.write_footer();
}

/// CGAL writes the normals of a PLY file for its own mesh only.
bool write_ply_with_normals(std::ostream& out, const basic_mesh<>& mesh, normal_list normals)
{
    storage<point> points(mesh.vertex_count());
    std::ranges::transform(mesh.points(), points.begin(), [](const auto& p) { return point(p[0], p[1], p[2]); });
    auto copy = mesh_traits<CGAL::Surface_mesh<point>>::build({std::move(points), mesh.topology(), 0});
    auto property = copy.add_property_map<CGAL::SM_Vertex_index, vector>("v:normal").first;
    for (const auto v : copy.vertices())
        property[v] = {normals[v][0], normals[v][1], normals[v][2]};
    return CGAL::IO::write_PLY(out, copy);
}

bool write_by_format(mesh_format format, std::ostream& out, const basic_mesh<>& mesh, normal_list normals)
{
    switch (format) {
    case mesh_format::obj: write_with_normals(obj_writer(), out, mesh, normals); return true;
    case mesh_format::ply: return write_ply_with_normals(out, mesh, normals);
    case mesh_format::off: write_with_normals(CGAL::File_writer_OFF(), out, mesh, normals); return true;
    default: return write_by_format(format, out, mesh);
    }
}

} // namespace

void write_mesh_file(const std::string& path, const basic_mesh<>& mesh, bool binary, normal_list normals)
{
    const mesh_format format = format_of(path);
    require_writable(format, mesh, path);
    const auto write = [&](std::ostream& out) {
        out.precision(std::numeric_limits<double>::max_digits10);
        CGAL::IO::set_mode(out, binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
        const bool written = normals.empty() ? write_by_format(format, out, mesh)
                                             : write_by_format(format, out, mesh, normals);
        if (not written)
            out.setstate(std::ios::failbit);
    };
    if (path == standard_stream) {
        write(std::cout);
        if (not std::cout.flush())
            throw file_error("standard output: could not be written completely");
        return;
    }
    io::output_file file(path);
    write(file.stream());
    file.commit();
}

} // namespace kith::tool
