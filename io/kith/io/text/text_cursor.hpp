// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_error.hpp"
#include "work_counter.hpp"

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

#include <locale.h>
#include <stdlib.h>

namespace kith::io {

/// The kinds of text, by what ends a line or is skipped besides white space.
enum class text_kind : unsigned char {
    plain,
    with_comments,      ///< from '#' to the end of the line
    with_continuations, ///< comments, and '\' at the end of a line joins the next one to it
};

/// Returns a word as it can be printed: at most 40 bytes and "...", with '?' for bytes that are not printable ASCII.
inline std::string shown(std::string_view word)
{
    std::string result(word.substr(0, 40));
    for (char& c : result)
        if (c < ' ' or c > '~')
            c = '?';
    return result + (word.size() > 40 ? "..." : "");
}

/// Returns the bytes without the byte order mark that some programs put before text in UTF-8.
inline std::string_view without_byte_order_mark(std::string_view bytes)
{
    return bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0);
}

/// Returns the number nearest to these digits, also if it is 0 or infinite, which std::from_chars does not return. The
/// decimal point is a point in every locale of the process.
inline double nearest_double(const std::string& digits)
{
    static const locale_t plain = ::newlocale(LC_ALL_MASK, "C", locale_t());
    return ::strtod_l(digits.c_str(), nullptr, plain);
}

/// A cursor that walks over the words of a text in memory, which it does not change. Lines end with LF, CR or CRLF.
/// Their numbers are counted only for error messages.
template <text_kind Kind>
class text_cursor {
public:
    explicit text_cursor(std::string_view text, std::size_t first_line = 1)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), first_line_(first_line)
    {
    }

    /// Skips blanks. Returns true if nothing but a comment is left on this line.
    [[nodiscard]] bool at_line_end()
    {
        skip_blanks();
        return at_ == end_ or ends_line(*at_);
    }
    /// Moves behind the end of this line. Returns false if the text ends there.
    bool next_line()
    {
        skip_line();
        if (at_ == end_)
            return false;
        file_work.set(position());
        at_ += *at_ == '\r' and at_ + 1 != end_ and at_[1] == '\n' ? 2 : 1;
        return at_ != end_;
    }
    /// Moves to the next word, on this or a later line. Returns false if there is none.
    [[nodiscard]] bool to_content()
    {
        while (at_line_end())
            if (not next_line())
                return false;
        return true;
    }
    /// Returns the next word of this line, or an empty one at its end.
    [[nodiscard]] std::string_view word() { return word_until(ends_line); }
    /// Returns the next name of this line, or an empty one at its end. A name may contain '#'; a comment begins only
    /// where a word would.
    [[nodiscard]] std::string_view name() { return word_until(is_line_break); }
    /// Returns the next word of this line or of the lines after it, or an empty one at the end of the text.
    [[nodiscard]] std::string_view word_of_any_line() { return to_content() ? word() : std::string_view(end_, 0); }

    /// Returns the coordinate that is next in this line; `what()` names its element in error messages. Errors:
    /// file_error if there is no number, or not a finite one.
    template <std::floating_point Number = double, std::invocable What>
    [[nodiscard]] Number number(const What& what)
    {
        skip_blanks();
        Number value = 0;
        last_ = at_;
        const char* const digits = at_ != end_ and * at_ == '+' ? at_ + 1 : at_;
        const auto [rest, error] = std::from_chars(digits, end_, value);
        if (error == std::errc() and ends_word(rest) and std::isfinite(value)) {
            at_ = rest;
            return value;
        }
        return Number(unusual_number<Number>(word(), what));
    }
    /// Returns the number that is next in this line, finite or not. Errors: file_error if there is none.
    template <std::invocable What>
    [[nodiscard]] double any_number(const What& what)
    {
        const auto found = word();
        const std::string digits(found.substr(found.starts_with('+') ? 1 : 0));
        double value = 0;
        const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc::invalid_argument or rest != digits.data() + digits.size())
            refuse(what() + " should be a number, it is '" + shown(found) + "'");
        return error == std::errc() ? value : nearest_double(digits); // too small or too large
    }
    /// Returns the whole number that is next in this line. Errors: file_error if there is none or it does not fit.
    template <std::integral Integer, std::invocable What>
    [[nodiscard]] Integer whole(const What& what)
    {
        skip_blanks();
        Integer value = 0;
        const auto [rest, error] = std::from_chars(at_, end_, value);
        if (error == std::errc() and ends_word(rest)) {
            last_ = at_;
            at_ = rest;
            return value;
        }
        const auto found = word();
        refuse(what() + " should be a whole number, it is '" + shown(found) + "'");
    }
    /// Returns the whole number that a word or a part of a word is. Errors: file_error if it is none or does not fit.
    template <std::integral Integer, std::invocable What>
    [[nodiscard]] Integer whole(std::string_view part, const What& what) const
    {
        Integer value = 0;
        const auto [rest, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() or rest != part.data() + part.size())
            refuse(what() + " should be a whole number, it is '" + shown(part) + "'");
        return value;
    }

    [[nodiscard]] std::size_t left() const { return std::size_t(end_ - at_); }
    [[nodiscard]] std::size_t position() const { return std::size_t(at_ - begin_); }
    void skip_line()
    {
        if constexpr (Kind == text_kind::with_continuations) {
            while (not at_line_end())
                (void)word();
        }
        while (at_ != end_ and *at_ != '\n' and *at_ != '\r')
            ++at_;
    }
    /// Returns the number of the line of the word that was read last.
    [[nodiscard]] std::size_t line() const
    {
        std::size_t result = first_line_;
        for (const char* c = begin_; c < last_; ++c)
            result += *c == '\n' or (*c == '\r' and (c + 1 == end_ or c[1] != '\n'));
        return result;
    }
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw file_error("line " + std::to_string(line()) + ": " + what);
    }
    /// Throws file_error with the number of the current line, for something that is missing at its end.
    [[noreturn]] void refuse_here(const std::string& what)
    {
        last_ = at_;
        refuse(what);
    }

private:
    static bool is_blank(char c) { return c == ' ' or c == '\t' or c == '\v' or c == '\f'; }
    static bool is_line_break(char c) { return c == '\n' or c == '\r'; }
    static bool ends_line(char c) { return is_line_break(c) or (Kind != text_kind::plain and c == '#'); }
    [[nodiscard]] std::string_view word_until(bool (*is_end)(char))
    {
        if (at_line_end())
            return {end_, 0};
        const char* const begin = at_;
        while (at_ != end_ and not is_blank(*at_) and not is_end(*at_) and not continues())
            ++at_;
        last_ = begin;
        return {begin, std::size_t(at_ - begin)};
    }
    /// Returns the start of the next line if this line is continued here, else null.
    [[nodiscard]] const char* continuation() const
    {
        if (Kind != text_kind::with_continuations or at_ == end_ or *at_ != '\\')
            return nullptr;
        const char* c = at_ + 1;
        while (c != end_ and is_blank(*c))
            ++c;
        if (c == end_ or (*c != '\n' and *c != '\r'))
            return nullptr; // part of a name
        return c + (*c == '\r' and c + 1 != end_ and c[1] == '\n' ? 2 : 1);
    }
    [[nodiscard]] bool continues() const { return continuation() != nullptr; }
    void skip_blanks()
    {
        for (;;) {
            while (at_ != end_ and is_blank(*at_))
                ++at_;
            const char* const next = continuation();
            if (next == nullptr)
                return;
            at_ = next;
        }
    }
    [[nodiscard]] bool ends_word(const char* c) const
    {
        return c == end_ or is_blank(*c) or ends_line(*c) or (Kind == text_kind::with_continuations and *c == '\\');
    }
    /// Returns the number of a word that number() cannot read directly, such as one that is too small for its type.
    /// Errors: file_error for a number that is too large, and for a word that is none.
    template <std::floating_point Number, class What>
    [[nodiscard]] Number unusual_number(std::string_view word, const What& what) const
    {
        const std::string digits(word.substr(word.starts_with('+') ? 1 : 0));
        Number value = 0;
        const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if ((error != std::errc() and error != std::errc::result_out_of_range) or rest != digits.data() + digits.size())
            refuse(what() + " should be a number, it is '" + shown(word) + "'");
        const double wide = nearest_double(digits); // tells what is too small from what is too large
        if (not std::isfinite(wide))
            refuse(what() + " is '" + shown(word) + "', which is not a finite number; correct it");
        if (not std::isfinite(Number(wide)))
            refuse(what() + " is too large for the type float; declare it double");
        return Number(wide);
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    const char* last_ = begin_;
    std::size_t first_line_;
};

} // namespace kith::io
