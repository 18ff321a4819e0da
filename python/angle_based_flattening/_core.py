"""The compiled library, by ctypes: python/src/interface.h has its functions. It takes arrays that others have checked."""

from __future__ import annotations

import ctypes
import json
import os
import signal
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import Cancelled, MeshError

if TYPE_CHECKING:
    from ._arrays import Array

_LIBRARY = ctypes.CDLL(str(Path(__file__).with_name("libangle_based_flattening.so")))


class _Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("shape", ctypes.c_int64 * 2), ("strides", ctypes.c_int64 * 2),
                ("kind", ctypes.c_char), ("size", ctypes.c_int8), ("dimensions", ctypes.c_int8)]


class _Mesh(ctypes.Structure):
    _fields_ = [(name, _Array) for name in ("vertices", "offsets", "indices", "marked_seams", "uv", "ignored_faces")]


class _Prescriptions(ctypes.Structure):
    _fields_ = [("corners", _Array), ("aspect_ratio", ctypes.c_double), ("angle_vertices", _Array),
                ("angles", _Array), ("pin_vertices", _Array), ("pins", _Array)]


class _Progress(ctypes.Structure):
    _fields_ = [("stage", ctypes.c_char_p), ("share", ctypes.c_double), ("is_cancelled", ctypes.c_int)]


def _declare(name: str, *arguments: Any, result: Any = ctypes.c_void_p) -> Any:
    function = _LIBRARY["abf_" + name]
    function.argtypes = arguments
    function.restype = result
    return function


_p, _i, _s, _pointer = ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.POINTER
_mesh, _array, _progress = _pointer(_Mesh), _pointer(_Array), _pointer(_Progress)
_atlas = _declare("atlas", _mesh, _i, _i, _s, _s, _progress)
_make_flattener = _declare("make_flattener", _mesh, _i, _s, _pointer(_Prescriptions), _pointer(_p))
_solve = _declare("solve", _p, _array, _progress)
_free_flattener = _declare("free_flattener", _p, result=None)
_lscm = _declare("lscm", _mesh, _progress)
_measure = _declare("measure", _mesh, _progress)
_certify = _declare("certify", _mesh, _progress)
_pack = _declare("pack", _mesh, _array, _s, _progress)
_unshared = _declare("unshared", _array, _array, _progress)
_seams = _declare("seams", _mesh, _s, _s, _progress)
_cones = _declare("cones", _mesh, _i, ctypes.c_double, _i, _i, _progress)
_bake = _declare("bake", _mesh, _mesh, _array, _s, _progress)
_description = _declare("description", result=_s)
_run_program = _declare("run_program", _i, _pointer(_s), result=_i)
_kind = _declare("kind", _p, result=_i)
_text = _declare("text", _p, result=_s)
_take_array = _declare("take_array", _p, _array)
_free_array = _declare("free_array", _p, result=None)
_free_result = _declare("free_result", _p, result=None)

_described = json.loads(_description())
__version__: str = _described["version"]
OPTIONS: dict[str, list[tuple[str, str, str, str, str]]] = _described["options"]  # name, kind, default, values, help


def _view(array: Array | None) -> _Array:
    """Where an array is."""
    if array is None:
        return _Array()
    two = array.ndim == 2
    view = _Array(array.ctypes.data, (array.shape[0], array.shape[1] if two else 1),
                  (array.strides[0], array.strides[1] if two else 0), array.dtype.kind.encode(), array.itemsize,
                  array.ndim)
    view.array = array  # which has to live as long
    return view


class _Owned:
    """Numbers of the library, for an array of numpy, which keeps this."""

    def __init__(self, handle: int, view: _Array):
        shape = tuple(view.shape)[:view.dimensions]
        self._handle = handle
        self.__array_interface__ = {"version": 3, "data": (view.data, False), "shape": shape,
                                    "typestr": f"<{view.kind.decode()}{view.size}"}

    def __del__(self, free: Any = _free_array) -> None:
        free(self._handle)


def _finish(result: int) -> tuple[str, list[Array]]:
    """The text and the arrays of a result, or its failure as an exception."""
    try:
        kind = _kind(result)
        text = _text(result).decode(errors="replace")
        arrays = []
        view = _Array()
        while handle := _take_array(result, view):
            arrays.append(np.asarray(_Owned(handle, view)))
    finally:
        _free_result(result)
    if kind == 0:
        return text, arrays
    if kind == 3:
        status, mesh, message = text.split("\n", 2)
        faces, vertices = arrays
        raise MeshError(status, message, faces, vertices, int(mesh))
    raise {1: ValueError, 2: TypeError, 4: MemoryError}.get(kind, RuntimeError)(text)


class Watch:
    """Who follows a computation, and how many seconds it may take."""

    def __init__(self, progress: Callable[[str, float], Any] | None, timeout: float):
        self._progress = progress
        self._timeout = timeout

    def run(self, function: Any, *arguments: Any) -> tuple[str, list[Array]]:
        """Calls a function of the library in another thread. Meanwhile, this one looks after signals, the time and the
        progress twenty times a second."""
        state = _Progress(b"READ", 0, 0)
        results: list[int] = []
        thread = threading.Thread(target=lambda: results.append(function(*arguments, state)), daemon=True)
        end: BaseException | None = None
        thread.start()
        try:
            begin = time.monotonic()
            thread.join(.05)
            while thread.is_alive():
                if time.monotonic() - begin > self._timeout:
                    raise TimeoutError("the computation took longer than the timeout")
                if self._progress is not None and self._progress(state.stage.decode(), state.share) is False:
                    raise Cancelled("the computation was cancelled")
                thread.join(.05)
        except BaseException as error:
            end = error
            state.is_cancelled = 1
            thread.join()
        if end is not None:
            for result in results:
                _free_result(result)
            raise end
        return _finish(results[0])


def _encoded(value: Any) -> tuple[str, str] | None:
    """An option as its type and its text."""
    if value is None:
        return None
    if isinstance(value, (bool, np.bool_)):
        return "bool", str(int(value))
    if isinstance(value, str):
        return "str", value
    if hasattr(value, "__index__"):
        return "int", str(value.__index__())
    if hasattr(value, "__float__"):
        return "float", repr(float(value))
    return type(value).__name__, ""


def _options(options: dict[str, Any]) -> bytes:
    return json.dumps({name: _encoded(value) for name, value in options.items()}).encode()


class GivenMesh:
    """A mesh as the library takes it."""

    def __init__(self, vertices: Array, offsets: Array | None, indices: Array,
                 marked_seams: Array | None, uv: Array | None, ignored_faces: Array | None):
        arrays = vertices, offsets, indices, marked_seams, uv, ignored_faces
        self.view = _Mesh(*map(_view, arrays))
        self.view.arrays = arrays  # as in `_view()`


class Flattener:
    """A mesh that is flattened again and again. What is prescribed comes as pairs of vertices and values."""

    def __init__(self, mesh: GivenMesh, is_hierarchical: bool, options: dict[str, Any], corners: Array | None,
                 aspect_ratio: float, angles: tuple[Array, Array] | None,
                 pins: tuple[Array, Array] | None):
        self._handle = _p()
        self._mesh = mesh
        prescriptions = _Prescriptions(_view(corners), aspect_ratio, *map(_view, angles or (None, None)),
                                       *map(_view, pins or (None, None)))
        _finish(_make_flattener(mesh.view, is_hierarchical, _options(options), prescriptions, self._handle))

    def __del__(self, free: Any = _free_flattener) -> None:
        free(self._handle)

    def solve(self, vertices: Array, watch: Watch) -> tuple[Array, str]:
        text, (uv,) = watch.run(_solve, self._handle, _view(vertices))
        return uv, text


def atlas(meshes: Sequence[GivenMesh], is_shared: bool, choices: dict[str, Any], options: dict[str, Any],
          watch: Watch) -> tuple[list[tuple[Array, Array, Array]], str]:
    views = (_Mesh * len(meshes))(*(mesh.view for mesh in meshes))
    views.meshes = meshes  # type: ignore[attr-defined]  # as in `_view()`
    text, arrays = watch.run(_atlas, views, len(meshes), is_shared, _options(choices), _options(options))
    return list(zip(arrays[::3], arrays[1::3], arrays[2::3])), text


def lscm(mesh: GivenMesh, watch: Watch) -> tuple[Array, str]:
    text, (uv,) = watch.run(_lscm, mesh.view)
    return uv, text


def measure(mesh: GivenMesh, watch: Watch) -> str:
    return watch.run(_measure, mesh.view)[0]


def certify(mesh: GivenMesh, watch: Watch) -> tuple[bool, Array, Array]:
    text, (flipped, overlapping) = watch.run(_certify, mesh.view)
    return text == "true", flipped, overlapping


def pack(mesh: GivenMesh, first_faces: Array, options: dict[str, Any], watch: Watch) -> tuple[Array, str]:
    text, (uv,) = watch.run(_pack, mesh.view, _view(first_faces), _options(options))
    return uv, text


def unshared(indices: Array, uv: Array) -> tuple[Array, Array, Array]:
    mapping, new_indices, coordinates = _finish(_unshared(_view(indices), _view(uv), None))[1]
    return mapping, new_indices, coordinates


def seams(mesh: GivenMesh, way: str, options: dict[str, Any], watch: Watch) -> tuple[Array, str]:
    text, (pairs,) = watch.run(_seams, mesh.view, way.encode(), _options(options))
    return pairs, text


def cones(mesh: GivenMesh, number: int, angle_multiple: float, is_flattened: bool, threads: int,
          watch: Watch) -> tuple[float, list[Array]]:
    """The predicted stretch; vertices, angles and, with a map, coordinates of corners and edges of seams."""
    text, arrays = watch.run(_cones, mesh.view, number, angle_multiple, is_flattened, threads)
    return float(text), arrays


def bake(mesh: GivenMesh, fine: GivenMesh, colors: Array | None, options: dict[str, Any],
         watch: Watch) -> tuple[Array, Array, Array | None, Array, str]:
    text, (normals, displacements, texels, *found) = watch.run(_bake, mesh.view, fine.view, _view(colors),
                                                               _options(options))
    height, report = text.split("\n", 1)
    rows = int(height)
    return (normals.reshape(rows, -1, 3), displacements.reshape(rows, -1),
            found[0].reshape(rows, -1, 3) if found else None, texels.reshape(rows, -1), report)


def run_program(arguments: Sequence[str]) -> int:
    """Runs the program flatten_mesh in this process, which signals interrupt then, and returns its exit status."""
    for each in signal.SIGINT, signal.SIGPIPE:  # Python keeps these to itself
        signal.signal(each, signal.SIG_DFL)
    argv = [b"flatten_mesh", *map(os.fsencode, arguments)]
    return int(_run_program(len(argv), (ctypes.c_char_p * (len(argv) + 1))(*argv, None)))
