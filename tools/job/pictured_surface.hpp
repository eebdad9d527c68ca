// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job_memory.hpp"
#include "schemes.hpp"

#include <kith/io/format/mesh_attributes.hpp>
#include <kith/picture/scene.hpp>
#include <kith/surface/curvature.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::tool {

/// A surface in a picture, with the values from which its colors follow.
struct pictured_surface {
    picture::surface shape;
    std::vector<double> parents;                 ///< of polygons: the face of the control mesh; NaN if there is none
    io::mesh_attributes attributes;              ///< of vertices and polygons
    std::vector<surface_curvature> curvatures{}; ///< of vertices, if they were asked for
    int level = 0;                               ///< of the polygons
};

/// A control mesh with its scheme, the memory that its refinements may use, and a number of polygons that looks smooth.
struct pictured_job {
    any_scheme scheme;
    const control_mesh& control;
    memory_limit memory;
    std::size_t enough_faces;
};

/// Returns the limit surface as the polygons of a fine level, `least_level` or a later one, with limit positions and
/// normals. Errors: those of refine_native and of the limits.
pictured_surface limit_in_picture(const pictured_job& job, int least_level);

/// Returns the polygons of a level. Errors: those of refine_native.
pictured_surface level_in_picture(const pictured_job& job, int level);

/// Returns the limit surface as triangles with curvatures. Errors: usage_error unless the scheme is Catmull-Clark or
/// Loop; those of tessellate.
pictured_surface curvature_in_picture(const pictured_job& job);

/// Returns the edges of a level as curves on the limit surface. Those of Catmull-Clark and Loop lie on the surface;
/// those of other schemes have its points and normals at their ends. Errors: as limit_in_picture.
picture::lines wire_in_picture(const pictured_job& job, int level);

} // namespace kith::tool
