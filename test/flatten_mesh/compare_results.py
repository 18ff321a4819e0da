# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the results of flatten_mesh for about 40 models, in all ways to flatten, and compares those of two versions.
Usage: compare_results.py make PROGRAM FOLDER [--models FOLDER...] [--only WORD] [--jobs N]
       compare_results.py compare OLD_FOLDER NEW_FOLDER

`make` flattens generated models, and, with --models, those of other folders that are in the list below (CGAL's
meshes, which the tests unpack, and the disks). `compare` names all that differs: files that are not there, statuses,
messages, members of the reports, and numbers: in reports by more than 1e-9 of themselves or of 1, in GLB by more
than the rounding of `float`, and in texts by more than 1e-9 of the largest one in lines that begin with the same
word. Seconds, memory and the version may differ. Its exit status is 1 if anything differs."""

import argparse
import concurrent.futures
import gzip
import json
import math
import os
import random
import re
import shutil
import struct
import subprocess
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import test_dirt  # noqa: E402
import test_mutations  # noqa: E402
from shapes import strip, terrain  # noqa: E402

TOLERANCE = 1e-9
NAMES = """cow homer camel elephant fandisk anchor_dense rotor pig bones mushroom bear dragknob helmet hand femur knot1
couplingdown joint part 3torus holes elephant-with-holes mask_cone lion-head cube_poly torus_quad mesh_with_colors
hedra_open armadillo man turbine cow_disk dino_disk camel_disk""".split()
LARGE = 15000  # triangles, above which models are flattened in fewer ways

# Names of ways, and the options of each run; {m} is the model. Outputs follow from the names of the files.
MAIN = {"texture": "-o o.obj --svg o.svg --seams-to o.selection.txt",
        "few-charts": "--for few-charts -o o.glb",
        "conformal": "--for conformal -o o.ply",
        "repack": "@texture/o.obj --repack -o o.obj",
        "plain": "--plain -o o.obj --svg o.svg --seams-to o.selection.txt",
        "hierarchical": "--plain --method hierarchical -o o.obj",
        "injective": "--plain --injective -o o.obj"}
MORE = {"creases": "--seams creases -o o.obj",
        "near-creases": "--seams near-creases -o o.obj",
        "hidden": "--seams hidden -o o.obj",
        "materials": "--charts-from-materials -o o.glb",
        "seams-from-uv": "@texture/o.obj --seams-from uv -o o.obj",
        "seams-from-file": "--seams-from @texture/o.selection.txt --for few-charts -o o.obj",
        "repair-charts": "@plain/o.obj --repack --repair-charts -o o.obj",
        "pages": "--texels-per-unit {density} --resolution 256 --block 4 -o o.obj --chart-image page_<UDIM>.png",
        "not-packed": "--no-pack --for conformal -o o.obj",
        "world": "--units world --rotations 8 --mip-levels 2 --resolution 512x256 -o o.obj",
        "second": "@texture/o.obj --uv-set 1 --for few-charts -o o.glb",
        "baked": "@plain/o.obj --simplify 300 --bake-from {m} --resolution 128 -o o.obj",
        "page": "--report o.html --picture o.png --for few-charts",
        "not-repaired": "--repair off --weld off -o o.obj",
        "one-atlas": "@plain/o.obj --one-atlas {m} -o %.obj --report o.html",
        "plain-direct-injective": "--plain --injective --method direct -o o.obj",
        "plain-polished": "--plain --injective --polish --area-weight 0.05 -o o.obj",
        "plain-rectangle": "--plain --rectangle auto -o o.obj",
        "plain-cones": "--plain --cones 6 --cone-angle-multiple 90 -o o.obj",
        "plain-filled": "--plain --holes fill -o o.obj",
        "plain-split": "--plain --split-overlaps -o o.obj",
        "plain-paper": "--plain --barrier 0 --step sqp --linear-solver direct --layout least-squares -o o.obj",
        "plain-eigen": "--plain --solver eigen --cut topology --equal-seams on -o o.obj",
        "plain-swept": "--plain --method hierarchical --simplification-rate 0.8 --angle-sweeps 3 -o o.obj"}


def generated(folder):
    """Writes models, and returns their paths."""
    generator = random.Random(58)
    rough, moebius = terrain(20, lambda i, j: generator.uniform(0, 2)), strip(1, 40, 1)
    surfaces = {"terrain": rough, "moebius": moebius, "ring": strip(2, 30, 2),
                **dict(zip(("torus", "octahedron", "sheet"), test_mutations.surfaces()))}
    both = [(x + 9, y, z) for x, y, z in rough[0]]
    surfaces["several"] = (moebius[0] + both, moebius[1] + [tuple(v + len(moebius[0]) for v in f) for f in rough[1]])
    points, faces = rough
    surfaces["dirty"] = (points + [(math.nan, 0, 0), (1e20, 0, 0)],
                         faces + [faces[3], faces[5][::-1], (0, 1, 400), (0, 1, 401), (0, 0, 1), (5, 25, 200)])
    files = []
    for name, (points, faces) in surfaces.items():
        files.append(folder / f"{name}.obj")
        files[-1].write_text(test_dirt.WRITERS["obj"](points, faces))
    files.append(folder / "scene.glb")
    files[-1].write_bytes(test_dirt.gltf(True))
    files.append(folder / "bits.stl")
    files[-1].write_bytes(test_dirt.binary_stl(*surfaces["sheet"]))
    return files


def run(program, model, folder, name, options):
    """Runs the program in a folder of its own; only what `{m}` and `@` stand for is outside."""
    place = folder / model.stem / name
    place.mkdir(parents=True)
    path = f"../../models/{model.name}"  # the same in the results of all versions
    words = options.replace("{m}", path).replace("@", "../").split()
    if "{density}" in options:
        report = json.loads((folder / model.stem / "texture" / "o.json").read_text())
        density = ((report.get("atlas") or {}).get("packing") or {}).get("texels_per_unit") or 100
        words = [word.replace("{density}", repr(density / 2)) for word in words]
    given = [] if words[0].startswith("../") else [path]
    command = [program, *given, *words, "--json", "o.json", "--threads", "1"]
    done = subprocess.run(command, cwd=place, capture_output=True, timeout=900, check=False)
    (place / "status.txt").write_bytes(b"%d\n%s" % (done.returncode, done.stderr))


def make_model(program, model, folder):
    ways = dict(MAIN)
    if model.stat().st_size < LARGE * 45:  # bytes of a triangle in OFF and OBJ
        ways.update(MORE)
    if model.stem in ("pig", "torus"):
        ways["symmetric"] = "--symmetric -o o.obj"
    for name, options in ways.items():
        run(program, model, folder, name, options)
    for file in list((folder / model.stem).rglob("*.*")):
        if file.stat().st_size > 10000:
            with gzip.open(f"{file}.gz", "wb", compresslevel=3) as compressed:
                compressed.write(file.read_bytes())
            file.unlink()


def make(program, folder, models, only, jobs):
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    inputs = folder / "models"
    inputs.mkdir(parents=True)
    files = generated(inputs)
    files += [Path(shutil.copy(file, inputs)) for source in models for file in sorted(Path(source).iterdir())
              if file.stem in NAMES and file.suffix in (".off", ".ply")]
    files = [file for file in files if only in file.stem]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for result in [pool.submit(make_model, program, file, folder) for file in files]:
            result.result()
    print(f"{len(files)} models")


def content(file):
    return gzip.open(file, "rb").read() if file.suffix == ".gz" else file.read_bytes()


def differences_of_json(old, new, place=""):
    """Places where two reports differ; of two numbers, if by more than the tolerance"""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() | new.keys()):
            if key not in ("seconds", "peak_memory_mb", "version", "generator"):
                yield from differences_of_json(old.get(key, "nothing"), new.get(key, "nothing"), f"{place}/{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for i, pair in enumerate(zip(old, new)):
            yield from differences_of_json(*pair, f"{place}/{i}")
    elif isinstance(old, float) and isinstance(new, (int, float)):
        # Reports have errors, such as residuals, that are rounding themselves.
        if abs(old - new) > TOLERANCE * max(abs(old), 1):
            yield f"{place}: {old!r}, now {new!r}"
    elif old != new:
        yield f"{place}: {str(old)[:80]!r}, now {str(new)[:80]!r}"


NUMBER = re.compile(r"-?[0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?")


def differences_of_text(old, new):
    if old == new:
        return
    if NUMBER.sub("#", old) != NUMBER.sub("#", new):
        yield "other words or lines"
        return
    largest, most = Counter(), Counter()  # of the lines with the same first word, such as 'vt'
    for old_line, new_line in zip(old.split("\n"), new.split("\n")):
        kind = NUMBER.sub("#", old_line).split(" ")[0]
        for a, b in zip(NUMBER.findall(old_line), NUMBER.findall(new_line)):
            largest[kind] = max(largest[kind], abs(float(a)))
            most[kind] = max(most[kind], abs(float(a) - float(b)))
    for kind, size in largest.items():
        if most[kind] > TOLERANCE * size:
            yield f"a number of a line {kind!r} differs by {most[kind]}, where the largest is {size}"


def by_corners(text):
    """An OBJ file with the texture coordinates of each corner on a line of its own: their order and numbers are free"""
    lines, uv = [], []
    for line in text.split("\n"):
        word, *rest = line.split() or [""]
        if word == "vt":
            uv.append(" ".join(rest))
        elif word == "f":
            corners = [(corner + "//").split("/") for corner in rest]
            lines.append(" ".join(["f", *(f"{v}/{n}" for v, _, n, *_ in corners)]))
            lines += [f"corner {uv[int(t) - 1] if t else ''}" for _, t, *_ in corners]
        elif not line.startswith("#"):
            lines.append(line)
    return "\n".join(lines)


def glb(data):
    """The JSON of a GLB file, and its other chunk as numbers"""
    length = struct.unpack_from("<I", data, 12)[0]
    rest = data[28 + length:]
    return json.loads(data[20:20 + length]), struct.unpack(f"<{len(rest) // 4}f", rest[:len(rest) // 4 * 4])


def differences_of_glb(old, new):
    (old_json, old_numbers), (new_json, new_numbers) = glb(old), glb(new)
    yield from differences_of_json(old_json, new_json)
    if len(old_numbers) != len(new_numbers):
        yield "another size"
    elif any(a != b and not abs(a - b) <= 2e-7 * max(abs(a), 1) for a, b in zip(old_numbers, new_numbers)):
        yield "other numbers"


def differences(name, old, new):
    if old == new:
        return []
    if name.endswith(".json"):
        return differences_of_json(json.loads(old), json.loads(new))
    if name.endswith(".glb"):
        return differences_of_glb(old, new)
    if name.endswith((".png", ".html")):
        return ["other bytes"]
    old, new = old.decode("utf-8", "replace"), new.decode("utf-8", "replace")
    return differences_of_text(by_corners(old), by_corners(new)) if name.endswith(".obj") \
        else differences_of_text(old, new)


def compare(old_folder, new_folder):
    old, new = ({str(file.relative_to(folder)).removesuffix(".gz"): file for file in folder.rglob("*.*")
                 if file.is_file()} for folder in (old_folder, new_folder))
    different = 0
    for name in sorted(old.keys() | new.keys()):
        found = [f"only in {old_folder if name in old else new_folder}"] if name not in old or name not in new \
            else list(differences(name, content(old[name]), content(new[name])))
        different += bool(found)
        for text in found[:5]:
            print(f"{name}: {text}")
        if len(found) > 5:
            print(f"{name}: {len(found) - 5} more")
    print(f"{len(old)} files, {different} different")
    return 1 if different or not old else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    maker, comparer = commands.add_parser("make"), commands.add_parser("compare")
    maker.add_argument("program")
    maker.add_argument("folder", type=Path)
    maker.add_argument("--models", nargs="*", default=[])
    maker.add_argument("--only", default="")
    maker.add_argument("--jobs", type=int, default=2)
    comparer.add_argument("old", type=Path)
    comparer.add_argument("new", type=Path)
    options = parser.parse_args()
    if options.command == "compare":
        return compare(options.old, options.new)
    make(str(Path(options.program).resolve()), options.folder.resolve(), options.models, options.only, options.jobs)
    return 0


if __name__ == "__main__":
    sys.exit(main())
