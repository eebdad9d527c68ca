// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/format/obj_tag.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

/// The statements that say nothing about the polygons, and their topics. Statements without a topic are not reported.
constexpr std::array<std::pair<std::string_view, std::string_view>, 42> other_statements{
    {{"mg", "smoothing groups"},
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

using cursor = text_cursor<text_kind::with_continuations>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// The lines of one to three numbers, `vt` or `vn`, to which corners refer before or behind these lines. Numbers that
/// are not finite count as missing: some programs write such normals for a face without area.
class referred_lines {
public:
    explicit referred_lines(const char* name) : name_(name) {}

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::size_t size() const { return lines_.size(); }
    void read_line(cursor& text)
    {
        const auto what = [&] { return name_ + " " + std::to_string(size() + 1); };
        std::array<double, 3> line{};
        std::size_t numbers = 0;
        for (; not text.at_line_end(); ++numbers) {
            const double x = text.any_number(what);
            if (numbers < 3)
                line[numbers] = std::isfinite(x) ? x : no_number;
        }
        if (numbers == 0)
            text.refuse_here(what() + " has no numbers");
        most_numbers_ = std::max(most_numbers_, std::min(numbers, std::size_t(3)));
        lines_.push_back(line);
    }
    /// Adds the reference of a corner: a line number from 1, or a negative one that counts back from the last line so
    /// far.
    void refer(std::size_t corner, std::ptrdiff_t index, std::size_t face, const cursor& text)
    {
        if (index == 0 or index < -std::ptrdiff_t(size()))
            text.refuse(complaint(face, index) + " so far; correct the index");
        of_corner_.resize(corner, none);
        of_corner_.push_back(std::size_t(index > 0 ? index - 1 : std::ptrdiff_t(size()) + index));
    }
    /// Removes all references if the file has no line at all, so that nothing is lost. Returns true if there were any.
    bool forget_if_empty()
    {
        const bool is_forgotten = lines_.empty() and not of_corner_.empty();
        if (is_forgotten)
            of_corner_.clear();
        return is_forgotten;
    }
    /// Returns the first corner whose line does not exist, if there is one.
    [[nodiscard]] std::optional<std::size_t> first_without_line() const
    {
        const auto found = std::ranges::find_if(of_corner_,
                                                [&](std::size_t line) { return line != none and line >= size(); });
        return found == of_corner_.end() ? std::nullopt : std::optional(std::size_t(found - of_corner_.begin()));
    }
    [[nodiscard]] std::string complaint_of(std::size_t corner, std::size_t face) const
    {
        return complaint(face, std::ptrdiff_t(of_corner_[corner]) + 1);
    }
    /// Makes attributes of the numbers. Precondition: first_without_line() returns nothing.
    [[nodiscard]] std::vector<attribute> at_corners(std::size_t corners, std::span<const std::string_view> names,
                                                    std::size_t least_numbers) const
    {
        std::vector<attribute> result;
        for (std::size_t i = 0; not of_corner_.empty() and i < std::max(most_numbers_, least_numbers); ++i) {
            result.emplace_back().name = names[i];
            result[i].values.assign(corners, no_number);
            for (std::size_t c = 0; c < of_corner_.size(); ++c)
                if (of_corner_[c] != none)
                    result[i].values[c] = lines_[of_corner_[c]][i];
        }
        return result;
    }
    [[nodiscard]] bool all_are_used() const
    {
        std::vector<bool> used(size());
        for (const std::size_t line : of_corner_)
            if (line != none)
                used[line] = true;
        return std::ranges::find(used, false) == used.end();
    }

private:
    static constexpr auto none = std::size_t(-1);

    [[nodiscard]] std::string complaint(std::size_t face, std::ptrdiff_t index) const
    {
        return "face " + std::to_string(face) + ": " + name_ + " " + std::to_string(index) +
               " does not exist, there are " + std::to_string(size());
    }

    std::string name_;
    std::vector<std::array<double, 3>> lines_;
    std::vector<std::size_t> of_corner_; ///< lines by corner, up to the last corner that has one
    std::size_t most_numbers_ = 0;
};

/// The words of one kind of statement. Each word holds for all faces up to the next statement.
class face_labels {
public:
    void begin(const std::string& label, std::size_t face)
    {
        const auto [place, is_new] = numbers_.try_emplace(label, numbers_.size());
        if (is_new)
            labels_.push_back(label);
        changes_.emplace_back(face, place->second);
    }
    /// Returns true if one of the faces has a word.
    [[nodiscard]] bool is_used(std::size_t faces) const
    {
        return std::ranges::any_of(changes_, [&](const auto& c) { return c.second != 0 and c.first < faces; });
    }
    [[nodiscard]] attribute at_faces(std::string_view name, std::size_t faces) const
    {
        attribute result{std::string(name), {4, false, true}, std::vector<double>(faces), labels_};
        for (std::size_t i = 0; i < changes_.size(); ++i) {
            const std::size_t end = i + 1 == changes_.size() ? faces : changes_[i + 1].first;
            std::fill(result.values.begin() + std::ptrdiff_t(changes_[i].first),
                      result.values.begin() + std::ptrdiff_t(end),
                      double(changes_[i].second));
        }
        return result;
    }

private:
    std::vector<std::string> labels_{""};
    std::map<std::string, std::size_t> numbers_{{"", 0}};
    std::vector<std::pair<std::size_t, std::size_t>> changes_; ///< (face, label): the label from this face on
};

class obj_reader {
public:
    explicit obj_reader(std::string_view bytes) : bytes_(bytes), text_(bytes) { soup_.first_number = 1; }

    polygon_soup read()
    {
        while (text_.to_content()) {
            const std::string_view statement = text_.word();
            if (statement == "v")
                read_vertex();
            else if (statement == "f")
                read_face();
            else if (statement == "vt")
                textures_.read_line(text_);
            else if (statement == "vn")
                normals_.read_line(text_);
            else if (statement == "t")
                read_tag();
            else if (statement == "mtllib")
                soup_.attributes.file_lines.push_back("mtllib " + rest_of_line());
            else if (not read_label(statement))
                leave_aside(statement);
        }
        require_vertices();
        if (soup_.points.empty() or soup_.faces.size() == 0)
            throw file_error("the file has " + counted(soup_.points.size(), "vertex") + " and " +
                             counted(soup_.faces.size(), "face") + "; nothing can be refined");
        for (referred_lines* lines : {&textures_, &normals_})
            require_lines(*lines);
        take_attributes();
        return std::move(soup_);
    }

private:
    void read_vertex()
    {
        const auto what = [&] { return "vertex " + std::to_string(soup_.points.size() + 1); };
        std::array<double, 7> p{0, 0, 0, 1};
        std::size_t numbers = 0; // three coordinates; a weight or a color of three or four may follow
        for (; not text_.at_line_end(); ++numbers) {
            const double x = text_.number(what);
            if (numbers < p.size())
                p[numbers] = x;
        }
        if (numbers < 3)
            text_.refuse(what() + " has " + counted(numbers, "coordinate") + ", 3 are needed");
        if (numbers > p.size())
            not_kept("extra numbers after the coordinates of vertices");
        else if (numbers >= 6)
            add_color({p[3], p[4], p[5], numbers == 7 ? p[6] : no_number});
        else if (numbers == 5)
            not_kept("extra numbers after the coordinates of vertices");
        else if (p[3] != 1)
            not_kept("weights of vertices");
        soup_.points.push_back({p[0], p[1], p[2]});
    }
    void add_color(const std::array<double, 4>& color)
    {
        colors_.resize(soup_.points.size(), {no_number, no_number, no_number, no_number});
        colors_.push_back(color);
    }
    /// Reads a face with corners `v`, `v/t`, `v//n` or `v/t/n`. Indices count from 1; negative ones count back from the
    /// last vertex so far.
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
                read_references(word.substr(slash + 1));
            soup_.faces.vertices.push_back(std::size_t(index > 0 ? index - 1 : std::ptrdiff_t(vertices) + index));
        }
        soup_.faces.first.push_back(soup_.faces.vertices.size());
    }
    /// Throws file_error for the first face with a corner whose vertex does not exist. Only the end of the file shows
    /// this, because vertices may come behind the faces.
    void require_vertices() const
    {
        const auto& vertices = soup_.faces.vertices;
        const auto found = std::ranges::find_if(vertices, [&](std::size_t v) { return v >= soup_.points.size(); });
        if (found == vertices.end())
            return;
        const std::size_t face = face_of(std::size_t(found - vertices.begin()));
        const std::size_t largest = std::ranges::max(soup_.faces[face - 1]);
        refuse_face(face,
                    "face " + std::to_string(face) + ": vertex " + std::to_string(largest + 1) +
                        " does not exist, there are " + std::to_string(soup_.points.size()));
    }
    /// Throws file_error for the first face with a corner whose line does not exist. If the file has no such lines at
    /// all, leaves out the references and notes that: some programs leave out the normals but not the references.
    void require_lines(referred_lines& lines)
    {
        if (lines.forget_if_empty())
            soup_.notes.push_back("faces refer to " + lines.name() +
                                  "s, and the file has none; the references are left out");
        else if (const auto corner = lines.first_without_line()) {
            const std::size_t face = face_of(*corner);
            refuse_face(face, lines.complaint_of(*corner, face));
        }
    }
    /// Returns the number of the face of a corner, from 1.
    [[nodiscard]] std::size_t face_of(std::size_t corner) const
    {
        return std::size_t(std::ranges::upper_bound(soup_.faces.first, corner) - soup_.faces.first.begin());
    }
    /// Throws file_error with the line of a face, which is searched in the whole text.
    [[noreturn]] void refuse_face(std::size_t face, const std::string& complaint) const
    {
        cursor text(bytes_);
        for (std::size_t faces = 0; text.to_content(); text.skip_line())
            if (text.word() == "f" and ++faces == face)
                break;
        text.refuse(complaint + "; correct the index");
    }
    /// Reads the text behind the first slash of a corner: `t`, `/n` or `t/n`.
    void read_references(std::string_view rest)
    {
        const std::size_t corner = soup_.faces.vertices.size(), face = soup_.faces.size() + 1;
        for (referred_lines* lines : {&textures_, &normals_}) {
            const auto end = std::min(rest.find('/'), rest.size());
            if (end != 0)
                lines->refer(corner,
                             text_.whole<std::ptrdiff_t>(
                                 rest.substr(0, end),
                                 [&] { return "face " + std::to_string(face) + ": a texture coordinate or normal"; }),
                             face,
                             text_);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        if (not rest.empty())
            text_.refuse("face " + std::to_string(face) +
                         ": a corner has at most a vertex, a texture coordinate and a normal, "
                         "but here is more: '" +
                         shown(rest) + "'");
    }
    /// Reads the rest of a line `t ...`: odd_generation or a tag.
    void read_tag()
    {
        const auto begin = text_;
        if ("t " + rest_of_line() == odd_generation) {
            soup_.attributes.file_lines.emplace_back(odd_generation);
            return;
        }
        text_ = begin;
        read_obj_tag(text_, soup_.tags);
    }
    /// Returns the words up to the end of the line, with a blank between them. Removes backslashes at the end, which
    /// the last line of a file may have.
    std::string rest_of_line()
    {
        std::string result;
        while (not text_.at_line_end())
            (result += result.empty() ? "" : " ") += text_.name();
        while (result.ends_with('\\'))
            result.pop_back();
        return result;
    }
    /// Reads a statement that names the faces after it. Returns false if it is another statement.
    bool read_label(std::string_view statement)
    {
        const auto found = std::ranges::find(
            label_statements, statement, &std::pair<std::string_view, std::string_view>::first);
        if (found == label_statements.end())
            return false;
        std::string label = rest_of_line();
        if (statement == "s" and (label == "off" or label == "0"))
            label.clear();
        labels_[std::size_t(found - label_statements.begin())].begin(label, soup_.faces.size());
        return true;
    }
    void take_attributes()
    {
        mesh_attributes& attributes = soup_.attributes;
        const std::size_t corners = soup_.faces.vertices.size();
        attributes.corners = textures_.at_corners(corners, texture_names, 2);
        for (attribute& a : normals_.at_corners(corners, normal_names, 3))
            attributes.corners.push_back(std::move(a));
        if (not textures_.all_are_used())
            not_kept("texture coordinates that no corner has");
        if (not normals_.all_are_used())
            not_kept("normals that no corner has");
        for (std::size_t i = 0; i < labels_.size(); ++i)
            if (labels_[i].is_used(soup_.faces.size()))
                attributes.faces.push_back(labels_[i].at_faces(label_statements[i].second, soup_.faces.size()));
        if (colors_.empty())
            return;
        colors_.resize(soup_.points.size(), {no_number, no_number, no_number, no_number});
        const bool has_alpha = std::ranges::any_of(colors_, [](const auto& c) { return not std::isnan(c[3]); });
        for (std::size_t i = 0; i < (has_alpha ? 4 : 3); ++i) {
            attributes.vertices.emplace_back().name = color_names[i];
            for (const auto& color : colors_)
                attributes.vertices[i].values.push_back(i == 3 and std::isnan(color[3]) and not std::isnan(color[0])
                                                            ? 1 // opaque, as colours of other vertices have an alpha
                                                            : color[i]);
        }
    }
    void leave_aside(std::string_view statement)
    {
        const auto found = std::ranges::find(
            other_statements, statement, &std::pair<std::string_view, std::string_view>::first);
        if (found == other_statements.end())
            text_.refuse("'" + shown(statement) + "' is not a statement of an OBJ file");
        not_kept(found->second);
        text_.skip_line();
    }
    void not_kept(std::string_view what)
    {
        if (not what.empty() and std::ranges::find(soup_.not_kept, what) == soup_.not_kept.end())
            soup_.not_kept.emplace_back(what);
    }

    std::string_view bytes_;
    cursor text_;
    polygon_soup soup_;
    referred_lines textures_{"texture coordinate"}, normals_{"normal"};
    std::array<face_labels, label_statements.size()> labels_; ///< as label_statements
    std::vector<std::array<double, 4>> colors_;               ///< up to the last vertex that has one
};

} // namespace

polygon_soup read_obj(std::string_view bytes)
{
    return obj_reader(bytes).read();
}

} // namespace kith::io
