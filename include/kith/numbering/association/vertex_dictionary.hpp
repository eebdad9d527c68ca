// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association_faults.hpp"

#include <kith/core/base/for_parts.hpp>

#include <concepts>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace kith {

/// A dictionary of new vertices by tuples that are in no column, such as elements that do not touch. These vertices
/// have the last numbers of their level. Cost: O(log n) for each vertex.
template <std::unsigned_integral Index>
class vertex_dictionary {
public:
    /// Adds a new vertex, which has a number of its own, under this tuple. Errors: association_error for a tuple that
    /// is in the dictionary already, and in loops whose order is not promised.
    [[gnu::noinline]] void add(const tuple_elements& tuple, Index id)
    {
        add_name(tuple, id);
        made_.push_back(tuple);
    }
    /// Adds the tuple as another name of a vertex. Errors: as above.
    [[gnu::noinline]] void add_name(const tuple_elements& tuple, Index id)
    {
        if (detail::in_loop_body)
            faults::without_order(tuple);
        if (not ids_.emplace(tuple, id).second)
            faults::refuse(tuple, faults::vertex_set_twice);
    }
    /// Returns the vertex of a tuple, or nothing if the tuple is not in the dictionary.
    [[nodiscard, gnu::noinline]] std::optional<Index> find(const tuple_elements& tuple) const
    {
        const auto found = ids_.find(tuple);
        return found == ids_.end() ? std::nullopt : std::optional(found->second);
    }
    /// Returns the vertex of a tuple. Errors: association_error if the tuple is not in the dictionary.
    [[nodiscard, gnu::noinline]] Index at(const tuple_elements& tuple) const
    {
        const auto found = find(tuple);
        if (not found)
            faults::read_early(tuple);
        return *found;
    }
    /// Returns the tuple under which the k-th of the new vertices was made. Precondition: k < size().
    [[nodiscard]] const tuple_elements& tuple_of(std::size_t k) const { return made_[k]; }
    /// Returns the number of new vertices.
    [[nodiscard]] std::size_t size() const { return made_.size(); }

    void clear()
    {
        ids_.clear();
        made_.clear();
    }

private:
    std::map<tuple_elements, Index> ids_;
    std::vector<tuple_elements> made_;
};

} // namespace kith
