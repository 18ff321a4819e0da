#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Flattens every component with a border of every mesh in a folder, each file in a process of its own,
and looks at each map with the exact certificate, whatever the parameterizer said. The exit status is 0
only if there was no crash, no timeout, and no map that was called valid and is not."""

import argparse
import sys
from collections import Counter
from pathlib import Path

import run
from report import Report, cell, row, table

TITLES = ["file", "component", "triangles", "borders", "holes", "result", "injective", "seconds", "message"]


def sweep_file(measure: run.Measure, file: Path, method: str) -> tuple[list[run.Measurement], run.Measurement]:
    """All runs, and what is to say of the file. After a crash another process goes on with the next run."""
    runs: list[run.Measurement] = []
    while True:
        lines, failure = measure.lines("sweep", file, method, "--first-run", len(runs), threads=None)
        begun = False  # whether a run was begun and not ended
        whole: run.Measurement = {}
        for line in lines:
            if "component" in line:
                runs.append(line | {"fault": failure})
                begun = True
            elif "fault" in line:
                runs[-1] |= line
                begun = False
            else:
                whole = line
        if not failure or not begun:
            return runs, whole | ({"fault": failure} if failure else {})


def result_cell(result: run.Measurement) -> str:
    return f"**FAULT: {escaped(result['fault'])}**" if result["fault"] else result["result"]


def escaped(text: str) -> str:
    return text.replace("|", "\\|")


def rows(name: str, runs: list[run.Measurement], whole: run.Measurement) -> list[list[str]]:
    result = []
    if "failure" in whole:
        result.append([name, *[""] * 4, "not read", "", "", escaped(whole["failure"])])
    if "fault" in whole:
        result.append([name, *[""] * 4, result_cell(whole), "", "", ""])
    for m in runs:
        result.append([name, *(str(m[key]) for key in ("component", "triangles", "borders")),
                       "allowed" if m["holes"] else "", result_cell(m),
                       cell(m["injective"], "yes") if is_valid(m) else "", cell(m.get("seconds"), "seconds"),
                       escaped(m.get("message", ""))])
    return result


def is_valid(m: run.Measurement) -> bool:
    return not m["fault"] and m["result"] == "valid"


def summary(results: dict[str, tuple[list[run.Measurement], run.Measurement]]) -> tuple[str, int]:
    """As text, and the number of faults"""
    wholes = [whole for _, whole in results.values()]
    runs = [(name, m) for name, (measured, _) in results.items() for m in measured]
    valid = [m for _, m in runs if is_valid(m)]
    faults = [f"{name}: {whole['fault']}" for name, (_, whole) in results.items() if "fault" in whole]
    faults += [f"{name}, component {m['component']}{', holes allowed' * m['holes']}: {m['fault']}"
               for name, m in runs if m["fault"]]
    errors = Counter(m["result"] for _, m in runs if not m["fault"] and m["result"] != "valid")
    text = (f"{len(results)} files, of which {sum('failure' in whole for whole in wholes)} were not read; "
            f"{sum(whole.get('closed', 0) for whole in wholes)} closed components were skipped. "
            f"{len(runs)} runs: {len(valid)} valid, of which {sum(m['injective'] for m in valid)} injective "
            "as a whole.\n\n")
    text += "".join(f"* {name}: {number}\n" for name, number in sorted(errors.items())) + "\n" * bool(errors)
    if not faults:
        return text + "No crash, no timeout, no map that was called valid and is not.\n", 0
    return text + f"**{len(faults)} FAULTS:**\n\n" + "".join(f"* {fault}\n" for fault in faults), len(faults)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=run.SHELL.parent, help="with meshes, also in "
                        "folders within it; by default the data of the examples")
    parser.add_argument("--method", choices=["direct", "hierarchical"], default="direct")
    run.add_options(parser, repeat=0, timeout=120, memory=8)
    options = parser.parse_args()
    measure = run.measure_of(options)
    report = Report(options.output)
    report.add(f"# Sweep, {options.method} method\n\n" + table(TITLES, []))
    results = {}
    for file in run.mesh_files(options.folder, recursive=True):
        name = str(file.relative_to(options.folder))
        results[name] = sweep_file(measure, file, options.method)
        report.add("".join(map(row, rows(name, *results[name]))))
    text, faults = summary(results)
    report.add("\n## Summary\n\n" + text)
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
