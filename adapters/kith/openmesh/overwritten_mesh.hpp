// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "write_in_place.hpp"

#include <kith/in_place/refine_in_place.hpp>
#include <kith/openmesh_properties.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace kith {

/// The access to all properties of a mesh, for callers that overwrite it. Values of any type can be copied.
template <class Scalar>
struct property_access<openmesh::kernel_view<Scalar>> : detail::openmesh_properties {
    using mesh = openmesh::kernel_view<Scalar>;

    static OpenMesh::BaseKernel& base_of(mesh& m) { return m.mesh(); }
    static const OpenMesh::BaseKernel& base_of(const mesh& m) { return m.mesh(); }
    template <class Handle>
    static std::vector<std::string> names(const mesh& m)
    {
        std::vector<std::string> result;
        detail::for_each_property<Handle>(m.mesh(), [&](const OpenMesh::BaseProperty* p) {
            if (not is_reserved(p->name()) and not m.is_hidden(p))
                result.push_back(p->name());
        });
        return result;
    }
    template <class Handle, class T>
    static auto find(const mesh& m, const std::string& name)
    {
        return property_access<base>::find<Handle, T>(m.mesh(), name);
    }
    template <class Handle, class T>
    static auto add(mesh& m, const std::string& name)
    {
        return property_access<base>::add<Handle, T>(m.mesh(), name);
    }
    template <class Handle>
    static std::vector<detail::any_property> other_properties(mesh& m, const std::vector<detail::known_property>& known)
    {
        std::vector<detail::any_property> result;
        detail::for_each_property<Handle>(m.mesh(), [&](OpenMesh::BaseProperty* p) {
            if (is_reserved(p->name()) or follows_from_points(p->name()) or m.is_hidden(p) or
                std::ranges::find(known, static_cast<const void*>(p), &detail::known_property::array) != known.end())
                return;
            const auto copy = [](void* a, std::size_t from, std::size_t to) {
                static_cast<OpenMesh::BaseProperty*>(a)->copy(from, to);
            };
            const auto swap = [](void* a, std::size_t x, std::size_t y) {
                static_cast<OpenMesh::BaseProperty*>(a)->swap(x, y);
            };
            result.push_back({p->name(), p, copy, swap});
        });
        return result;
    }
    template <class Handle>
    static std::string standard_name(standard_property)
    {
        return "";
    }
    template <standard_property>
    using standard_type = void;
};

} // namespace kith

namespace kith::openmesh {

/// A mesh of OpenMesh that can be read, overwritten in bulk, and asked for its properties.
template <class M>
concept subdividable_mesh = std::derived_from<M, OpenMesh::PolyConnectivity> and fillable_mesh<M> and
                            mesh_with_properties<M>;

namespace detail {

/// A guard that requests the normals of faces for its lifetime, if other normals need them.
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

/// A mesh that is read through a view and then overwritten.
template <subdividable_mesh Mesh>
class overwritten_mesh {
    using scalar = typename Mesh::Scalar;

public:
    using view_type = kernel_view<scalar>;
    using point = typename view_type::point;

    explicit overwritten_mesh(Mesh& mesh) : mesh_(&mesh), view_(mesh, points_of(mesh, copies_), empty_items(mesh)) {}
    overwritten_mesh(const overwritten_mesh&) = delete;
    overwritten_mesh& operator=(const overwritten_mesh&) = delete;

    [[nodiscard]] view_type& view() { return view_; }

    /// Overwrites the mesh with these elements and the values that were carried. After an exception the mesh is
    /// unchanged. Errors: those of mesh_writer. Cost: O(elements), and the same for each property.
    template <class Carried>
    void overwrite(const in_place::refined<point>& fine, Carried& carried)
    {
        normals_.emplace(*mesh_);
        mesh_writer writer(*mesh_, Mesh::is_trimesh(), fine.mesh.topology(), fine.keeps_vertices, not carried.empty());
        if (not carried.empty()) {
            carried.stage(view_, writer.places());
            carried.commit(writer.places());
        }
        writer.commit();
        for (std::size_t v = 0; v < fine.mesh.vertex_count(); ++v) {
            const point& p = fine.mesh.point(v);
            mesh_->set_point(writer.vertex_at(v), typename Mesh::Point(p[0], p[1], p[2]));
        }
    }
    /// Recomputes the requested normals. Precondition: the mesh was overwritten.
    void make_normals() { mesh_->update_normals(); }

private:
    /// Returns the points as arrays. If the mesh has points of another type, the arrays are in `copies`.
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
    /// Returns the properties of the element data that the traits leave empty, as most traits do.
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

    Mesh* mesh_;
    std::vector<point> copies_;
    view_type view_;
    std::optional<detail::needed_face_normals<Mesh>> normals_;
};

} // namespace kith::openmesh
