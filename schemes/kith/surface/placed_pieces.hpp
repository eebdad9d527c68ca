// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_place.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/surface/spline/surface_polynomial.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// The parameters of a place in a piece of a limit surface, and the number of the place.
struct placed_parameters {
    double s, t;
    std::size_t piece; ///< index among the pieces of the face or, if there are groups, of the group
    std::size_t number;
};
/// The inputs around a face with places, or around a face that steps make of it.
struct surface_net {
    const subdivision_matrix* rows; ///< over the inputs of `parent`; nullptr around a face of the control mesh
    std::size_t parent;             ///< index among the nets of the face; around a face of the control mesh the index
                                    ///< of its first input
    std::size_t size;
};
/// A polynomial of a limit surface that has places.
struct surface_piece {
    const surface_polynomial* polynomial;
    std::size_t net;           ///< index of the net of its points, among the nets of the face
    double s_u, s_v, t_u, t_v; ///< derivatives of its parameters by those of the face

    friend bool operator==(const surface_piece&, const surface_piece&) = default;
};
/// The end of the data of one face of the control mesh.
struct end_of_face {
    std::size_t nets, pieces, places;
};
/// The end of the data of a group of faces, whose coefficients are stored at the same time.
struct end_of_group {
    std::size_t faces, places;
};

/// The parts of `located_places`, face by face.
struct placed_pieces {
    std::size_t values = 0; ///< number of control values: one for each vertex or corner of the control mesh
    bool are_at_corners = false;
    std::vector<std::size_t> inputs{}; ///< indices of the control values around the faces
    std::vector<surface_net> nets{};   ///< each after its parent
    std::vector<surface_piece> pieces{};
    std::vector<placed_parameters> places{}; ///< face by face; in a group sorted by their numbers
    std::vector<end_of_face> faces{};
    std::vector<end_of_group> groups{};
    std::shared_ptr<const void> owner{}; ///< keeps polynomials and rows alive

    /// Appends the faces of another object. The places of these faces are already in this object, and there are no
    /// groups.
    void append(placed_pieces&& more)
    {
        const std::size_t inputs_before = inputs.size(), nets_before = nets.size(), pieces_before = pieces.size();
        if (faces.empty()) {
            inputs = std::move(more.inputs);
            nets = std::move(more.nets);
            pieces = std::move(more.pieces);
            faces = std::move(more.faces);
            return;
        }
        inputs.insert(inputs.end(), more.inputs.begin(), more.inputs.end());
        pieces.insert(pieces.end(), more.pieces.begin(), more.pieces.end());
        for (surface_net net : more.nets) {
            if (net.rows == nullptr)
                net.parent += inputs_before;
            nets.push_back(net);
        }
        for (const end_of_face& end : more.faces)
            faces.push_back({end.nets + nets_before, end.pieces + pieces_before, end.places});
    }
    /// Groups consecutive faces. A group has as many faces as have coefficients that fit in a cache, and there are some
    /// groups for each of `threads` threads. Sorts the places of each group by their numbers, since values that are
    /// written in order take less time. Cost: O(places).
    void make_groups(std::size_t threads)
    {
        const std::size_t most_pieces = std::clamp<std::size_t>(pieces.size() / (4 * threads), 64, 1024);
        std::vector<std::uint32_t> group_of(places.size());
        std::vector<std::size_t> next; // the next free position in each group
        std::size_t first_piece = 0;   // of the current group
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const end_of_face before = f == 0 ? end_of_face{0, 0, 0} : faces[f - 1];
            if (groups.empty() or faces[f].pieces - first_piece > most_pieces) {
                groups.push_back({});
                next.push_back(before.places);
                first_piece = before.pieces;
            }
            groups.back() = {f + 1, faces[f].places};
            for (std::size_t i = before.places; i < faces[f].places; ++i) {
                places[i].piece += before.pieces - first_piece;
                group_of[places[i].number] = std::uint32_t(groups.size() - 1);
            }
        }
        std::vector<std::size_t> positions(places.size());
        for (std::size_t number = 0; number < positions.size(); ++number)
            positions[number] = next[group_of[number]]++;
        std::vector<placed_parameters> sorted(places.size());
        for (const placed_parameters& place : places)
            sorted[positions[place.number]] = place;
        places = std::move(sorted);
    }
};

} // namespace detail

} // namespace kith
