"""Loads a run of ringlet into Blender 3.4 or later, as curves that move with the timeline:

    blender --python plugins/blender/load_run.py -- DIR

DIR holds frames.bin, which the writer `frames` makes, or frames/frame_<step>.obj. Each state is a
frame of the timeline, from 0 on. The strands are read again at each frame, so that a long run needs
no memory; a .blend that is saved keeps those of its last frame alone.
"""

import json
import math
import os
import re
import struct
import sys
from array import array

import bpy

RADIUS = 4e-5  # m, where a file has none


class BinaryFrames:
    """frames.bin, as plugins/frames/frames_format.h describes it."""

    def __init__(self, path):
        self.file = open(path, "rb")
        if self.file.read(16) != b"ringlet frames 2":
            raise ValueError(f"{path} does not begin with 'ringlet frames 2'")
        (length,) = struct.unpack("<Q", self.file.read(8))
        header = json.loads(self.file.read(length))
        self.counts = header["vertex_counts"]
        vertices = sum(self.counts)
        self.radii = array("f", self.file.read(4 * vertices))
        self.first = self.file.tell() + 8  # after a checksum
        self.number = "f" if header["precision"] == "single" else "d"
        self.bytes = 3 * vertices * array(self.number).itemsize
        self.size = (os.path.getsize(path) - self.first) // (self.bytes + 24)

    def __len__(self):
        return self.size

    def read(self, number, offset, count):
        self.file.seek(self.first + number * (self.bytes + 24) + offset)
        return self.file.read(count)

    def positions(self, number):
        return array("f", array(self.number, self.read(number, 16, self.bytes)))

    def time(self, number):
        return struct.unpack("<d", self.read(number, 8, 8))[0]

    def frames_per_second(self):
        return 1 / (self.time(1) - self.time(0)) if len(self) > 1 else 24


def strands_of(path):
    """Vertices of each strand of an .obj. Edges that follow each other are one strand."""
    counts, last = [], None
    with open(path) as file:
        for line in file:
            if not line.startswith("l "):
                continue
            vertices = line.split()[1:]
            if vertices[0] == last:
                counts[-1] += len(vertices) - 1
            else:
                counts.append(len(vertices))
            last = vertices[-1]
    return counts


class ObjFrames:
    """A sequence of .obj files, whose strands are those of the first."""

    def __init__(self, folder):
        files = [f for f in os.listdir(folder) if re.fullmatch(r"frame_\d+\.obj", f)]
        self.files = [os.path.join(folder, f)
                      for f in sorted(files, key=lambda f: int(re.search(r"\d+", f)[0]))]
        if not self.files:
            raise FileNotFoundError(f"there is neither frames.bin nor {folder}/frame_<step>.obj")
        self.counts = strands_of(self.files[0])
        self.radii = array("f", [RADIUS] * sum(self.counts))

    def __len__(self):
        return len(self.files)

    def positions(self, number):
        with open(self.files[number]) as file:
            return array("f", [float(x) for line in file if line.startswith("v ")
                               for x in line.split()[1:4]])

    def frames_per_second(self):
        return 24


def open_run(folder):
    binary = os.path.join(folder, "frames.bin")
    if os.path.exists(binary):
        return BinaryFrames(binary)
    return ObjFrames(os.path.join(folder, "frames"))


def make_curves(run, name):
    curves = bpy.data.curves.new(name, "CURVE")
    curves.dimensions = "3D"
    curves.bevel_depth = 1  # m; times the radius of each point
    curves.bevel_resolution = 0  # thin as they are, four sides will do, and take a third of the time
    first = 0
    for count in run.counts:
        spline = curves.splines.new("POLY")
        spline.points.add(count - 1)
        spline.points.foreach_set("radius", run.radii[first:first + count])
        first += count
    strands = bpy.data.objects.new(name, curves)
    strands.rotation_euler = (math.pi / 2, 0, 0)  # +y is up in ringlet, +z in Blender
    bpy.context.scene.collection.objects.link(strands)
    return curves


def place(curves, positions):
    points = array("f", [1]) * (len(positions) // 3 * 4)
    for axis in range(3):
        points[axis::4] = positions[axis::3]
    first = 0
    for spline in curves.splines:
        end = first + 4 * len(spline.points)
        spline.points.foreach_set("co", points[first:end])
        first = end
    curves.update_tag()


def load_run(folder):
    run = open_run(folder)
    curves = make_curves(run, os.path.basename(os.path.abspath(folder)))
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 0, len(run) - 1
    scene.render.fps = max(1, round(run.frames_per_second()))

    def follow(scene, _=None):
        place(curves, run.positions(min(max(scene.frame_current, 0), len(run) - 1)))

    bpy.app.handlers.frame_change_pre.append(follow)
    scene.frame_set(0)
    print(f"{len(run.counts)} strands, {len(run)} frames of {folder}")
    return curves


if __name__ == "__main__":
    if "--" not in sys.argv or len(sys.argv) != sys.argv.index("--") + 2:
        sys.exit("expected: blender --python load_run.py -- DIR")
    load_run(sys.argv[-1])
