#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes texture atlases by `make_atlas()`: of some models, for each purpose; of everything in a
folder, with all charts checked; of one model in many sizes; and against CGAL's LSCM on the same surfaces, cut open along the same seams."""

import argparse
import math
import statistics
from pathlib import Path

import run
from report import Report, Table, Targets, cell, head, table
from terrains import write_terrain

COLUMNS = [("charts", "charts", ".0f"), ("terminals", "terminals", ".0f"), ("seam", "seam", ".2f"), ("L2 stretch", "stretch", ".3f"),
           ("energy", "energy", ".2e"), ("contact", "contact", ".1%"), ("covered", "covered", ".1%"), ("flips", "flips", ".0f"),
           ("overlapping", "overlapping", ".0f"), ("shared texels", "shared_texels", ".0f"), ("seconds", "seconds", "seconds")]
STAGES = [("read", "read", ".1%"), ("charts", "chart_seconds", ".1%"), ("pack", "pack", ".1%"), ("certify", "certify", ".1%"),
          ("measure", "measure", ".1%"), ("write", "write", ".1%")]

# What a seam and an L2 stretch may be: 5 % and 2 % above what was to be reached with one chart
LIMITS = {"homer": (3.83, 1.068), "cow": (4.34, 1.076), "camel": (4.52, 1.079), "elephant": (4.97, 1.066), "armadillo": (4.66, 1.093),
          "turbine": (4.60, 1.123)}
SEPARATED = {"elephant": 0.49, "armadillo": 0.60}  # the least share that is covered
OTHERS = ["fandisk", "anchor_dense", "bunny00"]
METHODS = {"direct": "ABF++", "hierarchical": "hierarchical ABF++", "injective": "injective", "separated": "separated"}
# Models of CGAL's demo with 4,000 to 60,000 triangles, by size, and the largest medians of seconds on two threads
SMALL = {"6,000": (0.10, ["blobby", "knot", "bones", "elephant-with-holes", "mushroom", "rotor_small", "elephant", "triceratops", "cow",
                          "knot1", "retinal"]),
         "10,000": (0.18, ["anchor_dense", "femur", "dino", "holes", "homer", "b9_mesh", "mech-holes-shark", "knot2", "bull", "fandisk",
                           "lion", "blade"]),
         "20,000": (math.inf, ["cylinder_locally_refined", "lion-head", "cheese", "turbine", "camel", "ChineseDragon-10kv", "bear_bis",
                               "mannequin-devil", "bear"]),
         "50,000": (0.8, ["fandisk_large", "man", "diplodocus", "armadillo"])}
WAITING = [("seconds, 1 thread", "alone", "seconds"), ("2 threads", "seconds", "seconds"), ("2 / 1", "threads_ratio", ".2f"),
           ("CPU seconds, 1 thread", "cpu_alone", "seconds"), ("page faults", "faults_alone", ",.0f"), ("charts", "charts", ".0f"),
           ("L2 stretch", "stretch", ".3f")]
WAYS = {"few charts": [], "conformal": ["--for", "conformal"], "texture": ["--for", "texture"]}
NO_SURFACE = ("cannot read a manifold mesh", "the mesh has no faces")


def ways(m: run.Measurement) -> str:
    """How the maps of the charts were made"""
    return ", ".join(f"{title}: {m[name]:.0f}" for name, title in METHODS.items() if m[name] > 0)


class Benchmark:
    """Its functions are the parts of the report."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.program = run.measure_of(options)

    def measure(self, file: Path, *how: object, threads: int | None = None) -> run.Measurement:
        threads = threads or self.options.threads
        m = self.program.one("atlas", file, *how, threads=threads)
        run.tell(" ".join(map(str, (file.stem, *how, "threads", threads))), m)
        return m

    def files(self) -> list[Path]:
        demo = self.options.demo
        return [demo / f"{name}.off" for name in self.options.models] if demo else [run.EXAMPLES / "egg.off"]

    def models(self) -> str:
        rows, targets = Table(["model", "triangles", "for", "maps"], COLUMNS, 4), Targets()
        for file in self.files():
            for how, choice in WAYS.items():
                m = self.measure(file, "--check", *choice)
                rows.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else "", how, ways(m)], m)
                self.add_targets(file.stem, how, m, targets)
        return (f"On {self.options.threads} thread(s). Energy: of Equation 1, for each corner. Contact: the largest of a chart. "
                f"Covered: of the square, at 1024 by 1024 texels with a gutter of 4.\n\n{rows}" + (str(targets) if targets.rows else ""))

    @staticmethod
    def add_targets(name: str, how: str, m: run.Measurement, targets: Targets) -> None:
        if how != "few charts":
            if name in SEPARATED:
                targets.add(f"{name}, {how}: covered", ".1%", m["covered"], least=SEPARATED[name])
        elif name in LIMITS:
            seam, stretch = LIMITS[name]
            targets.add(f"{name}, charts", ".0f", m["charts"], most=1)
            targets.add(f"{name}, seam", ".2f", m["seam"], most=1.05 * seam)
            targets.add(f"{name}, L2 stretch", ".3f", m["stretch"], most=1.02 * stretch)
            targets.add(f"{name}, covered", ".1%", m["covered"], least=0.4)

    def folder(self) -> str:
        """All meshes that there are"""
        results = {file.name: self.measure(file, "--check") for file in run.mesh_files(self.options.demo or run.EXAMPLES)}
        meshes = {name: m for name, m in results.items() if not m.get("failure", "").startswith(NO_SURFACE)}
        done = {name: m for name, m in meshes.items() if "failure" not in m}
        failures = [[name, m["failure"]] for name, m in meshes.items() if "failure" in m]
        total = {name: sum(m[name] for m in done.values()) for name in
                 ("triangles", "charted", "parts", "skipped", "charts", "missed", "flips", "overlapping", "shared_texels", *METHODS)}
        targets = Targets()
        targets.add("meshes without an atlas", ".0f", len(failures), most=0)
        targets.add("faces with a chart", ".4%", total["charted"] / total["triangles"], least=1)
        for name, title in [("flips", "flipped faces"), ("overlapping", "overlapping faces"),
                            ("shared_texels", "texels of two charts, or faces out of the square")]:
            targets.add(title, ".0f", total[name], most=0)
        text = (f"{len(results)} files, of which {len(results) - len(meshes)} have no faces or are not manifold. The others have {total['triangles']:,.0f} triangles in "
                f"{total['parts']:.0f} parts, which become {total['charts']:.0f} charts ({ways(run.Measurement(total))}). "
                f"{total['skipped']:.0f} parts are skipped. {total['missed']:.0f} charts stretch by more than 3 % above the bound.\n{targets}")
        if failures:
            text += "\n" + table(["mesh", "FAILED"], failures, 2)
        skipped = [[name, m["message"]] for name, m in done.items() if m["skipped"] > 0]
        if skipped:
            text += "\n" + table(["mesh", "parts without charts"], skipped, 2)
        return text + self.outliers(done)

    @staticmethod
    def outliers(done: dict[str, run.Measurement]) -> str:
        columns = [("triangles", "triangles", ",.0f"), ("charts", "charts", ".0f"), ("missed", "missed", ".0f"),
                   ("seam", "seam", ".2f"), ("scale stretch", "scale_stretch", ".2f"), ("L2 stretch", "stretch", ".3g"),
                   ("seconds", "seconds", "seconds")]
        missed = Table(["mesh"], columns, 1)
        for name, m in sorted(done.items(), key=lambda item: -item[1]["scale_stretch"]):
            if m["missed"] > 0:
                missed.add([name], m)
        slowest = Table(["mesh"], columns, 1)
        for name, m in sorted(done.items(), key=lambda item: -item[1]["seconds"])[:5]:
            slowest.add([name], m)
        return (f"\nMeshes with charts that stretch more; scale stretch is the largest of a chart:\n\n{missed}" if missed.rows else "") + \
            f"\nThe slowest ones:\n\n{slowest}"

    def growth(self) -> str:
        base, threads = self.files()[-1].with_stem(self.options.base) if self.options.demo else self.files()[0], self.options.threads
        titles = ["triangles", "seconds, 1 thread", f"{threads} threads", f"1 / {threads}", "time / (n log n), relative", "bytes a triangle", "maps",
                  "seam", "L2 stretch", "covered"]
        rows, stages, targets, first = [], Table(["triangles"], STAGES, 0), Targets(), math.nan
        for size in self.options.sizes:
            file = Path(run.FOLDER.name) / f"growth_{size}.ply"
            made = self.program.mesh(base, "--triangles", size, "--any-topology", "--output", file)
            one, more = [made] * 2 if "failure" in made else run.interleaved(
                lambda count: self.measure(file, threads=count), [1, threads], self.options.repeat)
            if failure := one.get("failure") or more.get("failure"):
                rows.append([str(size), "FAILED: " + failure])
                continue
            n, seconds = one["triangles"], more["seconds"]
            rate = seconds / (n * math.log(n))
            first = rate if math.isnan(first) else first
            rows.append([f"{n:,.0f}", cell(one["seconds"], "seconds"), cell(seconds, "seconds"), f"{one['seconds'] / seconds:.2f}",
                         f"{rate / first:.2f}", f"{more['bytes'] / n:.0f}", ways(more), f"{more['seam']:.2f}", f"{more['stretch']:.3f}",
                         f"{more['covered']:.1%}"])
            stages.add([f"{n:,.0f}"], run.Measurement({name: more[name] / seconds for _, name, _ in STAGES}))
            if n > 9e5:
                targets.add(f"seconds for a million triangles, at {n:,.0f}", ".1f", seconds / n * 1e6, most=15)
                targets.add(f"time / (n log n), relative to the first row, at {n:,.0f}", ".2f", rate / first, most=1.3)
        return (f"The model {base.stem}, simplified or subdivided.\n\n{table(titles, rows, 0)}\n"
                f"The share of each stage in the time, on {threads} thread(s):\n\n{stages}" + (str(targets) if targets.rows else ""))

    def small(self) -> str:
        """What an interactive program waits for"""
        if not self.options.demo:
            return "Not measured: these are meshes of CGAL's demo (`--demo`).\n"
        rows, targets = Table(["model", "triangles", "maps"], WAITING, 3), Targets()
        for size, (most, names) in SMALL.items():
            seconds = []
            for name in names:
                m = self.wait(self.options.demo / f"{name}.off")
                rows.add([name, f"{m['triangles']:,.0f}", ways(m)], m)
                seconds.append(m["seconds"])
            typical = statistics.median(seconds)
            if most < math.inf:
                targets.add(f"some {size} triangles: median of the seconds on two threads", ".2f", typical, most=most)
            targets.add(f"some {size} triangles: largest / median", ".1f", max(seconds) / typical, most=3)
        m = self.wait(self.rough_terrain())
        rows.add(["rough terrain", f"{m['triangles']:,.0f}", ways(m)], m)
        return ("Page faults: those that no disk serves, of the library alone. The rough terrain is a square with hills and normal noise of two edge "
                f"lengths; it is not in the medians.\n\n{rows}{targets}")

    def wait(self, file: Path) -> run.Measurement:
        alone, m = run.interleaved(lambda count: self.measure(file, threads=count), [1, 2], self.options.repeat)
        m["alone"], m["cpu_alone"], m["faults_alone"] = alone["seconds"], alone["cpu"], alone["faults"]
        m["threads_ratio"] = m["seconds"] / alone["seconds"]
        return m

    @staticmethod
    def rough_terrain() -> Path:
        file = Path(run.FOLDER.name) / "rough_terrain.off"
        write_terrain(file, squares=160, height=0.3, noise=2, regular=False)
        return file

    def lscm(self) -> str:
        """The time of everything, over that of one map without any guarantee"""
        threads = self.options.threads
        titles = ["model", "triangles", "LSCM", "atlas, 1 thread", f"atlas, {threads} threads", "atlas, 1 thread / LSCM", f"{threads} threads / LSCM",
                  "flips of LSCM", "L2 stretch of LSCM", "of the atlas"]
        rows = []
        for file in self.files():
            disk = Path(run.FOLDER.name) / f"{file.stem}_disk.ply"
            cut = self.measure(file, "--output", disk)
            if "failure" in cut or cut["charts"] != 1:
                rows.append([file.stem, "FAILED: " + cut.get("failure", f"{cut['charts']:.0f} charts")])
                continue
            tasks = [("lscm", 1), ("atlas", 1), ("atlas", threads)]
            lscm, one, more = run.interleaved(
                lambda task: self.measure(file, threads=task[1]) if task[0] == "atlas" else self.program.one("flatten", "lscm", disk),
                tasks, self.options.repeat)
            rows.append([file.stem, f"{cut['triangles']:,.0f}", *(cell(m["seconds"], "seconds") for m in (lscm, one, more)),
                         *(cell(m["seconds"] / lscm["seconds"], ".1f") for m in (one, more)), cell(lscm["flips"], ".0f"),
                         cell(lscm["stretch"], ".3g"), cell(one["stretch"], ".3f")])
        return ("LSCM flattens the surface as make_atlas() has cut it open, on one thread. Its time is that of one linear system. That of the atlas includes "
                f"seams, all maps that were tried, packing, certificates and measures.\n\n{table(titles, rows)}")


PARTS = {"models": "Models", "small": "Small models", "folder": "A folder of meshes", "growth": "Growth", "lscm": "Time against LSCM"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo; without it, those of the examples are taken")
    parser.add_argument("--models", type=lambda text: text.split(","), default=[*LIMITS, *OTHERS], metavar="NAME,NAME,...",
                        help="of the demo (" + ",".join([*LIMITS, *OTHERS]) + ")")
    parser.add_argument("--parts", type=run.words(PARTS), default=",".join(PARTS), metavar="PART,PART,...", help="what to measure (%(default)s)")
    parser.add_argument("--sizes", type=run.numbers, default="20000,80000,320000,1300000", metavar="N,N,...",
                        help="numbers of triangles for growth (%(default)s)")
    parser.add_argument("--base", default="camel", metavar="NAME", help="the model that grows (%(default)s)")
    parser.add_argument("--threads", type=int, default=2, metavar="N", help="compared with one thread (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    benchmark = Benchmark(options)
    report = Report(options.output)
    report.add(head("Atlases", benchmark.program) + "Surfaces are read from files, which is not timed, and given to make_atlas() with default options, unless "
               "stated otherwise. Where faces are checked, the surface is cut open along the seams that it marks: *flips* and *overlapping* count faces by exact "
               "predicates, also across charts; *shared texels* counts those that two charts touch. Seam: length in units of the square root of the area. "
               f"Times of growth and of LSCM are medians of {options.repeat} runs, in turn with what they are compared with.\n")
    for part in options.parts:
        report.add(f"\n## {PARTS[part]}\n\n" + getattr(benchmark, part)())


if __name__ == "__main__":
    main()
