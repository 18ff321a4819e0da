#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Measures the hierarchical parameterizer: speed, memory, distortion, against the direct one, CGAL's
LSCM, hierarchical LSCM and the paper's order."""

import argparse
import csv
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import run
from report import DASH, Report, Targets, cell, count, failure_row, head, ratio, seconds, table, yes

TITLES = {"habf++": "hierarchical ABF++", "polished": "hierarchical ABF++, polished",
          "hlscm": "hierarchical LSCM", "sequential": "sequential hierarchy", "abf++": "direct ABF++",
          "lscm": "CGAL's LSCM"}
STAGES = ["read", "coarsen", "solve", "refine", "certify", "write"]
DIRECT_STAGES = ["read", "targets", "angles", "layout", "certify", "write"]


@dataclass(frozen=True)
class Task:
    """What one process measures"""

    method: str
    file: Path
    threads: int = 1
    rate: float | None = None
    sweeps: int | None = None

    def measure(self, measure: run.Measure) -> run.Measurement:
        arguments = [f"--{name}={value}" for name, value in (("rate", self.rate), ("sweeps", self.sweeps))
                     if value is not None]
        method = self.method
        if method == "polished":
            method, arguments = "habf++", [*arguments, "--polish"]
        result = measure.one("flatten", method, self.file, *arguments, threads=self.threads)
        run.tell(f"{self.file.stem}, {TITLES[self.method]}, threads {self.threads} {' '.join(arguments)}", result)
        return result


class Benchmark:
    """The parts of the report"""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.program = run.measure_of(options)

    def run(self, *tasks: Task) -> list[run.Measurement]:
        return run.interleaved(lambda task: task.measure(self.program), tasks, self.options.repeat)

    def compared_files(self) -> list[Path]:
        """The meshes in the folder, or else the one mesh"""
        return run.mesh_files(self.options.data) if self.options.data else [self.options.mesh]

    def speed(self) -> str:
        threads = self.options.threads
        titles = ["method", "threads", "triangles", "seconds", "per million", *STAGES, "bytes a triangle", "flips"]
        rows, ratios, targets = [], [], Targets()
        for size in self.options.sizes:
            with tempfile.TemporaryDirectory() as folder:
                file = self.program.resized(self.options.mesh, size, folder)
                tasks = [Task("habf++", file), Task("habf++", file, threads), Task("abf++", file), Task("lscm", file)]
                results = self.run(*tasks)
            one, more, direct, lscm = (m.get("seconds") for m in results)
            size = results[0].get("triangles", size)
            for task, m in zip(tasks, results):
                cells = [TITLES[task.method], str(task.threads), count(size)]
                # A stage that the method does not have takes exactly no time.
                rows.append(failure_row(cells, m, len(titles)) if "failure" in m else
                            [*cells, seconds(m["seconds"]), cell(m["seconds"] / size * 1e6, ".2f"),
                             *(seconds(m.get(stage) or None) for stage in STAGES),
                             count(m["bytes"] / size), count(m["flips"])])
            ratios.append([count(size), *(cell(ratio(*r), ".2f") for r in ((direct, one), (lscm, one), (one, more)))])
            at = f", {size:.0f} triangles"
            if size > 3e5:
                targets.at_most("seconds per million triangles, one thread" + at, ".2f", ratio(one, size / 1e6), 2.2)
                targets.at_least(f"one thread / {threads} threads" + at, ".2f", ratio(one, more), 1.3)
                targets.at_most("bytes a triangle, one thread" + at, ".0f", ratio(results[0].get("bytes"), size), 150)
                targets.at_most(f"bytes a triangle, {threads} threads" + at, ".0f",
                                ratio(results[1].get("bytes"), size), 150)
            if size > 1.5e6:
                targets.at_least("direct ABF++ / hierarchical" + at, ".2f", ratio(direct, one), 6)
                targets.at_least("CGAL's LSCM / hierarchical" + at, ".2f", ratio(lscm, one), 15)
        ratio_titles = ["triangles", "direct ABF++ / hierarchical", "CGAL's LSCM / hierarchical",
                        f"one thread / {threads} threads"]
        return ("The whole call of `parameterize()` on a mesh that is in memory, at the default rate, in "
                "seconds, with its stages. Memory: peak resident size during the call beyond that before "
                "it. Ratios are to the hierarchical method on one thread.\n\n" + table(titles, rows) +
                "\n" + table(ratio_titles, ratios, 0) + targets.text())

    def quality(self) -> str:
        limits = {"bunny": 0.002, "lionhead": 0.002, "horse": 0.002, "armadillo": 0.004, "camel": 0.008}
        titles = ["mesh", "triangles", "shear, direct", "hierarchical", "rise", "stretch, direct", "hierarchical",
                  "rise", "shear as returned, direct", "hierarchical", "kernel insertions", "% of vertices",
                  "retries", "flips"]
        rows, targets, most_percent, flips = [], Targets(), 0., 0.
        with tempfile.TemporaryDirectory() as folder:
            files = self.compared_files()
            if len(self.options.sizes) > 1:
                files.append(self.program.resized(self.options.mesh, self.options.sizes[1], folder))
            for file in files:
                d, h = results = self.run(Task("abf++", file), Task("habf++", file))
                failed = [m for m in results if "failure" in m]
                if failed:
                    rows.append(failure_row([file.stem], failed[0], len(titles)))
                    continue
                percent = 100 * h["kernel_insertions"] / h["vertices"]
                rises = {name: h[name] - d[name] for name in ("mean_shear", "stretch")}
                rows.append([file.stem, count(h["triangles"]),
                             *(text for name, rise in rises.items()
                               for text in (cell(d[name]), cell(h[name]), cell(rise, "+.4f"))),
                             cell(d["shear"]), cell(h["shear"]), count(h["kernel_insertions"]), cell(percent),
                             count(h["retries"]), count(h["flips"])])
                for limit in (limit for name, limit in limits.items() if name in file.stem):
                    targets.at_most("rise of shear, " + file.stem, ".4f", rises["mean_shear"], limit)
                    targets.at_most("rise of stretch, " + file.stem, ".4f", rises["stretch"], 0.015)
                most_percent, flips = max(most_percent, percent), flips + h["flips"]
        targets.at_most("kernel insertions, % of the vertices of any mesh", ".4f", most_percent, 0.02)
        targets.at_most("flips of all", ".0f", flips, 0)
        return ("Direct ABF++ and the hierarchical one at the default rate. The shear of Eq. 24 depends on the "
                "direction of the axes; the rise is that of its root mean square over all directions, and the "
                "shear as returned is the one along the axes of the coordinates.\n\n" +
                table(titles, rows) + targets.text())

    def rates(self) -> str:
        mesh = self.options.mesh
        tasks = [Task("abf++", mesh), *(Task("habf++", mesh, rate=rate / 100) for rate in self.options.rates)]
        results = self.run(*tasks)
        direct = results[0]
        titles = ["rate", "coarse triangles", "seconds", "shear", "rise", "stretch", "rise", "kernel insertions",
                  "retries", "flips"]
        rows = []
        for task, m in zip(tasks, results):
            cells = [f"{100 * task.rate:g} %" if task.rate else "direct"]
            rises = ((m.get(name), m.get(name, 0) - direct.get(name, float("nan"))) for name in ("mean_shear", "stretch"))
            rows.append(failure_row(cells, m, len(titles)) if "failure" in m else
                        [*cells, count(m.get("coarse_triangles")), seconds(m["seconds"]),
                         *(text for value, rise in rises for text in (cell(value), cell(rise, "+.4f"))),
                         count(m.get("kernel_insertions")), count(m.get("retries")), count(m["flips"])])
        text = (f"The hierarchical method on {mesh.stem} with `Hierarchical_options::simplification_rate` varied, "
                "and the direct one; the rises are to the latter. The paper has 0.004 of shear and 0.025 of "
                "stretch at 95 %.\n\n" + table(titles, rows))
        if self.options.figure:
            name = self.options.figure
            points = [(100 * (task.rate or 0), *(m[key] for key in ("seconds", "mean_shear", "stretch")))
                      for task, m in zip(tasks, results) if "failure" not in m]
            with open(f"{name}.csv", "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(["rate", "seconds", "shear", "stretch"])
                writer.writerows([f"{number:.6g}" for number in point] for point in points)
            draw_rates(points, f"{name}.svg")
            text += f"\nThe same is in `{name.name}.csv`, drawn in `{name.name}.svg`.\n"
        return text

    def variants(self, titles: list[str], text_columns: int, tasks_of: Callable[[Path], list[Task]],
                 cells_of: Callable[[Task, run.Measurement], list[str]], name_of: Callable[[Task], str]) -> str:
        """A table of several ways to flatten each mesh, which are named in the second column"""
        rows = []
        for file in self.compared_files():
            tasks = tasks_of(file)
            for task, m in zip(tasks, self.run(*tasks)):
                cells = [file.stem, name_of(task)]
                rows.append(failure_row(cells, m, len(titles)) if "failure" in m else [*cells, *cells_of(task, m)])
        return table(titles, rows, text_columns)

    def sequential(self) -> str:
        titles = ["mesh", "order", "triangles", "coarse triangles", "seconds", "coarsen", "solve", "refine",
                  "kernel insertions", "% of vertices", "shear", "stretch", "flips"]
        return ("By levels is the library, on one thread. Sequential is the paper's Section 5: one vertex at a "
                "time from a priority queue, and back in reverse order, with harmonic weights and one harmonic "
                "smoothing of the vertex and its neighbours. Both use the same cost, vetoes, coarse solver and "
                "number of coarse vertices.\n\n" +
                self.variants(titles, 2, lambda file: [Task("habf++", file), Task("sequential", file)],
                              lambda _, m: [count(m["triangles"]), count(m["coarse_triangles"]),
                                            *(seconds(m[name]) for name in ("seconds", "coarsen", "solve", "refine")),
                                            count(m["kernel_insertions"]),
                                            cell(100 * m["kernel_insertions"] / m["vertices"]),
                                            cell(m["mean_shear"]), cell(m["stretch"]), count(m["flips"])],
                              lambda task: "by levels" if task.method == "habf++" else "sequential"))

    def sweeps(self) -> str:
        titles = ["mesh", "sweeps on each level", "seconds", "refine", "shear", "stretch", "kernel insertions", "flips"]
        return ("The hierarchical method at the default rate, on one thread, with `Hierarchical_options::sweeps` "
                "varied; the default is 3.\n\n" +
                self.variants(titles, 1, lambda file: [Task("habf++", file, sweeps=n) for n in self.options.sweeps],
                              lambda _, m: [seconds(m["seconds"]), seconds(m["refine"]), cell(m["mean_shear"]),
                                            cell(m["stretch"]), count(m["kernel_insertions"]), count(m["flips"])],
                              lambda task: str(task.sweeps)))

    def polish(self) -> str:
        titles = ["mesh", "method", "seconds", "polish", "Newton steps", "shear", "stretch", "flips", "replaced"]

        def cells(task: Task, m: run.Measurement) -> list[str]:
            polished = task.method == "polished"
            return [seconds(m["seconds"]), seconds(m["polish"] if polished else None),
                    count(None if task.method == "habf++" else m["newton_steps"]), cell(m["mean_shear"]),
                    cell(m["stretch"]), count(m["flips"]), yes(m["polished"]) if polished else DASH]

        return ("Direct ABF++, the hierarchical one, and the latter as the start of the direct solver "
                "(`Hierarchical_options::polish`). Replaced: whether the direct solver's result was valid, and so "
                "was returned.\n\n" +
                self.variants(titles, 2, lambda file: [Task(method, file) for method in ("abf++", "habf++", "polished")],
                              cells, lambda task: TITLES[task.method]))

    def large(self) -> str:
        # A row of the paper's Table III: surfaces of that size, not ours. None: failed
        paper = {605846: {"habf++": 107, "hlscm": 305}, 698572: {"habf++": 50, "hlscm": 351}, 4241328: {"habf++": 819}}
        titles = ["triangles", "method", "threads", "seconds", "shear", "stretch", "kernel insertions", "flips",
                  "bytes a triangle", "faces a second", "times the paper's"]
        rows, targets, first, flips = [], Targets(), {}, 0.
        for size in self.options.large:
            with tempfile.TemporaryDirectory() as folder:
                file = self.program.resized(self.options.mesh, size, folder, noise=True)
                tasks = [Task(method, file, threads) for method in ("habf++", "hlscm")
                         for threads in (1, self.options.threads)]
                results = self.run(*tasks)
            for task, m in zip(tasks, results):
                n, time = m.get("triangles", size), m.get("seconds")
                theirs = next((times for k, times in paper.items() if abs(n / k - 1) < 0.02), {})
                over_paper = ratio(theirs.get(task.method) and theirs[task.method] * n / size, time)
                cells = [count(n), TITLES[task.method], str(task.threads)]
                rows.append(failure_row(cells, m, len(titles)) if "failure" in m else
                            [*cells, seconds(time), cell(m["mean_shear"]), cell(m["stretch"]),
                             count(m["kernel_insertions"]), count(m["flips"]), count(m["bytes"] / n), count(n / time),
                             count(over_paper)])
                flips += m.get("flips", 0)
                if task.method != "habf++":
                    continue
                threads = f", {task.threads} thread(s)"
                if n > 4e6:
                    targets.at_least("faces a second, times the paper's" + threads, ".0f", over_paper, 100)
                    for start, least in first.get(task.threads, []):
                        targets.at_most(f"time at {n:.0f} triangles / time at {start:.0f}{threads}", ".1f",
                                        ratio(time, least), 13)
                elif n < 4e5:
                    first.setdefault(task.threads, []).append((n, time))
                if n > 3e5:
                    targets.at_most(f"bytes a triangle, {n:.0f} triangles{threads}", ".0f", ratio(m.get("bytes"), n), 150)
        targets.at_most("flips of all", ".0f", flips, 0)
        return (f"The counterpart of the paper's Table III: {self.options.mesh.stem}, simplified and subdivided to the "
                "sizes there, each vertex then moved by a tenth of its shortest edge, at the default rate. The "
                "paper's surfaces are others of the same sizes (605,846 triangles: hierarchical ABF++ 107 s, "
                "hierarchical LSCM 305 s; 698,572: 50 s, 351 s; 4,241,328, at 98 %: 819 s, failed), on machines "
                "of 2004.\n\n" + table(titles, rows, 0) + targets.text())

    def direct(self) -> str:
        titles = ["triangles", "threads", "seconds", *(stage + ", %" for stage in DIRECT_STAGES), "Newton steps",
                  "CG steps", "factored", "bytes a triangle", "triangles / smallest", "time", "memory", "flips"]
        rows, smallest = [], []
        for size in self.options.sizes:
            with tempfile.TemporaryDirectory() as folder:
                file = self.program.resized(self.options.mesh, size, folder)
                tasks = [Task("abf++", file, threads) for threads in (1, self.options.threads)]
                results = self.run(*tasks)
            smallest = smallest or results
            for task, m, least in zip(tasks, results, smallest):
                cells = [count(m.get("triangles", size)), str(task.threads)]
                rows.append(failure_row(cells, m, len(titles)) if "failure" in m else
                            [*cells, seconds(m["seconds"]),
                             *(cell(100 * m[stage] / m["seconds"], ".1f") for stage in DIRECT_STAGES),
                             *(count(m[name]) for name in ("newton_steps", "cg_steps", "factorizations")),
                             count(m["bytes"] / m["triangles"]),
                             *(cell(ratio(m[name], least.get(name)), ".1f") for name in ("triangles", "seconds", "bytes")),
                             count(m["flips"])])
        return ("Direct ABF++: shares of its stages, and growth from the smallest size on, as quotients.\n\n" +
                table(titles, rows, 0))


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
    parser.add_argument("mesh", nargs="?", type=Path, default=run.SHELL, help="a disk, which is simplified or "
                        "subdivided; by default the sea shell of the examples")
    parser.add_argument("--data", type=Path, metavar="FOLDER",
                        help="disks for quality, sequential, sweeps and polish; by default only the one mesh")
    parser.add_argument("--parts", nargs="*", choices=PARTS, default=list(PARTS), help="what to measure")
    parser.add_argument("--sizes", type=run.numbers, default="97000,388000,1552000", metavar="N,N,...",
                        help="numbers of triangles for speed and direct; quality takes the second one")
    parser.add_argument("--large", type=run.numbers, default="388000,605846,698572,4241328", metavar="N,N,...",
                        help="numbers of triangles for large")
    parser.add_argument("--rates", type=run.numbers, default="80,85,90,92.5,95,97,98,99,99.5", metavar="PERCENT,...",
                        help="simplification rates for rates")
    parser.add_argument("--sweeps", type=lambda text: [int(word) for word in text.split(",")], default="0,1,2,3,4",
                        metavar="N,N,...", help="sweeps on each level for sweeps")
    parser.add_argument("--figure", type=Path, metavar="NAME",
                        help="what rates measures is also written to NAME.csv and drawn to NAME.svg")
    parser.add_argument("--threads", type=int, default=2, help="compared with one thread, in speed and large")
    run.add_options(parser)
    options = parser.parse_args()
    benchmark = Benchmark(options)
    report = Report(options.output)
    report.add(head("Hierarchical parameterization", benchmark.program) +
               f"Medians of {options.repeat} runs, each in a process of its own that has as many cores as threads, the "
               "BLAS on one thread. One thread where nothing else is said. A process was stopped after "
               f"{options.timeout:g} s, and had {options.memory:g} GB of memory.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())


if __name__ == "__main__":
    main()
