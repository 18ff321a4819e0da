#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that each internal folder includes only folders below it in the manual's table (mathematics.txt)"""

import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
packages = [f"CGAL/{name}/" for name in (
    "Texture_atlas/internal", "Surface_mesh_parameterization/internal/angle_based_flattening")]
page = (root / "doc/Angle_based_flattening/mathematics.txt").read_text(encoding="utf-8")
layers = re.findall(r"^<tr><td>`(\w+)/`</td>", page, re.MULTILINE)
faults = []
folders = {path.name for package in packages for path in (root / "include" / package).iterdir() if path.is_dir()}
if folders != set(layers):
    faults.append(f"only in the table or only a folder: {sorted(folders ^ set(layers))}")
number = 0
for header in sorted(path for package in packages for path in (root / "include" / package).rglob("*/*.h")):
    text = header.read_text(encoding="utf-8")
    for folder, name in re.findall(rf"#include <(?:{'|'.join(packages)})(\w+)/(\w+\.h)>", text):
        number += 1
        if folder in layers and layers.index(folder) < layers.index(header.parent.name):
            faults.append(f"{header.parent.name}/{header.name} includes {folder}/{name}, which is above it")
for header in sorted((root / "include/CGAL/Surface_mesh_parameterization").rglob("*.h")):
    if "CGAL/Texture_atlas/" in header.read_text(encoding="utf-8"):
        faults.append(f"{header.name} includes a header of the atlas package, which is above it")
print(*faults, f"{number} includes, {len(faults)} faults", sep="\n")
sys.exit(bool(faults) or number == 0)
