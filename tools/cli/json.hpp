// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

namespace kith::tool {

/// The few values that the program prints as JSON.
inline std::string to_json(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' or c == '\\') {
            result += '\\';
            result += c;
        } else if (c >= 0 and c < ' ') {
            constexpr std::string_view digits = "0123456789abcdef";
            result += "\\u00";
            result += digits[std::size_t(c) >> 4];
            result += digits[std::size_t(c) & 15];
        } else {
            result += c;
        }
    }
    return result + '"';
}
inline std::string to_json(const char* text)
{
    return to_json(std::string_view(text));
}
inline std::string to_json(const std::string& text)
{
    return to_json(std::string_view(text));
}
inline std::string to_json(std::same_as<bool> auto value)
{
    return value ? "true" : "false";
}
template <std::integral Integer>
    requires(not std::same_as<Integer, bool>)
std::string to_json(Integer value)
{
    return std::to_string(value);
}
/// The shortest digits that give the same number back.
inline std::string to_json(double value)
{
    if (not std::isfinite(value))
        return "null";
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof(digits), value).ptr};
}
template <class Range>
    requires requires(const Range& range) { to_json(*range.begin()); }
std::string to_json(const Range& range)
{
    std::string result;
    for (const auto& value : range)
        result += (result.empty() ? "" : ",") + to_json(value);
    return "[" + result + "]";
}

class json_object {
public:
    template <class T>
    json_object& add(std::string_view name, const T& value)
    {
        return add_json(name, to_json(value));
    }
    json_object& add(std::string_view name, const json_object& value) { return add_json(name, value.text()); }
    json_object& add_json(std::string_view name, const std::string& value)
    {
        members_ += (members_.empty() ? "" : ",") + to_json(name) + ":" + value;
        return *this;
    }
    [[nodiscard]] std::string text() const { return "{" + members_ + "}"; }

private:
    std::string members_;
};

inline std::string to_json(const json_object& object)
{
    return object.text();
}

} // namespace kith::tool
