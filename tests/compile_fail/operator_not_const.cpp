// SPDX-License-Identifier: BSD-3-Clause
#include <kith/refine.hpp>

struct scheme {
    static auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_faces(quads(kith::per_face)));
    }
    void operator()(const auto&) {}
};

int main()
{
    kith::refine(kith::basic_mesh<>(), scheme(), 1);
}
