# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a command with limits, and writes what it used: confined.py SECONDS GIGABYTES FILE.json COMMAND... It is a small
process of its own, because the peak memory of a process includes that of the process that started it."""

import json
import math
import os
import resource
import signal
import sys
import time


def main():
    limit, gigabytes, file = float(sys.argv[1]), float(sys.argv[2]), sys.argv[3]
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.execvp(sys.argv[4], sys.argv[4:])
    begin, why = time.monotonic(), ""
    while True:
        process, status, used = os.wait4(child, os.WNOHANG)
        if process:
            break
        time.sleep(.05)
        with open(f"/proc/{child}/statm", encoding="ascii") as statm:
            pages = (statm.read().split() or [0, 0])[1]
        if int(pages) * resource.getpagesize() > gigabytes * 2**30:
            why = f"did not end: more than {gigabytes:g} GB"
        elif time.monotonic() - begin > 10 * limit:
            why = "did not end: it waits"
        if why:
            os.kill(child, 9)
    code, seconds = os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime
    if code < 0 and not why:
        why = f"did not end in {limit:g} s" if -code == signal.SIGXCPU else f"crashed by signal {-code}"
    with open(file, "w", encoding="ascii") as report:
        json.dump({"failure": why, "seconds": seconds, "megabytes": used.ru_maxrss / 1024}, report)


if __name__ == "__main__":
    main()
