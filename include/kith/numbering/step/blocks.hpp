// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refinement.hpp"

#include <cstddef>

namespace kith {

/// The elements of one kind of a block: part `number` of `count`.
template <level Level, element Element>
struct block_elements {
    all_elements<Level, Element> all;
    std::size_t number, count;

    /// Returns where this part of `size` elements begins; end() returns where it ends.
    [[nodiscard]] std::size_t begin(std::size_t size) const { return size * number / count; }
    [[nodiscard]] std::size_t end(std::size_t size) const { return size * (number + 1) / count; }
};

/// A part of a level, `number` of `count`: some consecutive faces and the vertices, edges and corners that belong to
/// them.
template <level Level>
class block_of_level {
public:
    block_of_level(const Level& level, std::size_t number, std::size_t count)
        : level_(&level), number_(number), count_(count)
    {
    }

    [[nodiscard]] auto vertices() const { return part(level_->vertices()); }
    [[nodiscard]] auto edges() const { return part(level_->edges()); }
    [[nodiscard]] auto faces() const { return part(level_->faces()); }
    [[nodiscard]] auto corners() const { return part(level_->corners()); }
    /// Returns true if the whole level is closed.
    [[nodiscard]] bool is_closed() const { return level_->is_closed(); }

private:
    template <element Element>
    [[nodiscard]] auto part(const all_elements<Level, Element>& all) const
    {
        return block_elements<Level, Element>{all, number_, count_};
    }

    const Level* level_;
    std::size_t number_, count_;
};

/// Calls f on the elements of a block, in the order of their numbers; for_each calls f as it does on a level.
template <level Level, element Element, class F>
void for_each_by_number(const block_elements<Level, Element>& range, const F& f)
{
    const std::size_t size = range.all.size();
    if constexpr (detail::inlines_masks<Level>)
        detail::for_numbers_inlined(range.all, range.begin(size), range.end(size), f);
    else
        detail::for_numbers(range.all, range.begin(size), range.end(size), f);
}
template <level Level, element Element, class F>
void for_each(const block_elements<Level, Element>& range, const F& f)
{
    if constexpr (detail::met_by_faces<Level, Element>) {
        const std::size_t faces = range.all.level().face_count();
        detail::for_faces_inlined(range.all, range.begin(faces), range.end(faces), f);
    } else {
        for_each_by_number(range, f);
    }
}

/// Calls body(part of r) for parts of the coarse level that fit the cache. Data that one loop of the body fetches is
/// then still there for the next loop. The loops of the body must not read elements that they make, only the coarse
/// level and elements made before. Each OpenMP thread takes consecutive parts. Errors: as for_each.
template <level Level, mask_evaluator Space, class Scalar, class Body>
void in_blocks(const refinement<Level, Space, Scalar>& r, const Body& body)
{
    if constexpr (detail::ordered_by_faces<Level>) {
        constexpr std::size_t faces_of_block = 1024; // with all that belongs to them about half of a second-level cache
        const std::size_t faces = r.coarse.face_count();
        const std::size_t count = (faces + faces_of_block - 1) / faces_of_block;
        const bool parallel = Level::parallel and detail::is_worth_threads(faces);
        detail::for_shared_parts(count, 1, parallel, [&](detail::parts_to_do parts) {
            const detail::loop_body inside(true);
            parts.for_each([&](std::size_t number, std::size_t) {
                const block_of_level<Level> block(r.coarse, number, count);
                const refinement<block_of_level<Level>, Space, Scalar> part{block, r.assoc, r.generation};
                body(part);
            });
        });
    } else {
        const detail::loop_body inside(true);
        body(r);
    }
}

} // namespace kith
