#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes atlases of models of CGAL's demo for each purpose, and measures what a texture gets: the density of texels, its
evenness, and seams. With a table of figures of another program, textures are compared with these."""

import argparse
import math
from pathlib import Path

import run
from report import Report, Table, Targets, head, table

MODELS = ["cow", "homer", "camel", "elephant", "armadillo", "fandisk", "anchor_dense", "rotor", "turbine", "pig", "bones", "mushroom",
          "bear", "dragknob", "man", "helmet", "hand", "femur", "knot1", "couplingdown", "joint", "part"]
PURPOSES = ["few-charts", "conformal", "texture"]
COLUMNS = [("charts", "charts", ".0f"), ("seam", "seam", ".2f"), ("L2 stretch", "stretch", ".3f"), ("covered", "covered", ".1%"),
           ("density", "texel_density", ".3f"), ("of 95 %", "low_texel_density", ".3f"), ("flips", "flips", ".0f"),
           ("overlapping", "overlapping", ".0f"), ("shared texels", "shared_texels", ".0f"), ("seconds", "seconds", "seconds"),
           ("pack / charts", "packing_share", ".2f")]
# The columns of the table of another program, after the name of the model
OTHER = ["charts", "covered", "texel_density", "low_texel_density", "seam", "cpu", "overlapping"]


def geometric_mean(numbers: list[float]) -> float:
    return math.exp(sum(map(math.log, numbers)) / len(numbers)) if numbers else math.nan


def figures_of_other(file: Path) -> dict[str, dict[str, float]]:
    """Of each model, from the rows of a table in Markdown"""
    result = {}
    for line in file.read_text(encoding="utf-8").splitlines():
        name, *cells = (cell.strip() for cell in line.strip("| ").split("|"))
        if len(cells) == len(OTHER) and cells[0].isdigit():
            result[name] = dict(zip(OTHER, map(float, cells)))
    return result


def measure_all(options: argparse.Namespace) -> tuple[str, dict[str, run.Measurement]]:
    program, rows, textures = run.measure_of(options), Table(["model", "triangles", "for"], COLUMNS, 3), {}
    files = [options.demo / f"{name}.off" for name in options.models] if options.demo else [run.EXAMPLES / "egg.off"]
    for file in files:
        for purpose in PURPOSES:
            m = program.one("atlas", file, "--check", "--for", purpose, threads=options.threads)
            if "failure" not in m:
                m["packing_share"] = m["pack"] / m["chart_seconds"]
                if purpose == "texture":
                    textures[file.stem] = m
            rows.add([file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else "", purpose], m)
    return str(rows), textures


def comparison(textures: dict[str, run.Measurement], other: dict[str, dict[str, float]]) -> str:
    names = [name for name in textures if name in other]
    ratios = {key: [textures[name][key] / other[name][key] for name in names] for key in ("texel_density", "low_texel_density", "seam")}
    rows = [[name, *(f"{ratios[key][i]:.2f}" for key in ratios)] for i, name in enumerate(names)]
    rows.append(["geometric mean", *(f"{geometric_mean(values):.3f}" for values in ratios.values())])
    targets = Targets()
    targets.add("density", ".3f", geometric_mean(ratios["texel_density"]), least=1.15)
    targets.add("density of 95 % of the surface", ".3f", geometric_mean(ratios["low_texel_density"]), least=1.05)
    targets.add("models with less density", ".0f", sum(ratio <= 1 for ratio in ratios["texel_density"]), most=1)
    targets.add("seam", ".3f", geometric_mean(ratios["seam"]), most=0.35)
    return f"\n## Textures, relative to the other program\n\n{table(['model', 'density', 'of 95 %', 'seam'], rows)}\n{targets}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo; without it, a mesh of the examples is taken")
    parser.add_argument("--models", type=lambda text: text.split(","), default=MODELS, metavar="NAME,NAME,...", help="of the demo (" + ",".join(MODELS) + ")")
    parser.add_argument("--other", type=Path, metavar="FILE.md", help="a table of figures of another program: model, charts, covered share, density, density "
                        "of 95 %%, seam, CPU seconds, overlapping faces")
    parser.add_argument("--threads", type=int, default=1, metavar="N", help="of each run (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    report = Report(options.output)
    report.add(head("Atlases for textures", run.measure_of(options)) + "Density: of texels on the surface, as a harmonic mean, and the density that 95 % of the "
               "surface have at least, each face in its worst direction; 1 is an isometric map that fills the square, at 1024 by 1024 texels. Seam: length in units "
               "of the square root of the area. *Flips* and *overlapping* count faces by exact predicates; *shared texels* counts those that two charts touch.\n\n")
    text, textures = measure_all(options)
    report.add(text)
    if options.other:
        report.add(comparison(textures, figures_of_other(options.other)))


if __name__ == "__main__":
    main()
