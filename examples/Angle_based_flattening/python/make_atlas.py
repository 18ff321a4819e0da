# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an atlas of an OFF or OBJ file, and draws it: make_atlas.py [FILE [FILE.obj [FILE.png]]]"""

import sys
from pathlib import Path

import angle_based_flattening as abf
import matplotlib
import numpy as np
from mesh_files import read, write_obj

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

data = Path(__file__).resolve().parents[1] / "data"
file, output, picture = (sys.argv[1:] + [data / "egg.off", "atlas.obj", "atlas.png"][len(sys.argv) - 1:])[:3]
vertices, faces = read(file)
atlas = abf.atlas(vertices, faces)
write_obj(output, vertices, faces, atlas.uv)

colors = plt.cm.tab20(atlas.face_chart % 20)
figure = plt.figure(figsize=(10, 5), layout="constrained")
space = figure.add_subplot(1, 2, 1, projection="3d", proj_type="ortho")
space.add_collection3d(Poly3DCollection(vertices[faces], facecolors=colors, edgecolors="black", linewidths=.1))
space.auto_scale_xyz(*vertices.T)
space.set_box_aspect(np.ptp(vertices, axis=0))
space.set_axis_off()
plane = figure.add_subplot(1, 2, 2, aspect="equal")
plane.add_collection(PolyCollection(atlas.uv.reshape(-1, 3, 2), facecolors=colors, edgecolors="black", linewidths=.1))
plane.set(xlim=(0, 1), ylim=(0, 1))
figure.savefig(picture, dpi=120)
covered = atlas.report["atlas"]["packing"]["covered_share"]
print(f"{len(faces)} faces, {atlas.face_chart.max() + 1} charts, {covered:.0%} of the square covered")
