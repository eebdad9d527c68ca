// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/selected/polygon_closure_split.hpp>
#include <kith/schemes/selected/red_green_split.hpp>
#include <kith/schemes/selected/selectable_scheme.hpp>

#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// A scheme whose steps refine only the chosen faces; all faces if none have been chosen. `closure` keeps the mesh
/// conforming: no vertex lies on the edge of another face. Vertices at cut edges have the rules of the scheme, on the
/// mesh as it is; all other vertices stay. If a scheme reaches further than a ring of faces, new vertices beside green
/// faces are midpoints. So red faces have the points of full refinement, the same bits, wherever the level around them
/// has. Bank, Sherman & Weiser 1983. Cost: that of the scheme on all faces, without their connectivity, and that of the
/// new level.
template <selectable_scheme Scheme>
class selected {
    using split = std::conditional_t<detail::splits_triangles<Scheme>, red_green_split, polygon_closure_split>;

public:
    explicit selected(Scheme scheme = Scheme()) : scheme_(std::move(scheme)) {}

    /// Returns the scheme of the faces that are split, with its state of this level.
    [[nodiscard]] const Scheme& scheme() const { return scheme_; }
    /// Returns one flag per face of this level, set for chosen faces; none if all faces are chosen.
    [[nodiscard]] std::span<const unsigned char> chosen() const { return closure_.chosen(); }
    /// Chooses faces of the level, by a flag for each. Errors: mesh_error unless there is one per face. Cost: O(level).
    template <level Level>
    void select(const Level& level, std::span<const unsigned char> chosen)
    {
        closure_.select(level, chosen);
    }

    static constexpr auto traits()
    {
        constexpr auto& own = traits_of<Scheme>;
        return scheme_traits{
            .name = std::string_view(detail::name_of_selected<Scheme>.data(), detail::name_of_selected<Scheme>.size()),
            .faces = own.faces,
            .closed_only = own.closed_only,
            .trusted = own.trusted,
            .require = [](const selected& s, const auto& l, int g) { detail::require_by_traits(s.scheme_, l, g); },
            .state = [](auto& scheme) { return states(scheme); },
            .closure = [](const auto& scheme) -> const auto& { return closure_of(scheme); }};
    }
    [[nodiscard]] auto columns() const { return split{&closure_}.columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        if (closure_.is_everything())
            return scheme_(r);
        const auto& assoc = r.assoc;
        const auto all = assoc.pass(columns_of(scheme_, r.generation));
        scheme_(refinement<std::remove_cvref_t<decltype(r.coarse)>, std::remove_cvref_t<decltype(all)>, scalar_type<R>>{
            r.coarse, all, r.generation});

        const auto vertices = at_vertices([&](auto v) {
            if (closure_.is_moved(v))
                assoc(v, V) = all(v, V);
            else
                assoc(v, V) = v;
        });
        const auto is_green = closure_.vertices_of_green(r.coarse, detail::is_wide<Scheme>());
        const auto edges = at_edges([&](auto e) {
            if (not closure_.is_cut(e))
                return;
            if (not is_green.empty() and (is_green[e.org().index()] or is_green[e.dst().index()]))
                assoc(e, V) = average(e.org(), e.dst());
            else
                assoc(e, V) = all(e, V);
        });
        if constexpr (detail::splits_triangles<Scheme>)
            subdivide(split{&closure_}, r, vertices, edges);
        else
            subdivide(split{&closure_}, r, vertices, edges, at_faces([&](auto f) {
                          if (not closure_.is_red(f))
                              return;
                          if (split::is_green(closure_, f))
                              assoc(f, V) = average(split::own_vertices(closure_, f));
                          else
                              assoc(f, V) = all(f, V);
                      }));
    }

private:
    static const closure<split>& closure_of(const selected& scheme) { return scheme.closure_; }
    template <class Self>
    static auto states(Self& scheme)
    {
        if constexpr (has_state<Scheme>)
            return std::tie(scheme.scheme_, scheme.closure_);
        else
            return std::tie(scheme.closure_);
    }

    Scheme scheme_;
    closure<split> closure_;
};

} // namespace kith
