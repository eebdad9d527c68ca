// SPDX-License-Identifier: BSD-3-Clause
// A rule of a field whose function is not const.
#include <kith/linear.hpp>
#include <kith/refine_with_fields.hpp>

#include <span>
#include <tuple>
#include <vector>

struct rule {
    template <class T, class Step>
    kith::storage<T> after(std::span<const T> values, const Step& step);
};

void refine(const kith::basic_mesh<>& mesh)
{
    auto labels = kith::on_faces(std::vector<int>(mesh.face_count()), rule{});
    kith::refine_with_fields(mesh, kith::linear{}, 1, std::tie(labels));
}
