// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association_space.hpp"

namespace kith {

namespace detail {

/// The data that a pass owns. It is a base class, so that it exists before the space that refers to it.
template <level_numbering Numbering, value_space Values>
struct pass_parts {
    Numbering ids;
    Values values;
    connectivity<typename Numbering::index_type> nothing;
};

} // namespace detail

/// The association space of one of the passes of a step; thesis 4.1, chained. Its vertices belong to no level. They are
/// set and read as others are and exist as long as the pass.
template <level Level, level_numbering Numbering, values_of_step<Level> Values, bool Checked>
class pass_space : detail::pass_parts<Numbering, Values>,
                   public association_space<Level, Numbering, Values, connect::nothing, Checked> {
    using parts = detail::pass_parts<Numbering, Values>;
    using space = association_space<Level, Numbering, Values, connect::nothing, Checked>;

public:
    pass_space(const Level& coarse, const typename Numbering::columns_type& columns, const Values& step)
        : parts{{coarse, columns}, step.another(), {}}, space(coarse, parts::ids, parts::values, parts::nothing)
    {
        parts::values.allocate(parts::ids.vertices.total());
    }
    pass_space(const pass_space&) = delete;
    pass_space& operator=(const pass_space&) = delete;

    /// Returns the space to be written anew, in the same memory. Errors: association_error inside for_each and
    /// in_blocks.
    const pass_space& again() const
    {
        if (detail::in_loop_body)
            throw association_error("again() is called inside for_each or in_blocks, where other threads may read the "
                                    "pass; call it outside");
        space::forget_what_is_set();
        return *this;
    }
};

} // namespace kith
