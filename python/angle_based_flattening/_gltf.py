"""Scenes of pygltflib, by way of files: the program knows all of glTF that an atlas has to keep."""

from __future__ import annotations

import base64
import copy
import json
import mimetypes
import os
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from ._errors import MeshError

_WORDS = {"purpose": "for", "number_of_rotations": "rotations", "quantization_bits": "quantize",
          "separate_overlaps": "separate", "isometric_charts": "isometric", "equal_seam_lengths": "equal-seams"}
_SAME = ("seams", "weld", "repair", "timeout", "stretch_bound", "resolution", "gutter", "block", "texels_per_unit",
         "area_weight", "seam_price", "threads")


def arguments(options: dict[str, Any]) -> list[str]:
    """Options of `atlas()` as arguments of the program."""
    options = {name: value for name, value in options.items() if value is not None}
    words: list[str] = []
    if "height" in options:
        options["resolution"] = f"{options.get('resolution', 1024)}x{options.pop('height')}"
    charts = options.pop("given_charts", "replace")
    if charts not in ("replace", "keep", "repair"):
        raise ValueError(f"given_charts is {charts!r}, and must be one of 'replace', 'keep', 'repair'")
    words += {"replace": [], "keep": ["--repack"], "repair": ["--repack", "--repair-charts"]}[charts]
    words += ["--symmetric"] if options.pop("symmetric", False) else []
    words += [] if options.pop("pack_into_square", True) else ["--no-pack"]
    for name, value in options.items():
        if name not in _WORDS and name not in _SAME:
            raise ValueError(f"{name} is given, and does not go with glTF: the program makes the atlas")
        text = ("on" if value else "off") if isinstance(value, bool) else str(value)
        words.append(f"--{_WORDS.get(name, name.replace('_', '-'))}={text}")
    return words


def _uri(data: bytes, kind: str) -> str:
    return f"data:{kind};base64,{base64.b64encode(data).decode()}"


def unwrap(scene: Any, options: dict[str, Any]) -> Any:
    """A new ``pygltflib.GLTF2`` with an atlas of all its meshes, and with what was in files beside the given one."""
    import pygltflib

    words = arguments(options)
    scene = copy.deepcopy(scene)
    folder = Path(getattr(scene, "_path", None) or ".")
    for buffer in scene.buffers:
        data = scene.get_data_from_buffer_uri(buffer.uri)  # of the file itself, if there is no URI
        buffer.uri = _uri(bytes(data)[:buffer.byteLength], "application/octet-stream")
    for image in scene.images:
        if image.uri and not image.uri.startswith("data:"):  # which is not beside the copy
            kind = image.mimeType or mimetypes.guess_type(image.uri)[0] or "image/png"
            image.uri = _uri((folder / unquote(image.uri)).read_bytes(), kind)
    with tempfile.TemporaryDirectory() as name:
        given, made, told = (Path(name) / file for file in ("in.gltf", "out.glb", "out.json"))
        given.write_text(scene.to_json(), encoding="utf-8")
        # In a process of its own, for the program has handlers of signals.
        status = subprocess.run([sys.executable, "-m", __package__, given, "--output", made, "--json", told, "--quiet",
                                 *words], env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}).returncode
        report = json.loads(told.read_text()) if told.exists() else {"status": "FAILED", "message": f"exit status {status}"}
        if not made.exists():
            if report["status"] == "WRONG_USAGE":
                raise ValueError(report["message"])
            if report["status"] == "TIMED_OUT":
                raise TimeoutError("the computation took longer than the timeout")
            raise MeshError(report["status"], report["message"])
        if report.get("skipped"):
            warnings.warn(f"{len(report['skipped'])} parts have no chart: {report['skipped']}", stacklevel=3)
        return pygltflib.GLTF2().load(made)
