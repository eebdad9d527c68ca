// SPDX-License-Identifier: BSD-3-Clause
#include "vtu_piece.hpp"

#include "triangle_strip.hpp"

#include <kith/io/text/counted.hpp>
#include <kith/io/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace kith::io {

namespace {

/// VTK's numbers of the types of cells: the last type of points and lines, and the types that are faces.
constexpr double poly_line = 4, triangle = 5, triangle_strip = 6, polygon = 7, pixel = 8, quad = 9;

/// The array that marks cells of other pieces, and the bit of its values that does so.
constexpr std::string_view ghost_array = "vtkGhostType";
constexpr unsigned duplicate_cell = 1;

class piece_reader {
public:
    piece_reader(const vtu_declaration& declared, const vtu_numbers& numbers, vtu_words& words, bool is_joined)
        : declared_(declared), numbers_(numbers), words_(words), is_joined_(is_joined)
    {
    }

    vtu_piece read()
    {
        points_ = count_of("NumberOfPoints");
        read_points();
        declared_.is_poly_data ? read_poly_data() : read_cells();
        if (others_ != 0)
            soup().not_kept.emplace_back("points and lines");
        std::vector<std::size_t> vertices(points_);
        std::iota(vertices.begin(), vertices.end(), 0);
        add_attributes("PointData", vertices, soup().attributes.vertices);
        add_attributes("CellData", faces_, soup().attributes.faces);
        return std::move(result_);
    }

private:
    polygon_soup& soup() { return result_.soup; }
    const std::vector<xml_tag>& arrays_in(const std::string& section) const
    {
        static const std::vector<xml_tag> none;
        const auto found = declared_.arrays.find(section);
        return found == declared_.arrays.end() ? none : found->second;
    }
    [[nodiscard]] std::size_t count_of(std::string_view name) const
    {
        const std::string value = declared_.piece.attribute(name);
        if (value.empty() and declared_.is_poly_data and name != "NumberOfPoints")
            return 0;
        return text_cursor<text_kind::plain>(value).whole<std::size_t>([&] { return std::string(name); });
    }

    void read_points()
    {
        if (arrays_in("Points").empty()) {
            if (points_ == 0 and is_joined_)
                return;
            throw file_error("has no points");
        }
        const vtu_array array = vtu_array_of(arrays_in("Points").front());
        if (array.components != 3)
            throw file_error("its points have " + counted(array.components, "coordinate") + ", not 3");
        const auto values = numbers_.values(array, points_).numbers;
        for (std::size_t v = 0; v < points_; ++v) {
            const std::array<double, 3> point{values[3 * v], values[3 * v + 1], values[3 * v + 2]};
            if (not std::ranges::all_of(point, [](double x) { return std::isfinite(x); }))
                throw file_error("vertex " + std::to_string(v) +
                                 " has a coordinate that is not a finite number; give finite coordinates");
            soup().points.push_back(point);
        }
    }
    /// Returns the values of an array of the cells in a section. Errors: file_error if there is none.
    std::vector<double> of_cells(const std::string& section, const std::string& name, std::size_t count)
    {
        for (const xml_tag& tag : arrays_in(section))
            if (const vtu_array array = vtu_array_of(tag); array.name == name) {
                if (array.type.floating or array.components != 1)
                    throw file_error("the array '" + name + "' of the cells should have whole numbers");
                return numbers_.values(array, count).numbers;
            }
        throw file_error("the cells have no array '" + name + "'");
    }
    /// Calls use(cell, its vertices) for the cells of a section, which are numbered on from cells_.
    template <class Use>
    void for_each_cell(const std::string& section, std::size_t cells, const Use& use)
    {
        const auto ends = of_cells(section, "offsets", cells);
        if (not std::ranges::is_sorted(ends) or (not ends.empty() and ends.front() < 0))
            throw file_error("the offsets of the cells do not increase");
        if (not ends.empty() and ends.back() > most_corners)
            throw file_error("the offsets of the cells are beyond the end of any file");
        const auto vertices = of_cells(section, "connectivity", ends.empty() ? 0 : std::size_t(ends.back()));
        std::size_t begin = 0;
        for (const double cell_end : ends) {
            const std::size_t end = std::size_t(cell_end);
            corners_.clear();
            for (; begin < end; ++begin) {
                if (not(vertices[begin] >= 0 and vertices[begin] < double(points_)))
                    throw file_error("cell " + std::to_string(cells_) + " has a vertex that is not among the " +
                                     counted(points_, "vertex") + " of the file");
                corners_.push_back(std::size_t(vertices[begin]));
            }
            use(cells_, std::span<std::size_t>(corners_));
            ++cells_;
        }
    }
    void read_cells()
    {
        const std::size_t cells = count_of("NumberOfCells");
        if (cells == 0 and is_joined_ and arrays_in("Cells").empty())
            return;
        const auto types = of_cells("Cells", "types", cells);
        for_each_cell("Cells", cells, [&](std::size_t cell, std::span<std::size_t> corners) {
            if (types[cell] >= 1 and types[cell] <= poly_line)
                ++others_;
            else
                add_face(cell, types[cell], corners);
        });
    }
    /// Reads the faces of PolyData. Cell data have the order of the cells in VTK's memory: points, lines, polygons,
    /// strips.
    void read_poly_data()
    {
        others_ = count_of("NumberOfVerts") + count_of("NumberOfLines");
        cells_ = others_;
        for (const auto& [section, count, type] :
             {std::tuple("Polys", "NumberOfPolys", polygon), std::tuple("Strips", "NumberOfStrips", triangle_strip)})
            if (const std::size_t cells = count_of(count); cells != 0)
                for_each_cell(section, cells, [&, type = type](std::size_t cell, std::span<std::size_t> corners) {
                    add_face(cell, type, corners);
                });
    }
    void add_face(std::size_t cell, double type, std::span<std::size_t> corners)
    {
        auto& list = soup().faces;
        if (type == triangle_strip) {
            const std::size_t before = list.size();
            append_strip(list, corners, "cell " + std::to_string(cell));
            faces_.resize(faces_.size() + list.size() - before, cell);
            return;
        }
        const bool is_quad = type == quad or type == pixel;
        if (not is_quad and type != triangle and type != polygon)
            throw file_error("cell " + std::to_string(cell) + " is of type " +
                             std::to_string(std::size_t(std::clamp(type, 0., 255.))) +
                             " of VTK, which is not a face; save only the surface");
        const std::size_t degree = is_quad ? 4 : type == triangle ? 3 : std::max<std::size_t>(corners.size(), 3);
        if (corners.size() != degree)
            throw file_error("cell " + std::to_string(cell) + " has " + counted(corners.size(), "corner") +
                             ", not what its type has");
        if (type == pixel)
            std::swap(corners[2], corners[3]);
        faces_.push_back(cell);
        list.push_back(corners);
    }

    /// Returns true if a section gives the array a role, such as Normals.
    [[nodiscard]] bool is_named(const vtu_array& array, const std::string& section, std::string_view role) const
    {
        const auto found = declared_.sections.find(section);
        return not array.name.empty() and found != declared_.sections.end() and
               found->second.attribute(role) == array.name;
    }
    /// Returns the names of the attributes that the components of an array become.
    std::vector<std::string> names_of(const vtu_array& array, const std::string& section)
    {
        std::vector<std::string> result;
        const auto take = [&](std::span<const std::string_view> names) {
            result.assign(names.begin(), names.begin() + std::ptrdiff_t(array.components));
        };
        constexpr std::array<std::string_view, 6> colors{"RGB", "RGBA", "rgb", "rgba", "Colors", "colors"};
        if (array.components == 3 and is_named(array, section, "Normals"))
            take(normal_names);
        else if ((array.components == 2 or array.components == 3) and is_named(array, section, "TCoords"))
            take(texture_names);
        else if ((array.components == 3 or array.components == 4) and
                 std::ranges::find(colors, array.name) != colors.end())
            take(color_names);
        for (std::size_t i = result.size(); i < array.components; ++i)
            result.push_back(array.name + (array.components == 1 ? "" : "_" + std::to_string(i)));
        return result;
    }
    /// Returns a name that no earlier attribute has, and that is one word. Names by which PLY knows coordinates and the
    /// vertices of faces are not used. Cost: O(1) on average.
    std::string free_name(std::string name)
    {
        constexpr std::array<std::string_view, 5> taken{"x", "y", "z", "vertex_indices", "vertex_index"};
        std::ranges::replace_if(name, [](char c) { return (c >= 0 and c <= ' ') or c == 127; }, '_');
        const auto is_free = [&](const std::string& candidate) {
            return not candidate.empty() and std::ranges::find(taken, candidate) == taken.end() and
                   names_.insert(candidate).second;
        };
        std::string result = name;
        for (std::size_t& times = times_named_[name]; not is_free(result);)
            result = name + "_" + (++times == 1 ? "" : std::to_string(times));
        return result;
    }
    /// Reads an array that says how pieces are joined: ids or ghosts. Returns false for any other array, which is an
    /// attribute.
    bool take_joint(const vtu_array& array, const std::string& section, const std::vector<std::size_t>& elements)
    {
        const bool of_points = section == "PointData";
        const bool is_ghosts = array.name == ghost_array;
        const bool is_ids = array.name == (of_points ? "GlobalPointIds" : "GlobalCellIds") or
                            is_named(array, section, "GlobalIds");
        if (not is_joined_ or array.components != 1 or array.type.floating or not(is_ghosts or is_ids))
            return false;
        const auto [values, rounded] = numbers_.values(array, of_points ? points_ : cells_);
        if (rounded)
            throw file_error("the ids '" + shown(array.name) + "' are beyond 2^53; renumber the elements");
        if (is_ids) {
            auto& ids = of_points ? result_.point_ids : result_.cell_ids;
            ids.clear(); // of several such arrays the last one counts
            for (const std::size_t element : elements)
                ids.push_back(values[element]);
        } else if (not of_points) {
            result_.is_ghost.clear();
            for (const std::size_t element : elements)
                result_.is_ghost.push_back((unsigned(values[element]) & duplicate_cell) != 0);
        }
        return true;
    }
    /// Adds the attributes of the elements with these numbers.
    void add_attributes(const std::string& section, const std::vector<std::size_t>& elements,
                        std::vector<attribute>& attributes)
    {
        names_.clear();
        times_named_.clear();
        for (const xml_tag& tag : arrays_in(section)) {
            const vtu_array array = vtu_array_of(tag);
            if (take_joint(array, section, elements))
                continue;
            if (array.components > most_components)
                throw file_error("the array '" + shown(array.name) + "' has " + counted(array.components, "component") +
                                 ", " + std::to_string(most_components) + " are read at most");
            const auto [values, rounded] = numbers_.values(array, section == "PointData" ? points_ : cells_);
            if (rounded)
                soup().not_kept.push_back("digits beyond 2^53 of the array '" + shown(array.name) + "'");
            const auto names = names_of(array, section);
            const bool fits = array.type.bytes < 8 or array.type.floating;
            for (std::size_t i = 0; i < array.components; ++i) {
                attribute a{names[i], fits ? array.type : ply_number{8, true, true}, {}};
                for (const std::size_t element : elements)
                    a.values.push_back(stored(a, values[array.components * element + i], array.name));
                if (section == "CellData")
                    take_labels(a);
                if (a.labels.empty())
                    a.name = free_name(a.name);
                attributes.push_back(std::move(a));
            }
        }
    }
    /// Takes the words of an attribute if each value is the number of a word, and the first word says "none".
    void take_labels(attribute& a)
    {
        const auto found = words_.by_name.find(a.name);
        const bool is_shared = std::ranges::find(label_names, a.name) != std::end(label_names);
        if (not is_shared or found == words_.by_name.end() or found->second.empty() or
            not found->second.front().empty() or names_.contains(a.name))
            return;
        const auto is_number = [&](double x) { return x >= 0 and x < double(found->second.size()); };
        if (a.type.floating or not std::ranges::all_of(a.values, is_number))
            return;
        a.labels = found->second;
        words_.used.insert(a.name);
        names_.insert(a.name);
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

    const vtu_declaration& declared_;
    const vtu_numbers& numbers_;
    vtu_words& words_;
    bool is_joined_;
    std::size_t points_ = 0, cells_ = 0, others_ = 0; ///< others: points and lines
    std::vector<std::size_t> faces_;                  ///< the cells that are faces
    std::vector<std::size_t> corners_;                ///< of the cell that is read
    std::unordered_set<std::string> names_;           ///< of the attributes of a section so far
    std::unordered_map<std::string, std::size_t> times_named_;
    vtu_piece result_;
};

} // namespace

vtu_piece read_piece(const vtu_declaration& declared, const vtu_numbers& numbers, vtu_words& words, bool is_joined)
{
    return piece_reader(declared, numbers, words, is_joined).read();
}

} // namespace kith::io
