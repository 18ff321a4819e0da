#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts closed surfaces open along seams of `select_seams()`, and along seams to as many other terminals: farthest points, and
peaks of curvature in the manner of Seamster. Then shows what other bounds lead to, how the time to select seams grows, and
how the time to cut a surface open grows with the number of given vertices."""

import argparse
import math
import statistics
from pathlib import Path

import run
from report import Report, Table, Targets, cell, head, table

CHOICES = {"cones": "cones", "farthest": "farthest points", "peaks": "curvature peaks"}
COLUMNS = [("terminals", "terminals", ".0f"), ("seam", "seam", ".2f"), ("predicted", "predicted", ".3f"),
           ("L2 stretch", "stretch", ".3f"), ("scale stretch", "scale_stretch", ".3f"), ("flips", "flips", ".0f"),
           ("seconds, seams", "choice_seconds", "seconds"), ("ABF++", "seconds", "seconds")]
GROWTH = [("terminals", "terminals", ".0f"), ("seconds, seams", "choice_seconds", "seconds"),
          ("hierarchical ABF++", "seconds", "seconds"), ("seams / ABF++", "ratio", ".2f"), ("seam", "seam", ".2f"),
          ("L2 stretch", "stretch", ".3f")]
LIMITS = {"cow": (4.6, 1.11), "homer": (4.8, 1.11), "camel": (4.9, 1.12), "elephant": (5.7, 1.11), "fandisk": (2.3, 1.10),
          "anchor_dense": (4.5, 1.10), "turbine": (6.0, 1.13), "bunny00": (3.0, 1.10), "armadillo": (5.5, 1.11)}


def compare(measure: run.Measure, file: Path, options: argparse.Namespace) -> list[run.Measurement]:
    """Of all choices, with as many terminals as ours"""
    ours = measure.one("seams", "cones", file, "--bound", options.bound)
    if "failure" in ours:
        return [ours] * len(CHOICES)
    tasks = list(CHOICES)
    return run.interleaved(lambda choice: measure.one("seams", choice, file, "--bound", options.bound, "--terminals",
                                                      f"{ours['terminals']:.0f}"), tasks, options.repeat)


def comparison(measure: run.Measure, models: list[Path], options: argparse.Namespace) -> str:
    all_runs = Table(["model", "triangles", "terminals are"], [*COLUMNS, ("injective", "border_is_simple", "yes")], 3)
    targets = Targets()
    results: dict[str, list[run.Measurement]] = {choice: [] for choice in CHOICES}
    for file in models:
        for choice, m in zip(CHOICES, compare(measure, file, options)):
            run.tell(f"{file.stem}, {CHOICES[choice]}", m, "choice_seconds")
            all_runs.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else "", CHOICES[choice]], m)
            results[choice].append(m)
        if file.stem in LIMITS and options.bound == 1.1:
            seam, stretch = LIMITS[file.stem]
            targets.add(f"{file.stem}, seam", ".2f", results["cones"][-1]["seam"], most=seam)
            targets.add(f"{file.stem}, L2 stretch", ".3f", results["cones"][-1]["stretch"], most=stretch)
    medians = [[CHOICES[choice], *(cell(statistics.median(m[name] for m in runs), form) for _, name, form in COLUMNS)]
               for choice, runs in results.items()]
    error = max((abs(m["stretch"] / m["predicted"] - 1) for m in results["cones"]), default=math.nan)
    typical = statistics.median(abs(m["stretch"] / m["predicted"] - 1) for m in results["cones"])
    return (f"{all_runs}\n## Medians\n\n{table(['terminals are', *(title for title, _, _ in COLUMNS)], medians)}\n"
            f"The stretch of ABF++ differs from its prediction, along seams to cones, by {typical:.1%} in the median, and by "
            f"{error:.1%} at most.\n" + (str(targets) if targets.rows else ""))


def bounds(measure: run.Measure, models: list[Path], options: argparse.Namespace) -> str:
    """What other bounds lead to"""
    rows = []
    for bound in options.bounds:
        results = [measure.one("seams", "cones", file, "--bound", bound) for file in models]
        for file, m in zip(models, results):
            run.tell(f"{file.stem}, bound {bound}", m, "choice_seconds")
        medians = [cell(statistics.median(m[name] for m in results), form)
                   for name, form in [("terminals", ".0f"), ("seam", ".2f"), ("stretch", ".3f")]]
        rows.append([f"{bound:g}", *medians, f"{sum(m['border_is_simple'] == 1 for m in results)} of {len(models)}"])
    return ("\n## Bounds\n\nMedians of all models, along seams to cones.\n\n" +
            table(["bound", "terminals", "seam", "L2 stretch", "injective maps"], rows))


def growth(measure: run.Measure, base: Path, options: argparse.Namespace) -> str:
    rows, points = Table(["triangles"], GROWTH, 0), []
    for size in options.sizes:
        file = Path(run.FOLDER.name) / f"growth_{size}.ply"
        made = measure.mesh(base, "--triangles", size, "--any-topology", "--output", file)
        m = made if "failure" in made else run.interleaved(
            lambda method: measure.one("seams", "cones", file, "--method", method, "--bound", options.bound),
            ["habf++"], options.repeat)[0]
        if "failure" not in m:
            m["ratio"] = m["choice_seconds"] / m["seconds"]
            points.append((m["triangles"], m["choice_seconds"]))
        run.tell(f"{base.stem}, {size} triangles", m, "choice_seconds")
        rows.add([f"{m['triangles']:,.0f}" if "triangles" in m else size], m)
    text = f"\n## Growth\n\nThe model {base.stem}, simplified or subdivided, on one thread.\n\n{rows}"
    if len(points) > 1:
        (n, t), (many, long) = points[0], points[-1]
        text += (f"\nFrom the first row to the last, the time to select seams grows like "
                 f"n^{math.log(long / t) / math.log(many / n):.2f}.\n")
    return text


def many_terminals(measure: run.Measure, base: Path, options: argparse.Namespace) -> str:
    """The time of cut_to_disks() with few and many vertices that seams must reach, on the largest mesh of the growth"""
    file = Path(run.FOLDER.name) / "many_terminals.ply"
    made = measure.mesh(base, "--triangles", options.sizes[-1], "--any-topology", "--output", file)
    if "failure" in made:
        return f"\n## Given vertices\n\nFAILED: {made['failure']}\n"
    results = run.interleaved(lambda number: measure.one("seams", "random", file, "--terminals", number),
                              [f"{number:.0f}" for number in options.terminals], options.repeat)
    rows = Table(["triangles"], [("terminals", "terminals", ".0f"), ("seconds", "choice_seconds", "seconds"),
                                 ("seconds / those of the first row", "ratio", ".2f")], 0)
    for m in results:
        if "failure" not in m and "failure" not in results[0]:
            m["ratio"] = m["choice_seconds"] / results[0]["choice_seconds"]
        run.tell(f"{base.stem}, {m.get('terminals', 0):.0f} terminals", m, "choice_seconds")
        rows.add([f"{m['triangles']:,.0f}" if "triangles" in m else ""], m)
    return ("\n## Given vertices\n\nThe largest of these meshes, cut open by cut_to_disks() through random vertices, on one "
            f"thread.\n\n{rows}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo; without it, the egg of "
                        "the examples is cut")
    parser.add_argument("--models", default=",".join(LIMITS), metavar="NAME,NAME,...", help="of the demo (%(default)s)")
    parser.add_argument("--bound", type=float, default=1.1, metavar="X", help="of the predicted stretch (%(default)s)")
    parser.add_argument("--bounds", type=run.numbers, default="1.05,1.1,1.2", metavar="X,X,...", help="others (%(default)s)")
    parser.add_argument("--sizes", type=run.numbers, default="75000,300000,1200000", metavar="N,N,...",
                        help="numbers of triangles for the growth (%(default)s)")
    parser.add_argument("--terminals", type=run.numbers, default="10,100,1000", metavar="N,N,...",
                        help="numbers of given vertices (%(default)s)")
    parser.add_argument("--base", default="camel", metavar="NAME", help="the model that grows (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)

    egg = run.EXAMPLES / "egg.off"
    models = [options.demo / f"{name}.off" for name in options.models.split(",")] if options.demo else [egg]
    base = options.demo / f"{options.base}.off" if options.demo else egg
    report = Report(options.output)
    report.add(head("Seams", measure) + "Each surface is cut open along three choices of seams with equally many terminals, and flattened by "
               f"ABF++. Terminals are *cones* as select_seams() chooses them until it predicts a stretch of at most {options.bound:g}; "
               "*farthest points*, each the vertex farthest from the seams so far; or *curvature peaks*, the vertices of the largest "
               "absolute angle defect that are not near the seams so far, in the manner of Seamster. Before, the surface is cut to a "
               "disk; then, shortest paths join the terminals to the seams, and the seams are shortened. Seam: length in units of the "
               "square root of the area. Predicted: the L2 stretch that is predicted for the seams. Scale stretch: what the L2 stretch "
               "would be if the map kept all angles. Medians of times, on one thread.\n\n")
    report.add(comparison(measure, models, options))
    report.add(bounds(measure, models, options))
    report.add(growth(measure, base, options))
    report.add(many_terminals(measure, base, options))


if __name__ == "__main__":
    main()
