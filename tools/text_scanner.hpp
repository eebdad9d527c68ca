// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.hpp"

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace kith::tool {

/// Walks over the words of a text in memory and knows the line it is on. What a reader after it must not see can be
/// blanked in place. Every complaint names the line.
class text_scanner {
public:
    explicit text_scanner(std::string& text, std::size_t begin = 0, std::size_t line = 1)
        : text_(&text), next_line_(begin), next_number_(line)
    {
    }

    /// Goes to the next line; false when there is none.
    bool advance()
    {
        if (next_line_ >= text_->size())
            return false;
        line_begin_ = at_ = next_line_;
        const std::size_t newline = text_->find('\n', line_begin_);
        line_end_ = newline == std::string::npos ? text_->size() : newline;
        next_line_ = line_end_ + 1;
        number_ = next_number_++;
        return true;
    }
    /// The next word of this line; empty at its end.
    [[nodiscard]] std::string_view word()
    {
        while (at_ < line_end_ and is_space((*text_)[at_]))
            ++at_;
        const std::size_t begin = at_;
        while (at_ < line_end_ and not is_space((*text_)[at_]))
            ++at_;
        return std::string_view(*text_).substr(begin, at_ - begin);
    }
    /// The next word of this line or, past its end, of the lines after it; empty at the end of the text.
    [[nodiscard]] std::string_view word_of_any_line()
    {
        for (;;) {
            if (const auto found = word(); not found.empty())
                return found;
            if (not advance())
                return {};
        }
    }

    [[nodiscard]] std::size_t line() const { return number_; }
    /// Where the word that was read last ends, and where the line after this one begins.
    [[nodiscard]] std::size_t position() const { return at_; }
    [[nodiscard]] std::size_t next_line() const { return next_line_; }
    [[nodiscard]] std::string_view rest_of_line() const
    {
        return std::string_view(*text_).substr(at_, line_end_ - at_);
    }

    /// Overwrites a part of this line with spaces.
    void blank(std::string_view part)
    {
        text_->replace(std::size_t(part.data() - text_->data()), part.size(), part.size(), ' ');
    }
    void blank_line() { blank(std::string_view(*text_).substr(line_begin_, line_end_ - line_begin_)); }
    /// Blanks from '#' to the end of the line, so that it is not seen as words either.
    void blank_comment()
    {
        const std::string_view line = std::string_view(*text_).substr(line_begin_, line_end_ - line_begin_);
        if (const auto hash = line.find('#'); hash != line.npos)
            blank(line.substr(hash));
    }

    [[noreturn]] void refuse(const std::string& what) const
    {
        throw file_error("line " + std::to_string(number_) + ": " + what);
    }
    /// A coordinate; `what()` says of which element, in case of a complaint.
    /// Errors: file_error when the word is no number or not a finite one.
    template <std::invocable What>
    [[nodiscard]] double number(std::string_view word, const What& what) const
    {
        const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc::result_out_of_range)
            value = std::strtod(std::string(digits).c_str(), nullptr); // tells what is too small from what is too large
        else if (error != std::errc())
            refuse(what() + " should be a number, it is '" + shown(word) + "'");
        if (end != digits.data() + digits.size())
            refuse(what() + " should be a number, it is '" + shown(word) + "'");
        if (not std::isfinite(value))
            refuse(what() + " is '" + shown(word) + "', which is not a finite number; give it a place");
        return value;
    }
    /// A whole number. Errors: file_error when the word is none or does not fit.
    template <std::integral Integer, std::invocable What>
    [[nodiscard]] Integer whole(std::string_view word, const What& what) const
    {
        Integer value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() or end != word.data() + word.size())
            refuse(what() + " should be a whole number, it is '" + shown(word) + "'");
        return value;
    }
    /// A word as it can be printed: short, and without bytes that upset a terminal.
    [[nodiscard]] static std::string shown(std::string_view word)
    {
        std::string result(word.substr(0, 40));
        for (char& c : result)
            if (c < ' ' or c > '~')
                c = '?';
        return result + (word.size() > 40 ? "..." : "");
    }

private:
    [[nodiscard]] static bool is_space(char c) { return c == ' ' or c == '\t' or c == '\r' or c == '\v' or c == '\f'; }

    std::string* text_;
    std::size_t line_begin_ = 0;
    std::size_t line_end_ = 0;
    std::size_t at_ = 0;
    std::size_t next_line_;
    std::size_t number_ = 0;
    std::size_t next_number_;
};

} // namespace kith::tool
