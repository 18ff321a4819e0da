"""Checks of options, and how a computation is watched."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from . import _core

Progress = Callable[[str, float], Any]


def choice(name: str, value: str, known: Iterable[str]) -> str:
    """A word that has to be one of those known."""
    known = list(known)
    if value not in known:
        raise ValueError(f"{name} is {value!r}, and must be one of {', '.join(map(repr, known))}")
    return value


def number(name: str, value: Any, least: float, most: float = math.inf, open_below: bool = False) -> float:
    """A number within bounds."""
    if isinstance(value, bool) or not isinstance(value, (int, float)) and not hasattr(value, "__float__"):
        raise TypeError(f"{name} is a {type(value).__name__}, and must be a number")
    value = float(value)
    if math.isnan(value) or value < least or value > most or (open_below and value == least):
        bounds = f"{'above' if open_below else 'at least'} {least:g}"
        bounds += f" and at most {most:g}" if most < math.inf else ""
        raise ValueError(f"{name} is {value:g}, and must be {bounds}")
    return value


def integer(name: str, value: Any, least: int, most: int) -> int:
    """An integer within bounds."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} is a {type(value).__name__}, and must be an integer")
    value = value.__index__()
    if value < least or value > most:
        raise ValueError(f"{name} is {value}, and must be from {least} to {most}")
    return value


def switch(name: str, value: Any) -> bool:
    """True or False, also as numpy has them."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is a {type(value).__name__}, and must be True or False")
    return bool(value)


def watch(progress: Progress | None = None, timeout: float | None = None) -> _core.Watch:
    """How long a computation may take, and who follows it."""
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of the name of a stage and its share")
    return _core.Watch(progress, math.inf if timeout is None else number("timeout", timeout, 0, open_below=True))
