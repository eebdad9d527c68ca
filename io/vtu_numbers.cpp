// SPDX-License-Identifier: BSD-3-Clause
#include "vtu_numbers.hpp"

#include <kith/io/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#ifdef KITH_HAS_ZLIB
#include <zlib.h>
#endif

namespace kith::io {

namespace {

std::size_t whole_number(const std::string& text, std::size_t otherwise, const std::string& what)
{
    std::size_t value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty())
        return otherwise;
    if (error != std::errc() or rest != text.data() + text.size())
        throw file_error(what + " should be a whole number, it is '" + shown(text) + "'");
    return value;
}

std::string called(const vtu_array& array)
{
    return "the array '" + shown(array.name) + "'";
}

/// Returns the value of a base64 digit, or -1 for other characters.
int base64_digit(char c)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto found = digits.find(c);
    return found == digits.npos ? -1 : int(found);
}

/// Decodes the first `size` bytes, or all if there are fewer. The length may be encoded separately, so that '=' is not
/// the end.
std::string from_base64(std::string_view text, std::size_t size)
{
    std::string result;
    std::uint32_t group = 0;
    int digits = 0, fill = 0;
    for (const char c : text) {
        if (result.size() >= size)
            break;
        if (std::string_view(" \t\r\n").find(c) != std::string_view::npos)
            continue;
        const int digit = c == '=' ? 0 : base64_digit(c);
        if (digit < 0)
            break;
        fill += c == '=';
        group = group << 6 | std::uint32_t(digit);
        if (++digits == 4) {
            for (int i = 0; i < 3 - std::min(fill, 3); ++i)
                result += char(group >> (16 - 8 * i) & 0xff);
            group = 0, digits = 0, fill = 0;
        }
    }
    result.resize(std::min(result.size(), size));
    return result;
}

/// Calls f with a zero of the type of the array.
template <class F>
void with_zero(const ply_number& type, const F& f)
{
    if (type.bytes < 8)
        with_type(type, 0, f);
    else if (type.floating)
        f(0.);
    else
        type.is_signed ? f(std::int64_t(0)) : f(std::uint64_t(0));
}

/// Appends a number of the file. Sets `rounded` if a double cannot hold a whole number of eight bytes exactly.
template <class Number>
void append(vtu_values& values, Number number)
{
    const double nearest = double(number);
    if constexpr (std::integral<Number> and sizeof number == 8)
        values.rounded |= nearest == std::ldexp(1., std::numeric_limits<Number>::digits) or Number(nearest) != number;
    values.numbers.push_back(nearest);
}

/// Appends the number that a word is, if it is written as digits and a sign, and the type can hold it. Returns false
/// otherwise.
template <class Number>
bool append_whole(vtu_values& values, std::string_view word)
{
    Number number = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() or rest != word.data() + word.size())
        return false;
    append(values, number);
    return true;
}

/// Returns the first bytes of encoded data, at most `size`.
std::string decoded(std::string_view text, bool raw, std::size_t size)
{
    return raw ? std::string(text.substr(0, size)) : from_base64(text, size);
}

/// Throws file_error if an array has another length than `size`. A `length` of nothing is larger than any that is
/// needed.
void require_length(const vtu_array& array, std::optional<std::uint64_t> length, std::size_t size)
{
    if (length != size)
        throw file_error(called(array) + " should have " + std::to_string(size) + " bytes, it has " +
                         (length ? std::to_string(*length) : "more"));
}

[[noreturn]] void refuse_end(const vtu_array& array)
{
    throw file_error("the file ends in " + called(array));
}

constexpr std::string_view zlib_compressor = "vtkZLibDataCompressor";

/// Appends `size` bytes that are compressed in a block. Returns false if the block does not hold exactly `size` bytes.
/// Allocates no more memory than a block of this size can expand to.
bool append_inflated(std::string& result, std::string_view block, std::uint64_t size)
{
#ifdef KITH_HAS_ZLIB
    constexpr std::uint64_t most_growth = 1040; // zlib's is 1032
    if (size / most_growth > block.size())
        return false;
    const std::size_t before = result.size();
    result.resize(before + size);
    uLongf made = uLongf(size);
    return uncompress(reinterpret_cast<Bytef*>(result.data() + before),
                      &made,
                      reinterpret_cast<const Bytef*>(block.data()),
                      uLong(block.size())) == Z_OK and
           made == size;
#else
    (void)result, (void)block, (void)size;
    throw file_error("is compressed, and kith was built without zlib; write it without a compressor");
#endif
}

} // namespace

vtu_array vtu_array_of(const xml_tag& tag)
{
    vtu_array result{tag, tag.attribute("Name"), {}, 1};
    const std::string type = tag.attribute("type");
    constexpr std::array<std::pair<std::string_view, ply_number>, 10> types{{{"Float32", {4, true, true}},
                                                                             {"Float64", {8, true, true}},
                                                                             {"Int8", {1, false, true}},
                                                                             {"UInt8", {1, false, false}},
                                                                             {"Int16", {2, false, true}},
                                                                             {"UInt16", {2, false, false}},
                                                                             {"Int32", {4, false, true}},
                                                                             {"UInt32", {4, false, false}},
                                                                             {"Int64", {8, false, true}},
                                                                             {"UInt64", {8, false, false}}}};
    const auto found = std::ranges::find(types, type, &std::pair<std::string_view, ply_number>::first);
    if (found == types.end())
        throw file_error(called(result) + " is of the type '" + shown(type) + "', which is not read");
    result.type = found->second;
    result.components = whole_number(
        tag.attribute("NumberOfComponents"), 1, "the number of components of " + called(result));
    if (result.components == 0)
        throw file_error(called(result) + " has no components");
    return result;
}

vtu_numbers::vtu_numbers(const xml_tag& file)
{
    static_assert(std::endian::native == std::endian::little, "numbers are read as they lie");
    is_big_endian_ = file.attribute("byte_order") == "BigEndian";
    compressor_ = file.attribute("compressor");
    bytes_of_length_ = file.attribute("header_type") == "UInt64" ? 8 : 4;
}

void vtu_numbers::set_appended(const xml_tag& tag, std::string_view rest)
{
    const std::size_t mark = rest.find('_');
    if (mark == rest.npos)
        throw file_error("the appended data do not begin with '_'");
    appended_ = rest.substr(mark + 1);
    raw_ = tag.attribute("encoding") == "raw";
}

std::string vtu_numbers::bytes_of(const vtu_array& array, std::size_t size) const
{
    if (is_big_endian_)
        throw file_error("its numbers are big-endian, which is not read; write it on another machine, or as text");
    const bool is_appended = array.tag.attribute("format") == "appended";
    std::string_view text = array.tag.text;
    if (is_appended) {
        const std::size_t offset = whole_number(array.tag.attribute("offset"), 0, "the offset of " + called(array));
        text = appended_.substr(std::min(offset, appended_.size()));
    }
    const bool raw = is_appended and raw_;
    if (not compressor_.empty())
        return inflated(array, text, raw, size);
    std::uint64_t length = 0;
    const std::string head = decoded(text, raw, bytes_of_length_);
    if (head.size() != bytes_of_length_)
        refuse_end(array);
    std::memcpy(&length, head.data(), head.size());
    require_length(array, length, size);
    std::string bytes = decoded(text, raw, bytes_of_length_ + size);
    if (bytes.size() != bytes_of_length_ + size)
        refuse_end(array);
    bytes.erase(0, bytes_of_length_);
    return bytes;
}

/// Returns the bytes of a compressed array. The array begins with the number of its blocks and the size of a block.
/// Then come the size of the last block if it is smaller, and the compressed size of each block.
std::string vtu_numbers::inflated(const vtu_array& array, std::string_view text, bool raw, std::size_t size) const
{
    if (compressor_ != zlib_compressor)
        throw file_error("is compressed by " + shown(compressor_) + ", which is not read; write it with " +
                         std::string(zlib_compressor) + ", or without a compressor");
    const auto word = [&](const std::string& head, std::size_t i) {
        std::uint64_t result = 0;
        std::memcpy(&result, head.data() + i * bytes_of_length_, bytes_of_length_);
        return result;
    };
    constexpr std::size_t words = 3;
    std::string head = decoded(text, raw, words * bytes_of_length_);
    if (head.size() != words * bytes_of_length_)
        refuse_end(array);
    const std::uint64_t blocks = word(head, 0), block_bytes = word(head, 1), last_bytes = word(head, 2);
    if (blocks > text.size() / bytes_of_length_ or last_bytes > block_bytes)
        throw file_error("the blocks of " + called(array) + " are not blocks of " + std::string(zlib_compressor));
    const bool is_far_more = blocks > 1 and block_bytes > size / (blocks - 1);
    const std::uint64_t last = last_bytes != 0 ? last_bytes : block_bytes;
    const std::uint64_t length = blocks == 0 ? 0 : (blocks - 1) * block_bytes + last;
    require_length(array, is_far_more ? std::nullopt : std::optional(length), size);
    head = decoded(text, raw, (words + blocks) * bytes_of_length_);
    if (head.size() != (words + blocks) * bytes_of_length_)
        refuse_end(array);
    std::size_t begin = head.size(), end = begin;
    for (std::uint64_t i = 0; i < blocks; ++i)
        end += std::min<std::uint64_t>(word(head, words + i), text.size() + 1); // more than there are
    const std::string bytes = decoded(text, raw, end);
    if (bytes.size() != end)
        refuse_end(array);
    std::string result;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const std::size_t compressed = word(head, words + i);
        if (not append_inflated(
                result, std::string_view(bytes).substr(begin, compressed), i + 1 == blocks ? last : block_bytes))
            throw file_error("block " + std::to_string(i) + " of " + called(array) +
                             " is damaged; write the file again");
        begin += compressed;
    }
    return result;
}

vtu_values vtu_numbers::text_values(const vtu_array& array, std::size_t numbers) const
{
    if (numbers > array.tag.text.size())
        throw file_error(called(array) + " should have " + std::to_string(numbers) + " numbers, it has fewer");
    text_cursor<text_kind::plain> text(array.tag.text);
    vtu_values result;
    for (std::size_t i = 0; i < numbers; ++i) {
        if (not text.to_content())
            throw file_error(called(array) + " should have " + std::to_string(numbers) + " numbers, it has " +
                             std::to_string(i));
        auto ahead = text;
        const auto word = ahead.word();
        if (not array.type.floating and
            (append_whole<std::int64_t>(result, word) or append_whole<std::uint64_t>(result, word))) {
            text = ahead;
            continue;
        }
        const double value = text.any_number([&] { return "number " + std::to_string(i) + " of " + called(array); });
        const bool is_whole = value == std::trunc(value) and std::abs(value) < 0x1p63;
        if (not array.type.floating and not is_whole)
            throw file_error("number " + std::to_string(i) + " of " + called(array) + " should be whole");
        result.numbers.push_back(value);
    }
    if (text.to_content())
        throw file_error(called(array) + " should have " + std::to_string(numbers) + " numbers, it has more");
    return result;
}

vtu_values vtu_numbers::values(const vtu_array& array, std::size_t count) const
{
    constexpr std::size_t most = std::size_t(1) << 56; // far beyond what any file has
    if (count > most / array.components)
        throw file_error(called(array) + " should have more numbers than a file can have");
    const std::size_t numbers = count * array.components;
    const std::string format = array.tag.attribute("format");
    if (format != "appended" and format != "binary")
        return text_values(array, numbers);
    const std::string bytes = bytes_of(array, numbers * array.type.bytes);
    vtu_values result;
    result.numbers.reserve(numbers);
    with_zero(array.type, [&]<class Number>(Number number) {
        for (std::size_t i = 0; i < numbers; ++i) {
            std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
            append(result, number);
        }
    });
    return result;
}

} // namespace kith::io
