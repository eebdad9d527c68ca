// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "write_in_place.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/in_place/carried_properties.hpp>
#include <kith/in_place/refine_in_place.hpp>
#include <kith/in_place/split_with_creases.hpp>
#include <kith/linear.hpp>
#include <kith/openmesh_properties.hpp>

#include <OpenMesh/Tools/Subdivider/Uniform/SubdividerT.hh>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::openmesh {

/// A mesh of OpenMesh that can be read, overwritten in bulk, and asked for its properties.
template <class M>
concept subdividable_mesh = std::derived_from<M, OpenMesh::PolyConnectivity> and fillable_mesh<M> and
                            mesh_with_properties<M>;

namespace detail {

/// The normals of faces, requested for as long as it lives, where other normals need them.
template <class Mesh>
class needed_face_normals {
public:
    explicit needed_face_normals(Mesh& mesh)
        : mesh_((mesh.has_vertex_normals() or mesh.has_halfedge_normals()) and not mesh.has_face_normals() ? &mesh
                                                                                                           : nullptr)
    {
        if (mesh_ != nullptr)
            mesh_->request_face_normals();
    }
    needed_face_normals(const needed_face_normals&) = delete;
    needed_face_normals& operator=(const needed_face_normals&) = delete;
    ~needed_face_normals()
    {
        if (mesh_ != nullptr)
            mesh_->release_face_normals();
    }

private:
    Mesh* mesh_;
};

} // namespace detail

/// A subdivider as OpenMesh's are, and derived from their base class, by any scheme of kith's or of one's own:
/// attach(mesh), operator()(n), detach(), or operator()(mesh, n), in place. Old vertices keep their handles and come
/// before the new ones, in schemes that have a vertex for each; edges and faces are others. Attributes, status bits and
/// properties go along by the rules of `carry_properties`; normals are made anew. Values of types that kith does not
/// know, such as items of the traits, are copied from the parent on faces, edges and half-edges along old ones; old
/// vertices keep theirs. A mesh without faces stays as it is, and so do isolated vertices where old vertices stay.
/// As with OpenMesh the steps of sqrt(3) are counted from attach() on.
/// After an exception the mesh is as it was, also when memory ends, but for normals of half-edges, which OpenMesh makes.
template <subdividable_mesh Mesh, scheme Scheme, class RealType = double>
class subdivider : public OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType> {
    static constexpr bool fits = needs_triangles<Scheme> or not std::derived_from<Mesh, OpenMesh::TriConnectivity>;
    static_assert(
        fits, "kith::openmesh: a TriMesh holds triangles only and this scheme makes other faces; use a PolyMesh, or a "
              "scheme of triangles such as LoopT");

public:
    using parent_t = OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, RealType>;
    using mesh_t = Mesh;
    using real_t = RealType;
    /// Is told after each level how much of the work is done, and says whether to go on; if not, the mesh stays as it
    /// is.
    using progress_function = std::function<bool(double)>;

    explicit subdivider(Scheme scheme = {}) : scheme_(std::move(scheme)) {}
    explicit subdivider(Mesh& mesh, Scheme scheme = {}) : scheme_(std::move(scheme)) { attach(mesh); }
    subdivider(const subdivider&) = delete;
    subdivider& operator=(const subdivider&) = delete;
    ~subdivider() override { detach(); }

    [[nodiscard]] const char* name() const override
    {
        static const std::string with_end(scheme_name<Scheme>());
        return with_end.c_str();
    }
    /// Its options, creases among them. Those of an attached mesh become those of the refined one.
    [[nodiscard]] Scheme& scheme() { return scheme_; }
    void on_progress(progress_function progress) { progress_ = std::move(progress); }
    /// The properties that the last refinement carried, and those it left out with the reason.
    [[nodiscard]] const property_report& report() const { return report_; }

    /// For what follows, until detach(). Returns true.
    bool attach(Mesh& mesh) { return parent_t::attach(mesh); }
    /// The scheme remains that of the refined mesh.
    void detach()
    {
        keeps_scheme_ = true;
        parent_t::detach();
        keeps_scheme_ = false;
    }

    /// Refines the attached mesh n times. Where points are not to be updated, old vertices do not move, on any level.
    /// Returns false if no mesh is attached or progress said so. Errors: as kith::refine; the mesh is as it was then.
    bool operator()(std::size_t n, bool update_points = true) { return parent_t::operator()(n, update_points); }
    /// The same of another mesh, by a copy of the scheme. More arguments say how properties go:
    /// kith::by_rule<handle, type>(name, rule), kith::value_types<type...>().
    template <class... Argument>
    bool operator()(Mesh& mesh, std::size_t n, bool update_points = true, const Argument&... arguments)
    {
        Scheme copy = scheme_;
        return refine(mesh, copy, 0, n, update_points, arguments...);
    }

protected:
    // What the base class calls, which does not tell an attached mesh from one that is refined in one call: the first
    // mesh counts as attached, with its generation and creases.
    bool prepare(Mesh& mesh) override
    {
        if (attached_ == nullptr or has_failed_) {
            attached_ = &mesh;
            generation_ = 0;
            before_ = scheme_;
            has_failed_ = false;
        }
        return true;
    }
    bool subdivide(Mesh& mesh, std::size_t n, const bool update_points = true) override
    {
        if (&mesh != attached_) {
            Scheme copy = scheme_;
            return refine(mesh, copy, 0, n, update_points);
        }
        has_failed_ = true;
        const bool is_done = refine(mesh, scheme_, generation_, n, update_points);
        has_failed_ = false;
        if (is_done)
            generation_ = (generation_ + int(n % 2)) % 2;
        return is_done;
    }
    bool cleanup(Mesh& mesh) override
    {
        if (&mesh == attached_) {
            attached_ = nullptr;
            if (not keeps_scheme_)
                scheme_ = std::move(*before_);
            before_.reset();
        }
        return true;
    }

private:
    using scalar = typename Mesh::Scalar;
    using view = kernel_view<scalar>;
    using point = typename view::point;

    template <class... Argument>
    bool refine(Mesh& mesh, Scheme& used, int generation, std::size_t n, bool update_points,
                const Argument&... arguments)
    {
        if constexpr (std::same_as<Scheme, catmull_clark>)
            if (not update_points) {
                in_place::split_with_creases<linear> split{used.sharpness};
                const bool done = refine_by(split, mesh, generation, n, true, arguments...);
                used.sharpness = split.sharpness;
                return done;
            }
        return refine_by(used, mesh, generation, n, update_points, arguments...);
    }
    template <kith::scheme Used, class... Argument>
    bool refine_by(Used& used, Mesh& mesh, int generation, std::size_t n, bool update_points,
                   const Argument&... arguments)
    {
        report_ = {};
        if (n == 0 or mesh.faces_sbegin() == mesh.faces_end())
            return true;
        if (n > std::size_t(std::numeric_limits<int>::max()))
            throw mesh_error("OpenMesh's meshes cannot hold so many levels; refine fewer times");
        std::vector<point> copies; // where the mesh has points of another kind
        view all(mesh, points_of(mesh, copies), empty_items(mesh));
        auto control = lift_valid(all); // before its properties, as it looks whether this is a mesh
        control = {storage<point>(control.points()), control.topology(), generation};
        in_place::require_faces(all, control, used);
        in_place::carried_properties<view, Argument...> carried(all, {}, arguments...);
        Used next = used;
        const auto go_on = [&](double done) { return not progress_ or progress_(done); };
        const auto fine = in_place::refine(
            std::move(control), next, int(n), carried.values(), not update_points, go_on);
        if (not fine)
            return false;
        property_report report = carried.report(numbering_of<Used, std::uint32_t>::has_edges);
        const detail::needed_face_normals normals(mesh);
        {
            mesh_writer writer(
                mesh, Mesh::is_trimesh(), fine->mesh.topology(), fine->keeps_vertices, not carried.empty());
            if (not carried.empty()) {
                carried.stage(all, writer.places());
                carried.commit(writer.places());
            }
            writer.commit();
            for (std::size_t v = 0; v < fine->mesh.vertex_count(); ++v) {
                const point& p = fine->mesh.point(v);
                mesh.set_point(writer.vertex_at(v), typename Mesh::Point(p[0], p[1], p[2]));
            }
        }
        used = std::move(next);
        report_ = std::move(report);
        mesh.update_normals(); // those that were requested
        return true;
    }
    static const point* points_of(const Mesh& mesh, std::vector<point>& copies)
    {
        if constexpr (std::same_as<typename native_point<typename Mesh::Point>::type, point>) {
            return reinterpret_cast<const point*>(mesh.points());
        } else {
            for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
                const auto& p = mesh.point(OpenMesh::VertexHandle(int(v)));
                copies.push_back({p[0], p[1], p[2]});
            }
            return copies.data();
        }
    }
    /// What the traits of most meshes say of elements: nothing.
    static std::vector<const OpenMesh::BaseProperty*> empty_items(const Mesh& mesh)
    {
        std::vector<const OpenMesh::BaseProperty*> result;
        const auto look = [&]<class Handle, class Data>(Handle, std::type_identity<Data>) {
            if constexpr (std::is_empty_v<Data>)
                kith::detail::for_each_property<Handle>(mesh, [&](const OpenMesh::BaseProperty* p) {
                    if (dynamic_cast<const OpenMesh::PropertyT<Data>*>(p) != nullptr)
                        result.push_back(p);
                });
        };
        look(OpenMesh::VertexHandle(), std::type_identity<typename Mesh::VertexData>());
        look(OpenMesh::HalfedgeHandle(), std::type_identity<typename Mesh::HalfedgeData>());
        look(OpenMesh::EdgeHandle(), std::type_identity<typename Mesh::EdgeData>());
        look(OpenMesh::FaceHandle(), std::type_identity<typename Mesh::FaceData>());
        return result;
    }

    Scheme scheme_;
    std::optional<Scheme> before_; ///< the scheme when the mesh was attached
    Mesh* attached_ = nullptr;
    int generation_ = 0; ///< of the attached mesh, as far as it matters
    bool keeps_scheme_ = false, has_failed_ = false;
    progress_function progress_;
    property_report report_;
};

} // namespace kith::openmesh
