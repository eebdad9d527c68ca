// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_lattice.hpp"
#include "surface_locator.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/mask/stencil.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace kith::detail {

/// The evaluation of places at the same parameters in many faces of a limit surface. Shared data are made once for all
/// faces that look alike. It uses a locator, which must outlive this object.
template <parametric_scheme Scheme, std::unsigned_integral Index>
class surface_lattices {
public:
    /// A face, or a sub-face of a polygon, and the number of a list of parameters.
    struct request {
        std::size_t face, corner, list;
    };

    explicit surface_lattices(surface_locator<Scheme, Index>& surface) : surface_(&surface) {}

    /// Calls body(r, lattice) for each request, on threads, in no order. The face_lattice has the parameters
    /// parameters_of(list) and the control points around the face. `places` is about the number of places. Errors:
    /// mesh_error for faces for which the scheme has no parameters.
    template <bool HasNormals, affine_value T, class ParametersOf, class Body>
    void for_each(std::span<const request> requests, std::span<const T> control, std::size_t places,
                  const ParametersOf& parameters_of, const Body& body)
    {
        const std::vector<key> order = sorted(requests);
        const bool is_parallel = is_worth_threads(places) and most_threads() > 1;
        struct part {
            std::size_t begin, end, alike; // `alike` requests have the same lattice
        };
        std::vector<part> parts;
        for (std::size_t begin = 0; begin < order.size();) {
            const auto is_alike = [&](const key& other) { return order[begin].is_alike(other); };
            const std::size_t end = std::size_t(
                std::find_if_not(order.begin() + std::ptrdiff_t(begin), order.end(), is_alike) - order.begin());
            const std::size_t most = is_parallel ? 256 : end - begin;
            for (std::size_t first = begin; first < end; first += most)
                parts.push_back({first, std::min(first + most, end), end - begin});
            begin = end;
        }
        for_shared_parts(parts.size(), is_parallel ? 8 : parts.size(), is_parallel, [&](auto&& work) {
            typename locator::search search(surface_->mesh_.topology(), *surface_->shapes_);
            std::vector<std::size_t> inputs;
            work.for_each([&](std::size_t begin, std::size_t end) {
                for (; begin < end; ++begin) {
                    const part& some = parts[begin];
                    const request& first = requests[order[some.begin].request];
                    face_lattice<HasNormals> lattice(
                        search, *order[some.begin].of, order[some.begin].corner, parameters_of(first.list), some.alike);
                    for (std::size_t i = some.begin; i < some.end; ++i) {
                        inputs.clear();
                        search.append_inputs(*order[i].around, Index(requests[order[i].request].face), inputs);
                        lattice.move_to(order[i].rows, [&](std::size_t input) -> std::array<double, 3> {
                            const auto& point = affine<T>::load(control[inputs[input]]);
                            return {double(point[0]), double(point[1]), double(point[2])};
                        });
                        body(order[i].request, lattice);
                    }
                }
            });
        });
    }

private:
    using locator = surface_locator<Scheme, Index>;
    using neighbourhood = typename locator::neighbourhood;
    using shape = typename locator::shapes::shape;

    /// The place of a request in an order in which requests with the same lattice follow each other.
    struct key {
        std::size_t shape_number, list, corner, request;
        shape* of;
        const subdivision_matrix* rows; ///< of its inputs over those around the face; nullptr if they are the same
        const neighbourhood* around;    ///< the face

        [[nodiscard]] auto numbers() const { return std::tuple(shape_number, list, corner, request); }
        [[nodiscard]] bool is_alike(const key& other) const
        {
            return shape_number == other.shape_number and list == other.list and corner == other.corner;
        }
    };

    std::vector<key> sorted(std::span<const request> requests)
    {
        using domain = domain_of<Scheme>;
        std::vector<key> result;
        result.reserve(requests.size());
        for (std::size_t r = 0; r < requests.size(); ++r) {
            const neighbourhood& around = neighbourhood_of(requests[r].face);
            key made{0, requests[r].list, requests[r].corner, r, around.around, nullptr, &around};
            if constexpr (domain::splits_in_four)
                if (around.around->in_domain.degree != domain::sides) { // its sub-faces are whole children
                    surface_->shapes_->look(*around.around);
                    const auto& child = around.around->children[made.corner];
                    made.of = child.of;
                    made.rows = &child.rows;
                    made.corner = 0;
                }
            made.shape_number = shape_numbers_.emplace(made.of, shape_numbers_.size()).first->second;
            result.push_back(made);
        }
        if (not std::ranges::is_sorted(result, {}, &key::numbers))
            std::ranges::sort(result, {}, &key::numbers);
        return result;
    }
    const neighbourhood& neighbourhood_of(std::size_t face)
    {
        if constexpr (domain_of<Scheme>::is_cut_off_by_boundaries)
            if (touches_boundary(surface_->mesh_.topology(), face))
                throw mesh_error("face " + std::to_string(face) + " touches the boundary, where " +
                                 std::string(scheme_name<Scheme>()) +
                                 " has a surface in parts of faces only; close the mesh");
        return surface_->neighbourhood_of(Index(face));
    }

    locator* surface_;
    std::unordered_map<const shape*, std::size_t> shape_numbers_; // in the order in which they are met
};

} // namespace kith::detail
