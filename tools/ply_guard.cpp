// SPDX-License-Identifier: BSD-3-Clause
#include "file_guard.hpp"
#include "ply_header.hpp"
#include "text_scanner.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace kith::tool {

namespace {

/// The numbers of a text file, one after the other wherever its lines end.
class text_numbers {
public:
    text_numbers(std::string& bytes, const ply_header& header) : scan_(bytes, header.data_begin, header.data_line) {}

    template <std::invocable What>
    double floating(const ply_number& type, const What& what)
    {
        const double value = scan_.number(next(what), what);
        if (type.bytes == 4 and std::abs(value) > FLT_MAX)
            scan_.refuse(what() + " is too large for the type float; declare it double");
        return value;
    }
    template <std::invocable What>
    std::int64_t whole(const ply_number& type, const What& what)
    {
        const auto value = scan_.whole<std::int64_t>(next(what), what);
        const int bits = int(8 * type.bytes);
        const std::int64_t most = (std::int64_t(1) << (type.is_signed ? bits - 1 : bits)) - 1;
        if (value > most or value < (type.is_signed ? -most - 1 : 0))
            scan_.refuse(what() + " is " + std::to_string(value) + ", which does not fit its type");
        return value;
    }
    void expect_end()
    {
        if (not scan_.word_of_any_line().empty())
            scan_.refuse("the file goes on after its last element");
    }
    [[noreturn]] void refuse(const std::string& what) const { scan_.refuse(what); }

private:
    template <std::invocable What>
    std::string_view next(const What& what)
    {
        const auto word = scan_.word_of_any_line();
        if (word.empty())
            throw file_error("the file ends where " + what() + " should be");
        return word;
    }

    text_scanner scan_;
};

class binary_numbers {
public:
    binary_numbers(std::string& bytes, const ply_header& header)
        : rest_(std::string_view(bytes).substr(header.data_begin))
        , big_endian_(header.encoding == ply_encoding::big_endian)
    {
    }

    template <std::invocable What>
    double floating(const ply_number& type, const What& what)
    {
        const std::uint64_t bits = take(type.bytes, what);
        const double value = type.bytes == 4 ? std::bit_cast<float>(std::uint32_t(bits)) : std::bit_cast<double>(bits);
        if (not std::isfinite(value))
            refuse(what() + " is not a finite number; give it a place");
        return value;
    }
    template <std::invocable What>
    std::int64_t whole(const ply_number& type, const What& what)
    {
        const std::uint64_t bits = take(type.bytes, what);
        const int unused = int(64 - 8 * type.bytes);
        return type.is_signed ? std::int64_t(bits << unused) >> unused : std::int64_t(bits);
    }
    void expect_end() const
    {
        if (not rest_.empty())
            refuse("the file goes on for " + std::to_string(rest_.size()) + " bytes after its last element");
    }
    [[noreturn]] void refuse(const std::string& what) const { throw file_error(what); }

private:
    template <std::invocable What>
    std::uint64_t take(std::size_t bytes, const What& what)
    {
        if (rest_.size() < bytes)
            throw file_error("the file ends where " + what() + " should be");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            bits = bits << 8 | std::uint8_t(rest_[big_endian_ ? i : bytes - 1 - i]);
        rest_.remove_prefix(bytes);
        return bits;
    }

    std::string_view rest_;
    bool big_endian_;
};

template <class Numbers>
void check_list(Numbers& numbers, const ply_element& element, const ply_property& property, std::size_t item,
                std::size_t vertices, file_contents& contents)
{
    const auto what = [&] { return element.name + " " + std::to_string(item) + ": " + property.name; };
    const auto length = numbers.whole(property.count, [&] { return what() + ", its length"; });
    if (length < 0)
        numbers.refuse(what() + ": the list has " + std::to_string(length) + " entries");
    const bool corners = element.is_face() and (property.name == "vertex_indices" or property.name == "vertex_index");
    for (std::int64_t i = 0; i < length; ++i) {
        if (property.value.floating) {
            (void)numbers.floating(property.value, what);
            continue;
        }
        const auto value = numbers.whole(property.value, what);
        if (corners and (value < 0 or std::uint64_t(value) >= vertices))
            numbers.refuse("face " + std::to_string(item) + ": vertex " + std::to_string(value) +
                           " does not exist, there are " + std::to_string(vertices) + "; correct the index");
    }
    if (corners)
        contents.corners += std::size_t(length);
}

template <class Numbers>
file_contents check_elements(Numbers numbers, const ply_header& header)
{
    file_contents result{.vertices = header.vertices, .faces = header.faces};
    for (const auto& element : header.elements)
        for (std::size_t item = 0; item < element.count; ++item)
            for (const auto& property : element.properties) {
                const auto what = [&] { return element.name + " " + std::to_string(item) + ": " + property.name; };
                if (property.is_list())
                    check_list(numbers, element, property, item, header.vertices, result);
                else if (property.value.floating)
                    (void)numbers.floating(property.value, what);
                else
                    (void)numbers.whole(property.value, what);
            }
    numbers.expect_end();
    return result;
}

} // namespace

file_contents guard_ply(std::string& bytes)
{
    const ply_header header = read_ply_header(bytes);
    if (header.encoding == ply_encoding::text)
        return check_elements(text_numbers(bytes, header), header);
    file_contents result = check_elements(binary_numbers(bytes, header), header);
    result.binary = true;
    return result;
}

} // namespace kith::tool
