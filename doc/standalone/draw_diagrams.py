#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the diagrams of the manual as SVG: draw_diagrams.py RESULTS.md PICTURE_FOLDER."""

import math
import re
import sys
from pathlib import Path

INK, QUIET, LINE, SHADE, BLUE, RED, GREEN = (
    "#1d2733", "#5b6775", "#c3ccd5", "#eef3f7", "#14588a", "#b5542b", "#2b9a74")


class Svg:
    """Shapes in pixels; y grows downwards."""

    def __init__(self, width, height, title):
        self.lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'font-family="sans-serif" font-size="15" fill="{INK}">',
            f"<title>{title}</title>"]

    def polygon(self, points, fill=SHADE, stroke=INK, width=1.2):
        self.path("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + "Z", fill, stroke, width)

    def polyline(self, points, stroke=INK, width=1.2, dash=""):
        self.path("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points), "none", stroke, width, dash)

    def path(self, d, fill="none", stroke=INK, width=1.2, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.lines.append(f'<path fill="{fill}" stroke="{stroke}" stroke-width="{width}"{dashes} '
                          f'stroke-linejoin="round" d="{d}"/>')

    def ellipse(self, center, radii, turn=0., fill="none", stroke=INK, width=1.2):
        x, y = center
        self.lines.append(f'<ellipse cx="{x:.1f}" cy="{y:.1f}" rx="{radii[0]:.1f}" ry="{radii[1]:.1f}" '
                          f'transform="rotate({turn:.1f} {x:.1f} {y:.1f})" fill="{fill}" stroke="{stroke}" '
                          f'stroke-width="{width}"/>')

    def dot(self, center, fill=INK, radius=3.5):
        self.ellipse(center, (radius, radius), fill=fill, stroke="none")

    def text(self, at, words, anchor="middle", fill=INK, size=15):
        """What is in braces is an index."""
        words = re.sub("{(.*)}", r'<tspan dy="4" font-size="70%">\1</tspan>', words)
        self.lines.append(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" text-anchor="{anchor}" fill="{fill}" '
                          f'font-size="{size}">{words}</text>')

    def write(self, file):
        file.write_text("\n".join(self.lines + ["</svg>", ""]))
        print(file)


def toward(p, q, length):
    """The point at a distance from p on the way to q."""
    part = length / math.dist(p, q)
    return p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])


def angle(apex, p, q):
    """Between the directions from the apex to p and q."""
    u, v = [[b - a for a, b in zip(apex, end)] for end in (p, q)]
    return math.acos(sum(a * b for a, b in zip(u, v)) / (math.hypot(*u) * math.hypot(*v)))


def mark_corner(svg, apex, p, q, radius, color, width=2.4):
    a, b = toward(apex, p, radius), toward(apex, q, radius)
    turn = (a[0] - apex[0]) * (b[1] - apex[1]) - (a[1] - apex[1]) * (b[0] - apex[0])
    svg.path(f"M{a[0]:.1f} {a[1]:.1f}A{radius} {radius} 0 0 {int(turn > 0)} {b[0]:.1f} {b[1]:.1f}", stroke=color,
             width=width)


def label_corner(svg, apex, p, q, distance, words, color):
    middle = toward(apex, toward(p, q, math.dist(p, q) / 2), distance)
    svg.text((middle[0], middle[1] + 5), words, fill=color)


def wheel(folder):
    """The triangles around a vertex: as on the surface, where their angles leave a gap, and in the plane."""
    svg = Svg(760, 330, "The triangles around a vertex, on the surface and in the plane")
    ring = [(128, 8), (62, 118), (-72, 104), (-136, 4), (-60, -112), (70, -104)]
    height = 62.
    apex, around = (0., 0., height), [(x, -y, 0.) for x, y in ring]

    center = (180., 160.)
    direction, unrolled = math.radians(-20), []
    for k, p in enumerate(around + around[:1]):
        length = math.dist(apex, p)
        unrolled.append((center[0] + length * math.cos(direction), center[1] + length * math.sin(direction)))
        direction -= angle(apex, p, around[(k + 1) % len(around)])
    for p, q in zip(unrolled, unrolled[1:]):
        svg.polygon([center, p, q])
        mark_corner(svg, center, p, q, 26, BLUE)
    label_corner(svg, center, unrolled[1], unrolled[2], 48, "β{k}", BLUE)
    svg.dot(center)
    svg.text((center[0], 322), "surface, unrolled: a gap is left", fill=QUIET)

    center = (560., 160.)
    plane = [(center[0] + x, center[1] - y) for x, y in ring]
    for p, q in zip(plane, plane[1:] + plane[:1]):
        svg.polygon([center, p, q])
        mark_corner(svg, center, p, q, 26, BLUE)
        mark_corner(svg, p, q, center, 18, GREEN)
        mark_corner(svg, q, center, p, 18, RED)
    p, q = plane[1], plane[2]
    label_corner(svg, center, p, q, 48, "α{k}", BLUE)
    label_corner(svg, p, q, center, 38, "α{k⊕1}", GREEN)
    label_corner(svg, q, center, p, 38, "α{k⊖1}", RED)
    svg.dot(center)
    svg.text((center[0], 322), "plane: the angles fit together", fill=QUIET)
    svg.write(folder / "wheel.svg")


def distortion(folder):
    """A triangle and its image under a linear map, with a circle and the ellipse that it becomes."""
    svg = Svg(760, 280, "A circle in a triangle becomes an ellipse")
    center, radius = (170., 140.), 48.
    triangle = [(-130., 80.), (110., 80.), (20., -115.)]
    svg.polygon([(center[0] + x, center[1] + y) for x, y in triangle])
    svg.ellipse(center, (radius, radius), stroke=BLUE, width=2.4)
    svg.polyline([center, (center[0] + radius, center[1])], stroke=BLUE, width=1.6)
    svg.text((center[0] + radius / 2, center[1] - 8), "1", fill=BLUE)
    svg.text((center[0], 268), "on the surface", fill=QUIET)

    svg.polyline([(310., 140.), (378., 140.)], stroke=QUIET, width=2)
    svg.polyline([(368., 133.), (379., 140.), (368., 147.)], stroke=QUIET, width=2)

    image, turn, stretches = (585., 140.), math.radians(-14), (1.4, .75)

    def mapped(p):
        u = stretches[0] * (p[0] * math.cos(turn) + p[1] * math.sin(turn))
        v = stretches[1] * (-p[0] * math.sin(turn) + p[1] * math.cos(turn))
        return (image[0] + u * math.cos(turn) - v * math.sin(turn), image[1] + u * math.sin(turn) + v * math.cos(turn))

    svg.polygon([mapped(p) for p in triangle])
    svg.ellipse(image, [radius * s for s in stretches], math.degrees(turn), stroke=BLUE, width=2.4)
    for k, (name, color) in enumerate((("σ{1}", RED), ("σ{2}", GREEN))):
        along = turn + k * math.pi / 2
        end = mapped((radius * math.cos(along), radius * math.sin(along)))
        svg.polyline([image, end], stroke=color, width=2.4)
        side = toward(image, end, math.dist(image, end) / 2)
        svg.text((side[0] - 2 - 16 * k, side[1] - 8 + 14 * k), name, fill=color)
    svg.text((image[0], 268), "in the plane", fill=QUIET)
    svg.write(folder / "distortion.svg")


def fan(center, radius, first, last, parts):
    """The triangles of a fan, by angles in degrees."""
    rim = []
    for k in range(parts + 1):
        at = math.radians(first + (last - first) * k / parts)
        rim.append((center[0] + radius * math.cos(at), center[1] - radius * math.sin(at)))
    return [(center, p, q) for p, q in zip(rim, rim[1:])]


def defects(folder):
    """What is no disk, by the names of the diagnoses."""
    svg = Svg(900, 210, "Surfaces that are no disks")
    centers = [(90 + 180 * k, 85.) for k in range(5)]
    names = "NO_BORDER", "NONZERO_GENUS", "SEVERAL_BORDERS", "NON_MANIFOLD_VERTEX", "PARALLEL_EDGES"
    remedies = "cut it open", "cut it open", "solve, fill or cut", "divide the vertex", "split an edge"
    for center, name, remedy in zip(centers, names, remedies):
        svg.text((center[0], 178), name, size=12.5)
        svg.text((center[0], 198), remedy, fill=QUIET, size=13)

    x, y = centers[0]  # a sphere
    svg.ellipse((x, y), (58, 58), fill=SHADE)
    svg.path(f"M{x - 58} {y}A58 18 0 0 0 {x + 58} {y}", stroke=QUIET)
    svg.path(f"M{x - 58} {y}A58 18 0 0 1 {x + 58} {y}", stroke=LINE, dash="4 4")

    x, y = centers[1]  # a torus
    svg.ellipse((x, y), (74, 46), fill=SHADE)
    svg.path(f"M{x - 26} {y - 1}Q{x} {y - 18} {x + 26} {y - 1}Q{x} {y + 14} {x - 26} {y - 1}", fill="#ffffff", stroke="none")
    svg.path(f"M{x - 26} {y - 1}Q{x} {y - 18} {x + 26} {y - 1}")
    svg.path(f"M{x - 34} {y - 6}Q{x} {y + 20} {x + 34} {y - 6}")

    x, y = centers[2]  # a disk with two holes
    svg.ellipse((x, y), (70, 56), fill=SHADE)
    for hole in (x - 27, x + 27):
        svg.ellipse((hole, y), (15, 19), fill="#ffffff", stroke=RED, width=2)

    for triangle in fan(centers[3], 66, 35, 145, 3) + fan(centers[3], 66, 215, 325, 3):
        svg.polygon(triangle)
    svg.dot(centers[3], RED, 5)

    x, y = centers[4]  # two edges between the same vertices, and triangles between and around them
    svg.polygon([(x - 70, y), (x, y - 66), (x + 70, y), (x, y + 66)])
    svg.path(f"M{x - 70} {y}Q{x} {y - 38} {x + 70} {y}", stroke=RED, width=2.4)
    svg.path(f"M{x - 70} {y}Q{x} {y + 38} {x + 70} {y}", stroke=RED, width=2.4)
    svg.polyline([(x - 70, y), (x, y), (x + 70, y)], stroke=QUIET)
    svg.dot((x, y), QUIET)
    for end in ((x - 70, y), (x + 70, y)):
        svg.dot(end, RED, 5)
    svg.write(folder / "defects.svg")


def measured_times(results):
    """Seconds on one thread by method and number of triangles, from the benchmark of the hierarchical method."""
    table = results.read_text().split("\n## Hierarchical parameterization")[1].split("### Speed and memory")[1]
    times = {}
    for row in re.findall(r"^\| ([^|]+) \| 1 \| (\d+) \| ([\d.]+) \|", table.split("\n### ")[0], re.M):
        times.setdefault(row[0], []).append((int(row[1]), float(row[2])))
    if len(times) != 3 or any(len(rows) != 3 for rows in times.values()):
        sys.exit(f"{results} has no table of three methods on three surfaces")
    return times


def performance(results, folder):
    """Seconds against triangles, both logarithmic."""
    svg = Svg(760, 340, "Seconds by number of triangles")
    left, right, top, bottom = 70., 540., 20., 280.
    sizes, seconds = (8e4, 2e6), (.1, 100.)

    def place(size, time):
        return (left + (right - left) * math.log(size / sizes[0]) / math.log(sizes[1] / sizes[0]),
                bottom - (bottom - top) * math.log(time / seconds[0]) / math.log(seconds[1] / seconds[0]))

    for time in (.1, 1, 10, 100):
        y = place(sizes[0], time)[1]
        svg.polyline([(left, y), (right, y)], stroke=LINE)
        svg.text((left - 8, y + 5), f"{time:g} s", anchor="end", fill=QUIET, size=13)
    for size, name in ((1e5, "100 000"), (4e5, "400 000"), (16e5, "1.6 million")):
        x = place(size, .1)[0]
        svg.polyline([(x, top), (x, bottom)], stroke=LINE)
        svg.text((x, bottom + 20), name, fill=QUIET, size=13)
    svg.text(((left + right) / 2, bottom + 46), "triangles", fill=QUIET, size=13)
    names = {"CGAL's LSCM": ("LSCM", RED), "direct ABF++": ("ABF++", BLUE),
             "hierarchical ABF++": ("hierarchical ABF++", GREEN)}
    for method, rows in measured_times(results).items():
        name, color = names[method]
        points = [place(*row) for row in rows]
        svg.polyline(points, stroke=color, width=2.4)
        for point in points:
            svg.dot(point, color, 4)
        svg.text((points[-1][0] + 10, points[-1][1] + 5), f"{name}, {rows[-1][1]:.3g} s", anchor="start", fill=color)
    svg.write(folder / "performance.svg")


def main():
    results, folder = map(Path, sys.argv[1:])
    wheel(folder)
    distortion(folder)
    defects(folder)
    performance(results, folder)


if __name__ == "__main__":
    main()
