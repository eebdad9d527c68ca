# SPDX-License-Identifier: BSD-3-Clause
"""The module as it is used; it ends with an error where an answer is not the one that can be computed here."""

import kith
import numpy as np

cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])

levels = kith.Levels(cube, quads, "catmull-clark").refine(3)
assert levels.depth == 3 and levels.faces(3).shape == (384, 4) and levels.points().shape == (386, 3)
# The mask of Catmull & Clark at a vertex of valence 3, by hand.
face_points = cube[quads].mean(axis=1)
at_0 = [f for f in range(6) if 0 in quads[f]]
neighbors = cube[[1, 2, 4]]
by_hand = (3 - 2) / 3 * cube[0] + (neighbors.sum(axis=0) + face_points[at_0].sum(axis=0)) / 9
assert np.allclose(levels.points(1)[0], by_hand, atol=1e-15)

# Matrices, between levels and to the limit.
assert np.allclose(levels.matrix(0, 3) @ cube, levels.points(3), atol=1e-14)
assert np.allclose((levels.matrix(1, 3) @ levels.matrix(0, 1) - levels.matrix(0, 3)).toarray(), 0, atol=1e-15)
limit, normals = levels.limit(2)
assert np.allclose(levels.limit_matrix(0, 2) @ cube, limit, atol=1e-13)
assert np.all((limit * normals).sum(axis=1) > 0) and np.allclose(np.linalg.norm(normals, axis=1), 1)

# Values at vertices, and what each face came from.
assert np.array_equal(levels.carry(0, 3, cube), levels.points(3))
assert np.array_equal(levels.carry(0, 3, cube[:, 0]), levels.points(3)[:, 0])
assert levels.carry(0, 3, np.zeros((8, 0))).shape == (386, 0) and levels.carry(0, 3, np.zeros((8, 2, 0))).shape == (386, 2, 0)
kind, number = levels.ancestors("face", 3, 0)
assert np.all(kind == kith.FACE) and np.array_equal(np.bincount(number), [64] * 6)
labels = np.array(list("abcdef"))[number]
assert len(labels) == 384

# Control points are moved without refining again.
levels.move_points(cube * [1, 2, 3])
assert np.array_equal(levels.points(3), kith.refine(cube * [1, 2, 3], quads, "catmull-clark", 3)[0])

# Creases, the conventions of other libraries, degrees, mixed faces.
sharp = kith.Levels(cube, quads, "catmull-clark", sharp_edges=[(a, b, np.inf) for f in quads for a, b in zip(f, np.roll(f, 1))])
assert np.isclose(np.abs(sharp.refine(3).points()).max(), 1)
assert kith.refine(cube, quads, "unified", 1, degree=5)[1].shape == (24, 4)
house, faces = kith.refine([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 3, 0]], [[0, 1, 2, 3], [3, 2, 4]], "doo-sabin", 1)
assert sorted({len(f) for f in faces}) == [3, 4]
triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
assert kith.loop(cube[[0, 3, 5, 6]], triangles, 2)[1].shape == (64, 3)
# A corner of an open triangle is smoothed as igl.loop does it, to 3/4 of itself and 1/8 of each neighbour.
corner = kith.loop([[0, 0, 0], [8, 0, 0], [0, 8, 0]], [[0, 1, 2]])[0][0]
assert np.allclose(corner, [1, 1, 0], atol=1e-15)
assert kith.upsample(cube[[0, 3, 5, 6]], triangles, 2)[1].shape == (64, 3)
for name in kith.schemes:
    closed = triangles if name in ("loop", "sqrt3", "butterfly", "interpolatory-sqrt3", "linear-triangles") else quads
    points, faces = kith.refine(cube if closed is quads else cube[[0, 3, 5, 6]], closed, name, 2)
    assert np.isfinite(points).all() and len(faces) > len(closed)

# Kobbelt's point of the edge 0 4, by hand: a tension brings the weight of what lies opposite with it.
w = 0.5
g = w / (8 + w)
beyond = [cube[l].sum(axis=0) / 3 + g * (cube[k[0]] - cube[k].sum(axis=0) / 3) for l, k in (([1, 2, 4], [3, 5, 6]), ([0, 5, 6], [7, 1, 2]))]
by_hand = (8 + w) / 16 * (cube[0] + cube[4]) - w / 16 * (beyond[0] + beyond[1])
assert np.isclose(kith.refine(cube, quads, "kobbelt", 1, tension=w)[0], by_hand, atol=1e-15).all(axis=1).sum() == 1

# What cannot be done says why.
for wrong, why in [
    (lambda: kith.refine(cube, quads, "lopo"), "is none of"),
    (lambda: kith.refine(cube, quads, "loop"), "triangulate"),
    (lambda: kith.refine(cube, [[0, 1, 9]], "loop"), "9"),
    (lambda: levels.matrix(3, 0), "level 3"),
    (lambda: levels.carry(0, 3, np.zeros((7, 0))), "7"),
    (lambda: kith.refine(cube, quads, "kobbelt", tension=-8), "between 0 and"),
    (lambda: kith.refine(cube, quads, "kobbelt", sharp_edges=[(0, 1, 1)]), "creases"),
    (lambda: kith.refine(cube, quads, "catmull-clark", sharp_edges=[(0, 1, -1)]), "0 or more"),
    (lambda: kith.refine(cube, quads, "catmull-clark", sharp_edges=[(0, 1, np.nan)]), "0 or more"),
    (lambda: kith.refine(cube, quads, "catmull-clark", sharp_vertices=[(3, np.nan)]), "0 or more"),
]:
    try:
        wrong()
    except kith.MeshError as error:
        assert why in str(error), error
    else:
        raise AssertionError(why)
print("all as computed by hand")
