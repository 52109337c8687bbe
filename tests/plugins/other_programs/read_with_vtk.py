"""Reads the frames of a run with VTK's readers: read_with_vtk.py DIR."""

import struct
import sys

import vtk

FRAMES, STRANDS, VERTICES = 5, 3, 36


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def check(condition, what):
    if not condition:
        sys.exit(f"not as expected: {what}")


def points(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def lines(data):
    ids = vtk.vtkIdList()
    cells = data.GetLines()
    cells.InitTraversal()
    found = []
    while cells.GetNextCell(ids):
        found.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    return found


def main(folder):
    expected_lines = [list(range(12 * s, 12 * s + 12)) for s in range(STRANDS)]
    before = None
    for frame in range(FRAMES):
        name = f"{folder}/frames/frame_{frame:05}"
        vtp = read(vtk.vtkXMLPolyDataReader(), name + ".vtp")
        obj = read(vtk.vtkOBJReader(), name + ".obj")
        check(vtp.GetNumberOfPoints() == VERTICES, "points of the vtp")
        check(points(vtp) == points(obj), "the points of vtp and obj are the same")
        check(points(vtp) != before, "strands that move")
        check(lines(vtp) == expected_lines and lines(obj) == expected_lines, "lines")
        radius = vtp.GetPointData().GetArray("radius")
        ends = [struct.pack("f", radius.GetValue(i)) for i in (0, 11)]
        check(ends == [struct.pack("f", r) for r in (2e-3, 1e-3)], "radii")
        time = vtp.GetFieldData().GetArray("TimeValue").GetValue(0)
        check(abs(time - frame / 30) < 1e-6, "time")
        before = points(vtp)


main(sys.argv[1])
