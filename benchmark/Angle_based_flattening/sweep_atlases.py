#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `flatten_mesh` on every mesh in a folder, within a limit of time, and looks at each atlas as other programs read it: polygons
are fans from any corner. The exit status is 0 only if there was no crash, no timeout, no flip, no overlap, and no face without
coordinates that the report does not name."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

import numpy

import run
from report import Report, row, table

TITLES = ["file", "triangles", "charts", "status", "worst L2 stretch", "CPU s", "fault"]
Corners = list[tuple[int, int]]  # point, texture point


def read_obj(file: Path) -> tuple[numpy.ndarray, list[Corners], int]:
    """The texture points, the faces with coordinates, and the number of those without"""
    texture, faces, without = [], [], 0
    for line in file.read_text(encoding="utf-8", errors="replace").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "vt":
            texture.append((float(words[1]), float(words[2])))
        elif words[0] == "f":
            corners = [word.split("/") for word in words[1:]]
            if len({corner[1] for corner in corners if len(corner) > 1}) > 1:  # the same at all corners stand for none
                faces.append([(int(corner[0]), int(corner[1]) - 1) for corner in corners])
            else:
                without += 1
    return numpy.array(texture).reshape(-1, 2), faces, without


def turns(p: numpy.ndarray, q: numpy.ndarray, r: numpy.ndarray) -> numpy.ndarray:
    a, b = q - p, r - p
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def flipped_fans(uv: numpy.ndarray, faces: list[Corners]) -> int:
    """The number of faces of which a fan from some corner has a triangle that is not positively oriented: those that are not
    strictly convex"""
    by_size = defaultdict(list)
    for face in faces:
        by_size[len(face)].append([t for _, t in face])
    flipped = 0
    for polygons in by_size.values():
        p = uv[numpy.array(polygons)]
        flipped += int((turns(p, numpy.roll(p, -1, 1), numpy.roll(p, -2, 1)) <= 0).any(1).sum())
    return flipped


def border_sides(faces: list[Corners]) -> numpy.ndarray:
    """The sides of faces, as texture points, that no other face of the same chart has"""
    count: dict[tuple[int, int], int] = {}
    for face in faces:
        for (_, s), (_, t) in zip(face, face[1:] + face[:1]):
            count[s, t] = count.get((s, t), 0) + 1
    return numpy.array([side for side in count if side[::-1] not in count])


def crossings(uv: numpy.ndarray, sides: numpy.ndarray) -> int:
    """The number of pairs of sides that cross. Sides that only touch do not."""
    p, q = uv[sides[:, 0]], uv[sides[:, 1]]
    cell = max(float(numpy.abs(q - p).max(initial=0)) / 4, 1 / 512)
    cells = defaultdict(set)
    low, high = numpy.floor(numpy.minimum(p, q) / cell).astype(int), numpy.floor(numpy.maximum(p, q) / cell).astype(int)
    for i, ((x0, y0), (x1, y1)) in enumerate(zip(low, high)):
        for x in range(x0, x1 + 1):
            for y in range(y0, y1 + 1):
                cells[x, y].add(i)
    found = set()
    for inside in cells.values():
        index = numpy.fromiter(sorted(inside), int)
        for k, i in enumerate(index[:-1]):
            j = index[k + 1:]
            is_crossed = ((turns(p[i], q[i], p[j]) * turns(p[i], q[i], q[j]) < 0)
                          & (turns(p[j], q[j], p[i]) * turns(p[j], q[j], q[i]) < 0))
            found.update((int(i), int(other)) for other in j[is_crossed])
    return len(found)


def covered_more_than_once(uv: numpy.ndarray, faces: list[Corners], sides: numpy.ndarray) -> int:
    """Of one face of each chart: how many have a centre around which the sides of all charts do not wind exactly once. With fans
    that are not flipped, and sides that do not cross, that is the case everywhere in a chart if it is at one place."""
    parent = list(range(len(uv)))

    def find(v: int) -> int:
        while parent[v] != v:
            parent[v] = v = parent[parent[v]]
        return v

    for face in faces:
        for _, t in face[1:]:
            parent[find(t)] = find(face[0][1])
    first = {find(face[0][1]): face for face in reversed(faces)}
    p, q = uv[sides[:, 0]], uv[sides[:, 1]]
    wrong = 0
    for face in first.values():
        centre = uv[[t for _, t in face]].mean(0)
        up, down = (p[:, 1] <= centre[1]) & (q[:, 1] > centre[1]), (p[:, 1] > centre[1]) & (q[:, 1] <= centre[1])
        side = turns(p, q, centre)
        wrong += int((up & (side > 0)).sum()) - int((down & (side < 0)).sum()) != 1
    return wrong


def fault_of(atlas: Path, record: dict) -> str:
    uv, faces, without = read_obj(atlas)
    named = sum(part["faces"] for part in record["skipped"])
    if without > named:
        return f"{without} faces without coordinates, of which {named} are named"
    if not faces:
        return ""
    sides = border_sides(faces)
    checks = {"polygons that fans spoil": flipped_fans(uv, faces), "crossings": crossings(uv, sides),
              "charts over others": covered_more_than_once(uv, faces, sides)}
    return "; ".join(f"{number} {what}" for what, number in checks.items() if number)


def sweep(program: Path, file: Path, seconds_per_100k: float, folder: Path) -> dict:
    atlas, json_file = folder / "atlas.obj", folder / "atlas.json"
    for old in (atlas, json_file):
        old.unlink(missing_ok=True)
    # a triangle takes some twenty bytes at least, in any format; the least limit is for what is small
    limit = max(10, seconds_per_100k * file.stat().st_size / 20 / 100000)
    before = os.times()
    try:
        done = subprocess.run([program, file, "--quiet", "--output", atlas, "--json", json_file], timeout=limit, check=False,
                              capture_output=True, env=os.environ | {"OPENBLAS_NUM_THREADS": "1"})
    except subprocess.TimeoutExpired:
        return {"fault": f"not done in {limit:.0f} s"}
    after = os.times()
    result: dict = {"cpu": after.children_user - before.children_user}
    if done.returncode not in (0, 2):
        return result | {"fault": f"exit status {done.returncode}"}
    record = json.loads(json_file.read_bytes().decode("utf-8"))
    charts = record["atlas"]["charts"] if record.get("atlas") else []
    result |= {"status": record["status"], "triangles": record.get("triangles", 0), "charts": len(charts),
               "stretch": max((chart["l2_stretch"] for chart in charts), default=0)}
    if record["status"] == "OK" and result["stretch"] > 2:
        result["fault"] = "a bad chart is called OK"
    elif atlas.exists():
        result["fault"] = fault_of(atlas, record)
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=run.EXAMPLES, help="with meshes; by default the data of the examples")
    parser.add_argument("--program", type=Path, default=run.ROOT / "build/apps/flatten_mesh/flatten_mesh")
    parser.add_argument("--limit", type=float, default=10, metavar="SECONDS", help="for 100,000 triangles (10)")
    parser.add_argument("--output", type=Path, help="write the report to this file as well")
    options = parser.parse_args()
    report = Report(options.output)
    report.add("# Sweep of atlases\n\n" + table(TITLES, []))
    faults, files = 0, run.mesh_files(options.folder, recursive=True)
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            m = sweep(options.program, file, options.limit, Path(folder))
            faults += bool(m.get("fault"))
            report.add(row([str(file.relative_to(options.folder)), str(m.get("triangles", "")), str(m.get("charts", "")), m.get("status", ""),
                            f"{m['stretch']:.3f}" if "stretch" in m else "", f"{m['cpu']:.2f}" if "cpu" in m else "", m.get("fault", "")]))
    report.add(f"\n{len(files)} files, {faults} faults.\n")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
