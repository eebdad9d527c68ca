// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_CGAL // where kith::compiled_cgal is linked

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <kith/mesh/foreign_level.hpp>

namespace CGAL {

template <class Number>
struct Simple_cartesian;
class Epick;

} // namespace CGAL

namespace kith {

template <>
inline constexpr bool is_compiled_mesh<CGAL::Surface_mesh<CGAL::Point_3<CGAL::Simple_cartesian<double>>>> = true;
template <>
inline constexpr bool is_compiled_mesh<CGAL::Surface_mesh<CGAL::Point_3<CGAL::Epick>>> = true;

} // namespace kith

#endif
