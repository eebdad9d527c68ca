// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "closure.hpp"
#include "new_sides.hpp"

#include <kith/schemes/split/quad_split.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// The quad split of some faces of a level. Red faces are split into a quad per corner. In a green face the vertices on
/// its cut sides become corners, at most one on each side. So a green face is a polygon: one of n sides has n + 1 to 2n
/// - 2 corners, a quad 5 or 6. If a green face turns red, its own corners give birth to the quads. The vertices on its
/// sides serve as the middles of sides. A quad at a half of a side that is cut in the same step is green at once. In a
/// green face with the vertex m on side ab the kinds of side are:
///
///   a first_half    m second_half    all others whole
///
/// Numbers are those of quad_split if all faces are red: kept edges and those from the corners on sides come after all
/// others.
struct polygon_closure_split {
    static constexpr bool makes_polygons = true;

    const closure<polygon_closure_split>* marks;

    [[nodiscard]] auto columns() const
    {
        const auto cut_edge = [marks = marks](const auto& e) { return marks->is_cut(e); };
        const auto kept_edge = [marks = marks](const auto& e) { return not marks->is_cut(e); };
        const auto red_face = [marks = marks](const auto& f) { return marks->is_red(f); };
        const auto green_face = [marks = marks](const auto& f) { return not marks->is_red(f); };
        const auto red_side = [marks = marks](const auto& c) {
            return marks->is_red(c.f()) and marks->side(c) == side_kind::whole;
        };
        const auto red_middle = [marks = marks](const auto& c) {
            return marks->is_red(c.f()) and marks->lies_on_side(c);
        };
        const auto red_corner = [marks = marks](const auto& c) {
            return marks->is_red(c.f()) and not marks->lies_on_side(c);
        };
        const auto corners_of_quad = [marks = marks](const auto& c) {
            return std::size_t(4) + is_cut_half(*marks, c) + is_cut_half(*marks, c.prev());
        };
        const auto corners_of_green = [marks = marks](const auto& f) {
            std::size_t result = f.degree();
            for (const auto& c : f.corners())
                result += marks->is_cut(c.next_edge());
            return result;
        };
        return kith::columns(
            new_vertices(per_vertex, per_edge.only(cut_edge), per_face.only(red_face)),
            new_edges(
                per_end.only(cut_edge), per_side.only(red_side), per_edge.only(kept_edge), per_corner.only(red_middle)),
            new_faces(per_corner.only(red_corner).of_degree(corners_of_quad),
                      per_face.only(green_face).of_degree(corners_of_green)));
    }

    /// Returns true if the face has corners on its sides.
    template <face_element Face>
    static bool is_green(const closure<polygon_closure_split>& marks, const Face& f)
    {
        for (const auto& c : f.corners())
            if (marks.lies_on_side(c))
                return true;
        return false;
    }
    /// Returns the vertices of a face without those on its sides.
    template <face_element Face>
    static auto own_vertices(const closure<polygon_closure_split>& marks, const Face& f)
    {
        return f.corners().only([&marks](const auto& c) { return not marks.lies_on_side(c); }).map([](const auto& c) {
            return c.v();
        });
    }

    template <step_context R>
    void connect(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        const auto& closed = *marks;
        connect_split_faces(r, closed, [&](const auto& f) { return face_split(closed, assoc, f); });
        for_each(coarse.faces(), [&](auto f) {
            if (not closed.is_red(f))
                return;
            auto c = f.first_corner();
            if (closed.lies_on_side(c))
                c = c.next();
            assoc(f, V).starts_at(assoc(c, F).corner(2 + std::size_t(is_cut_half(closed, c))),
                                  face_split(closed, assoc, f).spoke(c.prev()).right);
        });
    }

    /// Calls put(new face, k, kind) for each side of the next level that is not whole.
    template <level Level, level_numbering Numbering, class Put>
    static void for_each_part_of_side(const Level& coarse, const Numbering& ids,
                                      const closure<polygon_closure_split>& marks, const Put& put)
    {
        using enum side_kind;
        for (const auto& f : coarse.faces()) {
            std::size_t k = 0;
            for (const auto& c : f.corners()) {
                if (not marks.is_red(f)) {
                    const std::size_t face = ids.faces.template known_id<tuple_kind::f>(f.index());
                    const bool is_cut = marks.is_cut(c.next_edge());
                    if (is_cut or marks.side(c) != whole)
                        put(face, k, is_cut ? first_half : marks.side(c));
                    if (is_cut)
                        put(face, k + 1, second_half);
                    k += is_cut ? 2 : 1;
                } else if (not marks.lies_on_side(c)) {
                    const std::size_t face = ids.faces.template known_id<tuple_kind::vf>(c.index());
                    const std::size_t after = is_cut_half(marks, c), before = is_cut_half(marks, c.prev());
                    if (after != 0)
                        put(face, 0, first_half), put(face, 1, second_half);
                    if (before != 0)
                        put(face, 3 + after, first_half), put(face, 4 + after, second_half);
                }
            }
        }
    }

private:
    using marks_type = closure<polygon_closure_split>;

    /// Returns true if the side from this corner is a half that is cut once more.
    template <corner_element Corner>
    static bool is_cut_half(const marks_type& marks, const Corner& c)
    {
        return marks.side(c) != side_kind::whole and marks.is_cut(c.next_edge());
    }

    /// The split of one face.
    template <mask_evaluator Assoc, face_element Face>
    class face_split : new_sides<Assoc> {
        using line = face_line<typename Assoc::index_type>;
        static constexpr targets::to_vertex V{};
        static constexpr targets::to_edge E{};
        static constexpr targets::to_face F{};
        using new_sides<Assoc>::assoc_, new_sides<Assoc>::kept, new_sides<Assoc>::start, new_sides<Assoc>::end;

        /// The lines of a quad, of which two sides may be cut. They are stored inline: quads are many, and none may
        /// allocate.
        class quad_lines {
        public:
            void push_back(const line& more) { lines_[size_++] = more; }
            [[nodiscard]] const line* begin() const { return lines_.data(); }
            [[nodiscard]] const line* end() const { return lines_.data() + size_; }

        private:
            std::array<line, 6> lines_;
            std::size_t size_ = 0;
        };
        /// The sides of a new edge, whichever tuple gave birth to it.
        struct sides {
            new_side<typename Assoc::index_type> left, right;
        };

    public:
        face_split(const marks_type& marks, const Assoc& assoc, const Face& f)
            : new_sides<Assoc>(assoc), marks_(marks), f_(f)
        {
        }

        void make_all() const
        {
            if (not marks_.is_red(f_))
                make_green();
            else
                for (const auto& c : f_.corners())
                    if (not marks_.lies_on_side(c))
                        make_quad(c);
        }

        /// Returns the start of the new half-edge that leaves the vertex of a corner along its side: the corner in
        /// which it starts, and its side.
        template <corner_element Corner>
        [[nodiscard]] auto leaving(const Corner& c) const
        {
            const auto side = cut(c) ? start(c) : kept(c);
            if (not marks_.is_red(c.f()))
                return std::pair(assoc_(c.f(), F).corner(place_in_green(c)), side);
            if (marks_.lies_on_side(c)) // the side is the last of the next corner's quad
                return std::pair(assoc_(c.next(), F).corner(3 + std::size_t(is_cut_half(marks_, c.next()))), side);
            return std::pair(assoc_(c, F).corner(0), side);
        }
        /// Returns the same for the vertex in the middle of the side. In a red face with a whole side the half-edge
        /// runs along the edge to the centre, otherwise along the second half of the side.
        template <corner_element Corner>
        [[nodiscard]] auto leaving_middle(const Corner& c) const
        {
            if (not marks_.is_red(c.f()))
                return std::pair(assoc_(c.f(), F).corner(place_in_green(c) + 1), end(c));
            if (marks_.lies_on_side(c))
                return std::pair(assoc_(c.next(), F).corner(4 + std::size_t(is_cut_half(marks_, c.next()))), end(c));
            if (marks_.side(c) == side_kind::whole)
                return std::pair(assoc_(c, F).corner(1), spoke(c).left);
            return std::pair(assoc_(c, F).corner(1), end(c));
        }
        /// Returns the edge from the middle of the side to the centre of a red face. The corner is that of the whole
        /// side, or one of the two from which its halves start.
        template <corner_element Corner>
        [[nodiscard]] sides spoke(const Corner& c) const
        {
            if (marks_.side(c) == side_kind::whole)
                return {assoc_(c.next_edge(), c.f(), E).left(), assoc_(c.next_edge(), c.f(), E).right()};
            const auto middle = marks_.lies_on_side(c) ? c : c.next();
            return {assoc_(middle, E).left(), assoc_(middle, E).right()};
        }

    private:
        void make_green() const
        {
            if (not has_cut_side()) {
                assoc_(f_, F) = polygon(f_.corners(), [this](const auto& c) { return assoc_(c.v(), V) >> kept(c); });
                return;
            }
            std::vector<line> lines;
            for (const auto& c : f_.corners())
                append(lines, c);
            assoc_(f_, F) = lines;
        }
        /// Makes the quad of a corner, green if halves are cut. It runs from the corner along its side to the middle,
        /// to the centre, to the middle of the side before and back.
        template <corner_element Corner>
        void make_quad(const Corner& c) const
        {
            quad_lines lines;
            if (marks_.side(c) == side_kind::whole) {
                lines.push_back(assoc_(c.v(), V) >> start(c));
                lines.push_back(assoc_(c.next_edge(), V) >> spoke(c).left);
            } else {
                append(lines, c);
                lines.push_back(assoc_(c.next().v(), V) >> spoke(c).left);
            }
            const auto before = c.prev();
            lines.push_back(assoc_(c.f(), V) >> spoke(before).right);
            if (marks_.side(before) == side_kind::whole)
                lines.push_back(assoc_(before.next_edge(), V) >> end(before));
            else
                append(lines, before);
            assoc_(c, F) = lines;
        }

        [[nodiscard]] bool cut(const auto& c) const { return marks_.is_cut(c.next_edge()); }
        [[nodiscard]] bool has_cut_side() const
        {
            for (const auto& c : f_.corners())
                if (cut(c))
                    return true;
            return false;
        }
        /// Appends the lines along a side, from a corner to before the next one.
        void append(auto& lines, const auto& c) const
        {
            lines.push_back(assoc_(c.v(), V) >> (cut(c) ? start(c) : kept(c)));
            if (cut(c))
                lines.push_back(assoc_(c.next_edge(), V) >> end(c));
        }
        [[nodiscard]] std::size_t place_in_green(const auto& corner) const
        {
            std::size_t place = 0;
            for (auto c = corner.f().first_corner(); not(c == corner); c = c.next())
                place += cut(c) ? 2 : 1;
            return place;
        }

        const marks_type& marks_;
        Face f_;
    };
    template <mask_evaluator Assoc, face_element Face>
    face_split(const marks_type&, const Assoc&, const Face&) -> face_split<Assoc, Face>;
};

} // namespace kith
