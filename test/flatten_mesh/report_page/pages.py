# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces, and the pages that the program writes of them"""

import array
import base64
import json
import math
import re
import subprocess
import sys
from pathlib import Path


def boxy_surface(sides: int, rounded: bool) -> str:
    """An OBJ file: a cube or, if rounded, a sphere, with a material for each of six sides of squares"""
    lines, numbers = [], {}

    def vertex(place: tuple[float, ...]) -> int:
        if place not in numbers:
            numbers[place] = len(numbers) + 1
            length = math.hypot(*place) if rounded else 1
            lines.append("v " + " ".join(f"{x / length:.9f}" for x in place))
        return numbers[place]

    for axis in range(3):
        for side in (-1, 1):
            lines.append(f"usemtl side_{axis}_{side}")
            for i in range(sides):
                for k in range(sides):
                    corners = []
                    for x, y in ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1))[::side]:
                        place = [0.0] * 3
                        place[axis], place[axis - 2], place[axis - 1] = side, 2 * x / sides - 1, 2 * y / sides - 1
                        corners.append(vertex(tuple(place)))
                    lines.append("f " + " ".join(map(str, corners)))
    return "\n".join(lines) + "\n"


def write_report(program: str, surface: Path, page: Path, *options: str) -> None:
    """By the program"""
    subprocess.run([program, str(surface), "--report", str(page), "--quiet", *options], check=True)


class ReportData:
    """What is in a page, read from the file"""

    TYPES = {"wedge_points": "I", "triangles": "I", "charts": "i", "faces": "I", "borders": "I"}

    def __init__(self, page: Path):
        self.text = page.read_text(encoding="utf-8")
        self.report = json.loads(self.element("report"))

    def element(self, name: str) -> str:
        """The text of the element with this id"""
        found = re.search(rf'<script type="[a-z/]*" id="{name}">([^<]*)</script>', self.text)
        assert found, f"There is no {name}."
        return found[1]

    def numbers(self, name: str) -> array.array:
        """The numbers of an array"""
        numbers = array.array(self.TYPES.get(name, "f"), base64.b64decode(self.element("array-" + name)))
        if sys.byteorder == "big":
            numbers.byteswap()
        return numbers

    def middle_in_plane(self, triangle: int) -> tuple[float, float]:
        """Of its texture coordinates"""
        wedges, uv = self.numbers("triangles")[3 * triangle:3 * triangle + 3], self.numbers("wedge_uv")
        return sum(uv[2 * w] for w in wedges) / 3, sum(uv[2 * w + 1] for w in wedges) / 3

    def replaced(self, report: dict, arrays: dict[str, array.array]) -> str:
        """The page with other data"""
        text = self.text.replace(self.element("report"), json.dumps(report))
        for name, numbers in arrays.items():
            if sys.byteorder == "big":
                numbers.byteswap()
            coded = base64.b64encode(numbers.tobytes()).decode()
            old = self.element("array-" + name)
            before, after = text.split(f'id="array-{name}">{old}')
            text = f'{before}id="array-{name}">{coded}{after}'
        return text


def wavy_sheet(data: ReportData, size: int) -> str:
    """The page of a sheet of size times size squares, each of two triangles, whose data are made here"""
    points, uv, triangles = array.array("f"), array.array("f"), array.array("I")
    for i in range(size + 1):
        for k in range(size + 1):
            x, y = k / size, i / size
            points.extend((2 * x - 1, 2 * y - 1, 0.1 * math.sin(9 * x) * math.sin(7 * y)))
            uv.extend((x, y))
    for i in range(size):
        for k in range(size):
            a, b = i * (size + 1) + k, (i + 1) * (size + 1) + k
            triangles.extend((a, a + 1, b + 1, a, b + 1, b))
    count = 2 * size * size
    values = array.array("f", (k / count for k in range(count)))
    arrays = {"points": points, "wedge_points": array.array("I", range((size + 1) ** 2)), "wedge_uv": uv,
              "triangles": triangles, "charts": array.array("i", bytes(4 * count)),
              "faces": array.array("I", range(count)), "borders": array.array("I")}
    arrays.update({measure["name"]: values for measure in data.report["measures"]})
    report = json.loads(json.dumps(data.report))
    report.update(triangles=count, shown_triangles=count, box=[0, 0, 1, 1])
    for measure in report["measures"]:
        measure["worst"] = [{"triangle": count - 1, "face": count - 1, "value": 1}]
    return data.replaced(report, arrays)
