// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_place.hpp"

#include <kith/mask/stencil.hpp>
#include <kith/shape/face_parameters.hpp>
#include <kith/spline/surface_polynomial.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Parameters in a piece of a limit surface, and the number of the place that they are of.
struct placed_parameters {
    face_parameters at;
    std::size_t number;
};
/// The inputs around a face that has places, or around a face that steps make of it.
struct surface_net {
    const subdivision_matrix* rows; ///< over those of `parent`; nullptr around a face of the control mesh
    std::size_t parent;             ///< among the nets of the face; for a face of the control mesh where in the list of
                                    ///< control values its own begin
    std::size_t size;
};
/// A polynomial of a limit surface that has places.
struct surface_piece {
    const surface_polynomial* polynomial;
    std::size_t net;        ///< over whose points, among those of the face
    std::size_t end_places; ///< where its places end
};
/// The end of what belongs to one face of the control mesh.
struct end_of_face {
    std::size_t nets, pieces;
};

/// The parts of `located_places`, face by face.
struct placed_pieces {
    std::size_t values = 0; ///< of the control mesh: one for each vertex, or for each corner
    bool are_at_corners = false;
    std::vector<std::size_t> inputs{}; ///< those around the faces
    std::vector<surface_net> nets{};   ///< each after its parent
    std::vector<surface_piece> pieces{};
    std::vector<placed_parameters> places{}; ///< piece by piece
    std::vector<end_of_face> faces{};
    std::shared_ptr<const void> owner{}; ///< of polynomials and rows

    /// Appends the faces of another object, whose places are among those of this one already.
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
            faces.push_back({end.nets + nets_before, end.pieces + pieces_before});
    }
};

} // namespace detail

} // namespace kith
