#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens disks without overlaps, by `Hierarchical_options::injective`: what that costs in distortion, time and memory, against the
hierarchical and the direct method, whose maps may overlap themselves."""

import argparse
import math
import statistics
from dataclasses import dataclass
from pathlib import Path

import run
from report import Report, Table, Targets, cell, head, table


@dataclass(frozen=True)
class Variant:
    """A method and its options"""

    title: str
    method: str
    options: tuple[str, ...] = ()


VARIANTS = {"direct": Variant("direct", "abf++"),
            "hierarchical": Variant("hierarchical", "habf++"),
            "fast": Variant("injective", "habf++", ("--injective",)),
            "polished": Variant("injective, polished", "habf++", ("--injective", "--polish")),
            "isometric": Variant("injective, isometric", "habf++", ("--injective", "--area-weight=1"))}
COLUMNS = [("energy", "energy", ".3e"), ("/ direct", "over_direct", ".3f"), ("L2 stretch", "stretch", ".3f"),
           ("symmetric Dirichlet", "symmetric_dirichlet", ".3f"), ("quasi-conformal", "quasi_conformal", ".3f"),
           ("contact", "contact", ".1%"), ("least clearance", "least_clearance", ".3f"), ("seconds", "seconds", "seconds"),
           ("/ direct", "time_over_direct", ".2f"), ("/ hierarchical", "time_over_hierarchical", ".2f"),
           ("bytes a triangle", "triangle_bytes", ".0f"), ("flips", "flips", ".0f"), ("injective", "is_injective", "yes")]
GROWTH = [("energy", "energy", ".3e"), ("L2 stretch", "stretch", ".3f"), ("seconds", "seconds", "seconds"),
          ("per million", "million_seconds", ".2f"), ("/ hierarchical", "time_over_hierarchical", ".2f"),
          ("bytes a triangle", "triangle_bytes", ".0f"), ("injective", "is_injective", "yes")]

ENERGIES = {"horse": 4.3e-4, "camel": 4.6e-3, "bunny": 2.2e-4, "armadillo": 2.6e-3, "cow": 1.5e-2}  # of the fast maps
DIRICHLET = {"camel": 4.19, "armadillo": 4.40, "bunny": 4.09, "horse": 4.08, "cow": 4.28, "hilbert": 4.01}  # of the isometric ones


def hilbert_points(order: int) -> list[tuple[int, int]]:
    """The points of the Hilbert curve of that order, one after the other: four copies of the curve before, two of them mirrored"""
    if order == 0:
        return [(0, 0)]
    before, size = hilbert_points(order - 1), 2**(order - 1)
    last = 2 * size - 1
    return ([(y, x) for x, y in before] + [(x, y + size) for x, y in before] +
            [(x + size, y + size) for x, y in before] + [(last - y, size - 1 - x) for x, y in before])


def write_hilbert(file: Path, order: int) -> None:
    """A strip along the curve, with gaps as wide as itself; each of its squares is two by two cells."""
    path = [(2 * x, 2 * y) for x, y in hilbert_points(order)]
    between = [((a[0] + b[0]) // 2, (a[1] + b[1]) // 2) for a, b in zip(path, path[1:])]
    vertices: dict[tuple[int, int], int] = {}
    faces = []
    for x, y in path + between:
        for i in (2 * x, 2 * x + 1):
            for j in (2 * y, 2 * y + 1):
                a, b, c, d = (vertices.setdefault(p, len(vertices)) for p in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                faces += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    with file.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        out.writelines(f"{x} {y} 0\n" for x, y in vertices)
        out.writelines(f"3 {a} {b} {c}\n" for a, b, c in faces)


class Benchmark:
    """Its functions are the parts of the report."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.program = run.measure_of(options)

    def measure(self, name: str, file: Path, threads: int = 1) -> run.Measurement:
        variant = VARIANTS[name]
        m = self.program.one("flatten", variant.method, file, *variant.options, threads=threads)
        run.tell(f"{file.stem}, {variant.title}, threads {threads}", m)
        if "failure" not in m:
            m["triangle_bytes"] = m["bytes"] / m["triangles"]
            m["million_seconds"] = m["seconds"] / m["triangles"] * 1e6
            m["is_injective"] = m["border_is_simple"] == 1 and m["flips"] == 0
        return m

    def medians(self, file: Path, tasks: list[tuple[str, int]]) -> list[run.Measurement]:
        """Of a variant and a number of threads each"""
        return run.interleaved(lambda task: self.measure(task[0], file, task[1]), tasks, self.options.repeat)

    def disks(self) -> list[Path]:
        hilbert = Path(run.FOLDER.name) / f"hilbert_{self.options.order}.off"
        write_hilbert(hilbert, self.options.order)
        return (run.mesh_files(self.options.data) if self.options.data else [run.SHELL]) + [hilbert]

    def quality(self) -> str:
        rows, targets = Table(["disk", "triangles", "map"], COLUMNS, 3), Targets()
        ratios: dict[str, list[run.Measurement]] = {name: [] for name in self.options.variants}
        for file in self.disks():
            name = file.stem.split("_")[0]
            names = ["direct", "hierarchical", *self.options.variants]
            of = dict(zip(names, self.medians(file, [(variant, 1) for variant in names])))
            for variant, m in of.items():
                m["over_direct"] = m["energy"] / of["direct"]["energy"] if of["direct"]["energy"] > 1e-12 else math.nan
                for other in ("direct", "hierarchical"):
                    m["time_over_" + other] = m["seconds"] / of[other]["seconds"]
                rows.add([name, f"{m['triangles']:,.0f}" if "triangles" in m else "", VARIANTS[variant].title], m)
                if variant in ratios:
                    ratios[variant].append(m)
                    targets.add(f"{name}, {VARIANTS[variant].title}: is injective", ".0f", m["is_injective"], least=1)
            self.add_targets(name, of, targets)
        columns = [("energy / direct", "over_direct", ".3f"), ("L2 stretch", "stretch", ".3f"),
                   ("time / direct", "time_over_direct", ".2f"), ("time / hierarchical", "time_over_hierarchical", ".2f")]
        medians = [[VARIANTS[name].title, *(cell(statistics.median([m[column] for m in all_of if not math.isnan(m[column])] or
                                                                   [math.nan]), form) for _, column, form in columns)]
                   for name, all_of in ratios.items()]
        return ("Energy: of Equation 1, for each corner. Quasi-conformal: the mean ratio of the singular values, weighted by area. "
                "Contact: the share of the border's length that is nearer to another part of it than the clearance. Least clearance "
                "is in local edge lengths. hilbert is a strip in the plane along a Hilbert curve, which needs no distortion at all."
                f"\n\n{rows}\nMedians of all disks:\n\n{table(['map', *(title for title, _, _ in columns)], medians)}{targets}")

    @staticmethod
    def add_targets(name: str, of: dict[str, run.Measurement], targets: Targets) -> None:
        if name in ENERGIES and "fast" in of:
            targets.add(f"{name}, energy", ".2e", of["fast"]["energy"], most=ENERGIES[name])
        if (name in ENERGIES or name == "lionhead") and "polished" in of:
            targets.add(f"{name}, energy, polished / direct", ".4f", of["polished"]["over_direct"], most=1.01)
            targets.add(f"{name}, time, polished / direct", ".2f", of["polished"]["time_over_direct"], most=5)
        if name in DIRICHLET and "isometric" in of:
            targets.add(f"{name}, symmetric Dirichlet energy, isometric", ".3f", of["isometric"]["symmetric_dirichlet"],
                        most=DIRICHLET[name])

    def growth(self) -> str:
        rows, targets, threads = Table(["triangles", "map", "threads"], GROWTH, 0), Targets(), self.options.threads
        for size in self.options.sizes:
            file = self.program.resized(self.options.mesh, size)
            tasks = [(name, count) for name in ("hierarchical", "fast") for count in (1, threads)]
            of = dict(zip(tasks, self.medians(file, tasks)))
            for (name, count), m in of.items():
                m["time_over_hierarchical"] = m["seconds"] / of["hierarchical", count]["seconds"]
                rows.add([f"{m.get('triangles', size):,.0f}", VARIANTS[name].title, count], m)
            one, more = of["fast", 1], of["fast", threads]
            at = f", {size} triangles"
            targets.add("is injective" + at, ".0f", one["is_injective"], least=1)
            if size > 3e5:
                targets.add("time, injective / hierarchical" + at, ".2f", one["time_over_hierarchical"], most=1.5)
                targets.add(f"one thread / {threads}{at}", ".2f", one["seconds"] / more["seconds"], least=1.3)
                targets.add("bytes a triangle" + at, ".0f", max(one["triangle_bytes"], more["triangle_bytes"]), most=160)
            if size > 1.5e6 and self.options.mesh.stem.startswith("horse"):
                targets.add("energy" + at, ".2e", one["energy"], most=3.2e-5)
        return f"{self.options.mesh.stem}, simplified or subdivided.\n\n{rows}{targets}"


PARTS = {"quality": "Disks", "growth": "Growth"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, nargs="?")
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="disks for quality; without it, the bundled one")
    parser.add_argument("--parts", type=run.words(PARTS), default=",".join(PARTS), metavar="PART,PART,...",
                        help="what to measure (%(default)s)")
    injective = [name for name, variant in VARIANTS.items() if "--injective" in variant.options]
    parser.add_argument("--variants", type=run.words(injective), default=",".join(injective), metavar="NAME,NAME,...",
                        help="injective maps for quality (%(default)s)")
    parser.add_argument("--order", type=int, default=5, metavar="N", help="of the Hilbert curve for quality (%(default)s)")
    parser.add_argument("--sizes", type=run.numbers, default="5000,97000,388000,1552000", metavar="N,N,...",
                        help="numbers of triangles for growth (%(default)s)")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="compared with one thread, in growth (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    benchmark = Benchmark(options)
    report = Report(options.output)
    report.add(head("Injective maps", benchmark.program) + f"Medians of {options.repeat} runs, each in a separate process with as "
               "many cores as threads, and on one thread unless stated otherwise. The maps of the direct and the hierarchical method "
               "may overlap themselves. *Injective* ones are made with `Hierarchical_options::injective`, with the default weight of "
               "areas and without polishing unless stated otherwise.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())


if __name__ == "__main__":
    main()
