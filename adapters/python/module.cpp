// SPDX-License-Identifier: BSD-3-Clause
// The Python module kith._kith: meshes and levels as NumPy arrays. The interface for Python users is in
// kith/__init__.py.

#include <kith/compiled_schemes.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_matrix.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/presets.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

using mesh = kith::basic_mesh<>;
using numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Returns a NumPy array that owns the memory of the vector.
template <class T>
py::array_t<T> given_away(std::vector<T> values, std::vector<py::ssize_t> shape = {})
{
    auto* const owned = new std::vector<T>(std::move(values));
    const py::capsule owner(owned, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    if (shape.empty())
        shape = {py::ssize_t(owned->size())};
    return py::array_t<T>(shape, owned->data(), owner);
}

std::vector<std::array<double, 3>> points_of(const numbers& array)
{
    if (array.ndim() != 2 or array.shape(1) != 3)
        throw kith::mesh_error("points are an array of shape (n, 3)");
    std::vector<std::array<double, 3>> result(std::size_t(array.shape(0)));
    if (not result.empty())
        std::memcpy(result.data(), array.data(), result.size() * sizeof(result[0]));
    return result;
}
template <class Points>
py::array_t<double> array_of(const Points& points)
{
    py::array_t<double> result({py::ssize_t(points.size()), py::ssize_t(3)});
    if (points.size() != 0)
        std::memcpy(result.mutable_data(), points.data(), points.size() * sizeof(points[0]));
    return result;
}

/// Returns the faces of a Python object: an array of shape (m, k) for faces of one degree, or a list of sequences for
/// mixed faces.
kith::face_list faces_of(const py::object& faces)
{
    kith::face_list result;
    if (py::isinstance<py::array>(faces)) {
        const indices array(faces);
        if (array.ndim() != 2)
            throw kith::mesh_error("faces are an array of shape (m, k), or a list of faces");
        const auto degree = std::size_t(array.shape(1));
        for (py::ssize_t f = 0; f < array.shape(0); ++f)
            result.push_back(std::span(array.data() + std::size_t(f) * degree, degree));
    } else {
        for (const auto& face : faces)
            result.push_back(face.cast<std::vector<std::int64_t>>());
    }
    return result;
}

/// The options of a scheme, which may be given beside its name.
struct scheme_options {
    std::optional<std::string> like;
    std::optional<int> degree;
    std::optional<double> tension;
    std::vector<std::tuple<std::size_t, std::size_t, double>> sharp_edges; ///< two vertices, sharpness
    std::vector<std::pair<std::size_t, double>> sharp_vertices;
};

template <class Scheme>
kith::mesh_error has_no(const char* choice)
{
    return kith::mesh_error(std::string(kith::scheme_name<Scheme>()) + " has no " + choice);
}

/// Sharpens edges and vertices of the control mesh.
template <class Scheme>
void give_creases(Scheme& scheme, const scheme_options& options, const mesh& control)
{
    if (options.sharp_edges.empty() and options.sharp_vertices.empty())
        return;
    if constexpr (kith::scheme_with_creases<Scheme>) {
        const kith::level_of<mesh> level(control);
        const auto require_vertex = [&](std::size_t v) {
            if (v >= level.vertex_count())
                throw kith::mesh_error("vertex " + std::to_string(v) + " is to be sharp, there are " +
                                       std::to_string(level.vertex_count()));
            return level.vertices()[v];
        };
        const auto require_sharpness = [](const std::string& element, double sharpness) {
            if (not(sharpness >= 0)) // nor a NaN
                throw kith::mesh_error(element + ": its sharpness is " + std::to_string(sharpness) +
                                       "; it must be 0 or more");
        };
        for (const auto& [a, b, sharpness] : options.sharp_edges) {
            const auto edge = index_tuple(require_vertex(a), require_vertex(b));
            if (edge.value == edge.not_incident)
                throw kith::mesh_error("vertices " + std::to_string(a) + " and " + std::to_string(b) +
                                       " are to be joined by a sharp edge; they have no edge");
            require_sharpness("edge " + std::to_string(a) + "-" + std::to_string(b), sharpness);
            scheme.sharpness.sharpen_edge(edge.value, sharpness);
        }
        for (const auto& [v, sharpness] : options.sharp_vertices) {
            const auto vertex = require_vertex(v);
            require_sharpness("vertex " + std::to_string(v), sharpness);
            scheme.sharpness.sharpen_vertex(vertex.index(), sharpness);
        }
    } else {
        throw has_no<Scheme>("creases");
    }
}

template <class Scheme>
Scheme configured(const scheme_options& options, const mesh& control)
{
    Scheme scheme;
    if (options.like) {
        static const std::map<std::string, kith::library> libraries{{"kith", kith::library::kith},
                                                                    {"cgal", kith::library::cgal},
                                                                    {"openmesh", kith::library::openmesh},
                                                                    {"opensubdiv", kith::library::opensubdiv},
                                                                    {"libigl", kith::library::libigl}};
        const auto found = libraries.find(*options.like);
        if (found == libraries.end())
            throw kith::mesh_error("like: '" + *options.like + "' is none of kith, cgal, openmesh, opensubdiv, libigl");
        scheme = kith::like<Scheme>(found->second);
    }
    if (options.degree) {
        if constexpr (requires { scheme.degree; })
            scheme.degree = *options.degree;
        else
            throw has_no<Scheme>("degree");
    }
    if (options.tension) {
        if constexpr (requires { scheme.tension; }) {
            scheme = Scheme{.tension = *options.tension}; // other weights follow from it
            scheme.require_weights();
        } else {
            throw has_no<Scheme>("tension");
        }
    }
    give_creases(scheme, options, control);
    return scheme;
}

/// A hierarchy of any scheme.
class levels {
public:
    virtual ~levels() = default;

    virtual void refine(int n) = 0;
    [[nodiscard]] virtual int depth() const = 0;
    [[nodiscard]] virtual const mesh& at(int level) const = 0;
    [[nodiscard]] virtual py::tuple ancestors(const std::string& kind, int level, int coarser) const = 0;
    [[nodiscard]] virtual kith::subdivision_matrix matrix(int from, int to) const = 0;
    [[nodiscard]] virtual kith::subdivision_matrix limit_matrix(int from, int to) const = 0;
    [[nodiscard]] virtual std::pair<py::array_t<double>, py::array_t<double>> limit(int level) const = 0;
    [[nodiscard]] virtual py::array_t<double> carry(int from, int to, const numbers& values) const = 0;
    virtual void move_points(int level, const numbers& points) = 0;

    [[nodiscard]] py::array_t<double> points(int level) const { return array_of(at(level).points()); }
    /// Returns the faces of a level: an array if they have one degree, else (corners, first corner of each face).
    [[nodiscard]] py::object faces(int level) const
    {
        const mesh& m = at(level);
        std::vector<std::int64_t> corners, first{0};
        corners.reserve(m.corner_count());
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            for (const auto v : m.face(f))
                corners.push_back(v);
            first.push_back(std::int64_t(corners.size()));
        }
        const std::size_t degree = m.face_count() == 0 ? 0 : m.face(0).size();
        bool is_uniform = true;
        for (std::size_t f = 0; f < m.face_count(); ++f)
            is_uniform = is_uniform and m.face(f).size() == degree;
        if (is_uniform)
            return given_away(std::move(corners), {py::ssize_t(m.face_count()), py::ssize_t(degree)});
        return py::make_tuple(given_away(std::move(corners)), given_away(std::move(first)));
    }
    [[nodiscard]] py::array_t<std::int64_t> edges(int level) const
    {
        const kith::level_of<mesh> here(at(level));
        std::vector<std::int64_t> ends;
        for (const auto e : here.edges()) {
            ends.push_back(std::int64_t(e.org().index()));
            ends.push_back(std::int64_t(e.dst().index()));
        }
        return given_away(std::move(ends), {py::ssize_t(here.edge_count()), 2});
    }
};

template <class Scheme>
class levels_of : public levels {
public:
    levels_of(const mesh& control, const scheme_options& options)
        : levels_(prepared(control), configured<Scheme>(options, control))
    {
    }

    void refine(int n) override { levels_.refine(n); }
    [[nodiscard]] int depth() const override { return levels_.depth(); }
    [[nodiscard]] const mesh& at(int level) const override { return levels_[level]; }
    [[nodiscard]] py::tuple ancestors(const std::string& kind, int level, int coarser) const override
    {
        const auto& here = levels_.elements(level);
        if (kind == "vertex")
            return ancestors_of(here.vertices(), level, coarser);
        if (kind == "edge")
            return ancestors_of(here.edges(), level, coarser);
        if (kind == "face")
            return ancestors_of(here.faces(), level, coarser);
        throw kith::mesh_error("kind: '" + kind + "' is none of vertex, edge, face");
    }
    [[nodiscard]] kith::subdivision_matrix matrix(int from, int to) const override { return levels_.matrix(from, to); }
    [[nodiscard]] kith::subdivision_matrix limit_matrix(int from, int to) const override
    {
        return kith::limit_matrix_of(levels_, from, to);
    }
    [[nodiscard]] std::pair<py::array_t<double>, py::array_t<double>> limit(int level) const override
    {
        const auto found = limit_surface_of(levels_, level);
        return {array_of(found.positions), array_of(found.normals)};
    }
    [[nodiscard]] py::array_t<double> carry(int from, int to, const numbers& values) const override
    {
        const auto rows = values.ndim() == 0 ? std::size_t(0) : std::size_t(values.shape(0));
        const auto width = rows == 0 ? std::size_t(1) : std::size_t(values.size()) / rows;
        std::vector<py::ssize_t> shape(values.shape(), values.shape() + values.ndim());
        std::vector<double> column(rows), result;
        for (std::size_t k = 0; k < width; ++k) {
            for (std::size_t i = 0; i < rows; ++i)
                column[i] = values.data()[i * width + k];
            const auto carried = levels_.carry(from, to, std::span<const double>(column));
            result.resize(carried.size() * width);
            for (std::size_t i = 0; i < carried.size(); ++i)
                result[i * width + k] = carried[i];
        }
        if (width == 0) // the number of rows changes all the same
            shape[0] = py::ssize_t(levels_.carry(from, to, std::span<const double>(column)).size());
        else if (not shape.empty())
            shape[0] = py::ssize_t(result.size() / width);
        return given_away(std::move(result), std::move(shape));
    }
    void move_points(int level, const numbers& points) override { levels_.move_points(level, points_of(points)); }

private:
    static mesh prepared(const mesh& control)
    {
        if constexpr (std::same_as<Scheme, kith::four_eight>)
            return kith::tri_quad(control);
        else
            return control;
    }
    /// Returns the ancestor of each element: its kind (0 vertex, 1 edge, 2 face), and its number.
    template <class Elements>
    [[nodiscard]] py::tuple ancestors_of(const Elements& elements, int level, int coarser) const
    {
        std::vector<std::int8_t> kinds;
        std::vector<std::int64_t> found;
        for (const auto x : elements) {
            const auto from = levels_.ancestor(level, x.handle(), coarser);
            kinds.push_back(std::int8_t(from.kind));
            found.push_back(std::int64_t(from.v ? from.v->value : from.e ? from.e->value : from.f->value));
        }
        return py::make_tuple(given_away(std::move(kinds)), given_away(std::move(found)));
    }

    kith::hierarchy<mesh, Scheme> levels_;
};

template <class... Schemes>
struct scheme_list {
    static std::vector<std::string> names() { return {std::string(kith::scheme_name<Schemes>())...}; }

    static std::unique_ptr<levels> make(const std::string& name, const numbers& points, const py::object& faces,
                                        const scheme_options& options)
    {
        std::unique_ptr<levels> result;
        const auto make_if = [&]<class Scheme>(const Scheme*) {
            if (name == kith::scheme_name<Scheme>())
                result = std::make_unique<levels_of<Scheme>>(kith::make_mesh(points_of(points), faces_of(faces)),
                                                             options);
        };
        (make_if(static_cast<const Schemes*>(nullptr)), ...);
        if (result == nullptr) {
            std::string text = "scheme: '" + name + "' is none of";
            for (const auto& known : names())
                text += " " + known;
            throw kith::mesh_error(text);
        }
        return result;
    }
};
template <class... Schemes>
scheme_list<Schemes...> list_of(const std::tuple<Schemes...>*);
using known_schemes = decltype(list_of(static_cast<const kith::all_schemes*>(nullptr)));

/// Returns the arguments of scipy.sparse.csr_matrix: weights, columns, the starts of the rows, and the shape.
py::tuple compressed_rows(kith::subdivision_matrix matrix)
{
    const auto rows = matrix.rows(), columns = matrix.columns;
    return py::make_tuple(given_away(std::move(matrix.weight)),
                          given_away(std::move(matrix.column)),
                          given_away(std::move(matrix.row_start)),
                          py::make_tuple(rows, columns));
}

} // namespace

PYBIND11_MODULE(_kith, module)
{
    py::register_exception<kith::mesh_error>(module, "MeshError", PyExc_ValueError);
    module.attr("schemes") = py::tuple(py::cast(known_schemes::names()));
    py::class_<levels>(module, "Levels")
        .def(py::init([](const numbers& points,
                         const py::object& faces,
                         const std::string& scheme,
                         std::optional<std::string>
                             like,
                         std::optional<int>
                             degree,
                         std::optional<double>
                             tension,
                         std::vector<std::tuple<std::size_t, std::size_t, double>>
                             sharp_edges,
                         std::vector<std::pair<std::size_t, double>>
                             sharp_vertices) {
                 return known_schemes::make(
                     scheme,
                     points,
                     faces,
                     {std::move(like), degree, tension, std::move(sharp_edges), std::move(sharp_vertices)});
             }),
             py::arg("points"),
             py::arg("faces"),
             py::arg("scheme"),
             py::arg("like"),
             py::arg("degree"),
             py::arg("tension"),
             py::arg("sharp_edges"),
             py::arg("sharp_vertices"))
        .def("refine", &levels::refine, py::call_guard<py::gil_scoped_release>())
        .def("depth", &levels::depth)
        .def("points", &levels::points)
        .def("faces", &levels::faces)
        .def("edges", &levels::edges)
        .def("ancestors", &levels::ancestors)
        .def("carry", &levels::carry)
        .def("limit", &levels::limit)
        .def("move_points", &levels::move_points)
        .def("matrix", [](const levels& l, int from, int to) { return compressed_rows(l.matrix(from, to)); })
        .def("limit_matrix",
             [](const levels& l, int from, int to) { return compressed_rows(l.limit_matrix(from, to)); });
}
