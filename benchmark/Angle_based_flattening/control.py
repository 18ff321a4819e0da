#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens surfaces that are cut open along seams through cones: cut first, with equal lengths along seams, and with prescribed
angles around the cones. And disks with free borders and as rectangles."""

import argparse
from pathlib import Path

import run
from report import Report, Table, Targets, head

MODELS = ["cow", "camel", "homer", "armadillo", "bunny00", "elephant"]
DISKS = ["lionhead", "bunny", "horse", "camel", "cow", "dino"]
MEASURES = [("E", "energy", ".5f"), ("E / first", "relative_energy", ".3f"), ("L2 stretch", "stretch", ".3f"),
            ("QC, mean", "quasi_conformal", ".3f"), ("QC, largest", "largest_quasi_conformal", ".1f"),
            ("flips", "flips", ".0f"), ("simple", "border_is_simple", "yes")]
STEPS = [("Newton", "newton_steps", ".0f"), ("CG", "cg_steps", ".0f"), ("factors", "factorizations", ".0f"),
         ("seconds", "seconds", "seconds"), ("time / first", "ratio", ".2f")]
SEAMS = [("jump", "jump", ".1e"), ("turn", "turn", ".1e"), ("error", "angle_error", ".1e")]
SIDES = [("error", "angle_error", ".1e"), ("from straight", "side_deviation", ".1e")]
# For which model with how many cones: the way, the number, the largest value, and how to write it
LIMITS = {("camel", 16): [("equal", "relative_energy", 1.02, ".3f"), ("equal", "jump", 1e-5, ".1e"),
                          ("rigid", "quasi_conformal", 1.08, ".3f")],
          ("cow", 8): [("rigid", "flips", 0, ".0f"), ("rigid", "quasi_conformal", 1.25, ".3f")],
          ("elephant", 8): [("equal", "jump", 1e-5, ".1e")], ("elephant", 16): [("equal", "jump", 1e-5, ".1e")]}
STRAIGHT = [("rectangle", "newton_steps", 6, ".0f"), ("rectangle, to 1e-9", "side_deviation", 1e-12, ".1e"),
            ("rectangle", "energy", 0.0057, ".4f")]
SLOWEST = 1.3  # of equal lengths, compared with cut first


def ways(measure: run.Measure, what: str, file: Path, *arguments: object) -> list[run.Measurement]:
    """The lines of one process, which takes the ways in turn. A way that failed has a line, too."""
    lines, failure = measure.lines(what, file, *arguments)
    if failure or not lines:
        lines.append(run.Measurement(failure=failure or "the process ended without a result"))
    for m in lines:
        run.tell(f"{what} of {file.stem}, {m.get('way', '')}", m)
    return lines


def row(rows: Table, name: str, number: str, m: run.Measurement) -> None:
    rows.add([name, f"{m['triangles']:,.0f}" if "triangles" in m else "", number, m.get("way", "")], m)


def cones(measure: run.Measure, models: list[Path], options: argparse.Namespace, targets: Targets) -> str:
    rows = Table(["model", "triangles", "cones", "way"], [("predicted", "predicted", ".3f"), *MEASURES, *SEAMS, *STEPS], 4)
    for file in models:
        for number in options.cones:
            found = ways(measure, "cones", file, "--cones", number, "--repeat", options.repeat)
            by_way = {m["way"]: m for m in found if "way" in m}
            for m in found:
                row(rows, file.stem, f"{number}", m)
            if not options.demo:
                continue
            of = f"{file.stem}, {number} cones"
            for way, what, most, form in LIMITS.get((file.stem, number), []):
                targets.add(f"{of}, {way}, {what}", form, by_way.get(way, run.Measurement())[what], most=most)
            targets.add(f"{of}, equal, time / first", ".2f", by_way.get("equal", run.Measurement())["ratio"], most=SLOWEST)
    return f"## Seams through cones\n\n{rows}\n"


def rectangles(measure: run.Measure, disks: list[Path], options: argparse.Namespace, targets: Targets) -> str:
    rows = Table(["disk", "triangles", "split edges", "way"], MEASURES + SIDES + STEPS, 4)
    for file in disks:
        found = ways(measure, "rectangle", file, "--repeat", options.repeat)
        by_way = {m["way"]: m for m in found if "way" in m}
        for m in found:
            row(rows, file.stem.removesuffix("_disk"), f"{m['split_edges']:.0f}" if "split_edges" in m else "", m)
        if file.stem == "lionhead_disk":
            for way, what, most, form in STRAIGHT:
                targets.add(f"lionhead, {way}, {what}", form, by_way.get(way, run.Measurement())[what], most=most)
    return f"## Rectangles\n\n{rows}\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="with the disks; without it, the bundled one is mapped")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo; without it, the egg of "
                        "the examples is cut")
    parser.add_argument("--models", default=",".join(MODELS), metavar="NAME,NAME,...", help="of the demo (%(default)s)")
    parser.add_argument("--cones", type=run.numbers, default="8,16", metavar="N,N,...", help="numbers of cones (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)

    models = [options.demo / f"{name}.off" for name in options.models.split(",")] if options.demo else [run.EXAMPLES / "egg.off"]
    disks = [options.data / f"{name}_disk.ply" for name in DISKS] if options.data else [run.SHELL]
    targets = Targets()
    report = Report(options.output)
    report.add(head("Control of seams and borders", measure) + "Each surface is cut open along seams through cones of select_cones(). "
               "*Cut first*: what is cut open is mapped like any disk. *Equal*: with equal lengths on both sides of seams; the sums of "
               "angles there are free. *Rigid*: the sums are prescribed, at cones those that select_cones() predicts, and a full turn "
               "elsewhere; *least squares*: the same with Cone_angles::LEAST_SQUARES, where these are possible. *Quarters*: with multiples "
               "of a right angle at the cones (spheres only). Disks: with a *free* border, with *four corners* that are right angles, and as a "
               "*rectangle*. Predicted: the L2 stretch that select_cones() expects. E: the energy of the angles, by "
               "measure_flattening(). QC: the quasi-conformal ratio. Jump: the largest difference between the logarithms of both lengths "
               "of an edge on a seam. Turn: of the angles around a vertex in the middle of a seam from a full turn. Error: of a prescribed "
               f"angle, in radians. The ways were taken in turn, {options.repeat} times, in one process on one thread. Times are medians; "
               "ratios are medians of those side by side.\n\n")
    report.add(cones(measure, models, options, targets))
    report.add(rectangles(measure, disks, options, targets))
    if targets.rows:
        report.add(f"## Targets\n{targets}")


if __name__ == "__main__":
    main()
