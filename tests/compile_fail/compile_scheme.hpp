// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine.hpp>

using namespace kith::targets;

template <class Text>
struct scheme_of {
    Text text;

    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge),
                             kith::new_faces(triangles(kith::per_face)));
    }
    void operator()(const auto& r) const { text(r.coarse, r.assoc); }
};

/// Has a scheme with this text compiled: text(coarse, assoc).
template <class Text>
void compile_scheme(const Text& text)
{
    kith::refine(kith::basic_mesh<>(), scheme_of<Text>{text}, 1);
}
