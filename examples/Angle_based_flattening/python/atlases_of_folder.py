# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an atlas of each OFF and OBJ file of a folder, several at a time, with limits of time and memory. Atlases that
are newer than their model are not made again: atlases_of_folder.py FOLDER OUTPUT_FOLDER [SECONDS [MEGABYTES]]"""

import functools
import resource
import sys
from pathlib import Path

import angle_based_flattening as abf
from dask.distributed import Client, LocalCluster, as_completed
from mesh_files import read, write_obj


def prepare_worker(folder, megabytes):
    """Beyond the limit of memory, a model is an error, and its worker goes on."""
    sys.path.append(folder)
    resource.setrlimit(resource.RLIMIT_DATA, (megabytes * 1024**2, resource.RLIM_INFINITY))


## [make_atlas]
def make_atlas(file, output, seconds):
    """What became of a model. Errors of a model do not end the others."""
    if output.exists() and output.stat().st_mtime >= file.stat().st_mtime:
        return "is there"
    try:
        vertices, faces = read(file)
        atlas = abf.atlas(vertices, faces, threads=1, timeout=seconds)
    except (ValueError, TimeoutError, MemoryError) as error:
        return f"{type(error).__name__}: {error}"
    part = output.with_suffix(".part")  # a worker that is killed leaves no half of an output
    write_obj(part, vertices, faces, atlas.uv)
    part.replace(output)
    return f"{atlas.face_chart.max() + 1} charts"
## [make_atlas]


def main(folder, outputs, seconds="60", megabytes="2000"):
    outputs.mkdir(parents=True, exist_ok=True)
    files = sorted(file for file in folder.iterdir() if file.suffix in (".off", ".obj"))
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        here = str(Path(__file__).resolve().parent)
        client.register_worker_callbacks(functools.partial(prepare_worker, here, int(megabytes)))
        futures = {client.submit(make_atlas, file, outputs / f"{file.stem}.obj", float(seconds), pure=False): file
                   for file in files}
        for future in as_completed(futures):
            error = future.exception()  # of a model that ended several workers, one after the other
            print(f"{futures[future].name}: {type(error).__name__ if error else future.result()}", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
