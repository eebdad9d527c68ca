// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_search.hpp"
#include "located_places.hpp"
#include "places_by_face.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/engine/neighbourhood/face_classes.hpp>
#include <kith/engine/neighbourhood/face_walk.hpp>
#include <kith/surface/shape/surface_shapes.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

template <parametric_scheme Scheme, std::unsigned_integral Index>
class surface_cells;
template <parametric_scheme Scheme, std::unsigned_integral Index>
class surface_lattices;

} // namespace detail

/// A locator of places on the limit surface of a mesh, anywhere in its faces: it finds the polynomial of the surface
/// there.
///
/// The polynomial is the spline of the scheme in regular parts of the mesh, also beside boundaries and creases there.
/// Elsewhere the locator refines the neighbourhood of a face by the scheme itself, until the place lies in a regular
/// part. So points are exact up to rounding: about 1e-15 of the control net. At an irregular vertex itself the point
/// and the tangent plane come from limit masks or from repeated steps. There du and dv are two tangents,
/// counter-clockwise. Their lengths have no meaning, since the derivatives by u and v are zero or infinite, and second
/// derivatives are NaN. On creases tangents are those of the side of the face; where creases meet some sides have none.
///
/// A locator takes all schemes of the library, with all creases, and a user's own with such a split. Doo-Sabin and
/// mid-edge have a surface in parts of the faces at a boundary, docs/how/surface.md. The degree of unified is at most
/// 5. For a scheme that is no spline among regular faces (Butterfly, Kobbelt, both sqrt3) places come from many steps;
/// first derivatives have about seven digits, and second ones are NaN. So it is on boundaries of 4-8 and Doo-Sabin.
/// With Doo-Sabin the derivative across is infinite, and a tangent replaces it. One thread at a time may use a locator.
/// The mesh need not outlive it.
template <parametric_scheme Scheme, std::unsigned_integral Index = std::uint32_t>
class surface_locator {
public:
    /// Takes a mesh and the scheme of its level. Errors: mesh_error for all faults that `validate` finds, for faces
    /// that the scheme does not take, and for creases of another level. Cost: O(corners).
    template <std::same_as<Index> I, class Point>
    explicit surface_locator(const basic_mesh<Point, I>& mesh, const Scheme& scheme = Scheme())
        : surface_locator(mesh.topology(), mesh.generation(), checked(mesh, scheme))
    {
    }
    template <mesh M>
    explicit surface_locator(const M& mesh, const Scheme& scheme = Scheme())
        : surface_locator(to_native_valid(mesh), scheme)
    {
    }
    surface_locator(const surface_locator&) = delete;
    surface_locator& operator=(const surface_locator&) = delete;

    /// Returns the located places, ready to be evaluated for values at the vertices. Places are given by the numbers of
    /// the faces of the mesh. Runs on threads; the results are the same bits for any number of threads. Errors:
    /// mesh_error, with the number of the place, for a face or corner that does not exist or parameters outside the
    /// face; also for a part of the face that a boundary cuts off. Cost: O(places), and that of a few steps around a
    /// face for each kind of irregular face: O(n^2) for a polygon or fan of n corners.
    [[nodiscard]] located_places locate(std::span<const surface_place> places);
    /// Returns the same for values at the corners of faces, such as texture coordinates with seams: locate(places,
    /// on_corners(uv, face_varying{})). The seams are those of the field; other values at corners with the same seams
    /// can be evaluated, too. Errors: also those of the rule, and mesh_error unless the field has a value for each
    /// corner. Cost: also that of reading the faces around each face with places.
    template <class T, marking_rule Rule>
    [[nodiscard]] located_places locate(std::span<const surface_place> places,
                                        const field<field_on::corners, T, Rule>& values);

private:
    friend class detail::surface_cells<Scheme, Index>;
    friend class detail::surface_lattices<Scheme, Index>;

    using shapes = detail::surface_shapes<Index, Scheme>;
    using search = detail::face_search<Index, shapes>;
    using neighbourhood = detail::face_neighbourhood<Index, typename shapes::shape>;
    static constexpr Index none = connectivity<Index>::none;

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

    /// Locates places by shapes. neighbourhood_of_face(face) returns a pointer to the face_neighbourhood of a face.
    template <class Shapes, class NeighbourhoodOf>
    located_places locate_with(const std::shared_ptr<Shapes>& all, std::span<const surface_place> places,
                               const NeighbourhoodOf& neighbourhood_of_face);

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
        // Classes only know states that list their elements. Faces that meet themselves again may differ within a
        // class.
        if (not scheme_of_places<Scheme> or not walk_.is_disk())
            return alone_.emplace(face, neighbourhood_around(face)).first->second;
        of_class = neighbourhood_around(model);
        of_class.steps.assign(walk_.steps().begin(), walk_.steps().end());
        of_class.inputs = walked_inputs(of_class.control);
        return of_class;
    }
    /// A face with the faces around it and their state.
    struct face_part {
        submesh<float, Index> cut;
        Scheme scheme;
        Index face;
    };
    [[nodiscard]] face_part part_around(Index face)
    {
        auto cut = cutter_.cut(detail::domain_of<Scheme>::faces_around(cutter_, mesh_.topology(), face, rings_));
        const auto place = std::ranges::lower_bound(cut.face_from, face) - cut.face_from.begin();
        Scheme scheme = scheme_;
        detail::restrict_state(scheme, scheme_, cut.numbers());
        return {std::move(cut), std::move(scheme), Index(place)};
    }
    [[nodiscard]] neighbourhood neighbourhood_around(Index face)
    {
        const face_part part = part_around(face);
        const auto& topology = part.cut.mesh.topology();
        auto [around, control] = shapes_->of_part({topology, mesh_.generation(), part.scheme, part.face});
        for (Index& input : control)
            input = part.cut.vertex_from[topology.corner_vertex[input]];
        return {around, std::move(control)};
    }
    /// Returns the same with the shape of values at corners.
    template <class T, class Rule>
    [[nodiscard]] auto neighbourhood_around(Index face, const field<field_on::corners, T, Rule>& values,
                                            detail::surface_shapes<Index, Scheme, Rule>& all)
    {
        const face_part part = part_around(face);
        const auto& topology = part.cut.mesh.topology();
        const auto corners = detail::corners_of(mesh_.topology(), topology, std::span<const Index>(part.cut.face_from));
        auto alike = detail::first_alike(topology,
                                         [&](Index a, Index b) { return values[corners[a]] == values[corners[b]]; });
        auto [around, control] = all.of_part({topology, mesh_.generation(), part.scheme, part.face, std::move(alike)});
        for (Index& input : control)
            input = corners[input];
        return detail::face_neighbourhood<Index, typename detail::surface_shapes<Index, Scheme, Rule>::shape>{
            around, std::move(control)};
    }
    /// Returns the places at which the walk has met these vertices.
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

    basic_mesh<float, Index> mesh_; // its points are not used
    Scheme scheme_;
    std::shared_ptr<shapes> shapes_;
    int rings_;
    submesh_cutter<float, Index> cutter_;
    face_walk<Index> walk_;
    face_classes<Index> classes_;
    std::vector<neighbourhood> of_class_;
    std::vector<Index> model_of_class_;              // the first face of each class
    std::unordered_map<Index, neighbourhood> alone_; // of faces that share no class
};

// Defined outside the class, so that a program that declares it `extern template` does not compile its members.

template <parametric_scheme Scheme, std::unsigned_integral Index>
surface_locator<Scheme, Index>::surface_locator(const connectivity<Index>& topology, int generation,
                                                const Scheme& scheme)
    : mesh_(storage<float>(topology.vertices, 0), topology, generation)
    , scheme_(scheme)
    , shapes_(std::make_shared<shapes>(scheme))
    , rings_(detail::rings_of_surface(scheme))
    , cutter_(mesh_)
    , walk_(mesh_.topology(), rings_)
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
    return locate_with(shapes_, places, [this](Index face) { return &neighbourhood_of(face); });
}

template <parametric_scheme Scheme, std::unsigned_integral Index>
template <class T, marking_rule Rule>
located_places surface_locator<Scheme, Index>::locate(std::span<const surface_place> places,
                                                      const field<field_on::corners, T, Rule>& values)
{
    if (values.size() != mesh_.corner_count())
        throw mesh_error("a field on corners has " + std::to_string(values.size()) + " values, the mesh has " +
                         std::to_string(mesh_.corner_count()) + " corners; give it one for each");
    using corner_shapes = detail::surface_shapes<Index, Scheme, Rule>;
    const auto all = std::make_shared<corner_shapes>(scheme_, values.rule());
    std::deque<detail::face_neighbourhood<Index, typename corner_shapes::shape>> made;
    return locate_with(
        all, places, [&](Index face) { return &made.emplace_back(neighbourhood_around(face, values, *all)); });
}

template <parametric_scheme Scheme, std::unsigned_integral Index>
template <class Shapes, class NeighbourhoodOf>
located_places surface_locator<Scheme, Index>::locate_with(const std::shared_ptr<Shapes>& all,
                                                           std::span<const surface_place> places,
                                                           const NeighbourhoodOf& neighbourhood_of_face)
{
    struct places_of_face {
        Index face;
        std::size_t begin;
        const detail::face_neighbourhood<Index, typename Shapes::shape>* around;
    };
    const detail::places_by_face by_face(mesh_.topology(), detail::domain_of<Scheme>::sides, places);
    std::vector<places_of_face> faces;
    for (std::size_t f = 0, begin = 0; f < mesh_.face_count(); begin = by_face.ends[f++])
        if (by_face.ends[f] != begin)
            faces.push_back({Index(f), begin, neighbourhood_of_face(Index(f))});
    const std::size_t count = faces.size();
    faces.push_back({0, places.size(), nullptr});

    detail::placed_pieces result;
    result.are_at_corners = not Shapes::shape::has_points;
    result.values = result.are_at_corners ? mesh_.corner_count() : mesh_.vertex_count();
    result.owner = all;
    result.places.resize(places.size());
    const bool is_parallel = detail::is_worth_threads(places.size()) and detail::most_threads() > 1;
    const std::size_t faces_of_part = is_parallel ? 512 : std::max<std::size_t>(count, 1);
    std::vector<detail::placed_pieces> parts((count + faces_of_part - 1) / faces_of_part);
    detail::for_shared_parts(count, faces_of_part, is_parallel, [&](auto&& work) {
        detail::face_search<Index, Shapes> search(mesh_.topology(), *all);
        work.for_each([&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                const std::size_t first = faces[f].begin, size = faces[f + 1].begin - first;
                search.locate(*faces[f].around,
                              faces[f].face,
                              places,
                              std::span(by_face.numbers).subspan(first, size),
                              std::span(result.places).subspan(first, size),
                              first + size,
                              parts[begin / faces_of_part]);
            }
        });
    });
    for (detail::placed_pieces& part : parts)
        result.append(std::move(part));
    result.make_groups(is_parallel ? detail::most_threads() : 1);
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
