# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The results of `compare` in tables like those of the paper, ratios, and growth."""

import numpy as np
import pandas as pd

from report import DASH, cell, table

METHODS = {
    "abf++": "ABF++", "habf++": "hierarchical ABF++", "abf": "ABF (2001)", "paper-abf++": "ABF++ to the letter (2005)",
    "log-abf": "ABF in logarithms (Zayer et al. 2005)", "linear-abf": "linear ABF (2007)", "mips": "MIPS",
    "stretch": "stretch minimization", "hlscm": "hierarchical LSCM", "lscm": "LSCM (CGAL)", "arap": "ARAP (CGAL)",
    "conformal": "discrete conformal map, on a circle (CGAL)",
    "mean-value": "mean value coordinates, on a circle (CGAL)", "authalic": "iterative authalic, on a circle (CGAL)"}
NUMBERS = ["runs", "seconds", "bytes", "shear", "principal_shear", "equal_stretch_error", "stretch",
           "linf_stretch", "energy", "angle_change", "corner_angle_change", "quasi_conformal", "area",
           "symmetric_dirichlet", "flips", "border_is_simple"]
TABLE_1, TABLE_2 = 60000, 300000  # up to which the paper's tables go, roughly


class Results:
    """A row for each mesh and method, in the order in which they were measured. Meshes have numbers,
    small ones first, as some have the same name."""

    def __init__(self, rows: list[dict]) -> None:
        self.rows = pd.DataFrame(rows, columns=["number", "mesh", "faces", "resized", "method",
                                                *NUMBERS, "failure"])
        self.rows[NUMBERS] = self.rows[NUMBERS].astype(float)
        self.methods = list(dict.fromkeys(self.rows["method"]))
        self.meshes = self.rows.groupby("number")[["mesh", "faces", "resized"]].first()

    def wide(self, name: str, curved: bool = False) -> pd.DataFrame:
        """A number, with a row for each mesh and a column for each method. Curved: without meshes on
        which some method leaves but rounding errors of the angles, whose quotients say nothing."""
        wide = self.rows.pivot(index="number", columns="method", values=name).reindex(columns=list(METHODS))
        return wide[~(self.wide("energy") < 1e-8).any(axis=1)] if curved else wide

    def quotients(self, name: str, left: str, right: str, least_faces: int = 0) -> pd.Series:
        """Of each mesh where both were measured"""
        wide = self.wide(name, curved=True)[lambda w: self.meshes["faces"][w.index] >= least_faces]
        return (wide[left] / wide[right]).dropna()

    def mesh_titles(self) -> pd.Series:
        """With their sizes"""
        sizes = self.meshes["faces"].map(lambda n: f"{(n + 500) // 1000}K" if n >= 1000 else str(n))
        return self.meshes["mesh"] + " (" + sizes + ")"

    def csv(self) -> str:
        """What was not measured is empty."""
        return self.rows.to_csv(columns=["mesh", "faces", "method", *NUMBERS, "failure"], index=False,
                                float_format="%.9g")


def finite(numbers: pd.Series) -> pd.Series:
    """Of which there is a geometric mean"""
    return numbers[np.isfinite(numbers) & (numbers > 0)]


def geometric_mean(numbers: pd.Series) -> float:
    """NaN of none"""
    return float(np.exp(np.log(finite(numbers)).mean()))


def times_table(results: Results) -> str:
    """Run times: a row for each method, a column for each mesh"""
    wide = results.wide("seconds")[results.meshes["faces"] <= TABLE_1]
    return table(["method", *results.mesh_titles()[wide.index]],
                 [[METHODS[method], *(cell(number, "seconds") for number in wide[method])]
                  for method in results.methods])


def distortions_table(results: Results, least: int, most: float) -> str:
    """Run time, distortion, flips and memory: a row for each mesh and method"""
    titles = ["mesh", "faces", "method", "seconds", "shear", "principal shear", "stretch",
              "energy", "flips", "memory, MB", "note"]
    rows = []
    for m in results.rows[results.rows["faces"].between(least + 1, most)].itertuples():
        expected = m.failure == "not tried" or m.failure.startswith("stopped")
        note = m.failure if expected else f"FAILED: {m.failure}"
        if not m.failure:
            note = "" if m.border_is_simple else "the border crosses itself"
        rows.append([m.mesh, str(m.faces), METHODS[m.method], cell(m.seconds, "seconds"), cell(m.shear),
                     cell(m.principal_shear), cell(m.stretch, ".5g"), cell(m.energy, ".3e"),
                     cell(m.flips, ".0f"), cell(m.bytes / 1e6, ".1f"), note])
    return table(titles, rows, 3) if rows else "There was no such mesh.\n"


def ratios_table(results: Results, reference: str) -> str:
    """Geometric means over the meshes that both methods could do, where both numbers are finite"""
    rows = []
    for method in results.methods:
        ratios = {name: finite(results.quotients(name, method, reference))
                  for name in ("seconds", "bytes", "principal_shear", "stretch", "energy")}
        mean = {name: cell(geometric_mean(ratio), ".3g") for name, ratio in ratios.items()}
        rows.append([METHODS[method], str(len(ratios["seconds"])), mean["seconds"], mean["bytes"],
                     mean["principal_shear"], mean["stretch"], str(len(ratios["stretch"])),
                     mean["energy"]])
    return table(["method", "meshes", "time", "memory", "principal shear", "stretch", "of meshes",
                  "energy"], rows)


def growth(results: Results, method: str) -> tuple[int, np.poly1d | None]:
    """On how many sizes of one surface it ran, and the line of least squares of the logarithms of
    seconds over those of faces, if they were at least three"""
    times = results.wide("seconds")[method][results.meshes["resized"]].dropna()
    if len(times) < 3:
        return len(times), None
    faces = results.meshes["faces"][times.index].astype(float)
    return len(times), np.poly1d(np.polyfit(np.log(faces), np.log(times), 1))


def growth_table(results: Results) -> str:
    """Of the time of each method"""
    rows = []
    for method in results.methods:
        sizes, line = growth(results, method)
        fitted = [cell(line[1], ".2f"), cell(np.exp(line(np.log(1e5))), "seconds")] if line else [DASH, DASH]
        rows.append([METHODS[method], str(sizes), *fitted])
    return table(["method", "sizes", "exponent", "seconds at 100,000 faces"], rows)
