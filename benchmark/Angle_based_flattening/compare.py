#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens meshes by ABF++ and the methods that it is compared with, side by side: the tables of the
paper, ratios, and whether what the paper says is seen."""

import argparse
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import run
from comparison import (METHODS, TABLE_2, Results, distortions_table, growth_table, ratios_table,
                        times_table)
from relations import relations_table
from report import Report, head

QUICK = {"sizes": "1000,4000,16000,64000", "most": 30000, "repeat": 1, "timeout": 8}
ALL = {"sizes": "1000,4000,16000,64000,256000,1024000,4241328", "timeout": 600}


@dataclass(frozen=True, order=True)
class InputMesh:
    """If it has no file, the base is yet to be resized."""

    faces: int
    name: str
    file: Path | None = None


def find_meshes(measure: run.Measure, options: argparse.Namespace) -> list[InputMesh]:
    """The disks, small ones first. Folders have much in them that is no disk; what is named has to be one."""
    files = {file: False for file in options.meshes if not file.is_dir()}  # whether it may be left out
    for folder in (*filter(Path.is_dir, options.meshes), *options.data):
        if folder.is_dir():
            files |= {file: True for file in run.mesh_files(folder)}
        else:
            print(f"left out: there is no folder '{folder}'", file=sys.stderr)
    meshes = [InputMesh(size, options.base.stem) for size in options.sizes]
    for file, from_folder in files.items():
        m = measure.mesh(file)
        if "failure" in m and not from_folder:
            raise SystemExit(f"{file}: {m['failure']}")
        if "failure" in m:
            print(f"left out: '{file}': {m['failure']}", file=sys.stderr)
        elif not from_folder or options.least <= m["triangles"] <= options.most:
            meshes.append(InputMesh(m["triangles"], file.stem, file))
    return sorted(meshes, key=lambda mesh: (mesh.faces, mesh.name))


class Runner:
    """Measures mesh by mesh, each method in processes of its own. A method that was stopped on two
    meshes is not tried on larger ones."""

    def __init__(self, measure: run.Measure, options: argparse.Namespace) -> None:
        self.measure, self.options = measure, options
        self.stops: Counter[str] = Counter()

    def rows(self, number: int, mesh: InputMesh) -> list[dict]:
        file = mesh.file or self.measure.resized(self.options.base, mesh.faces, noise=True)
        runs: dict[str, list[run.Measurement]] = {method: [] for method in self.options.methods}
        for _ in range(self.options.repeat):
            for method, done in runs.items():
                if not done and self.stops[method] >= 2:
                    done.append(run.Measurement(failure="not tried"))
                elif sum(m["seconds"] for m in done) < self.options.timeout:  # NaN after a failure
                    done.append(self.run_once(mesh, method, file))
        medians = {method: run.median(done) for method, done in runs.items()}
        faces = [*(m["triangles"] for m in medians.values() if "triangles" in m), mesh.faces][0]
        return [{"failure": ""} | m | {"number": number, "mesh": mesh.name, "faces": faces, "method": method,
                                       "resized": mesh.file is None, "runs": len(runs[method])}
                for method, m in medians.items()]

    def run_once(self, mesh: InputMesh, method: str, file: Path) -> run.Measurement:
        m = self.measure.one("flatten", method, file, threads=self.options.threads)
        if m.get("failure", "").startswith(("took longer", "out of memory")):
            m["failure"] = "stopped: " + m["failure"]
            self.stops[method] += 1
        run.tell(f"{mesh.name}, {mesh.faces}, {method}", m)
        return m


def parse_command_line() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="methods:\n" + "\n".join(f"  {name}: {title}" for name, title in METHODS.items()))
    parser.add_argument("meshes", nargs="*", type=Path, metavar="FILE|FOLDER", help="of meshes")
    parser.add_argument("--data", type=Path, action="append", default=[], metavar="FOLDER",
                        help="as above, but nothing is wrong if there is no such folder; may be given again")
    parser.add_argument("--sizes", type=run.numbers, default=[], metavar="N,N,...",
                        help="numbers of triangles to which the base is simplified or subdivided, with noise")
    parser.add_argument("--base", type=Path, default=run.SHELL, metavar="FILE",
                        help="a disk; by default a sea shell")
    for name, default, which in (("--least", 500, "smaller"), ("--most", 10000000, "larger")):
        parser.add_argument(name, type=int, default=default, metavar="N",
                            help=f"{which} meshes of folders are left out ({default})")
    parser.add_argument("--methods", type=run.words(METHODS), default=list(METHODS), metavar="NAME,NAME,...",
                        help="as listed below; all by default")
    presets = parser.add_mutually_exclusive_group()
    for name, preset in (("quick", QUICK), ("all", ALL)):
        presets.add_argument("--" + name, action="store_true",
                             help=" ".join(f"--{key} {value}" for key, value in preset.items()))
    parser.add_argument("--threads", type=int, default=1, metavar="N", help="cores of a process")
    parser.add_argument("--csv", type=Path, metavar="FILE.csv", help="write all figures there")
    parser.add_argument("--plots", type=Path, metavar="FOLDER", help="draw time.svg and distortion.svg there")
    run.add_options(parser, timeout=120)
    options = parser.parse_args()
    parser.set_defaults(**(QUICK if options.quick else ALL if options.all else {}))
    return parser.parse_args()


def add_tables(report: Report, results: Results) -> None:
    for title, caption, table in (
            ("Table I: run times", "In seconds, for meshes of up to 60,000 faces.\n\n", times_table(results)),
            ("Table II: small to large meshes", "Shear is that of Eq. 24, which depends on the direction of the "
             "axes; principal shear does not. Stretch is that of the mirror image if a triangle is flipped, "
             "and infinite if a triangle has no area. Energy is the mean square relative change of the "
             "target angles (Eq. 1, per angle), which ABF++ minimizes.\n\n", distortions_table(results, 0, TABLE_2)),
            ("Table III: very large meshes", "", distortions_table(results, TABLE_2, float("inf"))),
            ("Ratios to CGAL's LSCM", "Geometric means over the meshes, except developable ones, that both "
             "methods flattened; for stretch, those where it is finite.\n\n", ratios_table(results, "lscm")),
            ("Growth", "Growth of the run time on one surface of several sizes.\n\n", growth_table(results)),
            ("What the paper says", "Quotients on every mesh where both were measured, except developable "
             "ones.\n\n", relations_table(results))):
        report.add(f"\n## {title}\n\n{caption}{table}")


def main() -> None:
    options = parse_command_line()
    measure = run.measure_of(options)
    meshes = find_meshes(measure, options)
    if not meshes:
        raise SystemExit("there is no mesh; see --help")
    report = Report(options.output)
    report.add(head("Methods of flattening", measure) +
               f"Medians of up to {options.repeat} runs, as many as the time limit allows, each in a separate "
               f"process. Cores: {options.threads}; the BLAS used one thread. Seconds and memory (peak "
               "resident size) are those of the method alone, without its input mesh. Limits of a process: "
               f"{options.timeout:g} s, {options.memory:g} GB of memory. A method that exceeded them twice "
               "was not tried on larger meshes.\n")
    runner = Runner(measure, options)
    rows: list[dict] = []
    for number, mesh in enumerate(meshes):
        rows += runner.rows(number, mesh)
        results = Results(rows)
        if options.csv:
            options.csv.write_text(results.csv(), encoding="utf-8")
    add_tables(report, results)
    if options.plots:
        from plots import draw  # it needs matplotlib
        options.plots.mkdir(parents=True, exist_ok=True)
        report.add("\n## Plots\n\n" + draw(results, options.plots))


if __name__ == "__main__":
    main()
