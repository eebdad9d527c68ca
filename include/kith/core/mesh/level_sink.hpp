// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace kith {

/// A side of a new face: a vertex, and the half-edge by which the boundary of the face leaves it.
template <class Index>
struct face_line {
    Index vertex;
    Index halfedge;
};

/// The sides of a face in their order, as `polygon` returns them.
template <class T>
concept face_sides = requires(const T& lines) {
    (*lines.begin()).vertex;
    (*lines.begin()).halfedge;
};

/// A target other than a native mesh into which a step writes the next level. The elements have the numbers that they
/// would have in a native mesh, and half-edge 2e+s is side s of edge e. The scheme must declare its edges and is
/// trusted: it writes each element once, and the result is a manifold.
template <class S>
concept level_sink = requires(S& sink, typename S::index_type i,
                              std::span<const face_line<typename S::index_type>> lines) {
    requires std::unsigned_integral<typename S::index_type>; // as of a native mesh
    // The array of all points. Several threads assign the points, each point once.
    { sink.points() } -> std::same_as<typename S::point_type*>;
    // Sets the sides of face i, counter-clockwise from its first corner: any range of face_line. Several threads set
    // different faces.
    sink.set_face(i, lines);
    // Sets the half-edge that leaves vertex i and starts its fan. Called by several threads, maybe before its faces are
    // set.
    sink.set_start(i, i);
    // Ends the writing, with the generation of the level. The sides that no face has named are boundary sides.
    sink.finish(0);
};

/// The virtual interface of a level_sink: a step that writes into it is compiled once for all types of targets.
template <class Point, std::unsigned_integral Index>
class level_writer {
public:
    using point_type = Point;
    using index_type = Index;
    using lines = std::span<const face_line<Index>>;

    /// Allocates the elements; must be called first. A level is closed if it has no boundary. Errors: mesh_error for
    /// more elements than the target can number.
    virtual void make_room(std::size_t vertices, std::size_t edges, std::size_t faces, bool is_closed) = 0;
    [[nodiscard]] virtual Point* points() const = 0;
    virtual void set_start(Index vertex, Index leaving) = 0;
    /// Writes faces of one degree with consecutive numbers; `of_faces` lists the sides of all of them.
    virtual void set_faces(Index first, std::size_t degree, lines of_faces) = 0;
    virtual void finish(int generation) = 0;

    template <face_sides Lines>
    void set_face(Index id, const Lines& of_face)
    {
        if constexpr (std::convertible_to<const Lines&, lines>) {
            const lines all = of_face;
            set_faces(id, all.size(), all);
        } else {
            std::array<face_line<Index>, 8> few;
            std::size_t count = 0;
            for (const face_line<Index>& line : of_face) {
                if (count == few.size())
                    return set_large_face(id, of_face);
                few[count++] = line;
            }
            set_faces(id, count, lines(few.data(), count));
        }
    }

protected:
    level_writer() = default;
    level_writer(const level_writer&) = default;
    level_writer& operator=(const level_writer&) = default;
    ~level_writer() = default;

private:
    template <face_sides Lines>
    [[gnu::noinline]] void set_large_face(Index id, const Lines& of_face)
    {
        std::vector<face_line<Index>> all;
        for (const face_line<Index>& line : of_face)
            all.push_back(line);
        set_faces(id, all.size(), all);
    }
};

} // namespace kith
