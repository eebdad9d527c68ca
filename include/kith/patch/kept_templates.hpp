// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_template.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Becomes a Scheme and nothing else, no base of it.
template <class Scheme>
struct only_as {
    template <std::same_as<Scheme> Same>
    operator const Same&() const;
};

} // namespace detail

/// Schemes that can be told apart: by their members, if they have any. The comparison must be one of their own, as that of a
/// base would leave out the members that a derived scheme adds.
template <class Scheme>
concept comparable_scheme = std::is_empty_v<Scheme> or (std::equality_comparable<Scheme> and
                                                        requires(const detail::only_as<Scheme>& s) { s == s; });

/// Templates of a scheme without its state for so many steps of any mesh, by the neighbourhoods and the state there that they are
/// for. Those of the last number of steps are kept for the process, one list for each type of scheme and point, so that who refines this mesh
/// again, or another one, is spared making them; schemes that cannot be told apart have a list of their own each time. A template takes some
/// 5 to 30 KB, a list about `most_bytes` at most. Safe on several threads.
template <scheme Scheme, std::floating_point Scalar, std::unsigned_integral Index>
class kept_templates {
public:
    using pointer = std::shared_ptr<const patch_template<Scalar, Index>>;
    static constexpr std::size_t most_bytes = std::size_t(32) << 20;

    /// For so many steps that begin at a level of this generation.
    static std::shared_ptr<kept_templates> of(const Scheme& scheme, int generation, int rings, std::size_t steps)
    {
        const auto made = std::make_shared<kept_templates>(scheme, generation, rings, steps);
        if constexpr (comparable_scheme<Scheme>) {
            static std::mutex mutex;
            static std::shared_ptr<kept_templates> last;
            const std::lock_guard lock(mutex);
            if (last == nullptr or not last->is_for_what(*made))
                last = made;
            return last;
        } else {
            return made;
        }
    }

    kept_templates(const Scheme& scheme, int generation, int rings, std::size_t steps)
        : scheme_(scheme), generation_(generation), rings_(rings), steps_(steps)
    {
    }

    /// The template for the neighbourhoods that have this key of a walk and of the state there; nullptr where none is kept.
    [[nodiscard]] pointer find(const std::u16string& key) const
    {
        const std::lock_guard lock(mutex_);
        const auto place = of_key_.find(key);
        return place == of_key_.end() ? nullptr : place->second;
    }
    /// Keeps a template, if there is room for it, and hands it back.
    pointer keep(const std::u16string& key, patch_template<Scalar, Index> made)
    {
        pointer shared = std::make_shared<const patch_template<Scalar, Index>>(std::move(made));
        const std::lock_guard lock(mutex_);
        if (bytes_ < most_bytes and of_key_.try_emplace(key, shared).second)
            bytes_ += shared->bytes();
        return shared;
    }

private:
    [[nodiscard]] bool is_for_what(const kept_templates& other) const
    {
        if (generation_ != other.generation_ or rings_ != other.rings_ or steps_ != other.steps_)
            return false;
        if constexpr (std::is_empty_v<Scheme>)
            return true;
        else
            return scheme_ == other.scheme_;
    }

    Scheme scheme_;
    int generation_, rings_;
    std::size_t steps_;
    mutable std::mutex mutex_;
    std::unordered_map<std::u16string, pointer> of_key_;
    std::size_t bytes_ = 0;
};

} // namespace kith
