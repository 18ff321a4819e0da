"""Pictures of atlases: in notebooks, and by matplotlib where that is installed."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._atlas import Atlas

_MOST_FACES = 2000  # of which each is drawn in notebooks
_MOST_POINTS = 20000  # of borders of charts: some 200 kB


def _firsts(atlas: Atlas) -> NDArray[Any]:
    """The first corner of each face, and the end."""
    return np.arange(0, len(atlas.uv) + 1, 3) if atlas._offsets is None else atlas._offsets


def _polygons(atlas: Atlas) -> list[NDArray[np.float64]]:
    """The faces in the plane that have a chart."""
    firsts = _firsts(atlas)
    return [atlas.uv[firsts[i]:firsts[i + 1]] for i in np.flatnonzero(atlas.face_chart >= 0)]


def _color(chart: int) -> str:
    """Neighbours have hues far from each other."""
    return f"hsl({chart * 137.508 % 360:.0f} 55% {70 - chart % 3 * 8}%)"


def summary(atlas: Atlas) -> str:
    """A line on an atlas."""
    told = atlas.report["atlas"]
    charts = np.unique(atlas.face_chart[atlas.face_chart >= 0])
    words = [f"{len(atlas.face_chart)} faces", f"{len(charts)} chart{'s' * (len(charts) != 1)}"]
    if packing := told.get("packing"):
        words += [f"{packing['pages']} pages"] * (packing["pages"] > 1)
        words.append(f"{packing['covered_share']:.0%} covered")
    words.append("injective" if told["injective"] else "not injective")
    left = int((atlas.face_chart < 0).sum())
    return ", ".join(words + [f"{left} without chart"] * (left > 0))


def _size(atlas: Atlas) -> NDArray[np.float64]:
    """How far coordinates go: whole pages, if charts are packed."""
    most: NDArray[np.float64] = np.nanmax(atlas.uv, axis=0, initial=0)
    return np.maximum(np.ceil(most - 1e-9), 1) if atlas.report["atlas"].get("packing") else most


def _loops(atlas: Atlas) -> dict[int, list[NDArray[np.float64]]]:
    """The borders of each chart, closed."""
    firsts = _firsts(atlas)
    uv = np.where(np.isnan(atlas.uv), 0, atlas.uv)
    _, ids, _ = _core.unshared(atlas._indices, uv)
    starts = np.asarray(ids, np.int64).reshape(-1)
    following = np.arange(1, len(starts) + 1)
    following[firsts[1:] - 1] = firsts[:-1]
    ends = starts[following]
    charts = np.repeat(atlas.face_chart, np.diff(firsts))
    count = int(starts.max()) + 1
    keys = np.minimum(starts, ends) * count + np.maximum(starts, ends)
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    is_border = (counts[inverse] == 1) & (charts >= 0)
    places = np.zeros((count, 2))
    places[starts] = uv
    found: dict[int, list[NDArray[np.float64]]] = {}
    onward: dict[int, list[tuple[int, int]]] = {}
    for a, b, chart in zip(starts[is_border].tolist(), ends[is_border].tolist(), charts[is_border].tolist()):
        onward.setdefault(a, []).append((b, chart))
    for start in list(onward):
        while onward.get(start):
            v, chart = onward[start].pop()
            loop = [start]
            while v != start and onward.get(v):
                loop.append(v)
                v, chart = onward[v].pop()
            found.setdefault(chart, []).append(places[loop])
    return found


def _path(points: NDArray[np.float64], scale: float, height: float) -> str:
    """In pixels of a tenth; those at the same place are one."""
    pixels = np.round(np.column_stack([points[:, 0], height - points[:, 1]]) * scale, 1)
    is_new = np.r_[True, (np.diff(pixels, axis=0) != 0).any(axis=1)]
    return "M" + "L".join(f"{x:g} {y:g}" for x, y in pixels[is_new].tolist()) + "Z"


def as_html(atlas: Atlas) -> str:
    """A picture of the page, and a line below it."""
    width, height = _size(atlas).tolist()
    scale = 400 / max(width, height, 1e-300)
    loops = _loops(atlas)
    points = sum(len(loop) for of_chart in loops.values() for loop in of_chart)
    step = max(1, -(-points // _MOST_POINTS))
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * scale:.0f}" height="{height * scale:.0f}" '
             'style="background:#fff;border:1px solid #888" stroke-linejoin="round">']
    for chart, of_chart in sorted(loops.items()):
        path = "".join(_path(loop[::step if len(loop) > 3 * step else 1], scale, height) for loop in of_chart)
        lines.append(f'<path d="{path}" fill="{_color(chart)}" fill-rule="evenodd" stroke="#000" stroke-width=".6"/>')
    if len(atlas.face_chart) <= _MOST_FACES:
        path = "".join(_path(polygon, scale, height) for polygon in _polygons(atlas))
        lines.append(f'<path d="{path}" fill="none" stroke="#000" stroke-width=".2"/>')
    return "\n".join(["<div>", *lines, "</svg>", f"<div>{html.escape(summary(atlas))}</div>", "</div>"])


def show(atlas: Atlas, axes: Any) -> Any:
    """Draws the page with matplotlib."""
    try:
        import matplotlib.pyplot as plt
        from matplotlib.collections import PolyCollection
    except ImportError as error:
        raise ImportError("Atlas.show() needs matplotlib: pip install matplotlib") from error
    if axes is None:
        axes = plt.subplots(layout="constrained")[1]
    colors = plt.get_cmap("tab20")(atlas.face_chart[atlas.face_chart >= 0] % 20)
    width = .1 if len(colors) < 20000 else 0
    axes.add_collection(PolyCollection(_polygons(atlas), facecolors=colors, edgecolors="black" if width else "face",
                                       linewidths=width))
    size = _size(atlas)
    axes.set(xlim=(0, size[0]), ylim=(0, size[1]), aspect="equal", title=summary(atlas), xlabel="u", ylabel="v")
    return axes
