// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_template.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/level_sink.hpp>
#include <kith/engine/lane/lanes.hpp>
#include <kith/numbering/step/surface_order.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kith {

#ifdef KITH_HAS_LANES

/// The memory to which a level is written: its points, and the arrays of its connectivity or nothing.
template <class Point, std::unsigned_integral Index>
struct patch_output {
    Point* points;
    Index* corner_vertex = nullptr;
    Index* corner_halfedge = nullptr; ///< if null, the next two are, too
    Index* halfedge_corner = nullptr;
    Index* vertex_corner = nullptr;
    level_writer<Point, Index>* writer = nullptr; ///< of a mesh of another library, in place of these arrays
    /// The numbers of the coarse elements from which the written numbers follow, if these differ from those in the
    /// coarse mesh. Its faces have one degree then.
    const element_numbers<Index>* coarse_numbers = nullptr;
    std::size_t lane_bytes = kith::lane_bytes(); ///< size of the registers; smaller ones make the same bits

    [[nodiscard]] bool has_faces() const { return corner_vertex != nullptr; }
    [[nodiscard]] bool has_edges() const { return corner_halfedge != nullptr; }
};

/// A writer of the patches of faces of one class. Several faces lie side by side, each in a lane. Elements are written
/// to the places that follow from the numbers of the faces. If a level is larger than the caches, it is written past
/// them.
template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
class patch_writer {
    using scalar = scalar_of<Point>;
    static constexpr std::size_t size = lane_numbers<Point>;

public:
    using template_type = patch_template<scalar, Index>;

    /// The number of faces that lie side by side in registers of `Bytes` bytes. They fill two registers, so that an
    /// operand or a place is found once for both.
    template <std::size_t Bytes>
    static constexpr std::size_t width = 2 * lanes<scalar, Bytes>::count;
    /// The number of faces for which numbers are found at once. Of these as many are written together as fit.
    static constexpr std::size_t at_once = width<most_lane_bytes>;

    patch_writer(const patch_output<Point, Index>& to, bool past_caches) : to_(to), past_caches_(past_caches) {}

    /// Begins with `Width` faces, and prefetches the places that will be written. `bases` has what is added to each
    /// multiple in this mesh. `sources` has `at_once` numbers for each source.
    template <std::size_t Width>
    [[gnu::always_inline]] void begin(const template_type& t, const Index* bases, const Index* sources)
    {
        multiply<Width>(t, bases, sources);
        call_for<Width>(to_.points, t.vertices);
        if (to_.has_faces())
            call_for<Width>(to_.corner_vertex, t.corners);
        if (to_.has_edges()) {
            call_for<Width>(to_.corner_halfedge, t.corners);
            call_for<Width>(to_.halfedge_corner, t.halfedges);
            call_for<Width>(to_.vertex_corner, t.vertices);
        }
    }
    /// Writes points, from the slots of the program, and numbers. A slot has the lanes of one coordinate after those of
    /// another. A level_writer is called for the first `count` lanes only.
    template <std::size_t Width>
    [[gnu::always_inline]] void write(const template_type& t, const scalar* slots, std::size_t count)
    {
        write_points<Width>(t, slots);
        if (to_.has_faces())
            write_numbers<Width>(to_.corner_vertex, t.corners, t.corner_vertex);
        if (to_.has_edges()) {
            write_numbers<Width>(to_.corner_halfedge, t.corners, t.corner_halfedge);
            write_numbers<Width>(to_.halfedge_corner, t.halfedges, t.halfedge_corner);
            write_numbers<Width>(to_.vertex_corner, t.vertices, t.vertex_corner);
        }
        if (to_.writer != nullptr) {
            write_faces<Width>(*to_.writer, t, count);
            write_starts<Width>(*to_.writer, t, count);
        }
    }

private:
    template <std::size_t Width>
    [[gnu::always_inline]] void multiply(const template_type& t, const Index* bases, const Index* sources)
    {
        ensure_size(multiples_, t.multiples.size() * Width);
        Index* to = multiples_.data();
        for (const auto& m :
             std::span(t.multiples).first(to_.writer != nullptr ? t.multiples.size() : t.multiples_of_others)) {
            const Index base = *bases++;
            for (std::size_t lane = 0; lane < Width; ++lane)
                *to++ = Index(base + m.factor * sources[m.source * at_once + lane]);
        }
    }
    template <std::size_t Width>
    [[nodiscard]] Index multiple(std::size_t which, std::size_t lane) const
    {
        return multiples_[which * Width + lane];
    }

    using run = typename patch_numbers<Index>::run;
    using list = typename patch_numbers<Index>::list;

    /// Returns true if a run is written past the caches. A run shorter than a cache line would leave lines half
    /// written, which others fill later.
    [[nodiscard]] bool goes_past_caches(const run& r, std::size_t bytes) const
    {
        return past_caches_ and r.step == 1 and r.count * bytes >= 64;
    }
    /// Prefetches the places that will be written, so that they are in the caches when the program has run.
    template <std::size_t Width, class T>
    [[gnu::always_inline]] void call_for(T* array, const std::vector<run>& places) const
    {
        for (const run& r : places)
            if (not goes_past_caches(r, sizeof(T)))
                for (std::size_t lane = 0; lane < Width; ++lane) {
                    const auto* const first = reinterpret_cast<const char*>(
                        array + Index(r.offset + multiple<Width>(r.of, lane)));
                    for (std::size_t i = 0; i < r.step * r.count * sizeof(T); i += 64)
                        __builtin_prefetch(first + i, 1);
                }
    }

    /// Writes the points of the owned vertices.
    template <std::size_t Width>
    [[gnu::always_inline]] void write_points(const template_type& t, const scalar* slots) const
    {
        const std::uint16_t* slot = t.program.outputs().data();
        for (const run& r : t.vertices) {
            const std::size_t count = r.count, step = r.step * size;
            const auto all = [&](const auto& store) __attribute__((always_inline)) {
                for (std::size_t lane = 0; lane < Width; ++lane) {
                    scalar* to = first_number(to_.points[Index(r.offset + multiple<Width>(r.of, lane))]);
                    const scalar* const in_lane = slots + lane;
                    for (std::size_t v = 0; v < count; ++v, to += step) {
                        const scalar* const from = in_lane + slot[v] * (size * Width);
                        for (std::size_t i = 0; i < size; ++i)
                            store(to + i, from[i * Width]);
                    }
                }
            };
            if (goes_past_caches(r, sizeof(Point)))
                all([](scalar* at, scalar x) __attribute__((always_inline)) { store_past_caches(at, x); });
            else
                all([](scalar* at, scalar x) __attribute__((always_inline)) { *at = x; });
            slot += count;
        }
    }

    /// Writes the lines of faces to a level_writer, run by run.
    template <std::size_t Width>
    [[gnu::always_inline]] void write_faces(level_writer<Point, Index>& to, const template_type& t, std::size_t count)
    {
        using line = face_line<Index>;
        std::size_t first = 0;
        for (const auto& r : t.faces) {
            const std::size_t corners = r.degree * r.count;
            ensure_size(lines_, Width * corners);
            for (std::size_t i = 0; i < corners; ++i) {
                const std::size_t c = first + i;
                const Index* const vertex = multiples_.data() + t.corner_vertex.of[c] * Width;
                const Index* const halfedge = multiples_.data() + t.corner_halfedge.of[c] * Width;
                for (std::size_t lane = 0; lane < Width; ++lane)
                    lines_[corners * lane + i] = line{Index(t.corner_vertex.offset[c] + vertex[lane]),
                                                      Index(t.corner_halfedge.offset[c] + halfedge[lane])};
            }
            for (std::size_t lane = 0; lane < count; ++lane)
                to.set_faces(Index(r.offset + multiple<Width>(r.of, lane)),
                             r.degree,
                             std::span<const line>(lines_.data() + corners * lane, corners));
            first += corners;
        }
    }
    template <std::size_t Width>
    [[gnu::always_inline]] void write_starts(level_writer<Point, Index>& to, const template_type& t, std::size_t count)
    {
        std::size_t v = 0;
        for (const run& r : t.vertices)
            for (std::size_t i = 0; i < r.count; ++i, ++v)
                for (std::size_t lane = 0; lane < count; ++lane)
                    to.set_start(Index(r.offset + multiple<Width>(r.of, lane) + r.step * i),
                                 Index(t.vertex_halfedge.offset[v] + multiple<Width>(t.vertex_halfedge.of[v], lane)));
    }

    /// Writes numbers to the places of an array.
    template <std::size_t Width>
    [[gnu::always_inline]] void write_numbers(Index* array, const std::vector<run>& places, const list& numbers) const
    {
        const Index* offset = numbers.offset.data();
        const auto* of = numbers.of.data();
        for (const run& r : places) {
            Index* to[Width];
            for (std::size_t lane = 0; lane < Width; ++lane)
                to[lane] = array + Index(r.offset + multiple<Width>(r.of, lane));
            std::size_t i = 0;
            if constexpr (4 * sizeof(Index) == sizeof(quad) and Width % 4 == 0)
                if (r.step == 1 and r.count >= 4) {
                    i = r.count / 4 * 4;
                    for (std::size_t lane = 0; lane < Width; lane += 4)
                        write_quads<Width>(to + lane, i, goes_past_caches(r, sizeof(Index)), offset, of, lane);
                }
            for (; i < r.count; ++i)
                for (std::size_t lane = 0; lane < Width; ++lane)
                    to[lane][r.step * i] = Index(offset[i] + multiple<Width>(of[i], lane));
            offset += r.count;
            of += r.count;
        }
    }

    typedef std::uint32_t quad __attribute__((vector_size(16), may_alias));

    /// Writes numbers for four lanes, four numbers at a time, which are transposed from lanes to rows.
    template <std::size_t Width>
    [[gnu::always_inline]] void write_quads(Index* const* to, std::size_t count, bool past_caches, const Index* offset,
                                            const typename patch_numbers<Index>::place* of, std::size_t lane) const
    {
        bool is_aligned = past_caches;
        for (std::size_t i = 0; i < 4; ++i)
            is_aligned = is_aligned and reinterpret_cast<std::uintptr_t>(to[i]) % 64 == 0;
        const Index* const multiples = multiples_.data() + lane;
        const auto number = [&](std::size_t i) __attribute__((always_inline)) {
            return *reinterpret_cast<const quad*>(multiples + of[i] * Width) + offset[i];
        };
        const auto turn = [&](std::size_t i, const auto& store) __attribute__((always_inline)) {
            const quad a = number(i), b = number(i + 1), c = number(i + 2), d = number(i + 3);
            const quad ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
            const quad ef = __builtin_shufflevector(a, b, 2, 6, 3, 7), gh = __builtin_shufflevector(c, d, 2, 6, 3, 7);
            store(to[0] + i, quad(__builtin_shufflevector(ab, cd, 0, 1, 4, 5)));
            store(to[1] + i, quad(__builtin_shufflevector(ab, cd, 2, 3, 6, 7)));
            store(to[2] + i, quad(__builtin_shufflevector(ef, gh, 0, 1, 4, 5)));
            store(to[3] + i, quad(__builtin_shufflevector(ef, gh, 2, 3, 6, 7)));
        };
        std::size_t i = 0;
        // Writes whole cache lines: a processor has few buffers for writes past the caches, and is slow if these leave
        // half full.
        if (is_aligned)
            for (; i + 16 <= count; i += 16) {
                quad lines[4][4];
                for (std::size_t part = 0; part < 4; ++part) {
                    quad* line = &lines[0][part];
                    turn(i + 4 * part, [&](Index*, quad q) __attribute__((always_inline)) {
                        *line = q;
                        line += 4;
                    });
                }
                for (std::size_t row = 0; row < 4; ++row)
                    for (std::size_t part = 0; part < 4; ++part)
                        store_past_caches(reinterpret_cast<quad*>(to[row] + i) + part, lines[row][part]);
            }
        for (; i < count; i += 4)
            turn(i, [](Index* at, quad q) __attribute__((always_inline)) { __builtin_memcpy(at, &q, sizeof(q)); });
    }

    patch_output<Point, Index> to_;
    bool past_caches_;
    storage<Index> multiples_;
    storage<face_line<Index>> lines_;
};

#endif

} // namespace kith
