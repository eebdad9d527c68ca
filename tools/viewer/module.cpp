// SPDX-License-Identifier: BSD-3-Clause
// The functions that a page calls: surfaces as pointers, elements as a kind (0 vertex, 1 edge, 2 face) and a number.
#include "drawing.hpp"
#include "surface.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/loop.hpp>
#include <kith/sqrt3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <typeinfo>
#include <utility>
#include <vector>

namespace kith::viewer {

namespace {

/// An array that a function returns to the page. It is valid until the next call that returns one of its type.
struct returned_array {
    const void* data;
    std::size_t size;
};

template <class T>
const returned_array* returned(std::vector<T> values)
{
    static std::vector<T> kept;
    static returned_array result;
    kept = std::move(values);
    result = {kept.data(), kept.size()};
    return &result;
}

/// A surface that a page shows, with its frame and the values of its colors.
struct shown_surface {
    std::unique_ptr<surface> shape;
    frame seen{};
    shown_values values{};
};

/// The schemes in the order in which pages number them.
std::unique_ptr<surface> make_surface(int scheme, mesh_type control)
{
    switch (scheme) {
    case 0: return std::make_unique<surface_of_scheme<catmull_clark>>(std::move(control));
    case 1: return std::make_unique<surface_of_scheme<loop>>(std::move(control));
    case 2: return std::make_unique<surface_of_scheme<doo_sabin>>(std::move(control));
    default: return std::make_unique<surface_of_scheme<sqrt3>>(std::move(control));
    }
}

numbered_element element_of(int kind, std::uint32_t number)
{
    return {element_kind(kind), number};
}

/// Returns a list of kinds and numbers by turns.
std::vector<std::uint32_t> listed(const birth<mesh_type>& from)
{
    std::vector<std::uint32_t> result;
    const auto add = [&](std::uint32_t kind, const auto& handle) {
        if (handle)
            result.insert(result.end(), {kind, handle->value});
    };
    add(0, from.v);
    add(0, from.other_v);
    add(1, from.e);
    add(2, from.f);
    add(2, from.other_f);
    return result;
}

} // namespace

} // namespace kith::viewer

using namespace kith::viewer;

extern "C" {

/// The function of the page that shows the text of an error.
[[clang::import_name("fail")]] void fail(const char* text);

// This platform has no unwinder: an exception ends the module, and its text is shown. All exceptions of kith and of its
// standard library are std::exceptions. NOLINTBEGIN(readability-identifier-naming): names of the ABI
void* __cxa_allocate_exception(std::size_t size) noexcept
{
    return std::malloc(size);
}
void __cxa_throw(void* thrown, std::type_info*, void (*)(void*))
{
    fail(static_cast<std::exception*>(thrown)->what());
    std::abort();
}
// NOLINTEND(readability-identifier-naming)

[[clang::export_name("allocate")]] void* allocate(std::size_t bytes)
{
    return std::malloc(bytes);
}
[[clang::export_name("release")]] void release(void* block)
{
    std::free(block);
}

[[clang::export_name("open_surface")]] shown_surface* open_surface(int scheme, std::size_t vertices,
                                                                   const point* points, std::size_t faces,
                                                                   const std::uint32_t* degrees,
                                                                   const std::uint32_t* corners)
{
    kith::face_list list;
    for (const std::uint32_t degree : std::span(degrees, faces)) {
        list.push_back(std::span(corners, degree));
        corners += degree;
    }
    return new shown_surface{make_surface(scheme, kith::make_mesh(std::span(points, vertices), list))};
}
[[clang::export_name("close_surface")]] void close_surface(shown_surface* shown)
{
    delete shown;
}

[[clang::export_name("set_frame")]] void set_frame(shown_surface* shown, double x, double y, double z, double radius)
{
    shown->seen = {{x, y, z}, radius};
}
/// Edges are pairs of vertices.
[[clang::export_name("sharpen")]] void sharpen(shown_surface* shown, std::size_t edges, const std::uint32_t* ends,
                                               const double* of_edges, std::size_t vertices,
                                               const std::uint32_t* numbers, const double* of_vertices, bool is_chaikin)
{
    const level_type& control = shown->shape->elements(0);
    kith::creases sharpness(is_chaikin ? kith::crease_method::chaikin : kith::crease_method::uniform);
    for (std::size_t i = 0; i < edges; ++i)
        for (const auto c : control.vertices()[ends[2 * i]].corners()) {
            if (c.next().v().index() == ends[2 * i + 1])
                sharpness.sharpen_edge(c.next_edge().index(), of_edges[i]);
            else if (c.prev().v().index() == ends[2 * i + 1])
                sharpness.sharpen_edge(c.prev_edge().index(), of_edges[i]);
        }
    for (std::size_t i = 0; i < vertices; ++i)
        sharpness.sharpen_vertex(numbers[i], of_vertices[i]);
    shown->shape->sharpen(sharpness);
}
[[clang::export_name("move_points")]] void move_points(shown_surface* shown, const point* points, int last)
{
    shown->shape->move_points(std::span(points, shown->shape->elements(0).vertex_count()), last);
}
[[clang::export_name("levels_within")]] int levels_within(const shown_surface* shown, std::size_t faces)
{
    return shown->shape->levels_within(faces);
}
[[clang::export_name("refine_to")]] void refine_to(shown_surface* shown, int level)
{
    shown->shape->refine_to(level);
}

[[clang::export_name("counts")]] const returned_array* counts(const shown_surface* shown, int level)
{
    const auto counted = shown->shape->elements(level).counts();
    return returned(std::vector<std::uint32_t>{
        std::uint32_t(counted.vertices), std::uint32_t(counted.edges), std::uint32_t(counted.faces)});
}
[[clang::export_name("points")]] const returned_array* points(const shown_surface* shown, int level)
{
    std::vector<double> result;
    for (const auto v : shown->shape->elements(level).vertices())
        result.insert(result.end(), v.point().begin(), v.point().end());
    return returned(std::move(result));
}
/// Returns pairs of vertices.
[[clang::export_name("edges")]] const returned_array* edges(const shown_surface* shown, int level)
{
    std::vector<std::uint32_t> result;
    for (const auto e : shown->shape->elements(level).edges())
        result.insert(result.end(), {std::uint32_t(e.org().index()), std::uint32_t(e.dst().index())});
    return returned(std::move(result));
}
[[clang::export_name("edge_ends")]] const returned_array* ends_of_edges(const shown_surface* shown, int level)
{
    return returned(edge_ends(shown->shape->elements(level), shown->seen));
}
[[clang::export_name("face_vertices")]] const returned_array* face_vertices(const shown_surface* shown, int level,
                                                                            std::uint32_t face)
{
    std::vector<std::uint32_t> result;
    for (const auto v : shown->shape->elements(level).faces()[face].vertices())
        result.push_back(std::uint32_t(v.index()));
    return returned(std::move(result));
}
[[clang::export_name("face_edges")]] const returned_array* face_edges(const shown_surface* shown, int level,
                                                                      std::uint32_t face)
{
    std::vector<std::uint32_t> result;
    for (const auto e : shown->shape->elements(level).faces()[face].edges())
        result.push_back(std::uint32_t(e.index()));
    return returned(std::move(result));
}

[[clang::export_name("triangles")]] const returned_array* triangles(const shown_surface* shown, int level,
                                                                    bool is_smooth)
{
    return returned(triangles_of(*shown->shape, level, is_smooth, shown->seen));
}
[[clang::export_name("first_triangles")]] const returned_array* first_triangles_of(const shown_surface* shown,
                                                                                   int level)
{
    return returned(first_triangles(shown->shape->elements(level)));
}
/// Sets the values of the colors, and returns the two ends of their range, or an empty array.
[[clang::export_name("set_values")]] const returned_array* set_values(shown_surface* shown, int level, coloring by,
                                                                      std::size_t size, const double* given)
{
    shown->values = values_of(*shown->shape, level, by, std::span(given, size));
    const bool is_signed = by == coloring::gaussian or by == coloring::mean;
    const auto range = range_of(shown->values.values, is_signed);
    return returned(range ? std::vector<double>{(*range)[0], (*range)[1]} : std::vector<double>());
}
[[clang::export_name("colors")]] const returned_array* colors(const shown_surface* shown, int level, palette colors,
                                                              double least, double most)
{
    return returned(colors_of(shown->shape->elements(level), shown->values, colors, {least, most}));
}
[[clang::export_name("color_of")]] const returned_array* color_of_value(double value, palette colors, double least,
                                                                        double most)
{
    return returned(std::vector{color_of(value, colors, {least, most})});
}

/// Returns a list of kinds and numbers: the tuple that made an element.
[[clang::export_name("origin")]] const returned_array* origin(const shown_surface* shown, int level, int kind,
                                                              std::uint32_t number)
{
    return returned(listed(shown->shape->origin(level, element_of(kind, number))));
}
/// Returns a kind and a number.
[[clang::export_name("ancestor")]] const returned_array* ancestor(const shown_surface* shown, int level, int kind,
                                                                  std::uint32_t number, int coarser)
{
    const auto found = shown->shape->ancestor(level, element_of(kind, number), coarser);
    return returned(std::vector{std::uint32_t(found.kind), std::uint32_t(found.number)});
}
/// Returns ranges of numbers, each as its begin and its end, of the descendants of one kind.
[[clang::export_name("descendants")]] const returned_array*
descendants(const shown_surface* shown, int level, int kind, std::uint32_t number, int finer, int kind_of_descendants)
{
    const auto found = shown->shape->descendants(level, element_of(kind, number), finer);
    std::vector<std::uint32_t> result;
    for (const auto& [begin, end] : found.*of_kind(kith::element_kind(kind_of_descendants)))
        result.insert(result.end(), {std::uint32_t(begin), std::uint32_t(end)});
    return returned(std::move(result));
}
/// Returns the number of the face that a ray of the frame meets first, or an empty array.
[[clang::export_name("face_at")]] const returned_array* face_at_ray(const shown_surface* shown, int level, double x,
                                                                    double y, double z, double along_x, double along_y,
                                                                    double along_z)
{
    const auto found = face_at(shown->shape->elements(level), {x, y, z}, {along_x, along_y, along_z}, shown->seen);
    return returned(found ? std::vector{*found} : std::vector<std::uint32_t>());
}
}
