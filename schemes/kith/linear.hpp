// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/require_faces.hpp>
#include <kith/schemes/split/triangle_split.hpp>

namespace kith {

/// The linear split of polygons: midpoints and centroids; no vertex moves. After one step all faces are quads. C0.
/// Cost: O(corners).
struct linear {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "linear",
                             .trusted = true,
                             .reach = [](int rings) { return rings / 2 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        quad_split::connect(r);
    }
};

/// The linear split of triangles into four. C0. Cost: O(corners).
struct linear_triangles {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "linear-triangles",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = three_faces_at_vertices,
                             .reach = [](int rings) { return rings / 2 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return triangle_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        triangle_split::connect(r);
    }
};

} // namespace kith
#define KITH_SCHEME linear
#include <kith/schemes/compiled/in_library.hpp>
#define KITH_SCHEME linear_triangles
#include <kith/schemes/compiled/in_library.hpp>
