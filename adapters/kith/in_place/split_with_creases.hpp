// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/crease/creases.hpp>

namespace kith::in_place {

/// A scheme in place of Catmull-Clark or Loop that moves no point: the linear split, `linear` or `linear_triangles`,
/// which also carries the creases.
template <scheme Linear>
struct split_with_creases {
    creases sharpness{};

    static constexpr auto traits()
    {
        return scheme_traits{.name = traits_of<Linear>.name,
                             .faces = traits_of<Linear>.faces,
                             .trusted = true,
                             .require = traits_of<Linear>.require,
                             .state = &split_with_creases::sharpness};
    }
    static constexpr auto columns() { return Linear::columns(); }
    template <step_context R>
    void operator()(const R& r) const
    {
        Linear()(r);
    }
};

} // namespace kith::in_place
