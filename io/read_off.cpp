// SPDX-License-Identifier: BSD-3-Clause
#include <kith/text/counted.hpp>
#include <kith/read_mesh.hpp>
#include <kith/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace kith::io {

namespace {

using cursor = text_cursor<text_kind::with_comments>;

/// What the letters before OFF say: [ST][C][N][4][n]OFF.
struct off_keyword {
    bool texture = false, color = false, normal = false, homogeneous = false;

    [[nodiscard]] int coordinates() const { return homogeneous ? 4 : 3; }
    [[nodiscard]] int numbers() const { return coordinates() + (normal ? 3 : 0) + (color ? 4 : 0) + (texture ? 2 : 0); }
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
        tell_what_is_not_kept();
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
    /// Vertices and faces have lines of their own, where colors may follow them. But the format does not ask for that, and
    /// some files have all their numbers in a line: then nothing but what the keyword says stands between them.
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
        int more = 0;
        if (in_lines_)
            for (; not text_.at_line_end(); ++more)
                (void)text_.number(what);
        else
            for (; more < keyword_.numbers() - coordinates; ++more) {
                to_content(what);
                (void)text_.number(what);
            }
        if (more > most_numbers - 4)
            text_.refuse(what() + " has too many numbers; each vertex has a line of its own");
        more_at_vertices_ = std::max(more_at_vertices_, more);
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
        int more = 0; // a color: one to four numbers
        for (; not text_.at_line_end(); ++more)
            (void)text_.number([&] { return what() + ": its color"; });
        if (more > 4)
            text_.refuse(what() + " has too many numbers; each face has a line of its own");
        colored_faces_ |= more != 0;
    }
    void tell_what_is_not_kept()
    {
        const bool said = keyword_.normal or keyword_.color or keyword_.texture;
        if (keyword_.normal)
            soup_.not_kept.emplace_back("normals");
        if (keyword_.color or colored_faces_)
            soup_.not_kept.emplace_back("colours");
        if (keyword_.texture)
            soup_.not_kept.emplace_back("texture coordinates");
        if (more_at_vertices_ != 0 and not said)
            soup_.not_kept.emplace_back("numbers behind the coordinates of vertices");
    }

    cursor text_;
    off_keyword keyword_;
    polygon_soup soup_;
    std::size_t vertices_ = 0, faces_ = 0;
    bool in_lines_ = true; ///< each element stands in a line of its own
    int more_at_vertices_ = 0;
    bool colored_faces_ = false;
};

} // namespace

polygon_soup read_off(std::string_view bytes)
{
    return off_reader(bytes).read();
}

} // namespace kith::io
