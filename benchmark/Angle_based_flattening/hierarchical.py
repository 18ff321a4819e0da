#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the hierarchical parameterizer: speed, memory, distortion, against the direct one, CGAL's LSCM,
hierarchical LSCM and the paper's order."""

import argparse
import csv
import math
from dataclasses import dataclass
from pathlib import Path

import run
from report import Column, Report, Table, Targets, cell, head, table

TITLES = {"habf++": "hierarchical ABF++", "hlscm": "hierarchical LSCM", "abf++": "direct ABF++",
          "lscm": "CGAL's LSCM"}
DIRECT_STAGES = ["read", "targets", "angles", "layout", "certify", "write"]

# Columns that several tables have
SECONDS, *STAGES = ((name, name, "seconds") for name in (
    "seconds", "read", "coarsen", "solve", "refine", "certify", "write"))
TRIANGLES, FLIPS = ((name, name, ".0f") for name in ("triangles", "flips"))
FAILED = ("failed coarse charts", "failed_coarse_charts", ".0f")
COARSE = ("coarse triangles", "coarse_triangles", ".0f")
KERNEL = ("kernel insertions", "kernel_insertions", ".0f")
PERCENT = ("% of vertices", "kernel_percent", ".4f")
NEWTON = ("Newton steps", "newton_steps", ".0f")
BYTES = ("bytes a triangle", "triangle_bytes", ".0f")
SHEAR = ("shear", "mean_shear", ".4f")
STRETCH = ("stretch", "stretch", ".4f")
SHEAR_RISE = ("rise", "mean_shear_rise", "+.4f")
STRETCH_RISE = ("rise", "stretch_rise", "+.4f")

# Where the map of hierarchical LSCM starts, by the coarse chart that LSCM flattens
STARTS = {"none": "one triangle", "finer": "a finer chart", "first": "the first chart"}

# Seconds of the paper's Table III, for surfaces of that size, not ours
PAPER = {605846: {"habf++": 107, "hlscm": 305}, 698572: {"habf++": 50, "hlscm": 351},
         4241328: {"habf++": 819}}

# By how much shear may rise, on well-known meshes
SHEAR_RISES = {"bunny": 0.002, "lionhead": 0.002, "horse": 0.002, "armadillo": 0.004, "camel": 0.008}


@dataclass(frozen=True)
class Task:
    """What one process measures"""

    method: str
    file: Path
    threads: int = 1
    options: tuple[str, ...] = ()


def add_comparison(m: run.Measurement, direct: run.Measurement) -> None:
    """With the direct method"""
    for name in ("shear", "mean_shear", "stretch"):
        m["direct_" + name] = direct[name]
        m[name + "_rise"] = m[name] - direct[name]


class Benchmark:
    """Its functions are the parts of the report."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.program = run.measure_of(options)

    def measure(self, task: Task) -> run.Measurement:
        m = self.program.one("flatten", task.method, task.file, *task.options, threads=task.threads)
        run.tell(f"{task.file.stem}, {task.method}, threads {task.threads} {' '.join(task.options)}", m)
        m["triangle_bytes"] = m["bytes"] / m["triangles"]
        m["million_seconds"] = m["seconds"] / m["triangles"] * 1e6
        m["kernel_percent"] = 100 * m["kernel_insertions"] / m["vertices"]
        return m

    def medians(self, *tasks: Task) -> list[run.Measurement]:
        return run.interleaved(self.measure, tasks, self.options.repeat)

    def compared_files(self) -> list[Path]:
        """The meshes in the folder, or else the one mesh"""
        return run.mesh_files(self.options.data) if self.options.data else [self.options.mesh]

    def speed(self) -> str:
        threads = f"{self.options.threads} threads"
        speeds = Table(["method", "threads", "triangles"],
                       [SECONDS, ("per million", "million_seconds", ".2f"), *STAGES, BYTES, FLIPS])
        ratios, targets = [], Targets()
        for size in self.options.sizes:
            file = self.program.resized(self.options.mesh, size)
            tasks = [Task("habf++", file), Task("habf++", file, self.options.threads), Task("abf++", file),
                     Task("lscm", file)]
            one, more, direct, lscm = results = self.medians(*tasks)
            size = one.get("triangles", size)
            for task, m in zip(tasks, results):
                speeds.add([TITLES[task.method], task.threads, size], m)
            by_direct, by_lscm = direct["seconds"] / one["seconds"], lscm["seconds"] / one["seconds"]
            speedup = one["seconds"] / more["seconds"]
            ratios.append([str(size), *(cell(number, ".2f") for number in (by_direct, by_lscm, speedup))])
            at = f", {size} triangles"
            if size > 3e5:
                targets.add("seconds per million triangles, one thread" + at, ".2f", one["million_seconds"], most=2.2)
                targets.add(f"one thread / {threads}{at}", ".2f", speedup, least=1.3)
                targets.add("bytes a triangle, one thread" + at, ".0f", one["triangle_bytes"], most=150)
                targets.add(f"bytes a triangle, {threads}{at}", ".0f", more["triangle_bytes"], most=150)
            if size > 1.5e6:
                targets.add("direct ABF++ / hierarchical" + at, ".2f", by_direct, least=6)
                targets.add("CGAL's LSCM / hierarchical" + at, ".2f", by_lscm, least=15)
        titles = ["triangles", "direct ABF++ / hierarchical", "CGAL's LSCM / hierarchical",
                  "one thread / " + threads]
        return ("Seconds of a whole call of `parameterize()` at the default rate, without reading the file, and "
                "of its stages. Memory is the increase of the peak resident size during the call. Ratios are to "
                "the hierarchical method on one thread."
                f"\n\n{speeds}\n{table(titles, ratios, 0)}{targets}")

    def quality(self) -> str:
        columns = [TRIANGLES, ("shear, direct", "direct_mean_shear", ".4f"), ("hierarchical", *SHEAR[1:]),
                   SHEAR_RISE, ("stretch, direct", "direct_stretch", ".4f"), ("hierarchical", *STRETCH[1:]),
                   STRETCH_RISE, ("shear as returned, direct", "direct_shear", ".4f"),
                   ("hierarchical", "shear", ".4f"), KERNEL, PERCENT, FAILED, FLIPS]
        meshes, targets, most_percent, flips = Table(["mesh"], columns), Targets(), 0., 0
        resized = [self.program.resized(self.options.mesh, size) for size in self.options.sizes[1:2]]
        for file in self.compared_files() + resized:
            direct, m = self.medians(Task("abf++", file), Task("habf++", file))
            add_comparison(m, direct)
            most_percent, flips = max(most_percent, m["kernel_percent"]), flips + m.get("flips", 0)
            for limit in (limit for name, limit in SHEAR_RISES.items() if name in file.stem):
                targets.add("rise of shear, " + file.stem, ".4f", m["mean_shear_rise"], most=limit)
                targets.add("rise of stretch, " + file.stem, ".4f", m["stretch_rise"], most=0.015)
            meshes.add([file.stem], direct if "failure" in direct else m)
        targets.add("kernel insertions, % of the vertices of any mesh", ".4f", most_percent, most=0.02)
        targets.add("flips of all", ".0f", flips, most=0)
        return ("Direct ABF++ and hierarchical ABF++ at the default rate. The shear of Eq. 24 depends on the "
                "direction of the axes. The rise is that of the root mean square over all directions. The shear "
                "as returned is that along the axes of the coordinates."
                f"\n\n{meshes}{targets}")

    def rates(self) -> str:
        mesh, figure = self.options.mesh, self.options.figure
        tasks = [Task("habf++", mesh, options=(f"--simplification-rate={rate / 100}",)) for rate in self.options.rates]
        direct, *results = self.medians(Task("abf++", mesh), *tasks)
        rates = Table(["rate"], [COARSE, SECONDS, SHEAR, SHEAR_RISE, STRETCH, STRETCH_RISE, KERNEL, FAILED, FLIPS])
        for rate, m in zip(["direct", *self.options.rates], [direct, *results]):
            add_comparison(m, direct)
            rates.add(["direct" if m is direct else f"{rate:g} %"], m)
        text = (f"The hierarchical method on {mesh.stem} with `Hierarchical_options::simplification_rate` "
                "varied, and the direct method. Rises are relative to the direct method. The paper reports rises of "
                f"0.004 for shear and 0.025 for stretch at 95 %.\n\n{rates}")
        if figure:
            points = [(rate, m["seconds"], m["mean_shear"], m["stretch"])
                      for rate, m in zip([0, *self.options.rates], [direct, *results]) if "failure" not in m]
            with open(f"{figure}.csv", "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(["rate", "seconds", "shear", "stretch"])
                writer.writerows([f"{number:.6g}" for number in point] for point in points)
            draw_rates(points, f"{figure}.svg")
            text += f"\nThe same is in `{figure.name}.csv`, drawn in `{figure.name}.svg`.\n"
        return text

    def variants(self, title: str, columns: list[Column], variants: dict[str, tuple], text_columns: int) -> str:
        """A table with a row for each mesh and variant: its name, the method, and options of that"""
        result = Table(["mesh", title], columns, text_columns)
        for file in self.compared_files():
            tasks = [Task(method, file, options=options) for method, *options in variants.values()]
            for name, m in zip(variants, self.medians(*tasks)):
                result.add([file.stem, name], m)
        return f"\n\n{result}"

    def sequential(self) -> str:
        columns = [TRIANGLES, COARSE, SECONDS, *STAGES[1:4], KERNEL, PERCENT, SHEAR, STRETCH, FLIPS]
        return ("*By levels* is the library, on one thread. *Sequential* is Section 5 of the paper: a priority "
                "queue removes one vertex at a time, and the vertices are inserted in reverse order, with "
                "harmonic weights and one harmonic smoothing of the vertex and its neighbours. Both use the same "
                "cost, conditions, coarse solver and number of coarse vertices." +
                self.variants("order", columns, {"by levels": ("habf++",), "sequential": ("sequential",)}, 2))

    def sweeps(self) -> str:
        columns = [SECONDS, STAGES[3], SHEAR, STRETCH, KERNEL, FLIPS]
        variants = {str(number): ("habf++", f"--sweeps={number}") for number in self.options.sweeps}
        return ("The hierarchical method at the default rate, on one thread, with "
                "`Hierarchical_options::sweeps` varied; the default is 3." +
                self.variants("sweeps on each level", columns, variants, 1))

    def polish(self) -> str:
        columns = [SECONDS, ("polish", "polish", "seconds"), NEWTON, SHEAR, STRETCH, FLIPS,
                   ("replaced", "polished", "yes")]
        variants = {"direct ABF++": ("abf++",), "hierarchical ABF++": ("habf++",),
                    "hierarchical ABF++, polished": ("habf++", "--polish")}
        return ("Direct ABF++, hierarchical ABF++, and the latter as the start of the direct solver "
                "(`Hierarchical_options::polish`). Replaced: whether the direct solver's result was valid and "
                "therefore returned." + self.variants("method", columns, variants, 2))

    def large(self) -> str:
        runs = Table(["triangles", "method", "threads"],
                     [SECONDS, SHEAR, STRETCH, KERNEL, FLIPS, BYTES, ("faces a second", "speed", ".0f"),
                      ("times the paper's", "over_paper", ".0f")], 0)
        targets, flips = Targets(), 0
        smallest: dict[int, run.Measurement] = {}  # of each number of threads
        for size in self.options.large:
            file = self.program.resized(self.options.mesh, size, noise=True)
            tasks = [Task(method, file, threads) for method in ("habf++", "hlscm")
                     for threads in (1, self.options.threads)]
            for task, m in zip(tasks, self.medians(*tasks)):
                size = m.get("triangles", size)
                m["speed"] = size / m["seconds"]
                for faces, seconds in PAPER.items():
                    if abs(size / faces - 1) < 0.02 and task.method in seconds:
                        m["over_paper"] = m["speed"] * seconds[task.method] / faces
                runs.add([size, TITLES[task.method], task.threads], m)
                flips += m.get("flips", 0)
                if task.method != "habf++":
                    continue
                threads = f", {task.threads} thread(s)"
                first = smallest.setdefault(task.threads, m)
                if size > 4e6:
                    targets.add("faces a second, times the paper's" + threads, ".0f", m["over_paper"], least=100)
                if size > 4e6 and first["triangles"] < 4e5:
                    targets.add(f"time at {size} triangles / time at {first['triangles']}{threads}", ".1f",
                                m["seconds"] / first["seconds"], most=13)
                if size > 3e5:
                    targets.add(f"bytes a triangle, {size} triangles{threads}", ".0f", m["triangle_bytes"], most=150)
        targets.add("flips of all", ".0f", flips, most=0)
        return (f"The counterpart of the paper's Table III: {self.options.mesh.stem}, simplified and subdivided "
                "to the sizes there. Each vertex was then moved by a tenth of its shortest edge. The rate is the "
                "default. The paper's surfaces have the same sizes, but are different (605,846 triangles: hierarchical ABF++ "
                "107 s, hierarchical LSCM 305 s; 698,572: 50 s, 351 s; 4,241,328, at 98 %: 819 s, failed), on "
                f"machines of 2004.\n\n{runs}{targets}")

    def coarse(self) -> str:
        columns = [TRIANGLES, FAILED, ("degrees, hierarchical LSCM", "degrees", ".2f"),
                   ("hierarchical ABF++", "abf_degrees", ".2f"), FLIPS]
        meshes, served = Table(["mesh", "start"], columns, 2), dict.fromkeys(STARTS, 0)
        files = self.compared_files() + (run.mesh_files(self.options.demo) if self.options.demo else [])
        for file in files:
            abf, lscm = self.medians(Task("habf++", file), Task("hlscm", file))
            if "failure" in abf or abf["levels"] == 0:  # no surface with a border, or none that is simplified
                continue
            lscm["degrees"], lscm["abf_degrees"] = (m["angle_change"] * 180 / math.pi for m in (lscm, abf))
            start = "none" if not lscm["coarse_method"] else "finer" if lscm["failed_coarse_charts"] else "first"
            served[start] += 1
            meshes.add([file.stem, STARTS[start]], lscm)
        return ("CGAL's LSCM and ABF++ as parameterizers of the coarse chart, at the default rate. A coarse chart has "
                "failed if its map has flipped triangles; after four, the map starts from one triangle. Degrees are the "
                "mean change of angles, weighted by area. LSCM flattened the first coarse chart of "
                f"{served['first']} of {sum(served.values())} surfaces, a finer one of {served['finer']}, and none of "
                f"{served['none']}.\n\n{meshes}")

    def direct(self) -> str:
        growth = {"triangles": "triangles / smallest", "seconds": "time", "bytes": "memory"}
        sizes = Table(["triangles", "threads"], [
            SECONDS, *((stage + ", %", stage + "_percent", ".1f") for stage in DIRECT_STAGES), NEWTON,
            ("CG steps", "cg_steps", ".0f"), ("factored", "factorizations", ".0f"), BYTES,
            *((title, name + "_growth", ".1f") for name, title in growth.items()), FLIPS], 0)
        smallest: dict[int, run.Measurement] = {}  # of each number of threads
        for size in self.options.sizes:
            file = self.program.resized(self.options.mesh, size)
            tasks = [Task("abf++", file, threads) for threads in (1, self.options.threads)]
            for task, m in zip(tasks, self.medians(*tasks)):
                first = smallest.setdefault(task.threads, m)
                m.update({stage + "_percent": 100 * m[stage] / m["seconds"] for stage in DIRECT_STAGES})
                m.update({name + "_growth": m[name] / first[name] for name in growth})
                sizes.add([m.get("triangles", size), task.threads], m)
        return ("Direct ABF++: percentages of its stages, and growth relative to the smallest size."
                f"\n\n{sizes}")


def draw_rates(points: list[tuple[float, ...]], file: str) -> None:
    """Shear and stretch against the rate, like the paper's Fig. 7; the direct method has rate 0."""
    import matplotlib.pyplot as plt  # only where something is drawn
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for axis, name, k in zip(axes, ("shear", "stretch"), (2, 3)):
        axis.plot(*zip(*((point[0], point[k]) for point in points if point[0] > 0)), "o-", label="hierarchical ABF++")
        for point in points:
            if point[0] == 0:
                axis.axhline(point[k], linestyle="--", color="C1", label="direct ABF++")
        axis.set(xlabel="simplification rate, %", ylabel="L2 " + name)
        axis.grid(alpha=0.4)
        axis.legend()
    figure.savefig(file)


PARTS = {"speed": "Speed and memory", "quality": "Distortion", "rates": "Simplification rates",
         "sequential": "Level by level, or one vertex at a time", "large": "Large surfaces", "sweeps": "Sweeps",
         "polish": "Polishing", "coarse": "LSCM on the coarse chart", "direct": "The direct method"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, nargs="?")
    parser.add_argument("--data", type=Path, metavar="FOLDER",
                        help="disks for quality, sequential, sweeps and polish; by default only the one mesh")
    parser.add_argument("--demo", type=Path, metavar="FOLDER",
                        help="meshes of CGAL's demo, for coarse; those without a border are left out")
    parser.add_argument("--parts", type=run.words(PARTS), default=",".join(PARTS), metavar="PART,PART,...",
                        help="what to measure (%(default)s)")
    for name, default, text in (
            ("sizes", "97000,388000,1552000", "numbers of triangles for speed, direct; quality takes the second one"),
            ("large", "388000,605846,698572,4241328", "numbers of triangles for large"),
            ("rates", "80,85,90,92.5,95,97,98,99,99.5", "simplification rates in percent for rates"),
            ("sweeps", "0,1,2,3,4", "sweeps on each level for sweeps")):
        parser.add_argument("--" + name, type=run.numbers, default=default, metavar="N,N,...", help=f"{text} ({default})")
    parser.add_argument("--figure", type=Path, metavar="NAME",
                        help="what rates measures is also written to NAME.csv and drawn to NAME.svg")
    parser.add_argument("--threads", type=int, default=2, metavar="N",
                        help="compared with one thread, in speed and large")
    run.add_options(parser)
    options = parser.parse_args()
    benchmark = Benchmark(options)
    report = Report(options.output)
    report.add(head("Hierarchical parameterization", benchmark.program) +
               f"Medians of {options.repeat} runs, each in a separate process with as many cores as threads. The BLAS "
               "used one thread. Runs used one thread unless stated otherwise. Limits of a process: "
               f"{options.timeout:g} s, {options.memory:g} GB of memory.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())


if __name__ == "__main__":
    main()
