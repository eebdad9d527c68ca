// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "piece_values.hpp"
#include "placed_pieces.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/mask/stencil.hpp>
#include <kith/surface/spline/fast_affine.hpp>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The derivatives of a limit surface that a caller asks for; second ones come with first ones.
enum class derivatives : unsigned char { none, first, second };

/// The values of a limit surface at some places, in the order of the places, and their derivatives by the parameters of
/// the faces. Derivatives that were not asked for are empty.
template <class T>
struct surface_values {
    storage<T> points;
    storage<T> du{}, dv{};
    storage<T> duu{}, duv{}, dvv{};
};

/// Places on a limit surface that have been located: the polynomial of each. They can be evaluated any number of times,
/// for control points that move and for other values at the vertices of the control mesh.
class located_places {
public:
    located_places() = default;
    /// Takes the results of `surface_locator`.
    explicit located_places(detail::placed_pieces pieces) : all_(std::move(pieces)) {}

    [[nodiscard]] std::size_t size() const { return all_.places.size(); }

    /// Returns the values of the limit surface and their derivatives. `control` has a value per vertex of the control
    /// mesh, such as points, colours or rows of weights; a value per corner if the places were located for those.
    /// Derivatives that are not known at irregular vertices (see `surface_locator`) are NaN. Runs on the threads of
    /// OpenMP if values are plain bytes. Errors: mesh_error unless there is a value for each vertex or corner. Cost:
    /// O(places), and for each face with places that of a product with a matrix of some dozen rows.
    template <affine_value T>
    [[nodiscard]] surface_values<T> evaluate(std::span<const T> control, derivatives wanted = derivatives::none) const
    {
        if (control.size() != all_.values) {
            const std::string elements = all_.are_at_corners ? "corners" : "vertices";
            throw mesh_error("places on a surface with " + std::to_string(all_.values) + " control " + elements +
                             " were given " + std::to_string(control.size()) + " values; give one for each of these " +
                             elements);
        }
        surface_values<T> result{storage<T>(size())};
        if (wanted != derivatives::none)
            for (storage<T>* values : {&result.du, &result.dv})
                *values = storage<T>(size());
        if (wanted == derivatives::second)
            for (storage<T>* values : {&result.duu, &result.duv, &result.dvv})
                *values = storage<T>(size());
        const bool is_parallel = std::is_trivially_copyable_v<T> and detail::is_worth_threads(size());
        detail::for_parts(
            all_.groups.size(),
            is_parallel,
            [&](std::size_t begin, std::size_t end) {
                detail::piece_values<T> memory;
                for (std::size_t group = begin; group < end; ++group)
                    switch (wanted) {
                    case derivatives::none: evaluate_group<1>(group, control, memory, result); break;
                    case derivatives::first: evaluate_group<3>(group, control, memory, result); break;
                    case derivatives::second: evaluate_group<6>(group, control, memory, result); break;
                    }
            },
            2);
        return result;
    }
    template <std::ranges::contiguous_range Values>
        requires affine_value<std::ranges::range_value_t<Values>>
    [[nodiscard]] auto evaluate(const Values& values, derivatives wanted = derivatives::none) const
    {
        return evaluate(std::span<const std::ranges::range_value_t<Values>>(values), wanted);
    }

    /// Returns the weights of the control vertices in the values at the places, a row per place, and in derivatives.
    /// Errors: mesh_error if a derivative is asked for that is not known. Cost: O(n log n) for n entries.
    [[nodiscard]] surface_values<stencil_row> weights(derivatives wanted = derivatives::none) const
    {
        for (std::size_t group = 0; group < all_.groups.size(); ++group)
            for (const auto& place : places_of(group))
                if (pieces_of(group)[place.piece].polynomial->derivatives < int(wanted))
                    throw mesh_error("place " + std::to_string(place.number) +
                                     " is an irregular vertex or lies on a boundary, where such derivatives have no "
                                     "finite value; ask for fewer derivatives or move the place");
        return evaluate(unit_rows(all_.values), wanted);
    }

private:
    /// Returns the end of the data of all faces before a face; begin_of_group that of all before a group.
    [[nodiscard]] detail::end_of_face begin_of_face(std::size_t face) const
    {
        return face == 0 ? detail::end_of_face{0, 0, 0} : all_.faces[face - 1];
    }
    [[nodiscard]] detail::end_of_group begin_of_group(std::size_t group) const
    {
        return group == 0 ? detail::end_of_group{0, 0} : all_.groups[group - 1];
    }
    [[nodiscard]] std::span<const detail::placed_parameters> places_of(std::size_t group) const
    {
        const std::size_t first = begin_of_group(group).places;
        return std::span(all_.places).subspan(first, all_.groups[group].places - first);
    }
    [[nodiscard]] std::span<const detail::surface_piece> pieces_of(std::size_t group) const
    {
        const std::size_t first = begin_of_face(begin_of_group(group).faces).pieces;
        return std::span(all_.pieces).subspan(first, all_.faces[all_.groups[group].faces - 1].pieces - first);
    }

    /// Evaluates the places of a group: the coefficients of its faces first, so that values are written in their order.
    template <std::size_t Outputs, class T>
    void evaluate_group(std::size_t group, std::span<const T> control, detail::piece_values<T>& of_pieces,
                        surface_values<T>& result) const
    {
        of_pieces.clear();
        for (std::size_t face = begin_of_group(group).faces; face < all_.groups[group].faces; ++face)
            of_pieces.add_face(all_, face, [&](std::size_t input) {
                return detail::fast_affine<T>::load(control[all_.inputs[input]]);
            });
        const auto pieces = pieces_of(group);
        for (const auto& place : places_of(group)) {
            const auto made = of_pieces.template at<Outputs>(pieces[place.piece], place);
            storage<T>* const outputs[] = {
                &result.points, &result.du, &result.dv, &result.duu, &result.duv, &result.dvv};
            for (std::size_t i = 0; i < Outputs; ++i)
                (*outputs[i])[place.number] = detail::fast_affine<T>::store(made[i]);
        }
    }

    detail::placed_pieces all_;
};

} // namespace kith
