// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repair_options.hpp"
#include "repair_report.hpp"

#include <kith/core/base/in_library.hpp>
#include <kith/core/mesh/make_mesh.hpp>

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#ifdef KITH_HAS_BODIES

namespace kith::detail {

/// The faces during a repair, and the original elements from which they come.
struct mended_soup {
    static constexpr std::size_t none = std::size_t(-1);

    mended_soup(std::size_t vertices, const face_list& all, const repair_options& how, std::size_t first_number)
        : options(how)
        , faces(all)
        , from_face(all.size())
        , from_corner(all.vertices.size())
        , kept_as(all.vertices.size())
        , from_vertex(vertices)
        , is_joined(vertices, false)
        , report(first_number)
    {
        for (auto* numbers : {&from_face, &from_corner, &kept_as, &from_vertex})
            std::iota(numbers->begin(), numbers->end(), std::size_t(0));
    }

    /// Returns the number of a vertex in messages.
    [[nodiscard]] std::string number(std::size_t vertex) const { return report.number(from_vertex[vertex]); }

    /// Rebuilds the faces: f(face, corners) may change the corners of a face, and returns true if the face stays.
    template <class F>
    void remake(const F& f)
    {
        face_list made;
        std::vector<std::size_t> from_face_now, from_corner_now, corners;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            corners.resize(faces[face].size());
            std::iota(corners.begin(), corners.end(), faces.first[face]);
            if (not f(face, corners))
                continue;
            for (const std::size_t c : corners) {
                made.vertices.push_back(faces.vertices[c]);
                from_corner_now.push_back(from_corner[c]);
            }
            made.first.push_back(made.vertices.size());
            from_face_now.push_back(from_face[face]);
        }
        faces = std::move(made);
        from_face = std::move(from_face_now);
        from_corner = std::move(from_corner_now);
    }
    void drop_marked(const std::vector<bool>& is_dropped)
    {
        remake([&](std::size_t face, const auto&) { return not is_dropped[face]; });
    }

    repair_options options;
    face_list faces;
    std::vector<std::size_t> from_face, from_corner; ///< the numbers in the original
    std::vector<std::size_t> kept_as;                ///< by original corner: the corner that stands for it
    std::vector<std::size_t> from_vertex;            ///< also for new vertices, which come last
    std::vector<bool> is_joined;                     ///< true if the vertex was joined with another one
    repair_report report;
};

} // namespace kith::detail

#endif
