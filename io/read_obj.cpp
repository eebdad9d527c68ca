// SPDX-License-Identifier: BSD-3-Clause
#include <kith/text/counted.hpp>
#include <kith/format/obj_tag.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kith::io {

namespace {

/// Statements that say nothing about the polygons, and what they are about; nothing: not worth a word.
constexpr std::array<std::pair<std::string_view, std::string_view>, 49> other_statements{
    {{"vt", "texture coordinates"},
     {"vn", "normals"},
     {"usemtl", "materials"},
     {"mtllib", "materials"},
     {"o", "objects"},
     {"g", "groups"},
     {"s", "smoothing groups"},
     {"mg", "smoothing groups"},
     {"maplib", "texture maps"},
     {"usemap", "texture maps"},
     {"l", "lines"},
     {"p", "single points"},
     {"vp", "curves and surfaces"},
     {"cstype", "curves and surfaces"},
     {"deg", "curves and surfaces"},
     {"step", "curves and surfaces"},
     {"bmat", "curves and surfaces"},
     {"curv", "curves and surfaces"},
     {"curv2", "curves and surfaces"},
     {"surf", "curves and surfaces"},
     {"parm", "curves and surfaces"},
     {"trim", "curves and surfaces"},
     {"hole", "curves and surfaces"},
     {"scrv", "curves and surfaces"},
     {"sp", "curves and surfaces"},
     {"end", "curves and surfaces"},
     {"con", "curves and surfaces"},
     {"bsp", "curves and surfaces"},
     {"bzp", "curves and surfaces"},
     {"cdc", "curves and surfaces"},
     {"cdp", "curves and surfaces"},
     {"res", "curves and surfaces"},
     {"curv2d_1", "curves and surfaces"},
     {"surf_1", "curves and surfaces"},
     {"surf_2", "curves and surfaces"},
     {"q0_1", "curves and surfaces"},
     {"q1_1", "curves and surfaces"},
     {"q0_2", "curves and surfaces"},
     {"q1_2", "curves and surfaces"},
     {"call", "calls of other files"},
     {"csh", "calls of other programs"},
     {"bevel", ""},
     {"c_interp", ""},
     {"d_interp", ""},
     {"lod", ""},
     {"shadow_obj", ""},
     {"trace_obj", ""},
     {"ctech", ""},
     {"stech", ""}}};

class obj_reader {
public:
    explicit obj_reader(std::string_view bytes) : text_(bytes) { soup_.first_number = 1; }

    polygon_soup read()
    {
        while (text_.to_content()) {
            const std::string_view statement = text_.word();
            if (statement == "v")
                read_vertex();
            else if (statement == "f")
                read_face();
            else if (statement == "t")
                read_obj_tag(text_, soup_.tags);
            else
                leave_aside(statement);
        }
        if (std::size_t(largest_index_) > soup_.points.size())
            throw file_error("line " + std::to_string(text_at_largest_.line()) + ": face " +
                             std::to_string(face_of_largest_) + ": vertex " + std::to_string(largest_index_) +
                             " does not exist, there are " + std::to_string(soup_.points.size()) +
                             "; correct the index");
        if (soup_.points.empty() or soup_.faces.size() == 0)
            throw file_error("the file has " + counted(soup_.points.size(), "vertex") + " and " +
                             counted(soup_.faces.size(), "face") + "; nothing can be refined");
        return std::move(soup_);
    }

private:
    void read_vertex()
    {
        const auto what = [&] { return "vertex " + std::to_string(soup_.points.size() + 1); };
        std::array<double, 4> p{0, 0, 0, 1};
        std::size_t numbers = 0; // three coordinates; a weight or a color may follow
        for (; not text_.at_line_end(); ++numbers) {
            const double x = text_.number(what);
            if (numbers < 4)
                p[numbers] = x;
        }
        if (numbers < 3)
            text_.refuse(what() + " has " + counted(numbers, "coordinate") + ", 3 are needed");
        if (numbers >= 6)
            not_kept("colours");
        else if (p[3] != 1)
            not_kept("weights of vertices");
        soup_.points.push_back({p[0], p[1], p[2]});
    }
    /// Indices count from 1; negative ones count back from the last vertex so far. `v`, `v/t`, `v//n` and `v/t/n`.
    void read_face()
    {
        const std::size_t vertices = soup_.points.size();
        const auto what = [&] { return "face " + std::to_string(soup_.faces.size() + 1); };
        while (not text_.at_line_end()) {
            const std::string_view word = text_.word();
            const auto slash = word.find('/');
            const auto index = text_.whole<std::ptrdiff_t>(word.substr(0, slash),
                                                           [&] { return what() + ": a vertex"; });
            if (index == 0 or index < -std::ptrdiff_t(vertices))
                text_.refuse(what() + ": vertex " + std::to_string(index) + " does not exist, there are " +
                             std::to_string(vertices) + " so far; correct the index");
            if (slash != word.npos)
                check_references(word.substr(slash + 1));
            if (index > largest_index_) {
                largest_index_ = index;
                if (std::size_t(index) > vertices) { // may come later
                    face_of_largest_ = soup_.faces.size() + 1;
                    text_at_largest_ = text_;
                }
            }
            soup_.faces.vertices.push_back(std::size_t(index > 0 ? index - 1 : std::ptrdiff_t(vertices) + index));
        }
        soup_.faces.first.push_back(soup_.faces.vertices.size());
    }
    void check_references(std::string_view rest) const
    {
        while (not rest.empty()) {
            const auto end = std::min(rest.find('/'), rest.size());
            if (end != 0)
                (void)text_.whole<std::ptrdiff_t>(rest.substr(0, end), [&] {
                    return "face " + std::to_string(soup_.faces.size() + 1) + ": a texture coordinate or normal";
                });
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    void leave_aside(std::string_view statement)
    {
        const auto found = std::ranges::find(
            other_statements, statement, &std::pair<std::string_view, std::string_view>::first);
        if (found == other_statements.end())
            text_.refuse("'" + shown(statement) + "' is no statement of an OBJ file");
        const bool is_off = statement == "s" and [ahead = text_]() mutable
        {
            const auto word = ahead.word();
            return word == "off" or word == "0";
        }
        ();
        if (not is_off)
            not_kept(found->second);
        text_.skip_line();
    }
    void not_kept(std::string_view what)
    {
        if (not what.empty() and std::ranges::find(soup_.not_kept, what) == soup_.not_kept.end())
            soup_.not_kept.emplace_back(what);
    }

    text_cursor<text_kind::with_continuations> text_;
    text_cursor<text_kind::with_continuations> text_at_largest_ = text_;
    polygon_soup soup_;
    std::ptrdiff_t largest_index_ = 0;
    std::size_t face_of_largest_ = 0;
};

} // namespace

polygon_soup read_obj(std::string_view bytes)
{
    return obj_reader(bytes).read();
}

} // namespace kith::io
