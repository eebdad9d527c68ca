# SPDX-License-Identifier: BSD-3-Clause
"""Subdivision surfaces of NumPy arrays, with all levels and all relations between them.

    levels = kith.Levels(points, faces, "catmull-clark")
    levels.refine(3)
    points, faces = levels.points(3), levels.faces(3)
    prolongation = levels.matrix(0, 3)      # scipy.sparse.csr_matrix
    kind, number = levels.ancestors("face", 3, 0)

Points are arrays of shape (n, 3). Faces are an array of shape (m, k), or a list of faces where these have different numbers
of corners; given back they are an array, or a list of arrays.
"""

import numpy as _numpy

from . import _kith
from ._kith import MeshError, schemes

__all__ = ["Levels", "MeshError", "loop", "refine", "schemes", "upsample"]

#: What the first array of Levels.ancestors says.
VERTEX, EDGE, FACE = 0, 1, 2


def _sparse(parts):
    from scipy.sparse import csr_matrix

    weights, columns, row_start, shape = parts
    return csr_matrix((weights, columns, row_start), shape=shape)


class Levels:
    """A control mesh and its refinements; level 0 is the control mesh.

    scheme: one of kith.schemes. like: the conventions of another library ("cgal", "openmesh", "opensubdiv", "libigl"). degree and
    tension: of the schemes that have them. sharp_edges: (vertex, vertex, sharpness) each, sharp_vertices: (vertex, sharpness)
    each; sharpness may be infinite. Raises MeshError, which is a ValueError, for what cannot be refined, with the reason.
    An object is used by one thread at a time.
    """

    def __init__(self, points, faces, scheme, *, like=None, degree=None, tension=None, sharp_edges=(), sharp_vertices=()):
        self._levels = _kith.Levels(points, faces, scheme, like, degree, tension, list(sharp_edges), list(sharp_vertices))

    @property
    def depth(self):
        """The number of the last level."""
        return self._levels.depth()

    def refine(self, n=1):
        """Adds n levels."""
        self._levels.refine(n)
        return self

    def points(self, level=None):
        """The points of a level, of the last one by default."""
        return self._levels.points(self.depth if level is None else level)

    def faces(self, level=None):
        """The faces of a level: an array of shape (m, k), or a list of arrays where they have different numbers of corners."""
        found = self._levels.faces(self.depth if level is None else level)
        if isinstance(found, tuple):
            corners, first = found
            return _numpy.split(corners, first[1:-1])
        return found

    def edges(self, level=None):
        """The two ends of each edge, an array of shape (m, 2)."""
        return self._levels.edges(self.depth if level is None else level)

    def ancestors(self, kind, level, coarser):
        """Of all elements of a level ("vertex", "edge" or "face") those of a coarser one from which they descend: two arrays,
        their kinds (VERTEX, EDGE, FACE) and their numbers."""
        return self._levels.ancestors(kind, level, coarser)

    def matrix(self, coarser, finer):
        """The subdivision matrix between two levels, as a SciPy matrix in compressed rows."""
        return _sparse(self._levels.matrix(coarser, finer))

    def limit_matrix(self, coarser, finer):
        """The matrix that takes the vertices of one level where those of another end up when it is refined for ever."""
        return _sparse(self._levels.limit_matrix(coarser, finer))

    def limit(self, level=None):
        """The points of a level where they end up, and the unit normals there."""
        return self._levels.limit(self.depth if level is None else level)

    def carry(self, coarser, finer, values):
        """Values at vertices, of shape (n,) or (n, ...), carried to a finer level by the scheme's own weights."""
        return self._levels.carry(coarser, finer, values)

    def move_points(self, points, level=0):
        """Moves the vertices of a level, and those of all finer levels with them."""
        self._levels.move_points(level, points)


def refine(points, faces, scheme, n=1, **options):
    """The points and faces of a mesh refined n times; options as those of Levels."""
    levels = Levels(points, faces, scheme, **options).refine(n)
    return levels.points(), levels.faces()


def loop(points, faces, n=1):
    """As igl.loop: points and triangles after n steps of Loop's scheme, with libigl's weights and boundary corners."""
    return refine(points, faces, "loop", n, like="libigl")


def upsample(points, faces, n=1):
    """As igl.upsample: each triangle is cut into four, n times, and nothing is smoothed."""
    return refine(points, faces, "linear-triangles", n)
