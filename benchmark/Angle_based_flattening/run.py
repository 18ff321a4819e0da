# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program `measure`, each time in a process of its own, with limits of time and memory."""

import argparse
import json
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEASURE = ROOT / "build/benchmark/Angle_based_flattening/measure"  # the default, which is built when it is needed
SHELL = ROOT / "benchmark/Angle_based_flattening/data/shell.off"
EXAMPLES = ROOT / "examples/Angle_based_flattening/data"

FOLDER = tempfile.TemporaryDirectory()  # for meshes that are made; it vanishes with the process


class Measurement(dict):
    """Names and numbers, NaN of what was not measured; with "failure", the reason why some were not"""

    def __missing__(self, name: str) -> float:
        return math.nan


@dataclass(frozen=True)
class Measure:
    """The program, and the limits of a process that runs it"""

    program: Path
    seconds: float
    gigabytes: float

    def lines(self, *arguments: object, threads: int | None = 1,
              seconds: float | None = None) -> tuple[list[Measurement], str]:
        """What it printed, and why that may not be all; nothing if it ended well"""
        cores = sorted(os.sched_getaffinity(0))
        if threads and threads > len(cores):
            raise SystemExit(f"cannot use {threads} cores")
        size = int(self.gigabytes * 2**30)

        def confine() -> None:
            # From behind: the first core has other things to do as well.
            os.sched_setaffinity(0, cores[-threads:] if threads else cores)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

        limit, failure = seconds or self.seconds, ""
        environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        try:
            # In a folder of its own, for some libraries write files where they are.
            words = [str(word.resolve() if isinstance(word, Path) else word) for word in arguments]
            done = subprocess.run([self.program, *words], stdout=subprocess.PIPE, timeout=limit, env=environment,
                                  cwd=FOLDER.name, preexec_fn=confine, check=False)
            output = done.stdout
            if done.returncode:
                failure = (f"killed by signal {-done.returncode}" if done.returncode < 0 else
                           f"ended with status {done.returncode}")
        except subprocess.TimeoutExpired as stopped:
            output, failure = stopped.stdout or b"", f"took longer than {limit:g} s"
        except (OSError, subprocess.SubprocessError) as error:
            output, failure = b"", f"cannot be started: {error}"
        # Libraries print, too.
        lines = output.decode(errors="replace").splitlines()
        return [json.loads(line, object_hook=Measurement) for line in lines
                if line.startswith("{") and line.endswith("}")], failure

    def one(self, *arguments: object, **how) -> Measurement:
        """The only line that it printed"""
        lines, failure = self.lines(*arguments, **how)
        if failure or not lines:
            return Measurement(failure=failure or "the process ended without a result")
        m = lines[-1]
        return Measurement(failure=m["failure"]) if "failure" in m else m

    def mesh(self, file: Path, *arguments: object) -> Measurement:
        """Looks at a mesh, or makes one; that may take as long as it likes."""
        return self.one("mesh", file, *arguments, threads=None, seconds=1e5)

    @cache
    def resized(self, base: Path, triangles: int, noise: bool = False) -> Path:
        """Makes a mesh of about that many triangles of the base"""
        file = Path(FOLDER.name) / "resized.ply"
        m = self.mesh(base, "--triangles", triangles, "--output", file, *["--noise"] * noise)
        if "failure" in m:
            raise SystemExit(f"{base}: {m['failure']}")
        return file.rename(file.with_stem(f"{base.stem}_{(m['triangles'] + 500) // 1000}k"))


def median(runs: Sequence[Measurement]) -> Measurement:
    """Number by number, the median of runs that succeeded; the first failure if one did not"""
    for run in runs:
        if "failure" in run:
            return run
    return Measurement({name: number if all(run[name] == number for run in runs) else
                        statistics.median(run[name] for run in runs) for name, number in runs[0].items()})


def interleaved(measure_task: Callable, tasks: Sequence, repeat: int) -> list[Measurement]:
    """Medians of task by task, and then all of them again, so that a disturbance does not hit one task only.
    What failed once is not tried again."""
    runs: list[list[Measurement]] = [[] for _ in tasks]
    for _ in range(repeat):
        for task, done in zip(tasks, runs):
            if not done or "failure" not in done[-1]:
                done.append(measure_task(task))
    return [median(done) for done in runs]


def tell(what: str, m: Measurement, name: str = "seconds") -> None:
    """Tells of the progress, apart from the report."""
    print(f"{what}: {m.get('failure') or f'{m[name]:.3g} s'}", file=sys.stderr, flush=True)


def mesh_files(folder: Path, recursive: bool = False) -> list[Path]:
    """The meshes in a folder, sorted by their names"""
    return sorted(file for file in folder.glob("**/*" if recursive else "*")
                  if file.suffix in {".off", ".obj", ".ply", ".stl"} and file.is_file())


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
                        "simplified or subdivided; by default a sea shell")


def build(target: str) -> None:
    """In the build folder, as the scripts do"""
    commands = 'source "$0/scripts/common.bash"; configure "$build"; compile "$build" --target "$1"'
    if subprocess.run(["bash", "-euo", "pipefail", "-c", commands, ROOT, target], check=False).returncode != 0:
        raise SystemExit(f"the target '{target}' cannot be built")


def add_options(parser: argparse.ArgumentParser, repeat: int = 3, timeout: int = 600,
                memory: int = 16) -> None:
    """Those that the benchmarks have in common"""
    if repeat:
        parser.add_argument("--repeat", type=int, default=repeat, metavar="N",
                            help="of how many processes each the medians are taken (%(default)s)")
    parser.add_argument("--timeout", type=float, default=timeout, metavar="SECONDS",
                        help="limit of a process, which is stopped then (%(default)s)")
    parser.add_argument("--memory", type=float, default=memory, metavar="GB",
                        help="limit of a process (%(default)s)")
    parser.add_argument("--measure", type=Path, metavar="PROGRAM", help="what measures (%(default)s)",
                        default=MEASURE)
    parser.add_argument("-o", "--output", type=Path, metavar="FILE.md", help="write the report there as well")


def measure_of(options: argparse.Namespace) -> Measure:
    """As the options say"""
    if min(options.timeout, options.memory, vars(options).get("repeat", 1)) <= 0:
        raise SystemExit("--repeat, --timeout and --memory take numbers above 0")
    if options.measure == MEASURE:
        build("measure")
    elif not options.measure.is_file():
        raise SystemExit(f"there is no program '{options.measure}'")
    return Measure(options.measure.resolve(), options.timeout, options.memory)
