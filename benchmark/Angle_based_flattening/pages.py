#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what `flatten_mesh --report` writes, beside an OBJ file of the same atlas, and what `--bake-from` takes, beside
the charts that it bakes into."""

import argparse
import json
import subprocess
from pathlib import Path

import run
from report import Report, Table, Targets, head

PAGES = [("page, MB", "megabytes", ".1f"), ("page, s", "page", "seconds"), ("OBJ, s", "obj", "seconds"), ("ratio", "ratio", ".2f")]
BAKING = [("texels of charts", "texels", ",.0f"), ("baking, s", "bake", "seconds"), ("microseconds a texel", "each", ".2f"),
          ("charts, s", "charts", "seconds"), ("ratio", "ratio", ".2f"), ("rays that missed, %", "missed", ".3f"),
          ("back faces, %", "back", ".3f")]


def flatten(options: argparse.Namespace, mesh: Path, *arguments: object) -> run.Measurement:
    """The report of a run, with the seconds of its stages"""
    done = subprocess.run([options.program, mesh, "--for", "few-charts", *map(str, arguments), "--threads", str(options.threads), "--json", "-"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    result = json.loads(done.stdout)
    return run.Measurement(result) if result["status"] == "OK" else run.Measurement(failure=result["message"])


def measure_page(options: argparse.Namespace, mesh: Path) -> run.Measurement:
    page, obj = Path(run.FOLDER.name) / "page.html", Path(run.FOLDER.name) / "surface.obj"
    with_page, with_obj = flatten(options, mesh, "--report", page), flatten(options, mesh, "--output", obj)
    for m in (with_page, with_obj):
        if "failure" in m:
            return m
    seconds, of_obj = with_page["seconds"]["write"], with_obj["seconds"]["write"]
    return run.Measurement(triangles=with_page["triangles"], megabytes=page.stat().st_size / 1e6, page=seconds, obj=of_obj,
                           ratio=seconds / of_obj)


def measure_baking(options: argparse.Namespace, simple: Path, fine: Path, resolution: int) -> run.Measurement:
    m = flatten(options, simple, "--bake-from", fine, "--output", Path(run.FOLDER.name) / "baked.obj", "--resolution", resolution)
    if "failure" in m:
        return m
    seconds, baking = m["seconds"], m["baking"]
    texels = baking["chart_texels"]
    return run.Measurement(triangles=baking["triangles"], texels=texels, bake=seconds["bake"], each=1e6 * seconds["bake"] / texels,
                           charts=seconds["charts"], ratio=seconds["bake"] / seconds["charts"], missed=100 * baking["missed_rays"] / texels,
                           back=100 * baking["back_faces"] / texels)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", type=run.numbers, default="20000,100000,400000,1500000", metavar="N,N,...", help="triangles (%(default)s)")
    parser.add_argument("--simple", type=int, default=5000, metavar="N", help="triangles of the surface that is baked into (%(default)s)")
    parser.add_argument("--resolutions", type=run.numbers, default="1024,4096", metavar="N,N,...", help="(%(default)s)")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="of each run (%(default)s)")
    parser.add_argument("--program", type=Path, metavar="PROGRAM", help="what flattens (%(default)s)",
                        default=run.ROOT / "build/apps/flatten_mesh/flatten_mesh")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)
    surfaces = [measure.resized(run.SHELL, size) for size in options.sizes]

    report, targets = Report(options.output), Targets()
    report.add(head("Pages and baking", measure) +
               f"On {options.threads} threads, medians of {options.repeat} runs in turn. Pages: what `--report` writes, beside the OBJ file of the same atlas. "
               "More than 250,000 triangles are thinned for the page. Baking: without reading and writing; ratio: to the time for the charts of the simple surface.\n")
    table = Table(["triangles"], PAGES, 0)
    for m in run.interleaved(lambda mesh: measure_page(options, mesh), surfaces, options.repeat):
        run.tell("page", m, "page")
        table.add([f"{m['triangles']:,.0f}"], m)
        if m["triangles"] <= 100000 or m["triangles"] == min(options.sizes):
            targets.add(f"{m['triangles']:,.0f} triangles, MB", ".1f", m["megabytes"], most=12)
            targets.add(f"{m['triangles']:,.0f} triangles, seconds", ".2f", m["page"], most=2)
    report.add(f"\n## Pages\n\n{table}{targets}")

    simple = measure.resized(run.SHELL, options.simple)
    tasks = [(simple, fine, resolution) for fine in surfaces for resolution in options.resolutions]
    table = Table(["fine triangles", "resolution"], BAKING, 0)
    for task, m in zip(tasks, run.interleaved(lambda task: measure_baking(options, *task), tasks, options.repeat)):
        run.tell("baking", m, "bake")
        table.add([f"{m['triangles']:,.0f}", f"{task[2]:,}"], m)
    report.add(f"\n## Baking into {options.simple:,} triangles\n\n{table}")


if __name__ == "__main__":
    main()
