// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_surface_order.hpp"

#include <kith/patch/face_classes.hpp>
#include <kith/patch/patch_filler.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// New faces come from faces and corners: then each face has its own descendants.
template <class... Columns>
constexpr bool faces_come_from_faces(const std::tuple<Columns...>*)
{
    return ((Columns::kind == tuple_kind::f or Columns::kind == tuple_kind::vf or Columns::kind == tuple_kind::ef or
             Columns::kind == tuple_kind::vfe) and
            ...);
}

template <scheme Scheme>
inline constexpr bool has_patches = faces_come_from_faces(
    static_cast<const decltype(columns_of(std::declval<const Scheme&>(), 0).faces.list)*>(nullptr));

} // namespace detail

/// A scheme whose last steps may be made patch by patch: its numbers follow from the tuples in one way everywhere, and its
/// reach is known.
template <class Scheme, class Point, class Index>
concept patchable_scheme = fits_lanes<Point> and reaching_scheme<Scheme> and orderable_scheme<Scheme, Index> and
                           detail::has_patches<Scheme>;

/// When patches are worth while: what a final face costs in each of the ways to make it, level by level being 1.
struct patch_costs {
    double in_patch = .4;
    double among_few = 3;           ///< of few faces with their rings, where making a template is not worth it
    double of_template = 4000;      ///< of making one, in final faces
    double of_walk = 40;            ///< of walking around a face of the first level to find its class
    double share_of_walks = .05;    ///< nobody looks where all walks cost more than this share of the whole
    double to_be_cheaper = .9;      ///< patches must come to less than so much
    std::size_t least_faces = 8192; ///< of the level whose faces own patches; for fewer nobody looks
};

#ifdef KITH_HAS_LANES

/// The last steps of a refinement to face-vertex lists, face by face: a face of the level before them owns a patch of the last
/// level. Faces with alike neighbourhoods share a template, which is replayed in SIMD lanes; the few others are refined as
/// meshes of their own. The numbers and the bits are those of refining level by level.
template <class Point, std::unsigned_integral Index, scheme Scheme>
    requires patchable_scheme<Scheme, Point, Index>
class patch_refinement {
public:
    /// `levels` steps from a control mesh that has its edges. Cost: O(1).
    patch_refinement(const basic_mesh<Point, Index>& control, const Scheme& scheme, int levels,
                     const patch_costs& costs = {})
        : scheme_(scheme)
        , costs_(costs)
        , levels_(levels)
        , generation_(control.generation())
        , counts_(count(control.topology()))
    {
        const bool closed = counts_.boundary_edges == 0;
        if (not detail::is_free_of_order<Scheme>(closed) or not ignores_numbers(scheme) or levels < 1)
            return;
        const auto planned = plan(counts_, scheme, levels, generation_, sizeof(Point), sizeof(Index));
        first_ = control.topology().degree == int(degree) ? 0 : 1;
        const auto faces = [&](int level) { return planned[std::size_t(level)].counts.faces; };
        begin_ = levels;
        while (begin_ > first_ and faces(levels) / faces(begin_ - 1) <= most_faces_of_patch)
            --begin_;
        worth_looking_ = has_lanes() and begin_ < levels and faces(begin_) >= costs.least_faces and
                         costs.of_walk * double(faces(first_)) <= costs.share_of_walks * double(faces(levels));
        for (int level = 0; level < levels; ++level)
            counts_of_level_.push_back(planned[std::size_t(level)].counts);
        last_ = planned.back().counts;
    }

    /// Whether there are so many faces that it may be worth while.
    [[nodiscard]] bool is_worth_looking() const { return worth_looking_; }

    /// What refining level by level makes with connect::faces, to the bit. Precondition: is_worth_looking().
    [[nodiscard]] basic_mesh<Point, Index> refine(basic_mesh<Point, Index> mesh)
    {
        face_classes<Index> classes(rings());
        numbering_of<Scheme, Index> ids;
        Scheme scheme = scheme_;
        const auto step = [&](int level) {
            auto fine = refine_mesh<connect::everything>(mesh, scheme, ids);
            if (level >= first_)
                classes.follow(ids, degree, fine.topology());
            mesh = std::move(fine);
        };
        for (int level = 0; level < begin_; ++level) {
            if (level == first_)
                classes.look_at(mesh.topology());
            step(level);
        }
        if (begin_ == first_)
            classes.look_at(mesh.topology());
        if (auto result = in_patches(mesh, classes))
            return std::move(*result);
        for (int level = begin_; level + 1 < levels_; ++level)
            mesh = refine_mesh<connect::everything>(mesh, scheme, ids);
        return refine_mesh<connect::faces>(mesh, scheme, ids);
    }

private:
    using numbering = numbering_of<Scheme, Index>;
    using class_number = typename face_classes<Index>::number;
    using patch = patch_template<scalar_of<Point>, Index>;

    static constexpr std::size_t degree = numbering::common_degree;
    static constexpr std::size_t most_faces_of_patch = 100;

    /// Rings by which a class says all of the patch and of the classes of the next level.
    [[nodiscard]] int rings() const
    {
        int result = rings_before_steps(scheme_, std::size_t(levels_ - begin_)).front();
        while (reach_of(scheme_, result) > result)
            result = reach_of(scheme_, result);
        return result;
    }

    [[nodiscard]] std::optional<basic_mesh<Point, Index>> in_patches(const basic_mesh<Point, Index>& mesh,
                                                                     const face_classes<Index>& classes)
    {
        const auto& of_face = classes.of_faces();
        std::vector<std::size_t> members(classes.count(), 0);
        for (const class_number c : of_face)
            if (c != classes.unlike)
                ++members[c];
        const double faces_of_patch = double(last_.faces) / double(mesh.face_count());
        const auto gains = [&](std::size_t count) {
            return double(count) * faces_of_patch * (costs_.among_few - costs_.in_patch) > costs_.of_template;
        };
        double cost = 0;
        std::size_t in_templates = 0;
        for (const std::size_t count : members)
            if (gains(count)) {
                cost += costs_.of_template + double(count) * faces_of_patch * costs_.in_patch;
                in_templates += count;
            }
        cost += double(mesh.face_count() - in_templates) * faces_of_patch * costs_.among_few;
        if (cost > costs_.to_be_cheaper * double(last_.faces))
            return {};

        std::vector<column_bases> bases;
        for (int level = begin_; level < levels_; ++level)
            bases.push_back(bases_of_columns(scheme_, counts_of_level_[std::size_t(level)], generation_ + level));
        std::vector<std::optional<patch>> templates(classes.count());
        {
            template_maker<Scheme, Point, Index> maker(mesh, scheme_, bases);
            face_walk<Index> walk(mesh.topology(), classes.rings());
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                if (const class_number c = of_face[f]; c != classes.unlike and gains(members[c])) {
                    walk.around(f);
                    templates[c] = maker.make(walk);
                    members[c] = 0; // once
                }
        }

        using filler = patch_filler<Point, Index, degree>;
        storage<Point> points(last_.vertices);
        connectivity<Index> fine;
        fine.vertices = last_.vertices;
        fine.allocate_faces(last_.faces, int(degree), [](std::size_t) { return degree; });
        detail::for_parts(
            mesh.face_count(),
            true,
            [&](std::size_t begin, std::size_t end) {
                filler fill(mesh, points, fine);
                constexpr std::size_t width = filler::width;
                std::vector<Index> waiting(templates.size() * width);
                std::vector<std::uint8_t> count(templates.size(), 0);
                const auto flush = [&](std::size_t c) {
                    fill.fill(*templates[c], std::span(waiting).subspan(c * width, count[c]));
                    count[c] = 0;
                };
                for (std::size_t f = begin; f < end; ++f) {
                    const class_number c = of_face[f];
                    if (c == face_classes<Index>::unlike or not templates[c])
                        continue;
                    waiting[c * width + count[c]++] = Index(f);
                    if (count[c] == width)
                        flush(c);
                }
                for (std::size_t c = 0; c < count.size(); ++c)
                    if (count[c] != 0)
                        flush(c);
            },
            1);
        std::vector<Index> few;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (const class_number c = of_face[f]; c == classes.unlike or not templates[c])
                few.push_back(Index(f));
        refine_few(mesh, few, bases, points, fine);
        return basic_mesh<Point, Index>(std::move(points), std::move(fine), generation_ + levels_);
    }

    /// The patches of some faces, in increasing order, as meshes of their own, level by level.
    void refine_few(const basic_mesh<Point, Index>& mesh, std::span<const Index> few,
                    std::span<const column_bases> bases, storage<Point>& points, connectivity<Index>& to) const
    {
        constexpr std::size_t at_once = 1024;
        if (few.empty())
            return;
        const connectivity<Index>& whole = mesh.topology();
        const std::vector<int> rings = rings_before_steps(scheme_, bases.size());
        submesh_cutter<Point, Index> cutter(mesh);
        std::vector<bool> is_one(mesh.face_count(), false);
        for (; not few.empty(); few = few.subspan(std::min(at_once, few.size()))) {
            const auto here = few.first(std::min(at_once, few.size()));
            for (const Index f : here)
                is_one[f] = true;
            auto part = cutter.cut(cutter.faces_around(here, rings.front()));
            part_of_whole<owned_number<Index>> numbers{{}, {}, {}, degree};
            for (const Index v : part.vertex_from)
                numbers.vertices.push_back({v, is_one[whole.vertex_corner[v] / degree]});
            for (const Index e : part.edge_from)
                numbers.edges.push_back({e, is_one[whole.halfedge_corner[2 * std::size_t(e)] / degree]});
            for (const Index f : part.face_from)
                numbers.faces.push_back({f, is_one[f]});
            for (const Index f : here)
                is_one[f] = false;
            const auto fine = refine_part<numbering>(
                std::move(part.mesh),
                numbers,
                bases,
                rings,
                [](const auto& face) { return face.owned; },
                [&](const auto& level, auto& ids) { return refine_mesh<connect::everything>(level, scheme_, ids); },
                [&](const auto& level, auto& ids) { return refine_mesh<connect::faces>(level, scheme_, ids); });
            copy_owned(fine, numbers, points, to);
        }
    }

    static void copy_owned(const basic_mesh<Point, Index>& part, const part_of_whole<owned_number<Index>>& numbers,
                           storage<Point>& points, connectivity<Index>& to)
    {
        for (std::size_t v = 0; v < numbers.vertices.size(); ++v)
            if (numbers.vertices[v].owned)
                points[numbers.vertices[v].number] = part.point(v);
        for (std::size_t f = 0; f < numbers.faces.size(); ++f) {
            if (not numbers.faces[f].owned)
                continue;
            Index* corner = to.corner_vertex.data() + degree * std::size_t(numbers.faces[f].number);
            for (const Index v : part.face(f))
                *corner++ = numbers.vertices[v].number;
        }
    }

    Scheme scheme_;
    patch_costs costs_;
    int levels_, generation_;
    int first_ = 0, begin_ = 0; // the first level whose faces have one degree; that whose faces own patches
    bool worth_looking_ = false;
    counts counts_, last_;
    std::vector<counts> counts_of_level_;
};

#endif

} // namespace kith
