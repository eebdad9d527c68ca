// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "regular_masks.hpp"

#include <kith/base/for_parts.hpp>
#include <kith/base/storage.hpp>
#include <kith/lane/lanes.hpp>
#include <kith/level/native_level.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::detail {

#ifdef KITH_HAS_LANES

/// The arrays that limits are written into, by vertex.
struct limit_places {
    std::array<double, 3>* positions;
    std::array<double, 3>* normals;
    unsigned char* has_no_normal;
    unsigned char* is_open; ///< whether the limits of a vertex are still to be made
};

/// Makes the limits of regular vertices, as many at a time as two registers have lanes: what `limit_search::take` makes
/// of each, to the same bits.
template <std::unsigned_integral Index, int Degree>
class regular_limits {
    using mesh_type = basic_mesh<std::array<double, 3>, Index>;
    using level_type = native_level<std::array<double, 3>, Index, Degree>;

public:
    /// All must outlive this.
    regular_limits(const mesh_type& mesh, const regular_masks& masks, const std::vector<unsigned char>& is_irregular,
                   const limit_places& to)
        : level_(mesh)
        , mesh_(mesh.topology())
        , points_(mesh.points().data())
        , masks_(masks)
        , is_irregular_(is_irregular)
        , to_(to)
        , corners_((masks.steps().size() + 1) * most_at_once)
        , slots_(masks.program().slots() * most_at_once, point{})
    {
    }

    /// Makes those of the vertices whose fans begin in the faces [begin, end).
    void make(std::size_t begin, std::size_t end)
    {
        vertices_.clear();
        level_.for_vertices_of(begin, end, [&](auto v) {
            if (is_irregular_.empty() or is_irregular_[v.value] == 0)
                vertices_.push_back(v.value);
        });
        count_ = vertices_.size();
        vertices_.resize(count_ + most_at_once, count_ != 0 ? vertices_.back() : 0); // the last fills up the registers
#if defined(__x86_64__)
        const std::size_t bytes = lane_bytes();
        if (bytes == 64)
            return make_64_bytes();
        if (bytes == 32)
            return make_32_bytes();
#endif
        make_16_bytes();
    }

private:
    template <std::size_t Bytes>
    static constexpr std::size_t width = 2 * Bytes / sizeof(double);
    static constexpr std::size_t most_at_once = width<most_lane_bytes>;
    static constexpr auto degree = Index(Degree == 0 ? 4 : Degree);
    using point = std::array<double, 4>; ///< with room for one more number, so that registers have whole points

    KITH_LANES_OF_16_BYTES void make_16_bytes() { make_lanes<16>(); }
#if defined(__x86_64__)
    KITH_LANES_OF_32_BYTES void make_32_bytes() { make_lanes<32>(); }
    KITH_LANES_OF_64_BYTES void make_64_bytes() { make_lanes<64>(); }
#endif

    template <std::size_t Bytes>
    [[gnu::always_inline]] void make_lanes()
    {
        for (std::size_t first = 0; first < count_; first += width<Bytes>)
            make_some<Bytes>(vertices_.data() + first, std::min(width<Bytes>, count_ - first));
    }
    template <std::size_t Bytes>
    [[gnu::always_inline]] void make_some(const Index* vertices, std::size_t count)
    {
        constexpr std::size_t w = width<Bytes>;
        walk<w>(vertices);
        load<w>();
        masks_.program().template run<w * sizeof(point) / Bytes, Bytes>(
            reinterpret_cast<typename lanes<double, Bytes>::type*>(slots_.data()));
        const bool have_tangents = masks_.have_tangents();
        if (have_tangents)
            make_normals<Bytes>(result<w>(1), result<w>(2));
        const point* const position = result<w>(0);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t v = vertices[i];
            if (is_open_[i] != 0)
                continue;
            to_.is_open[v] = 0;
            to_.positions[v] = {position[i][0], position[i][1], position[i][2]};
            if (have_tangents) {
                to_.has_no_normal[v] = 0;
                to_.normals[v] = {normals_[0][i], normals_[1][i], normals_[2][i]};
            }
        }
    }
    template <std::size_t Width>
    [[nodiscard]] const point* result(std::size_t number) const
    {
        return slots_.data() + Width * masks_.program().outputs()[number];
    }
    /// Reaches the corners around each vertex, and notes whether its fan is not one of the regular valence.
    template <std::size_t Width>
    [[gnu::always_inline]] void walk(const Index* vertices)
    {
        Index* const first = corners_.data();
        const Index *const starts = mesh_.vertex_corner.data(), *const halfedge = mesh_.corner_halfedge.data(),
                           *const at = mesh_.halfedge_corner.data();
        for (std::size_t i = 0; i < Width; ++i) {
            first[i] = starts[vertices[i]];
            is_open_[i] = 0;
        }
        Index* to = first + Width;
        const Index* const last_of_fan = first + Width * masks_.valence();
        for (const corner_from& step : masks_.steps()) {
            const Index* const from = first + Width * step.reached;
            const bool is_in_fan = to < last_of_fan;
            for (std::size_t i = 0; i < Width; ++i) {
                const Index c = at[halfedge[moved(from[i], step.on)] ^ 1];
                const bool is_at_end = c == connectivity<Index>::none or c == first[i];
                to[i] = is_at_end ? first[i] : c;
                is_open_[i] |= Index(is_at_end and is_in_fan);
            }
            to += Width;
        }
        for (std::size_t i = 0; i < Width; ++i)
            is_open_[i] |= Index(at[halfedge[moved(last_of_fan[i - Width], degree - 1)] ^ 1] != first[i]);
    }
    /// The corner that lies so many corners on in its face.
    [[nodiscard, gnu::always_inline]] Index moved(Index corner, Index on) const
    {
        Index place;
        if constexpr (Degree == 4)
            return (corner & ~Index(3)) | ((corner + on) & 3);
        else if constexpr (Degree == 0)
            place = Index(corner - mesh_.face_corner[mesh_.corner_face[corner]]);
        else
            place = corner % degree;
        return Index(corner + on - (place + on >= degree ? degree : 0));
    }
    template <std::size_t Width>
    [[gnu::always_inline]] void load()
    {
        const Index* const vertex = mesh_.corner_vertex.data();
        point* to = slots_.data();
        for (const corner_from& input : masks_.inputs()) {
            const Index* const from = corners_.data() + Width * input.reached;
            for (std::size_t i = 0; i < Width; ++i) {
                const auto& at = points_[vertex[moved(from[i], input.on)]];
                to[i] = {at[0], at[1], at[2], 0};
            }
            to += Width;
        }
    }

    /// The unit normals that two tangents give each, as normal_of; leaves open where the tangents or their product have
    /// an exponent that asks for more.
    template <std::size_t Bytes>
    [[gnu::always_inline]] void make_normals(const point* first, const point* second)
    {
        using pack = typename lanes<double, Bytes>::type;
        using bits = typename lanes<std::uint64_t, Bytes>::type;
        constexpr std::size_t count = Bytes / sizeof(double), w = width<Bytes>;
        const auto bring_near_one = [](pack(&v)[3], bits& exponent) __attribute__((always_inline)) {
            bits largest = (bits)v[0] << 1;
            for (std::size_t k = 1; k < 3; ++k) {
                const bits one = (bits)v[k] << 1;
                largest = largest > one ? largest : one;
            }
            exponent = largest >> 53;
            const pack factor = (pack)((0x7fe - exponent) << 52);
            for (pack& x : v) {
                x *= factor;
                keep_rounded(x);
            }
        };
        for (std::size_t from = 0; from < w; from += count) {
            pack a[3], b[3], n[3];
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    a[k][i] = first[from + i][k];
                    b[k][i] = second[from + i][k];
                }
            bits of_a, of_b, of_n;
            bring_near_one(a, of_a);
            bring_near_one(b, of_b);
            for (std::size_t k = 0; k < 3; ++k) {
                pack left = a[(k + 1) % 3] * b[(k + 2) % 3], right = a[(k + 2) % 3] * b[(k + 1) % 3];
                keep_rounded(left);
                keep_rounded(right);
                n[k] = left - right;
            }
            bring_near_one(n, of_n);
            pack squares[3];
            for (std::size_t k = 0; k < 3; ++k) {
                squares[k] = n[k] * n[k];
                keep_rounded(squares[k]);
            }
            pack length = squares[0] + squares[1] + squares[2];
            for (std::size_t i = 0; i < count; ++i)
                length[i] = std::sqrt(length[i]);
            for (std::size_t i = 0; i < count; ++i)
                is_open_[from + i] |= Index(not(is_in_range(of_a[i]) and is_in_range(of_b[i]) and is_usual(of_n[i])));
            for (std::size_t k = 0; k < 3; ++k)
                *reinterpret_cast<pack*>(normals_[k].data() + from) = n[k] / length;
        }
    }

    level_type level_;
    const connectivity<Index>& mesh_;
    const std::array<double, 3>* points_;
    const regular_masks& masks_;
    const std::vector<unsigned char>& is_irregular_;
    limit_places to_;
    std::vector<Index> vertices_;
    std::size_t count_ = 0; // of those that are to be made
    std::array<Index, most_at_once> is_open_{};
    alignas(most_lane_bytes) std::array<std::array<double, most_at_once>, 3> normals_;
    storage<Index> corners_; // those reached, of each vertex
    storage<point> slots_;   // the last numbers are zero
};

/// Makes the limits of the regular vertices of a level, if there are masks for them, and closes these vertices. All
/// others stay open. `with_normals` says that a vertex without a normal stays open. Errors: those of the masks.
/// Cost: O(corners).
template <std::unsigned_integral Index, scheme Scheme>
void make_regular_limits(const basic_mesh<std::array<double, 3>, Index>& mesh, const Scheme& scheme, bool with_normals,
                         const limit_places& to)
{
    if constexpr (scheme_of_places<Scheme> and limit_rules<Scheme>::are_alike_where_regular) {
        const connectivity<Index>& level = mesh.topology();
        const std::size_t degree = level.degree == 3 ? 3 : 4;
        const auto masks = regular_masks::of(without_state(scheme), degree, mesh.generation());
        if (not masks or (with_normals and not masks->have_tangents()))
            return;
        const auto is_irregular = irregular_vertices(
            level, state_marks<Index>(level, scheme), degree, masks->valence(), limit_rules<Scheme>::rings(scheme));
        const auto make = [&]<int Degree>() {
            constexpr std::size_t faces_of_part = 1024;
            for_shared_parts(level.faces, faces_of_part, is_worth_threads(level.faces), [&](parts_to_do parts) {
                regular_limits<Index, Degree> some(mesh, *masks, is_irregular, to);
                parts.for_each([&](std::size_t begin, std::size_t end) { some.make(begin, end); });
            });
        };
        if (level.degree == 4)
            make.template operator()<4>();
        else if (level.degree == 3)
            make.template operator()<3>();
        else
            make.template operator()<0>();
    }
}

#endif

} // namespace kith::detail
