# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the operators of Blender with those of our add-on, and measures what the add-on takes beside the module:
blender --background --factory-startup --python blender.py -- ADD-ON [MODULE] [--demo FOLDER] [--only NAME,...]
or, in bpy from PyPI, python blender.py -- ADD-ON ...
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

MODELS = ["suzanne", "bones", "elephant", "cow", "homer", "fandisk", "lion-head", "camel", "bear", "armadillo"]
MARGIN = 4 / 1024  # between islands, of the square: as ours by default
COLUMNS = {  # the title of a number, and its format
    "islands": "{:,.0f}",
    "seams": "{:.1f}",
    "angle change": "{:.2f}°",
    "stretch": "{:.3f}",
    "flips": "{:,.0f}",
    "overlaps": "{:,.0f}",
    "covered": "{:.0f} %",
    "seconds": "{:.2f}",
}


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


def with_known(operator, **options):
    """Calls an operator with those of the options that this version of Blender has."""
    known = operator.get_rna_type().properties
    return operator(**{name: value for name, value in options.items() if name in known})


def unwrap(method):
    with_known(bpy.ops.uv.unwrap, method=method, margin=MARGIN, margin_method="FRACTION")


def minimum_stretch():
    """A method from Blender 4.3 on, and an operator before that."""
    methods = bpy.ops.uv.unwrap.get_rna_type().properties["method"].enum_items.keys()
    if "MINIMUM_STRETCH" in methods:
        unwrap("MINIMUM_STRETCH")
    else:
        unwrap("ANGLE_BASED")
        bpy.ops.uv.minimize_stretch(iterations=100)
        pack()


def smart_project():
    with_known(
        bpy.ops.uv.smart_project, angle_limit=math.radians(66), island_margin=MARGIN, margin_method="FRACTION"
    )


def pack():
    with_known(bpy.ops.uv.pack_islands, margin=MARGIN, margin_method="FRACTION", shape_method="CONCAVE")


# The first marks the seams that all but Smart UV Project unwrap along. The last two pack the islands before them.
OPERATORS = {
    "Auto Seams and Unwrap": lambda: bpy.ops.uv.abf_auto_seams(),
    "Unwrap (ABF++)": lambda: bpy.ops.uv.abf_unwrap(),
    "Unwrap (ABF++) for angles": lambda: bpy.ops.uv.abf_unwrap(purpose="conformal"),
    "*Smart UV Project*": smart_project,
    "*Minimum Stretch*": minimum_stretch,
    "*Conformal*": lambda: unwrap("CONFORMAL"),
    "*Angle Based*": lambda: unwrap("ANGLE_BASED"),
    "*Pack Islands*": pack,
    "Pack (Certified)": lambda: bpy.ops.uv.abf_pack(),
}


def measure(found, seconds):
    """The numbers of a row."""
    from abf_unwrap.blender_mesh import read_mesh
    from abf_unwrap.islands import islands_of, joined_corners

    mesh = read_mesh(found, "ALL")
    uv = mesh.uv.astype(float)
    lengths = np.linalg.norm(np.diff(mesh.vertices[mesh.edges].astype(float), axis=1)[:, 0], axis=1)
    has_two_faces = np.bincount(mesh.corner_edges, minlength=len(mesh.edges)) >= 2
    islands = islands_of(mesh, by_uv=True)
    joined = joined_corners(mesh, by_uv=True)  # at the begin of each edge, and then at the end of each
    has_two_faces[mesh.corner_edges[joined[: len(joined) // 2, 0]]] = False
    areas = np.empty(len(found.data.polygons))
    found.data.polygons.foreach_get("area", areas)
    measures, certificate = abf.measure(mesh.vertices, mesh.polygons, uv), abf.certify(mesh.vertices, mesh.polygons, uv)
    return [
        len(islands),
        lengths[has_two_faces].sum() / math.sqrt(areas.sum()),
        math.degrees(measures["mean_angle_change"]),
        measures["l2_stretch"],
        len(certificate.flipped),
        len(certificate.overlapping),
        100 * sum(np.abs(each.signed_areas(uv[each.corners])).sum() for each in islands),
        seconds,
    ]


def cells_of(numbers):
    return [form.format(number) for form, number in zip(COLUMNS.values(), numbers)]


def compare(name, folder):
    """The rows of a model. All operators run in edit mode, as Blender's own do."""
    found, rows = add_model(name, folder), []
    for operator, run in OPERATORS.items():
        bpy.ops.object.mode_set(mode="EDIT")
        begin, failure = time.perf_counter(), None
        try:
            run()
        except RuntimeError as error:
            failure = str(error).splitlines()[0].split(";")[0]
        seconds = time.perf_counter() - begin
        bpy.ops.object.mode_set(mode="OBJECT")
        numbers = measure(found, seconds) if failure is None else None
        rows.append(([name, f"{len(found.data.polygons):,}", operator], numbers, failure))
        print(rows[-1], file=sys.stderr, flush=True)
    return rows


def summary(rows):
    """A row for each operator: sums of counts and seconds, and means of the rest, over the models that it has done."""
    table_rows = []
    for operator in OPERATORS:
        numbers = [numbers for cells, numbers, _ in rows if cells[2] == operator and numbers is not None]
        failures = sum(cells[2] == operator and numbers is None for cells, numbers, _ in rows)
        if numbers:
            sums, means = np.sum(numbers, axis=0), np.mean(numbers, axis=0)
            whole = [sums[k] if title in ("islands", "flips", "overlaps", "seconds") else means[k]
                     for k, title in enumerate(COLUMNS)]
            table_rows.append([operator, *cells_of(whole), f"{failures}"])
    return table(["operator", *COLUMNS, "refused"], table_rows)


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


def many_islands(columns=50, rows=40):
    """The seconds that Blender's packer and ours take for many islands of various sizes."""
    scenes.clear()
    random = np.random.default_rng(1)
    vertices, faces = [], []
    for k in range(columns * rows):
        width, height = random.uniform(0.1, 1, 2)
        corners = ((0, 0), (width, 0), (width, height), (0, height))
        vertices += [(x + k % columns, y + k // columns, 0) for x, y in corners]
        faces.append(range(4 * k, 4 * k + 4))
    found = scenes.add("islands", vertices, faces, uv=np.array(vertices)[:, :2])
    scenes.select_faces(found, np.ones(len(faces)))
    bpy.context.tool_settings.use_uv_select_sync = True
    for name in ("*Pack Islands*", "Pack (Certified)"):
        bpy.ops.object.mode_set(mode="EDIT")
        begin = time.perf_counter()
        OPERATORS[name]()
        seconds = time.perf_counter() - begin
        bpy.ops.object.mode_set(mode="OBJECT")
        covered = measure(found, seconds)[-2]
        print(f"{columns * rows:,} islands, {name}: {seconds:.2f} s, {covered:.0f} % covered")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("addon")
    parser.add_argument("module", nargs="?")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--only", default=",".join(MODELS), metavar="NAME,...")
    options = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    names = [name for name in options.only.split(",") if options.demo or name == "suzanne"]
    rows = [row for name in names for row in compare(name, options.demo)]
    print(f"Blender {bpy.app.version_string}\n")
    all_cells = [[*cells, *([failure] if numbers is None else cells_of(numbers))] for cells, numbers, failure in rows]
    print(table(["model", "faces", "operator", *COLUMNS], all_cells, 3))
    print(summary(rows))
    many_islands()
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
