// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_array.hpp"
#include "vtu_layout.hpp"

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::detail {

inline std::string xml_text(const std::string& text)
{
    constexpr std::array<std::pair<char, std::string_view>, 4> escapes{
        {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};
    std::string result;
    for (const char letter : text) {
        const auto escape = std::ranges::find(escapes, letter, &std::pair<char, std::string_view>::first);
        escape == escapes.end() ? void(result += letter) : void(result += escape->second);
    }
    return result;
}

/// The arrays of fields in a VTK file, beside the file's own arrays.
class vtu_arrays {
public:
    /// Returns true if a field may have this name: it is not empty, and none of the file's own arrays has it.
    static bool is_free(std::string_view name)
    {
        constexpr std::array<std::string_view, 10> taken{"connectivity",
                                                         "offsets",
                                                         "types",
                                                         "Normals",
                                                         "GlobalPointIds",
                                                         "GlobalCellIds",
                                                         "parent",
                                                         "level",
                                                         "tile",
                                                         "rank"};
        return not name.empty() and std::ranges::find(taken, name) == taken.end();
    }

    /// Takes the arrays. Errors: mesh_error for fields on edges or corners, and for a name that is empty or taken. One
    /// array of points and one of cells may share a name.
    explicit vtu_arrays(std::vector<file_array> arrays) : arrays_(std::move(arrays))
    {
        for (const auto& array : arrays_)
            if (array.on != field_on::vertices and array.on != field_on::faces)
                throw mesh_error("the field \"" + array.name +
                                 "\" is on edges or corners, where a file of VTK has no values; leave it out");
        std::set<std::pair<field_on, std::string_view>> names;
        for (const file_array& array : arrays_)
            if (not is_free(array.name) or not names.insert({array.on, array.name}).second)
                throw mesh_error("a field cannot be named \"" + array.name +
                                 "\": the name is empty, or another array of the file has it; give it another one");
    }

    [[nodiscard]] const std::vector<file_array>& list() const { return arrays_; }
    [[nodiscard]] bool any_on(field_on kind) const
    {
        return std::ranges::any_of(arrays_, [&](const auto& array) { return array.on == kind; });
    }
    /// Returns the declarations of the arrays on one kind of element, for the index of vtu_pieces.
    [[nodiscard]] std::string declarations(field_on kind) const
    {
        std::string result;
        for (const auto& array : arrays_)
            if (array.on == kind)
                result += "<PDataArray " + attributes(array) + "/>\n";
        return result;
    }
    /// Adds the arrays on one kind of element to a layout and stores the number of each in `places`.
    void add_to(vtu_layout& layout, field_on kind, std::uint64_t elements, std::vector<std::size_t>& places) const
    {
        places.resize(arrays_.size());
        for (std::size_t i = 0; i < arrays_.size(); ++i)
            if (arrays_[i].on == kind) {
                places[i] = layout.add(elements * arrays_[i].bytes, attributes(arrays_[i]));
                if (not arrays_[i].words.empty())
                    layout.add_words(xml_text(arrays_[i].name), arrays_[i].words);
            }
    }

private:
    static std::string attributes(const file_array& array)
    {
        return "type=\"" + array.type + "\" Name=\"" + xml_text(array.name) + "\"" +
               (array.numbers == 1 ? "" : " NumberOfComponents=\"" + std::to_string(array.numbers) + "\"");
    }

    std::vector<file_array> arrays_;
};

} // namespace kith::detail
