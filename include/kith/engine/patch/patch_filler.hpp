// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_writer.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/engine/lane/lanes.hpp>
#include <kith/numbering/step/surface_order.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kith {

#ifdef KITH_HAS_LANES

/// A writer of the patches of faces by templates. It fills as many faces at a time as two registers have lanes.
template <class Point, std::unsigned_integral Index>
    requires fits_lanes<Point>
class patch_filler {
    using scalar = scalar_of<Point>;
    using writer = patch_writer<Point, Index>;
    static constexpr std::size_t size = lane_numbers<Point>;

public:
    using template_type = typename writer::template_type;

    static constexpr std::size_t at_once = writer::at_once;

    /// Returns how many numbers find() writes for the faces of a class that are filled in one call.
    static std::size_t numbers_found(const template_type& t) { return (t.inputs.size() + t.sources.size()) * at_once; }

    /// Takes a coarse mesh and the output. With `past_caches`, it writes past the caches, for a level too large to stay
    /// in them until it is read.
    patch_filler(const basic_mesh<Point, Index>& coarse, const patch_output<Point, Index>& to, bool past_caches)
        : coarse_(&coarse)
        , writer_(to, past_caches)
        , finder_(coarse.topology())
        , numbers_(to.coarse_numbers)
        , lane_bytes_(to.lane_bytes)
    {
    }

    /// Finds the vertices of the inputs and the numbers of the sources. Precondition: there are 1 to `at_once` faces,
    /// all of the class of the template.
    void find(const template_type& t, std::span<const Index> faces, std::span<Index> found)
    {
        finder_.walk(t.steps, faces);
        Index* to = found.data();
        for (const walked_element& input : t.inputs) {
            finder_.find(input, to);
            to += at_once;
        }
        for (const walked_element& source : t.sources) {
            finder_.find(source, to);
            if (numbers_ != nullptr) {
                const storage<Index>& number = numbers_->of(source.kind);
                for (std::size_t i = 0; i < at_once; ++i)
                    to[i] = number[to[i]];
            }
            to += at_once;
        }
    }
    /// Prefetches the points that will be read.
    void call_for(const template_type& t, std::span<const Index> found) const
    {
        for (const Index v : found.first(t.inputs.size() * at_once))
            __builtin_prefetch(&coarse_->point(v));
    }
    /// Writes the patches of `count` faces. `bases` has what is added to each multiple in this mesh. Precondition:
    /// find() has found `found` for these faces.
    /// Cost: that of the program.
    void fill(const template_type& t, std::span<const Index> bases, std::span<const Index> found, std::size_t count)
    {
#if defined(__x86_64__)
        if (lane_bytes_ == 64 and count > writer::template width<32>)
            return fill_64_bytes(t, bases, found.data(), count);
        if (lane_bytes_ >= 32)
            return in_parts<32>(count, [&](std::size_t begin, std::size_t part) {
                fill_32_bytes(t, bases, found.data() + begin, part);
            });
#endif
        in_parts<16>(count,
                     [&](std::size_t begin, std::size_t part) { fill_16_bytes(t, bases, found.data() + begin, part); });
    }

private:
    /// Calls f(begin, count) for as many of these faces at a time as there are lanes.
    template <std::size_t Bytes, class F>
    static void in_parts(std::size_t count, const F& f)
    {
        constexpr std::size_t width = writer::template width<Bytes>;
        for (std::size_t begin = 0; begin < count; begin += width)
            f(begin, std::min(width, count - begin));
    }

    // Separate functions, because g++ 12 makes slower code of them inside the loop.

    KITH_LANES_OF_16_BYTES void fill_16_bytes(const template_type& t, std::span<const Index> bases, const Index* found,
                                              std::size_t count)
    {
        fill_registers<16>(t, bases, found, count);
    }
#if defined(__x86_64__)
    KITH_LANES_OF_32_BYTES void fill_32_bytes(const template_type& t, std::span<const Index> bases, const Index* found,
                                              std::size_t count)
    {
        fill_registers<32>(t, bases, found, count);
    }
    KITH_LANES_OF_64_BYTES void fill_64_bytes(const template_type& t, std::span<const Index> bases, const Index* found,
                                              std::size_t count)
    {
        fill_registers<64>(t, bases, found, count);
    }
#endif
    /// Writes the patches of at most as many faces as there are lanes.
    template <std::size_t Bytes>
    [[gnu::always_inline]] void fill_registers(const template_type& t, std::span<const Index> bases, const Index* found,
                                               std::size_t count)
    {
        using registers = lanes<scalar, Bytes>;
        constexpr std::size_t faces = writer::template width<Bytes>;
        ensure_size(slots_, t.program.slots() * size * faces);
        load<faces>(t, found);
        writer_.template begin<faces>(t, bases.data(), found + t.inputs.size() * at_once);
        t.program.template run<size * faces / registers::count, Bytes>(
            reinterpret_cast<typename registers::type*>(slots_.data()));
        writer_.template write<faces>(t, slots_.data(), count);
    }

    /// Loads the points of the inputs, each neighbourhood into a lane.
    template <std::size_t Width>
    [[gnu::always_inline]] void load(const template_type& t, const Index* found)
    {
        scalar* to = slots_.data();
        for (std::size_t input = 0; input < t.inputs.size(); ++input, to += size * Width, found += at_once)
            for (std::size_t lane = 0; lane < Width; ++lane) {
                const scalar* const from = first_number(coarse_->point(found[lane]));
                for (std::size_t i = 0; i < size; ++i)
                    to[i * Width + lane] = from[i];
            }
    }

    const basic_mesh<Point, Index>* coarse_;
    writer writer_;
    element_finder<Index, at_once> finder_;
    const element_numbers<Index>* numbers_; // of coarse elements in the output, or nothing
    std::size_t lane_bytes_;
    storage<scalar> slots_;
};

#endif

} // namespace kith
