#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares flatten_mesh with other programs that make atlases, and with other maps of its charts: peers.py FLATTEN_MESH
FOLDER MESH... The folder gets an environment with the libraries, and all results. Each run is a process of its own,
with limits of time and memory. It is repeated to see whether its results have the same bits. evaluator.py measures
all. With --only, only the named atlases are made: "module" is parametrize() of the Python module, in PYTHONPATH."""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

from evaluator import charts_and_seams, evaluate, merged
from report import table

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[1] / "test/python"))
import program  # noqa: E402

PACKAGES = {"numpy": "numpy==2.4.6", "scipy": "scipy==1.17.1", "xatlas": "xatlas==0.0.11",
            "uvunwrap": "uvunwrap==0.3.0", "geotex": "geotex==0.1.3", "open3d": "open3d-cpu==0.20.0",
            "igl": "libigl==2.6.3"}
ATLASES = {"ours": "flatten_mesh", "module": "parametrize()", "xatlas": "xatlas 0.0.11",
           "uvunwrap": "uvunwrap 0.3.0", "geotex": "geotex 0.1.3", "open3d": "Open3D 0.20.0, UVAtlas"}
MAPS = {"ours": "flatten_mesh, with these seams", "lscm": "libigl 2.6.3, LSCM", "arap": "libigl 2.6.3, ARAP",
        "slim": "libigl 2.6.3, SLIM", "cgal-lscm": "CGAL, LSCM", "cgal-arap": "CGAL, ARAP"}
FAULTS = [("flipped", "flipped", ",.0f"), ("no area", "unmapped", ",.0f"), ("overlaps", "within", ",.0f")]
QUALITY = [("E", "density", ".3f"), ("w05", "w05", ".3f"), ("symmetric Dirichlet", "dirichlet", ".4g")]
OF_ATLASES = [("charts", "charts", ",.0f"), ("seam", "seam", ".1f"), *FAULTS, ("between charts", "between", ",.0f"),
              *QUALITY, ("covered", "covered", ".3f")]
OF_MAPS = [("charts mapped", "charts", ",.0f"), *FAULTS, *QUALITY]


class Failure(Exception):
    """Why there is no result"""


def limited(options, *command, source=os.devnull, output=os.devnull, result):
    """The processor time and the peak memory of a process, which ends at the limits, and has to write a file"""
    result.unlink(missing_ok=True)
    report, log = options.folder / "used.json", options.folder / "log.txt"
    with open(source, "rb") as stdin, open(output, "wb") as stdout, open(log, "wb") as stderr:
        subprocess.run([sys.executable, HERE / "confined.py", str(options.seconds), str(options.gigabytes), report,
                        *command], stdin=stdin, stdout=stdout, stderr=stderr, check=True, cwd=options.folder,
                       env=os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"})
    used = json.loads(report.read_text(encoding="ascii"))
    if used["failure"]:
        raise Failure(used["failure"])
    if not result.is_file() or not result.stat().st_size:
        lines = [line for line in log.read_text(errors="replace").splitlines() if line.strip("\x1b[0m; ")]
        told = lines[-1].rpartition(": ")[2] if lines else "no result"
        raise Failure("not to be had" if "No module named" in told else f"failed: {told}")
    return used["seconds"], used["megabytes"]


def of_library(options, tool, mesh):
    """Vertices, faces and coordinates of their corners; the area of the page, processor time and memory"""
    result = options.folder / "result.npz"
    _, megabytes = limited(options, options.python, HERE / "peer_tools.py", tool, mesh, result, result=result)
    numbers = np.load(result)
    return (*surface(mesh), numbers["corners"]), float(numbers["page"]), float(numbers["seconds"]), megabytes


def of_program(options, file, *arguments):
    output = file.with_name(f"{file.stem}-atlas.obj")
    used = limited(options, options.program, file, "--quiet", "--threads", "1", "--output", output, *arguments,
                   result=output)
    lines = [line.split() for line in output.read_text(encoding="utf-8").splitlines()]
    vertices, uvs = (np.array([line[1:] for line in lines if line[:1] == [name]], float) for name in ("v", "vt"))
    rows = np.array([[word.split("/")[:2] for word in line[1:]] for line in lines if line[:1] == ["f"]], int) - 1
    return (vertices, merged(vertices, rows[..., 0]), uvs[rows[..., 1]]), 1., *used


def of_cgal(options, method, charts):
    cgal, source, result = (options.folder / name for name in ("cgal_maps", "charts.txt", "coordinates.txt"))
    if not cgal.is_file():
        raise Failure("not to be had")
    vertices, faces = surface(charts)
    uses = []
    with source.open("w", encoding="ascii") as file:
        for rows in np.split(faces, np.cumsum(np.load(charts)["sizes"])[:-1]):
            used, local = np.unique(rows, return_inverse=True)
            uses.append(used)
            file.write(f"{len(used)} {len(rows)}\n")
            file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices[used].tolist())
            file.writelines(f"{a} {b} {c}\n" for a, b, c in local.reshape(-1, 3).tolist())
    _, megabytes = limited(options, cgal, method, source=source, output=result, result=result)
    numbers, uv, place = np.array(result.read_text(encoding="ascii").split(), float), np.zeros((len(vertices), 2)), 1
    for used in uses:
        of_chart = numbers[place + 1:place + 1 + 2 * len(used)].reshape(-1, 2)
        uv[used] = of_chart if np.isfinite(of_chart).all() else 0
        place += 1 + 2 * len(used)
    return (vertices, faces, uv[faces]), 1., numbers[0], megabytes


def surface(file):
    arrays = np.load(file)
    return arrays["vertices"], arrays["faces"]


def write_charts(vertices, faces, corners, file):
    """The charts of an atlas as surfaces of their own, one after the other; returns their number"""
    chart, _ = charts_and_seams(faces, corners)
    rows = np.column_stack([np.repeat(chart, 3), faces.reshape(-1), corners.reshape(-1, 2)])
    points, place = np.unique(rows, axis=0, return_inverse=True)
    sizes = np.unique(chart, return_counts=True)[1]
    np.savez(file, vertices=vertices[points[:, 1].astype(int)],
             faces=place.reshape(-1, 3)[np.argsort(chart, kind="stable")], sizes=sizes)
    return len(sizes)


def measured(what, columns, run, *arguments):
    """The cells of a row, and the atlas. The row is also told at once, so that nothing is lost if this is stopped."""
    atlas = None
    try:
        atlas, page, seconds, megabytes = run(*arguments)
        numbers = evaluate(*atlas, page if columns is OF_ATLASES else None)
        cells = [format(numbers[name], form) for _, name, form in columns]
        row = [*what, f"{seconds:.2f}", f"{megabytes:,.0f}", *cells]
        row.append("yes" if all(map(np.array_equal, atlas, run(*arguments)[0])) else "NO")
    except Failure as failure:
        row = [*(row if atlas else what), str(failure)]
    print(*row, sep=" | ", file=sys.stderr, flush=True)
    return row, atlas


def rows_of(options, mesh):
    """Of both tables"""
    name, charts = f"{mesh.stem}, {len(surface(mesh)[1]):,}", mesh.with_name(f"{mesh.stem}-charts.npz")
    atlases, ours = [], None
    for tool in options.only:
        run = (of_program, options, mesh.with_suffix(".obj")) if tool == "ours" else (of_library, options, tool, mesh)
        row, atlas = measured((name, ATLASES[tool]), OF_ATLASES, *run)
        atlases.append(row)
        ours = atlas if tool == "ours" else ours
    if not ours:
        return atlases, []
    name += f"; {write_charts(*ours, charts)} charts"
    maps = []
    for tool, title in MAPS.items():
        run = (of_program, options, mesh.with_name(f"{mesh.stem}-atlas.obj"), "--seams-from", "uv",
               "--stretch-bound", "inf") if tool == "ours" \
            else (of_cgal, options, tool[5:], charts) if tool[:5] == "cgal-" else (of_library, options, tool, charts)
        maps.append(measured((name, title), OF_MAPS, *run)[0])
    return atlases, maps


def install(options):
    """The environment, and CGAL's maps. What cannot be had leaves a row that says so."""
    options.folder.mkdir(parents=True, exist_ok=True)
    options.python = options.folder / "environment/bin/python"
    if not options.python.is_file():
        subprocess.run([sys.executable, "-m", "venv", options.folder / "environment"], check=True)
    for module, package in PACKAGES.items():
        if module in ATLASES and module not in options.only:
            continue
        if subprocess.run([options.python, "-c", f"import {module}"], stderr=subprocess.DEVNULL,
                          check=False).returncode:
            subprocess.run([options.python, "-m", "pip", "install", "--quiet", package], check=False)
    if "ours" in options.only and not (options.folder / "cgal_maps").is_file():
        subprocess.run(["g++", "-O2", "-DNDEBUG", "-std=c++17", "-DCGAL_EIGEN3_ENABLED", "-isystem",
                        "/usr/include/eigen3", HERE / "methods/cgal_maps.cpp", "-o", options.folder / "cgal_maps",
                        "-lgmp", "-lmpfr"], check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=lambda name: Path(name).resolve(), help="flatten_mesh")
    parser.add_argument("folder", type=lambda name: Path(name).resolve(), help="for the environment and the results")
    parser.add_argument("meshes", type=Path, nargs="*", default=[HERE / "data/shell.off"], metavar="MESH",
                        help="OFF, OBJ, PLY or STL, of triangles; by default a sea shell")
    parser.add_argument("--seconds", type=float, default=600, help="of processor time of a run (%(default)s)")
    parser.add_argument("--gigabytes", type=float, default=8, help="of memory of a run (%(default)s)")
    parser.add_argument("--only", type=lambda names: names.split(","), metavar="NAME,...",
                        default=[name for name in ATLASES if name != "module"], help="of " + ", ".join(ATLASES))
    options = parser.parse_args()
    install(options)
    atlases, maps = [], []
    for file in options.meshes:
        mesh = options.folder / f"{file.stem}.npz"
        subprocess.run([options.python, HERE / "peer_tools.py", "read", file, mesh], check=True, stdout=sys.stderr)
        program.write_obj(mesh.with_suffix(".obj"), *surface(mesh))
        for rows, more in zip((atlases, maps), rows_of(options, mesh)):
            rows += more
    for title, columns, rows in (("Atlases", OF_ATLASES, atlases), ("Maps of the same charts", OF_MAPS, maps)):
        if not rows:
            continue
        titles = ["mesh, triangles", "program", "CPU s", "MB", *(title for title, _, _ in columns), "same bits"]
        print(f"### {title}\n\n{table(titles, rows, 2)}")


if __name__ == "__main__":
    main()
