// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/numbering/step/refinement.hpp>
#include <kith/numbering/step/step.hpp>

#include <cstdint>
#include <utility>
#include <vector>

/// A scheme made from its columns and its text, text(coarse, assoc). It is checked like every scheme of a user.
template <class Columns, class Text>
struct own_scheme {
    Columns declared;
    Text text;

    own_scheme(Columns declared, Text text) : declared(std::move(declared)), text(std::move(text)) {}

    [[nodiscard]] auto columns() const { return declared; }
    template <class R>
    void operator()(const R& r) const
    {
        text(r.coarse, r.assoc);
    }
};

/// Returns the points that one step makes by text(coarse, assoc). The scheme declares faces, but makes none.
template <class Vertices, class Text>
std::vector<shapes::point> make_vertices(const mesh3d& mesh, const Vertices& vertices, const Text& text)
{
    using level = kith::level_of<mesh3d>;
    const own_scheme scheme(kith::columns(vertices, kith::new_faces(quads(kith::per_face))), text);
    const level coarse(mesh);
    const kith::numbering_of<decltype(scheme), std::uint32_t> ids(coarse, scheme.columns());
    kith::point_values<level> values;
    kith::run_scheme<kith::connect::nothing, true>(coarse, scheme, 0, ids, scheme.columns(), values);
    const auto made = values.take();
    return {made.begin(), made.end()};
}
