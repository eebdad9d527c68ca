// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <kith/format/facet_normal.hpp>
#include <kith/text/text_writer.hpp>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>

namespace kith::io {

void write_stl(std::ostream& out, const written_mesh& what)
{
    const basic_mesh<>& mesh = what.mesh;
    const auto normal = [&](std::size_t f) {
        const auto face = mesh.face(f);
        return facet_normal(mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2]));
    };
    if (what.binary) {
        std::string header = "binary STL written by kith"; // not "solid", which begins a text
        header.resize(80, ' ');
        out << header;
        out << text_block().raw(std::uint32_t(mesh.face_count())).text();
        write_blocks(out, mesh.face_count(), [&](text_block& text, std::size_t f) {
            const auto add = [&](const std::array<double, 3>& p) {
                text.raw(std::array<float, 3>{float(p[0]), float(p[1]), float(p[2])});
            };
            add(normal(f));
            for (const auto v : mesh.face(f))
                add(mesh.point(v));
            text.raw(std::uint16_t(0));
        });
        return;
    }
    out << "solid kith\n";
    write_blocks(out, mesh.face_count(), [&](text_block& text, std::size_t f) {
        text << "facet normal " << normal(f) << "\nouter loop\n";
        for (const auto v : mesh.face(f))
            text << "vertex " << mesh.point(v) << '\n';
        text << "endloop\nendfacet\n";
    });
    out << "endsolid kith\n";
}

} // namespace kith::io
