// SPDX-License-Identifier: BSD-3-Clause
#include <kith/text/counted.hpp>
#include <kith/read_mesh.hpp>
#include <kith/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

using cursor = text_cursor<text_kind::with_comments>;

/// What the letters before OFF say: [ST][C][N][4][n]OFF.
struct off_keyword {
    bool texture = false, color = false, normal = false, homogeneous = false;

    [[nodiscard]] int coordinates() const { return homogeneous ? 4 : 3; }
    [[nodiscard]] int numbers() const { return coordinates() + (normal ? 3 : 0) + (color ? 4 : 0) + (texture ? 2 : 0); }
};

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Colors of some elements, three or four numbers each.
class colors {
public:
    void add(std::size_t element, std::span<const double> color)
    {
        values_.resize(4 * element, no_number);
        values_.insert(values_.end(), color.begin(), color.end());
        values_.resize(4 * element + 4, no_number);
        has_alpha_ |= color.size() == 4;
    }
    /// The attributes. Whole numbers up to 255, of which some are larger than 1, are bytes; all others go from 0 to 1.
    void give(std::vector<attribute>& attributes, std::size_t elements)
    {
        if (values_.empty())
            return;
        values_.resize(4 * elements, no_number);
        const auto is_byte = [](double x) { return std::isnan(x) or (x == std::floor(x) and x >= 0 and x <= 255); };
        const bool in_bytes = std::ranges::all_of(values_, is_byte) and
                              std::ranges::any_of(values_, [](double x) { return x > 1; });
        const std::size_t first = attributes.size();
        for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
            attributes.emplace_back().name = color_names[i];
            if (in_bytes)
                attributes.back().type = {1, false, false};
            for (std::size_t element = 0; element < elements; ++element) {
                const double x = values_[4 * element + i];
                const bool is_opaque = i == 3 and std::isnan(x) and not std::isnan(values_[4 * element]);
                attributes[first + i].values.push_back(not is_opaque ? x : in_bytes ? 255 : 1);
            }
        }
    }

private:
    std::vector<double> values_; ///< four per element, up to the last that has a color
    bool has_alpha_ = false;
};

/// A vertex has four coordinates, a normal, a color of four and a texture coordinate of three numbers at most.
constexpr int most_numbers = 15;

off_keyword read_keyword(cursor& text)
{
    const std::string_view keyword = text.word();
    std::string capitals(keyword.substr(0, 16)); // some programs write the word in small letters
    std::ranges::transform(capitals, capitals.begin(), [](char c) { return c >= 'a' and c <= 'z' ? char(c - 32) : c; });
    std::string_view word = capitals;
    const auto take = [&](std::string_view prefix) {
        const bool there = word.starts_with(prefix);
        word.remove_prefix(there ? prefix.size() : 0);
        return there;
    };
    off_keyword result;
    result.texture = take("ST");
    result.color = take("C");
    result.normal = keyword != "nOFF" and take("N");
    result.homogeneous = take("4");
    if (word == "NOFF")
        text.refuse("'" + std::string(keyword) + "' has another number of coordinates than three; write it as OFF");
    if (word != "OFF" or keyword.size() > 16)
        text.refuse("an OFF file begins with the word OFF, this one with '" + shown(keyword) + "'");
    return result;
}

class off_reader {
public:
    explicit off_reader(std::string_view bytes) : text_(bytes) {}

    polygon_soup read()
    {
        to_content([] { return std::string("the word OFF"); });
        keyword_ = read_keyword(text_);
        read_counts();
        soup_.points.reserve(vertices_);
        soup_.faces.first.reserve(faces_ + 1);
        soup_.faces.vertices.reserve(std::min(3 * faces_, text_.left() / 2));
        in_lines_ = lines_hold_elements();
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
    /// Goes to the next word; refuses the end of the file.
    template <std::invocable Wanted>
    void to_content(const Wanted& wanted)
    {
        if (not text_.to_content())
            throw file_error("the file ends where " + wanted() + " should be");
    }
    void read_counts()
    {
        to_content([] { return std::string("the numbers of vertices and faces"); });
        if (cursor ahead = text_; ahead.word() == "BINARY")
            text_.refuse_here(
                "binary OFF is not read, as programs do not agree on its byte order; save it as text or as PLY");
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
    /// Vertices and faces have lines of their own, where colors may follow them. But the format does not ask for that,
    /// and some files have all their numbers in a line: then nothing but what the keyword says stands between them.
    bool lines_hold_elements()
    {
        const auto numbers_in_line = [](cursor text) {
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
            text_.refuse("more than the numbers of vertices, faces and edges stands on this line");
        }
        cursor first = text_;
        if (not first.to_content())
            return true;
        const std::size_t numbers = numbers_in_line(first);
        return numbers <= std::size_t(most_numbers) and (vertices_ < 2 or numbers < all);
    }
    void read_vertex(std::size_t vertex)
    {
        const auto what = [&] { return "vertex " + std::to_string(vertex); };
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
                text_.refuse(what() + " lies at infinity, its fourth coordinate is 0; give it a place");
            for (int i = 0; i < 3; ++i)
                p[std::size_t(i)] /= p[3];
            if (not(std::isfinite(p[0]) and std::isfinite(p[1]) and std::isfinite(p[2])))
                text_.refuse(what() + " has no finite place, its fourth coordinate is too small; give it a place");
        }
        soup_.points.push_back({p[0], p[1], p[2]});
        std::array<double, most_numbers> numbers{};
        std::size_t more = 0;
        const auto read_number = [&] {
            const double x = text_.number(what);
            if (more++ < numbers.size())
                numbers[more - 1] = x;
        };
        if (in_lines_)
            while (not text_.at_line_end())
                read_number();
        else
            while (int(more) < keyword_.numbers() - coordinates) {
                to_content(what);
                read_number();
            }
        if (more > std::size_t(most_numbers - 4))
            text_.refuse(what() + " has too many numbers; each vertex has a line of its own");
        take_numbers(vertex, std::span(numbers).first(more));
    }
    /// What stands behind the coordinates of a vertex: normal, color, texture, as far as the keyword says; some have
    /// nothing.
    void take_numbers(std::size_t vertex, std::span<const double> numbers)
    {
        if (numbers.empty())
            return;
        const std::size_t normal = keyword_.normal ? 3 : 0, texture = keyword_.texture ? 2 : 0;
        const std::size_t color = numbers.size() - std::min(numbers.size(), normal + texture);
        if (numbers.size() < normal + texture or (color != 0 and not(keyword_.color and (color == 3 or color == 4)))) {
            has_other_numbers_ = true;
            return;
        }
        const auto add = [&](std::vector<std::vector<double>>& columns, std::span<const double> values) {
            columns.resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) {
                columns[i].resize(vertex, no_number);
                columns[i].push_back(values[i]);
            }
        };
        if (keyword_.normal)
            add(normals_, numbers.first(3));
        if (keyword_.color)
            vertex_colors_.add(vertex, numbers.subspan(normal, color));
        if (keyword_.texture)
            add(textures_, numbers.last(2));
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
        std::array<double, 4> color{}; // three or four numbers, or one, that of a color in a list which programs have
        std::size_t more = 0;
        for (; not text_.at_line_end(); ++more) {
            const double x = text_.number([&] { return what() + ": its color"; });
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
                columns[i].resize(vertices_, no_number);
                attributes.vertices.emplace_back().name = names[i];
                attributes.vertices.back().values = std::move(columns[i]);
            }
        };
        take(normals_, normal_names);
        vertex_colors_.give(attributes.vertices, vertices_);
        take(textures_, texture_names);
        face_colors_.give(attributes.faces, faces_);
        if (has_other_numbers_)
            soup_.not_kept.emplace_back("numbers behind the coordinates of vertices");
        if (has_listed_colors_)
            soup_.not_kept.emplace_back("colours of faces by their numbers in a list");
    }

    cursor text_;
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
