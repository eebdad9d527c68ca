// SPDX-License-Identifier: BSD-3-Clause
#include "compile_scheme.hpp"

struct without_faces {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_edges(kith::per_end));
    }
    void operator()(const auto&) const {}
};

int main()
{
    kith::refine(kith::basic_mesh<>(), without_faces(), 1);
}
