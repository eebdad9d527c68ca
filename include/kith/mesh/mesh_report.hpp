// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/base/in_library.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

// A mesh whose half-edges were joined by hand, and not well.
[[noreturn]] void refuse_shared_halfedge(std::size_t face);
[[noreturn]] void refuse_removed_edge(std::size_t face);
[[noreturn]] void refuse_removed_vertex(std::size_t face);

} // namespace detail

/// What can be wrong with a mesh.
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

/// Everything that `validate` found: each problem counted, the first few of each kind told with their elements.
class mesh_report {
public:
    static constexpr std::size_t told_of_each_kind = 8;

    mesh_report() = default;
    /// For elements that the user numbers from there: OBJ files begin with 1.
    explicit mesh_report(std::size_t first_number) : first_number_(first_number) {}

    /// An element as the user numbers it.
    [[nodiscard]] std::string number(std::size_t element) const;

    /// Adds a problem; `describe()` is called only while there is room to tell it.
    template <class Describe>
    void add(problem kind, const Describe& describe)
    {
        if (counts_[std::size_t(kind)]++ < told_of_each_kind)
            tell(kind, describe());
    }

    // What is found on more than one way into the library; elements by number.
    void add_no_faces();
    void add_not_finite(std::size_t vertex);
    void add_isolated(std::size_t vertex);
    void add_edge_without_face(std::size_t edge);
    /// Of a face with these vertices, which are sorted.
    void add_face_faults(std::size_t face, std::vector<std::size_t>& vertices);
    /// Of a face whose half-edges do not come back to the first.
    void add_open_face(std::size_t face);
    /// Of a face one of whose half-edges names another face, or does not come before its next.
    void add_unjoined_face(std::size_t face);
    /// Of a half-edge that names a face whose half-edges it is none of.
    void add_lost_side(std::size_t halfedge, std::size_t face);
    void add_several_fans(std::size_t vertex, std::size_t faces);
    /// Of a vertex whose half-edges lead to none of its faces.
    void add_lost_fan(std::size_t vertex);
    /// Of a vertex that starts at a half-edge of another one.
    void add_foreign_start(std::size_t vertex, std::size_t halfedge, std::size_t other);
    /// Of a vertex at the boundary that starts within its fan.
    void add_late_start(std::size_t vertex, std::size_t halfedge, std::size_t first);
    void add_few_corners(std::size_t face, std::size_t corners);
    void add_repeated_corner(std::size_t face, std::size_t vertex);

    [[nodiscard]] bool ok() const { return told_.empty(); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] std::size_t count(problem kind) const { return counts_[std::size_t(kind)]; }
    [[nodiscard]] bool has(problem kind) const { return count(kind) != 0; }

    /// One line per told problem, then how many more there are of each kind.
    [[nodiscard]] std::vector<std::string> lines() const;
    [[nodiscard]] std::string text() const;
    /// Throws mesh_error with the text when there is any problem.
    void require_ok() const;

private:
    void tell(problem kind, std::string&& text);
    [[nodiscard]] std::string named(const char* kind, std::size_t element) const;

    static constexpr std::array<std::string_view, 8> names{"empty mesh",
                                                           "coordinates that are not finite",
                                                           "indices out of range",
                                                           "degenerate faces",
                                                           "isolated vertices",
                                                           "edges with too many faces",
                                                           "edges whose faces are turned",
                                                           "vertices with several fans"};

    std::size_t first_number_ = 0;
    std::array<std::size_t, 8> counts_{};
    std::vector<std::pair<problem, std::string>> told_;
};

#ifdef KITH_HAS_BODIES

namespace detail {

[[noreturn]] KITH_IN_LIBRARY void refuse_face(std::size_t face, const char* why)
{
    throw mesh_error("face " + std::to_string(face) + ": " + why + "; repair the mesh");
}
KITH_IN_LIBRARY void refuse_shared_halfedge(std::size_t face)
{
    refuse_face(face, "its half-edges do not form a cycle of their own");
}
KITH_IN_LIBRARY void refuse_removed_edge(std::size_t face)
{
    refuse_face(face, "one of its edges has been removed");
}
KITH_IN_LIBRARY void refuse_removed_vertex(std::size_t face)
{
    refuse_face(face, "one of its vertices has been removed");
}

} // namespace detail

KITH_IN_LIBRARY std::string mesh_report::number(std::size_t element) const
{
    return std::to_string(std::ptrdiff_t(element + first_number_)); // one that was negative reads like that
}
KITH_IN_LIBRARY void mesh_report::add_no_faces()
{
    add(problem::empty_mesh, [] { return std::string("the mesh has no faces; nothing can be refined"); });
}
KITH_IN_LIBRARY void mesh_report::add_not_finite(std::size_t vertex)
{
    add(problem::not_finite,
        [&] { return named("vertex", vertex) + "a coordinate is not a finite number; give it a place"; });
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
        return named("face", face) + "its half-edges do not lead back to the first; join them anew or remove the face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_unjoined_face(std::size_t face)
{
    add(problem::degenerate_face, [&] {
        return named("face", face) + "its half-edges do not all name it as their face and come before their next; join "
                                     "them anew or remove the face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_lost_side(std::size_t halfedge, std::size_t face)
{
    add(problem::degenerate_face, [&] {
        return named("half-edge", halfedge) + "names face " + number(face) +
               ", which has been removed or does not come to it; let it have no face, as the library's own function "
               "that removes a face does";
    });
}
KITH_IN_LIBRARY void mesh_report::add_lost_fan(std::size_t vertex)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) +
               "its half-edge leads to none of its faces; give it one that leaves it in a face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_foreign_start(std::size_t vertex, std::size_t halfedge, std::size_t other)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) + "its half-edge " + std::to_string(halfedge) + " leaves vertex " +
               number(other) + "; give it one that leaves it in a face";
    });
}
KITH_IN_LIBRARY void mesh_report::add_late_start(std::size_t vertex, std::size_t halfedge, std::size_t first)
{
    add(problem::nonmanifold_vertex, [&] {
        return named("vertex", vertex) + "its half-edge " + std::to_string(halfedge) +
               " has faces on both sides, half-edge " + std::to_string(first) +
               " lies at the boundary; give it that one";
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
        return named("face", face) + "comes to vertex " + number(vertex) +
               " twice; remove the repeated corner or the face";
    });
}
KITH_IN_LIBRARY std::vector<std::string> mesh_report::lines() const
{
    std::vector<std::string> result;
    for (const auto& [kind, text] : told_)
        result.push_back(text);
    for (std::size_t kind = 0; kind < counts_.size(); ++kind)
        if (counts_[kind] > told_of_each_kind)
            result.push_back("and " + std::to_string(counts_[kind] - told_of_each_kind) +
                             " more: " + std::string(names[kind]));
    return result;
}
KITH_IN_LIBRARY std::string mesh_report::text() const
{
    std::string result;
    for (const auto& line : lines())
        result += (result.empty() ? "" : "\n") + line;
    return result;
}
KITH_IN_LIBRARY void mesh_report::require_ok() const
{
    if (not ok())
        throw mesh_error(text());
}
KITH_IN_LIBRARY void mesh_report::tell(problem kind, std::string&& text)
{
    told_.emplace_back(kind, std::move(text));
}
KITH_IN_LIBRARY std::string mesh_report::named(const char* kind, std::size_t element) const
{
    return kind + (" " + number(element)) + ": ";
}

#endif

} // namespace kith
