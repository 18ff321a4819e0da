# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests in this folder share. The helpers of the folder above are found from here."""

import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import meshes  # noqa: E402


@pytest.fixture
def torus():
    vertices, faces = meshes.torus(24, 16)
    colors = np.random.default_rng(1).integers(0, 255, (len(vertices), 4)).astype(np.uint8)
    return SimpleNamespace(vertices=vertices, faces=faces, colors=colors)
