# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports in Markdown: tables, numbers in their cells, and on what machine they were measured."""

import math
import os
import re
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from run import Measure, Measurement

DASH = "–"  # for what was not measured
Column = tuple[str, str, str]  # its title, the name of its number, and the format of a cell


def cell(number: float, form: str = ".4f") -> str:
    """A number by its format, or as `seconds`, or as `yes` or no; a dash for NaN"""
    if math.isnan(number):
        return DASH
    if form == "yes":
        return "yes" if number else "no"
    if form == "milliseconds":
        return f"{1000 * number:.3g} ms"
    if form == "seconds":  # enough digits to compare times by
        form = ".3f" if number < 1 else ".2f" if number < 100 else ".0f"
    return format(number, form)


def row(cells: Iterable[str]) -> str:
    """A line of a table"""
    return "| " + " | ".join(cells) + " |\n"


def table(titles: Sequence[str], rows: Iterable[Sequence[str]], text_columns: int = 1) -> str:
    """A table whose other columns are numbers; rows that are too short end in empty cells."""
    rule = ["---"] * text_columns + ["---:"] * (len(titles) - text_columns)
    filled = ([*cells, *[""] * (len(titles) - len(cells))] for cells in rows)
    return row(titles) + row(rule) + "".join(map(row, filled))


class Table:
    """A row for each measurement: cells that are given, and then its numbers"""

    def __init__(self, titles: list[str], columns: list[Column], text_columns: int = 1) -> None:
        self.titles = titles + [title for title, _, _ in columns]
        self.columns, self.text_columns = columns, text_columns
        self.rows: list[list[str]] = []

    def add(self, cells: list[object], m: Measurement) -> None:
        """If there are no numbers, the reason is in the last cell."""
        numbers = [cell(m[name], form) for _, name, form in self.columns]
        if "failure" in m:
            numbers = [DASH] * (len(self.columns) - 1) + ["FAILED: " + m["failure"]]
        self.rows.append([*map(str, cells), *numbers])

    def __str__(self) -> str:
        return table(self.titles, self.rows, self.text_columns)


class Targets:
    """What was to be reached, and what was. A number that was not measured misses its target."""

    def __init__(self) -> None:
        self.rows: list[list[str]] = []

    def add(self, what: str, form: str, number: float, *, most: float | None = None, least: float = -math.inf) -> None:
        limit = f"at least {least:{form}}" if most is None else f"at most {most:{form}}"
        met = number >= least if most is None else number <= most
        verdict = "not measured" if math.isnan(number) else "yes" if met else "NO"
        self.rows.append([what, limit, cell(number, form), verdict])

    def __str__(self) -> str:
        return "\n" + table(["target", "limit", "measured", "met"], self.rows)


class Report:
    """Goes to standard output, and to a file if there is one, at once: nothing is lost if the program is stopped."""

    def __init__(self, file: Path | None) -> None:
        self.files = [sys.stdout] + ([file.open("w", encoding="utf-8")] if file else [])

    def add(self, text: str) -> None:
        for file in self.files:
            print(text, end="", file=file, flush=True)


def head(title: str, measure: Measure) -> str:
    """The title, what prints the report again, without the folders of this machine, and one sentence each
    about the hardware and the software"""
    processor = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    software = measure.one("software")
    compiler, blas = software.pop("compiler"), software.pop("BLAS")
    libraries = [f"{name} {version}" for name, version in software.items()]
    return (f"# {title}\n\n    {' '.join(Path(word).name for word in sys.argv)}\n\n"
            f"Machine: {processor[1] if processor else 'unknown'}, {os.cpu_count()} cores, {memory:.0f} GB of "
            f"memory. Software: {', '.join([compiler, *libraries, blas])}.\n\n")
