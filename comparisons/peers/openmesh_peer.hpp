// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/interpolatory_sqrt3.hpp>
#include <kith/loop.hpp>
#include <kith/mid_edge.hpp>
#include <kith/openmesh.hpp>
#include <kith/polygon_soup.hpp>
#include <kith/presets.hpp>
#include <kith/sqrt3.hpp>

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/MidpointT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3InterpolatingSubdividerLabsikGreinerT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
// The next header is not self-contained: it needs the mesh headers above it.
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace kith::comparison {

struct openmesh_doubles : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};

/// OpenMesh's uniform subdividers on one of its mesh types, with doubles.
template <class Mesh>
struct openmesh_peer {
    using mesh = Mesh;

    static constexpr library conventions = library::openmesh;
    static std::string version() { return "OpenMesh 9"; }

    /// Makes the mesh with OpenMesh's own functions, not with kith's adapter. Returns no mesh if OpenMesh refuses a
    /// face.
    static std::optional<mesh> make(const basic_mesh<>& native)
    {
        mesh result;
        for (const auto& [x, y, z] : native.points())
            result.add_vertex({x, y, z});
        std::vector<OpenMesh::VertexHandle> face;
        for (std::size_t f = 0; f < native.face_count(); ++f) {
            face.clear();
            for (const std::size_t v : native.face(f))
                face.push_back(OpenMesh::VertexHandle(int(v)));
            if (not result.add_face(face).is_valid())
                return std::nullopt;
        }
        return result;
    }

    static io::polygon_soup soup(const mesh& m)
    {
        io::polygon_soup result;
        for (const auto v : m.vertices())
            result.points.push_back({m.point(v)[0], m.point(v)[1], m.point(v)[2]});
        std::vector<std::size_t> face;
        for (const auto f : m.faces()) {
            face.clear();
            for (const auto v : m.fv_ccw_range(f))
                face.push_back(std::size_t(v.idx()));
            result.faces.push_back(face);
        }
        return result;
    }

    static void refine(mesh& m, const catmull_clark&, int levels)
    {
        run(OpenMesh::Subdivider::Uniform::CatmullClarkT<mesh, double>(), m, levels);
    }
    static void refine(mesh& m, const mid_edge&, int levels)
    {
        run(OpenMesh::Subdivider::Uniform::MidpointT<mesh, double>(), m, levels);
    }
    static void refine(mesh& m, const butterfly&, int levels)
    {
        run(OpenMesh::Subdivider::Uniform::ModifiedButterflyT<mesh, double>(), m, levels);
    }
    static void refine(mesh& m, const loop&, int levels)
    {
        run_with_weights(OpenMesh::Subdivider::Uniform::LoopT<mesh, double>(), m, levels);
    }
    static void refine(mesh& m, const sqrt3&, int levels)
    {
        run_with_weights(OpenMesh::Subdivider::Uniform::Sqrt3T<mesh, double>(), m, levels);
    }
    static void refine(mesh& m, const interpolatory_sqrt3&, int levels)
    {
        run_with_weights(OpenMesh::Subdivider::Uniform::InterpolatingSqrt3LGT<mesh, double>(), m, levels);
    }

private:
    template <class Subdivider>
    static void run(Subdivider&& subdivider, mesh& m, int levels)
    {
        if (not subdivider(m, std::size_t(levels)))
            throw std::runtime_error("OpenMesh did not refine");
    }
    /// Runs a subdivider that keeps a table of weights by valence. The default table ends at valence 49, and OpenMesh
    /// reads past its end without an error; so this function makes a table that is large enough.
    template <class Subdivider>
    static void run_with_weights(Subdivider&& subdivider, mesh& m, int levels)
    {
        std::size_t valence = 49;
        for (const auto v : m.vertices())
            valence = std::max<std::size_t>(valence, m.valence(v));
        subdivider.init_weights(valence + 1);
        run(subdivider, m, levels);
    }
};

} // namespace kith::comparison
