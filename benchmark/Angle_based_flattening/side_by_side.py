# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that are printed row by row, and programs with the time that they take."""

import os
import resource
import subprocess
import time


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def head(*titles):
    print()
    row(*titles)
    row("---", *["---:"] * (len(titles) - 1))


def run(*command):
    """The ended process of a command, whose output is kept, its seconds, and its processor time. The BLAS has one
    thread."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    process = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                             env=os.environ | {"OPENBLAS_NUM_THREADS": "1"})
    seconds, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    return process, seconds, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
