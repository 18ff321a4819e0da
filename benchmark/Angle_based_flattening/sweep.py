#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens every component with a border of every mesh in a folder, each file in a process of its own, and
looks at each map with the exact certificate, whatever the parameterizer said. The exit status is 0 only if
there was no crash, no timeout, and no map that was called valid and is not."""

import argparse
import sys
from collections import Counter
from pathlib import Path

import run
from report import Report, cell, row, table

TITLES = ["file", "component", "triangles", "borders", "holes", "result", "injective", "seconds", "message"]


def sweep_file(measure: run.Measure, file: Path, method: str) -> list[run.Measurement]:
    """All runs, and what is to say of the file as a whole. After a crash another process goes on with the
    next run."""
    results: list[run.Measurement] = []
    while True:
        lines, failure = measure.lines("sweep", file, method, "--first-run", len(results), threads=None)
        begun = False  # whether a run was begun and not ended
        for m in lines:
            if "component" in m:
                results.append(run.Measurement(m, fault=failure))
            elif "fault" in m:
                results[-1].update(m)
            else:
                results.append(m)
            begun = "component" in m
        if failure and not begun:
            results.append(run.Measurement(fault=failure))
        if not failure or not begun:
            return results


def table_row(name: str, m: run.Measurement) -> list[str]:
    if m.get("fault"):
        result = f"**FAULT: {m['fault']}**"
    else:
        result = "not read" if "failure" in m else m["result"]
    cells = [name, *(str(m.get(key, "")) for key in ("component", "triangles", "borders")),
             "allowed" if m.get("holes") else "", result, cell(m["injective"], "yes") if result == "valid" else "",
             cell(m["seconds"], "seconds"), m.get("failure") or m.get("message", "")]
    return [text.replace("|", "\\|") for text in cells]


def summary(results: list[tuple[str, run.Measurement]]) -> tuple[str, list[str]]:
    """As text, and the faults"""
    faults, counts, errors = [], Counter(), Counter()
    for name, m in results:
        counts["closed"] += m.get("closed", 0)
        counts["not read"] += "failure" in m
        counts["runs"] += "component" in m
        if m.get("fault"):
            where = f", component {m['component']}{', holes allowed' * m['holes']}" if "component" in m else ""
            faults.append(f"{name}{where}: {m['fault']}")
        elif m.get("result") == "valid":
            counts["valid"] += 1
            counts["injective"] += m["injective"]
        elif "result" in m:
            errors[m["result"]] += 1
    text = (f"{len({name for name, _ in results})} files, of which {counts['not read']} were not read; "
            f"{counts['closed']} closed components were skipped. {counts['runs']} runs: {counts['valid']} valid, "
            f"of which {counts['injective']} injective as a whole.\n\n")
    text += "".join(f"* {name}: {number}\n" for name, number in sorted(errors.items())) + "\n" * bool(errors)
    if not faults:
        return text + "No crash, no timeout, no map that was called valid and is not.\n", faults
    return text + f"**{len(faults)} FAULTS:**\n\n" + "".join(f"* {fault}\n" for fault in faults), faults


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=run.EXAMPLES,
                        help="with meshes, also in folders within it; by default the data of the examples")
    parser.add_argument("--method", choices=["direct", "hierarchical"], default="direct")
    run.add_options(parser, repeat=0, timeout=120, memory=8)
    options = parser.parse_args()
    measure = run.measure_of(options)
    report = Report(options.output)
    report.add(f"# Sweep, {options.method} method\n\n" + table(TITLES, []))
    results = []
    for file in run.mesh_files(options.folder, recursive=True):
        name = str(file.relative_to(options.folder))
        for m in sweep_file(measure, file, options.method):
            results.append((name, m))
            if "closed" not in m:
                report.add(row(table_row(name, m)))
    text, faults = summary(results)
    report.add("\n## Summary\n\n" + text)
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
