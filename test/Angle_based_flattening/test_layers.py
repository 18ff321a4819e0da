#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that each internal folder includes only folders below it in the manual's table (mathematics.txt). Usage:
test_layers.py ROOT"""

import re
import sys
from pathlib import Path

root = Path(sys.argv[1])
internal = "CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/"
page = (root / "doc/Angle_based_flattening/mathematics.txt").read_text(encoding="utf-8")
layers = re.findall(r"^<tr><td>`(\w+)/`</td>", page, re.MULTILINE)
faults = []
folders = {folder.name for folder in (root / "include" / internal).iterdir()}
if folders != set(layers):
    faults.append(f"only in the table or only a folder: {sorted(folders ^ set(layers))}")
number = 0
for header in sorted((root / "include" / internal).rglob("*.h")):
    for folder, name in re.findall(rf"#include <{internal}(\w+)/(\w+\.h)>", header.read_text(encoding="utf-8")):
        number += 1
        if folder in layers and layers.index(folder) < layers.index(header.parent.name):
            faults.append(f"{header.parent.name}/{header.name} includes {folder}/{name}, which is above it")
print(*faults, f"{number} includes, {len(faults)} faults", sep="\n")
sys.exit(bool(faults) or number == 0)
