"""Tests that travel with the package: ``python -m angle_based_flattening.check``. The exit status is 1 if one fails."""

from __future__ import annotations

import contextlib
import platform
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import angle_based_flattening as abf

from . import _core

Mesh = tuple[NDArray[np.float64], NDArray[np.int64]]


def _torus(n: int = 60, m: int = 40) -> Mesh:
    """A bumpy torus of 2 n m triangles."""
    i, j = (each.ravel() for each in np.meshgrid(np.arange(n), np.arange(m)))
    u, v = 2 * np.pi * i / n, 2 * np.pi * j / m
    r = 1 + .2 * np.sin(5 * u) * np.cos(3 * v)
    a, b, c, d = (((j + y) % m) * n + (i + x) % n for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
    vertices = np.column_stack([(3 + r * np.cos(v)) * np.cos(u), (3 + r * np.cos(v)) * np.sin(u), r * np.sin(v)])
    return vertices, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def _expect(is_right: Any, what: str) -> None:
    if not is_right:
        raise AssertionError(what)


def check_atlas() -> None:
    """An atlas of a closed surface with a handle."""
    vertices, faces = _torus()
    atlas = abf.atlas(vertices, faces)
    assert isinstance(atlas, abf.Atlas)
    _expect(atlas.uv.shape == (3 * len(faces), 2) and not np.isnan(atlas.uv).any(), "faces without coordinates")
    _expect(atlas.uv.min() >= 0 and atlas.uv.max() <= 1, "coordinates outside of the page")
    _expect((atlas.face_chart >= 0).all() and atlas.report["atlas"]["injective"], "the report says that it is wrong")
    _expect(abf.certify(vertices, faces, atlas.uv), "the atlas is not injective")
    vmapping, indices, uvs = atlas.unshared()
    _expect(np.array_equal(vmapping[indices], faces) and np.abs(uvs[indices].reshape(-1, 2) - atlas.uv).max() < 1e-6,
            "unshared() is not the same atlas")


def check_flatten() -> None:
    """A disk, and a map that is not injective."""
    vertices, faces = _torus()
    disk = faces[(faces[:, 0] < 600) & (faces.max(axis=1) < 600) & (np.ptp(faces % 60, axis=1) < 30)]
    flattening = abf.flatten(vertices, disk)
    _expect(abf.certify(vertices, disk, flattening.uv), "the map is not injective")
    _expect(abf.measure(vertices, disk, flattening.uv)["mean_angle_change"] < .05, "angles have changed much")
    mirrored = abf.certify(vertices, disk, flattening.uv * [-1, 1])
    _expect(not mirrored and len(mirrored.flipped) == len(disk), "flipped triangles are not found")


def check_errors() -> None:
    """Wrong input has errors of the types that are documented."""
    vertices, faces = _torus(12, 8)
    calls: list[tuple[type[Exception], Callable[[], Any]]] = [
        (ValueError, lambda: abf.atlas(vertices[:, :2], faces)), (ValueError, lambda: abf.atlas(vertices, faces + 1)),
        (ValueError, lambda: abf.atlas(vertices, faces, resolution=0)),
        (TypeError, lambda: abf.atlas(vertices, faces, resolutoin=1)),
        (abf.MeshError, lambda: abf.flatten(vertices, faces)), (abf.MeshError, lambda: abf.atlas(vertices, faces[:0])),
        (TypeError, lambda: abf.unwrap(0))]
    for kind, call in calls:
        with contextlib.suppress(kind):
            call()
            raise AssertionError(f"no {kind.__name__} of wrong input")


def check_program() -> None:
    """The program writes and reads files."""
    if not hasattr(_core, "run_program"):
        return print("  without the program")
    vertices, faces = _torus(12, 8)
    with tempfile.TemporaryDirectory() as name:
        files = [Path(name) / file for file in ("given.obj", "made.obj", "again.glb", "last.obj")]
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
        files[0].write_text("\n".join(lines) + "\n")
        for source, result in zip(files, files[1:]):
            status = _core.run_program([str(source), "--output", str(result), "--quiet"])
            _expect(status == 0 and result.exists(), f"{source.suffix} to {result.suffix}: exit status {status}")
        for result in files[1], files[3]:
            text = result.read_text()
            _expect("\nvt " in text and text.count("\nf ") == len(faces), f"{result.name} has no coordinates")
        _expect(files[2].read_bytes()[:4] == b"glTF", "the GLB file is none")


def main() -> int:
    """Runs all checks."""
    print(f"angle_based_flattening {abf.__version__}, Python {platform.python_version()}, numpy {np.__version__}, "
          f"{platform.system()} {platform.machine()}")
    start = time.perf_counter()
    for check in check_atlas, check_flatten, check_errors, check_program:
        begin = time.perf_counter()
        try:
            check()
        except Exception as error:  # whatever it is, it has to be told
            print(f"{check.__name__} failed: {type(error).__name__}: {error}", file=sys.stderr)
            return 1
        print(f"{check.__name__}: {time.perf_counter() - begin:.2f} s")
    with contextlib.suppress(ImportError):  # not on Windows
        import resource
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (2**20 if sys.platform == "darwin" else 2**10)
        print(f"peak memory: {peak:.0f} MB")
    print(f"all checks passed in {time.perf_counter() - start:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
