"""Checks of options, and how a computation is watched."""

from __future__ import annotations

import contextlib
import inspect
import math
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

import numpy as np

from . import _core

Progress = Callable[[str, float], Any]
Function = TypeVar("Function", bound=Callable[..., Any])


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
    return float(value)


def integer(name: str, value: Any, least: int, most: int) -> int:
    """An integer within bounds."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} is a {type(value).__name__}, and must be an integer")
    value = value.__index__()
    if value < least or value > most:
        raise ValueError(f"{name} is {value}, and must be from {least} to {most}")
    return int(value)


def switch(name: str, value: Any) -> bool:
    """True or False, also as numpy has them."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is a {type(value).__name__}, and must be True or False")
    return bool(value)


def _default(kind: str, text: str) -> Any:
    """A default of the table of options. None stands for one that depends on other options."""
    if text == "" or ":" in text:
        return None
    if kind == "bool":
        return text == "on"
    return {"str": str, "int": int, "float": float}[kind](text)


def _row(name: str, kind: str, default: str, values: str, help: str) -> str:
    """What a docstring says on an option."""
    if kind == "bool":
        help, default, values = (re.sub(r"\boff\b", "False", re.sub(r"\bon\b(?=[:;,]|$| or off)", "True", text))
                                 for text in (help, default, values))
    values = values.replace("from 0 to 2147483647", "at least 0")
    default = f"; default {default}" if default else ""
    return textwrap.fill(f"{name}: {help} ({values}{default}).", 120, initial_indent=" " * 8,
                         subsequent_indent=" " * 12, break_on_hyphens=False)


def takes(*tables: str) -> Callable[[Function], Function]:
    """Decorates a function whose `options` are those of tables: its signature has them all, and its docstring too."""
    rows: dict[str, tuple[str, str, str, str, str]] = {}
    for table in tables:
        for name, kind, default, values, help in _core.OPTIONS[table]:
            first = rows.setdefault(name, (name, kind, default, values, help))
            if first[2] != default:  # each method has its own
                rows[name] = (name, kind, f"{tables[0]}: {first[2]}; {table}: {default}", first[3], first[4])

    def decorate(function: Function) -> Function:
        signature = inspect.signature(function)
        before = [p for p in signature.parameters.values() if p.kind != inspect.Parameter.VAR_KEYWORD]
        keywords = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_default(kind, default))
                    for name, kind, default, *_ in rows.values()]
        vars(function)["__signature__"] = signature.replace(parameters=before + keywords)
        described = "\n".join(_row(*row) for row in rows.values())
        function.__doc__ = (function.__doc__ or "").replace("        OPTIONS", described)
        return function

    return decorate


class _Bar:
    """A bar of tqdm for each stage, as the function `progress`."""

    def __init__(self) -> None:
        try:
            from tqdm.auto import tqdm
        except ImportError as error:
            raise ImportError("progress=True needs tqdm: pip install tqdm; or give a function") from error
        self._bar: Any = tqdm(total=100, leave=False, bar_format="{desc} {percentage:3.0f}%|{bar}| {elapsed}")

    def __call__(self, stage: str, share: float) -> None:
        self._bar.set_description_str(stage.lower(), refresh=False)
        self._bar.n = 100 * share  # which falls where a stage begins
        self._bar.refresh()

    def close(self) -> None:
        """Removes it."""
        self._bar.close()


def watch(progress: Progress | None = None, timeout: float | None = None) -> _core.Watch:
    """How long a computation may take, and who follows it."""
    if progress is not None and not callable(progress):
        raise TypeError("progress must be a function of the name of a stage and its share, or True for a bar")
    return _core.Watch(progress, math.inf if timeout is None else number("timeout", timeout, 0, open_below=True))


@contextlib.contextmanager
def watching(progress: Progress | bool | None, timeout: float | None) -> Iterator[_core.Watch]:
    """As `watch()`, with a bar if `progress` is True, which is there as long as the computation."""
    bar = _Bar() if progress is True else None
    try:
        yield watch(bar if bar else None if isinstance(progress, bool) else progress, timeout)
    finally:
        if bar:
            bar.close()
