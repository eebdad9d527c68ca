// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_template.hpp"

#include <kith/core/base/platform.hpp>
#include <kith/core/mesh/connect.hpp>
#include <kith/engine/strategy/strategy_choice.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace kith {

namespace detail {

/// A type that converts to Scheme and to nothing else, not even to a base of it.
template <class Scheme>
struct only_as {
    template <std::same_as<Scheme> Same>
    operator const Same&() const;
};

} // namespace detail

/// A scheme that can be told apart by its members, if it has any. Its masks have to follow from these members: changes
/// of data that it reads from elsewhere are not noticed. The comparison must be the scheme's own. That of a base would
/// leave out the members that a derived scheme adds.
template <class Scheme>
concept comparable_scheme = std::is_empty_v<Scheme> or (std::equality_comparable<Scheme> and
                                                        requires(const detail::only_as<Scheme>& s) { s == s; });

namespace detail {

/// The numbers of the schemes of one type for which templates are kept. Safe on several threads.
template <comparable_scheme Scheme>
class scheme_numbers {
public:
    /// Returns the number of a scheme; equal schemes have equal numbers. Cost: O(schemes).
    std::size_t of(const Scheme& scheme)
    {
        constexpr std::size_t most_schemes = 64;
        if constexpr (std::is_empty_v<Scheme>) {
            return 0;
        } else {
            const std::lock_guard lock(mutex_);
            const auto place = std::ranges::find(schemes_, scheme, &std::pair<Scheme, std::size_t>::first);
            if (place != schemes_.end())
                return place->second;
            if (schemes_.size() == most_schemes)
                schemes_.pop_front();
            schemes_.emplace_back(scheme, ++last_number_);
            return last_number_;
        }
    }

private:
    mutex mutex_;
    std::list<std::pair<Scheme, std::size_t>> schemes_; // and their numbers
    std::size_t last_number_ = 0;
};

} // namespace detail

/// A cache of the templates of a scheme for some number of steps on any mesh. The keys are neighbourhoods, with the
/// state of the scheme there. Templates are kept until the process ends, per type of scheme, number and index. Thus
/// later refinements, of this mesh or another one, need not make them again. Schemes that cannot be told apart share
/// none. A template takes some 5 to 30 KB. Those of one type of scheme, number and index take at most `most_bytes`: the
/// least recently used ones are given up. Safe on several threads.
template <std::floating_point Scalar, std::unsigned_integral Index>
class kept_templates {
public:
    using pointer = std::shared_ptr<const patch_template<Scalar, Index>>;
    static constexpr std::size_t most_bytes = std::size_t(64) << 20;

    /// Returns the templates of a scheme for `steps` steps that begin at a level of this generation, with classes by
    /// this many rings. `made` is the key of the patch_output_kind.
    template <scheme Scheme>
    static kept_templates of(const Scheme& scheme, int generation, int rings, std::size_t steps, std::size_t made = 0)
    {
        std::shared_ptr<store> where;
        std::size_t number = 0;
        if constexpr (comparable_scheme<Scheme>) {
            // Never destroyed, since static objects of a program may refine until its end.
            static const auto& of_all = *new std::shared_ptr<store>(std::make_shared<store>());
            static auto& numbers = *new detail::scheme_numbers<Scheme>();
            where = of_all;
            number = numbers.of(scheme);
        } else {
            where = std::make_shared<store>();
        }
        kept_templates result(std::move(where));
        for (const std::size_t part : {number >> 16, number, std::size_t(generation), std::size_t(rings), steps, made})
            result.purpose_ += char16_t(part);
        return result;
    }

    /// Returns true if no template is kept for these steps.
    [[nodiscard]] bool empty() const { return store_->empty(purpose_); }
    /// Returns the template for neighbourhoods whose walk and state have this key, or nullptr if none is kept.
    [[nodiscard]] pointer find(const std::u16string& key) const { return store_->find(purpose_, key); }
    /// Keeps a template and returns it.
    pointer keep(const std::u16string& key, patch_template<Scalar, Index> made) const
    {
        auto shared = std::make_shared<const patch_template<Scalar, Index>>(std::move(made));
        store_->keep(purpose_, key, shared);
        return shared;
    }

    /// Returns what these steps have made without templates, of levels with so many faces and this connectivity.
    /// Patches may be a gain with one connectivity and none with another.
    [[nodiscard]] template_demand demand(std::size_t faces, connect last_level) const
    {
        return store_->demand(purpose_and(faces, last_level));
    }
    void keep(std::size_t faces, connect last_level, const template_demand& demand) const
    {
        store_->keep(purpose_and(faces, last_level), demand);
    }

private:
    /// Two lists of templates. The young list has the templates that were asked for since it began. When it is full, it
    /// replaces the old list.
    class store {
    public:
        bool empty(const std::u16string& purpose)
        {
            const std::lock_guard lock(mutex_);
            return not young_.contains(purpose) and not old_.contains(purpose);
        }
        pointer find(const std::u16string& purpose, const std::u16string& key)
        {
            const std::lock_guard lock(mutex_);
            if (const pointer found = in(young_, purpose, key))
                return found;
            const pointer found = in(old_, purpose, key);
            if (found != nullptr)
                add(purpose, key, found);
            return found;
        }
        void keep(const std::u16string& purpose, const std::u16string& key, const pointer& made)
        {
            const std::lock_guard lock(mutex_);
            add(purpose, key, made);
        }
        template_demand demand(const std::u16string& purpose)
        {
            const std::lock_guard lock(mutex_);
            const auto place = demands_.find(purpose);
            return place == demands_.end() ? template_demand{} : place->second;
        }
        void keep(const std::u16string& purpose, const template_demand& demand)
        {
            constexpr std::size_t most_demands = 256;
            const std::lock_guard lock(mutex_);
            if (demands_.size() == most_demands and not demands_.contains(purpose))
                demands_.clear();
            demands_[purpose] = demand;
        }

    private:
        using lists = std::unordered_map<std::u16string, std::unordered_map<std::u16string, pointer>>; // by purpose

        static pointer in(const lists& all, const std::u16string& purpose, const std::u16string& key)
        {
            const auto list = all.find(purpose);
            if (list == all.end())
                return nullptr;
            const auto place = list->second.find(key);
            return place == list->second.end() ? nullptr : place->second;
        }
        void add(const std::u16string& purpose, const std::u16string& key, const pointer& made)
        {
            const std::size_t bytes = made->bytes() + sizeof(char16_t) * key.size();
            if (bytes_ + bytes > most_bytes / 2) {
                old_ = std::exchange(young_, {});
                bytes_ = 0;
            }
            if (young_[purpose].try_emplace(key, made).second)
                bytes_ += bytes;
        }

        detail::mutex mutex_;
        lists young_, old_;
        std::size_t bytes_ = 0; // of the young list
        std::unordered_map<std::u16string, template_demand> demands_;
    };

    explicit kept_templates(std::shared_ptr<store> where) : store_(std::move(where)) {}

    [[nodiscard]] std::u16string purpose_and(std::size_t faces, connect last_level) const
    {
        std::u16string result = purpose_ + char16_t(last_level);
        for (; faces != 0; faces >>= 16)
            result += char16_t(faces);
        return result;
    }

    std::shared_ptr<store> store_;
    std::u16string purpose_; // the scheme, first generation, rings, steps and output kind
};

} // namespace kith
