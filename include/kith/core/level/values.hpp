// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "elements.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The values over which masks are evaluated: those at the vertices of the coarse level, which the derived class reads,
/// and those of the fine level, which are being computed.
template <affine_value T>
class fine_values {
public:
    using value_type = T;
    using scalar = typename affine<T>::scalar;
    using sum = typename affine<T>::sum;

    static void add(sum& total, const sum& more) { affine<T>::add(total, more); }
    static void scale(sum& total, const scalar& weight) { affine<T>::scale(total, weight); }

    fine_values() = default;
    fine_values(const fine_values&) = delete;
    fine_values& operator=(const fine_values&) = delete;

    void allocate(std::size_t size)
    {
        own_ = storage<T>(size);
        allocate_at(own_.data(), size);
    }
    /// Uses an array of the caller for the values of the fine level; the caller keeps it.
    void allocate_at(T* array, std::size_t size)
    {
        fine_ = array;
        size_ = size;
    }
    [[nodiscard]] decltype(auto) fine(std::size_t id) const { return affine<T>::load(fine_[id]); }
    void assign(std::size_t id, const sum& total) { fine_[id] = affine<T>::store(total); }

    // The vertices of the dictionary come after all others. Their number is known only at the end.
    [[nodiscard]] std::size_t listed_count() const { return listed_.size(); }
    void append(const sum& total) { listed_.push_back(affine<T>::store(total)); }
    [[nodiscard]] sum listed(std::size_t id) const
    {
        return affine<T>::load(id < size_ ? fine_[id] : listed_[id - size_]);
    }

    /// Returns all values of the fine level and leaves this object empty.
    [[nodiscard]] storage<T> take()
    {
        if (not listed_.empty()) {
            storage<T> all(own_.size() + listed_.size());
            std::move(listed_.begin(), listed_.end(), std::move(own_.begin(), own_.end(), all.begin()));
            listed_.clear();
            own_ = std::move(all);
        }
        return std::move(own_);
    }

private:
    storage<T> own_;
    T* fine_ = nullptr;
    std::size_t size_ = 0; // number of vertices of columns
    std::vector<T> listed_;
};

/// The points of the meshes themselves, as values.
template <level Level>
class point_values : public fine_values<typename Level::point_type> {
public:
    /// Returns an object without fine values over the same coarse level, for another pass of a step.
    [[nodiscard]] point_values another() const { return {}; }

    template <walkable_level L>
    [[nodiscard]] decltype(auto) coarse(const vertex<L>& v) const
    {
        return affine<typename Level::point_type>::load(v.point());
    }
};

/// The values of any other type with an `affine`, one per vertex.
template <affine_value T>
class attribute_values : public fine_values<T> {
public:
    explicit attribute_values(std::span<const T> coarse) : coarse_(coarse) {}

    /// Returns an object without fine values over the same coarse level, for another pass of a step.
    [[nodiscard]] attribute_values another() const { return attribute_values(coarse_); }

    template <walkable_level L>
    [[nodiscard]] decltype(auto) coarse(const vertex<L>& v) const
    {
        return affine<T>::load(coarse_[v.index()]);
    }

private:
    std::span<const T> coarse_;
};

} // namespace kith
