// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "blocks.hpp"

#include <kith/core/mask/by_valence.hpp> // a word of rules, too

#include <type_traits>
#include <utility>

namespace kith {

/// A rule for all elements of one kind: at_vertices, at_edges, at_faces, at_corners.
template <class Elements, class Body>
class rule {
public:
    rule(Elements elements, Body body, bool applies = true)
        : elements_(std::move(elements)), body_(std::move(body)), applies_(applies)
    {
    }

    /// Returns this rule if the condition holds, else a rule that does nothing.
    [[nodiscard]] rule when(bool condition) const { return rule(elements_, body_, applies_ and condition); }

    /// Applies the rule to the elements of a level or a part of it.
    template <step_context R>
    void operator()(const R& r) const
    {
        if (not applies_)
            return;
        const Body body = body_; // the compiler knows that a local copy has no aliases
        for_each(elements_(r.coarse), [&body, &assoc = r.assoc](const auto& x) {
            if constexpr (std::is_void_v<decltype(body(x))>)
                body(x);
            else
                assoc(x, targets::V) = body(x);
        });
    }

private:
    Elements elements_;
    Body body_;
    bool applies_;
};

/// Returns the rule of all vertices: body(v) returns the mask of the new point (v), or makes elements itself.
template <class Body>
[[nodiscard]] auto at_vertices(const Body& body)
{
    return rule([](const auto& level) { return level.vertices(); }, body);
}
template <class Body>
[[nodiscard]] auto at_edges(const Body& body)
{
    return rule([](const auto& level) { return level.edges(); }, body);
}
template <class Body>
[[nodiscard]] auto at_faces(const Body& body)
{
    return rule([](const auto& level) { return level.faces(); }, body);
}
template <class Body>
[[nodiscard]] auto at_corners(const Body& body)
{
    return rule([](const auto& level) { return level.corners(); }, body);
}

/// Returns the rule of vertices whose points stay, as in interpolating schemes.
[[nodiscard]] inline auto kept_vertices()
{
    return at_vertices([](auto v) { return v; });
}

/// Makes the points of the next level by these rules and connects them by the split. Order and parts are those that
/// suit the machine. No rule may read points that other rules make. Points that all rules read are made before, in a
/// loop of their own. Errors: as for_each. Cost: that of the rules.
template <class Split, step_context R, class... Rules>
void subdivide(const Split& split, const R& r, const Rules&... rules)
{
    in_blocks(r, [&](const auto& part) {
        (rules(part), ...);
        split.connect(part);
    });
}

} // namespace kith
