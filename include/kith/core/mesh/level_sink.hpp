// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace kith {

/// One line of a new face: a vertex and the side by which the boundary of the face leaves it.
template <class Index>
struct face_line {
    Index vertex;
    Index halfedge;
};

/// The lines of a face in their order, as `polygon` gives them.
template <class T>
concept face_sides = requires(const T& lines) {
    (*lines.begin()).vertex;
    (*lines.begin()).halfedge;
};

/// What a step writes the next level into when that is no native mesh: numbers are those that the elements would have
/// there, and half-edge 2e+s is side s of edge e. The scheme is trusted and declares its edges: each element is written
/// once, and what is written is a manifold.
template <class S>
concept level_sink = requires(S& sink, typename S::index_type i,
                              std::span<const face_line<typename S::index_type>> lines) {
    requires std::unsigned_integral<typename S::index_type>; // as of a native mesh
    // The array of all points, of which each is assigned once; several threads do.
    { sink.points() } -> std::same_as<typename S::point_type*>;
    // Face i has these lines, counter-clockwise from its first corner: any range of face_line. Several threads make
    // different faces.
    sink.set_face(i, lines);
    // The fan of vertex i starts at a half-edge that leaves it. Several threads, and maybe before its faces are there.
    sink.set_start(i, i);
    // Comes last, with the generation of the level: nothing lies on the sides that no face has named.
    sink.finish(0);
};

/// A level_sink behind virtual functions: a step that writes into it is compiled once, whatever it is that is written.
template <class Point, std::unsigned_integral Index>
class level_writer {
public:
    using point_type = Point;
    using index_type = Index;
    using lines = std::span<const face_line<Index>>;

    /// Comes first. A level is closed when it has no boundary. Errors: mesh_error for more elements than it can number.
    virtual void make_room(std::size_t vertices, std::size_t edges, std::size_t faces, bool is_closed) = 0;
    [[nodiscard]] virtual Point* points() const = 0;
    virtual void set_start(Index vertex, Index leaving) = 0;
    /// Faces of one degree whose numbers follow one another, the lines of all in one list.
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
