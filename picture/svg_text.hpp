// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/picture/color.hpp>

#include <string>

namespace kith::picture {

/// Returns a number with so many digits after the point, but without zeros at its end.
std::string number(double x, int digits = 1);

/// Returns a color without its opacity, such as #1f77b4.
std::string hexadecimal(const color& paint);

/// Returns a text that can stand in an element of XML.
std::string escaped(const std::string& text);

} // namespace kith::picture
