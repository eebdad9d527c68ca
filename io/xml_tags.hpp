// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kith::io {

/// A start or an end of an element, and the text behind it.
struct xml_tag {
    std::string_view name; ///< "/Points" at its end
    std::string_view attributes;
    std::string_view text; ///< to the next tag

    /// Errors: file_error for one without its second quote.
    [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/// Goes from tag to tag, without looking at how they lie in one another; comments are left out.
class xml_tags {
public:
    explicit xml_tags(std::string_view text) : text_(text) {}

    /// False at the end. Errors: file_error for a tag without its end.
    bool next(xml_tag& tag);
    /// All that is behind the last tag.
    [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

} // namespace kith::io
