// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_text.hpp"
#include "own_scheme.hpp"

#include <string>

/// Returns the error of a scheme that declares a vertex per vertex and a quad per face. The given text runs instead of
/// a text that copies them.
template <class Edges, class Text>
std::string fault(const shapes::shape& shape, const Edges& edges, const Text& text)
{
    const kith::new_vertices vertices(kith::per_vertex);
    const kith::new_faces faces(quads(kith::per_face));
    const own_scheme scheme(kith::columns(vertices, edges, faces), text);
    return error_text<kith::association_error>([&] {
        kith::numbering_of<decltype(scheme), std::uint32_t> ids;
        kith::refine_mesh<kith::connect::everything>(native(shape), scheme, ids);
    });
}

inline constexpr auto copy_vertices = [](const auto& coarse, const auto& assoc) {
    for (auto v : coarse.vertices())
        assoc(v, kith::targets::V) = v;
};
inline constexpr auto copy_faces = [](const auto& coarse, const auto& assoc) {
    for (auto f : coarse.faces())
        assoc(f, kith::targets::F) = polygon(assoc(f.vertices(), kith::targets::V));
};
