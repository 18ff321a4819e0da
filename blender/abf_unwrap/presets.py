# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What maps are commonly made for, with the values of the options. Nothing here needs Blender."""

from __future__ import annotations

from typing import Any

# Tiles of films have 4096 texels as a rule. The blocks of a light map are those of compressed textures.
PRESETS: dict[str, tuple[str, str, dict[str, Any]]] = {
    "GAME": (
        "Game asset",
        "One texture of 2048 texels, a margin of 8, and seams where few directions see them",
        {"purpose": "texture", "seams": "hidden", "resolution": 2048, "gutter": 8},
    ),
    "LIGHT_MAP": (
        "Light map",
        "One texture of 512 texels in a new UV layer; no two islands share a block of 4 x 4 texels",
        {"purpose": "texture", "resolution": 512, "gutter": 4, "block": 4, "uv_layer": "NEW"},
    ),
    "FILM": (
        "Film (UDIM)",
        "Tiles of 4096 texels, as many as 1024 texels per metre take, with little stretch",
        {
            "purpose": "texture",
            "resolution": 4096,
            "gutter": 16,
            "pack_into": "TILES",
            "density": 1024.0,
            "stretch_bound": 1.05,
        },
    ),
}
