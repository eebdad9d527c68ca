// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bezier_patch.hpp"
#include "box_tree.hpp"
#include "cell_pieces.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/surface/surface_locator.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::detail {

/// The limit surface of a mesh as cells whose points bound it: each cell lies in the convex hull of its points. Among
/// regular faces these are the Bezier points of a polynomial. Elsewhere they are the control points around the face,
/// and the cell has children, which steps of the scheme make.
template <parametric_scheme Scheme, std::unsigned_integral Index>
class surface_cells {
    using shape = surface_shape<Index, Scheme, as_points>;
    using domain = domain_of<Scheme>;

public:
    using vector = std::array<double, 3>;
    using patch = bezier_patch<domain::is_tensor, domain::degree>;
    using place = cell_place<domain::is_tensor, domain::sides>;

    struct cell;
    using cell_list = std::vector<cell>;

    /// The children of a cell, which are made at the first access. Threads that make them at the same time make the
    /// same ones.
    class kept_children {
    public:
        kept_children() = default;
        kept_children(const kept_children&) = delete;
        kept_children& operator=(const kept_children&) = delete;
        ~kept_children() { delete list_.load(); }

        template <class Make>
        const cell_list& get(const Make& make)
        {
            const cell_list* known = list_.load(std::memory_order_acquire);
            if (known == nullptr) {
                auto made = std::make_unique<const cell_list>(make());
                if (list_.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel))
                    known = made.release();
            }
            return *known;
        }

    private:
        std::atomic<const cell_list*> list_ = nullptr;
    };
    struct cell {
        place at;
        shape* of;                    ///< nullptr for a polynomial
        std::size_t number;           ///< among the cells of the shape
        std::size_t depth;            ///< the number of descents
        std::vector<vector> points{}; ///< Bezier points of a polynomial, or control points
        std::unique_ptr<kept_children> children{};
    };

    /// Takes a mesh and its scheme. Errors: those of `surface_locator`; mesh_error if control points do not bound the
    /// surface. Cost: O(corners), and for each kind of irregular face that of a step.
    template <class Point>
    surface_cells(const basic_mesh<Point, Index>& mesh, const Scheme& scheme) : surface_(mesh, scheme)
    {
        if constexpr (not scheme_of_places<Scheme>)
            refuse();
        for (const Point& p : mesh.points()) {
            const auto& x = affine<Point>::load(p);
            control_.push_back({double(x[0]), double(x[1]), double(x[2])});
        }
        typename surface_locator<Scheme, Index>::search search(surface_.mesh_.topology(), *surface_.shapes_);
        std::vector<std::size_t> inputs;
        std::vector<vector> net;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            if constexpr (not domain::has_polynomials_at_boundaries)
                if (touches_boundary(surface_.mesh_.topology(), f))
                    throw mesh_error("face " + std::to_string(f) + " touches the boundary, where " +
                                     std::string(scheme_name<Scheme>()) +
                                     " has no polynomials; close the mesh or search a tessellation");
            const auto& around = surface_.neighbourhood_of(Index(f));
            inputs.clear();
            search.append_inputs(around, Index(f), inputs);
            net.clear();
            for (const std::size_t v : inputs)
                net.push_back(control_[v]);
            add_roots(f, *around.around, net);
        }
        make_tree();
    }
    surface_cells(const surface_cells&) = delete;
    surface_cells& operator=(const surface_cells&) = delete;

    /// Returns the points of the surface at places.
    [[nodiscard]] storage<vector> points_at(std::span<const surface_place> places)
    {
        return surface_.locate(places).evaluate(std::span<const vector>(control_)).points;
    }
    [[nodiscard]] bool empty() const { return cells_.empty(); }
    /// Returns the middle of a ball that contains the surface.
    [[nodiscard]] const vector& middle() const { return middle_; }
    [[nodiscard]] double radius() const { return radius_; }
    /// Returns a bound of the rounding errors of points of cells.
    [[nodiscard]] double rounding() const { return rounding_; }

    /// Returns the tree of the boxes of the root cells of faces; its items are their numbers.
    [[nodiscard]] const box_tree& tree() const { return tree_; }
    [[nodiscard]] const cell& root(std::size_t number) const { return cells_[number]; }
    /// Returns the children of a cell that is no polynomial. Children that the cell does not keep are added to `made`.
    /// Errors: mesh_error if control points do not bound the surface. Cost: O(control points) for each child.
    [[nodiscard]] const cell_list& children_of(const cell& parent, std::deque<cell_list>& made) const
    {
        if (parent.children)
            return parent.children->get([&] { return make_children(parent); });
        return made.emplace_back(make_children(parent));
    }

private:
    [[noreturn]] static void refuse()
    {
        throw mesh_error("the control points of this scheme do not bound its surface, which is no spline among regular "
                         "faces or has negative weights; search a tessellation instead");
    }
    /// Adds the cells of a face.
    void add_roots(std::size_t f, shape& around, std::span<const vector> net)
    {
        const std::size_t degree = around.in_domain.degree, parts = degree == domain::sides ? 1 : degree;
        for (std::size_t corner = 0; corner < parts; ++corner)
            for (const cell_piece& piece : pieces_of(samples_of_face_, [&](face_parameters& at) -> child_cell {
                     return {0, domain::enter(around.in_domain, corner, at)};
                 }))
                cells_.push_back(make_cell(place{f, corner}.within(piece.origin, piece.along_s, piece.along_t),
                                           around,
                                           piece.of.cell,
                                           0,
                                           net));
    }
    [[nodiscard]] cell make_cell(const place& at, shape& of, std::size_t number, std::size_t depth,
                                 std::span<const vector> net) const
    {
        constexpr std::size_t most_kept = 3;
        surface_.shapes_->look(of);
        if (not of.leads_to_polynomials)
            refuse();
        const surface_polynomial* const polynomial = of.polynomials[number].get();
        if (polynomial == nullptr)
            return {at,
                    &of,
                    number,
                    depth,
                    {net.begin(), net.end()},
                    depth < most_kept ? std::make_unique<kept_children>() : nullptr};
        const auto bezier = patch(*polynomial, product(polynomial->rows, net)).points;
        return {at, nullptr, number, depth, {bezier.begin(), bezier.end()}};
    }
    [[nodiscard]] cell_list make_children(const cell& parent) const
    {
        constexpr double rounding = 1e-12;
        cell_list result;
        for (const cell_piece& piece :
             pieces_of(samples_of_cell_, [&](face_parameters& at) { return descend(*parent.of, parent.number, at); })) {
            const auto& child = parent.of->children[piece.of.child];
            if (std::ranges::any_of(child.rows.weight, [](double weight) { return weight < -rounding; }))
                refuse();
            if (not lies_within(piece, domain::is_tensor))
                throw mesh_error("searches of " + std::string(scheme_name<Scheme>()) + " take faces of " +
                                 std::to_string(domain::sides) +
                                 " vertices only; search the surface of the next level");
            result.push_back(make_cell(parent.at.within(piece.origin, piece.along_s, piece.along_t),
                                       *child.of,
                                       piece.of.cell,
                                       parent.depth + 1,
                                       product(child.rows, parent.points)));
        }
        return result;
    }
    static std::vector<vector> product(const subdivision_matrix& rows, std::span<const vector> points)
    {
        std::vector<vector> result(rows.rows());
        for (std::size_t i = 0; i < result.size(); ++i)
            for (std::size_t k = rows.begin_of_row(i); k < rows.begin_of_row(i + 1); ++k)
                for (std::size_t x = 0; x < 3; ++x)
                    result[i][x] += rows.weight[k] * points[std::size_t(rows.column[k])][x];
        return result;
    }

    /// Makes the tree of the root cells of faces.
    void make_tree()
    {
        std::vector<space_box> boxes;
        for (const cell& c : cells_)
            boxes.push_back(space_box::of(c.points));
        tree_ = box_tree(boxes);
        if (boxes.empty())
            return;
        const auto& [least, most] = tree_.nodes()[0].box;
        double largest = 0;
        for (std::size_t x = 0; x < 3; ++x) {
            middle_[x] = (least[x] + most[x]) / 2;
            largest = std::max({largest, -least[x], most[x]});
        }
        rounding_ = 1e-14 * largest;
        radius_ = length_of(vector_between(least, most)) / 2 + 2 * rounding_;
    }

    surface_locator<Scheme, Index> surface_;
    std::vector<parameters> samples_of_face_ = points_in_pieces(domain::fineness, domain::sides == 4),
                            samples_of_cell_ = points_in_pieces(domain::fineness, domain::is_tensor);
    std::vector<vector> control_;
    std::vector<cell> cells_; // root cells of the faces
    box_tree tree_;
    vector middle_{};
    double radius_ = 0, rounding_ = 0;
};

} // namespace kith::detail
