// SPDX-License-Identifier: BSD-3-Clause
#include "errors.hpp"
#include "file_guard.hpp"
#include "input_file.hpp"
#include "mesh_file.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/OFF/generic_copy_OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace kith::tool {

namespace {

using point = CGAL::Simple_cartesian<double>::Point_3;
using input = boost::iostreams::stream<boost::iostreams::array_source>;

/// What CGAL's scan of an OFF file hands over. CGAL's own soup reader is not used for OFF, as it reads past the end of
/// lines that lack the colors or texture coordinates of the lines before.
class off_collector {
public:
    explicit off_collector(polygon_soup& soup) : soup_(&soup) {}

    template <class Stream>
    void write_header(Stream&, std::size_t vertices, std::size_t, std::size_t faces)
    {
        soup_->points.reserve(vertices);
        soup_->faces.first.reserve(faces + 1);
    }
    void write_vertex(double x, double y, double z) { soup_->points.push_back({x, y, z}); }
    void write_facet_header() const {}
    void write_facet_begin(std::size_t) const {}
    void write_facet_vertex_index(std::size_t vertex) { soup_->faces.vertices.push_back(vertex); }
    void write_facet_end() { soup_->faces.first.push_back(soup_->faces.vertices.size()); }
    void write_footer() const {}

private:
    polygon_soup* soup_;
};

bool read_off(input& in, const file_contents& contents, polygon_soup& soup)
{
    CGAL::File_header_OFF header(contents.vertices, 0, contents.faces, false, false, false, false);
    header.set_homogeneous(contents.homogeneous);
    CGAL::File_scanner_OFF scanner(in, header);
    off_collector collector(soup);
    CGAL::generic_copy_OFF(scanner, soup, collector);
    return not in.bad();
}

template <class Read>
bool read_soup(input& in, polygon_soup& soup, const Read& read)
{
    std::vector<point> points;
    std::vector<std::vector<std::size_t>> faces;
    const bool good = read(in, points, faces);
    soup.points.reserve(points.size());
    for (const point& p : points)
        soup.points.push_back({p.x(), p.y(), p.z()});
    soup.faces = face_list(faces);
    return good;
}

bool read_by_format(mesh_format format, input& in, const file_contents& contents, polygon_soup& soup)
{
    const auto obj = [](auto& stream, auto& points, auto& faces) { return CGAL::IO::read_OBJ(stream, points, faces); };
    const auto ply = [](auto& stream, auto& points, auto& faces) { return CGAL::IO::read_PLY(stream, points, faces); };
    const auto stl = [](auto& stream, auto& points, auto& faces) { return CGAL::IO::read_STL(stream, points, faces); };
    switch (format) {
    case mesh_format::obj: return read_soup(in, soup, obj);
    case mesh_format::ply: return read_soup(in, soup, ply);
    case mesh_format::stl: return read_soup(in, soup, stl);
    default: in.seekg(std::streamoff(contents.data_begin)); return read_off(in, contents, soup);
    }
}

} // namespace

polygon_soup read_mesh_file(const std::string& path)
{
    const mesh_format format = format_of(path);
    const std::string name = path == standard_stream ? "standard input" : path;
    std::string bytes = read_bytes(path);
    file_contents contents;
    try {
        contents = guard(format, bytes);
    } catch (const file_error& error) {
        throw file_error(name + ": " + error.what());
    }
    input in(bytes.data(), bytes.size());
    CGAL::IO::set_mode(in, contents.binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
    polygon_soup soup;
    soup.tags = contents.tags;
    const bool good = read_by_format(format, in, contents, soup);
    const bool vertices_agree = format == mesh_format::stl ? soup.points.size() <= contents.vertices
                                                           : soup.points.size() == contents.vertices;
    if (not good or not vertices_agree or soup.faces.size() != contents.faces or
        soup.faces.vertices.size() != contents.corners)
        throw file_error(name + ": was not read completely: " + std::to_string(soup.points.size()) + " of " +
                         std::to_string(contents.vertices) + " vertices and " + std::to_string(soup.faces.size()) +
                         " of " + std::to_string(contents.faces) + " faces");
    return soup;
}

} // namespace kith::tool
