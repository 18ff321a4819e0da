# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an atlas of each OFF and OBJ file of a folder with Dask, several at a time, with limits of time and memory.
Atlases that are newer than their model are not made again: atlases_of_folder.py FOLDER OUTPUT_FOLDER [SECONDS
[MEGABYTES]]"""

import sys
from pathlib import Path

import dask
from dask.distributed import Client, LocalCluster, as_completed
from one_model import make_atlas


## [main]
def main(folder, outputs, seconds="60", megabytes="2000"):
    outputs.mkdir(parents=True, exist_ok=True)
    files = sorted(file for file in folder.iterdir() if file.suffix in (".off", ".obj"))
    dask.config.set({"distributed.scheduler.worker-saturation": 1})  # no model waits for a worker that may be killed
    with LocalCluster(threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        futures = {client.submit(make_atlas, file, outputs / f"{file.stem}.obj", float(seconds), int(megabytes),
                                 pure=False): file for file in files}
        for future in as_completed(futures):
            error = future.exception()  # of a model that ended four workers, one after the other
            print(f"{futures[future].name}: {type(error).__name__ if error else future.result()}", flush=True)
## [main]


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
