// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/boundary.hpp>
#include <kith/creases.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace kith::tool {

/// What an OBJ file says about sharp edges, sharp vertices and holes in lines `t ...`, as OpenSubdiv's test files have
/// them.
struct mesh_tags {
    struct edge {
        std::size_t from = 0;
        std::size_t to = 0;
        double sharpness = 0;
    };

    std::vector<edge> edges;
    std::vector<std::pair<std::size_t, double>> vertices;
    std::vector<std::size_t> holes; ///< faces
    bool boundary_is_hole = false;  ///< the faces at the boundary, too
    std::optional<boundary_corner> corners;
    std::optional<crease_method> method;
    std::size_t unread = 0; ///< lines that mean something else

    [[nodiscard]] bool has_creases() const { return not edges.empty() or not vertices.empty(); }
};

/// The creases of these tags on a mesh. Errors: mesh_error for an edge or vertex that the mesh does not have.
creases creases_of(const mesh_tags& tags, const basic_mesh<>& mesh);

} // namespace kith::tool
