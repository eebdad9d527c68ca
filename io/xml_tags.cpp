// SPDX-License-Identifier: BSD-3-Clause
#include "xml_tags.hpp"

#include <kith/io/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace kith::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Returns a text with the five escapes of XML replaced by their characters.
std::string plain_text(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, char>, 5> escapes{
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    while (not text.empty()) {
        const auto found = std::ranges::find_if(escapes, [&](const auto& e) { return text.starts_with(e.first); });
        result += found == escapes.end() ? text.front() : found->second;
        text.remove_prefix(found == escapes.end() ? 1 : found->first.size());
    }
    return result;
}

/// Returns the place where a tag ends, outside of quotation marks. A quoted text has no '<'; if it seems to have one,
/// its closing mark is missing.
std::size_t end_of_tag(std::string_view text, std::size_t begin)
{
    constexpr std::string_view ends = ">\"'";
    std::size_t at = text.find_first_of(ends, begin);
    while (at != text.npos and text[at] != '>') {
        const std::size_t close = text.find_first_of(text[at] == '"' ? "\"<" : "'<", at + 1);
        if (close == text.npos or text[close] == '<')
            return text.find('>', at);
        at = text.find_first_of(ends, close + 1);
    }
    return at;
}

} // namespace

std::string xml_tag::attribute(std::string_view wanted) const
{
    for (std::size_t at = 0; at < attributes.size();) {
        const std::size_t equals = attributes.find('=', at);
        if (equals == attributes.npos)
            break;
        const std::size_t open = attributes.find_first_of("\"'", equals);
        const std::size_t close = open == attributes.npos ? open : attributes.find(attributes[open], open + 1);
        if (close == attributes.npos)
            throw file_error("an attribute of the element '" + shown(name) + "' has no end");
        std::string_view key = attributes.substr(at, equals - at);
        key.remove_prefix(std::min(key.find_first_not_of(blanks), key.size()));
        key = key.substr(0, key.find_last_not_of(blanks) + 1);
        if (key == wanted)
            return plain_text(attributes.substr(open + 1, close - open - 1));
        at = close + 1;
    }
    return {};
}

bool xml_tags::next(xml_tag& tag)
{
    for (std::size_t begin = text_.find('<', at_); begin != text_.npos; begin = text_.find('<', at_)) {
        const bool is_comment = text_.substr(begin).starts_with("<!--");
        const std::size_t end = is_comment ? text_.find("-->", begin) : end_of_tag(text_, begin);
        if (end == text_.npos)
            throw file_error("the file ends inside of an element, which begins with '" +
                             shown(text_.substr(begin, 20)) + "'");
        at_ = end + (is_comment ? 3 : 1);
        if (text_[begin + 1] == '!' or text_[begin + 1] == '?')
            continue;
        const std::string_view inside = text_.substr(begin + 1, end - begin - 1);
        tag.name = inside.substr(0, inside.find_first_of(" \t\r\n"));
        if (tag.name.size() > 1 and tag.name.ends_with('/'))
            tag.name.remove_suffix(1);
        tag.attributes = inside.substr(tag.name.size());
        const std::size_t next = std::min(text_.find('<', at_), text_.size());
        tag.text = text_.substr(at_, next - at_);
        return true;
    }
    at_ = text_.size();
    return false;
}

} // namespace kith::io
