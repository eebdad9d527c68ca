// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "closure.hpp"
#include "new_sides.hpp"

#include <kith/schemes/split/triangle_split.hpp>

#include <utility>

namespace kith {

/// The triangle split of some faces of a level with triangles only: red faces are split in four, a green face, which
/// has one cut side, in two. If a pair of green triangles turns red, it is split into the four triangles of the face
/// that it was. The two of these at its middle vertex may be green again. With m the vertex in the middle of side ab:
///
///   green:  (a, m, c) the left one, (m, b, c) the right one; the edge between them runs from m to c
///   corners of the left one    a first_half    m inner       c whole
///   corners of the right one   m second_half   b whole       c inner
///
/// Numbers are those of triangle_split if all faces are red: kept edges come after all others, and kept faces stand in
/// the column of the faces in the middle.
struct red_green_split {
    static constexpr bool makes_polygons = false;

    const closure<red_green_split>* marks;

    [[nodiscard]] auto columns() const
    {
        const auto cut_edge = [marks = marks](const auto& e) { return marks->is_cut(e); };
        const auto kept_edge = [marks = marks](const auto& e) {
            return not(marks->is_cut(e) or (marks->side(e.lcorner()) == side_kind::inner and marks->is_red(e.lface())));
        };
        const auto corner_face = [marks = marks](const auto& c) { return has_face(*marks, c); };
        const auto corner_edge = [marks = marks](const auto& c) { return has_edge(*marks, c); };
        const auto face_face = [marks = marks](const auto& f) { return has_face(*marks, f); };
        return kith::columns(new_vertices(per_vertex, per_edge.only(cut_edge)),
                             new_edges(per_end.only(cut_edge), per_corner.only(corner_edge), per_edge.only(kept_edge)),
                             new_faces(triangles(per_corner.only(corner_face)), triangles(per_face.only(face_face))));
    }

    template <step_context R>
    void connect(const R& r) const
    {
        const auto& assoc = r.assoc;
        const auto& closed = *marks;
        connect_split_faces(r, closed, [&](const auto& f) { return face_split(closed, assoc, f); });
    }

    /// Calls put(new face, k, kind) for each side of the next level that is not whole.
    template <level Level, level_numbering Numbering, class Put>
    static void for_each_part_of_side(const Level& coarse, const Numbering& ids, const closure<red_green_split>& marks,
                                      const Put& put)
    {
        using enum side_kind;
        const auto corner_face = [&](const auto& c) { return ids.faces.template known_id<tuple_kind::vf>(c.index()); };
        for (const auto& c : coarse.corners()) {
            const auto kind = marks.side(c);
            const bool is_red = marks.is_red(c.f());
            if (not is_red and kind != whole) { // a pair stays
                const auto f = c.f();
                put(ids.faces.template known_id<tuple_kind::f>(f.index()), c.index() - f.first_corner().index(), kind);
            } else if (marks.is_cut(c.next_edge()) and (not is_red or kind == first_half)) {
                put(corner_face(c), 0, first_half);
                put(corner_face(c), 1, inner);
                put(corner_face(c.next()), 0, second_half);
                put(corner_face(c.next()), 2, inner);
            } else if (marks.is_cut(c.next_edge()) and kind == second_half) {
                put(corner_face(c), 0, first_half);
                put(corner_face(c), 1, inner);
                put(corner_face(c.next()), 1, inner);
                put(corner_face(c.next()), 2, second_half);
            }
        }
    }

private:
    using marks_type = closure<red_green_split>;

    template <corner_element Corner>
    static bool has_face(const marks_type& marks, const Corner& c)
    {
        using enum side_kind;
        const bool cut_after = marks.is_cut(c.next_edge());
        if (not marks.is_red(c.f()))
            return cut_after or marks.is_cut(c.prev_edge());
        switch (marks.side(c)) {
        case inner: return marks.side(c.prev()) == first_half and marks.is_cut(c.prev_edge());
        case second_half: return cut_after;
        default: return true;
        }
    }
    template <corner_element Corner>
    static bool has_edge(const marks_type& marks, const Corner& c)
    {
        return marks.is_red(c.f()) ? has_face(marks, c) : marks.is_cut(c.next().next_edge());
    }
    /// Returns true for a face that stays, and for a red face, which has a triangle in its middle. In a red pair only
    /// the left triangle has it.
    template <face_element Face>
    static bool has_face(const marks_type& marks, const Face& f)
    {
        for (const auto& c : f.corners()) {
            if (marks.is_red(f) and marks.side(c) == side_kind::second_half)
                return false;
            if (not marks.is_red(f) and marks.is_cut(c.next_edge()))
                return false;
        }
        return true;
    }

    /// The split of one face.
    template <mask_evaluator Assoc, face_element Face>
    class face_split : new_sides<Assoc> {
        using corner_type = decltype(std::declval<const Face&>().first_corner());
        static constexpr targets::to_vertex V{};
        static constexpr targets::to_edge E{};
        static constexpr targets::to_face F{};
        using new_sides<Assoc>::assoc_, new_sides<Assoc>::kept, new_sides<Assoc>::start, new_sides<Assoc>::end;

    public:
        face_split(const marks_type& marks, const Assoc& assoc, const Face& f)
            : new_sides<Assoc>(assoc), marks_(marks), f_(f)
        {
        }

        void make_all() const
        {
            if (is_one_of_pair() and marks_.is_red(f_))
                make_red_half();
            else if (marks_.is_red(f_))
                make_red();
            else if (has_cut_side())
                make_green();
            else
                assoc_(f_, F) = polygon(f_.corners(), [this](const auto& c) { return along(c); });
        }

        /// Returns the start of the new half-edge that leaves the vertex of a corner along its side: the corner in
        /// which it starts, and its side. If that side lay between a pair and has gone, it is the next half-edge
        /// counter-clockwise.
        [[nodiscard]] auto leaving(const corner_type& c) const
        {
            if (not marks_.is_red(f_)) {
                if (cut(c))
                    return std::pair(assoc_(c, F).corner(0), start(c));
                if (cut(c.prev()))
                    return std::pair(assoc_(c, F).corner(1), kept(c));
                if (cut(c.next()))
                    return std::pair(assoc_(c.next(), F).corner(2), kept(c));
                return std::pair(assoc_(f_, F).corner(c.index() - f_.first_corner().index()), kept(c));
            }
            switch (kind(c)) {
            case side_kind::whole: break;
            case side_kind::first_half: return std::pair(assoc_(c, F).corner(0), cut(c) ? start(c) : kept(c));
            case side_kind::second_half:
                return cut(c) ? std::pair(assoc_(c, F).corner(0), start(c))
                              : std::pair(assoc_(c.next(), F).corner(2), kept(c));
            case side_kind::inner:
                if (is_left(c))
                    return std::pair(assoc_(f_, F).corner(0), assoc_(c.across().prev(), E).right());
                return leaving_apex(c.across().next());
            }
            return std::pair(assoc_(c, F).corner(0), start(c));
        }
        /// Returns the same for the vertex in the middle of the side: the first half-edge that leaves it,
        /// counter-clockwise from the end of the side.
        [[nodiscard]] auto leaving_middle(const corner_type& c) const
        {
            return std::pair(assoc_(c, F).corner(1), middle_side(c));
        }

    private:
        void make_red() const
        {
            for (const auto& c : f_.corners())
                assoc_(c, F) = polygon(first(c), middle(c) >> assoc_(c, E).left(), second(c.prev()));
            assoc_(f_, F) = polygon(f_.corners(), [this](auto c) { return middle(c.prev()) >> assoc_(c, E).right(); });
        }
        void make_green() const
        {
            const auto a = corner_where([this](const auto& c) { return cut(c); });
            const auto b = a.next(), c = b.next();
            assoc_(a, F) = polygon(first(a), middle(a) >> assoc_(c, E).left(), along(c));
            assoc_(b, F) = polygon(second(a), along(b), assoc_(c.v(), V) >> assoc_(c, E).right());
        }
        /// Makes the new faces in one triangle of a red pair. The left triangle also makes the new faces that lie in
        /// both.
        void make_red_half() const
        {
            const auto inner = inner_corner();
            if (is_left(inner)) {
                const auto m = inner, c = m.next(), a = c.next();
                const auto across = m.across(); // the corner at c in the right triangle
                const auto b = across.prev();
                if (cut(a)) {
                    assoc_(a, F) = polygon(first(a), middle(a) >> assoc_(m, E).left(), second(c));
                    assoc_(m, F) = polygon(
                        second(a), assoc_(m.v(), V) >> assoc_(a, E).left(), middle(c) >> assoc_(m, E).right());
                } else {
                    assoc_(a, F) = polygon(along(a), assoc_(m.v(), V) >> assoc_(a, E).left(), second(c));
                }
                assoc_(c, F) = polygon(first(c), middle(c) >> assoc_(c, E).left(), second(b));
                assoc_(f_, F) = polygon(assoc_(m.v(), V) >> assoc_(b, E).right(),
                                        middle(b) >> assoc_(c, E).right(),
                                        middle(c) >> assoc_(a, E).right());
            } else {
                const auto c = inner, m = c.next(), b = m.next();
                if (cut(m)) {
                    assoc_(m,
                           F) = polygon(first(m), middle(m) >> assoc_(m, E).left(), middle(b) >> assoc_(b, E).left());
                    assoc_(b, F) = polygon(first(b), middle(b) >> assoc_(m, E).right(), second(m));
                } else {
                    assoc_(b, F) = polygon(first(b), middle(b) >> assoc_(b, E).left(), along(m));
                }
            }
        }

        [[nodiscard]] auto middle_side(const corner_type& c) const
        {
            if (not marks_.is_red(f_))
                return assoc_(c.prev(), E).left();
            if (kind(c.prev()) == side_kind::second_half and cut(c.prev()))
                return assoc_(c.prev(), E).right();
            return assoc_(kind(c) == side_kind::first_half ? c.next() : c, E).left();
        }

        [[nodiscard]] bool is_one_of_pair() const
        {
            return has([this](const auto& c) { return kind(c) == side_kind::inner; });
        }
        [[nodiscard]] bool has_cut_side() const
        {
            return has([this](const auto& c) { return cut(c); });
        }

        /// Returns the line from a corner along its kept side. `first` and `second` return the lines along the halves
        /// of a cut side.
        [[nodiscard]] auto along(const corner_type& c) const { return assoc_(c.v(), V) >> kept(c); }
        [[nodiscard]] auto first(const corner_type& c) const { return assoc_(c.v(), V) >> start(c); }
        [[nodiscard]] auto second(const corner_type& c) const { return assoc_(c.next_edge(), V) >> end(c); }

        [[nodiscard]] side_kind kind(const corner_type& c) const { return marks_.side(c); }
        [[nodiscard]] bool cut(const corner_type& c) const { return marks_.is_cut(c.next_edge()); }
        [[nodiscard]] bool is_left(const corner_type& inner) const
        {
            return kind(inner.prev()) == side_kind::first_half;
        }
        template <class Is>
        [[nodiscard]] bool has(const Is& is) const
        {
            const auto c = f_.first_corner();
            return is(c) or is(c.next()) or is(c.prev());
        }
        template <class Is>
        [[nodiscard]] corner_type corner_where(const Is& is) const
        {
            const auto c = f_.first_corner();
            return is(c) ? c : is(c.next()) ? c.next() : c.prev();
        }
        [[nodiscard]] corner_type inner_corner() const
        {
            return corner_where([this](const auto& c) { return kind(c) == side_kind::inner; });
        }
        [[nodiscard]] auto middle(const corner_type& c) const { return assoc_(c.next_edge(), V); }
        [[nodiscard]] auto leaving_apex(const corner_type& apex) const
        {
            return std::pair(assoc_(apex, F).corner(0), start(apex));
        }

        const marks_type& marks_;
        Face f_;
    };
    template <mask_evaluator Assoc, face_element Face>
    face_split(const marks_type&, const Assoc&, const Face&) -> face_split<Assoc, Face>;
};

} // namespace kith
