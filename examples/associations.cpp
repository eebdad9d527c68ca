// SPDX-License-Identifier: BSD-3-Clause
// Draws the diagrams of the documentation from the associations of real steps: the elements that each kind of tuple
// makes, Catmull-Clark's associations around an extraordinary vertex, a patch, and the ghosts of a tile.
// Sample run: associations docs

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/nasri_hasbini.hpp>
#include <kith/picture.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/sqrt3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace {

using point = std::array<double, 3>;
using mesh = kith::basic_mesh<point>;
using kind = kith::tuple_kind;
using kith::picture::color;

constexpr color old_color{.76F, .25F, .05F}; // of the tuple
constexpr color new_color{.06F, .46F, .43F}; // of the elements that it makes

/// Returns a gray of this brightness, between 0 and 1.
constexpr color gray(float brightness)
{
    return {brightness, brightness, brightness};
}

/// A scheme: each quad gets a vertex made from two opposite vertices, which share no edge, and four triangles.
struct diagonals {
    static constexpr auto traits() { return kith::scheme_traits{.name = "diagonals"}; }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_side)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for (const auto v : coarse.vertices())
            assoc(v, V) = v;
        for (const auto f : coarse.faces()) { // not for_each: these vertices are numbered in the order of the calls
            const auto a = f.first_corner().v(), b = f.first_corner().next().next().v();
            assoc(a, b, V) = average(a, b);
            for (const auto c : f.corners())
                assoc(c.next_edge(), f, F) = polygon(assoc(c.v(), V), assoc(c.next().v(), V), assoc(a, b, V));
        }
    }
};

/// Makes a plane grid of n by n quads, or of twice as many triangles, with slightly moved vertices.
mesh grid(int n, bool triangles = false)
{
    std::vector<point> points;
    std::vector<std::vector<int>> faces;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x)
            points.push_back({x + .12 * std::sin(2. * x + 3 * y), y + .12 * std::cos(3. * x + y), 0});
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
            if (triangles) {
                faces.push_back({a, b, c});
                faces.push_back({a, c, d});
            } else {
                faces.push_back({a, b, c, d});
            }
        }
    return kith::make_mesh(points, faces);
}

/// Makes five quads around a vertex.
mesh flower()
{
    std::vector<point> points{{1.5, 1.5, 0}};
    std::vector<std::vector<int>> faces;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 1.25 : 1.6, turn = .628319 * i + .3;
        points.push_back({1.5 + radius * std::cos(turn), 1.5 + radius * std::sin(turn), 0});
    }
    for (int i = 0; i < 5; ++i)
        faces.push_back({0, 2 * i + 1, 2 * i + 2, 2 * i == 8 ? 1 : 2 * i + 3});
    return kith::make_mesh(points, faces);
}

/// Panels of equal size, with meshes in the plane.
class drawing {
public:
    drawing(int columns, int rows)
        : sheet_{.view = {0, 90},
                 .width = columns * side,
                 .height = rows * (side + 30),
                 .columns = columns,
                 .text_size = 14}
    {
    }

    /// Begins the next panel.
    void panel(const std::string& title) { sheet_.panels.push_back({.title = title}); }
    void line(const point& a, const point& b, const color& ink, double width)
    {
        add(kith::picture::lines{.points = {a, b}, .segments = {{0, 1}}, .ink = ink, .width = width});
    }
    void dot(const point& p, const color& ink, double radius) { line(p, p, ink, 2 * radius); }
    template <class Face>
    void fill(const Face& f, color paint, float opacity)
    {
        paint.opacity = opacity;
        kith::picture::surface polygon{.paint = paint, .light = kith::picture::shading::none};
        for (const auto& v : f.vertices()) {
            polygon.corners.push_back(std::uint32_t(polygon.points.size()));
            polygon.points.push_back(v.point());
        }
        polygon.first.push_back(std::uint32_t(polygon.points.size()));
        add(polygon);
    }
    /// Draws the edges of a level at a height; what is higher covers them.
    template <class Level>
    void edges(const Level& level, const color& ink, double width, double height = 0)
    {
        kith::picture::lines all{.ink = ink, .width = width};
        for (const auto& e : level.edges()) {
            const auto first = std::uint32_t(all.points.size());
            for (point p : {e.org().point(), e.dst().point()}) {
                p[2] = height;
                all.points.push_back(p);
            }
            all.segments.push_back({first, first + 1});
        }
        add(all);
    }
    template <class Edge>
    void edge(const Edge& e, const color& ink)
    {
        line(e.org().point(), e.dst().point(), ink, 5);
    }
    void write(const std::string& file) const
    {
        std::ofstream out(file);
        kith::picture::write_svg(out, sheet_);
    }

private:
    static constexpr int side = 230; // of a panel, in pixels

    void add(const auto& item) { sheet_.panels.back().items.emplace_back(item); }

    kith::picture::sheet sheet_;
};

template <class Element>
point middle(const Element& x)
{
    point sum{};
    double n = 0;
    const auto add = [&](const point& p) { sum[0] += p[0], sum[1] += p[1], ++n; };
    if constexpr (requires { x.vertices(); }) {
        for (const auto& v : x.vertices())
            add(v.point());
    } else if constexpr (requires { x.org(); }) {
        add(x.org().point()), add(x.dst().point());
    } else {
        add(x.point());
    }
    return {sum[0] / n, sum[1] / n, 0};
}

/// Draws the old elements of a tuple, which a hierarchy returns as the origin of a new element.
template <class Level, class Birth>
void draw_tuple(drawing& out, const Level& coarse, const Birth& birth)
{
    if (birth.e)
        out.edge(coarse.edges()[birth.e->value], old_color);
    for (const auto& v : {birth.v, birth.other_v})
        if (v)
            out.dot(coarse.vertices()[v->value].point(), old_color, 6);
}

/// Draws one step: of all new elements that a tuple of this kind makes, only the one nearest to the middle.
template <class Elements, class Scheme>
void draw_step(drawing& out, const mesh& control, const Scheme& scheme, std::optional<kind> tuple, Elements elements_of)
{
    kith::hierarchy levels(control, scheme);
    levels.refine();
    const auto &coarse = levels.elements(0), &fine = levels.elements(1);
    const auto elements = elements_of(fine);
    std::optional<std::size_t> best;
    double nearest = 1e9;
    for (const auto& x : elements)
        if (const auto birth = levels.origin(1, x.handle()); birth.kind == tuple)
            if (const point p = middle(x); std::hypot(p[0] - 1.6, p[1] - 1.4) < nearest) {
                nearest = std::hypot(p[0] - 1.6, p[1] - 1.4);
                best = x.index();
            }
    if (not best)
        return;
    const auto x = elements[*best];
    const auto birth = levels.origin(1, x.handle());
    if (birth.f)
        out.fill(coarse.faces()[birth.f->value], old_color, .2F);
    if constexpr (requires { x.vertices(); })
        out.fill(x, new_color, .45F);
    out.edges(coarse, gray(.53F), 2.5);
    out.edges(fine, new_color, .8);
    draw_tuple(out, coarse, birth);
    if constexpr (requires { x.org(); })
        out.edge(x, new_color);
    else if constexpr (requires { x.point(); })
        out.dot(x.point(), new_color, 5);
}

void draw_tuples(const std::string& file)
{
    drawing out(4, 3);
    const auto vertices = [](const auto& level) { return level.vertices(); };
    const auto edges = [](const auto& level) { return level.edges(); };
    const auto faces = [](const auto& level) { return level.faces(); };
    const mesh quads = grid(3), triangles = grid(3, true);
    const auto draw =
        [&](const char* title, const mesh& control, const auto& scheme, std::optional<kind> tuple, auto elements) {
            out.panel(title);
            draw_step(out, control, scheme, tuple, elements);
        };
    draw("(v) → V, Catmull-Clark", quads, kith::catmull_clark{}, kind::v, vertices);
    draw("(e) → V, Catmull-Clark", quads, kith::catmull_clark{}, kind::e, vertices);
    draw("(f) → V, Catmull-Clark", quads, kith::catmull_clark{}, kind::f, vertices);
    draw("(v,f) → V, Doo-Sabin", quads, kith::doo_sabin{}, kind::vf, vertices);
    draw("(v,f) → E, Loop", triangles, kith::loop{}, kind::vf, edges);
    draw("(v,e) → E, Catmull-Clark", quads, kith::catmull_clark{}, kind::ve, edges);
    draw("(e) → F, Doo-Sabin", quads, kith::doo_sabin{}, kind::e, faces);
    draw("(v,f) → F, Catmull-Clark", quads, kith::catmull_clark{}, kind::vf, faces);
    draw("(v) → F, Doo-Sabin", quads, kith::doo_sabin{}, kind::v, faces);
    draw("(e,f) → F, √3", triangles, kith::sqrt3{}, kind::ef, faces);
    draw("(v,f,e) → E, Nasri-Hasbini", quads, kith::nasri_hasbini{}, kind::vfe, edges);
    draw("(v,v) → V, a diagonal", quads, diagonals{}, std::nullopt, vertices);
    out.write(file);
}

/// Draws the new vertices that faces, edges and vertices make, with an arrow from each old element to its vertex.
void draw_catmull_clark(const std::string& file)
{
    drawing out(3, 1);
    kith::hierarchy levels(flower(), kith::catmull_clark{});
    levels.refine();
    const auto &coarse = levels.elements(0), &fine = levels.elements(1);
    const auto draw = [&](const char* title, kind tuple) {
        out.panel(title);
        for (const auto& v : fine.vertices())
            if (const auto birth = levels.origin(1, v.handle()); birth.kind == tuple and birth.f)
                out.fill(coarse.faces()[birth.f->value], old_color, .12F);
        out.edges(coarse, gray(.53F), 2.5);
        out.edges(fine, new_color, .8);
        for (const auto& v : fine.vertices())
            if (const auto birth = levels.origin(1, v.handle()); birth.kind == tuple) {
                if (birth.e)
                    out.edge(coarse.edges()[birth.e->value], old_color);
                if (birth.v)
                    out.line(coarse.vertices()[birth.v->value].point(), v.point(), old_color, 2);
                draw_tuple(out, coarse, birth);
                out.dot(v.point(), new_color, 5);
            }
    };
    draw("(f) → V", kind::f);
    draw("(e) → V", kind::e);
    draw("(v) → V", kind::v);
    out.write(file);
}

/// Draws the descendants of one face over three steps.
void draw_patch(const std::string& file)
{
    drawing out(4, 1);
    kith::hierarchy levels(grid(3), kith::catmull_clark{});
    levels.refine(3);
    const auto root = levels.elements(0).faces()[4].handle();
    for (int level = 0; level <= 3; ++level) {
        const bool is_made = level == 0 or level == 3;
        out.panel("level " + std::to_string(level) + (is_made ? "" : " (never made)"));
        const auto& elements = levels.elements(level);
        if (level == 0) {
            out.fill(elements.faces()[root.value], old_color, .3F);
        } else if (is_made) {
            for (const auto f : levels.descendants(0, root, level).faces())
                out.fill(elements.faces()[f.value], new_color, .4F);
        }
        out.edges(elements, is_made ? gray(.33F) : gray(.8F), is_made ? 1.2 : .8);
    }
    out.write(file);
}

/// Draws the levels of a tile: the faces that it owns, and its ghosts.
void draw_ghosts(const std::string& file)
{
    drawing out(4, 1);
    const mesh control = grid(8);
    kith::partition parts{{}, 2};
    for (const auto& f : kith::level_of<mesh>(control).faces()) {
        const point p = middle(f);
        parts.part_of.push_back(p[0] > 3 and p[0] < 5 and p[1] > 3 and p[1] < 5 ? 1 : 0);
    }
    out.panel("control mesh and a part");
    const kith::level_of<mesh> whole(control);
    for (const auto& f : whole.faces())
        if (parts.part_of[f.index()] == 1)
            out.fill(f, old_color, .4F);
    out.edges(whole, gray(.33F), 1.2);
    kith::tiled_refinement refinement(control, kith::doo_sabin{}, 2, parts);
    refinement.refine_levels(1, [&](auto&& kept) {
        out.panel("level " + std::to_string(kept.level) + " of the tile");
        out.edges(whole, gray(.87F), .8, -1);
        const kith::level_of<mesh> level(kept.part.mesh);
        for (const auto& f : level.faces())
            out.fill(f,
                     kept.part.owns_face(f.index()) ? old_color : gray(.53F),
                     kept.part.owns_face(f.index()) ? .4F : .25F);
        out.edges(level, gray(.33F), kept.level == 2 ? .6 : 1.2);
    });
    out.write(file);
}

} // namespace

int main(int count, char** words)
{
    const std::string folder = count > 1 ? words[1] : ".";
    draw_tuples(folder + "/associations.svg");
    draw_catmull_clark(folder + "/catmull_clark.svg");
    draw_patch(folder + "/patch.svg");
    draw_ghosts(folder + "/ghost_rings.svg");
    std::ifstream last(folder + "/ghost_rings.svg");
    return last ? 0 : 1;
}
