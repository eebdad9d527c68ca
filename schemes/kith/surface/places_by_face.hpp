// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surface_place.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kith::detail {

/// The numbers of places in the order of the faces that they lie in.
struct places_by_face {
    /// Takes places and sorts them by faces. Faces with `sides` corners have parameters of their own; others have
    /// sub-faces. Errors: mesh_error for a place that does not exist. Cost: O(places + faces).
    template <std::unsigned_integral Index>
    places_by_face(const connectivity<Index>& mesh, std::size_t sides, std::span<const surface_place> places)
        : numbers(places.size()), ends(mesh.faces + 1, 0)
    {
        for (std::size_t i = 0; i < places.size(); ++i) {
            require_in_face(mesh, sides, places[i], i);
            ++ends[places[i].face + 1];
        }
        for (std::size_t f = 0; f < mesh.faces; ++f)
            ends[f + 1] += ends[f];
        for (std::size_t i = 0; i < places.size(); ++i)
            numbers[ends[places[i].face]++] = i;
    }

    std::vector<std::size_t> numbers;
    std::vector<std::size_t> ends; ///< for each face the end of its places among the numbers

private:
    template <std::unsigned_integral Index>
    static void require_in_face(const connectivity<Index>& mesh, std::size_t sides, const surface_place& place,
                                std::size_t number)
    {
        const auto refuse = [&](const std::string& problem) {
            throw mesh_error("place " + std::to_string(number) + ": " + problem);
        };
        if (place.face >= mesh.faces)
            refuse("face " + std::to_string(place.face) + " does not exist, there are " + std::to_string(mesh.faces) +
                   "; give the number of a face of the control mesh");
        const auto degree = std::size_t(mesh.first_corner(place.face + 1) - mesh.first_corner(place.face));
        const std::size_t parts = degree == sides ? 1 : degree;
        if (place.corner >= parts)
            refuse("face " + std::to_string(place.face) + " has no sub-face " + std::to_string(place.corner) +
                   ", there are " + std::to_string(parts) + "; give 0 to " + std::to_string(parts - 1));
        const bool is_inside = 0 <= place.u and place.u <= 1 and 0 <= place.v and place.v <= 1;
        if (not is_inside)
            refuse("u is " + std::to_string(place.u) + " and v is " + std::to_string(place.v) +
                   "; give numbers from 0 to 1");
        constexpr double most_with_rounding = 1 + 1e-15;
        if (sides == 3 and place.u + place.v > most_with_rounding)
            refuse("u + v is " + std::to_string(place.u + place.v) + " in a triangle; give at most 1");
    }
};

/// Returns true if a vertex of a face lies at the boundary.
template <std::unsigned_integral Index>
bool touches_boundary(const connectivity<Index>& mesh, std::size_t face)
{
    for (Index corner = mesh.first_corner(face); corner < mesh.first_corner(face + 1); ++corner) {
        const Index start = mesh.vertex_corner[mesh.corner_vertex[corner]];
        Index c = start;
        do
            c = mesh.next_in_fan(c);
        while (c != mesh.none and c != start);
        if (c == mesh.none)
            return true;
    }
    return false;
}

} // namespace kith::detail
