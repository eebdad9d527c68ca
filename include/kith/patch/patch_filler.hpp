// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_template.hpp"

#include <kith/base/storage.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

namespace kith {

#ifdef KITH_HAS_LANES

/// Where a level is written: its points, and the vertices of its faces corner by corner, or nowhere.
template <class Point, std::unsigned_integral Index>
struct patch_output {
    Point* points;
    Index* corner_vertex = nullptr;

    [[nodiscard]] bool has_faces() const { return corner_vertex != nullptr; }
};

/// Writes the points and faces that some faces of a level own, after templates, as many faces at a time as there are lanes.
template <class Point, std::unsigned_integral Index, std::size_t Degree>
    requires fits_lanes<Point>
class patch_filler {
    using scalar = scalar_of<Point>;
    using pack = typename lanes<scalar>::type;
    static constexpr std::size_t size = std::tuple_size_v<Point>;

public:
    using patch = patch_template<scalar, Index>;

    /// How many faces are filled at a time.
    static constexpr std::size_t width = lanes<scalar>::count;

    /// For faces of a mesh that all have this degree, as have those of the level that is written.
    patch_filler(const basic_mesh<Point, Index>& coarse, const patch_output<Point, Index>& to)
        : coarse_(&coarse), to_(to)
    {
    }

    /// Preconditions: has_lanes(), and the template is of the class of these faces, 1 to `width`. Cost: that of the program.
    KITH_LANES void fill(const patch& t, std::span<const Index> faces)
    {
        make_room(slots_, t.program.slots() * size * width);
        make_room(first_corners_, t.steps.size() + 1);
        make_room(numbers_, t.vertices.size() * width);
        for (std::size_t lane = 0; lane < width; ++lane) { // where there are fewer faces the first stands for them
            walk(t, faces[lane < faces.size() ? lane : 0]);
            load(t, lane);
            number(t, numbers_of(t, lane));
        }
        for (std::size_t lane = 0; lane < faces.size(); ++lane)
            call_for(t, faces[lane], numbers_of(t, lane));
        t.program.template run<size>(reinterpret_cast<pack*>(slots_.data()));
        for (std::size_t lane = 0; lane < faces.size(); ++lane) {
            store(t, lane, numbers_of(t, lane));
            if (to_.has_faces())
                connect(t, faces[lane], numbers_of(t, lane));
        }
    }

private:
    template <class T>
    static void make_room(storage<T>& array, std::size_t size)
    {
        if (array.size() < size)
            array = storage<T>(size);
    }
    [[nodiscard]] Index* numbers_of(const patch& t, std::size_t lane)
    {
        return numbers_.data() + t.vertices.size() * lane;
    }

    /// Finds the faces of the neighbourhood.
    [[gnu::always_inline]] void walk(const patch& t, Index face)
    {
        const connectivity<Index>& mesh = coarse_->topology();
        Index* first = first_corners_.data();
        *first = Index(Degree * face);
        for (const walk_step& step : t.steps)
            *++first = Index(mesh.across(corner(step.from)) - step.rotation);
    }
    [[nodiscard]] Index corner(const walked_corner& c) const { return Index(first_corners_[c.face] + c.corner); }

    /// The points of the neighbourhood into a lane.
    [[gnu::always_inline]] void load(const patch& t, std::size_t lane)
    {
        scalar* to = slots_.data() + lane;
        for (const walked_corner& input : t.inputs) {
            const Point& point = coarse_->point(coarse_->topology().corner_vertex[corner(input)]);
            for (std::size_t i = 0; i < size; ++i, to += width)
                *to = point[i];
        }
    }
    /// The numbers of the fine vertices.
    [[gnu::always_inline]] void number(const patch& t, Index* to) const
    {
        const connectivity<Index>& mesh = coarse_->topology();
        const Index* offset = t.vertices.offset.data();
        const Index* factor = t.vertices.factor.data();
        std::size_t i = 0;
        for (std::size_t s = 0; s < t.vertices.sources.size(); ++s) {
            const auto& [kind, place] = t.vertices.sources[s];
            const Index at = corner(place);
            const Index source = kind == tuple_kind::v   ? mesh.corner_vertex[at]
                                 : kind == tuple_kind::e ? Index(mesh.corner_halfedge[at] / 2)
                                                         : Index(at / Degree);
            for (const std::size_t end = t.vertices.end[s]; i < end; ++i)
                to[i] = Index(offset[i] + factor[i] * source);
        }
    }
    /// The first corner of a run.
    [[nodiscard]] static std::size_t first_corner(const typename patch::face_run& run, Index face)
    {
        return Degree * std::size_t(Index(run.offset + run.factor * face));
    }
    /// Calls for what will be written: it is here when the program has run.
    [[gnu::always_inline]] void call_for(const patch& t, Index face, const Index* numbers) const
    {
        constexpr std::size_t indices_of_line = 64 / sizeof(Index);
        for (std::size_t v = 0; v < t.outputs.size(); v += 2)
            __builtin_prefetch(to_.points + numbers[t.outputs[v]], 1);
        if (not to_.has_faces())
            return;
        for (const auto& run : t.runs)
            for (std::size_t i = 0; i < Degree * run.count; i += indices_of_line)
                __builtin_prefetch(to_.corner_vertex + first_corner(run, face) + i, 1);
    }
    [[gnu::always_inline]] void store(const patch& t, std::size_t lane, const Index* numbers) const
    {
        const std::span<const std::uint16_t> slots = t.program.outputs();
        for (std::size_t v = 0; v < slots.size(); ++v) {
            const scalar* const value = slots_.data() + lane + slots[v] * size * width;
            Point& point = to_.points[numbers[t.outputs[v]]];
            for (std::size_t i = 0; i < size; ++i)
                point[i] = value[i * width];
        }
    }
    [[gnu::always_inline]] void connect(const patch& t, Index face, const Index* numbers) const
    {
        const typename patch::place* vertex = t.corners.data();
        for (const auto& run : t.runs) {
            Index* to = to_.corner_vertex + first_corner(run, face);
            for (std::size_t f = 0; f < run.count; ++f, to += Degree, vertex += Degree)
                for (std::size_t i = 0; i < Degree; ++i)
                    to[i] = numbers[vertex[i]];
        }
    }

    const basic_mesh<Point, Index>* coarse_;
    patch_output<Point, Index> to_;
    storage<scalar> slots_;
    storage<Index> first_corners_, numbers_;
};

#endif

} // namespace kith
