// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/text/counted.hpp>
#include <kith/io/text/text_cursor.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

using off_cursor = text_cursor<text_kind::with_comments>;

/// The prefix of the keyword: [ST][C][N][4][n]OFF in any order, because programs do not agree on one.
struct off_keyword {
    bool texture = false, color = false, normal = false, homogeneous = false;
    bool has_dimension = false;  ///< the number of coordinates stands behind the keyword
    bool color_is_first = false; ///< the letter N stands before C: MeshLab, which writes colours before normals

    [[nodiscard]] int coordinates() const { return homogeneous ? 4 : 3; }
    [[nodiscard]] int numbers() const { return coordinates() + (normal ? 3 : 0) + (color ? 4 : 0) + (texture ? 2 : 0); }
};

constexpr double no_component = std::numeric_limits<double>::quiet_NaN();

/// A number of a file, and whether it is written with a point or an exponent.
struct off_number {
    double value = 0;
    bool has_point = false;
};
using off_numbers = std::span<const off_number>;

bool is_byte(double x)
{
    return x == std::floor(x) and x >= 0 and x <= 255;
}
bool is_share(double x)
{
    return x >= 0 and x <= 1;
}
bool is_larger_than_one(const off_number& x)
{
    return x.value > 1;
}

/// The colours of some elements, with three or four numbers each. Each colour has its own kind: whole numbers from 0 to
/// 255, or numbers from 0 to 1, which have a point.
class colors {
public:
    void add(std::size_t element, off_numbers color)
    {
        kinds_.resize(element, kind::none);
        values_.resize(4 * element, no_component);
        const auto rgb = color.first(3);
        const bool are_bytes = std::ranges::all_of(rgb, is_byte, &off_number::value);
        kind of_color = are_bytes and std::ranges::any_of(rgb, is_larger_than_one)        ? kind::bytes
                        : are_bytes and std::ranges::none_of(rgb, &off_number::has_point) ? kind::zeros_and_ones
                                                                                          : kind::shares;
        double alpha = color.size() == 4 ? color[3].value : no_component;
        if (of_color == kind::zeros_and_ones and alpha > 1 and is_byte(alpha))
            of_color = kind::bytes;
        const bool is_share_beside_bytes = of_color == kind::bytes and color.size() == 4 and color[3].has_point and
                                           is_share(alpha);
        const double unit = is_share_beside_bytes ? 255 : 1;
        if (is_share_beside_bytes)
            of_color = kind::shares;
        else if (of_color == kind::shares and alpha > 1 and is_byte(alpha))
            alpha /= 255;
        for (const off_number& x : rgb)
            values_.push_back(x.value / unit);
        values_.push_back(alpha);
        kinds_.push_back(of_color);
        has_alpha_ |= color.size() == 4;
    }
    /// Appends the attributes: bytes if all colours are bytes, else numbers from 0 to 1. A colour of zeros and ones has
    /// the kind of the other colours.
    void give(std::vector<attribute>& attributes, std::size_t elements)
    {
        if (kinds_.empty())
            return;
        kinds_.resize(elements, kind::none);
        values_.resize(4 * elements, no_component);
        const bool some_are_bytes = std::ranges::find(kinds_, kind::bytes) != kinds_.end();
        const bool all_are_bytes = some_are_bytes and std::ranges::find(kinds_, kind::shares) == kinds_.end();
        const std::size_t first = attributes.size();
        for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
            attributes.emplace_back().name = color_names[i];
            if (all_are_bytes)
                attributes.back().type = {1, false, false};
            for (std::size_t element = 0; element < elements; ++element) {
                const kind of_color = kinds_[element];
                const bool is_in_bytes = of_color == kind::bytes or
                                         (of_color == kind::zeros_and_ones and some_are_bytes);
                const double full = is_in_bytes ? 255 : 1, x = values_[4 * element + i];
                const bool is_opaque = i == 3 and std::isnan(x) and of_color != kind::none;
                attributes[first + i].values.push_back((is_opaque ? full : x) / (all_are_bytes ? 1 : full));
            }
        }
    }

private:
    enum class kind : unsigned char { none, bytes, shares, zeros_and_ones };

    std::vector<kind> kinds_;    ///< up to the last element that has a colour
    std::vector<double> values_; ///< four per element
    bool has_alpha_ = false;
};

/// A vertex has four coordinates, a normal, a color of four and a texture coordinate of two numbers at most.
constexpr int most_numbers = 13;

/// The numbers of a vertex behind its coordinates.
struct vertex_numbers {
    std::array<off_number, most_numbers> numbers{};
    std::size_t count = 0;

    [[nodiscard]] off_numbers all() const { return std::span(numbers).first(count); }
};

bool is_plausible_color(off_numbers color)
{
    return std::ranges::all_of(color, is_share, &off_number::value) or
           std::ranges::all_of(color, is_byte, &off_number::value);
}
/// Returns true if the vector has length 1, or length 0 as for a vertex without a normal.
bool is_plausible_normal(off_numbers n)
{
    constexpr double tolerance = 0.02; // programs write few digits
    const double square = n[0].value * n[0].value + n[1].value * n[1].value + n[2].value * n[2].value;
    return square == 0 or std::abs(square - 1) < tolerance;
}

off_keyword read_keyword(off_cursor& text)
{
    const std::string_view keyword = text.word();
    const auto refuse = [&] {
        text.refuse("an OFF file begins with the word OFF, this one with '" + shown(keyword) + "'");
    };
    std::string capitals(keyword.substr(0, 16)); // some programs write the word in small letters
    std::ranges::transform(capitals, capitals.begin(), [](char c) { return c >= 'a' and c <= 'z' ? char(c - 32) : c; });
    if (keyword.size() > 16 or not capitals.ends_with("OFF"))
        refuse();
    const bool is_small = keyword.ends_with("off"); // then n may stand for N
    off_keyword result;
    for (std::size_t at = 0; at != keyword.size() - 3;) {
        const std::string_view rest = std::string_view(capitals).substr(at);
        bool* const is_there = rest.starts_with("ST")                ? &result.texture
                               : rest[0] == 'C'                      ? &result.color
                               : rest[0] == '4'                      ? &result.homogeneous
                               : keyword[at] == 'n' and not is_small ? &result.has_dimension
                               : rest[0] == 'N'                      ? &result.normal
                                                                     : nullptr;
        if (is_there == nullptr or *is_there)
            refuse();
        *is_there = true;
        result.color_is_first |= result.normal and not result.color;
        at += is_there == &result.texture ? 2 : 1;
    }
    return result;
}

class off_reader {
public:
    explicit off_reader(std::string_view bytes) : bytes_(bytes), text_(bytes) {}

    polygon_soup read()
    {
        to_content([] { return std::string("the word OFF"); });
        keyword_ = read_keyword(text_);
        read_counts();
        soup_.points.reserve(vertices_);
        soup_.faces.first.reserve(faces_ + 1);
        soup_.faces.vertices.reserve(std::min(3 * faces_, text_.left() / 2));
        in_lines_ = lines_hold_elements();
        if (keyword_.color and keyword_.normal)
            find_order();
        for (std::size_t v = 0; v < vertices_; ++v)
            read_vertex(v);
        for (std::size_t f = 0; f < faces_; ++f)
            read_face(f);
        if (text_.to_content()) {
            (void)text_.word();
            text_.refuse("the file goes on after its " + counted(vertices_, "vertex") + " and " +
                         counted(faces_, "face"));
        }
        take_attributes();
        return std::move(soup_);
    }

private:
    /// Moves to the next word. Errors: file_error at the end of the file.
    template <std::invocable Wanted>
    void to_content(const Wanted& wanted)
    {
        if (not text_.to_content())
            throw file_error("the file ends where " + wanted() + " should be");
    }
    void read_counts()
    {
        to_content([] { return std::string("the numbers of vertices and faces"); });
        if (off_cursor ahead = text_; ahead.word() == "BINARY")
            text_.refuse_here(
                "binary OFF is not read, as programs do not agree on its byte order; save it as text or as PLY");
        if (keyword_.has_dimension)
            read_dimension();
        vertices_ = text_.whole<std::size_t>([] { return std::string("the number of vertices"); });
        faces_ = text_.whole<std::size_t>([] { return std::string("the number of faces"); });
        if (not text_.at_line_end())
            (void)text_.whole<std::ptrdiff_t>([] { return std::string("the number of edges"); });
        // The shortest vertex is "0 0 0\n" and the shortest face "0\n".
        const std::size_t room = text_.left() + 1;
        if (vertices_ > room / 6 or faces_ > (room - 6 * vertices_) / 2)
            text_.refuse("the file is too short for " + counted(vertices_, "vertex") + " and " +
                         counted(faces_, "face"));
    }
    /// Reads the number of coordinates, without a homogeneous one, that nOFF gives.
    void read_dimension()
    {
        const auto dimension = text_.whole<std::size_t>([] { return std::string("the number of coordinates"); });
        if (dimension != 3)
            text_.refuse("vertices have " + counted(dimension, "coordinate") + ", but three are needed; write three");
        to_content([] { return std::string("the numbers of vertices and faces"); });
    }
    /// Decides by the first vertices whether colours or normals come first, because programs do not agree and both are
    /// three numbers. Normals have length 1; colours are bytes or numbers from 0 to 1. If all numbers fit both orders,
    /// the keyword decides, which is noted.
    void find_order()
    {
        constexpr std::size_t most_vertices = 4096;
        const off_cursor begin = text_;
        std::array<std::size_t, 2> doubts{}; // normals first, colours first
        for (std::size_t v = 0; v < std::min(vertices_, most_vertices); ++v) {
            (void)read_place(v);
            const vertex_numbers found = read_numbers(v);
            for (const bool color_is_first : {false, true})
                if (const auto parts = parts_of(found.all(), color_is_first); parts and not parts->color.empty())
                    doubts[color_is_first] += not is_plausible_color(parts->color) or
                                              not is_plausible_normal(parts->normal);
        }
        text_ = begin;
        if (doubts[0] != doubts[1])
            keyword_.color_is_first = doubts[1] < doubts[0];
        else if (doubts[0] != 0)
            return; // no order is as it should be, and the keyword decides
        else if (keyword_.color_is_first)
            soup_.notes.emplace_back("the order of vertex colours and normals is ambiguous; colours are read "
                                     "first, as MeshLab writes them after NC");
        else
            soup_.notes.emplace_back("the order of vertex normals and colours is ambiguous; normals are read "
                                     "first, as Geomview writes them after CN");
    }
    /// Returns true if vertices and faces have their own lines, in which colors may follow them. The format does not
    /// require lines, and some files have all numbers in one line. Then only the numbers that the keyword names stand
    /// between them.
    bool lines_hold_elements()
    {
        const auto numbers_in_line = [](off_cursor text) {
            std::size_t result = 0;
            while (not text.word().empty())
                ++result;
            return result;
        };
        const std::size_t all = vertices_ * std::size_t(keyword_.numbers());
        if (const std::size_t more = numbers_in_line(text_); more != 0) {
            if (more >= all and vertices_ != 0)
                return false;
            (void)text_.word();
            text_.refuse("this line holds more than the numbers of vertices, faces and edges");
        }
        off_cursor first = text_;
        if (not first.to_content())
            return true;
        const std::size_t numbers = numbers_in_line(first);
        return numbers <= std::size_t(most_numbers) and (vertices_ < 2 or numbers < all);
    }
    static std::string name_of_vertex(std::size_t vertex) { return "vertex " + std::to_string(vertex); }
    /// Reads a number of this line.
    template <std::invocable What>
    off_number read_number(const What& what)
    {
        const std::size_t begin = text_.position();
        const double value = text_.number(what);
        const std::string_view digits = bytes_.substr(begin, text_.position() - begin);
        return {value, digits.find_first_of(".eE") != digits.npos};
    }
    void read_vertex(std::size_t vertex)
    {
        soup_.points.push_back(read_place(vertex));
        take_numbers(vertex, read_numbers(vertex).all());
    }
    std::array<double, 3> read_place(std::size_t vertex)
    {
        const auto what = [&] { return name_of_vertex(vertex); };
        to_content([&] { return what() + " of " + std::to_string(vertices_); });
        const int coordinates = keyword_.coordinates();
        std::array<double, 4> p{};
        for (int i = 0; i < coordinates; ++i) {
            if (text_.at_line_end() and (in_lines_ or not text_.to_content()))
                text_.refuse(what() + " has " + counted(std::size_t(i), "coordinate") + ", " +
                             std::to_string(coordinates) + " are needed");
            p[std::size_t(i)] = text_.number(what);
        }
        if (keyword_.homogeneous) {
            if (p[3] == 0)
                text_.refuse(what() + " lies at infinity, its fourth coordinate is 0; give finite coordinates");
            for (int i = 0; i < 3; ++i)
                p[std::size_t(i)] /= p[3];
            if (not(std::isfinite(p[0]) and std::isfinite(p[1]) and std::isfinite(p[2])))
                text_.refuse(what() +
                             " does not have finite coordinates, its fourth one is too small; give finite coordinates");
        }
        return {p[0], p[1], p[2]};
    }
    /// Reads the numbers behind the coordinates: those of the line, or as many as the keyword says.
    vertex_numbers read_numbers(std::size_t vertex)
    {
        const auto what = [&] { return name_of_vertex(vertex); };
        vertex_numbers result;
        const auto read = [&] {
            const off_number x = read_number(what);
            if (result.count++ < result.numbers.size())
                result.numbers[result.count - 1] = x;
        };
        if (in_lines_)
            while (not text_.at_line_end())
                read();
        else
            while (int(result.count) < keyword_.numbers() - keyword_.coordinates()) {
                to_content(what);
                read();
            }
        if (result.count > std::size_t(most_numbers - 4))
            text_.refuse(what() + " has too many numbers; each vertex has a line of its own");
        return result;
    }
    struct number_parts {
        off_numbers normal, color, texture;
    };
    /// Divides the numbers behind the coordinates; a vertex may lack its colour. Returns nothing if their count does
    /// not fit the keyword.
    [[nodiscard]] std::optional<number_parts> parts_of(off_numbers all, bool color_is_first) const
    {
        const std::size_t normal = keyword_.normal ? 3 : 0, texture = keyword_.texture ? 2 : 0;
        if (all.size() < normal + texture)
            return std::nullopt;
        const std::size_t color = all.size() - normal - texture;
        if (color != 0 and not(keyword_.color and (color == 3 or color == 4)))
            return std::nullopt;
        return number_parts{all.subspan(color_is_first ? color : 0, normal),
                            all.subspan(color_is_first ? 0 : normal, color),
                            all.last(texture)};
    }
    void take_numbers(std::size_t vertex, off_numbers numbers)
    {
        if (numbers.empty())
            return;
        const auto parts = parts_of(numbers, keyword_.color_is_first);
        if (not parts) {
            has_other_numbers_ = true;
            return;
        }
        const auto add = [&](std::vector<std::vector<double>>& columns, off_numbers values) {
            columns.resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                columns[i].resize(vertex, no_component);
                columns[i].push_back(values[i].value);
            }
        };
        if (keyword_.normal)
            add(normals_, parts->normal);
        if (not parts->color.empty())
            vertex_colors_.add(vertex, parts->color);
        if (keyword_.texture)
            add(textures_, parts->texture);
    }
    void read_face(std::size_t face)
    {
        const auto what = [&] { return "face " + std::to_string(face); };
        to_content([&] { return what() + " of " + std::to_string(faces_); });
        const auto degree = text_.whole<std::size_t>([&] { return what() + ": its number of corners"; });
        for (std::size_t i = 0; i < degree; ++i) {
            if (text_.at_line_end() and (in_lines_ or not text_.to_content()))
                text_.refuse(what() + " should have " + counted(degree, "corner") + ", " +
                             (i == 1 ? "1 is there" : std::to_string(i) + " are there"));
            const auto vertex = text_.whole<std::ptrdiff_t>([&] { return what() + ": a vertex"; });
            if (vertex < 0 or std::size_t(vertex) >= vertices_)
                text_.refuse(what() + ": vertex " + std::to_string(vertex) + " does not exist, there are " +
                             std::to_string(vertices_) + "; correct the index");
            soup_.faces.vertices.push_back(std::size_t(vertex));
        }
        soup_.faces.first.push_back(soup_.faces.vertices.size());
        if (not in_lines_)
            return;
        std::array<off_number, 4>
            color{}; // three or four numbers, or one: a number in a list of colors that programs have
        std::size_t more = 0;
        for (; not text_.at_line_end(); ++more) {
            const off_number x = read_number([&] { return what() + ": its color"; });
            if (more < color.size())
                color[more] = x;
        }
        if (more > color.size())
            text_.refuse(what() + " has too many numbers; each face has a line of its own");
        if (more >= 3)
            face_colors_.add(face, std::span(color).first(more));
        has_listed_colors_ |= more == 1 or more == 2;
    }
    void take_attributes()
    {
        mesh_attributes& attributes = soup_.attributes;
        const auto take = [&](std::vector<std::vector<double>>& columns, std::span<const std::string_view> names) {
            for (std::size_t i = 0; i < columns.size(); ++i) {
                columns[i].resize(vertices_, no_component);
                attributes.vertices.emplace_back().name = names[i];
                attributes.vertices.back().values = std::move(columns[i]);
            }
        };
        take(normals_, normal_names);
        vertex_colors_.give(attributes.vertices, vertices_);
        take(textures_, texture_names);
        face_colors_.give(attributes.faces, faces_);
        if (has_other_numbers_)
            soup_.not_kept.emplace_back("extra numbers after the coordinates of vertices");
        if (has_listed_colors_)
            soup_.not_kept.emplace_back("colours of faces given as indices of a colour map");
    }

    std::string_view bytes_;
    off_cursor text_;
    off_keyword keyword_;
    polygon_soup soup_;
    std::size_t vertices_ = 0, faces_ = 0;
    bool in_lines_ = true;                                ///< each element stands in a line of its own
    std::vector<std::vector<double>> normals_, textures_; ///< by coordinate, up to the last vertex that has one
    colors vertex_colors_, face_colors_;
    bool has_other_numbers_ = false; ///< behind the coordinates of a vertex
    bool has_listed_colors_ = false;
};

} // namespace

polygon_soup read_off(std::string_view bytes)
{
    return off_reader(bytes).read();
}

} // namespace kith::io
