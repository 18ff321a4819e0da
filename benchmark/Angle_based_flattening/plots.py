# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of `compare`."""

from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

from comparison import METHODS, Results, growth

matplotlib.use("svg")
COLOURS = ["#d62728", "#ff9896", "#1f77b4", "#17becf", "#9467bd", "#e377c2", "#8c564b", "#bcbd22",
           "#2ca02c", "#98df8a", "#7f7f7f", "#ff7f0e", "#393b79", "#c49c94"]
STYLES = {method: {"color": colour, "marker": marker}
          for method, colour, marker in zip(METHODS, COLOURS, "os^vDP*X<>pdh8")}


def draw_times(results: Results, file: Path) -> None:
    """Points of all meshes, and the fitted line of the resized ones"""
    figure, axes = plt.subplots(figsize=(9, 9), layout="constrained")
    faces, wide = results.meshes["faces"], results.wide("seconds")
    for method in results.methods:
        _, line = growth(results, method)
        label = METHODS[method] + (f", $n^{{{line[1]:.2f}}}$" if line else "")
        axes.loglog(faces, wide[method], linestyle="", label=label, **STYLES[method])
        if line:
            ends = np.array([faces.min(), faces.max()], dtype=float)
            axes.loglog(ends, np.exp(line(np.log(ends))), color=STYLES[method]["color"], linewidth=0.8)
    axes.set(xlabel="faces", ylabel="seconds")
    axes.grid(alpha=0.4)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), ncols=3, fontsize="small")
    figure.savefig(file)


def draw_distortions(results: Results, file: Path) -> None:
    """One diagram for each measure, the meshes beside each other. The excess of stretch is over the best
    value, which is 1."""
    figure, all_axes = plt.subplots(3, 1, figsize=(12, 13.5), sharex=True, layout="constrained")
    measures = {"energy": "energy", "principal_shear": "principal shear",
                "stretch": "L2 stretch - 1"}
    for axes, (name, title) in zip(all_axes, measures.items()):
        wide = results.wide(name, curved=True).reset_index(drop=True) - (name == "stretch")
        wide = wide.where(np.isfinite(wide) & (wide > 0))
        for method in results.methods:
            axes.semilogy(wide.index, wide[method], linewidth=0.5, label=METHODS[method],
                          **STYLES[method])
        axes.set(ylabel=title)
        axes.grid(alpha=0.4)
    titles = results.mesh_titles()[results.wide("energy", curved=True).index]
    all_axes[-1].set_xticks(range(len(titles)), titles, rotation=40, ha="right")
    all_axes[0].legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize="small")
    figure.savefig(file)


def draw(results: Results, folder: Path) -> str:
    """Returns what the report says of it."""
    draw_times(results, folder / "time.svg")
    draw_distortions(results, folder / "distortion.svg")
    return "".join(f"![{name}]({folder.name}/{name})\n" for name in ("time.svg", "distortion.svg"))
