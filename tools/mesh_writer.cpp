// SPDX-License-Identifier: BSD-3-Clause
#include "errors.hpp"
#include "mesh_file.hpp"
#include "mesh_format.hpp"
#include "output_file.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace kith::tool {

namespace {

using point = CGAL::Simple_cartesian<double>::Point_3;

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

} // namespace

void write_mesh_file(const std::string& path, const basic_mesh<>& mesh, bool binary)
{
    const mesh_format format = format_of(path);
    require_writable(format, mesh, path);
    const auto write = [&](std::ostream& out) {
        out.precision(std::numeric_limits<double>::max_digits10);
        CGAL::IO::set_mode(out, binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
        if (not write_by_format(format, out, mesh))
            out.setstate(std::ios::failbit);
    };
    if (path == standard_stream) {
        write(std::cout);
        if (not std::cout.flush())
            throw file_error("standard output: could not be written completely");
        return;
    }
    output_file file(path);
    write(file.stream());
    file.commit();
}

} // namespace kith::tool
