// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The kinds of things with numbers: vertices, the two sides of each edge, faces and their corners.
enum class number_kind : unsigned char { vertex, side, face, corner };

/// The numbers that a patch writes, and the numbers of the places to which it writes them. All follow from the numbers
/// of a few coarse elements, the sources. A number is an offset plus a multiple. A multiple is a factor times the
/// number of a source, plus the number that the path of columns adds.
template <std::unsigned_integral Index>
class patch_numbers {
public:
    using place = std::uint16_t; ///< an index in the list of multiples

    struct multiple {
        std::uint32_t source; ///< its place in the list of sources
        Index factor;
        column_path path;
        number_kind kind;
    };
    /// A list of numbers one by one.
    struct list {
        std::vector<Index> offset;
        std::vector<place> of;
    };
    /// A run of numbers that follow one another, or of every second one.
    struct run {
        Index offset;
        place of;
        std::uint16_t step;
        std::uint32_t count;
    };

    /// A run of faces that follow one another and have the same degree.
    struct face_run {
        Index offset;
        place of;
        std::uint32_t degree, count;
    };

    /// Returns what is added to a multiple of the number of a source in a mesh. The steps of the mesh have these bases,
    /// and its faces have this degree, or several (0).
    static Index base(const multiple& m, std::span<const column_bases> bases, std::size_t degree)
    {
        switch (m.kind) {
        case number_kind::vertex: return Index(m.path.base(tuple_kind::v, bases, degree));
        case number_kind::side: return Index(2 * m.path.base(tuple_kind::e, bases, degree));
        case number_kind::face: return Index(m.path.base(tuple_kind::f, bases, degree));
        default:
            return degree != 0 ? Index(degree * m.path.base(tuple_kind::f, bases, degree))
                               : Index(m.path.base(tuple_kind::vf, bases, degree));
        }
    }

    /// Begins anew in the same memory, with sources whose numbers are below `sources`.
    void restart(std::size_t sources)
    {
        multiples_.clear();
        sources_.clear();
        next_of_source_.clear();
        first_of_source_.assign(sources, none);
    }

    [[nodiscard]] const std::vector<multiple>& multiples() const { return multiples_; }
    /// Returns the sources of the multiples.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const { return sources_; }
    /// Returns true if there are more multiples than `place` can number. Then the lists must not be used.
    [[nodiscard]] bool is_too_long() const { return multiples_.size() > std::numeric_limits<place>::max(); }

    [[nodiscard]] list all(number_kind kind, std::span<const affine_number<Index>> numbers)
    {
        list result;
        result.offset.reserve(numbers.size());
        result.of.reserve(numbers.size());
        for (const auto& n : numbers) {
            result.offset.push_back(n.offset);
            result.of.push_back(find(kind, n));
        }
        return result;
    }
    [[nodiscard]] std::vector<run> runs(number_kind kind, std::span<const affine_number<Index>> numbers)
    {
        std::vector<run> result;
        for (const auto& n : numbers) {
            const place of = find(kind, n);
            if (result.empty() or not follows(result.back(), n.offset, of))
                result.push_back({n.offset, of, 1, 0});
            run& last = result.back();
            if (last.count == 1)
                last.step = std::uint16_t(n.offset - last.offset);
            ++last.count;
        }
        return result;
    }
    /// Returns the runs of faces with these numbers and degrees.
    [[nodiscard]] std::vector<face_run> runs_of_faces(std::span<const affine_number<Index>> numbers,
                                                      std::span<const std::uint32_t> degrees)
    {
        std::vector<face_run> result;
        for (std::size_t f = 0; f < numbers.size(); ++f) {
            const place of = find(number_kind::face, numbers[f]);
            if (result.empty() or result.back().of != of or result.back().degree != degrees[f] or
                Index(numbers[f].offset - result.back().offset) != result.back().count)
                result.push_back({numbers[f].offset, of, degrees[f], 0});
            ++result.back().count;
        }
        return result;
    }

private:
    static bool follows(const run& last, Index offset, place of)
    {
        const Index step = Index(offset - last.offset);
        return of == last.of and (last.count == 1 ? step == 1 or step == 2 : step == Index(last.step * last.count));
    }
    place find(number_kind kind, const affine_number<Index>& n)
    {
        std::uint32_t& first = first_of_source_[n.source];
        for (std::uint32_t known = first; known != none; known = next_of_source_[known])
            if (const multiple& m = multiples_[known]; m.factor == n.factor and m.path == n.path and m.kind == kind)
                return place(known);
        const std::uint32_t source = first == none ? std::uint32_t(sources_.size()) : multiples_[first].source;
        if (first == none)
            sources_.push_back(n.source);
        next_of_source_.push_back(std::exchange(first, std::uint32_t(multiples_.size())));
        multiples_.push_back({source, n.factor, n.path, kind});
        return place(first);
    }

    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<multiple> multiples_;
    std::vector<std::uint32_t> sources_;
    std::vector<std::uint32_t> first_of_source_, next_of_source_; // multiples of the same source, one after the other
};

} // namespace kith
