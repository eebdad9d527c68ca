// SPDX-License-Identifier: BSD-3-Clause
// A scheme of a user's own, with a MEMBER or TRAITS that are not as they should be.
#ifdef ON_RANKS
#include <kith/refine_by_exchange.hpp>
#include <kith/refine_on_ranks.hpp>
#endif
#include <kith/refine_in_tiles.hpp>

#ifndef MEMBER
#define MEMBER static_assert(true)
#endif
#ifndef TRAITS
#define TRAITS
#endif

namespace {

int reach(int rings);

struct no_after {};
struct with_after {
    template <class Level, class Numbering>
    [[nodiscard]] with_after after(const Level&, const Numbering&) const;
};
struct with_part : with_after {
    template <class Level, class Numbering>
    [[nodiscard]] with_part after(const Level&, const Numbering&) const;
    template <class Part>
    [[nodiscard]] with_part of_part(const Part&) const;
};
struct with_message : with_part {
    template <class Level, class Numbering>
    [[nodiscard]] with_message after(const Level&, const Numbering&) const;
    template <class Part>
    [[nodiscard]] with_message of_part(const Part&) const;
    template <class Out>
    void pack(Out&) const;
    template <class In>
    void unpack(In&);
};

struct own {
    no_after one;
    with_after two;
    with_part three;
    with_message four;
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
#if defined EXCHANGE
    kith::mpi::communicator comm(MPI_COMM_WORLD);
    kith::mpi::exchanging_refinement(comm, mesh, own(), {{}, 1}, 1).refine();
#elif defined ON_RANKS
    kith::mpi::communicator comm(MPI_COMM_WORLD);
    kith::mpi::rank_refinement refinement(comm, mesh, own(), 1, {{}, 1});
#elif defined TILES
    kith::tiled_refinement refinement(mesh, own(), 1, {{}, 1});
    refinement.refine(0);
#else
    kith::refine(mesh, own(), 1);
#endif
}
