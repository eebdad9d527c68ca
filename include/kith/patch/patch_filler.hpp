// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_writer.hpp"

#include <kith/base/storage.hpp>
#include <kith/lane/lanes.hpp>
#include <kith/mesh/basic_mesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

namespace kith {

#ifdef KITH_HAS_LANES

/// Writes what some faces of a level own, after templates, as many faces at a time as two registers have lanes.
template <class Point, std::unsigned_integral Index, std::size_t Degree>
    requires fits_lanes<Point>
class patch_filler {
    using scalar = scalar_of<Point>;
    using pack = typename lanes<scalar>::type;
    using writer = patch_writer<Point, Index, Degree>;
    static constexpr std::size_t size = std::tuple_size_v<Point>;
    static constexpr std::size_t width = writer::width;
    static constexpr std::size_t packs = size * width / lanes<scalar>::count; // of a point of each face

public:
    using patch = typename writer::patch;

    /// How many are best filled in one call.
    static constexpr std::size_t at_once = 2 * width;

    /// For faces of a mesh that all have this degree, as have those of the level that is written: past the caches if that is too
    /// large to be in them when it is read.
    patch_filler(const basic_mesh<Point, Index>& coarse, const patch_output<Point, Index>& to, bool past_caches)
        : coarse_(&coarse), writer_(to, past_caches)
    {
    }

    /// `bases`: what is added to each multiple in this mesh. Preconditions: has_lanes(), and the template is of the class of these faces, 1 to
    /// `at_once`. Cost: that of the program.
    KITH_LANES void fill(const patch& t, std::span<const Index> bases, std::span<const Index> faces)
    {
        ensure_size(slots_, t.program.slots() * size * width);
        ensure_size(first_corners_, (t.steps.size() + 1) * at_once);
        ensure_size(sources_, t.sources.size() * width);
        walk(t, faces);
        for (std::size_t begin = 0; begin < faces.size(); begin += width)
            fill_lanes(t, bases, begin, std::min(width, faces.size() - begin));
    }

private:
    /// Finds the faces of all neighbourhoods, step by step around all of them: what one waits for from the memory, the others do, too.
    [[gnu::always_inline]] void walk(const patch& t, std::span<const Index> faces)
    {
        const connectivity<Index>& mesh = coarse_->topology();
        Index* to = first_corners_.data();
        for (std::size_t i = 0; i < faces.size(); ++i)
            to[i] = Index(Degree * faces[i]);
        for (const walk_step& step : t.steps) {
            to += at_once;
            for (std::size_t i = 0; i < faces.size(); ++i)
                to[i] = Index(mesh.across(corner(step.from, i)) - step.rotation);
        }
        for (const walked_corner& input : t.inputs)
            for (std::size_t i = 0; i < faces.size(); ++i)
                __builtin_prefetch(&coarse_->point(mesh.corner_vertex[corner(input, i)]));
    }
    [[nodiscard]] Index corner(const walked_corner& c, std::size_t i) const
    {
        return Index(first_corners_[at_once * c.face + i] + c.corner);
    }

    /// Of some of these faces, at most as many as there are lanes. A function of its own: in the loop g++ 12 makes slower code of it.
    KITH_LANES void fill_lanes(const patch& t, std::span<const Index> bases, std::size_t begin, std::size_t count)
    {
        for (std::size_t lane = 0; lane < width; ++lane) { // where there are fewer faces the first stands for them
            const std::size_t i = begin + (lane < count ? lane : 0);
            load(t, i, lane);
            look_up(t, i, lane);
        }
        writer_.begin(t, bases.data(), sources_.data());
        t.program.template run<packs>(reinterpret_cast<pack*>(slots_.data()));
        writer_.write(t, slots_.data(), count);
    }

    /// The points of a neighbourhood into a lane.
    [[gnu::always_inline]] void load(const patch& t, std::size_t face, std::size_t lane)
    {
        scalar* to = slots_.data() + lane;
        for (const walked_corner& input : t.inputs) {
            const Point& point = coarse_->point(coarse_->topology().corner_vertex[corner(input, face)]);
            for (std::size_t i = 0; i < size; ++i, to += width)
                *to = point[i];
        }
    }
    /// The numbers that others follow from.
    [[gnu::always_inline]] void look_up(const patch& t, std::size_t face, std::size_t lane)
    {
        const connectivity<Index>& mesh = coarse_->topology();
        Index* to = sources_.data() + lane;
        for (const auto& [kind, place] : t.sources) {
            const Index at = corner(place, face);
            *to = kind == tuple_kind::v   ? mesh.corner_vertex[at]
                  : kind == tuple_kind::e ? Index(mesh.corner_halfedge[at] / 2)
                                          : Index(at / Degree);
            to += width;
        }
    }

    const basic_mesh<Point, Index>* coarse_;
    writer writer_;
    storage<scalar> slots_;
    storage<Index> first_corners_, sources_;
};

#endif

} // namespace kith
