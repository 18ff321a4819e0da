# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of all formats with random damage, from a fixed seed. The program ends with status 0 or 2 and says so in JSON.
What it writes can be read again, with the same charts.
Usage: test_mutations.py FLATTEN_MESH [NUMBER [FIRST]]    (the numbers of the files: 200 from 0 on if not given)"""

import concurrent.futures
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import test_dirt
from shapes import sphere, terrain, torus

SECONDS = 60
NUMBERS = [b"0", b"-1", b"1", b"2", b"65535", b"4294967296", b"9223372036854775808", b"1e-30", b"1e30", b"1e300",
           b"nan", b"inf", b"0.5", b"", b"x"]


def surfaces():
    """A torus, an octahedron, and a rough sheet"""
    yield torus(9, 6)
    yield sphere(2, 4)
    noise = random.Random(1)
    yield terrain(7, lambda i, j: noise.uniform(0, 1))


def generated():
    """Formats and contents of good files"""
    for points, faces in surfaces():
        for name, write in test_dirt.WRITERS.items():
            yield name, write(points, faces).encode()
        yield "ply", test_dirt.binary_ply(points, faces)
        yield "stl", test_dirt.binary_stl(points, faces)
    for is_binary in (False, True):
        yield ("glb" if is_binary else "gltf"), test_dirt.gltf(is_binary)


def dirty():
    """Formats and contents of bad ones"""
    for case in test_dirt.cases:
        form = case["name"].split()[0]
        if form in test_dirt.WRITERS and len(case["content"]) < 2000:
            yield form, case["content"]


def damaged(form, content, generator):
    """One to four kinds of damage: to bytes, numbers, lines, or members of JSON; to numbers alone in half of the files,
    as these are refused less often while they are read"""
    kinds = generator.choice((range(6), (3,)))
    for _ in range(generator.choice((1, 1, 2, 4))):
        kind, size = generator.choice(kinds), len(content)
        if form == "gltf" and generator.random() < 0.8:
            words = list(re.finditer(rb'-?[0-9.]+|"[a-zA-Z0-9_]+"', content))
            word = generator.choice(words)
            new = generator.choice(NUMBERS[:10]) if word.group()[:1] != b'"' else generator.choice(words).group()
            content = content[:word.start()] + new + content[word.end():]
        elif kind == 0 and size > 0:
            at = generator.randrange(size)
            content = content[:at] + bytes([generator.randrange(256)]) + content[at + 1:]
        elif kind == 1 and size > 0:
            at, length = generator.randrange(size), generator.randrange(1, 40)
            content = content[:at] + content[at + length:]
        elif kind == 2 and size > 0:
            at, length, to = generator.randrange(size), generator.randrange(1, 60), generator.randrange(size)
            content = content[:to] + content[at:at + length] + content[to:]
        elif kind == 3:
            numbers = list(re.finditer(rb"-?[0-9][-+.0-9e]*", content))
            if numbers:
                number = generator.choice(numbers)
                content = content[:number.start()] + generator.choice(NUMBERS) + content[number.end():]
        else:
            lines = content.split(b"\n")
            i, j = generator.randrange(len(lines)), generator.randrange(len(lines))
            if kind == 4:
                lines[i], lines[j] = lines[j], lines[i]
            else:
                lines[i] = lines[j]
            content = b"\n".join(lines)
    return content


class Fault(Exception):
    """What is wrong with a run"""


def flatten(program, file, output, *options):
    """Exit status and report"""
    report = output.with_suffix(".json")
    command = [program, file, "-o", output, "--json", report, "--threads", "1", *options]
    try:
        run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        raise Fault("does not end") from None
    if run.returncode not in (0, 2):
        raise Fault(f"status {run.returncode}: {run.stderr[-500:]!r}")
    for line in run.stderr.decode("utf-8", "replace").split("\n")[:-1]:
        if not line.startswith("flatten_mesh: ") or not line.isprintable():
            raise Fault(f"on standard error: {line!r}")
    return run.returncode, json.loads(report.read_text(), parse_constant=lambda word: 1 / 0)


def check(program, folder, number, seeds):
    """Damages a file, flattens it, and reads the result."""
    generator = random.Random(number)
    form, content = generator.choice(seeds[number % len(seeds)])
    file = folder / f"{number}.{form}"
    file.write_bytes(damaged(form, content, generator))
    output = folder / f"{number}_out.{generator.choice(('obj', 'ply', 'glb'))}"
    purpose = generator.choice(("texture", "few-charts"))
    status, report = flatten(program, file, output, "--for", purpose)
    if not output.exists():
        if status == 0:
            raise Fault("status 0 without output")
        return 0
    # Faces that were left out have no coordinates, with which glTF does not tell them from others.
    _, again = flatten(program, output, folder / f"{number}_again.obj", "--repack",
                       *(["--repair-charts"] if report["skipped"] else []))
    written, read = (Counter(chart["triangles"] for chart in r["atlas"]["charts"]) for r in (report, again))
    is_same = not written - read if report["skipped"] else written == read
    # Sheets that meet in an edge, or are the back of each other, may be told apart in another way.
    if not is_same and not re.search("more than two faces|sheets of their own", str(report["notes"] + again["notes"])):
        raise Fault(f"charts of so many triangles were written, and read: {sorted(written.elements())[:50]}, "
                    f"{sorted(read.elements())[:50]}")
    return 1


def main():
    program, number, first = sys.argv[1], *(map(int, sys.argv[2:] + ["200", "0"][len(sys.argv) - 2:]))
    good = list(generated())
    seeds = [good, good, list(dirty())]
    faults = written = 0
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(2) as pool:
        runs = [pool.submit(check, program, Path(name), i, seeds) for i in range(first, first + number)]
        for i, run in enumerate(runs, first):
            try:
                written += run.result()
            except (Fault, OSError, ValueError, KeyError, TypeError, ArithmeticError) as fault:
                faults += 1
                print(f"file {i}: {type(fault).__name__}: {fault}")
    print(f"{number} files, {written} with an atlas, {faults} wrong")
    return 1 if faults or written < number / 4 else 0


if __name__ == "__main__":
    sys.exit(main())
