# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the atlas of one file, within limits: what workers of Dask and Ray do."""

import math
import resource
import signal

import angle_based_flattening as abf
from mesh_files import read, write_obj


## [make_atlas]
def make_atlas(file, output, seconds, megabytes):
    """What became of a model. Errors of a model do not end the others."""
    if output.exists() and output.stat().st_mtime >= file.stat().st_mtime:
        return "is there"
    resource.setrlimit(resource.RLIMIT_DATA, (megabytes * 1024**2, resource.RLIM_INFINITY))
    signal.alarm(10 + 2 * math.ceil(seconds))  # ends the worker where something hangs that has no timeout
    try:
        vertices, faces = read(file)
        atlas = abf.atlas(vertices, faces, threads=1, timeout=seconds)
        write_obj(output, vertices, faces, atlas.uv)  # a worker that is killed leaves no half of an output
    except (ValueError, TimeoutError, MemoryError) as error:
        return f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)
    return f"{atlas.face_chart.max() + 1} charts"
## [make_atlas]
