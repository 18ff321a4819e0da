# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads, interruption, limits of time, progress, and memory."""

import os
import signal
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import angle_based_flattening as abf
import meshes
import numpy as np
import program
import pytest

LONG = meshes.torus(200, 132)  # seconds
SMALL = meshes.hill(5)
EXPECTED = abf.atlas(*SMALL).uv


@pytest.fixture(autouse=True)
def works_afterwards():
    yield
    assert program.same_bits(abf.atlas(*SMALL).uv, EXPECTED)


def test_other_threads_go_on():
    """A thread that holds the interpreter lock for a moment comes to it many times during a call."""
    moments, is_done = [0], threading.Event()

    def count():
        while not is_done.wait(.001):
            moments[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = moments[0]
    abf.atlas(*meshes.torus(40, 26))
    during = moments[0] - before
    is_done.set()
    thread.join()
    assert during > 10


def test_two_at_once():
    surfaces = [meshes.torus(seed=1), meshes.sphere(seed=2), meshes.hill(seed=3), meshes.box()] * 2
    one_by_one = [abf.atlas(*mesh) for mesh in surfaces]
    with ThreadPoolExecutor(2) as pool:
        at_once = list(pool.map(lambda mesh: abf.atlas(*mesh), surfaces))
    assert all(program.same_bits(a.uv, b.uv) for a, b in zip(one_by_one, at_once))


def test_a_flattener_at_work_is_refused():
    vertices, faces = meshes.hill(120)
    flattener = abf.Flattener(faces)
    errors = []

    def again(*_):
        try:
            flattener.solve(vertices)
        except RuntimeError as error:
            errors.append(str(error))

    flattener.solve(vertices, progress=again)
    assert errors and all("give each thread its own" in error for error in errors)


def test_interruption():
    def interrupt():
        time.sleep(.1)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    with pytest.raises(KeyboardInterrupt):
        thread.start()
        abf.atlas(*LONG)
    thread.join()


@pytest.mark.parametrize("function", [abf.atlas, abf.flatten])
def test_timeout(function):
    mesh = LONG if function is abf.atlas else meshes.hill(200)
    with pytest.raises(TimeoutError):
        function(*mesh, timeout=1e-3)


def test_progress():
    calls = []
    main = threading.get_ident()

    def progress(stage, share):
        assert threading.get_ident() == main
        calls.append((stage, share))

    abf.atlas(*LONG, progress=progress)
    assert calls and all(0 <= share <= 1 for _, share in calls)
    stages = [stage for stage, _ in calls]
    assert len(set(stages)) > 1 and set(stages) <= {"READ", "CHARTS", "PACK", "CERTIFY", "MEASURE", "WRITE"}
    assert stages == sorted(stages, key=["READ", "CHARTS", "PACK", "CERTIFY", "MEASURE", "WRITE"].index)


def test_cancellation():
    calls = []
    with pytest.raises(abf.Cancelled):
        abf.atlas(*LONG, progress=lambda *call: calls.append(call) or len(calls) < 2)
    assert len(calls) == 2


def test_errors_of_progress():
    class Oops(Exception):
        pass

    def progress(*_):
        raise Oops("in progress")

    with pytest.raises(Oops, match="in progress"):
        abf.atlas(*LONG, progress=progress)


def resident_kilobytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_memory():
    """A thousand calls of all that takes arrays, after some for caches to fill. Arrays of one round have 100 kB."""
    vertices, faces = meshes.hill(16)
    atlas = abf.atlas(vertices, faces)
    arrays = (vertices, faces, atlas.uv)

    def calls():
        abf.atlas(*SMALL, resolution=32, threads=1)
        abf.certify(*arrays)
        abf.measure(*arrays)
        atlas.unshared()
        with pytest.raises(abf.MeshError):
            abf.flatten(vertices, np.zeros((1, 3), int))
        with pytest.raises(ValueError):
            abf.atlas(vertices, faces + 1)

    for _ in range(20):
        calls()
    counts, before = list(map(sys.getrefcount, arrays)), resident_kilobytes()
    for _ in range(170):
        calls()
    assert list(map(sys.getrefcount, arrays)) == counts
    assert resident_kilobytes() - before < 6000
