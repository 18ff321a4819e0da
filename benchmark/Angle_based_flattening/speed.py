#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how fast everything is, side by side in one run: the direct method against CGAL's LSCM, the hierarchical one on large
surfaces, injective maps, seams, atlases, and reading."""

import argparse
import math
import statistics
from pathlib import Path

import run
from report import Report, Table, Targets, head

DIRECT = [("LSCM", "lscm", "seconds"), ("ABF++", "seconds", "seconds"), ("ABF++ / LSCM", "ratio", ".2f"),
          ("angles", "angles", "seconds"), ("layout", "layout", "seconds"), ("Newton steps", "newton_steps", ".0f"),
          ("CG steps", "cg_steps", ".0f"), ("bytes a triangle", "triangle_bytes", ".0f"), ("energy", "energy", ".3e"),
          ("flips", "flips", ".0f")]
LARGE = [("seconds", "seconds", "seconds"), ("per million", "million_seconds", ".2f"), ("read", "read", "seconds"),
         ("coarsen", "coarsen", "seconds"), ("solve", "solve", "seconds"), ("refine", "refine", "seconds"),
         ("certify", "certify", "seconds"), ("/ hierarchical", "ratio", ".2f"), ("bytes a triangle", "triangle_bytes", ".0f"),
         ("kernel insertions, %", "kernel_percent", ".4f"), ("energy", "energy", ".3e"), ("L2 stretch", "stretch", ".3f"), ("flips", "flips", ".0f")]
AGAIN = [("first", "first", "seconds"), ("second", "seconds", "seconds"), ("second / first", "ratio", ".2f"),
         ("Newton steps", "newton_steps", ".0f"), ("CG steps", "cg_steps", ".0f"), ("energy", "energy", ".3e"), ("flips", "flips", ".0f")]
THREADS = [("1 thread", "one", "milliseconds"), ("2 threads", "seconds", "milliseconds"), ("2 / 1", "ratio", ".2f"),
           ("CPU, 2 / 1", "cpu_ratio", ".2f")]
SURFACES = [("seconds", "seconds", "seconds"), ("per million", "million_seconds", ".2f"), ("charts", "charts", ".0f"),
            ("bytes a triangle", "triangle_bytes", ".0f")]


def completed(m: run.Measurement) -> run.Measurement:
    """With what is relative to the number of triangles"""
    n = m["triangles"]
    m["million_seconds"] = m["seconds"] / n * 1e6
    m["triangle_bytes"] = m["bytes"] / n
    m["kernel_percent"] = 100 * m["kernel_insertions"] / m["vertices"]
    return m


class Benchmark:
    """Its functions are the parts of the report."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options, self.program = options, run.measure_of(options)
        self.targets = Targets()

    def medians(self, file: Path, tasks: list[tuple[str, int, tuple[str, ...]]], repeat: int = 0) -> list[run.Measurement]:
        """Of methods on so many threads, with options"""
        found = run.interleaved(lambda task: self.program.one("flatten", task[0], file, *task[2], threads=task[1]),
                                tasks, repeat or self.options.repeat)
        for task, m in zip(tasks, found):
            run.tell(f"{file.stem}, {task[0]} {' '.join(task[2])}, {task[1]} thread(s)", m)
        return [completed(m) for m in found]

    def disks(self) -> list[Path]:
        return [file for file in run.mesh_files(self.options.data) if self.program.mesh(file)["triangles"] >= self.options.least] \
            if self.options.data else [self.options.mesh]

    def direct(self) -> str:
        threads, rows, times = self.options.threads, Table(["mesh", "triangles"], DIRECT), []
        large = [self.program.resized(self.options.mesh, size) for size in self.options.sizes[-1:]]
        hard = sorted(self.options.demo.glob("mannequin-devil.off")) if self.options.demo else []
        disks, ratios = self.disks(), []
        for file in disks + hard + large:
            # LSCM needs minutes for the large ones.
            lscm, m = self.medians(file, [("lscm", 1, ()), ("abf++", threads, ())], 1 if file in large else self.options.direct_repeat)
            m["lscm"], m["ratio"] = lscm["seconds"], m["seconds"] / lscm["seconds"]
            rows.add([file.stem, f"{m['triangles']:,.0f}"], m)
            if file in disks:
                ratios.append(m["ratio"])
            most = 0.85 if file in disks else 0.9 if file in hard else 0.22
            self.targets.add(f"direct / LSCM, {file.stem}", ".2f", m["ratio"], most=most)
            if file in large:
                self.targets.add(f"direct, bytes a triangle, {file.stem}", ".0f", m["triangle_bytes"], most=900)
            times.append((m["triangles"], m["seconds"], file))
        self.targets.add("direct / LSCM, geometric mean of the disks", ".2f", statistics.geometric_mean(ratios), most=0.6)
        first = [time for time in times if time[2].stem == self.options.mesh.stem]
        if first:
            self.targets.add(f"direct, growth of the time from {first[0][0]:,.0f} to {times[-1][0]:,.0f} triangles", ".1f",
                             times[-1][1] / first[0][1], most=20)
        return f"On {threads} threads; LSCM uses one.\n\n{rows}"

    def again(self) -> str:
        rows, ratios = Table(["mesh", "call", "triangles"], AGAIN), {"again": [], "warm": []}
        for file in self.disks():
            tasks = [("abf++", 1, ())] + [(f"abf++-{call}", 1, ()) for call in ratios]
            first, *others = self.medians(file, tasks, self.options.direct_repeat)
            for call, m in zip(ratios, others):
                m["first"], m["ratio"] = first["seconds"], m["seconds"] / first["seconds"]
                ratios[call].append(m["ratio"])
                rows.add([file.stem, call, f"{m['triangles']:,.0f}"], m)
        for call, what, most in (("warm", "last", 0.6), ("again", "target", 1)):
            self.targets.add(f"second call from the {what} angles / first, geometric mean", ".2f",
                             statistics.geometric_mean(ratios[call]), most=most)
        return ("A second call of the same parameterizer on one thread: from the target angles on the same points (again), "
                f"or with `warm_start` after a twist by 0.01 radians (warm).\n\n{rows}")

    def hierarchical(self) -> str:
        threads, rows = self.options.threads, Table(["mesh", "map", "threads", "triangles"], LARGE, 2)
        tasks = [("habf++", count, kind) for kind in ((), ("--injective",)) for count in (1, threads)]
        for size in self.options.sizes:
            file = self.program.resized(self.options.mesh, size)
            of = dict(zip(tasks, self.medians(file, tasks)))
            for (method, count, kind), m in of.items():
                m["ratio"] = m["seconds"] / of[method, count, ()]["seconds"]
                rows.add([file.stem, "injective" if kind else "hierarchical", count, f"{m['triangles']:,.0f}"], m)
                at = f", {file.stem}, {count} thread(s)"
                if kind:
                    self.targets.add("injective / hierarchical" + at, ".2f", m["ratio"], most=1.6)
                else:
                    self.targets.add("hierarchical, seconds per million" + at, ".2f", m["million_seconds"], most=2 if count == 1 else 1.3)
                    self.targets.add("hierarchical, bytes a triangle" + at, ".0f", m["triangle_bytes"], most=140)
                if (count, kind) == (1, ()):
                    self.targets.add("reading, seconds per million" + at, ".3f", m["read"] / m["triangles"] * 1e6, most=0.15)
                    self.targets.add("kernel insertions, %" + at, ".4f", m["kernel_percent"], most=0.02)
        for file in run.mesh_files(self.options.data) if self.options.data else []:
            m = self.medians(file, tasks[:1], 1)[0]
            m["ratio"] = math.nan
            rows.add([file.stem, "hierarchical", 1, f"{m['triangles']:,.0f}"], m)
        for size in self.options.huge:
            file = self.program.resized(self.options.mesh, size)
            m = self.medians(file, [("habf++", threads, ())], 1)[0]
            m["ratio"] = math.nan
            rows.add([file.stem, "hierarchical", threads, f"{m['triangles']:,.0f}"], m)
            self.targets.add(f"hierarchical, seconds for ten million, at {m['triangles']:,.0f}", ".1f", 10 * m["million_seconds"], most=22)
            file.unlink()
        return str(rows)

    def threads(self) -> str:
        """What a second thread gains or costs"""
        rows, base = Table(["what", "triangles"], THREADS), self.options.demo / "camel.off" if self.options.demo else run.EXAMPLES / "egg.off"
        for size in self.options.thread_sizes:
            disk, surface = self.program.resized(self.options.mesh, size), Path(run.FOLDER.name) / f"surface_{size}.ply"
            self.program.mesh(base, "--triangles", size, "--any-topology", "--output", surface)
            for what, arguments in (("direct", ("flatten", "abf++", disk)), ("hierarchical", ("flatten", "habf++", disk)),
                                    ("atlas", ("atlas", surface))):
                one, two = run.interleaved(lambda count: self.program.one(*arguments, threads=count), [1, 2], self.options.direct_repeat)
                two["one"], two["ratio"], two["cpu_ratio"] = one["seconds"], two["seconds"] / one["seconds"], two["cpu"] / one["cpu"]
                rows.add([what, f"{two['triangles']:,.0f}"], two)
                self.targets.add(f"{what}, two threads / one, {two['triangles']:,.0f} triangles", ".2f", two["ratio"], most=1.02)
            surface.unlink()
        return str(rows)

    def surfaces(self) -> str:
        threads, rows = self.options.threads, Table(["what", "threads", "triangles"], SURFACES)
        base = self.options.demo / "camel.off" if self.options.demo else run.EXAMPLES / "egg.off"
        for size in self.options.surfaces:
            is_first = size == self.options.surfaces[0]
            file = Path(run.FOLDER.name) / f"surface_{size}.ply"
            made = self.program.mesh(base, "--triangles", size, "--any-topology", "--output", file)
            if is_first:
                seams = self.program.one("seams", "cones", file, "--method", "habf++")
                seams["seconds"] = seams["choice_seconds"]
                seams["bytes"] = math.nan
                rows.add(["seams", 1, f"{made['triangles']:,.0f}"], completed(seams))
                self.targets.add(f"seams, seconds per million, at {made['triangles']:,.0f}", ".2f", seams["million_seconds"], most=2)
            m = completed(self.program.one("atlas", file, threads=threads))
            rows.add(["atlas", threads, f"{made['triangles']:,.0f}"], m)
            self.targets.add(f"atlas, seconds per million, at {made['triangles']:,.0f}", ".1f", m["million_seconds"],
                             most=12 if is_first else 14)
            file.unlink()
        return f"{base.stem}, subdivided.\n\n{rows}"


PARTS = {"direct": "Direct", "again": "Asked again", "hierarchical": "Hierarchical and injective", "surfaces": "Seams and atlases",
         "threads": "One thread and two"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, nargs="?")
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="disks; by default only the one mesh")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--parts", type=run.words(PARTS), default=",".join(PARTS), metavar="PART,PART,...", help="(%(default)s)")
    for name, default, text in (("sizes", "388000,1552000", "triangles of the large disks"), ("huge", "10000000", "and of huge ones"),
                                ("surfaces", "1250000,5000000", "triangles of the surfaces that are cut open")):
        parser.add_argument("--" + name, type=run.numbers, default=default, metavar="N,N,...", help=f"{text} ({default})")
    parser.add_argument("--thread-sizes", type=run.numbers, default="100,300,1000,3000,10000,30000,100000,300000,1000000",
                        metavar="N,N,...", help="triangles of the surfaces for one thread and two (%(default)s)")
    parser.add_argument("--least", type=int, default=15000, metavar="N", help="triangles of a disk for the direct method (%(default)s)")
    parser.add_argument("--direct-repeat", type=int, default=7, metavar="N", help="runs of the direct method on small disks (%(default)s)")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="compared with one (%(default)s)")
    run.add_options(parser, memory=22)
    options = parser.parse_args()
    benchmark = Benchmark(options)
    report = Report(options.output)
    report.add(head("Speed", benchmark.program) +
               f"Medians of {options.repeat} runs in turn, of {options.direct_repeat} of the direct method on small disks, and one run of the largest, each in a separate "
               "process with as many cores as threads. The BLAS used one thread. Times are those of whole calls, without reading files.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())
    report.add(str(benchmark.targets))


if __name__ == "__main__":
    main()
