// SPDX-License-Identifier: BSD-3-Clause
#include "vtu_numbers.hpp"

#include <kith/read_mesh.hpp>
#include <kith/text/counted.hpp>
#include <kith/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace kith::io {

namespace {

/// VTK's numbers of the last cell that is of points and lines, and of those that are faces.
constexpr double poly_line = 4, triangle = 5, polygon = 7, pixel = 8, quad = 9;

/// Others, and what is told about an array inside of it, are passed over.
constexpr std::array<std::string_view, 5> sections_that_are_read{
    "FieldData", "Points", "Cells", "PointData", "CellData"};

class vtu_reader {
public:
    explicit vtu_reader(std::string_view bytes) : tags_(bytes) {}

    polygon_soup read()
    {
        collect();
        read_points();
        read_cells();
        add_attributes("PointData", all(points_), soup_.attributes.vertices);
        add_attributes("CellData", faces_, soup_.attributes.faces);
        for (const auto& [name, words] : words_)
            soup_.not_kept.push_back("the field data '" + shown(name) + "'");
        return std::move(soup_);
    }

private:
    /// Reads what the file declares.
    void collect()
    {
        xml_tag tag;
        std::size_t pieces = 0;
        std::string section;
        while (tags_.next(tag)) {
            if (tag.name == "VTKFile") {
                if (const auto type = tag.attribute("type"); type != "UnstructuredGrid")
                    throw file_error("holds " + shown(type) + ", not an UnstructuredGrid; save it as one");
                numbers_.emplace(tag);
            } else if (tag.name == "AppendedData") {
                require_begun().set_appended(tag, tags_.rest());
                break;
            } else if (tag.name == "Piece") {
                if (++pieces > 1)
                    throw file_error("has several pieces; save it as one");
                points_ = count_of(tag, "NumberOfPoints");
                cells_ = count_of(tag, "NumberOfCells");
            } else if (tag.name == "DataArray" and section == "FieldData") {
                add_words(tag);
            } else if (tag.name == "DataArray" and not section.empty()) {
                arrays_[section].push_back(tag);
            } else if (tag.name == "/" + section or tag.name == "/Piece") {
                section.clear();
            } else if (not tag.attributes.ends_with('/') and
                       std::ranges::find(sections_that_are_read, tag.name) != sections_that_are_read.end()) {
                section = tag.name;
                sections_[section] = tag;
            }
        }
        (void)require_begun();
        if (pieces == 0)
            throw file_error("has no piece with points and cells");
    }
    vtu_numbers& require_begun()
    {
        if (not numbers_)
            throw file_error("a file of VTK begins with the element VTKFile, which is not there");
        return *numbers_;
    }
    /// What is said of the file as a whole: words for which the numbers of an array of that name stand.
    void add_words(const xml_tag& tag)
    {
        std::vector<std::string> words;
        if (tag.attribute("type") == "String" and tag.attribute("format") == "ascii") {
            std::string word;
            text_cursor<text_kind::plain> text(tag.text);
            while (text.to_content()) {
                const int letter = text.whole<int>([] { return std::string("a letter of a word"); });
                if (letter < std::numeric_limits<signed char>::min() or
                    letter > std::numeric_limits<unsigned char>::max())
                    throw file_error("the words '" + shown(tag.attribute("Name")) + "' have the letter " +
                                     std::to_string(letter) + ", which is none");
                if (letter != 0)
                    word += letter > 0 and letter < ' ' ? '_' : char(letter); // lines of OBJ end there
                else
                    words.push_back(std::exchange(word, {}));
            }
        }
        words_[tag.attribute("Name")] = words;
    }
    static std::size_t count_of(const xml_tag& tag, std::string_view name)
    {
        const std::string value = tag.attribute(name);
        return text_cursor<text_kind::plain>(value).whole<std::size_t>([&] { return std::string(name); });
    }
    static std::vector<std::size_t> all(std::size_t count)
    {
        std::vector<std::size_t> result(count);
        for (std::size_t i = 0; i < count; ++i)
            result[i] = i;
        return result;
    }

    void read_points()
    {
        if (arrays_["Points"].empty())
            throw file_error("has no points");
        const vtu_array array = vtu_array_of(arrays_["Points"].front());
        if (array.components != 3)
            throw file_error("its points have " + counted(array.components, "coordinate") + ", not 3");
        const auto values = numbers_->values(array, points_).numbers;
        for (std::size_t v = 0; v < points_; ++v) {
            const std::array<double, 3> point{values[3 * v], values[3 * v + 1], values[3 * v + 2]};
            if (not std::ranges::all_of(point, [](double x) { return std::isfinite(x); }))
                throw file_error("vertex " + std::to_string(v) + " has no finite place");
            soup_.points.push_back(point);
        }
    }
    /// The values of an array of the cells. Errors: file_error when there is none.
    std::vector<double> of_cells(const std::string& name, std::size_t count)
    {
        for (const xml_tag& tag : arrays_["Cells"])
            if (const vtu_array array = vtu_array_of(tag); array.name == name) {
                if (array.type.floating or array.components != 1)
                    throw file_error("the array '" + name + "' of the cells should have whole numbers");
                return numbers_->values(array, count).numbers;
            }
        throw file_error("the cells have no array '" + name + "'");
    }
    void read_cells()
    {
        const auto ends = of_cells("offsets", cells_), types = of_cells("types", cells_);
        if (not std::ranges::is_sorted(ends) or (not ends.empty() and ends.front() < 0))
            throw file_error("the offsets of the cells do not increase");
        if (not ends.empty() and ends.back() > most_corners)
            throw file_error("the offsets of the cells are beyond the end of any file");
        const auto vertices = of_cells("connectivity", ends.empty() ? 0 : std::size_t(ends.back()));
        std::size_t begin = 0, others = 0;
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            const std::size_t end = std::size_t(ends[cell]);
            const std::span corners(vertices.data() + begin, end - begin);
            begin = end;
            for (const double v : corners)
                if (not(v >= 0 and v < double(points_)))
                    throw file_error("cell " + std::to_string(cell) + " has a vertex that is not among the " +
                                     counted(points_, "vertex") + " of the file");
            if (types[cell] >= 1 and types[cell] <= poly_line) {
                ++others;
                continue;
            }
            add_face(cell, types[cell], corners);
        }
        if (others != 0)
            soup_.not_kept.push_back("points and lines");
    }
    void add_face(std::size_t cell, double type, std::span<const double> corners)
    {
        const bool is_quad = type == quad or type == pixel;
        if (not is_quad and type != triangle and type != polygon)
            throw file_error("cell " + std::to_string(cell) + " is of type " +
                             std::to_string(std::size_t(std::clamp(type, 0., 255.))) +
                             " of VTK, which is no face; take the surface alone");
        const std::size_t degree = is_quad ? 4 : type == triangle ? 3 : std::max<std::size_t>(corners.size(), 3);
        if (corners.size() != degree)
            throw file_error("cell " + std::to_string(cell) + " has " + counted(corners.size(), "corner") +
                             ", not what its type has");
        faces_.push_back(cell);
        auto& list = soup_.faces;
        for (const double v : corners)
            list.vertices.push_back(std::size_t(v));
        if (type == pixel)
            std::swap(list.vertices[list.vertices.size() - 1], list.vertices[list.vertices.size() - 2]);
        list.first.push_back(list.vertices.size());
    }

    /// The names that the components of an array have as attributes.
    std::vector<std::string> names_of(const vtu_array& array, const std::string& section)
    {
        std::vector<std::string> result;
        const auto take = [&](std::span<const std::string_view> names) {
            result.assign(names.begin(), names.begin() + std::ptrdiff_t(array.components));
        };
        const auto is_named = [&](const char* role) {
            return not array.name.empty() and sections_[section].attribute(role) == array.name;
        };
        constexpr std::array<std::string_view, 6> colors{"RGB", "RGBA", "rgb", "rgba", "Colors", "colors"};
        if (array.components == 3 and is_named("Normals"))
            take(normal_names);
        else if ((array.components == 2 or array.components == 3) and is_named("TCoords"))
            take(texture_names);
        else if ((array.components == 3 or array.components == 4) and
                 std::ranges::find(colors, array.name) != colors.end())
            take(color_names);
        for (std::size_t i = result.size(); i < array.components; ++i)
            result.push_back(array.name + (array.components == 1 ? "" : "_" + std::to_string(i)));
        return result;
    }
    /// A name that no other attribute has, and that is one word; some say in PLY where vertices are and which ones a
    /// face has. `given`: for each name, which other one has been given for it last.
    static std::string free_name(std::string name, const std::vector<attribute>& others,
                                 std::map<std::string, std::string>& given)
    {
        constexpr std::array<std::string_view, 5> taken{"x", "y", "z", "vertex_indices", "vertex_index"};
        std::ranges::replace_if(name, [](char c) { return (c >= 0 and c <= ' ') or c == 127; }, '_');
        std::string& last = given[name];
        name = last.empty() ? name : last + '_';
        while (name.empty() or std::ranges::find(taken, name) != taken.end() or
               std::ranges::find(others, name, &attribute::name) != others.end())
            name += '_';
        return last = name;
    }
    /// Of the elements with these numbers.
    void add_attributes(const std::string& section, const std::vector<std::size_t>& elements,
                        std::vector<attribute>& attributes)
    {
        std::map<std::string, std::string> given;
        for (const xml_tag& tag : arrays_[section]) {
            const vtu_array array = vtu_array_of(tag);
            if (array.components > most_components)
                throw file_error("the array '" + shown(array.name) + "' has " + counted(array.components, "component") +
                                 ", " + std::to_string(most_components) + " are read at most");
            const auto [values, rounded] = numbers_->values(array, section == "PointData" ? points_ : cells_);
            if (rounded)
                soup_.not_kept.push_back("digits beyond 2^53 of the array '" + shown(array.name) + "'");
            const auto names = names_of(array, section);
            const bool fits = array.type.bytes < 8 or array.type.floating;
            for (std::size_t i = 0; i < array.components; ++i) {
                attribute a{names[i], fits ? array.type : ply_number{8, true, true}, {}};
                for (const std::size_t element : elements)
                    a.values.push_back(stored(a, values[array.components * element + i], array.name));
                if (section == "CellData")
                    take_labels(a);
                if (a.labels.empty())
                    a.name = free_name(a.name, attributes, given);
                attributes.push_back(std::move(a));
            }
        }
    }
    /// The words of an attribute, where each value is the number of one and the first says none.
    void take_labels(attribute& a)
    {
        const auto found = words_.find(a.name);
        const bool is_shared = std::ranges::find(label_names, a.name) != std::end(label_names);
        if (not is_shared or found == words_.end() or found->second.empty() or not found->second.front().empty())
            return;
        const auto is_number = [&](double x) { return x >= 0 and x < double(found->second.size()); };
        if (a.type.floating or not std::ranges::all_of(a.values, is_number))
            return;
        a.labels = std::move(found->second);
        words_.erase(found);
    }
    static double stored(const attribute& a, double value, const std::string& name)
    {
        const double result = as_stored(a.type, value);
        if (not a.type.floating and result != value)
            throw file_error("a number of the array '" + shown(name) + "' does not fit its type");
        return result;
    }

    static constexpr std::size_t most_components = 16;
    static constexpr double most_corners = 0x1p56;

    xml_tags tags_;
    std::optional<vtu_numbers> numbers_;
    std::map<std::string, std::vector<xml_tag>> arrays_; ///< of points, cells and their data
    std::map<std::string, xml_tag> sections_;
    std::map<std::string, std::vector<std::string>> words_; ///< of arrays, until one has taken them
    std::size_t points_ = 0, cells_ = 0;
    std::vector<std::size_t> faces_; ///< the cells that are faces
    polygon_soup soup_;
};

} // namespace

polygon_soup read_vtu(std::string_view bytes)
{
    return vtu_reader(bytes).read();
}

} // namespace kith::io
