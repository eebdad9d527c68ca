// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "canonical_part.hpp"
#include "parametric_scheme.hpp"
#include "surface_place.hpp"

#include <kith/limit/limit.hpp>
#include <kith/mask/stencil.hpp>
#include <kith/spline/bicubic_net.hpp>
#include <kith/spline/box_net.hpp>
#include <kith/spline/linear_net.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// The shapes of the parts of a mesh around its faces, and of those around the faces that steps make of them. Parts of
/// one shape have the same polynomials. The scheme's own text refines a part of each shape once, with rows of weights
/// for points, until the surface over its face is a polynomial.
template <std::unsigned_integral Index, parametric_scheme Scheme>
class surface_shapes {
    using mesh_type = basic_mesh<stencil_row, Index>;

public:
    using polynomial_pointer = std::unique_ptr<const surface_polynomial>;

    /// The neighbourhood of a face. If the surface there is no polynomial, its children are shapes again, whose control
    /// points are weighted sums of its own.
    struct shape {
        struct child {
            shape* of;
            subdivision_matrix rows;
        };

        shape(mesh_type m, Scheme s, Index f)
            : vertices(m.vertex_count()), mesh(std::move(m)), scheme(std::move(s)), face(f)
        {
        }

        std::size_t vertices;                           ///< its control points
        polynomial_pointer polynomial{};                ///< if the surface over the face is one
        std::vector<child> children{};                  ///< otherwise; by corners, in the middle comes last
        std::array<polynomial_pointer, 4> at_corners{}; ///< the limits of corners that have been asked for
        polynomial_pointer last{};                      ///< a control point
        bool is_seen = false;

        mesh_type mesh; ///< with unit rows for points
        Scheme scheme;
        Index face;
    };

    explicit surface_shapes(const Scheme& scheme) : rings_(rings_of_surface(scheme)) {}

    /// Returns the shape of a part, and for each of its control points the vertex of the part.
    std::pair<shape*, std::vector<Index>> of_part(const connectivity<Index>& part, int generation, const Scheme& scheme,
                                                  Index face)
    {
        auto canonical = make_canonical(part, scheme, face);
        const auto add = [&] {
            shapes_.push_back(std::make_unique<shape>(
                mesh_of_units(std::move(canonical.mesh), generation), std::move(canonical.scheme), canonical.face));
            return shapes_.back().get();
        };
        if (canonical.key.empty())
            return {add(), std::move(canonical.vertex_from)};
        shape*& known = by_key_[canonical.key];
        if (known == nullptr)
            known = add();
        return {known, std::move(canonical.vertex_from)};
    }

    /// Follows a place down to the piece of the surface that it lies in: calls descend(k) for each child on the way.
    /// Returns the polynomial over the control points of the last shape. `corner` is the sub-face of the place if the
    /// face is a polygon, and `at` becomes the parameters in the piece.
    /// Cost: O(depth); a shape that is met for the first time costs a step.
    template <class Descend>
    const surface_polynomial* find(shape& root, std::size_t corner, face_parameters& at, const Descend& descend)
    {
        shape* here = &root;
        for (int depth = 0;; ++depth) {
            look(*here);
            if (here->polynomial)
                return here->polynomial.get();
            if (const auto* limit = limit_of_corner(*here, at)) {
                at = {0, 0};
                return limit;
            }
            if (depth == most_steps)
                return here->last.get();
            const std::size_t k = next_child(here->children.size(), corner, at);
            descend(k);
            here = here->children[k].of;
        }
    }

private:
    static constexpr std::size_t degree = has_quad_parameters<Scheme> ? 4 : 3;
    // Nets shrink by .66 or less in a step, so that after 100 steps they are points but for rounding.
    static constexpr int most_steps = 100;

    /// A face that a step makes, and what lies around it, with rows over the control points of a shape for points.
    struct made_face {
        mesh_type mesh;
        Scheme scheme;
        Index face;
    };

    static mesh_type mesh_of_units(connectivity<Index> topology, int generation)
    {
        const auto units = unit_rows(topology.vertices);
        return {storage<stencil_row>(units), std::move(topology), generation};
    }
    /// Returns the control net of a face. `inputs` is the number of entries of the rows of the mesh.
    template <class Net>
    static std::optional<Net> net_of(const mesh_type& mesh, const Scheme& scheme, Index face, std::size_t inputs)
    {
        const std::span<const stencil_row> rows(mesh.points());
        return Net::around(
            rows_of_part<Index>{mesh.topology(), rows, inputs, [&](Index e) { return is_sharp(scheme, e); }}, face);
    }

    /// Finds out whether the surface over the face of a shape is a polynomial, and else makes its children.
    void look(shape& here)
    {
        if (here.is_seen)
            return;
        here.last = constant(dense({{{here.mesh.face(here.face)[0], 1.}}}, here.vertices), 0);
        const auto made = split(here);
        if (goes_on_alike(here)) {
            if constexpr (degree == 4)
                here.polynomial = polynomial_of_any<bicubic_net, linear_net<4>>(here, made);
            else
                here.polynomial = polynomial_of_any<box_net, linear_net<3>>(here, made);
        }
        if (not here.polynomial)
            for (const made_face& one : made) {
                auto [child, vertex_from] = of_part(one.mesh.topology(), one.mesh.generation(), one.scheme, one.face);
                std::vector<stencil_row> rows;
                for (const Index v : vertex_from)
                    rows.push_back(one.mesh.point(v));
                here.children.push_back({child, make_matrix(rows, here.vertices)});
            }
        here.is_seen = true;
    }
    /// Returns true if the same happens on the levels to come: the face is as refined ones are, and the state settled.
    static bool goes_on_alike(const shape& here)
    {
        return here.mesh.face(here.face).size() == degree and is_settled(here.scheme);
    }
    /// Returns the polynomial of the first kind of net that the scheme subdivides as splines are subdivided. The scheme
    /// then does so on all levels, since the children look like the shape.
    template <class... Nets>
    static polynomial_pointer polynomial_of_any(const shape& here, std::span<const made_face> made)
    {
        polynomial_pointer result;
        ((result = result ? std::move(result) : polynomial_of_net<Nets>(here, made)), ...);
        return result;
    }
    template <class Net>
    static polynomial_pointer polynomial_of_net(const shape& here, std::span<const made_face> made)
    {
        const auto net = net_of<Net>(here.mesh, here.scheme, here.face, here.vertices);
        if (not net)
            return {};
        for (std::size_t k = 0; k < made.size(); ++k) {
            const auto child = net_of<Net>(made[k].mesh, made[k].scheme, made[k].face, here.vertices);
            if (not child or not are_equal(child->points(), net->child(k).points()))
                return {};
        }
        return std::make_unique<const surface_polynomial>(net->polynomial());
    }

    /// Returns the faces that a step makes of the face of a shape.
    [[nodiscard]] std::vector<made_face> split(const shape& here) const
    {
        numbering_of<Scheme, Index> ids;
        const auto fine = refine_mesh<connect::everything>(here.mesh, here.scheme, ids);
        Scheme scheme = here.scheme;
        advance(scheme, level_of<mesh_type>(here.mesh), here.mesh.generation(), ids, fine);
        submesh_cutter<stencil_row, Index> cutter(fine);
        std::vector<made_face> result;
        const auto add = [&](std::size_t face) {
            const std::array<Index, 1> seed{Index(face)};
            auto part = cutter.cut(cutter.faces_around(seed, rings_));
            Scheme of_part = scheme;
            take_part(of_part, scheme, part.numbers());
            const auto place = std::ranges::lower_bound(part.face_from, Index(face)) - part.face_from.begin();
            result.push_back({std::move(part.mesh), std::move(of_part), Index(place)});
        };
        const std::size_t first = here.mesh.topology().first_corner(here.face);
        for (std::size_t k = 0; k < here.mesh.face(here.face).size(); ++k)
            add(ids.faces.template id<tuple_kind::vf>(first + k));
        if constexpr (degree == 3)
            add(ids.faces.template id<tuple_kind::f>(here.face));
        return result;
    }
    /// Returns the child that a place lies in. `corner` is that of the place in the control mesh.
    static std::size_t next_child(std::size_t children, std::size_t corner, face_parameters& at)
    {
        if constexpr (degree == 3)
            return descend_in_triangle(at);
        else
            return children == 4 ? descend_in_quad(at) : corner;
    }

    /// Returns the limit of a corner of the face, and tangents there, if a place is at that corner, the corner is
    /// irregular, and there are closed masks. At a regular corner the child is a polynomial, which has derivatives.
    const surface_polynomial* limit_of_corner(shape& here, const face_parameters& at)
    {
        constexpr std::array<std::array<double, 2>, 4> of_quad{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        constexpr std::array<std::array<double, 2>, 3> of_triangle{{{0, 0}, {1, 0}, {0, 1}}};
        if (not goes_on_alike(here))
            return nullptr;
        for (std::size_t k = 0; k < degree; ++k) {
            if ((degree == 4 ? of_quad[k] : of_triangle[k % 3]) != std::array{at.s, at.t})
                continue;
            shape& child = *here.children[k].of;
            look(child);
            if (not child.polynomial and not here.at_corners[k])
                here.at_corners[k] = limit_by_masks(here, here.mesh.face(here.face)[k]);
            return here.at_corners[k].get();
        }
        return nullptr;
    }
    /// Returns the limit of a vertex by closed masks; nothing if there is none.
    static polynomial_pointer limit_by_masks(const shape& here, Index vertex_number)
    {
        const auto coefficients = with_native_level<Scheme>(here.mesh, [&](const auto& level) {
            return position_and_tangents(level.vertices()[vertex_number], level, here);
        });
        if (coefficients.empty())
            return {};
        if (coefficients.size() == 1)
            return constant(coefficients[0], 0);
        auto made = polynomial_of(1, false, coefficients);
        made.derivatives = 1;
        return std::make_unique<const surface_polynomial>(std::move(made));
    }
    /// Returns the rows of the position, and of the second and the first tangent, as far as there are masks.
    template <level Level>
    static std::vector<control_row> position_and_tangents(const vertex<Level>& v, const Level& level, const shape& here)
    {
        [[maybe_unused]] const auto& rules = limit_rules<Scheme>::on(here.scheme, level);
        [[maybe_unused]] const auto value = [&](const auto& mask) {
            return dense(affine<stencil_row>::store(mask.evaluate(point_values<Level>())), here.vertices);
        };
        std::vector<control_row> result;
        if constexpr (has_limit_positions<Scheme, vertex<Level>, Level>)
            limit_rules<Scheme>::position(rules, v, [&](const auto& mask) { result.assign(1, value(mask)); });
        if constexpr (has_limit_tangents<Scheme, vertex<Level>, Level>)
            if (not result.empty())
                limit_rules<Scheme>::tangents(rules, v, [&](const auto& first, const auto& second) {
                    const auto a = value(first), b = value(second);
                    if (are_finite(a) and are_finite(b)) { // not at a vertex of two edges
                        result.push_back(b);
                        result.push_back(a);
                    }
                });
        return result;
    }
    static bool are_finite(const control_row& row)
    {
        return std::ranges::all_of(row, [](double weight) { return std::isfinite(weight); });
    }
    static polynomial_pointer constant(const control_row& row, int derivatives)
    {
        auto made = polynomial_of(0, false, std::array{row});
        made.derivatives = derivatives;
        return std::make_unique<const surface_polynomial>(std::move(made));
    }

    int rings_;
    std::vector<std::unique_ptr<shape>> shapes_;
    std::unordered_map<std::u32string, shape*> by_key_;
};

} // namespace detail

} // namespace kith
