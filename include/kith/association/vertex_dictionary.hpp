// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association_faults.hpp"

#include <kith/base/for_parts.hpp>

#include <concepts>
#include <map>

namespace kith {

/// New vertices by tuples that are in no column, such as elements that do not touch. Cost: O(log n) each.
template <std::unsigned_integral Index>
class vertex_dictionary {
public:
    /// Errors: association_error for a tuple that it has already, and in loops whose order is not promised.
    [[gnu::noinline]] void add(const tuple_elements& tuple, Index id)
    {
        if (detail::in_loop_body)
            faults::without_order(tuple);
        if (not ids_.emplace(tuple, id).second)
            faults::refuse(tuple, faults::vertex_set_twice);
    }
    /// Errors: association_error for a tuple that it does not have.
    [[nodiscard, gnu::noinline]] Index find(const tuple_elements& tuple) const
    {
        const auto found = ids_.find(tuple);
        if (found == ids_.end())
            faults::read_early(tuple);
        return found->second;
    }
    void clear() { ids_.clear(); }

private:
    std::map<tuple_elements, Index> ids_;
};

} // namespace kith
