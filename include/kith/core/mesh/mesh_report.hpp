// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith {

/// The kinds of faults in a mesh.
enum class problem : unsigned char {
    empty_mesh,
    not_finite,
    bad_index,
    degenerate_face,
    isolated_vertex,
    nonmanifold_edge,
    turned_face,
    nonmanifold_vertex,
};

/// The messages about elements, by kind. All messages are counted, and the first few of each kind are kept as text.
class element_messages {
public:
    static constexpr std::size_t told_of_each_kind = 8;

    /// Returns the number of an element in messages.
    [[nodiscard]] std::string number(std::size_t element) const;

    [[nodiscard]] bool empty() const { return told_.empty(); }
    /// Returns one line per message that was kept, then the number of further messages of each kind.
    [[nodiscard]] std::vector<std::string> lines() const;
    [[nodiscard]] std::string text() const;

protected:
    /// Begins without messages. `kinds` are the names of the kinds in plural and must outlive the object; elements are
    /// numbered from `first_number`.
    explicit element_messages(std::span<const std::string_view> kinds, std::size_t first_number)
        : kinds_(kinds), counts_(kinds.size()), first_number_(first_number)
    {
    }
    /// Counts a message; `describe()` is called only while there is room for its text.
    template <class Describe>
    void add_message(std::size_t kind, const Describe& describe)
    {
        if (counts_[kind]++ < told_of_each_kind)
            tell(describe());
    }
    [[nodiscard]] std::size_t count_of(std::size_t kind) const { return counts_[kind]; }
    [[nodiscard]] std::string named(const char* kind, std::size_t element) const;

private:
    void tell(std::string&& text);

    std::span<const std::string_view> kinds_;
    std::vector<std::size_t> counts_;
    std::size_t first_number_;
    std::vector<std::string> told_;
};

/// A report of everything that `validate` found. Each problem is counted; the first few of each kind are described with
/// their elements.
class mesh_report : public element_messages {
public:
    mesh_report() : mesh_report(0) {}
    /// Begins an empty report. `first_number` is the number of the first element in messages; OBJ files begin with 1.
    explicit mesh_report(std::size_t first_number) : element_messages(names, first_number) {}

    /// Adds a problem; `describe()` is called only while there is room for its text.
    template <class Describe>
    void add(problem kind, const Describe& describe)
    {
        add_message(std::size_t(kind), describe);
    }

    // The faults below are found by several functions. Elements are named by their numbers.
    void add_no_faces();
    void add_not_finite(std::size_t vertex);
    void add_isolated(std::size_t vertex);
    void add_edge_without_face(std::size_t edge);
    /// Adds the faults of a face with these vertices: a repeated vertex, or fewer than three. The function sorts the
    /// vertices.
    void add_face_faults(std::size_t face, std::vector<std::size_t>& vertices);
    /// Adds a face whose half-edges do not come back to the first.
    void add_open_face(std::size_t face);
    /// Adds a face of which a half-edge names another face, or is not the one before its next.
    void add_unjoined_face(std::size_t face);
    /// Adds a face with an edge, or a vertex, that the mesh library has removed.
    void add_removed_edge(std::size_t face);
    void add_removed_vertex(std::size_t face);
    /// Adds a half-edge that names a face to which it does not belong.
    void add_lost_side(std::size_t halfedge, std::size_t face);
    void add_several_fans(std::size_t vertex, std::size_t faces);
    /// Adds a vertex whose half-edge leads to none of its faces.
    void add_lost_fan(std::size_t vertex);
    /// Adds a vertex that starts at a half-edge of another vertex.
    void add_foreign_start(std::size_t vertex, std::size_t halfedge, std::size_t other);
    /// Adds a boundary vertex that starts in the middle of its fan.
    void add_late_start(std::size_t vertex, std::size_t halfedge, std::size_t first);
    void add_few_corners(std::size_t face, std::size_t corners);
    void add_repeated_corner(std::size_t face, std::size_t vertex);

    /// Adds an edge between two vertices, the smaller one first, whose two faces run through it in the same direction.
    void add_turned_face(std::size_t low, std::size_t high, std::size_t face, std::size_t other, bool is_one_sided);

    [[nodiscard]] bool ok() const { return empty(); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] std::size_t count(problem kind) const { return count_of(std::size_t(kind)); }
    [[nodiscard]] bool has(problem kind) const { return count(kind) != 0; }
    /// Throws mesh_error with the text if there is any problem.
    void require_ok() const;

private:
    static constexpr std::array<std::string_view, 8> names{"empty mesh",
                                                           "coordinates that are not finite",
                                                           "indices out of range",
                                                           "degenerate faces",
                                                           "isolated vertices",
                                                           "edges with too many faces",
                                                           "edges whose faces are turned",
                                                           "vertices with several fans"};
};

#ifdef KITH_HAS_BODIES

KITH_IN_LIBRARY std::string element_messages::number(std::size_t element) const
{
    return std::to_string(std::ptrdiff_t(element + first_number_)); // so a negative number is shown as it was
}
KITH_IN_LIBRARY void mesh_report::add_no_faces()
{
    add(problem::empty_mesh, [] { return std::string("the mesh has no faces; nothing can be refined"); });
}
KITH_IN_LIBRARY void mesh_report::add_not_finite(std::size_t vertex)
{
    add(problem::not_finite,
        [&] { return named("vertex", vertex) + "a coordinate is not a finite number; give finite coordinates"; });
}
KITH_IN_LIBRARY void mesh_report::add_isolated(std::size_t vertex)
{
    add(problem::isolated_vertex,
        [&] { return named("vertex", vertex) + "belongs to no face; remove it or give it a face"; });
}
KITH_IN_LIBRARY void mesh_report::add_edge_without_face(std::size_t edge)
{
    add(problem::nonmanifold_edge, [&] { return named("edge", edge) + "has no face; remove it or give it a face"; });
}
KITH_IN_LIBRARY void mesh_report::add_face_faults(std::size_t face, std::vector<std::size_t>& vertices)
{
    std::sort(vertices.begin(), vertices.end());
    if (const auto twice = std::adjacent_find(vertices.begin(), vertices.end()); twice != vertices.end())
        add_repeated_corner(face, *twice);
    if (vertices.size() < 3)
        add_few_corners(face, vertices.size());
}
KITH_IN_LIBRARY void mesh_report::add_open_face(std::size_t face)
{
    add(problem::degenerate_face, [&] {
        return named("face", face) + "its half-edges do not lead back to the first; relink them or remove the face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_unjoined_face(std::size_t face)
{
    add(problem::degenerate_face, [&] {
        return named("face", face) + "its half-edges name another face, or contradict each other about the next and "
                                     "the previous one; relink them or remove the face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_lost_side(std::size_t halfedge, std::size_t face)
{
    add(problem::degenerate_face, [&] {
        return named("half-edge", halfedge) + "names face " + number(face) +
               ", which has been removed or does not contain it; reset its face, as the mesh library does when it "
               "removes a face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_lost_fan(std::size_t vertex)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) +
               "its half-edge leads to none of its faces; give it an outgoing half-edge of one of its faces";
    });
}
KITH_IN_LIBRARY void mesh_report::add_foreign_start(std::size_t vertex, std::size_t halfedge, std::size_t other)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) + "its half-edge " + std::to_string(halfedge) + " leaves vertex " +
               number(other) + "; give it an outgoing half-edge of one of its faces";
    });
}
KITH_IN_LIBRARY void mesh_report::add_late_start(std::size_t vertex, std::size_t halfedge, std::size_t first)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) + "its half-edge " + std::to_string(halfedge) +
               " has faces on both sides, half-edge " + std::to_string(first) +
               " lies on the boundary; give it that one";
    });
}
KITH_IN_LIBRARY void mesh_report::add_several_fans(std::size_t vertex, std::size_t faces)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) + "its " + std::to_string(faces) +
               " faces form several fans; split the vertex, one copy per fan";
    });
}
KITH_IN_LIBRARY void mesh_report::add_few_corners(std::size_t face, std::size_t corners)
{
    add(problem::degenerate_face, [&] {
        return named("face", face) + "has " + std::to_string(corners) + (corners == 1 ? " corner" : " corners") +
               "; remove it";
    });
}
KITH_IN_LIBRARY void mesh_report::add_repeated_corner(std::size_t face, std::size_t vertex)
{
    add(problem::degenerate_face, [&] {
        return named("face", face) + "contains vertex " + number(vertex) +
               " twice; remove the repeated corner or the face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_removed_edge(std::size_t face)
{
    add(problem::degenerate_face,
        [&] { return named("face", face) + "one of its edges has been removed; remove the face, too"; });
}
KITH_IN_LIBRARY void mesh_report::add_removed_vertex(std::size_t face)
{
    add(problem::degenerate_face,
        [&] { return named("face", face) + "one of its vertices has been removed; remove the face, too"; });
}
KITH_IN_LIBRARY void mesh_report::add_turned_face(std::size_t low, std::size_t high, std::size_t face,
                                                  std::size_t other, bool is_one_sided)
{
    add(problem::turned_face, [&] {
        return "edge " + number(low) + "-" + number(high) + ": faces " + number(face) + " and " + number(other) +
               " run through it in the same direction" +
               (is_one_sided
                    ? ", and reversing faces does not help, as the surface is one-sided (not orientable); cut it "
                      "along edges from boundary to boundary"
                    : "; reverse one of them");
    });
}
KITH_IN_LIBRARY void mesh_report::require_ok() const
{
    if (not ok())
        throw mesh_error(text());
}
KITH_IN_LIBRARY std::vector<std::string> element_messages::lines() const
{
    std::vector<std::string> result = told_;
    for (std::size_t kind = 0; kind < counts_.size(); ++kind)
        if (counts_[kind] > told_of_each_kind)
            result.push_back("and " + std::to_string(counts_[kind] - told_of_each_kind) +
                             " more: " + std::string(kinds_[kind]));
    return result;
}
KITH_IN_LIBRARY std::string element_messages::text() const
{
    std::string result;
    for (const auto& line : lines())
        result += (result.empty() ? "" : "\n") + line;
    return result;
}
KITH_IN_LIBRARY void element_messages::tell(std::string&& text)
{
    told_.push_back(std::move(text));
}
KITH_IN_LIBRARY std::string element_messages::named(const char* kind, std::size_t element) const
{
    return kind + (" " + number(element)) + ": ";
}

#endif

} // namespace kith
