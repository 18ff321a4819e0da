# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
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


def cell(number: float | None, form: str = ".4f") -> str:
    """A number by its format, with a dash for None and NaN"""
    return DASH if number is None or math.isnan(number) else format(number, form)


def count(number: float | None) -> str:
    """A whole number"""
    return cell(number, ".0f")


def seconds(number: float | None) -> str:
    """Enough digits to compare times by"""
    return cell(number, ".3f" if (number or 0) < 1 else ".2f" if number < 100 else ".0f")


def yes(met: object) -> str:
    """What is not met shall be seen."""
    return "yes" if met else "no"


def row(cells: Iterable[str]) -> str:
    """A line of a table"""
    return "| " + " | ".join(cells) + " |\n"


def table(titles: Sequence[str], rows: Iterable[Sequence[str]], text_columns: int = 1) -> str:
    """A table whose other columns are numbers; rows that are too short end in empty cells."""
    rule = ["---"] * text_columns + ["---:"] * (len(titles) - text_columns)
    filled = ([*cells, *[""] * (len(titles) - len(cells))] for cells in rows)
    return row(titles) + row(rule) + "".join(map(row, filled))


def failure_row(cells: Sequence[str], result: Measurement, columns: int) -> list[str]:
    """The first cells, and then the reason why there are no others"""
    return [*cells, *[DASH] * (columns - len(cells) - 1), "FAILED: " + result["failure"]]


def ratio(numerator: float | None, denominator: float | None) -> float:
    """NaN if one of them was not measured"""
    return math.nan if None in (numerator, denominator) else numerator / denominator


class Targets:
    """What was to be reached, and what was. A number that was not measured misses its target."""

    def __init__(self) -> None:
        self.rows: list[list[str]] = []

    def at_most(self, what: str, form: str, number: float, limit: float) -> None:
        self._add(what, f"at most {limit:{form}}", form, number, number <= limit)

    def at_least(self, what: str, form: str, number: float, limit: float) -> None:
        self._add(what, f"at least {limit:{form}}", form, number, number >= limit)

    def _add(self, what: str, limit: str, form: str, number: float, met: bool) -> None:
        verdict = "not measured" if math.isnan(number) else "yes" if met else "NO"
        self.rows.append([what, limit, cell(number, form), verdict])

    def text(self) -> str:
        return "\n" + table(["target", "limit", "measured", "met"], self.rows)


class Report:
    """Text that goes to standard output, and to a file if there is one. What was added is not lost
    if the program is stopped."""

    def __init__(self, file: Path | None) -> None:
        self.file = file
        self.text = ""

    def add(self, text: str) -> None:
        self.text += text
        print(text, end="", flush=True)
        if self.file:
            self.file.write_text(self.text, encoding="utf-8")


def command_text() -> str:
    """What prints this report again, without the folders of this machine, as a block"""
    return "    " + " ".join(Path(word).name for word in sys.argv) + "\n\n"


def describe_machine(measure: Measure) -> str:
    """One sentence about the hardware and one about the software"""
    processor = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    software = measure.one("software")
    compiler, blas = software.pop("compiler", ""), software.pop("BLAS", "")
    libraries = [f"{name} {version}" for name, version in software.items()]
    return (f"Machine: {processor[1] if processor else 'unknown'}, {os.cpu_count()} cores, "
            f"{memory:.0f} GB of memory. Software: {', '.join([compiler, *libraries, blas])}.")


def head(title: str, measure: Measure) -> str:
    """With what each report begins"""
    return f"# {title}\n\n{command_text()}{describe_machine(measure)}\n\n"
