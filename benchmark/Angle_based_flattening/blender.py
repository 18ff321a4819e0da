# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the operators of Blender with those of our add-on, and measures what the add-on takes beside the module:
blender --background --factory-startup --python blender.py -- ADD-ON [MODULE] [--demo FOLDER] [--only NAME,...]
ADD-ON is the zip file, or the folder of the sources; then MODULE is the folder of the Python module."""

import argparse
import math
import os
import sys
import time
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "blender/test")]
import scenes
from addon import install
from report import table

MARGIN = 4 / 1024  # between islands, of the square: as ours by default
TITLES = ["model", "faces", "operator", "islands", "seams", "angle change", "stretch", "flips", "overlaps", "seconds"]


def read_off(file):
    """The vertices and the faces of an OFF file."""
    words = iter(" ".join(line.split("#")[0] for line in file.read_text().splitlines()).replace("OFF", "", 1).split())
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    points = [[float(next(words)) for _ in range(3)] for _ in range(vertices)]
    return points, [[int(next(words)) for _ in range(int(next(words)))] for _ in range(faces)]


def add_model(name, folder):
    """Blender's monkey, or a mesh of CGAL's demo; without loose vertices."""
    scenes.clear()
    if name == "suzanne":
        bpy.ops.mesh.primitive_monkey_add()
    else:
        scenes.add(name, *read_off(folder / f"{name}.off"))
    for layer in list(bpy.context.object.data.uv_layers):
        bpy.context.object.data.uv_layers.remove(layer)
    scenes.select_faces(bpy.context.object, np.ones(len(bpy.context.object.data.polygons)))
    bpy.context.tool_settings.use_uv_select_sync = True  # or some of Blender's operators want a selection of their own
    return bpy.context.object


def unwrap():
    bpy.ops.uv.unwrap(method="ANGLE_BASED", margin=MARGIN)


def minimize_stretch():
    """Blender's way to little stretch: a method of its own from 4.3 on, before that an operator."""
    methods = bpy.ops.uv.unwrap.get_rna_type().properties["method"].enum_items.keys()
    if "MINIMUM_STRETCH" in methods:
        bpy.ops.uv.unwrap(method="MINIMUM_STRETCH", margin=MARGIN)
    else:
        bpy.ops.uv.unwrap(method="ANGLE_BASED", margin=MARGIN)
        bpy.ops.uv.minimize_stretch(iterations=100)
        bpy.ops.uv.pack_islands(margin=MARGIN)


# The first marks the seams that all but the last unwrap along.
OPERATORS = {
    "Auto Seams and Unwrap": lambda: bpy.ops.uv.abf_auto_seams(),
    "Unwrap (ABF++), these seams": lambda: bpy.ops.uv.abf_unwrap(),
    "Unwrap (ABF++) for angles, these seams": lambda: bpy.ops.uv.abf_unwrap(purpose="conformal"),
    "Blender: Unwrap, these seams": unwrap,
    "Blender: Minimize Stretch, these seams": minimize_stretch,
    "Blender: Smart UV Project": lambda: bpy.ops.uv.smart_project(angle_limit=math.radians(66), island_margin=MARGIN),
}


def measure(found, seconds):
    """The cells of a row."""
    from abf_unwrap.blender_mesh import read_mesh
    from abf_unwrap.islands import islands_of, joined_corners

    mesh = read_mesh(found, "ALL")
    uv = mesh.uv.astype(float)
    lengths = np.linalg.norm(np.diff(mesh.vertices[mesh.edges].astype(float), axis=1)[:, 0], axis=1)
    has_two_faces = np.bincount(mesh.corner_edges, minlength=len(mesh.edges)) >= 2
    joined = joined_corners(mesh, by_uv=True)  # at the begin of each edge, and then at the end of each
    has_two_faces[mesh.corner_edges[joined[: len(joined) // 2, 0]]] = False
    areas = np.empty(len(found.data.polygons))
    found.data.polygons.foreach_get("area", areas)
    measures, certificate = abf.measure(mesh.vertices, mesh.polygons, uv), abf.certify(mesh.vertices, mesh.polygons, uv)
    return [
        f"{len(islands_of(mesh, by_uv=True)):,}",
        f"{lengths[has_two_faces].sum() / math.sqrt(areas.sum()):.1f}",
        f"{math.degrees(measures['mean_angle_change']):.2f}°",
        f"{measures['l2_stretch']:.3f}",
        f"{len(certificate.flipped):,}",
        f"{len(certificate.overlapping):,}",
        f"{seconds:.2f}",
    ]


def compare(name, folder):
    """The rows of a model. All operators run in edit mode, as Blender's own do."""
    found, rows = add_model(name, folder), []
    for operator, run in OPERATORS.items():
        bpy.ops.object.mode_set(mode="EDIT")
        begin = time.perf_counter()
        run()
        seconds = time.perf_counter() - begin
        bpy.ops.object.mode_set(mode="OBJECT")
        rows.append([name, f"{len(found.data.polygons):,}", operator, *measure(found, seconds)])
        print(rows[-1], file=sys.stderr, flush=True)
    return rows


def overhead(mode, squares=316, repeat=5):
    """The number of quads of a grid, and the least seconds that an operator takes for it beside the module. They are those
    of the processor, so that other programs do not count."""
    from abf_unwrap.mesh_arrays import MeshResult, TaskResult
    from abf_unwrap.session import Session

    scenes.clear()
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=squares, y_subdivisions=squares)
    bpy.ops.object.mode_set(mode=mode)
    times = []
    for _ in range(repeat):
        begin = time.process_time()
        session = Session(bpy.context, lambda meshes, progress: None)
        mesh = session.meshes[0]
        session.job.result = TaskResult([MeshResult(mesh.uv.astype(float), np.zeros(len(mesh.edges), bool))], "")
        session.finish(lambda kind, message: None)
        times.append(time.process_time() - begin)
    bpy.ops.object.mode_set(mode="OBJECT")
    return mesh.number_of_faces, min(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("addon")
    parser.add_argument("module", nargs="?")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--only", default="suzanne,cow,fandisk,camel,armadillo", metavar="NAME,...")
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    names = [name for name in options.only.split(",") if options.demo or name == "suzanne"]
    rows = [cells for name in names for cells in compare(name, options.demo)]
    print(f"Blender {bpy.app.version_string}\n")
    print(table(TITLES, rows, 3))
    for mode in ("OBJECT", "EDIT"):
        faces, seconds = overhead(mode)
        print(f"{faces:,} quads in {mode.lower()} mode: {seconds:.3f} s beside the module")


if __name__ == "__main__":
    abf = install()
    try:
        main()
    except SystemExit as error:
        os._exit(int(bool(error.code)))
    sys.stdout.flush()
    os._exit(0)
