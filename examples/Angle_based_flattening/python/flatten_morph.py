# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens a surface while it changes its shape. Calls after the first one reuse what depends on the faces only."""

import time
from pathlib import Path

import angle_based_flattening as abf
import numpy as np
from mesh_files import read

vertices, faces = read(Path(__file__).resolve().parents[1] / "data" / "mask.off")
flattener = abf.Flattener(faces, holes="fill", warm_start=True)
height = vertices[:, 2] - vertices[:, 2].mean()
for step in range(6):
    moved = vertices + np.outer(height, [0, 0, -.1 * step])
    begin = time.perf_counter()
    flattening = flattener.solve(moved)
    milliseconds = 1e3 * (time.perf_counter() - begin)
    change = abf.measure(moved, faces, flattening.uv)["mean_angle_change"]
    print(f"height {1 - .1 * step:.1f}: angles change by {np.degrees(change):.3f} degrees ({milliseconds:.0f} ms)")
