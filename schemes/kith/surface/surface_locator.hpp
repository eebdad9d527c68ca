// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "located_places.hpp"

#include <kith/base/error.hpp>
#include <kith/level/lift.hpp>
#include <kith/neighbourhood/element_finder.hpp>
#include <kith/neighbourhood/face_classes.hpp>
#include <kith/neighbourhood/face_walk.hpp>
#include <kith/shape/surface_shapes.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

/// Finds places on the limit surface of a mesh, anywhere in its faces: the polynomial that the surface is there.
///
/// The polynomial is the spline of the scheme in regular parts of the mesh, also beside boundaries and creases there.
/// Elsewhere the locator refines what lies around a face by the scheme's own text, until the place lies in a regular
/// part. So points are exact but for rounding: about 1e-15 of the control net. At an irregular vertex itself the point
/// and the tangent plane come from the limit masks. There du and dv are two tangents, counter-clockwise; their lengths
/// have no meaning, for the derivatives by u and v are zero or infinite, and second derivatives are no numbers.
///
/// For Catmull-Clark, Loop, Nasri-Hasbini and the linear schemes, with all creases, and for a user's own of such a
/// split. Of a scheme that is no spline among regular faces (Butterfly, Kobbelt, sqrt3) places come from many steps;
/// first derivatives have about seven digits, and second ones are no numbers.
/// One thread at a time may use a locator. The mesh need not outlive it.
template <parametric_scheme Scheme, std::unsigned_integral Index = std::uint32_t>
class surface_locator {
public:
    /// Errors: mesh_error for everything that `validate` finds, for faces that the scheme does not take, and for
    /// creases of another level. Cost: O(corners).
    template <std::same_as<Index> I, class Point>
    explicit surface_locator(const basic_mesh<Point, I>& mesh, const Scheme& scheme = Scheme())
        : surface_locator(mesh.topology(), mesh.generation(), checked(mesh, scheme))
    {
    }
    template <mesh M>
    explicit surface_locator(const M& mesh, const Scheme& scheme = Scheme()) : surface_locator(lift_valid(mesh), scheme)
    {
    }
    surface_locator(const surface_locator&) = delete;
    surface_locator& operator=(const surface_locator&) = delete;

    /// Returns places in the numbers of the faces of the mesh, ready to be evaluated.
    /// Errors: mesh_error, with the number of the place, for a face or corner that does not exist and for parameters
    /// outside of the face. Cost: O(places), and that of a few steps around a face for each kind of irregular face. Of
    /// a polygon or fan of n corners that is O(n^2).
    [[nodiscard]] located_places locate(std::span<const surface_place> places);

private:
    using shapes = detail::surface_shapes<Index, Scheme>;
    using shape = typename shapes::shape;
    static constexpr Index none = connectivity<Index>::none;

    /// The shape of a class of faces, and how the control points around a face of it are found.
    struct neighbourhood {
        shape* around = nullptr;
        std::vector<walk_step> steps{};
        std::vector<walked_element> inputs{};
        std::vector<Index> vertices{}; ///< the control points themselves, of a face alone
    };

    template <class Point>
    static const Scheme& checked(const basic_mesh<Point, Index>& mesh, const Scheme& scheme)
    {
        validate(mesh).require_ok();
        require_edges(mesh);
        with_native_level<Scheme>(
            mesh, [&](const auto& level) { detail::require_control_level(scheme, level, mesh.generation()); });
        return scheme;
    }
    surface_locator(const connectivity<Index>& topology, int generation, const Scheme& scheme);

    /// Returns the numbers of the places, those in one face together. Errors: those of `locate`.
    [[nodiscard]] std::vector<std::size_t> in_order_of_faces(std::span<const surface_place> places) const
    {
        std::vector<std::size_t> begin(mesh_.face_count() + 1, 0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            require_in_face(places[i], i);
            ++begin[places[i].face + 1];
        }
        for (std::size_t f = 0; f < mesh_.face_count(); ++f)
            begin[f + 1] += begin[f];
        std::vector<std::size_t> result(places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            result[begin[places[i].face]++] = i;
        return result;
    }
    void require_in_face(const surface_place& place, std::size_t number) const
    {
        const auto refuse = [&](const std::string& problem) {
            throw mesh_error("place " + std::to_string(number) + ": " + problem);
        };
        if (place.face >= mesh_.face_count())
            refuse("face " + std::to_string(place.face) + " does not exist, there are " +
                   std::to_string(mesh_.face_count()) + "; give the number of a face of the control mesh");
        const std::size_t degree = mesh_.face(place.face).size();
        const std::size_t parts = degree == detail::domain_of<Scheme>::sides ? 1 : degree;
        if (place.corner >= parts)
            refuse("face " + std::to_string(place.face) + " has no sub-face " + std::to_string(place.corner) +
                   ", there are " + std::to_string(parts) + "; give 0 to " + std::to_string(parts - 1));
        const bool is_inside = 0 <= place.u and place.u <= 1 and 0 <= place.v and place.v <= 1;
        if (not is_inside)
            refuse("u is " + std::to_string(place.u) + " and v is " + std::to_string(place.v) +
                   "; give numbers from 0 to 1");
        constexpr double most_with_rounding = 1 + 1e-15;
        if (not detail::has_quad_parameters<Scheme> and place.u + place.v > most_with_rounding)
            refuse("u + v is " + std::to_string(place.u + place.v) + " in a triangle; give at most 1");
    }

    /// Locates places of one face.
    void locate_in_face(Index face, std::span<const surface_place> places, std::span<const std::size_t> numbers,
                        detail::placed_pieces& result)
    {
        const neighbourhood& here = neighbourhood_of(face);
        nets_.assign(1, {here.around, {}});
        result.nets.push_back({nullptr, result.inputs.size(), here.around->vertices});
        append_inputs(here, face, result.inputs);
        found_.clear();
        for (const std::size_t number : numbers) {
            const surface_place& place = places[number];
            detail::face_parameters at{place.u, place.v};
            std::size_t net = 0;
            const auto descend = [&](std::size_t child) {
                auto& next = nets_[net].children;
                if (next.size() <= child)
                    next.resize(child + 1, 0);
                if (next[child] == 0) {
                    const auto& [of, rows] = nets_[net].of->children[child];
                    next[child] = nets_.size();
                    result.nets.push_back({&rows, net, of->vertices});
                    nets_.push_back({of, {}});
                }
                net = nets_[net].children[child];
            };
            const auto* polynomial = shapes_->find(*here.around, place.corner, at, descend);
            const auto piece = std::ranges::find_if(
                found_, [&](const found_piece& p) { return p.polynomial == polynomial and p.net == net; });
            if (piece != found_.end())
                piece->places.push_back({at, number});
            else
                found_.push_back({polynomial, net, {{at, number}}});
        }
        for (const found_piece& piece : found_) {
            result.places.insert(result.places.end(), piece.places.begin(), piece.places.end());
            result.pieces.push_back({piece.polynomial, piece.net, result.places.size()});
        }
        result.faces.push_back({result.nets.size(), result.pieces.size()});
    }
    [[nodiscard]] const neighbourhood& neighbourhood_of(Index face)
    {
        const auto number = classes_.of_faces()[face];
        neighbourhood& of_class = of_class_[number];
        if (of_class.around != nullptr)
            return of_class;
        if (const auto known = alone_.find(face); known != alone_.end())
            return known->second;
        const Index model = model_of_class_[number];
        walk_.around(model);
        // Classes know states that say where they are. Faces that meet themselves again may differ within a class.
        if (not scheme_of_places<Scheme> or not walk_.is_disk())
            return alone_.emplace(face, neighbourhood_around(face)).first->second;
        of_class = neighbourhood_around(model);
        of_class.steps.assign(walk_.steps().begin(), walk_.steps().end());
        of_class.inputs = walked_inputs(of_class.vertices);
        return of_class;
    }
    [[nodiscard]] neighbourhood neighbourhood_around(Index face)
    {
        const std::array<Index, 1> seed{face};
        const auto part = cutter_.cut(cutter_.faces_around(seed, rings_));
        const auto place = std::ranges::lower_bound(part.face_from, face) - part.face_from.begin();
        Scheme scheme = scheme_;
        detail::take_part(scheme, scheme_, part.numbers());
        auto [around, vertices] = shapes_->of_part(part.mesh.topology(), mesh_.generation(), scheme, Index(place));
        for (Index& v : vertices)
            v = part.vertex_from[v];
        return {around, {}, {}, std::move(vertices)};
    }
    /// Returns where the walk has met these vertices.
    [[nodiscard]] std::vector<walked_element> walked_inputs(std::span<const Index> vertices) const
    {
        std::unordered_map<Index, walked_corner> corners;
        for (std::size_t f = 0; f < walk_.faces().size(); ++f) {
            const auto face = mesh_.face(walk_.faces()[f]);
            for (std::size_t k = 0; k < face.size(); ++k)
                corners.try_emplace(face[k], walked_corner{std::uint16_t(f), std::uint16_t(k)});
        }
        std::vector<walked_element> result;
        for (const Index v : vertices)
            result.push_back({tuple_kind::v, corners.at(v)});
        return result;
    }
    void append_inputs(const neighbourhood& here, Index face, std::vector<std::size_t>& inputs)
    {
        if (here.inputs.empty()) {
            inputs.insert(inputs.end(), here.vertices.begin(), here.vertices.end());
            return;
        }
        finder_.walk(here.steps, std::span(&face, 1));
        for (const walked_element& input : here.inputs) {
            Index vertex = 0;
            finder_.find(input, &vertex);
            inputs.push_back(vertex);
        }
    }

    struct found_net {
        shape* of;
        std::vector<std::size_t> children; // their nets, or 0
    };
    struct found_piece {
        const detail::surface_polynomial* polynomial;
        std::size_t net;
        std::vector<detail::placed_parameters> places;
    };

    basic_mesh<float, Index> mesh_; // its points are not used
    Scheme scheme_;
    std::shared_ptr<shapes> shapes_;
    int rings_;
    submesh_cutter<float, Index> cutter_;
    face_walk<Index> walk_;
    element_finder<Index, 1> finder_;
    face_classes<Index> classes_;
    std::vector<neighbourhood> of_class_;
    std::vector<Index> model_of_class_;              // the first face of each
    std::unordered_map<Index, neighbourhood> alone_; // of faces that share nothing
    std::vector<found_net> nets_;                    // in the face at work
    std::vector<found_piece> found_;
};

// Outside of the class, so that what declares it `extern template` does not compile them.

template <parametric_scheme Scheme, std::unsigned_integral Index>
surface_locator<Scheme, Index>::surface_locator(const connectivity<Index>& topology, int generation,
                                                const Scheme& scheme)
    : mesh_(storage<float>(topology.vertices, 0), topology, generation)
    , scheme_(scheme)
    , shapes_(std::make_shared<shapes>(scheme))
    , rings_(detail::rings_of_surface(scheme))
    , cutter_(mesh_)
    , walk_(mesh_.topology(), rings_)
    , finder_(mesh_.topology())
    , classes_(mesh_.topology(), rings_, state_marks<Index>(mesh_.topology(), scheme))
    , of_class_(classes_.count())
    , model_of_class_(classes_.count(), none)
{
    for (std::size_t f = mesh_.face_count(); f > 0; --f)
        model_of_class_[classes_.of_faces()[f - 1]] = Index(f - 1);
}

template <parametric_scheme Scheme, std::unsigned_integral Index>
located_places surface_locator<Scheme, Index>::locate(std::span<const surface_place> places)
{
    detail::placed_pieces result;
    result.vertices = mesh_.vertex_count();
    result.owner = shapes_;
    result.places.reserve(places.size());
    const std::vector<std::size_t> by_face = in_order_of_faces(places);
    for (std::size_t begin = 0, end = 0; begin < by_face.size(); begin = end) {
        const std::size_t face = places[by_face[begin]].face;
        while (end < by_face.size() and places[by_face[end]].face == face)
            ++end;
        locate_in_face(Index(face), places, std::span(by_face).subspan(begin, end - begin), result);
    }
    return located_places(std::move(result));
}

template <mesh M, parametric_scheme Scheme>
surface_locator(const M&, const Scheme&) -> surface_locator<Scheme>;
template <class Point, std::unsigned_integral Index, parametric_scheme Scheme>
surface_locator(const basic_mesh<Point, Index>&, const Scheme&) -> surface_locator<Scheme, Index>;

#ifdef KITH_COMPILED_SCHEMES
extern template class surface_locator<catmull_clark>;
extern template class surface_locator<loop>;
#endif

} // namespace kith
