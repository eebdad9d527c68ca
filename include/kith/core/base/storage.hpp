// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "large_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace kith {

/// A fixed-size array whose elements are left uninitialised if their type is trivially copyable. Large arrays lie in
/// `large_blocks`. Refining writes every element of fresh memory once, so clearing it first would double the memory
/// traffic. With 4 KiB pages, the page faults would cost more than the arithmetic.
template <class T>
class storage {
public:
    using value_type = T;

    storage() = default;
    explicit storage(std::size_t size) : data_(allocate(size)), size_(size)
    {
        if constexpr (not trivial) {
            try {
                std::uninitialized_value_construct_n(data_, size_);
            } catch (...) {
                release();
                throw;
            }
        }
    }
    storage(std::size_t size, const T& value) : storage(size) { std::fill_n(data_, size_, value); }
    template <class Range>
        requires requires(const Range& range) { std::data(range), std::size(range); }
    explicit storage(const Range& range) : storage(std::size(range))
    {
        std::copy_n(std::data(range), size_, data_);
    }
    storage(const storage& other) : storage(other.size_) { std::copy_n(other.data_, size_, data_); }
    storage(storage&& other) noexcept : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0))
    {
    }
    storage& operator=(storage other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~storage()
    {
        if constexpr (not trivial)
            std::destroy_n(data_, size_);
        release();
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] T* begin() noexcept { return data_; }
    [[nodiscard]] T* end() noexcept { return data_ + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data_; }
    [[nodiscard]] const T* end() const noexcept { return data_ + size_; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    static constexpr bool trivial = std::is_trivially_copyable_v<T>;

    static constexpr std::size_t alignment = std::max(large_blocks::cache_line, alignof(T));

    static bool is_large(std::size_t size)
    {
        return alignment == large_blocks::cache_line and size * sizeof(T) >= large_blocks::smallest;
    }
    static T* allocate(std::size_t size)
    {
        if (size == 0)
            return nullptr;
        if (size > PTRDIFF_MAX / sizeof(T))
            throw std::bad_array_new_length();
        if (is_large(size))
            return static_cast<T*>(shared_blocks.allocate(size * sizeof(T)));
        void* const block = std::aligned_alloc(alignment, (size * sizeof(T) + alignment - 1) / alignment * alignment);
        if (block == nullptr)
            throw std::bad_alloc();
        return static_cast<T*>(block);
    }
    void release() noexcept
    {
        if (is_large(size_))
            shared_blocks.free(data_, size_ * sizeof(T));
        else
            std::free(data_);
    }

    T* data_ = nullptr;
    std::size_t size_ = 0;
};

/// Enlarges a reused array to at least `size` elements. If it grows, its values are lost.
template <class T>
void ensure_size(storage<T>& array, std::size_t size)
{
    if (array.size() < size)
        array = storage<T>(size);
}

} // namespace kith
