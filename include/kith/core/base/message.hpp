// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <concepts>
#include <vector>

namespace kith {

/// The writer of a message: it adds plain values and arrays of them one after the other, as kith::packer does.
template <class Out>
concept message_writer = requires(Out& out, int value, const std::vector<int>& values) {
    { out.add(value) } -> std::same_as<Out&>;
    { out.add_array(values) } -> std::same_as<Out&>;
};
/// The reader of a message, in the order in which it was written, such as a kith::unpacker.
template <class In>
concept message_reader = requires(In& in) {
    { in.template get<int>() } -> std::same_as<int>;
    { in.template get_array<std::vector<int>>() } -> std::same_as<std::vector<int>>;
};

} // namespace kith
