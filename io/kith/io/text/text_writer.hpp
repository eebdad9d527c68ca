// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "work_counter.hpp"

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace kith::io {

/// A text to which words and numbers are appended.
class text_block {
public:
    text_block& operator<<(std::string_view text)
    {
        text_.append(text);
        return *this;
    }
    text_block& operator<<(char c)
    {
        text_.push_back(c);
        return *this;
    }
    /// Appends a number; a floating-point number in the shortest digits that read back as the same number.
    template <class Number>
        requires(std::is_arithmetic_v<Number> and not std::same_as<Number, char>)
    text_block& operator<<(Number number)
    {
        return add(number);
    }
    text_block& operator<<(const std::array<double, 3>& p) { return *this << p[0] << ' ' << p[1] << ' ' << p[2]; }
    /// Appends the bytes of a number as they lie in memory.
    template <class Number>
    text_block& raw(Number number)
    {
        text_.append(reinterpret_cast<const char*>(&number), sizeof(number));
        return *this;
    }

    [[nodiscard]] std::string_view text() const { return text_; }
    void clear() { text_.clear(); }

private:
    template <class Number>
    text_block& add(Number number)
    {
        std::array<char, 32> digits;
        const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        text_.append(digits.data(), std::size_t(end - digits.data()));
        return *this;
    }

    std::string text_;
};

/// Calls write(block, i) for all i below a count, and writes the blocks in this order. Several threads fill blocks at
/// the same time. Errors: those of `write`, and those of the stream, in its state.
template <class Write>
void write_blocks(std::ostream& out, std::size_t count, const Write& write)
{
    constexpr std::size_t per_block = 4096, blocks_at_once = 32;
    std::vector<text_block> blocks(std::min(blocks_at_once, count / per_block + 1));
    for (std::size_t begin = 0; begin < count and out; begin += blocks.size() * per_block) {
        const std::size_t used = std::min(blocks.size(), (count - begin + per_block - 1) / per_block);
        const auto fill = [&](std::size_t first_block, std::size_t end_block) {
            for (std::size_t b = first_block; b < end_block; ++b) {
                blocks[b].clear();
                const std::size_t first = begin + b * per_block;
                for (std::size_t i = first; i < std::min(first + per_block, count); ++i)
                    write(blocks[b], i);
            }
        };
        const bool parallel = used * per_block >= kith::detail::elements_worth_threads();
        kith::detail::for_parts(used, parallel, fill, 2);
        for (std::size_t b = 0; b < used; ++b)
            out.write(blocks[b].text().data(), std::streamsize(blocks[b].text().size()));
        file_work.add(std::min(blocks.size() * per_block, count - begin));
    }
}

} // namespace kith::io
