#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures the hierarchical parameterizer: speed, memory, distortion, against the direct one, CGAL's LSCM,
hierarchical LSCM and the paper's order."""

import argparse
import csv
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from math import nan
from pathlib import Path

import run
from report import Column, Report, Table, Targets, cell, head, ratio, table

TITLES = {"habf++": "hierarchical ABF++", "polished": "hierarchical ABF++, polished",
          "hlscm": "hierarchical LSCM", "sequential": "sequential hierarchy", "abf++": "direct ABF++",
          "lscm": "CGAL's LSCM"}
DIRECT_STAGES = ["read", "targets", "angles", "layout", "certify", "write"]

# Columns that several tables have
SECONDS, *STAGES = ((name, name, "seconds") for name in (
    "seconds", "read", "coarsen", "solve", "refine", "certify", "write"))
TRIANGLES, FLIPS, RETRIES = ((name, name, ".0f") for name in ("triangles", "flips", "retries"))
COARSE = ("coarse triangles", "coarse_triangles", ".0f")
KERNEL = ("kernel insertions", "kernel_insertions", ".0f")
PERCENT = ("% of vertices", "kernel_percent", ".4f")
NEWTON = ("Newton steps", "newton_steps", ".0f")
BYTES = ("bytes a triangle", "triangle_bytes", ".0f")
SHEAR = ("shear", "mean_shear", ".4f")
STRETCH = ("stretch", "stretch", ".4f")
SHEAR_RISE = ("rise", "mean_shear_rise", "+.4f")
STRETCH_RISE = ("rise", "stretch_rise", "+.4f")

# Seconds of the paper's Table III, for surfaces of that size, not ours
PAPER = {605846: {"habf++": 107, "hlscm": 305}, 698572: {"habf++": 50, "hlscm": 351}, 4241328: {"habf++": 819}}

# By how much shear may rise, on well-known meshes
SHEAR_RISES = {"bunny": 0.002, "lionhead": 0.002, "horse": 0.002, "armadillo": 0.004, "camel": 0.008}


@dataclass(frozen=True)
class Task:
    """What one process measures"""

    method: str
    file: Path
    threads: int = 1
    rate: float | None = None
    sweeps: int | None = None

    def measure(self, measure: run.Measure) -> run.Measurement:
        method = "habf++" if self.method == "polished" else self.method
        arguments = [f"--{name}={value}" for name, value in (("rate", self.rate), ("sweeps", self.sweeps))
                     if value is not None] + ["--polish"] * (self.method == "polished")
        m = measure.one("flatten", method, self.file, *arguments, threads=self.threads)
        run.tell(f"{self.file.stem}, {method}, threads {self.threads} {' '.join(arguments)}", m)
        if "failure" not in m:
            m["triangle_bytes"] = m["bytes"] / m["triangles"]
            m["million_seconds"] = m["seconds"] / m["triangles"] * 1e6
            m["kernel_percent"] = 100 * m.get("kernel_insertions", 0) / m["vertices"]
        return m


def add_rises(m: run.Measurement, direct: run.Measurement) -> None:
    """Over the direct method"""
    for name in {"mean_shear", "stretch"} & m.keys() & direct.keys():
        m[name + "_rise"] = m[name] - direct[name]


class Benchmark:
    """Its functions are the parts of the report."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.program = run.measure_of(options)

    def medians(self, *tasks: Task) -> list[run.Measurement]:
        return run.interleaved(lambda task: task.measure(self.program), tasks, self.options.repeat)

    @contextmanager
    def resized(self, triangles: int, noise: bool = False) -> Iterator[Path]:
        """A file with the one mesh in another size, while it is needed"""
        with tempfile.TemporaryDirectory() as folder:
            yield self.program.resized(self.options.mesh, triangles, folder, noise)

    def compared_files(self) -> list[Path]:
        """The meshes in the folder, or else the one mesh"""
        return run.mesh_files(self.options.data) if self.options.data else [self.options.mesh]

    def speed(self) -> str:
        threads = f"{self.options.threads} threads"
        speeds = Table(["method", "threads", "triangles"],
                       [SECONDS, ("per million", "million_seconds", ".2f"), *STAGES, BYTES, FLIPS])
        ratios, targets = [], Targets()
        for size in self.options.sizes:
            with self.resized(size) as file:
                tasks = [Task("habf++", file), Task("habf++", file, self.options.threads),
                         Task("abf++", file), Task("lscm", file)]
                results = self.medians(*tasks)
            size = results[0].get("triangles", size)
            for task, m in zip(tasks, results):
                speeds.add([TITLES[task.method], str(task.threads), str(size)], m)
            one, more, direct, lscm = (m.get("seconds") for m in results)
            by_direct, by_lscm, speedup = ratio(direct, one), ratio(lscm, one), ratio(one, more)
            ratios.append([str(size), *(cell(number, ".2f") for number in (by_direct, by_lscm, speedup))])
            at = f", {size} triangles"
            if size > 3e5:
                targets.at_most("seconds per million triangles, one thread" + at, ".2f",
                                results[0].get("million_seconds", nan), 2.2)
                targets.at_least(f"one thread / {threads}{at}", ".2f", speedup, 1.3)
                for which, m in zip(("one thread", threads), results):
                    targets.at_most(f"bytes a triangle, {which}{at}", ".0f", m.get("triangle_bytes", nan), 150)
            if size > 1.5e6:
                targets.at_least("direct ABF++ / hierarchical" + at, ".2f", by_direct, 6)
                targets.at_least("CGAL's LSCM / hierarchical" + at, ".2f", by_lscm, 15)
        titles = ["triangles", "direct ABF++ / hierarchical", "CGAL's LSCM / hierarchical", "one thread / " + threads]
        return ("The whole call of `parameterize()` on a mesh that is in memory, at the default rate, in "
                "seconds, with its stages. Memory: peak resident size during the call beyond that before it. "
                f"Ratios are to the hierarchical method on one thread.\n\n{speeds}\n{table(titles, ratios, 0)}{targets}")

    def quality(self) -> str:
        columns = [TRIANGLES, ("shear, direct", "direct_mean_shear", ".4f"), ("hierarchical", *SHEAR[1:]),
                   SHEAR_RISE, ("stretch, direct", "direct_stretch", ".4f"), ("hierarchical", *STRETCH[1:]),
                   STRETCH_RISE, ("shear as returned, direct", "direct_shear", ".4f"),
                   ("hierarchical", "shear", ".4f"), KERNEL, PERCENT, RETRIES, FLIPS]
        results = {file.stem: self.medians(Task("abf++", file), Task("habf++", file))
                   for file in self.compared_files()}
        for size in self.options.sizes[1:2]:
            with self.resized(size) as file:
                results[file.stem] = self.medians(Task("abf++", file), Task("habf++", file))
        meshes, targets = Table(["mesh"], columns), Targets()
        for name, (direct, m) in results.items():
            add_rises(m, direct)
            meshes.add([name], direct if "failure" in direct else
                       m | {"direct_" + key: number for key, number in direct.items()})
            for limit in (limit for mesh, limit in SHEAR_RISES.items() if mesh in name):
                targets.at_most("rise of shear, " + name, ".4f", m.get("mean_shear_rise", nan), limit)
                targets.at_most("rise of stretch, " + name, ".4f", m.get("stretch_rise", nan), 0.015)
        targets.at_most("kernel insertions, % of the vertices of any mesh", ".4f",
                        max(m.get("kernel_percent", 0) for _, m in results.values()), 0.02)
        targets.at_most("flips of all", ".0f", sum(m.get("flips", 0) for _, m in results.values()), 0)
        return ("Direct ABF++ and the hierarchical one at the default rate. The shear of Eq. 24 depends on the "
                "direction of the axes; the rise is that of its root mean square over all directions, and the "
                f"shear as returned is the one along the axes of the coordinates.\n\n{meshes}{targets}")

    def rates(self) -> str:
        mesh, figure = self.options.mesh, self.options.figure
        tasks = [Task("abf++", mesh), *(Task("habf++", mesh, rate=rate / 100) for rate in self.options.rates)]
        results = self.medians(*tasks)
        rates = Table(["rate"], [COARSE, SECONDS, SHEAR, SHEAR_RISE, STRETCH, STRETCH_RISE, KERNEL, RETRIES, FLIPS])
        for task, m in zip(tasks, results):
            add_rises(m, results[0])
            rates.add([f"{100 * task.rate:g} %" if task.rate else "direct"], m)
        text = (f"The hierarchical method on {mesh.stem} with `Hierarchical_options::simplification_rate` "
                "varied, and the direct one; the rises are to the latter. The paper has 0.004 of shear and "
                f"0.025 of stretch at 95 %.\n\n{rates}")
        if figure:
            points = [(100 * (task.rate or 0), m["seconds"], m["mean_shear"], m["stretch"])
                      for task, m in zip(tasks, results) if "failure" not in m]
            with open(f"{figure}.csv", "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(["rate", "seconds", "shear", "stretch"])
                writer.writerows([f"{number:.6g}" for number in point] for point in points)
            draw_rates(points, f"{figure}.svg")
            text += f"\nThe same is in `{figure.name}.csv`, drawn in `{figure.name}.svg`.\n"
        return text

    def variants(self, title: str, columns: list[Column], variants: dict[str, dict], text_columns: int = 2) -> str:
        """A table with a row for each mesh and name of a variant, which is given by the members of its task"""
        result = Table(["mesh", title], columns, text_columns)
        for file in self.compared_files():
            for name, m in zip(variants, self.medians(*(Task(file=file, **task) for task in variants.values()))):
                result.add([file.stem, name], m)
        return f"\n\n{result}"

    def sequential(self) -> str:
        return ("By levels is the library, on one thread. Sequential is the paper's Section 5: one vertex at a "
                "time from a priority queue, and back in reverse order, with harmonic weights and one harmonic "
                "smoothing of the vertex and its neighbours. Both use the same cost, vetoes, coarse solver and "
                "number of coarse vertices." +
                self.variants("order", [TRIANGLES, COARSE, SECONDS, *STAGES[1:4], KERNEL, PERCENT, SHEAR, STRETCH, FLIPS],
                              {"by levels": {"method": "habf++"}, "sequential": {"method": "sequential"}}))

    def sweeps(self) -> str:
        return ("The hierarchical method at the default rate, on one thread, with `Hierarchical_options::sweeps` "
                "varied; the default is 3." +
                self.variants("sweeps on each level", [SECONDS, STAGES[3], SHEAR, STRETCH, KERNEL, FLIPS],
                              {str(n): {"method": "habf++", "sweeps": n} for n in self.options.sweeps}, 1))

    def polish(self) -> str:
        return ("Direct ABF++, the hierarchical one, and the latter as the start of the direct solver "
                "(`Hierarchical_options::polish`). Replaced: whether the direct solver's result was valid, and "
                "so was returned." +
                self.variants("method", [SECONDS, ("polish", "polish", "seconds"), NEWTON, SHEAR, STRETCH, FLIPS,
                                         ("replaced", "polished", "yes")],
                              {TITLES[method]: {"method": method} for method in ("abf++", "habf++", "polished")}))

    def large(self) -> str:
        runs = Table(["triangles", "method", "threads"],
                     [SECONDS, SHEAR, STRETCH, KERNEL, FLIPS, BYTES, ("faces a second", "speed", ".0f"),
                      ("times the paper's", "over_paper", ".0f")], 0)
        targets, flips = Targets(), 0.
        smallest: dict[int, run.Measurement] = {}  # of each number of threads
        for size in self.options.large:
            with self.resized(size, noise=True) as file:
                tasks = [Task(method, file, threads) for method in ("habf++", "hlscm")
                         for threads in (1, self.options.threads)]
                results = self.medians(*tasks)
            for task, m in zip(tasks, results):
                size = m.get("triangles", size)
                if "failure" not in m:
                    m["speed"] = size / m["seconds"]
                    for faces, seconds in PAPER.items():
                        if abs(size / faces - 1) < 0.02 and task.method in seconds:
                            m["over_paper"] = m["speed"] * seconds[task.method] / faces
                runs.add([str(size), TITLES[task.method], str(task.threads)], m)
                flips += m.get("flips", 0)
                if task.method != "habf++":
                    continue
                threads = f", {task.threads} thread(s)"
                first = smallest.setdefault(task.threads, m)
                if size > 4e6:
                    targets.at_least("faces a second, times the paper's" + threads, ".0f", m.get("over_paper", nan), 100)
                    if first.get("triangles", size) < 4e5:
                        targets.at_most(f"time at {size} triangles / time at {first['triangles']}{threads}", ".1f",
                                        ratio(m.get("seconds"), first["seconds"]), 13)
                if size > 3e5:
                    targets.at_most(f"bytes a triangle, {size} triangles{threads}", ".0f", m.get("triangle_bytes", nan), 150)
        targets.at_most("flips of all", ".0f", flips, 0)
        return (f"The counterpart of the paper's Table III: {self.options.mesh.stem}, simplified and subdivided to "
                "the sizes there, each vertex then moved by a tenth of its shortest edge, at the default rate. The "
                "paper's surfaces are others of the same sizes (605,846 triangles: hierarchical ABF++ 107 s, "
                "hierarchical LSCM 305 s; 698,572: 50 s, 351 s; 4,241,328, at 98 %: 819 s, failed), on machines of "
                f"2004.\n\n{runs}{targets}")

    def direct(self) -> str:
        growth = {"triangles": "triangles / smallest", "seconds": "time", "bytes": "memory"}
        sizes = Table(["triangles", "threads"], [
            SECONDS, *((stage + ", %", stage + "_percent", ".1f") for stage in DIRECT_STAGES), NEWTON,
            ("CG steps", "cg_steps", ".0f"), ("factored", "factorizations", ".0f"), BYTES,
            *((title, name + "_growth", ".1f") for name, title in growth.items()), FLIPS], 0)
        smallest: list[run.Measurement] = []
        for size in self.options.sizes:
            with self.resized(size) as file:
                tasks = [Task("abf++", file, threads) for threads in (1, self.options.threads)]
                results = self.medians(*tasks)
            smallest = smallest or results
            for task, m, least in zip(tasks, results, smallest):
                if "failure" not in m:
                    m |= {stage + "_percent": 100 * m[stage] / m["seconds"] for stage in DIRECT_STAGES}
                    m |= {name + "_growth": ratio(m[name], least.get(name)) for name in growth}
                sizes.add([str(m.get("triangles", size)), str(task.threads)], m)
        return f"Direct ABF++: shares of its stages, and growth from the smallest size on, as quotients.\n\n{sizes}"


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
         "polish": "Polishing", "direct": "The direct method"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, nargs="?")
    parser.add_argument("--data", type=Path, metavar="FOLDER",
                        help="disks for quality, sequential, sweeps and polish; by default only the one mesh")
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
               f"Medians of {options.repeat} runs, each in a process of its own that has as many cores as threads, "
               "the BLAS on one thread. One thread where nothing else is said. A process was stopped after "
               f"{options.timeout:g} s, and had {options.memory:g} GB of memory.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())


if __name__ == "__main__":
    main()
