# SPDX-License-Identifier: BSD-3-Clause
"""Reads what kith writes with the readers of VTK, as ParaView does, and with those of meshio: readers_test.py KITH.

Values of vertices that are linear functions of their points stay these functions of the refined points.
"""
import os
import subprocess
import sys
import tempfile

missing = []
try:
    import numpy as np
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)
try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader, vtkXMLPUnstructuredGridReader,
                                     vtkXMLUnstructuredGridReader)
except ImportError as error:
    missing.append(error)
try:
    import meshio
except ImportError as error:
    missing.append(error)

KITH = sys.argv[1]
POINTS = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
FACES = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
PARTS = [0, 0, 5, 7]
COLORS = ("red", "green", "blue")


def quality(points):
    return points @ [1, 2, -1] + 3


def colors(points):
    """Returns red, green and blue from 0 to 255."""
    return 128 + 60 * points


def write_control_meshes():
    """Writes control.ply, which has values, and plain.off, which has none."""
    lines = ["ply", "format ascii 1.0", "element vertex 4", "property double x", "property double y",
             "property double z", *(f"property uchar {name}" for name in COLORS), "property double quality",
             "element face 4", "property list uchar int vertex_indices", "property int part", "end_header"]
    lines += [" ".join(map(repr, [*p, *map(int, colors(np.array(p))), q]))
              for p, q in zip(POINTS.tolist(), quality(POINTS).tolist())]
    lines += [" ".join(map(str, [3, *face, part])) for face, part in zip(FACES, PARTS)]
    with open("control.ply", "w") as file:
        file.write("\n".join(lines) + "\n")
    with open("plain.off", "w") as file:
        rows = [" ".join(map(repr, p)) for p in POINTS.tolist()] + ["3 %d %d %d" % face for face in FACES]
        file.write("OFF\n4 4 0\n" + "\n".join(rows) + "\n")


def refine(output, *more, control="control.ply"):
    subprocess.run([KITH, "refine", control, "-s", "loop", "-n", "3", "-o", output, *more], check=True,
                   stdout=subprocess.DEVNULL)
    return output


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def triangles(data):
    """Returns the points of the corners of all cells: cells x 3 x 3."""
    cells = data.GetCells() if hasattr(data, "GetCells") else data.GetPolys()
    assert np.all(np.diff(vtk_to_numpy(cells.GetOffsetsArray())) == 3)
    return points_of(data)[vtk_to_numpy(cells.GetConnectivityArray())].reshape(-1, 3, 3)


def expect_parts(parts, path):
    numbers, counts = np.unique(parts, return_counts=True)
    assert numbers.tolist() == [0, 5, 7] and counts.tolist() == [128, 64, 64], path


def expect_colors(found, points, path):
    """Expects whole numbers, so each may be half a number away."""
    assert np.abs(found - colors(points)).max() <= .5 + 1e-4, path


def expect_values(value_at_points, part_of_cells, points, path):
    """Expects all values of control.ply; both functions take a name."""
    assert np.allclose(value_at_points("quality"), quality(points), rtol=0, atol=1e-13), path
    expect_colors(np.stack([value_at_points(name) for name in COLORS], 1), points, path)
    expect_parts(part_of_cells("part"), path)


def expect_vtk_values(data, path):
    def value_at_points(name):
        together = data.GetPointData().GetArray("RGB")  # of .vtp
        if name in COLORS and together is not None:
            return vtk_to_numpy(together)[:, COLORS.index(name)]
        return vtk_to_numpy(data.GetPointData().GetArray(name))

    expect_values(value_at_points, lambda name: vtk_to_numpy(data.GetCellData().GetArray(name)), points_of(data), path)


def in_order(corners):
    """Returns triangles in an order of their own, each from its least corner on."""
    rows = [min(tuple(map(tuple, np.roll(t, k, 0))) for k in range(3)) for t in corners.tolist()]
    return np.array(sorted(rows))


def vtk_reads(whole):
    for path, more in [("a.vtu", []), ("tiles.vtu", ["--tiles", "3"])]:
        data = read(vtkXMLUnstructuredGridReader(), refine(path, *more))
        assert np.array_equal(triangles(data), whole), path
        expect_vtk_values(data, path)
    data = read(vtkXMLPUnstructuredGridReader(), refine("pieces.pvtu", "--tiles", "3"))
    assert np.array_equal(in_order(triangles(data)), in_order(whole))
    expect_vtk_values(data, "pieces.pvtu")
    data = read(vtkXMLPolyDataReader(), refine("a.vtp"))
    assert np.array_equal(triangles(data), whole)
    expect_vtk_values(data, "a.vtp")
    # These readers keep floats, and no values but the colors of PLY and of glTF.
    for path, more, reader in [("a.ply", [], vtkPLYReader), ("binary.ply", ["--binary"], vtkPLYReader),
                               ("a.obj", [], vtkOBJReader), ("binary.stl", ["--binary"], vtkSTLReader)]:
        data = read(reader(), refine(path, *more))
        assert np.array_equal(triangles(data), whole.astype(np.float32)), path
        if path.endswith(".ply"):
            expect_colors(vtk_to_numpy(data.GetPointData().GetArray("RGB")), points_of(data), path)
    blocks = read(vtkGLTFReader(), refine("a.glb"))
    each = blocks.NewIterator()
    data = each.GetCurrentDataObject()
    assert np.array_equal(triangles(data), whole.astype(np.float32))
    linear = vtk_to_numpy(data.GetPointData().GetArray("COLOR_0"))[:, :3]  # of light; above .04 a power of 2.4
    expect_colors(255 * (1.055 * linear ** (1 / 2.4) - .055), points_of(data), "a.glb")
    print("VTK reads nine files as they were meant")


def meshio_reads(whole):
    # It reads .off without colors and binary .ply without values of faces.
    for path, more in [("a.off", []), ("plain.obj", []), ("plain.ply", []), ("plain_binary.ply", ["--binary"]),
                       ("a.stl", []), ("plain_binary.stl", ["--binary"]), ("plain.vtu", [])]:
        data = meshio.read(refine(path, *more, control="plain.off"))
        found = data.points[data.cells_dict["triangle"]]
        expected = whole.astype(np.float32) if path == "plain_binary.stl" else whole
        assert np.array_equal(in_order(found), in_order(expected)), path
    for path, more in [("a.ply", []), ("a.vtu", []), ("tiles.vtu", ["--tiles", "3"])]:
        data = meshio.read(refine(path, *more))
        assert np.array_equal(data.points[data.cells_dict["triangle"]], whole), path
        expect_values(data.point_data.__getitem__, lambda name: data.cell_data[name][0], data.points, path)
    data = meshio.read(refine("a.obj"))  # a row is a point and its color
    assert np.array_equal(data.points[data.cells_dict["triangle"], :3], whole)
    expect_colors(255 * data.points[:, 3:], data.points[:, :3], "a.obj")
    print("meshio reads eleven files as they were meant")


def main():
    write_control_meshes()
    with open(refine("whole.off", control="plain.off")) as file:
        numbers = np.array(file.read().split()[1:], float)
    vertices, faces = int(numbers[0]), int(numbers[1])
    assert (vertices, faces) == (130, 256)
    points = numbers[3:3 + 3 * vertices].reshape(-1, 3)
    whole = points[numbers[3 + 3 * vertices:].astype(int).reshape(-1, 4)[:, 1:]]
    if "vtkXMLPolyDataReader" in globals():
        vtk_reads(whole)
    if "meshio" in globals():
        meshio_reads(whole)
    for error in missing:
        print("skipped:", error)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
sys.exit(77 if missing else 0)
