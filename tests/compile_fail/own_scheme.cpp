// SPDX-License-Identifier: BSD-3-Clause
// A scheme of a user's own, with a MEMBER or TRAITS that are not as they should be.
#include <kith/refine_in_tiles.hpp>

#ifndef MEMBER
#define MEMBER static_assert(true)
#endif
#ifndef TRAITS
#define TRAITS
#endif

namespace {

struct only_after {
    template <class Level, class Numbering>
    [[nodiscard]] only_after after(const Level&, const Numbering&) const
    {
        return {};
    }
};
struct no_after {};

struct own {
    only_after level;
    no_after constant;
    MEMBER;
#ifndef NO_TRAITS
    static constexpr auto traits() { return kith::scheme_traits{TRAITS}; }
#endif
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
#ifndef NO_EDGES
                             kith::new_edges(kith::per_end, kith::per_side),
#endif
                             kith::new_faces(quads(kith::per_corner)));
    }
    template <class R>
    void operator()(const R&) const
    {
    }
};

} // namespace

int main()
{
    const kith::basic_mesh<> mesh;
#ifdef TILES
    kith::tiled_refinement refinement(mesh, own(), 1, {{}, 1});
    refinement.refine(0);
#else
    kith::refine(mesh, own(), 1);
#endif
}
