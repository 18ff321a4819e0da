"""The compiled part. It takes arrays that the other modules have checked."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__version__: str
OPTIONS: dict[str, list[tuple[str, str, str, str, str]]]  # name, kind, default, values, and what it does

class Watch:
    def __init__(self, progress: Callable[[str, float], Any] | None, timeout: float) -> None: ...

class GivenMesh:
    def __init__(
        self,
        vertices: NDArray[np.floating],
        offsets: NDArray[np.integer] | None,
        indices: NDArray[np.integer],
        marked_seams: NDArray[np.integer] | None,
        uv: NDArray[np.floating] | None,
        ignored_faces: NDArray[np.bool_] | None,
    ) -> None: ...

class Prescriptions:
    def __init__(
        self,
        corners: Sequence[int],
        aspect_ratio: float,
        angles: Sequence[tuple[int, float]],
        pins: Sequence[tuple[int, Sequence[float]]],
    ) -> None: ...

class Flattener:
    def __init__(
        self, mesh: GivenMesh, is_hierarchical: bool, options: dict[str, Any], prescriptions: Prescriptions
    ) -> None: ...
    def solve(self, vertices: NDArray[np.floating], watch: Watch) -> tuple[NDArray[np.float64], str]: ...

def atlas(
    meshes: Sequence[GivenMesh], is_shared: bool, choices: dict[str, Any], options: dict[str, Any], watch: Watch
) -> tuple[list[tuple[NDArray[np.float64], NDArray[np.int32], NDArray[np.int64]]], str]: ...
def lscm(mesh: GivenMesh, watch: Watch) -> tuple[NDArray[np.float64], str]: ...
def measure(mesh: GivenMesh, watch: Watch) -> str: ...
def certify(mesh: GivenMesh, watch: Watch) -> tuple[bool, list[int], list[int]]: ...
def pack(
    mesh: GivenMesh, first_faces: Sequence[int], options: dict[str, Any], watch: Watch
) -> tuple[NDArray[np.float64], str]: ...
def unshared(
    indices: NDArray[np.integer], uv: NDArray[np.floating]
) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]: ...
def seams(
    mesh: GivenMesh, way: str, options: dict[str, Any], watch: Watch
) -> tuple[NDArray[np.int64], str]: ...
def cones(
    mesh: GivenMesh, number: int, angle_multiple: float, is_flattened: bool, threads: int, watch: Watch
) -> tuple[list[tuple[int, float]], float, NDArray[np.float64], NDArray[np.int64]]: ...
def bake(
    mesh: GivenMesh, fine: GivenMesh, colors: Sequence[Sequence[int]], options: dict[str, Any], watch: Watch
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32] | None, NDArray[np.uint8], str]: ...
def run_program(arguments: Sequence[str]) -> int: ...
