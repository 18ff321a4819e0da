# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the program `measure`, each time in a process of its own, with limits of time and memory."""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SHELL = ROOT / "examples" / "Angle_based_flattening" / "data" / "shell.off"
SUFFIXES = {".off", ".obj", ".ply", ".stl"}

Measurement = dict  # names and numbers; with "failure", the reason, the rest may be missing


@dataclass(frozen=True)
class Measure:
    """The program, and the limits of a process that runs it."""

    program: Path
    seconds: float
    gigabytes: float

    def lines(self, *arguments: object, threads: int | None = 1,
              seconds: float | None = None) -> tuple[list[Measurement], str]:
        """What it printed, and why that may not be all; nothing if it ended well."""
        cores = sorted(os.sched_getaffinity(0))
        if threads and threads > len(cores):
            raise SystemExit(f"cannot use {threads} cores")
        size = int(self.gigabytes * 2**30)

        def confine() -> None:
            # From behind: the first core has other things to do as well.
            os.sched_setaffinity(0, cores[-threads:] if threads else cores)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

        limit = seconds or self.seconds
        environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        try:
            done = subprocess.run([self.program, *map(str, arguments)], stdout=subprocess.PIPE,
                                  timeout=limit, env=environment, preexec_fn=confine, check=False)
        except subprocess.TimeoutExpired as stopped:
            return parse(stopped.stdout or b""), f"took longer than {limit:g} s"
        except (OSError, subprocess.SubprocessError) as error:
            return [], f"cannot be started: {error}"
        failure = ("" if done.returncode == 0 else
                   f"killed by signal {-done.returncode}" if done.returncode < 0 else
                   f"ended with status {done.returncode}")
        return parse(done.stdout), failure

    def one(self, *arguments: object, **options) -> Measurement:
        """The only line that it printed."""
        lines, failure = self.lines(*arguments, **options)
        if failure or not lines:
            return {"failure": failure or "the process ended without a result"}
        return lines[-1]

    def mesh(self, file: Path, triangles: int = 0, noise: bool = False,
             output: Path | None = None) -> Measurement:
        """Looks at a mesh, or makes one; that may take as long as it likes."""
        return self.one("mesh", file, "--triangles", triangles, *["--noise"] * noise,
                        *(["--output", output] if output else []), threads=None, seconds=1e5)

    def resized(self, base: Path, triangles: int, folder: str, noise: bool = False) -> Path:
        """Makes a mesh of about that many triangles of the base, in the folder."""
        file = Path(folder) / "resized.ply"
        made = self.mesh(base, triangles, noise, file)
        if "failure" in made:
            raise SystemExit(f"{base}: {made['failure']}")
        return file.rename(file.with_stem(f"{base.stem}_{(made['triangles'] + 500) // 1000}k"))


def parse(output: bytes) -> list[Measurement]:
    """The measurements in an output, with whatever libraries print around them."""
    result = []
    for line in output.decode(errors="replace").splitlines():
        if line.startswith("{") and line.endswith("}"):
            result.append(json.loads(line))
    return result


def median(runs: Sequence[Measurement]) -> Measurement:
    """Number by number, the median of runs that succeeded; the first failure if one did not."""
    for run in runs:
        if "failure" in run:
            return run
    return {name: statistics.median(run[name] for run in runs) for name in runs[0]}


def interleaved(measure_task, tasks: Sequence, repeat: int) -> list[Measurement]:
    """Task by task, and then all of them again, so that a disturbance does not hit one task only.
    What failed once is not tried again."""
    runs: list[list[Measurement]] = [[] for _ in tasks]
    for _ in range(repeat):
        for task, done in zip(tasks, runs):
            if not done or "failure" not in done[-1]:
                done.append(measure_task(task))
    return [median(done) for done in runs]


def tell(what: str, m: Measurement, name: str = "seconds") -> None:
    """Tells of the progress, apart from the report."""
    print(f"{what}: {m['failure'] if 'failure' in m else f'{m[name]:.3g} s'}", file=sys.stderr, flush=True)


def mesh_files(folder: Path, recursive: bool = False) -> list[Path]:
    """The meshes in a folder, sorted by their names."""
    files: Iterable[Path] = folder.rglob("*") if recursive else folder.iterdir()
    return sorted(file for file in files if file.suffix in SUFFIXES and file.is_file())


def positive(text: str) -> float:
    """For options that take a number above 0"""
    number = float(text)
    if not number > 0:
        raise ValueError
    return number


def numbers(text: str) -> list[float]:
    """For options that take numbers with commas between them, none of them negative"""
    result = [float(word) if set(word) & set(".e") else int(word) for word in text.split(",")]
    if min(result) < 0:
        raise ValueError
    return result


def words(known: Iterable[str]) -> Callable[[str], list[str]]:
    """For options that take words with commas between them, all of them known"""
    def split(text: str) -> list[str]:
        if unknown := [word for word in text.split(",") if word not in known]:
            raise argparse.ArgumentTypeError(f"there is no {', '.join(unknown)}")
        return text.split(",")

    return split


def add_mesh(parser: argparse.ArgumentParser, name: str = "mesh", **how: str) -> None:
    """The mesh of which others are made"""
    parser.add_argument(name, type=Path, default=SHELL, metavar="FILE", **how, help="a disk, which is "
                        "simplified or subdivided; by default the sea shell of the examples")


def add_options(parser: argparse.ArgumentParser, repeat: int = 3, timeout: int = 600,
                memory: int = 16) -> None:
    """Those that the benchmarks have in common"""
    if repeat:
        parser.add_argument("--repeat", type=int, default=repeat, metavar="N",
                            help="of how many processes each the medians are taken (%(default)s)")
    parser.add_argument("--timeout", type=positive, default=timeout, metavar="SECONDS",
                        help="limit of a process, which is stopped then (%(default)s)")
    parser.add_argument("--memory", type=positive, default=memory, metavar="GB",
                        help="limit of a process (%(default)s)")
    parser.add_argument("--measure", type=Path, metavar="PROGRAM", help="what measures",
                        default=ROOT / "build/benchmark/Angle_based_flattening/measure")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE.md",
                        help="write the report there as well")


def measure_of(options: argparse.Namespace) -> Measure:
    """As the options say"""
    if not options.measure.is_file():
        raise SystemExit(f"there is no program '{options.measure}': build the target measure")
    return Measure(options.measure.resolve(), options.timeout, options.memory)
