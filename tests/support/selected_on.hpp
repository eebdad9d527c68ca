// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_text.hpp"
#include "shapes.hpp"
#include "same_mesh.hpp"
#include "some_selections.hpp"
#include "user_mesh.hpp"

#include <kith/hierarchy.hpp>
#include <kith/selected.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Expects that a selection of faces gives equal levels on a mesh of another library and on its native copy. Faces are
/// selected by flags, by handles and by a condition. The checker of the library must find no errors.
template <class M, class Scheme>
void expect_levels_of_native(const Scheme& scheme, const shapes::shape& shape)
{
    using face = typename kith::mesh_traits<M>::face;
    const M mesh = user_mesh<M>::make(shape.points, shape.faces);
    kith::hierarchy levels(mesh, kith::selected(scheme));
    kith::hierarchy natives(kith::to_native(mesh), kith::selected(scheme)); // numbers edges in the same order
    std::mt19937 random(5);
    for (int level = 1; level <= 4; ++level) {
        const auto& here = levels.elements(level - 1);
        const auto flags = some_faces(here.face_count(), random, 4);
        natives.refine_flagged(flags);
        if (level == 1) {
            levels.refine_flagged(flags);
        } else if (level == 2) {
            std::vector<face> list;
            for (std::size_t f = 0; f < flags.size(); ++f)
                if (flags[f] != 0)
                    list.push_back(here.face_at(f));
            levels.refine_faces(list);
        } else {
            levels.refine_if([&](face f) { return flags[here.index(f)] != 0; });
        }
        EXPECT_EQ(user_mesh<M>::complaints(levels[level]), "");
        EXPECT_EQ(faces_of(levels[level]), faces_of(natives[level]));
        for (std::size_t v = 0; v < natives[level].vertex_count(); ++v)
            EXPECT_EQ(coordinates(levels.elements(level).vertices()[v].point()),
                      coordinates(natives.elements(level).vertices()[v].point()));
    }
    const auto& control = levels.elements(0);
    for (std::size_t f = 0; f < control.face_count(); ++f)
        EXPECT_EQ(levels.descendants(0, control.face_at(f), 4).numbers(),
                  natives.descendants(0, natives.elements(0).face_at(f), 4).numbers());
    levels.undo(3);
    levels.redo(3);
    EXPECT_EQ(faces_of(levels.finest()), faces_of(natives.finest()));
}

/// Expects an error that names a selected face if the control mesh has removed it. The hierarchy can be refined
/// afterwards.
template <class M, class Scheme>
void expect_removed_face_is_named(const Scheme& scheme, M control, typename kith::mesh_traits<M>::face removed)
{
    kith::hierarchy levels(std::move(control), kith::selected(scheme));
    const auto text = error_text<kith::mesh_error>([&] { levels.refine_faces(std::vector{removed}); });
    EXPECT_NE(text.find("level 0 has no face"), std::string::npos) << text;
    EXPECT_NE(text.find("it was removed"), std::string::npos) << text;
    EXPECT_EQ(levels.depth(), 0);
    levels.refine_if([&](const auto& f) { return not(f == removed); });
    EXPECT_EQ(levels.depth(), 1);
}
