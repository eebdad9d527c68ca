// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kith::io {

/// The start or the end tag of an element, and the text behind it.
struct xml_tag {
    std::string_view name; ///< "/Points" in an end tag
    std::string_view attributes;
    std::string_view text; ///< to the next tag

    /// Returns the value of an attribute, or an empty text if the tag lacks it. Errors: file_error for a value without
    /// its second quote.
    [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/// A cursor that goes from tag to tag, without regard to nesting. It skips comments.
class xml_tags {
public:
    explicit xml_tags(std::string_view text) : text_(text) {}

    /// Moves to the next tag. Returns false at the end. Errors: file_error for a tag without its end.
    bool next(xml_tag& tag);
    /// Returns everything behind the last tag.
    [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace kith::io
