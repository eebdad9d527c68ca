// SPDX-License-Identifier: BSD-3-Clause
#include <kith/attributes_of.hpp>

#include <algorithm>
#include <cstddef>

namespace kith::io {

mesh_attributes attributes_of(const polygon_soup& soup, const basic_mesh<>& mesh)
{
    mesh_attributes result = soup.attributes;
    for (std::size_t f = 0; not result.corners.empty() and f < mesh.face_count(); ++f) {
        const auto face = soup.faces[f];
        const auto turn = std::ranges::find(face, mesh.face(f)[0]) - face.begin();
        for (attribute& a : result.corners) {
            const auto first = a.values.begin() + std::ptrdiff_t(soup.faces.first[f]);
            std::rotate(first, first + turn, first + std::ptrdiff_t(face.size()));
        }
    }
    return result;
}

} // namespace kith::io
