# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an atlas of each OFF and OBJ file of a folder with Ray, several at a time, with limits of time and memory.
Atlases that are newer than their model are not made again: atlases_of_folder_ray.py FOLDER OUTPUT_FOLDER [SECONDS
[MEGABYTES]]"""

import sys
from pathlib import Path

import ray
from one_model import make_atlas


## [main]
def main(folder, outputs, seconds="60", megabytes="2000"):
    outputs.mkdir(parents=True, exist_ok=True)
    files = sorted(file for file in folder.iterdir() if file.suffix in (".off", ".obj"))
    ray.init(include_dashboard=False, log_to_driver=False)
    task = ray.remote(num_cpus=1, memory=int(megabytes) * 1024**2, max_retries=3)(make_atlas)
    waiting = {task.remote(file, outputs / f"{file.stem}.obj", float(seconds), int(megabytes)): file for file in files}
    while waiting:
        (done,), _ = ray.wait(list(waiting))
        try:
            result = ray.get(done)
        except ray.exceptions.RayError as error:  # of a model that ended four workers, one after the other
            result = type(error).__name__
        print(f"{waiting.pop(done).name}: {result}", flush=True)
## [main]


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
