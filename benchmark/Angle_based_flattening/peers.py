#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares flatten_mesh with other programs that make atlases, and with other maps of its charts: peers.py FLATTEN_MESH
FOLDER MESH... The folder gets an environment with the libraries, and all results. Each run is a process of its own, with
limits of time and memory, and is repeated to see whether its results have the same bits. All results are measured by
evaluator.py."""

import argparse
import json
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from evaluator import charts_and_seams, evaluate, merged
from report import DASH, table

HERE = Path(__file__).resolve().parent
PACKAGES = {"xatlas": "xatlas==0.0.11", "uvunwrap": "uvunwrap==0.3.0", "geotex": "geotex==0.1.3",
            "open3d": "open3d-cpu==0.20.0", "igl": "libigl==2.6.3"}
ATLASES = {"ours": "flatten_mesh", "xatlas": "xatlas 0.0.11", "uvunwrap": "uvunwrap 0.3.0", "geotex": "geotex 0.1.3",
           "open3d": "Open3D 0.20, UVAtlas"}
MAPS = {"ours": "flatten_mesh, with these seams", "lscm": "libigl 2.6.3, LSCM", "arap": "libigl 2.6.3, ARAP",
        "slim": "libigl 2.6.3, SLIM", "cgal-lscm": "CGAL, LSCM", "cgal-arap": "CGAL, ARAP"}
FAULTS = [("flipped", "flipped", ",.0f"), ("no area", "unmapped", ",.0f"), ("overlaps", "within", ",.0f")]
QUALITY = [("E", "density", ".3f"), ("w05", "w05", ".3f"), ("symmetric Dirichlet", "dirichlet", ".4g")]
OF_ATLASES = [("charts", "charts", ",.0f"), ("seam", "seam", ".1f"), *FAULTS, ("between charts", "between", ",.0f"),
              *QUALITY, ("covered", "covered", ".3f")]
OF_MAPS = [("charts mapped", "charts", ",.0f"), *FAULTS, *QUALITY]


class Failure(Exception):
    """Why there is no result"""


def limited(command, options, source=os.devnull, output=os.devnull):
    """The processor time and the peak memory of a process, which ends at the limits"""
    report = options.folder / "used.json"
    with open(source, "rb") as stdin, open(output, "wb") as stdout, open(options.folder / "log.txt", "wb") as log:
        subprocess.run([sys.executable, HERE / "confined.py", str(options.seconds), str(options.gigabytes), report,
                        *command], stdin=stdin, stdout=stdout, stderr=log, check=True, cwd=options.folder,
                       env=os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"})
    used = json.loads(report.read_text(encoding="ascii"))
    if used["failure"]:
        raise Failure(used["failure"])
    return used["seconds"], used["megabytes"]


def write_obj(file, vertices, faces):
    lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist()]
    file.write_text("".join(lines + [f"f {a} {b} {c}\n" for a, b, c in (faces + 1).tolist()]), encoding="ascii")


def read_obj(file):
    """Vertices, faces, and the coordinates of their corners"""
    lines = [line.split() for line in file.read_text(encoding="utf-8").splitlines()]
    vertices, uvs = (np.array([line[1:] for line in lines if line[:1] == [name]], float) for name in ("v", "vt"))
    rows = np.array([[word.split("/")[:2] for word in line[1:]] for line in lines if line[:1] == ["f"]], int) - 1
    return vertices, rows[..., 0], uvs[rows[..., 1]]


def last_line_of(log):
    lines = [line for line in log.read_text(errors="replace").splitlines() if line.strip(" \x1b[0m;")]
    return "failed: " + (lines[-1].rpartition(": ")[2] if lines else "no result")


def python(tool, file, options):
    """The corners that a library computes, and their page"""
    output = options.folder / "result.npz"
    output.unlink(missing_ok=True)
    _, megabytes = limited([options.python, HERE / "peer_tools.py", tool, file, output], options)
    if not output.is_file():
        raise Failure(last_line_of(options.folder / "log.txt"))
    return np.load(output), megabytes


def run_library(tool, mesh, options):
    result, megabytes = python(tool, mesh.with_suffix(".npz"), options)
    vertices, faces = mesh_of(mesh)
    return (vertices, faces, result["corners"]), float(result["page"]), float(result["seconds"]), megabytes


def run_ours(mesh, options, *arguments):
    output = mesh.with_name(f"{mesh.stem}-ours{len(arguments)}.obj")
    output.unlink(missing_ok=True)
    seconds, megabytes = limited([options.program, mesh, "--quiet", "--threads", "1", "--output", output,
                                     *arguments], options)
    if not output.is_file():
        raise Failure(last_line_of(options.folder / "log.txt"))
    vertices, faces, corners = read_obj(output)
    return (vertices, merged(vertices, faces), corners), 1.0, seconds, megabytes


def run_cgal(method, mesh, options):
    vertices, faces, sizes = (np.load(mesh.with_suffix(".npz"))[name] for name in ("vertices", "faces", "sizes"))
    source, output = options.folder / "charts.txt", options.folder / "coordinates.txt"
    uses = []
    with source.open("w", encoding="ascii") as file:
        for rows in np.split(faces, np.cumsum(sizes)[:-1]):
            used, local = np.unique(rows, return_inverse=True)
            uses.append(used)
            file.write(f"{len(used)} {len(rows)}\n")
            file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices[used].tolist())
            file.writelines(f"{a} {b} {c}\n" for a, b, c in local.reshape(-1, 3).tolist())
    program = options.folder / "cgal_maps"
    if not program.is_file():
        raise Failure("not to be had: CGAL's headers do not compile")
    _, megabytes = limited([program, method], options, source, output)
    numbers, uv, place = np.array(output.read_text(encoding="ascii").split(), float), np.zeros((len(vertices), 2)), 1
    for used in uses:
        of_chart = numbers[place + 1:place + 1 + 2 * len(used)].reshape(-1, 2)
        uv[used] = of_chart if np.isfinite(of_chart).all() else 0
        place += 1 + 2 * len(used)
    return (vertices, faces, uv[faces]), None, numbers[0], megabytes


def mesh_of(mesh):
    arrays = np.load(mesh.with_suffix(".npz"))
    return arrays["vertices"], arrays["faces"]


def write_charts(vertices, faces, corners, file):
    """The charts of an atlas as surfaces of their own, one after the other"""
    chart, _ = charts_and_seams(faces, corners)
    order = np.argsort(chart, kind="stable")
    rows = np.column_stack([np.repeat(chart, 3), faces.reshape(-1), corners.reshape(-1, 2)])
    points, place = np.unique(rows, axis=0, return_inverse=True)
    sizes = np.unique(chart, return_counts=True)[1]
    np.savez(file, vertices=vertices[points[:, 1].astype(int)], faces=place.reshape(-1, 3)[order], sizes=sizes)
    return len(sizes)


def measured(run, title, columns):
    """The cells of a run, and its atlas"""
    print(title, file=sys.stderr, flush=True)
    try:
        atlas, page, seconds, megabytes = run()
        numbers = evaluate(*atlas, page if columns is OF_ATLASES else None)
        try:
            same = "yes" if all(np.array_equal(a, b) for a, b in zip(atlas, run()[0])) else "NO"
        except Failure as failure:
            same = str(failure)
    except Failure as failure:
        return [str(failure)], None
    cells = [format(numbers[name], form) for _, name, form in columns]
    return [f"{seconds:.2f}", f"{megabytes:,.0f}", *cells, same], atlas


def rows_of(mesh, options):
    """Of both tables"""
    vertices, faces = mesh_of(mesh)
    name = f"{mesh.stem}, {len(faces):,}"
    atlases, maps, charts = [], [], mesh.with_name(f"{mesh.stem}-charts.obj")
    for tool in ATLASES:
        def run():
            return run_ours(mesh, options) if tool == "ours" else run_library(tool, mesh, options)
        cells, atlas = measured(run, f"{name}: {ATLASES[tool]}", OF_ATLASES)
        atlases.append([name, ATLASES[tool], *cells])
        if tool == "ours" and atlas:
            count = write_charts(*atlas, charts.with_suffix(".npz"))
    if not charts.with_suffix(".npz").is_file():
        return atlases, maps
    for tool in MAPS:
        def run():
            if tool == "ours":
                return run_ours(mesh.with_name(f"{mesh.stem}-ours0.obj"), options, "--seams-from", "uv")
            if tool.startswith("cgal-"):
                return run_cgal(tool[5:], charts, options)
            return run_library(tool, charts, options)
        cells, _ = measured(run, f"{name}: {MAPS[tool]}", OF_MAPS)
        maps.append([f"{name}; {count} charts", MAPS[tool], *cells])
    return atlases, maps


def install(options):
    """The environment, and CGAL's maps. What cannot be had leaves a row that says so."""
    options.folder.mkdir(parents=True, exist_ok=True)
    environment = options.folder / "environment"
    options.python = environment / "bin/python"
    if not options.python.is_file():
        subprocess.run([sys.executable, "-m", "venv", environment], check=True)
    for module, package in {"numpy": "numpy", "scipy": "scipy", **PACKAGES}.items():
        if subprocess.run([options.python, "-c", f"import {module}"], stderr=subprocess.DEVNULL, check=False).returncode:
            subprocess.run([options.python, "-m", "pip", "install", "--quiet", package], check=False)
    if not (options.folder / "cgal_maps").is_file():
        subprocess.run(["g++", "-O2", "-DNDEBUG", "-std=c++17", "-DCGAL_EIGEN3_ENABLED", "-isystem",
                        "/usr/include/eigen3", HERE / "methods/cgal_maps.cpp", "-o", options.folder / "cgal_maps",
                        "-lgmp", "-lmpfr"], check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="flatten_mesh")
    parser.add_argument("folder", type=Path, help="for the environment and the results")
    parser.add_argument("meshes", type=Path, nargs="*", metavar="MESH", help="OFF, OBJ, PLY or STL, of triangles")
    parser.add_argument("--seconds", type=float, default=600, help="of processor time of a run (%(default)s)")
    parser.add_argument("--gigabytes", type=float, default=8, help="of memory of a run (%(default)s)")
    options = parser.parse_args()
    options.program, options.folder = options.program.resolve(), options.folder.resolve()
    meshes = [file.resolve() for file in options.meshes] or [HERE / "data/shell.off"]
    install(options)
    atlases, maps = [], []
    for file in meshes:
        mesh = options.folder / f"{file.stem}.obj"
        subprocess.run([options.python, HERE / "peer_tools.py", "read", file, mesh.with_suffix(".npz")], check=True)
        write_obj(mesh, *mesh_of(mesh))
        for rows, more in zip((atlases, maps), rows_of(mesh, options)):
            rows += more
    for title, columns, rows in (("Atlases", OF_ATLASES, atlases), ("Maps of the same charts", OF_MAPS, maps)):
        titles = ["mesh, triangles", "program", "CPU s", "MB", *(title for title, _, _ in columns), "same bits"]
        print(f"### {title}\n\n{table(titles, rows, 2)}")


if __name__ == "__main__":
    main()
