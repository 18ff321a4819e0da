"""Checks of arrays. Errors name the array, and what it should be."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np

from ._errors import MeshError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Array: TypeAlias = NDArray[Any]

INTEGERS = (np.int32, np.uint32, np.int64, np.uint64)


class SupportsArray(Protocol):
    """An array, of numpy or of another library."""

    def __array__(self) -> Array: ...


def name_of(what: str, mesh: str) -> str:
    """The name of an array in messages."""
    return f"{what} of {mesh}" if mesh else what


def _array(values: ArrayLike, what: str) -> Array:
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{what} is not an array of numbers: {error}") from None
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{what} has elements of type {array.dtype}, and needs numbers")
    return array


def numbers(values: ArrayLike, what: str, columns: int) -> Array:
    """An array of float32 or float64 with that many columns, without a copy if it is one."""
    array = _array(values, what)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{what} has the shape {array.shape}, and must have the shape (n, {columns})")
    if array.dtype not in (np.float32, np.float64):
        array = array.astype(np.float64)
    return array


def integers(values: ArrayLike, what: str, columns: int | None) -> Array:
    """An array of integers with that many columns, or of one dimension, without a copy if it is one."""
    array = _array(values, what)
    if array.size == 0 and array.ndim <= 1 and columns is not None:
        array = np.zeros((0, columns), np.int64)
    shape = "(m,)" if columns is None else f"(m, {columns})"
    if array.ndim != (1 if columns is None else 2) or (columns is not None and array.shape[1] != columns):
        raise ValueError(f"{what} has the shape {array.shape}, and must have the shape {shape}")
    if array.dtype.kind not in "iu":
        if array.size > 0:
            raise ValueError(f"{what} has elements of type {array.dtype}, and needs integers")
        array = array.astype(np.int64)
    if array.dtype not in INTEGERS:  # smaller, or of another order of bytes
        array = array.astype(np.int64)
    return array


def polygons(faces: ArrayLike, mesh: str = "") -> tuple[Array | None, Array]:
    """The offsets and indices of faces. Triangles have no offsets."""
    if isinstance(faces, tuple) and len(faces) == 2 and all(isinstance(a, np.ndarray) and a.ndim == 1 for a in faces):
        offsets = integers(faces[0], name_of("offsets", mesh), None)
        if offsets.size == 0:
            raise ValueError(f"{name_of('offsets', mesh)} is empty, and must begin with 0")
        return offsets, integers(faces[1], name_of("indices", mesh), None)
    return None, integers(faces, name_of("faces", mesh), 3)


def number_of_faces(offsets: Array | None, indices: Array) -> int:
    """Of faces as `polygons()` returns them."""
    return len(indices) if offsets is None else len(offsets) - 1


def check_not_empty(offsets: Array | None, indices: Array, mesh: str = "", number: int = 0) -> None:
    """Raises a `MeshError` if there are no faces."""
    if number_of_faces(offsets, indices) == 0:
        raise MeshError("EMPTY_MESH", f"{mesh or 'the mesh'} has no faces", mesh=number)


def flags(values: ArrayLike, what: str, count: int) -> Array:
    """An array of bool of that length."""
    array = np.asarray(values)
    if array.dtype != np.bool_ or array.shape != (count,):
        raise ValueError(f"{what} is an array of {array.dtype} with the shape {array.shape}, "
                         f"and must be one of bool with the shape ({count},)")
    return array
