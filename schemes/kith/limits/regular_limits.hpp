// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "regular_masks.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/level/native_level.hpp>
#include <kith/engine/lane/lanes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::detail {

#ifdef KITH_HAS_LANES

/// The limits of regular vertices, made for as many vertices at a time as two registers have lanes. The results have
/// the same bits as those of `limit_search::take` at each vertex.
template <std::unsigned_integral Index, int Degree>
class regular_limits {
    using mesh_type = basic_mesh<std::array<double, 3>, Index>;
    using level_type = native_level<std::array<double, 3>, Index, Degree>;

public:
    /// Takes references, all of which must outlive this object.
    regular_limits(const mesh_type& mesh, const regular_masks& masks, const std::vector<unsigned char>& is_irregular,
                   const limit_places& to)
        : level_(mesh)
        , mesh_(mesh.topology())
        , points_(mesh.points().data())
        , masks_(masks)
        , is_irregular_(is_irregular)
        , to_(to)
        , corners_((masks.steps().size() + 1) * at_once)
        , found_(masks.inputs().size() * at_once)
        , slots_(masks.program().slots() * width<most_lane_bytes>, point{})
    {
    }

    /// Makes the limits of the vertices whose fans begin in the faces [begin, end).
    void make(std::size_t begin, std::size_t end)
    {
        vertices_.clear();
        level_.for_vertices_of(begin, end, [&](auto v) {
            if (is_irregular_.empty() or is_irregular_[v.value] == 0)
                vertices_.push_back(v.value);
        });
        count_ = vertices_.size();
        vertices_.resize(count_ + at_once, count_ != 0 ? vertices_.back() : 0); // copies of the last one fill up
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
    static constexpr std::size_t at_once = 128;
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
        for (std::size_t first = 0; first < count_; first += at_once) {
            find(vertices_.data() + first);
            const std::size_t end = std::min(at_once, count_ - first);
            for (std::size_t i = 0; i < end; i += width<Bytes>)
                make_some<Bytes>(vertices_.data() + first + i, i, std::min(width<Bytes>, end - i));
        }
    }
    /// Makes the limits of some of the vertices that were found, beginning with this one.
    template <std::size_t Bytes>
    [[gnu::always_inline]] void make_some(const Index* vertices, std::size_t first, std::size_t count)
    {
        constexpr std::size_t w = width<Bytes>;
        load<w>(first);
        masks_.program().template run<w * sizeof(point) / Bytes, Bytes>(
            reinterpret_cast<typename lanes<double, Bytes>::type*>(slots_.data()));
        const limit_places all = to_;
        Index* const is_open = is_open_.data() + first;
        const bool have_tangents = masks_.have_tangents();
        if (have_tangents)
            make_normals<Bytes>(result<w>(1), result<w>(2), is_open);
        const point* const position = result<w>(0);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t v = vertices[i];
            if (is_open[i] != 0)
                continue;
            all.is_open[v] = 0;
            all.positions[v] = {position[i][0], position[i][1], position[i][2]};
            if (have_tangents) {
                all.has_no_normal[v] = 0;
                all.normals[v] = {normals_[0][i], normals_[1][i], normals_[2][i]};
            }
        }
    }
    template <std::size_t Width>
    [[nodiscard]] const point* result(std::size_t number) const
    {
        return slots_.data() + Width * masks_.program().outputs()[number];
    }
    /// Finds the points to be read around each vertex, and notes whether its fan has another valence. Each step is made
    /// for all vertices before the next step, so that their memory accesses overlap.
    [[gnu::always_inline]] void find(const Index* vertices)
    {
        Index* const first = corners_.data();
        for (std::size_t i = 0; i < at_once; ++i)
            first[i] = mesh_.vertex_corner[vertices[i]];
        Index* to = first + at_once;
        for (const corner_from& step : masks_.steps()) {
            cross(first + at_once * step.reached, step.on, to);
            for (std::size_t i = 0; i < at_once; ++i)
                to[i] = to[i] == connectivity<Index>::none ? first[i] : to[i]; // the fan is not regular
            to += at_once;
        }
        Index* const end_of_fan = first + at_once * masks_.valence();
        std::array<Index, at_once> last;
        cross(end_of_fan - at_once, degree - 1, last.data());
        for (std::size_t i = 0; i < at_once; ++i)
            is_open_[i] = Index(last[i] != first[i]);
        for (const Index* at = first + at_once; at != end_of_fan; at += at_once)
            for (std::size_t i = 0; i < at_once; ++i)
                is_open_[i] |= Index(at[i] == first[i]);

        const Index* const vertex = mesh_.corner_vertex.data();
        Index* found = found_.data();
        for (const corner_from& input : masks_.inputs()) {
            const auto from = moved(first + at_once * input.reached, input.on);
            for (std::size_t i = 0; i < at_once; ++i) {
                found[i] = vertex[from[i]];
                __builtin_prefetch(points_ + found[i]);
            }
            found += at_once;
        }
    }
    /// Finds the corners across from the corners that lie `on` corners after the given ones.
    [[gnu::always_inline]] void cross(const Index* corners, Index on, Index* across) const
    {
        const Index *const halfedge = mesh_.corner_halfedge.data(), *const at = mesh_.halfedge_corner.data();
        const auto from = moved(corners, on);
        for (std::size_t i = 0; i < at_once; ++i)
            across[i] = at[halfedge[from[i]] ^ 1];
    }
    /// Returns the corners that lie `on` corners after the given ones in their faces.
    [[nodiscard, gnu::always_inline]] std::array<Index, at_once> moved(const Index* corners, Index on) const
    {
        std::array<Index, at_once> result;
        for (std::size_t i = 0; i < at_once; ++i) {
            const Index c = corners[i];
            if constexpr (Degree == 4) {
                result[i] = Index(c & ~Index(3)) | (Index(c + on) & 3);
            } else {
                const Index place = Degree == 3 ? c % 3 : Index(c - mesh_.face_corner[mesh_.corner_face[c]]);
                result[i] = Index(c + on - (place + on >= degree ? degree : 0));
            }
        }
        return result;
    }
    /// Reads the points found for as many vertices as the registers hold.
    template <std::size_t Width>
    [[gnu::always_inline]] void load(std::size_t first)
    {
        const std::array<double, 3>* const points = points_;
        const Index* found = found_.data() + first;
        point* to = slots_.data();
        for (std::size_t input = 0; input < masks_.inputs().size(); ++input, found += at_once, to += Width)
            for (std::size_t i = 0; i < Width; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    to[i][k] = points[found[i]][k];
    }

    /// Makes unit normals of two tangents each, as normal_of does. A vertex stays open if the exponents of its tangents
    /// or of their product need more care.
    template <std::size_t Bytes>
    [[gnu::always_inline]] void make_normals(const point* first, const point* second, Index* is_open)
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
                is_open[from + i] |= Index(not(is_in_range(of_a[i]) and is_in_range(of_b[i]) and is_usual(of_n[i])));
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
    std::size_t count_ = 0; // number of vertices whose limits are to be made
    std::array<Index, at_once> is_open_{};
    alignas(most_lane_bytes) std::array<std::array<double, width<most_lane_bytes>>, 3> normals_;
    storage<Index> corners_; // the corners reached from each vertex
    storage<Index> found_;   // the vertices of the inputs of each vertex
    storage<point> slots_;   // the last number of each is not read
};

/// Makes the limits of all vertices of a level that are not marked as irregular, and closes these vertices. A vertex
/// whose fan shows that it is irregular stays open. Cost: O(corners).
template <std::unsigned_integral Index>
void fill_regular_limits(const basic_mesh<std::array<double, 3>, Index>& mesh, const regular_masks& masks,
                         const std::vector<unsigned char>& is_irregular, const limit_places& to)
{
    constexpr std::size_t faces_of_part = 1024;
    const auto make = [&, faces = mesh.face_count()]<int Degree>() {
        for_shared_parts(faces, faces_of_part, is_worth_threads(faces), [&](parts_to_do parts) {
            regular_limits<Index, Degree> some(mesh, masks, is_irregular, to);
            parts.for_each([&](std::size_t begin, std::size_t end) { some.make(begin, end); });
        });
    };
    if (mesh.topology().degree == 4)
        make.template operator()<4>();
    else if (mesh.topology().degree == 3)
        make.template operator()<3>();
    else
        make.template operator()<0>();
}

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
        fill_regular_limits(mesh, *masks, is_irregular, to);
    }
}

#endif

} // namespace kith::detail
