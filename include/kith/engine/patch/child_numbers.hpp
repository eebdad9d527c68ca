// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/engine/neighbourhood/affine_columns.hpp>

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// A column of a step of a whole mesh: the kind of its tuples, and the number where it begins.
struct whole_column {
    tuple_kind kind;
    std::uint64_t base;
};

/// A representation of the number that an element of a part has in the whole mesh. child(column, which, each) is the
/// number of one of its `each` children in a column: base + number * each + which.
template <class N>
concept inherited_number = requires(const N& n, const whole_column& column, std::uint64_t i) {
    { n.child(column, i, i) } -> std::same_as<N>;
    { n.of_each(i, i) } -> std::same_as<N>; // of things such as corners, several of which belong to each element
};

/// A path of columns that has led to an element, one per step. In each mesh the columns begin at other numbers.
class column_path {
    static constexpr int bits = 3;

public:
    static constexpr int most_columns = std::numeric_limits<std::uint32_t>::digits / bits;

    /// Returns the path with one more column. Precondition: it has fewer than most_columns.
    [[nodiscard]] column_path then(tuple_kind kind) const
    {
        column_path result;
        result.kinds_ = kinds_ << bits | (std::uint32_t(kind) + 1);
        return result;
    }
    /// Returns the number that the element with number 0 leads to by this path: its first child, the first child of
    /// that, and so on. The steps of the mesh have these bases. `last` is the kind of the result: a vertex, an edge, a
    /// face or the first corner of a face (v, e, f or vf). Returns 0 for an empty path.
    /// Precondition: any other path has one column for each step.
    [[nodiscard]] std::uint64_t base(tuple_kind last, std::span<const column_bases> bases, std::size_t degree) const
    {
        if (kinds_ == 0)
            return 0;
        // The kind of element that a step has made follows from the column after it.
        std::array<tuple_kind, most_columns> made;
        made[bases.size() - 1] = last;
        for (std::size_t step = bases.size() - 1; step > 0; --step) {
            const tuple_kind kind = kind_before(bases.size() - step - 1);
            const bool of_corners = made[step] == tuple_kind::vf and bases[step].has_corners_of_face(kind);
            made[step - 1] = of_corners ? tuple_kind::vf : numbered_elements(kind, degree);
        }
        std::uint64_t number = 0;
        for (std::size_t step = 0; step < bases.size(); ++step) {
            const tuple_kind kind = kind_before(bases.size() - step - 1);
            number = bases[step].base(made[step], kind) + bases[step].of_each(made[step], kind) * number;
        }
        return number;
    }

    friend auto operator<=>(const column_path&, const column_path&) = default;

private:
    [[nodiscard]] tuple_kind kind_before(std::size_t columns) const
    {
        return tuple_kind((kinds_ >> bits * columns & ((1U << bits) - 1)) - 1);
    }

    std::uint32_t kinds_ = 0; // the last one lowest
};

/// A number in the whole mesh as a function of the number of an element of an earlier level, its source. It is offset +
/// factor * (number of the source) + (what the path makes of 0).
template <std::unsigned_integral Index>
struct affine_number {
    Index offset, factor;
    std::uint32_t source; ///< which element of the earlier level
    column_path path{};

    [[nodiscard]] affine_number child(const whole_column& column, std::uint64_t which, std::uint64_t each) const
    {
        return {Index(which + each * offset), Index(each * factor), source, path.then(column.kind)};
    }
    /// Returns the number of one of `each` things that every element has, such as corners of a face or sides of an
    /// edge. Then what the path makes of 0 must be multiplied by `each`, too.
    [[nodiscard]] affine_number of_each(std::uint64_t which, std::uint64_t each) const
    {
        return {Index(which + each * offset), Index(each * factor), source, path};
    }
};

/// A number in the whole mesh, and whether its element descends from a wanted element of the earlier level.
template <std::unsigned_integral Index>
struct owned_number {
    Index number;
    bool owned;

    [[nodiscard]] owned_number child(const whole_column& column, std::uint64_t which, std::uint64_t each) const
    {
        return {Index(column.base + which + each * number), owned};
    }
    [[nodiscard]] owned_number of_each(std::uint64_t which, std::uint64_t each) const
    {
        return {Index(which + each * number), owned};
    }
};

/// The numbers of all elements of a part of a level in the whole mesh.
template <inherited_number Number>
struct part_of_whole {
    storage<Number> vertices, edges, faces;
    storage<Number> first_corners; ///< of faces, where these may have several degrees
    std::size_t degree = 0;        ///< of all faces; 0: they may have several

    /// Returns the number of the i-th corner of a face.
    [[nodiscard]] Number corner(std::size_t face, std::size_t i) const
    {
        return degree != 0 ? faces[face].of_each(i, degree) : first_corners[face].of_each(i, 1);
    }
    /// Returns the numbers of a part of this part, which has the listed elements.
    template <std::unsigned_integral Index>
    [[nodiscard]] part_of_whole of_part(std::span<const Index> some_vertices, std::span<const Index> some_edges,
                                        std::span<const Index> some_faces) const
    {
        const auto some = [](const storage<Number>& all, std::span<const Index> which) {
            storage<Number> result(which.size());
            for (std::size_t i = 0; i < which.size(); ++i)
                result[i] = all[which[i]];
            return result;
        };
        return {some(vertices, some_vertices),
                some(edges, some_edges),
                some(faces, some_faces),
                degree != 0 ? storage<Number>() : some(first_corners, some_faces),
                degree};
    }
    /// Returns the numbers of the next level of the part, which a step has made with these ids. Edges are left out if
    /// `with_edges` is false.
    /// Cost: O(elements).
    template <level_numbering Numbering, std::unsigned_integral Index>
    [[nodiscard]] part_of_whole next(const connectivity<Index>& part, const Numbering& ids, const column_bases& bases,
                                     bool with_edges = true) const
    {
        return {children(part, ids.vertices, bases, tuple_kind::v),
                with_edges ? children(part, ids.edges, bases, tuple_kind::e) : storage<Number>(),
                children(part, ids.faces, bases, tuple_kind::f),
                Numbering::common_degree != 0 ? storage<Number>() : children(part, ids.faces, bases, tuple_kind::vf),
                Numbering::common_degree};
    }

private:
    template <std::unsigned_integral Index, element_ids Ids>
    [[nodiscard]] storage<Number> children(const connectivity<Index>& part, const Ids& ids, const column_bases& bases,
                                           tuple_kind made) const
    {
        storage<Number> result(ids.total());
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (add_column<Ids::kinds[I]>(part, ids, bases, made, result), ...);
        }(std::make_index_sequence<Ids::size>());
        return result;
    }
    template <tuple_kind Kind, std::unsigned_integral Index, element_ids Ids>
    void add_column(const connectivity<Index>& part, const Ids& ids, const column_bases& bases, tuple_kind made,
                    storage<Number>& result) const
    {
        const whole_column column{Kind, bases.base(made, Kind)};
        const bool of_corners = made == tuple_kind::vf and bases.has_corners_of_face(Kind);
        const tuple_kind of = of_corners ? tuple_kind::vf : numbered_elements(Kind, degree);
        const std::uint64_t of_each = bases.of_each(made, Kind);
        const std::uint64_t step = made == tuple_kind::vf and not of_corners ? bases.degrees[std::size_t(Kind)] : 1;
        const std::size_t tuples = tuples_of_each(Kind, degree);
        const bool some_are_picked = step * tuples != of_each; // equally many of each face
        const storage<Number>& parents = of == tuple_kind::v   ? vertices
                                         : of == tuple_kind::e ? edges
                                         : of == tuple_kind::f ? faces
                                                               : first_corners;
        std::size_t tuple = 0;
        for (std::size_t x = 0; x < parents.size(); ++x) {
            const std::size_t corners = Kind == tuple_kind::f or of != tuple_kind::vf
                                            ? 1
                                            : part.first_corner(x + 1) - part.first_corner(x);
            std::uint64_t picked = 0;
            for (std::size_t which = 0; which < tuples * corners; ++which, ++tuple)
                if (const auto id = ids.template id<Kind>(tuple); id != Ids::none)
                    result[id] = parents[x].child(column, step * (some_are_picked ? picked++ : which), of_each);
        }
    }
};

/// Allocates the faces of the level that some steps of a whole mesh make. Cost: as `connectivity::allocate_faces`.
template <std::unsigned_integral Index>
void allocate_faces(connectivity<Index>& fine, const connectivity<Index>& coarse, std::span<const column_bases> bases)
{
    struct run {
        std::size_t faces;
        std::size_t degree; // 0: those of the coarse faces
    };
    std::vector<run> runs{{coarse.faces, std::size_t(coarse.degree)}};
    for (const column_bases& step : bases) {
        std::vector<std::size_t> kinds;
        for (std::size_t kind = 0; kind < step.faces.size(); ++kind)
            if (step.face_counts[kind] != 0)
                kinds.push_back(kind);
        std::ranges::sort(kinds, {}, [&](std::size_t kind) { return step.faces[kind]; });
        std::vector<run> next;
        for (const std::size_t kind : kinds)
            if (step.degrees[kind] == 0)
                next.insert(next.end(), runs.begin(), runs.end());
            else
                next.push_back({step.face_counts[kind], step.degrees[kind]});
        runs = std::move(next);
    }
    std::size_t count = 0;
    for (const run& r : runs)
        count += r.faces;
    const std::size_t first = runs.empty() ? 0 : runs.front().degree;
    const bool are_alike = (first == 3 or first == 4) and
                           std::ranges::all_of(runs, [&](const run& r) { return r.degree == first; });
    auto at = runs.begin();
    std::size_t face_of_run = 0;
    fine.allocate_faces(count, are_alike ? int(first) : 0, [&](std::size_t) {
        while (face_of_run == at->faces) {
            ++at;
            face_of_run = 0;
        }
        const std::size_t face = face_of_run++;
        return at->degree != 0 ? at->degree : coarse.first_corner(face + 1) - coarse.first_corner(face);
    });
}

} // namespace kith
