// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/catmull_clark.hpp>
#include <kith/cgal.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/loop.hpp>
#include <kith/polygon_soup.hpp>
#include <kith/presets.hpp>
#include <kith/sqrt3.hpp>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/version.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kith::comparison {

/// CGAL's Subdivision_method_3 with doubles, on Surface_mesh by default.
struct cgal_peer {
    using point = CGAL::Simple_cartesian<double>::Point_3;
    using mesh = CGAL::Surface_mesh<point>;

    static constexpr library conventions = library::cgal;
    static std::string version() { return "CGAL " CGAL_VERSION_STR; }

    /// Makes the mesh with CGAL's own functions, not with kith's adapter. Returns no mesh if CGAL finds that the faces
    /// are not a manifold.
    template <class Mesh = mesh>
    static std::optional<Mesh> make(const basic_mesh<>& native)
    {
        namespace processing = CGAL::Polygon_mesh_processing;
        std::vector<std::vector<std::size_t>> faces;
        for (std::size_t f = 0; f < native.face_count(); ++f)
            faces.emplace_back(native.face(f).begin(), native.face(f).end());
        if (not processing::is_polygon_soup_a_polygon_mesh(faces))
            return std::nullopt;
        std::vector<point> points;
        for (const auto& [x, y, z] : native.points())
            points.emplace_back(x, y, z);
        Mesh result;
        processing::polygon_soup_to_polygon_mesh(points, faces, result);
        return result;
    }

    static io::polygon_soup soup(const mesh& m)
    {
        io::polygon_soup result;
        std::vector<std::size_t> number(m.num_vertices()); // Doo-Sabin leaves removed vertices
        for (const auto v : m.vertices()) {
            number[v] = result.points.size();
            result.points.push_back({m.point(v).x(), m.point(v).y(), m.point(v).z()});
        }
        std::vector<std::size_t> face;
        for (const auto f : m.faces()) {
            face.clear();
            for (const auto v : m.vertices_around_face(m.halfedge(f)))
                face.push_back(number[v]);
            result.faces.push_back(face);
        }
        return result;
    }

    template <class Mesh>
    static void refine(Mesh& m, const catmull_clark&, int levels)
    {
        CGAL::Subdivision_method_3::CatmullClark_subdivision(m, CGAL::parameters::number_of_iterations(levels));
    }
    template <class Mesh>
    static void refine(Mesh& m, const loop&, int levels)
    {
        CGAL::Subdivision_method_3::Loop_subdivision(m, CGAL::parameters::number_of_iterations(levels));
    }
    template <class Mesh>
    static void refine(Mesh& m, const doo_sabin&, int levels)
    {
        CGAL::Subdivision_method_3::DooSabin_subdivision(m, CGAL::parameters::number_of_iterations(levels));
    }
    template <class Mesh>
    static void refine(Mesh& m, const sqrt3&, int levels)
    {
        CGAL::Subdivision_method_3::Sqrt3_subdivision(m, CGAL::parameters::number_of_iterations(levels));
    }
};

} // namespace kith::comparison
