#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs charts by `pack_charts()` and, for comparison, by the rectangles around them: charts of surfaces that are cut open and split
where they overlap, and of surfaces that are cut into many regions."""

import argparse
import math
import statistics
from pathlib import Path

import run
from report import Report, Table, Targets, head

MODELS = ["cow", "homer", "camel", "elephant", "fandisk", "anchor_dense", "turbine", "bunny00", "armadillo"]
COLUMNS = [("charts", "charts", ",.0f"), ("covered share", "share", ".3f"), ("of rectangles", "rectangle_share", ".3f"),
           ("ratio", "ratio", ".2f"), ("attempts", "attempts", ".0f"), ("seconds", "seconds", "seconds"),
           ("rectangles", "rectangle_seconds", "seconds")]
PAGES = [("charts", "charts", ",.0f"), ("pages", "pages", ",.0f"), ("covered share", "share", ".3f"), ("seconds", "seconds", "seconds")]
LEAST = {"elephant": 0.49, "armadillo": 0.60}


def measure_all(measure: run.Measure, files: list[Path], title: str, options: argparse.Namespace, *, regions: int = 0,
                resolution: int = 1024, gutter: int = 2) -> str:
    table = Table(["surface", "triangles"], COLUMNS, 1)
    ratios, targets = [], Targets()
    for file in files:
        m = measure.one("packing", file, "--regions", regions, "--resolution", resolution, "--gutter", gutter, threads=options.threads)
        run.tell(file.stem, m)
        table.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else ""], m)
        if "failure" not in m:
            ratios.append(m["ratio"])
            if options.demo and resolution == 1024:
                least = LEAST.get(file.stem) if regions == 0 else 0.60 if regions < 1000 else None
                if least:
                    targets.add(f"{file.stem}, covered share", ".3f", m["share"], least=least)
    mean = math.exp(statistics.fmean(map(math.log, ratios))) if ratios else math.nan
    return (f"\n## {title}\n\n{table}\nCharts cover {mean:.2f} times the share that rectangles do, in the geometric mean.\n" +
            (str(targets) if targets.rows else ""))


def measure_pages(measure: run.Measure, files: list[Path], options: argparse.Namespace) -> str:
    table = Table(["surface", "triangles", "regions", "without gaps"], PAGES, 1)
    for file in files:
        for regions, pages in ((300, 5), (1000, 50), (3000, 50)):
            m = measure.one("packing", file, "--regions", regions, "--pages", pages, "--gutter", 4, threads=options.threads)
            run.tell(file.stem, m)
            table.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else "", f"{regions:,}", f"{pages} pages"], m)
    return ("\n## Several pages, gutter 4\n\nThe number of texels per unit of length is such that the charts would fill so many pages without gaps. "
            f"Covered share: of all pages.\n\n{table}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--regions", type=int, nargs="*", default=[30, 300, 3000], metavar="N", help="into which surfaces are cut (%(default)s)")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="of each run (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)

    report = Report(options.output)
    report.add(head("Packing", measure) + "Each surface is cut to disks, flattened by ABF++, and split by split_overlaps(). The charts are packed by pack_charts(), and by the skyline of "
               "their smallest rectangles. Covered share: the sum of the areas of the triangles in the unit square. Ratio: of both shares. "
               "Attempts: scales that were tried. Times are single ones, "
               f"on {options.threads} threads; those of pack_charts() include reading the mesh and the certificate.\n")
    if options.demo:
        files = [options.demo / f"{name}.off" for name in MODELS]
        large = [options.demo / f"{name}.off" for name in ("bunny00", "armadillo")]
    else:
        files = large = [run.EXAMPLES / "dinosaur.off", run.EXAMPLES / "egg.off"]
    report.add(measure_all(measure, files, "Few charts: seams for a stretch of 1.1", options))
    for number in options.regions:
        report.add(measure_all(measure, files if number < 1000 else large, f"Cut into {number} regions", options, regions=number))
    if options.demo:
        report.add(measure_all(measure, files, "Cut into 300 regions, 4096 texels, gutter 8", options, regions=300, resolution=4096, gutter=8))
    report.add(measure_pages(measure, large, options))


if __name__ == "__main__":
    main()
