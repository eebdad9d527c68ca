// SPDX-License-Identifier: BSD-3-Clause
// Teaches kith a new mesh type in one page, then refines meshes of that type directly.
// Sample run: own_mesh

#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>

#include <cstdio>
#include <ranges>
#include <vector>

/// A user's plane mesh: half-edges are stored in pairs, faces are numbers, and -1 means "none".
namespace atlas {

struct position {
    float x, y;
};
struct halfedge {
    int from = -1, next = -1, prev = -1, face = -1;
};
struct map {
    std::vector<position> places;
    std::vector<int> way_out;      // for each place: a half-edge that leaves it
    std::vector<halfedge> borders; // half-edges 2i and 2i+1 run along border i
    std::vector<int> around;       // for each land: a half-edge of it
};

} // namespace atlas

template <>
struct kith::affine<atlas::position> : kith::coordinates_affine<float, 2> {
    static sum load(const atlas::position& p) { return {p.x, p.y}; }
    static atlas::position store(const sum& total) { return {total[0], total[1]}; }
};

template <>
struct kith::mesh_traits<atlas::map> {
    // The map uses plain numbers for all kinds of elements; kith needs a different type for each kind.
    using vertex = kith::element_id<struct place_kind, unsigned>;
    using edge = kith::element_id<struct border_kind, unsigned>;
    using face = kith::element_id<struct land_kind, unsigned>;
    using halfedge = kith::element_id<struct side_kind, unsigned>;
    using point = atlas::position;

    template <class Handle>
    static auto numbered(std::size_t n)
    {
        return std::views::iota(0U, unsigned(n)) | std::views::transform([](unsigned i) { return Handle{i}; });
    }
    static auto vertices(const atlas::map& m) { return numbered<vertex>(m.places.size()); }
    static auto edges(const atlas::map& m) { return numbered<edge>(m.borders.size() / 2); }
    static auto faces(const atlas::map& m) { return numbered<face>(m.around.size()); }
    template <class Handle>
    static std::size_t index(const atlas::map&, Handle x)
    {
        return x.value;
    }
    static std::size_t vertex_bound(const atlas::map& m) { return m.places.size(); }
    static std::size_t edge_bound(const atlas::map& m) { return m.borders.size() / 2; }
    static std::size_t face_bound(const atlas::map& m) { return m.around.size(); }
    static std::size_t halfedge_bound(const atlas::map& m) { return m.borders.size(); }

    static halfedge next(const atlas::map& m, halfedge h) { return {unsigned(m.borders[h.value].next)}; }
    static halfedge prev(const atlas::map& m, halfedge h) { return {unsigned(m.borders[h.value].prev)}; }
    static halfedge opposite(const atlas::map&, halfedge h) { return {h.value ^ 1}; }
    static bool is_boundary(const atlas::map& m, halfedge h) { return m.borders[h.value].face < 0; }
    static vertex source(const atlas::map& m, halfedge h) { return {unsigned(m.borders[h.value].from)}; }
    static edge edge_of(const atlas::map&, halfedge h) { return {h.value / 2}; }
    static face face_of(const atlas::map& m, halfedge h) { return {unsigned(m.borders[h.value].face)}; }
    static halfedge halfedge_of(const atlas::map& m, vertex v) { return {unsigned(m.way_out[v.value])}; }
    static halfedge halfedge_of(const atlas::map&, edge e) { return {2 * e.value}; }
    static halfedge halfedge_of(const atlas::map& m, face f) { return {unsigned(m.around[f.value])}; }
    static bool is_isolated(const atlas::map& m, vertex v) { return m.way_out[v.value] < 0; }
    static point point_of(const atlas::map& m, vertex v) { return m.places[v.value]; }

    /// Builds the map in one pass over the corners, since the native mesh stores half-edges in pairs, too.
    static atlas::map build(kith::basic_mesh<point, std::uint32_t>&& fine)
    {
        const auto& t = fine.topology();
        atlas::map m{{fine.points().begin(), fine.points().end()}, {}, std::vector<atlas::halfedge>(2 * t.edges()), {}};
        for (std::size_t v = 0; v < t.vertices; ++v)
            m.way_out.push_back(int(t.corner_halfedge[t.vertex_corner[v]]));
        for (std::size_t f = 0; f < t.faces; ++f) {
            const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
            m.around.push_back(int(t.corner_halfedge[first]));
            for (std::size_t c = first; c < end; ++c) {
                const int next = int(t.corner_halfedge[c + 1 == end ? first : c + 1]);
                const int prev = int(t.corner_halfedge[c == first ? end - 1 : c - 1]);
                m.borders[t.corner_halfedge[c]] = {int(t.corner_vertex[c]), next, prev, int(f)};
            }
        }
        for (std::size_t h = 1; h < m.borders.size(); h += 2) // the far side of a coast has no face
            if (m.borders[h].face < 0)
                m.borders[h].from = m.borders[std::size_t(m.borders[h - 1].next)].from;
        for (std::size_t h = 1; h < m.borders.size(); h += 2)
            if (m.borders[h].face < 0) { // its next half-edge runs on along the coast: turn clockwise around its end
                int onward = int(h - 1);
                while (onward % 2 == 0 or m.borders[std::size_t(onward)].face >= 0)
                    onward = m.borders[std::size_t(onward)].prev ^ 1;
                m.borders[h].next = onward;
                m.borders[std::size_t(onward)].prev = int(h);
            }
        return m;
    }
};
static_assert(kith::refinable_mesh<atlas::map>);

int main()
{
    const std::vector<atlas::position> places{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
    const std::vector<std::vector<int>> lands{{0, 1, 4, 3}, {1, 2, 5, 4}};
    const auto coarse = kith::mesh_traits<atlas::map>::build(kith::make_mesh(places, lands));

    kith::hierarchy<atlas::map, kith::catmull_clark> levels(coarse); // kith walks on atlas::map itself
    levels.refine(3);
    const atlas::map once = kith::refine(coarse, kith::catmull_clark{}, 3); // native levels inside, one map at the end
    const atlas::map& finest = levels.finest();

    bool same = once.places.size() == finest.places.size();
    for (std::size_t i = 0; same and i < once.places.size(); ++i)
        same = once.places[i].x == finest.places[i].x and once.places[i].y == finest.places[i].y;
    std::printf("%zu lands, %zu places; both ways the same: %s\n",
                finest.around.size(),
                finest.places.size(),
                same ? "yes" : "no");
    return same and finest.around.size() == 128 and finest.places.size() == 153 ? 0 : 1;
}
