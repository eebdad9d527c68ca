// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "inherit.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/numbering/step/children.hpp>

#include <cstddef>
#include <functional>
#include <span>

namespace kith {

/// The rule of values on faces (material, label, group, hole). A face that is made in a face inherits from that face,
/// by `inherit(value)`. A face that is made by an edge or a vertex, as in Doo-Sabin's scheme, has `born`: a value, or a
/// function of (const auto& edge_or_vertex, values). The functions may be called on several threads.
template <class Inherit = std::identity, class Born = no_value>
struct from_parent {
    [[no_unique_address]] Inherit inherit{};
    [[no_unique_address]] Born born{};

    template <class T, finished_step Step>
    [[nodiscard]] storage<T> after(std::span<const T> values, const Step& step) const
    {
        storage<T> result(step.ids.faces.total());
        detail::inherit_values<element_kind::face>(result, values, *this, step);
        return result;
    }
};

} // namespace kith
