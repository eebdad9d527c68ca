// SPDX-License-Identifier: BSD-3-Clause
#include "obj_tag.hpp"

#include <array>
#include <string>
#include <string_view>

namespace kith::tool {

namespace {

struct tag_arguments {
    std::vector<std::size_t> whole;
    std::vector<double> numbers;
    std::vector<std::string_view> words;
};

/// The three sizes, and then so many arguments.
tag_arguments read_arguments(text_scanner& scan)
{
    std::string_view sizes = scan.word();
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slash = sizes.find('/');
        if ((slash == sizes.npos) != (i == 2))
            scan.refuse("a tag gives the numbers of its arguments as in 2/1/0");
        count[i] = scan.whole<std::size_t>(sizes.substr(0, slash),
                                           [] { return std::string("a number of arguments of the tag"); });
        sizes.remove_prefix(i == 2 ? sizes.size() : slash + 1);
    }
    tag_arguments result;
    const auto next = [&] {
        const auto word = scan.word();
        if (word.empty())
            scan.refuse("the tag has fewer arguments than it says");
        return word;
    };
    for (std::size_t i = 0; i < count[0]; ++i)
        result.whole.push_back(scan.whole<std::size_t>(next(), [] { return std::string("an argument of the tag"); }));
    for (std::size_t i = 0; i < count[1]; ++i)
        result.numbers.push_back(scan.number(next(), [] { return std::string("an argument of the tag"); }));
    for (std::size_t i = 0; i < count[2]; ++i)
        result.words.push_back(next());
    if (not scan.word().empty())
        scan.refuse("the tag has more arguments than it says");
    return result;
}

/// The sharpness of the i-th of several elements, which have one each or one for all.
double sharpness_at(text_scanner& scan, const std::vector<double>& given, std::size_t i, std::size_t elements)
{
    if (given.size() != 1 and given.size() != elements)
        scan.refuse("the tag should have one sharpness, or " + std::to_string(elements));
    const double sharpness = given[given.size() == 1 ? 0 : i];
    if (sharpness < 0)
        scan.refuse("a sharpness is 0 or more");
    return sharpness >= 10 ? infinitely_sharp : sharpness; // OpenSubdiv's convention
}

} // namespace

void read_obj_tag(text_scanner& scan, mesh_tags& tags)
{
    const auto name = scan.word();
    const tag_arguments arguments = read_arguments(scan);
    const auto& whole = arguments.whole;
    if (name == "crease") {
        if (whole.size() < 2)
            scan.refuse("a crease runs from one vertex to another");
        for (std::size_t i = 0; i + 1 < whole.size(); ++i)
            tags.edges.push_back({whole[i], whole[i + 1], sharpness_at(scan, arguments.numbers, i, whole.size() - 1)});
    } else if (name == "corner") {
        for (std::size_t i = 0; i < whole.size(); ++i)
            tags.vertices.emplace_back(whole[i], sharpness_at(scan, arguments.numbers, i, whole.size()));
    } else if (name == "hole") {
        tags.holes.insert(tags.holes.end(), whole.begin(), whole.end());
    } else if (name == "interpolateboundary" and whole.size() == 1 and whole[0] <= 2) {
        tags.corners = whole[0] == 1 ? boundary_corner::kept : boundary_corner::smoothed;
        tags.boundary_is_hole = whole[0] == 0;
    } else if (name == "creasemethod" and arguments.words.size() == 1 and
               (arguments.words[0] == "chaikin" or arguments.words[0] == "normal")) {
        tags.method = arguments.words[0] == "chaikin" ? crease_method::chaikin : crease_method::uniform;
    } else {
        ++tags.unread;
    }
}

} // namespace kith::tool
