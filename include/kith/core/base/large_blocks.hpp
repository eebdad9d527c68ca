// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"
#include "platform.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <type_traits>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace kith {

/// The size of a huge page in bytes, on Linux and most processors.
inline constexpr std::size_t huge_page = std::size_t(2) << 20;

/// Asks the system for huge pages where they lie completely inside an array that has not been touched yet. With 4 KiB
/// pages, the page faults of a large array take longer than writing it. A refusal by the system costs speed only.
template <class T>
void advise_large_pages([[maybe_unused]] T* array, [[maybe_unused]] std::size_t size)
{
#if defined(__linux__)
    const auto begin = (reinterpret_cast<std::uintptr_t>(array) + huge_page - 1) / huge_page * huge_page;
    const auto end = reinterpret_cast<std::uintptr_t>(array + size) / huge_page * huge_page;
    if (begin < end)
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

namespace detail {

/// The addresses from `begin` up to, but not including, `end`.
struct memory_range {
    std::uintptr_t begin, end;
};

/// Returns the writable memory of the process that is not mapped from a file, in order; nothing if the system does not
/// tell. Cost: O(mappings).
[[nodiscard]] std::vector<memory_range> writable_memory() noexcept;
/// Asks for huge pages for memory that is mapped now and was not mapped `before`. Cost: O(mappings).
void advise_memory_since(const std::vector<memory_range>& before) noexcept;

} // namespace detail

/// Asks for huge pages for arrays of another library whose addresses are not known: calls reserve(), which allocates
/// the arrays without writing to them. Page faults of 4 KiB take several times as long as writing a large array.
/// Errors: those of reserve(). Cost: that of reserve(), and O(mappings of the process).
template <class Reserve>
void reserve_in_large_pages(const Reserve& reserve)
{
    const auto before = detail::writable_memory();
    reserve();
    detail::advise_memory_since(before);
}

/// The cache of all memory blocks of `storage` from 64 KiB on. A freed block is kept for the next block of about the
/// same size. Blocks from 4 MiB on are in 2 MiB pages. The kernel clears every fresh page, which takes a quarter of the
/// time of a large refinement. For some ten thousand faces it takes more than half of the time, since malloc gives
/// freed arrays back to the kernel (docs/design.md, Speed). A program that refines again, or tile by tile, avoids this.
/// Blocks in use and kept blocks together take at most an eighth more memory than was ever in use. All kept blocks go
/// back to the system in three cases: more memory than ever is needed, there is no memory for a block, or a mesh of
/// another library is made. Safe to use from several threads.
class large_blocks {
public:
    static constexpr std::size_t page = huge_page;
    /// The size in bytes of the smallest block here; malloc keeps smaller ones itself.
    static constexpr std::size_t smallest = std::size_t(64) << 10;
    static constexpr std::size_t cache_line = 64;

    /// Returns a block that is not cleared, aligned to a cache line; to a huge page if it has at least two of them.
    /// Errors: std::bad_alloc. Cost: O(kept blocks).
    [[nodiscard]] void* allocate(std::size_t bytes);

    /// Keeps a block for later use, or gives it back to the system. Precondition: `block` is from allocate(bytes).
    void free(void* block, std::size_t bytes) noexcept;

    /// Limits the bytes that are kept; the default is 1 GiB, and 0 means that nothing is kept.
    void keep_at_most(std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        limit_ = bytes;
        keep_only(bytes);
    }
    /// Gives all kept blocks back to the system.
    void give_back();
    /// Returns the number of bytes that are kept and not in use.
    [[nodiscard]] std::size_t kept() const
    {
        const std::lock_guard lock(mutex_);
        return kept_bytes_;
    }

private:
    struct kept_block {
        void* block;
        std::size_t bytes;
    };

    static constexpr bool is_huge(std::size_t bytes) { return bytes >= 2 * page; }

    /// Rounds a size up, so that blocks of nearly the same size get the same size. The added memory is never touched,
    /// so it costs address space only.
    static std::size_t in_whole_units(std::size_t bytes)
    {
        const std::size_t unit = std::max(is_huge(bytes) ? page : smallest / 16, std::bit_floor(bytes) / 16);
        return (bytes + unit - 1) / unit * unit;
    }
    void* forget(std::size_t i)
    {
        const auto [block, bytes] = kept_[i];
        // The blocks stay in the order in which they were freed. So repeated work gets the same blocks again, and each
        // thread finds the parts in its caches that it had before.
        const auto place = kept_.begin() + std::ptrdiff_t(i);
        std::copy(place + 1, kept_.begin() + std::ptrdiff_t(kept_count_--), place);
        kept_bytes_ -= bytes;
        return block;
    }
    /// Gives the smallest blocks back, which are the cheapest to clear again, until no more than `bytes` bytes are
    /// kept.
    void keep_only(std::size_t bytes)
    {
        while (kept_bytes_ > bytes)
            std::free(forget(std::size_t(smallest_kept() - kept_.begin())));
    }
    [[nodiscard]] auto smallest_kept() const -> std::array<kept_block, 256>::const_iterator
    {
        return std::min_element(kept_.begin(),
                                kept_.begin() + std::ptrdiff_t(kept_count_),
                                [](const auto& a, const auto& b) { return a.bytes < b.bytes; });
    }

    mutable detail::mutex mutex_;
    std::array<kept_block, 256> kept_{};
    std::size_t kept_count_ = 0;
    std::size_t kept_bytes_ = 0;
    std::size_t in_use_ = 0, most_in_use_ = 0;
    std::size_t limit_ = detail::is_sanitized ? 0 : std::size_t(1) << 30; // else reads of freed blocks go unnoticed
};

#ifdef KITH_HAS_BODIES

namespace detail {

KITH_IN_LIBRARY std::vector<memory_range> writable_memory() noexcept
{
    std::vector<memory_range> result;
#if defined(__linux__)
    std::FILE* const maps = std::fopen("/proc/self/maps", "re");
    if (maps == nullptr)
        return result;
    try {
        std::array<char, 256> line; // begin-end rights offset device inode name; the name may be truncated
        bool is_begin = true;
        while (std::fgets(line.data(), int(line.size()), maps) != nullptr) {
            unsigned long long begin = 0, end = 0, inode = 0;
            std::array<char, 5> rights{};
            if (is_begin and
                std::sscanf(line.data(), "%llx-%llx %4s %*x %*s %llu", &begin, &end, rights.data(), &inode) == 4 and
                rights[1] == 'w' and rights[3] == 'p' and inode == 0)
                result.push_back({std::uintptr_t(begin), std::uintptr_t(end)});
            is_begin = std::strchr(line.data(), '\n') != nullptr;
        }
    } catch (const std::bad_alloc&) {
        result.clear();
    }
    std::fclose(maps);
#endif
    return result;
}

KITH_IN_LIBRARY void advise_memory_since(const std::vector<memory_range>& before) noexcept
{
    if (before.empty()) // the system did not tell: all would be new
        return;
    auto old = before.begin();
    for (const memory_range& now : writable_memory()) {
        std::uintptr_t begin = now.begin;
        while (begin < now.end) {
            while (old != before.end() and old->end <= begin)
                ++old;
            const std::uintptr_t end = old == before.end() ? now.end : std::clamp(old->begin, begin, now.end);
            advise_large_pages(reinterpret_cast<std::byte*>(begin), end - begin);
            begin = old == before.end() ? now.end : std::max(end, std::min(old->end, now.end));
        }
    }
}

} // namespace detail

KITH_IN_LIBRARY void* large_blocks::allocate(std::size_t bytes)
{
    bytes = in_whole_units(bytes);
    const std::lock_guard lock(mutex_);
    const std::size_t now = in_use_ + bytes;
    for (std::size_t i = kept_count_; i-- > 0;)
        if (kept_[i].bytes == bytes) {
            in_use_ = now;
            return forget(i);
        }
    // If the faces at least triple, a level and the two before it, which a second run allocates in between, need less
    // than an eighth more. If the faces double, this costs one more block.
    keep_only(std::min(limit_, (now > most_in_use_ ? now : most_in_use_ / 8 * 9) - now));
    const std::size_t alignment = is_huge(bytes) ? page : cache_line;
    void* block = std::aligned_alloc(alignment, bytes);
    if (block == nullptr) {
        keep_only(0);
        block = std::aligned_alloc(alignment, bytes);
    }
    if (block == nullptr)
        throw std::bad_alloc();
    in_use_ = now;
    most_in_use_ = std::max(most_in_use_, now);
    if (is_huge(bytes))
        advise_large_pages(static_cast<std::byte*>(block), bytes);
    return block;
}

KITH_IN_LIBRARY void large_blocks::free(void* block, std::size_t bytes) noexcept
{
    bytes = in_whole_units(bytes);
    const std::lock_guard lock(mutex_);
    in_use_ -= bytes;
    if (kept_count_ == kept_.size() and smallest_kept()->bytes < bytes)
        std::free(forget(std::size_t(smallest_kept() - kept_.begin())));
    if (kept_count_ == kept_.size() or bytes > limit_ - std::min(limit_, kept_bytes_)) {
        std::free(block);
        return;
    }
    kept_[kept_count_++] = {block, bytes};
    kept_bytes_ += bytes;
}

KITH_IN_LIBRARY void large_blocks::give_back()
{
    const std::lock_guard lock(mutex_);
    keep_only(0);
}

#endif

/// The blocks of the process. This object is never destroyed, so arrays of any lifetime may use it.
inline constinit large_blocks shared_blocks;
static_assert(std::is_trivially_destructible_v<large_blocks>);

} // namespace kith
