// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "overwritten_mesh.hpp"

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

/// A subdivider with the interface and the base class of OpenMesh's subdividers, by any scheme of kith or of the
/// caller. It refines in place: attach(mesh), operator()(n), detach(); or operator()(mesh, n). In schemes with a vertex
/// for each old vertex, old vertices keep their handles and come before the new ones. Edges and faces are replaced.
/// Attributes, status bits and properties are carried by the rules of `carry_properties`; normals are recomputed.
/// Values of unknown types, such as items of the traits, are copied from the parent to faces, and to edges and
/// half-edges along old ones. Old vertices keep such values. A mesh without faces is not changed; isolated vertices
/// stay if old vertices stay. As in OpenMesh, the steps of sqrt(3) are counted from attach() on.
/// After an exception, also when memory runs out, the mesh is unchanged, except where OpenMesh computes normals of
/// half-edges.
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
    /// A function that is called after each level with the share of the work done. If it returns false, the refinement
    /// stops and the mesh is not changed.
    using progress_function = std::function<bool(double)>;

    explicit subdivider(Scheme scheme = Scheme()) : scheme_(std::move(scheme)) {}
    explicit subdivider(Mesh& mesh, Scheme scheme = Scheme()) : scheme_(std::move(scheme)) { attach(mesh); }
    subdivider(const subdivider&) = delete;
    subdivider& operator=(const subdivider&) = delete;
    ~subdivider() override { detach(); }

    [[nodiscard]] const char* name() const override
    {
        static const std::string with_end(scheme_name<Scheme>());
        return with_end.c_str();
    }
    /// Returns the scheme with its options, among them creases. Refining an attached mesh turns them into those of the
    /// refined mesh.
    [[nodiscard]] Scheme& scheme() { return scheme_; }
    void on_progress(progress_function progress) { progress_ = std::move(progress); }
    /// Returns which properties the last refinement carried, and which it left out, with the reason.
    [[nodiscard]] const property_report& report() const { return report_; }

    /// Attaches a mesh, which operator()(n) refines until detach(). Returns true.
    bool attach(Mesh& mesh) { return parent_t::attach(mesh); }
    /// Detaches the mesh. The scheme remains that of the refined mesh.
    void detach()
    {
        keeps_scheme_ = true;
        parent_t::detach();
        keeps_scheme_ = false;
    }

    /// Refines the attached mesh n times. If `update_points` is false, old vertices do not move, on any level. Returns
    /// false if no mesh is attached or the progress function stopped the refinement. Errors: as kith::refine; the mesh
    /// is then unchanged. One exception: OpenMesh computes requested normals last; if memory runs out there, the mesh
    /// is already refined.
    bool operator()(std::size_t n, bool update_points = true) { return parent_t::operator()(n, update_points); }
    /// Refines another mesh in the same way, by a copy of the scheme. Further arguments set how properties are carried:
    /// kith::by_rule<handle, type>(name, rule), kith::value_types<type...>().
    template <class... Argument>
    bool operator()(Mesh& mesh, std::size_t n, bool update_points = true, const Argument&... arguments)
    {
        Scheme copy = scheme_;
        return refine(mesh, copy, 0, n, update_points, arguments...);
    }

protected:
    // The base class calls these three. It does not tell an attached mesh from a mesh that is refined in one call: the
    // first mesh counts as attached, with its generation and creases.
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
    using view = typename overwritten_mesh<Mesh>::view_type;
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
        overwritten_mesh<Mesh> whole(mesh);
        auto& all = whole.view();
        auto control = to_native_valid(all); // before its properties, as it checks that this is a mesh
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
        whole.overwrite(*fine, carried);
        used = std::move(next);
        report_ = std::move(report);
        whole.make_normals();
        return true;
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
