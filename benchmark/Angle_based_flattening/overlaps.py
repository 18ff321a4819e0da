#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens disks, and closed surfaces cut open by `select_seams()`, by ABF++, and splits the charts where their maps overlap
themselves."""

import argparse
from pathlib import Path

import run
from report import Report, Table, head

DISKS = ["cow", "dino", "lionhead", "camel", "armadillo", "bunny", "horse"]
MODELS = ["cow", "homer", "camel", "elephant", "fandisk", "anchor_dense", "turbine", "bunny00", "armadillo"]
COLUMNS = [("overlapping", "overlapping", ",.0f"), ("pieces", "pieces", ".0f"), ("largest piece", "largest", ".2f"),
           ("extra seam, %", "extra_seam", ".1f"), ("seconds, map", "seconds", "seconds"),
           ("seconds, split", "split_seconds", "seconds")]


def measure_all(measure: run.Measure, files: list[Path], title: str, options: argparse.Namespace) -> str:
    table = Table(["surface", "triangles"], COLUMNS, 1)
    extra = []
    for file in files:
        m = measure.one("overlaps", file, "--bound", options.bound)
        run.tell(file.stem, m)
        table.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else ""], m)
        if "failure" not in m and m["pieces"] > 1:
            extra.append(m["extra_seam"])
    text = f"\n## {title}\n\n{table}"
    if extra:
        text += (f"\n{len(extra)} of {len(files)} overlap. Their new seams make the borders {sum(extra) / len(extra):.1f} % longer in "
                 f"the mean, {max(extra):.1f} % at most.\n")
    return text


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="with the disks")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--bound", type=float, default=1.1, metavar="X", help="of the stretch of closed surfaces (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)

    report = Report(options.output)
    report.add(head("Overlaps", measure) + "Each surface is flattened by ABF++, and split by split_overlaps(). Overlapping: the triangles that overlap others. "
               "Largest piece: its part of all triangles. Extra seam: by how much longer borders become; each new seam adds twice its length.\n")
    if options.data:
        report.add(measure_all(measure, [options.data / f"{name}_disk.ply" for name in DISKS], "Disks", options))
    if options.demo:
        report.add(measure_all(measure, [options.demo / f"{name}.off" for name in MODELS],
                               f"Surfaces that are cut open, bound {options.bound:g}", options))
    if not options.data and not options.demo:
        options.bound = 1.05
        report.add(measure_all(measure, [run.EXAMPLES / "dinosaur.off", run.EXAMPLES / "egg.off"], "Meshes of the examples", options))


if __name__ == "__main__":
    main()
