"""Compares what Blender's own importers make of a run with what load_run.py shows:

    blender --background --python read_with_blender.py -- LOAD_RUN.py DIR
"""

import os
import sys

import bpy

STRANDS, VERTICES, FRAMES = 3, 36, 5

script, folder = sys.argv[-2:]
sys.path.insert(0, os.path.dirname(script))
import load_run  # noqa: E402


def in_world(thing, coordinates):
    return [tuple(thing.matrix_world @ x.to_3d()) for x in coordinates]


def differ(a, b):
    """Whether two lists of points or numbers are not the same but for rounding."""
    flat = [[c for x in list_ for c in (x if isinstance(x, tuple) else (x,))] for list_ in (a, b)]
    return len(a) != len(b) or max(abs(p - q) for p, q in zip(*flat)) > 1e-6


def check(condition, what):
    if not condition:
        raise AssertionError(what)


def check_mesh(mesh, positions, what):
    edges = {tuple(sorted(edge.vertices)) for edge in mesh.data.edges}
    expected = {(v, v + 1) for v in range(VERTICES - 1) if v % 12 != 11}
    check(edges == expected, f"{what}: edges")
    check(not differ(in_world(mesh, [v.co for v in mesh.data.vertices]), positions),
          f"{what}: vertices")


curves = load_run.load_run(folder)
strands = next(o for o in bpy.data.objects if o.data == curves)
check(len(curves.splines) == STRANDS, "splines")
radii = [p.radius for p in curves.splines[0].points]
check(abs(radii[0] - 2e-3) < 1e-8 and abs(radii[-1] - 1e-3) < 1e-8, "radii")

before = None
for frame in range(FRAMES):
    bpy.context.scene.frame_set(frame)
    bpy.context.view_layer.update()
    points = in_world(strands, [p.co for s in curves.splines for p in s.points])
    check(before is None or differ(points, before), "strands that move")
    before = points

    name = os.path.join("frames", f"frame_{frame:05}")
    bpy.ops.import_scene.obj(filepath=os.path.join(folder, name + ".obj"))
    check_mesh(bpy.context.selected_objects[0], points, "obj, polylines")
    bpy.ops.wm.obj_import(filepath=os.path.join(folder, "edges", name + ".obj"))
    check_mesh(bpy.context.selected_objects[0], points, "obj, edges")
    bpy.ops.import_mesh.ply(filepath=os.path.join(folder, name + ".ply"))
    mesh = bpy.context.selected_objects[0]
    mesh.rotation_euler = strands.rotation_euler  # a .ply knows no axis that is up
    bpy.context.view_layer.update()
    check_mesh(mesh, points, "ply")
    binary = load_run.BinaryFrames(os.path.join(folder, "frames.bin"))
    for files in (os.path.join(folder, "frames"), os.path.join(folder, "edges", "frames")):
        obj = load_run.ObjFrames(files)
        check(obj.counts == binary.counts, "strands of both kinds of frames")
        check(not differ(obj.positions(frame), binary.positions(frame)), "both kinds of frames")
