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

/// Parameters in a piece of a limit surface, and the number of the place that they are of.
struct placed_parameters {
    double s, t;
    std::size_t piece; ///< among those of the face; when there are groups, of the group
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
    std::size_t net;           ///< over whose points, among those of the face
    double s_u, s_v, t_u, t_v; ///< derivatives of its parameters by those of the face

    friend bool operator==(const surface_piece&, const surface_piece&) = default;
};
/// The end of what belongs to one face of the control mesh.
struct end_of_face {
    std::size_t nets, pieces, places;
};
/// The end of what belongs to a group of faces, whose coefficients are known at the same time.
struct end_of_group {
    std::size_t faces, places;
};

/// The parts of `located_places`, face by face.
struct placed_pieces {
    std::size_t values = 0; ///< of the control mesh: one for each vertex, or for each corner
    bool are_at_corners = false;
    std::vector<std::size_t> inputs{}; ///< those around the faces
    std::vector<surface_net> nets{};   ///< each after its parent
    std::vector<surface_piece> pieces{};
    std::vector<placed_parameters> places{}; ///< face by face; in a group by their numbers
    std::vector<end_of_face> faces{};
    std::vector<end_of_group> groups{};
    std::shared_ptr<const void> owner{}; ///< of polynomials and rows

    /// Appends the faces of another object. Its places are among those of this one already, and there are no groups.
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
    /// Groups faces that follow each other, as many as have coefficients that fit in a cache and as leave some groups
    /// for each of so many threads. Sorts the places of each group by their numbers, for values that are written in
    /// order take less time. Cost: O(places).
    void make_groups(std::size_t threads)
    {
        const std::size_t most_pieces = std::clamp<std::size_t>(pieces.size() / (4 * threads), 64, 1024);
        std::vector<std::uint32_t> group_of(places.size());
        std::vector<std::size_t> next; // of the positions of each group
        std::size_t first_piece = 0;   // of the group
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
