// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/format/obj_tag.hpp>

#include <kith/io/text/counted.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

namespace kith::io {

namespace {

using cursor = text_cursor<text_kind::with_continuations>;

/// The least sharpness with which an edge stays sharp for ever in OpenSubdiv's files.
constexpr double sharp_for_ever = 10;

struct tag_arguments {
    std::vector<std::size_t> whole;
    std::vector<double> numbers;
    std::vector<std::string_view> words;
};

/// Reads the three counts of arguments, and then the arguments.
tag_arguments read_arguments(cursor& text)
{
    std::string_view sizes = text.word();
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slash = sizes.find('/');
        if ((slash == sizes.npos) != (i == 2))
            text.refuse("a tag gives the numbers of its arguments as in 2/1/0");
        count[i] = text.whole<std::size_t>(sizes.substr(0, slash),
                                           [] { return std::string("a number of arguments of the tag"); });
        sizes.remove_prefix(i == 2 ? sizes.size() : slash + 1);
    }
    const auto what = [] { return std::string("an argument of the tag"); };
    const auto require_one_more = [&] {
        if (text.at_line_end())
            text.refuse("the tag has fewer arguments than it says");
    };
    tag_arguments result;
    for (std::size_t i = 0; i < count[0]; ++i) {
        require_one_more();
        result.whole.push_back(text.whole<std::size_t>(what));
    }
    for (std::size_t i = 0; i < count[1]; ++i) {
        require_one_more();
        result.numbers.push_back(text.number(what));
    }
    for (std::size_t i = 0; i < count[2]; ++i) {
        require_one_more();
        result.words.push_back(text.word());
    }
    if (not text.at_line_end())
        text.refuse("the tag has more arguments than it says");
    return result;
}

/// Returns the sharpness of the i-th of several elements. `given` has one value per element, or one for all.
double sharpness_at(cursor& text, const std::vector<double>& given, std::size_t i, std::size_t elements)
{
    if (given.size() != 1 and given.size() != elements)
        text.refuse("the tag should have one sharpness, or " + std::to_string(elements));
    const double sharpness = given[given.size() == 1 ? 0 : i];
    if (sharpness < 0)
        text.refuse("a sharpness is 0 or more");
    return sharpness >= sharp_for_ever ? infinitely_sharp : sharpness;
}

std::string sharpness_text(double sharpness)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), std::min(sharpness, sharp_for_ever)).ptr;
    return {digits.data(), end};
}

} // namespace

void read_obj_tag(cursor& text, mesh_tags& tags)
{
    const auto name = text.word();
    const tag_arguments arguments = read_arguments(text);
    const auto& whole = arguments.whole;
    if (name == "crease") {
        if (whole.size() < 2)
            text.refuse("a crease runs from one vertex to another");
        for (std::size_t i = 0; i + 1 < whole.size(); ++i)
            tags.edges.push_back({whole[i], whole[i + 1], sharpness_at(text, arguments.numbers, i, whole.size() - 1)});
    } else if (name == "corner") {
        for (std::size_t i = 0; i < whole.size(); ++i)
            tags.vertices.emplace_back(whole[i], sharpness_at(text, arguments.numbers, i, whole.size()));
    } else if (name == "hole") {
        tags.holes.insert(tags.holes.end(), whole.begin(), whole.end());
    } else if (name == "interpolateboundary" and whole.size() == 1 and whole[0] <= 2) {
        tags.corners = whole[0] == 1 ? boundary_corner::kept : boundary_corner::smoothed;
        tags.boundary_is_hole = whole[0] == 0;
    } else if (name == "creasemethod" and arguments.words.size() == 1 and
               (arguments.words[0] == "chaikin" or arguments.words[0] == "normal")) {
        tags.method = arguments.words[0] == "chaikin" ? crease_method::chaikin : crease_method::uniform;
    } else {
        tags.unread.push_back({text.line(), shown(name)});
    }
}

std::string obj_tag_lines(const mesh_tags& tags)
{
    std::string result;
    for (const auto& [from, to, sharpness] : tags.edges)
        result += "t crease 2/1/0 " + std::to_string(from) + " " + std::to_string(to) + " " +
                  sharpness_text(sharpness) + "\n";
    for (const auto& [vertex, sharpness] : tags.vertices)
        result += "t corner 1/1/0 " + std::to_string(vertex) + " " + sharpness_text(sharpness) + "\n";
    for (const std::size_t face : tags.holes)
        result += "t hole 1/0/0 " + std::to_string(face) + "\n";
    if (tags.boundary_is_hole)
        result += "t interpolateboundary 1/0/0 0\n";
    else if (tags.corners)
        result += "t interpolateboundary 1/0/0 " + std::string(*tags.corners == boundary_corner::kept ? "1" : "2") +
                  "\n";
    if (tags.method)
        result += "t creasemethod 0/0/1 " + std::string(*tags.method == crease_method::chaikin ? "chaikin" : "normal") +
                  "\n";
    return result;
}

} // namespace kith::io
