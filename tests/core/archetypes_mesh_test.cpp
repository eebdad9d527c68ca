// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/archetypes.hpp"
#include "support/same_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/level/validate.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine.hpp>
#include <kith/tiles/number/corners_at_vertices.hpp>
#include <kith/tiles/number/global_numbering.hpp>
#include <kith/tiles/part/check_tile.hpp>
#include <kith/tiles/part/tile_like.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace archetypes {

/// A point type that has only a specialization of kith::affine.
struct place {
    double x, y, z;
};

/// A mesh with a distinct handle type for each kind of element.
class mesh {
public:
    template <class Kind>
    struct name {
        std::size_t number = 0;
        friend bool operator==(const name&, const name&) = default;
    };
    using vertex = name<struct vertex_kind>;
    using edge = name<struct edge_kind>;
    using face = name<struct face_kind>;
    using halfedge = name<struct halfedge_kind>;

    explicit mesh(const kith::basic_mesh<place, std::uint32_t>& native) : native_(native) {}
    mesh(mesh&&) = default;
    mesh& operator=(mesh&&) = delete;

    friend const auto& native_of(const mesh& m) { return m.native_; }

private:
    kith::basic_mesh<place, std::uint32_t> native_;
};

/// A range that, like views::filter, can be iterated only once and only if it is not const.
template <class Handle>
class once {
public:
    class iterator {
    public:
        using value_type = Handle;
        using difference_type = std::ptrdiff_t;
        explicit iterator(std::size_t i) : i_(i) {}
        iterator(iterator&&) = default;
        iterator& operator=(iterator&&) = default;
        Handle operator*() const { return {i_}; }
        iterator& operator++() { return ++i_, *this; }
        void operator++(int) { ++i_; }
        friend bool operator==(const iterator& i, std::size_t end) { return i.i_ == end; }

    private:
        std::size_t i_;
    };
    explicit once(std::size_t size) : size_(size) {}
    [[nodiscard]] iterator begin() { return iterator(0); }
    [[nodiscard]] std::size_t end() { return size_; }

private:
    std::size_t size_;
};

} // namespace archetypes

template <>
struct kith::affine<archetypes::place> : kith::coordinates_affine<double, 3> {
    static sum load(const archetypes::place& p) { return {p.x, p.y, p.z}; }
    static archetypes::place store(const sum& s) { return {s[0], s[1], s[2]}; }
};

template <>
struct kith::mesh_traits<archetypes::mesh> {
    using mesh = archetypes::mesh;
    using vertex = mesh::vertex;
    using edge = mesh::edge;
    using face = mesh::face;
    using halfedge = mesh::halfedge;
    using point = archetypes::place;

    static const auto& topology(const mesh& m) { return native_of(m).topology(); }
    static std::size_t corner(const mesh& m, halfedge h) { return topology(m).halfedge_corner[h.number]; }
    static halfedge of_corner(const mesh& m, std::size_t c) { return {topology(m).corner_halfedge[c]}; }

    static auto vertices(const mesh& m) { return archetypes::once<vertex>(topology(m).vertices); }
    static auto edges(const mesh& m) { return archetypes::once<edge>(topology(m).edges()); }
    static auto faces(const mesh& m) { return archetypes::once<face>(topology(m).faces); }
    static std::size_t index(const mesh&, const auto& x) { return x.number; }
    static std::size_t vertex_bound(const mesh& m) { return topology(m).vertices; }
    static std::size_t edge_bound(const mesh& m) { return topology(m).edges(); }
    static std::size_t face_bound(const mesh& m) { return topology(m).faces; }
    static std::size_t halfedge_bound(const mesh& m) { return 2 * topology(m).edges(); }
    static halfedge next(const mesh& m, halfedge h)
    {
        return of_corner(m, topology(m).next(std::uint32_t(corner(m, h))));
    }
    static halfedge prev(const mesh& m, halfedge h)
    {
        return of_corner(m, topology(m).prev(std::uint32_t(corner(m, h))));
    }
    static halfedge opposite(const mesh&, halfedge h) { return {h.number ^ 1}; }
    static bool is_boundary(const mesh& m, halfedge h) { return corner(m, h) == topology(m).none; }
    static vertex source(const mesh& m, halfedge h)
    {
        return is_boundary(m, h) ? source(m, next(m, opposite(m, h))) : vertex{topology(m).corner_vertex[corner(m, h)]};
    }
    static edge edge_of(const mesh&, halfedge h) { return {h.number / 2}; }
    static face face_of(const mesh& m, halfedge h) { return {topology(m).face_of(std::uint32_t(corner(m, h)))}; }
    static halfedge halfedge_of(const mesh& m, vertex v) { return of_corner(m, topology(m).vertex_corner[v.number]); }
    static halfedge halfedge_of(const mesh&, edge e) { return {2 * e.number}; }
    static halfedge halfedge_of(const mesh& m, face f) { return of_corner(m, topology(m).first_corner(f.number)); }
    static bool is_isolated(const mesh&, vertex) { return false; }
    static point point_of(const mesh& m, vertex v) { return native_of(m).points()[v.number]; }
    static mesh build(kith::basic_mesh<point, std::uint32_t>&& fine) { return mesh(fine); }
};

namespace archetypes {

/// A read-only array.
template <class T>
class array : stays {
public:
    explicit array(const auto& values) : values_(values.begin(), values.end()) {}
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + size(); }
    [[nodiscard]] const T* data() const { return values_.data(); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool empty() const { return values_.empty(); }
    const T& operator[](std::size_t i) const { return values_[i]; }

private:
    std::vector<T> values_;
};

/// A tile that has the contents of a kith::tile.
class tile : stays {
    using known = kith::tile<shapes::point>;

public:
    using point_type = shapes::point;
    using index_type = std::uint32_t;

    explicit tile(const known& t)
        : mesh(t.mesh)
        , vertex_ids(t.vertex_ids)
        , edge_ids(t.edge_ids)
        , face_ids(t.face_ids)
        , first_corner_ids(t.first_corner_ids)
        , corners_before(t.corners_before)
        , marked_before(t.marked_before)
        , roots(t.roots)
        , vertex_marks(t.vertex_marks)
        , edge_marks(t.edge_marks)
        , face_marks(t.face_marks)
        , root_of(t.root_of)
        , known_(t)
    {
    }

    const mesh3d mesh;
    const array<kith::global_id> vertex_ids, edge_ids, face_ids, first_corner_ids, corners_before, marked_before, roots;
    const array<unsigned char> vertex_marks, edge_marks, face_marks;
    const array<std::uint32_t> root_of;

    [[nodiscard]] bool owns_vertex(std::size_t v) const { return known_.owns_vertex(v); }
    [[nodiscard]] bool owns_edge(std::size_t e) const { return known_.owns_edge(e); }
    [[nodiscard]] bool owns_face(std::size_t f) const { return known_.owns_face(f); }
    [[nodiscard]] bool is_cut(std::size_t e) const { return known_.is_cut(e); }
    [[nodiscard]] kith::global_id corner_id(std::size_t f, std::size_t k) const { return known_.corner_id(f, k); }
    [[nodiscard]] kith::global_id end_id(std::size_t e, std::size_t side) const { return known_.end_id(e, side); }
    [[nodiscard]] kith::global_id root(std::size_t f) const { return known_.root(f); }

private:
    const known& known_;
};

} // namespace archetypes

namespace {

static_assert(kith::refinable_mesh<archetypes::mesh> and not kith::fillable_mesh<archetypes::mesh>);
static_assert(kith::level<kith::level_of<archetypes::mesh>>);
static_assert(kith::tile_like<archetypes::tile> and kith::tile_like<kith::tile<archetypes::place, std::uint64_t>>);

using mesh_traits = kith::mesh_traits<archetypes::mesh>;
struct without_halfedge_of : mesh_traits {
    static void halfedge_of() = delete;
};
struct without_bound : mesh_traits {
    static void halfedge_bound() = delete;
};
struct without_faces : mesh_traits {
    static void faces() = delete;
};
struct with_text_handles : mesh_traits {
    using face = const char*;
};
struct without_end_id : archetypes::tile {
    void end_id() const = delete;
};
struct without_marks : archetypes::tile {
    int edge_marks;
};
struct with_small_numbers : archetypes::tile {
    const archetypes::array<std::uint32_t> face_ids;
};
static_assert(not kith::mesh<archetypes::mesh, without_halfedge_of>);
static_assert(not kith::mesh<archetypes::mesh, without_bound>);
static_assert(not kith::mesh<archetypes::mesh, without_faces>);
static_assert(not kith::mesh<archetypes::mesh, with_text_handles>);
static_assert(not kith::tile_like<without_end_id>);
static_assert(not kith::tile_like<without_marks>);
static_assert(not kith::tile_like<with_small_numbers>);

archetypes::mesh own_mesh(const mesh3d& native)
{
    kith::storage<archetypes::place> places(native.vertex_count());
    for (std::size_t v = 0; v < places.size(); ++v)
        places[v] = {native.points()[v][0], native.points()[v][1], native.points()[v][2]};
    return archetypes::mesh({std::move(places), kith::connectivity(native.topology())});
}

/// Calls test(own mesh, native mesh) for every shape.
void for_each_pair(const auto& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        test(own_mesh(mesh), mesh);
    }
}

std::vector<shapes::point> points_of(const archetypes::mesh& m)
{
    std::vector<shapes::point> result;
    for (const auto& p : native_of(m).points())
        result.push_back({p.x, p.y, p.z});
    return result;
}

} // namespace

TEST(archetypes_mesh, any_mesh_is_refined_as_the_native_one)
{
    for_each_pair([](const archetypes::mesh& own, const mesh3d& native) {
        EXPECT_TRUE(kith::validate(own));
        const auto ours = kith::refine(own, kith::catmull_clark(), 2);
        const auto theirs = kith::refine(native, kith::catmull_clark(), 2);
        EXPECT_EQ(points_of(ours), std::vector(theirs.points().begin(), theirs.points().end()));
        EXPECT_EQ(faces_of(ours), faces_of(theirs));
        EXPECT_EQ(faces_of(kith::refine(own, archetypes::scheme(0.5), 1)),
                  faces_of(kith::refine(native, archetypes::scheme(0.5), 1)));
    });
}

TEST(archetypes_mesh, what_is_wrong_with_any_mesh_is_found)
{
    auto twice = native(shapes::cube());
    auto topology = twice.topology();
    topology.corner_vertex[0] = topology.corner_vertex[2];
    const auto broken = own_mesh({kith::storage<shapes::point>(twice.points()), std::move(topology)});
    EXPECT_FALSE(kith::validate(broken));
    EXPECT_THROW(kith::refine(broken, kith::catmull_clark(), 1), kith::mesh_error);
}

TEST(archetypes_mesh, what_reads_tiles_reads_any)
{
    for (const auto& shape : {shapes::cube(), shapes::grid(4, 3)}) {
        const auto mesh = native(shape);
        std::vector<std::uint32_t> part_of(mesh.face_count());
        for (std::size_t f = 0; f < part_of.size(); ++f)
            part_of[f] = std::uint32_t(f % 2);
        kith::tile_cutter cutter(mesh, kith::catmull_clark(), part_of, 2);
        const auto known = cutter.cut(1, 1).part;
        const archetypes::tile own(known);

        EXPECT_EQ(kith::detail::fault_of_tile(own.mesh.topology(), own.mesh.vertex_count(), own), nullptr);
        EXPECT_EQ(kith::incomplete_vertices(own), kith::incomplete_vertices(known));
        EXPECT_EQ(kith::faces_at_cuts(own), kith::faces_at_cuts(known));
        EXPECT_EQ(kith::rings_of_ghosts(own), kith::rings_of_ghosts(known));
        for (const auto kind : {kith::element_kind::vertex, kith::element_kind::edge, kith::element_kind::face})
            EXPECT_TRUE(std::ranges::equal(kith::ids_of(own, kind), kith::ids_of(known, kind)));

        const kith::level_of<mesh3d> level(own.mesh);
        for (std::size_t tuple = 0; tuple < 2 * level.corner_count(); ++tuple) {
            constexpr auto kind = kith::tuple_kind::vfe;
            const std::size_t face = parent(level, kind, tuple);
            const auto here = kith::detail::in_whole<kind>(own, face, tuple);
            EXPECT_EQ(here.id, kith::detail::in_whole<kind>(known, face, tuple).id);
        }
        const auto columns = kith::catmull_clark::columns();
        const auto facts = kith::global_numbering<decltype(columns)>::facts_at_boundary(columns, own);
        EXPECT_EQ(facts, kith::global_numbering<decltype(columns)>::facts_at_boundary(columns, known));
        const auto at_boundary = kith::corners_at_vertices::owned_at_boundary(own);
        ASSERT_EQ(at_boundary.size(), kith::corners_at_vertices::owned_at_boundary(known).size());
        for (std::size_t i = 0; i < at_boundary.size(); ++i)
            EXPECT_EQ(at_boundary[i].id, kith::corners_at_vertices::owned_at_boundary(known)[i].id);
    }
}
