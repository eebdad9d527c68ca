// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "placed_pieces.hpp"

#include <kith/core/base/error.hpp>
#include <kith/engine/neighbourhood/element_finder.hpp>
#include <kith/engine/neighbourhood/face_walk.hpp>
#include <kith/surface/shape/surface_shapes.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kith::detail {

/// The shape of a class of faces, and the way to the inputs around a face of the class.
template <std::unsigned_integral Index, class Shape>
struct face_neighbourhood {
    Shape* around = nullptr;
    std::vector<Index> control{};         ///< the inputs among the control values, of a face alone or of the model
    std::vector<walk_step> steps{};       ///< from a face of the class
    std::vector<walked_element> inputs{}; ///< the places on the walk at which the inputs lie
};

/// The memory of a thread that locates places.
template <std::unsigned_integral Index, class Shapes>
class face_search {
    using shape = typename Shapes::shape;

public:
    using neighbourhood = face_neighbourhood<Index, shape>;

    face_search(const connectivity<Index>& mesh, Shapes& all) : shapes_(&all), finder_(mesh) {}

    /// Locates the places of one face, given by their numbers. Writes them to `found`, and appends nets and pieces to
    /// `result`. `end` is the number of places up to the last one of the face. Errors: mesh_error for a place that a
    /// boundary cuts off.
    void locate(const neighbourhood& here, Index face, std::span<const surface_place> places,
                std::span<const std::size_t> numbers, std::span<placed_parameters> found, std::size_t end,
                placed_pieces& result)
    {
        nets_.assign(1, {here.around, {}});
        result.nets.push_back({nullptr, result.inputs.size(), here.around->inputs});
        append_inputs(here, face, result.inputs);
        const auto first_piece = std::ptrdiff_t(result.pieces.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const surface_place& place = places[numbers[i]];
            face_parameters at{place.u, place.v};
            std::size_t net = 0;
            const auto descend = [&](std::size_t child) {
                auto& next = nets_[net].children;
                if (next.size() <= child)
                    next.resize(child + 1, 0);
                if (next[child] == 0) {
                    const auto& [of, rows, first] = nets_[net].of->children[child];
                    next[child] = nets_.size();
                    result.nets.push_back({&rows, net, of->inputs});
                    nets_.push_back({of, {}});
                }
                net = nets_[net].children[child];
            };
            const auto* polynomial = shapes_->find(*here.around, place.corner, at, descend);
            if (polynomial == nullptr)
                throw mesh_error("place " + std::to_string(numbers[i]) + ": the boundary cuts off this part of face " +
                                 std::to_string(face) + ", which has no surface; take places nearer to inner vertices");
            const surface_piece piece{polynomial, net, at.s_u, at.s_v, at.t_u, at.t_v};
            const auto known = std::find(result.pieces.begin() + first_piece, result.pieces.end(), piece);
            found[i] = {at.s, at.t, std::size_t(known - result.pieces.begin() - first_piece), numbers[i]};
            if (known == result.pieces.end())
                result.pieces.push_back(piece);
        }
        result.faces.push_back({result.nets.size(), result.pieces.size(), end});
    }
    /// Appends the inputs around a face.
    void append_inputs(const neighbourhood& here, Index face, std::vector<std::size_t>& inputs)
    {
        if (here.inputs.empty()) {
            inputs.insert(inputs.end(), here.control.begin(), here.control.end());
            return;
        }
        finder_.walk(here.steps, std::span(&face, 1));
        for (const walked_element& input : here.inputs) {
            Index vertex = 0;
            finder_.find(input, &vertex);
            inputs.push_back(vertex);
        }
    }

private:
    struct found_net {
        shape* of;
        std::vector<std::size_t> children; // indices of their nets, or 0
    };

    Shapes* shapes_;
    element_finder<Index, 1> finder_;
    std::vector<found_net> nets_; // of the current face
};

} // namespace kith::detail
