// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "write_in_place.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/in_place/carried_properties.hpp>
#include <kith/in_place/refine_in_place.hpp>
#include <kith/in_place/split_with_creases.hpp>
#include <kith/linear.hpp>
#include <kith/openmesh_properties.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace kith::openmesh {

/// A mesh of OpenMesh that can be read, overwritten in bulk, and asked for its properties.
template <class M>
concept subdividable_mesh = std::derived_from<M, OpenMesh::PolyConnectivity> and fillable_mesh<M> and
                            mesh_with_properties<M>;

/// A subdivider as OpenMesh's are, by any scheme of kith's or of one's own: attach(mesh), operator()(n), detach(), or
/// operator()(mesh, n), in place. Old vertices keep their handles and come before the new ones, in schemes that have a
/// vertex for each; edges and faces are others. Attributes, status bits and properties with names go along by the rules
/// of `carry_properties`; normals are made anew.
/// As with OpenMesh the steps of sqrt(3) are counted from attach() on.
template <subdividable_mesh Mesh, scheme Scheme>
class subdivider {
    static constexpr bool fits = needs_triangles<Scheme> or not std::derived_from<Mesh, OpenMesh::TriConnectivity>;
    static_assert(
        fits, "kith::openmesh: a TriMesh holds triangles only and this scheme makes other faces; use a PolyMesh, or a "
              "scheme of triangles such as LoopT");

public:
    using mesh_t = Mesh;
    /// Is told after each level how much of the work is done, and says whether to go on; if not, the mesh stays as it
    /// is.
    using progress_function = std::function<bool(double)>;

    explicit subdivider(Scheme scheme = {}) : scheme_(std::move(scheme)) {}
    explicit subdivider(Mesh& mesh, Scheme scheme = {}) : scheme_(std::move(scheme)) { attach(mesh); }
    subdivider(const subdivider&) = delete;
    subdivider& operator=(const subdivider&) = delete;

    [[nodiscard]] const char* name() const
    {
        static const std::string with_end(scheme_name<Scheme>());
        return with_end.c_str();
    }
    /// Its options, creases among them. Those of an attached mesh become those of the refined one.
    [[nodiscard]] Scheme& scheme() { return scheme_; }
    void on_progress(progress_function progress) { progress_ = std::move(progress); }

    /// For what follows, until detach(). Returns true.
    bool attach(Mesh& mesh)
    {
        if (attached_ != &mesh)
            generation_ = 0;
        attached_ = &mesh;
        return true;
    }
    void detach() { attached_ = nullptr; }

    /// Refines the attached mesh n times. Where points are not to be updated, old vertices do not move, on any level.
    /// Returns false if no mesh is attached or progress said so. Errors: as kith::refine; the mesh is as it was then.
    bool operator()(std::size_t n, bool update_points = true)
    {
        if (attached_ == nullptr or not refine(*attached_, scheme_, generation_, n, update_points))
            return false;
        generation_ = (generation_ + int(n % 2)) % 2;
        return true;
    }
    /// The same of another mesh, by a copy of the scheme.
    bool operator()(Mesh& mesh, std::size_t n, bool update_points = true)
    {
        Scheme copy = scheme_;
        return refine(mesh, copy, 0, n, update_points);
    }

private:
    using scalar = typename Mesh::Scalar;
    using point = std::array<scalar, 3>;

    bool refine(Mesh& mesh, Scheme& used, int generation, std::size_t n, bool update_points) const
    {
        if constexpr (std::same_as<Scheme, catmull_clark>)
            if (not update_points) {
                in_place::split_with_creases<linear> split{used.sharpness};
                const bool done = refine_by(split, mesh, generation, n, true);
                used.sharpness = split.sharpness;
                return done;
            }
        return refine_by(used, mesh, generation, n, update_points);
    }
    template <kith::scheme Used>
    bool refine_by(Used& used, Mesh& mesh, int generation, std::size_t n, bool update_points) const
    {
        if (n == 0)
            return true;
        if (n > std::size_t(std::numeric_limits<int>::max()))
            throw mesh_error("OpenMesh's meshes cannot hold so many levels; refine fewer times");
        auto control = read(mesh, generation); // before its properties, as it looks whether this is a mesh
        in_place::require_faces(mesh, control, used);
        in_place::carried_properties<Mesh> carried(mesh);
        Used next = used;
        const auto go_on = [&](double done) { return not progress_ or progress_(done); };
        const auto fine = in_place::refine(
            std::move(control), next, int(n), carried.values(), not update_points, go_on);
        if (not fine)
            return false;
        write_connectivity(mesh, fine->mesh.topology(), fine->keeps_vertices);
        carried.write(mesh);
        std::size_t i = 0;
        for (const auto v : mesh_traits<Mesh>::vertices(mesh)) {
            const point& p = fine->mesh.point(i++);
            mesh.set_point(v, typename Mesh::Point(p[0], p[1], p[2]));
        }
        make_normals(mesh);
        used = std::move(next);
        return true;
    }
    /// Those that were requested, which follow from those of faces.
    static void make_normals(Mesh& mesh)
    {
        const bool has_those_of_faces = mesh.has_face_normals();
        const bool needs_them = mesh.has_vertex_normals() or mesh.has_halfedge_normals();
        if (needs_them and not has_those_of_faces)
            mesh.request_face_normals();
        mesh.update_normals();
        if (needs_them and not has_those_of_faces)
            mesh.release_face_normals();
    }
    static in_place::native_mesh<point> read(const Mesh& mesh, int generation)
    {
        const auto control = lift_valid(mesh);
        storage<point> points(control.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = {control.point(v)[0], control.point(v)[1], control.point(v)[2]};
        return {std::move(points), control.topology(), generation};
    }

    Scheme scheme_;
    Mesh* attached_ = nullptr;
    int generation_ = 0; ///< of the attached mesh, as far as it matters
    progress_function progress_;
};

} // namespace kith::openmesh
