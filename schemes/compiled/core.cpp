// SPDX-License-Identifier: BSD-3-Clause
#define KITH_HAS_BODIES
#include <kith/core/level/validate.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/limits/regular_masks.hpp>
#include <kith/refine.hpp>
#include <kith/repair.hpp>

namespace kith::detail {

template class read_connectivity<std::uint32_t>;
template void pair_corners(connectivity<std::uint32_t>&, mesh_report&);
template void pair_corners(connectivity<std::size_t>&, mesh_report&);
template void start_fans(connectivity<std::uint32_t>&, mesh_report&);
template void start_fans(connectivity<std::size_t>&, mesh_report&);
template connectivity<std::uint32_t> connect_faces(std::size_t, const face_list&);
template connectivity<std::size_t> connect_faces(std::size_t, const face_list&);

} // namespace kith::detail
