# SPDX-License-Identifier: BSD-3-Clause
"""Reads what kith writes with the readers of VTK, as ParaView does: vtk_test.py KITH.

A value of vertices that is a linear function of their points stays that function of the refined points.
"""
import os
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPUnstructuredGridReader,
                                     vtkXMLUnstructuredGridReader)
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

KITH = sys.argv[1]
POINTS = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
FACES = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
PARTS = [0, 0, 5, 7]


def quality(points):
    return points @ [1, 2, -1] + 3


def control_mesh():
    lines = ["ply", "format ascii 1.0", "element vertex 4", "property double x", "property double y",
             "property double z", "property double quality", "element face 4",
             "property list uchar int vertex_indices", "property int part", "end_header"]
    lines += [" ".join(map(repr, [*p, q])) for p, q in zip(POINTS.tolist(), quality(POINTS).tolist())]
    lines += [" ".join(map(str, [3, *face, part])) for face, part in zip(FACES, PARTS)]
    return "\n".join(lines) + "\n"


def refine(output, *more):
    subprocess.run([KITH, "refine", "control.ply", "-s", "loop", "-n", "3", "-o", output, *more], check=True,
                   stdout=subprocess.DEVNULL)
    return output


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def triangles(data):
    """Returns the points of the corners of all cells: cells x 3 x 3."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    cells = data.GetCells() if hasattr(data, "GetCells") else data.GetPolys()
    assert np.all(np.diff(vtk_to_numpy(cells.GetOffsetsArray())) == 3)
    return points[vtk_to_numpy(cells.GetConnectivityArray())].reshape(-1, 3, 3)


def expect_values(data, path):
    """Expects `quality` at points and `part` on cells."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    values = vtk_to_numpy(data.GetPointData().GetArray("quality"))
    assert np.allclose(values, quality(points), rtol=0, atol=1e-13), path
    parts = vtk_to_numpy(data.GetCellData().GetArray("part"))
    numbers, counts = np.unique(parts, return_counts=True)
    assert numbers.tolist() == [0, 5, 7] and counts.tolist() == [128, 64, 64], path


def in_order(corners):
    """Returns triangles in an order of their own, each from its least corner on."""
    rows = [min(tuple(map(tuple, np.roll(t, k, 0))) for k in range(3)) for t in corners.tolist()]
    return np.array(sorted(rows))


def main():
    with open("control.ply", "w") as file:
        file.write(control_mesh())
    with open(refine("whole.off")) as file:
        numbers = np.array(file.read().split()[1:], float)
    vertices, faces = int(numbers[0]), int(numbers[1])
    assert (vertices, faces) == (130, 256)
    points = numbers[3:3 + 3 * vertices].reshape(-1, 3)
    whole = points[numbers[3 + 3 * vertices:].astype(int).reshape(-1, 4)[:, 1:]]

    for path, more in [("a.vtu", []), ("tiles.vtu", ["--tiles", "3"])]:
        data = read(vtkXMLUnstructuredGridReader(), refine(path, *more))
        assert np.array_equal(triangles(data), whole), path
        expect_values(data, path)
    data = read(vtkXMLPUnstructuredGridReader(), refine("pieces.pvtu", "--tiles", "3"))
    assert np.array_equal(in_order(triangles(data)), in_order(whole))
    expect_values(data, "pieces.pvtu")
    data = read(vtkXMLPolyDataReader(), refine("a.vtp"))
    assert np.array_equal(triangles(data), whole)
    expect_values(data, "a.vtp")
    # These readers keep floats.
    for path, more, reader in [("a.ply", [], vtkPLYReader), ("binary.ply", ["--binary"], vtkPLYReader),
                               ("a.obj", [], vtkOBJReader), ("binary.stl", ["--binary"], vtkSTLReader)]:
        assert np.array_equal(triangles(read(reader(), refine(path, *more))), whole.astype(np.float32)), path
    print("VTK reads eight files as they were meant")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
