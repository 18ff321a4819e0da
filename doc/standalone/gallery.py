# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes atlases of the meshes in a list, draws them, and writes the manual's page with the figures of the program's
reports. `scripts/gallery` calls it."""

import argparse
import html
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

columns = {
    "charts": lambda r: f"{len(r['atlas']['charts'])}",
    "angle change": lambda r: f"{math.degrees(r['atlas']['mean_angle_change']):.2f}&deg;",
    "quasi-conformal ratio": lambda r: f"{r['atlas']['mean_quasi_conformal_ratio']:.3f}",
    "scale stretch": lambda r: f"{max(chart['scale_stretch'] for chart in r['atlas']['charts']):.2f}",
    "L2 stretch": lambda r: f"{r['atlas']['l2_stretch']:.2f}",
    "covered": lambda r: f"{100 * r['atlas']['packing']['covered_share']:.0f}&nbsp;%",
    "flips": lambda r: f"{r['atlas']['flipped_triangles']}",
    "overlaps": lambda r: "none" if r["atlas"]["injective"] else "some",
}

head = """/*!
\\page ABF_part_gallery Gallery
\\cgalAutoToc

These atlases were made by `flatten_mesh --for few-charts`, and drawn by `scripts/gallery`, which also wrote this page:
all figures are those of the program's reports. Left: the surface with a checkerboard of the plane, in a colour for each chart; seams are
dark lines, and the inside of a surface is grey. Right: the atlas in the unit square.

The meshes come with CGAL's demos (Debian's package `libcgal-demo`). They belong to their authors and are not part of this package.
"""

tail = """
Components, borders and handles are those of the surface after repairs. The columns of the tables:

- *angle change*: the mean change of the surface's own angles, weighted by area;
- *quasi-conformal ratio*: largest over smallest stretch within a triangle, the mean over the area; 1 is perfect;
- *scale stretch*: of the worst chart; the program asks for {bound:g} at most, and tells if that is missed by more than 3 %;
- *L2 stretch*: root mean square stretch of lengths from the plane to the surface, for equal areas; 1 is perfect;
- *covered*: the share of the square that charts cover;
- *overlaps*: whether triangles overlap within a chart or between charts, by exact predicates.

*/
"""


def picture_name(mesh):
    return f"{Path(mesh['file']).name.replace('.', '_')}.png"


def make_atlas(arguments, mesh, folder):
    """Returns the name of the atlas and the report."""
    atlas, report = folder / f"{mesh['file']}.obj", folder / f"{mesh['file']}.json"
    if not atlas.exists():
        run = subprocess.run([arguments.program, mesh["file"], "--for", "few-charts", "--quiet", "--output", atlas, "--json", report],
                             cwd=arguments.meshes, stderr=subprocess.PIPE, text=True)
        if not atlas.exists():
            sys.exit(f"{mesh['file']}: no atlas (exit status {run.returncode})\n{run.stderr}")
    return atlas, json.loads(report.read_text())


def draw(arguments, layout, picture, size, meshes, atlases):
    """Returns the topology of each surface."""
    words = [word for mesh, atlas in zip(meshes, atlases) for word in (atlas, mesh["eye"], mesh["up"])]
    run = subprocess.run([arguments.draw, layout, picture, str(size), *words], check=True, stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def count(number, noun):
    return f"{number}&nbsp;{noun}{'' if number == 1 else 's'}"


def surface_text(report):
    topology = report["topology"]
    return ", ".join([count(report["triangles"], "triangle"), count(report["components"], "component"),
                      count(topology["borders"], "border"), count(topology["handles"], "handle")])


def pictures_html(meshes, reports):
    """Two in a row, each with a caption"""
    cells = [f"<td width=\"50%\"><img src=\"{picture_name(mesh)}\" alt=\"{html.escape(mesh['file'])} and its atlas\"/><br>"
             f"`{mesh['file']}`: {mesh['text']}.<br>{surface_text(reports[mesh['file']])}</td>" for mesh in meshes]
    rows = ["\n".join(cells[i:i + 2]) for i in range(0, len(cells), 2)]
    return "<table>\n" + "\n".join(f"<tr>\n{row}\n</tr>" for row in rows) + "\n</table>\n"


def table(meshes, reports):
    lines = [["mesh", *columns]]
    lines += [[f"`{mesh['file']}`", *(column(reports[mesh["file"]]) for column in columns.values())] for mesh in meshes]
    marks = ["---"] + ["---:"] * len(columns)
    return "\n".join("| " + " | ".join(line) + " |" for line in [lines[0], marks, *lines[1:]]) + "\n"


def notes(meshes, reports):
    """What the program says about a mesh, and what it left out"""
    texts = []
    for mesh in meshes:
        report = reports[mesh["file"]]
        said = [note.removeprefix(f"'{mesh['file']}': ") for note in report["notes"]]
        said += [skipped["message"] for skipped in report["skipped"]]
        texts += [f"- `{mesh['file']}`: \"{html.escape(text, quote=False)}\"\n" for text in said]
    return "\nThe program's notes:\n\n" + "".join(texts) if texts else ""


def page(sections, reports):
    text = head
    for number, section in enumerate(sections):
        text += f"\n\\section ABF_gallery_{number} {section['title']}\n\n{section['text']}\n\n"
        text += pictures_html(section["meshes"], reports) + "\n" + table(section["meshes"], reports)
        text += notes(section["meshes"], reports)
    bound = next(iter(reports.values()))["atlas"]["seams"]["stretch_bound"]
    return text + tail.format(bound=bound)


def resolved(name):
    return Path(name).resolve() # the program runs in the folder of the meshes


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("list", type=Path, help="the meshes, in sections, and those of the row for README.md")
    parser.add_argument("--program", required=True, type=resolved, help="flatten_mesh")
    parser.add_argument("--draw", required=True, type=resolved, help="draw_atlases")
    parser.add_argument("--meshes", required=True, type=Path, help="the folder of the meshes")
    parser.add_argument("--doc", required=True, type=Path, help="the folder of the manual, for gallery.txt and fig")
    arguments = parser.parse_args()
    contents = json.loads(arguments.list.read_text())
    pictures = arguments.doc / "fig" / "gallery"
    pictures.mkdir(parents=True, exist_ok=True)
    reports = {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for mesh in (mesh for section in contents["sections"] for mesh in section["meshes"]):
            print(mesh["file"], flush=True)
            atlas, report = make_atlas(arguments, mesh, folder)
            report["topology"], = draw(arguments, "pair", pictures / picture_name(mesh), 300, [mesh], [atlas])
            reports[mesh["file"]] = report
        row = contents["row"]
        atlases = [make_atlas(arguments, mesh, folder)[0] for mesh in row]
        draw(arguments, "row", arguments.doc / "fig" / "readme.png", 1600 // len(row), row, atlases)
    (arguments.doc / "gallery.txt").write_text(page(contents["sections"], reports))


if __name__ == "__main__":
    main()
