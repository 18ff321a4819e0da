#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parses each source and each header as a unit of its own: parse_alone.py BUILD_FOLDER [PART_OF_A_FILE_NAME...]

So a file that relies on what other files include is an error. The build folder has compile_commands.json of clang++,
for builds without precompiled headers and without unity builds.

Parsing CGAL for each of 700 files would take 5,100 seconds of processor time. Units that include the same of the
headers in SHARED, directly or by other headers, therefore read these from one precompiled header. And a header is
parsed before a unit that includes it, and all that it includes, in the same run of the compiler. Neither the
precompiled header nor the header before has anything that a unit does not include anyway, and so they hide no missing
include.
"""

import concurrent.futures
import functools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHARED = ("boost/test/unit_test.hpp", "Eigen/Core", "CGAL/Simple_cartesian.h", "CGAL/boost/graph/helpers.h",
          "CGAL/Exact_predicates_inexact_constructions_kernel.h", "CGAL/Eigen_sparse_matrix.h", "CGAL/Surface_mesh.h",
          "CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h",
          "CGAL/Texture_atlas/make_atlas.h")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
LEAST_UNITS = 8  # with fewer, precompiling takes longer than it saves
MUST_NOT_COMPILE = {ROOT / "test/Angle_based_flattening/without_SuperLU/default_solver.cpp",  # tests of errors
                    ROOT / "test/Texture_atlas/wrong_key_type.cpp"}


class Includes:
    """What the files of the repository include, directly or by other files of the repository"""

    def __init__(self, files, folders):
        self.texts = {file: file.read_text(encoding="utf-8") for file in files}
        self.names = {file: INCLUDE.findall(text) for file, text in self.texts.items()}
        self.folders = folders
        self.own = functools.cache(self.own)

    def own(self, folder, name):
        """The file of the repository that is included by this name in the folder, or None"""
        found = (Path(os.path.normpath(place / name)) for place in (folder, *self.folders))
        return next((path for path in found if path in self.texts), None)

    @functools.cache
    def all_of(self, file):
        """The names of all includes, and the files of the repository among them with the file itself"""
        names, seen, rest = set(), {file}, [file]
        while rest:
            includer = rest.pop()
            for name in self.names[includer]:
                names.add(name)
                other = self.own(includer.parent, name)
                if other is not None and other not in seen:
                    seen.add(other)
                    rest.append(other)
        return names, seen

    @functools.cache
    def defines_first(self, file):
        """Whether a file defines a macro before it includes anything, which may change what it includes"""
        return re.search(r"^\s*#\s*define\b(?!.*_H\b)", self.texts[file].split("#include")[0], re.M) is not None

    def shared(self, file):
        """The headers of SHARED among the includes"""
        names = () if self.defines_first(file) else self.all_of(file)[0]
        return tuple(name for name in SHARED if name in names)

    def can_follow(self, unit, header):
        """Whether a unit includes a header, directly or by others, and so may be parsed after it"""
        return (header.suffix == ".h" and header in self.all_of(unit)[1] and
                not self.defines_first(unit) and not self.defines_first(header))

    def chains(self, units, options):
        """Lists of units that are parsed one after the other"""
        found = []
        for unit in sorted(units, key=lambda unit: (len(self.all_of(unit)[1]), str(unit))):
            for chain in reversed(found):
                if self.can_follow(unit, chain[-1]) and set(options[chain[-1]]) <= set(options[unit]):
                    chain.append(unit)
                    break
            else:
                found.append([unit])
            found.sort(key=lambda chain: len(self.all_of(chain[-1])[1]))
        return found


def options_of_sources(folder):
    """The compiler and the options of each source in compile_commands.json"""
    options = {}
    for command in json.loads((folder / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(command["command"])
        output = words.index("-o")
        del words[output:output + 2]
        words.remove("-c")
        words.remove(command["file"])
        # Units that share precompiled headers have the same optimization, sanitizers, visibility and assertions: none.
        options.setdefault(Path(command["file"]), [word for word in words if not word.startswith(("-O", "-f", "-U"))])
    return options


def options_of_all(files, sources, includes):
    """The options of each file. A header has the options of a source that includes it, of the library if possible. A
    file that belongs to no target, because that is built elsewhere, has the options of the nearest source."""
    options = dict(sources)
    for source in sorted(sources, key=lambda file: (file.parts[len(ROOT.parts)] != "src", file)):
        for file in includes.all_of(source)[1]:
            options.setdefault(file, sources[source])
    for file in files:
        if file not in options:
            options[file] = sources[max(sorted(sources), key=lambda source: len(os.path.commonpath([source, file])))]
    return options


def parse(options, units, *more):
    """What the compiler says of units; nothing if they are right. They are compiled as a header, so that templates are
    not instantiated: instantiation takes two thirds of the time, and the builds do it."""
    command = [*options, "-Wall", "-Wextra", "-Werror", *more, "-x", "c++-header", "-", "-o", os.devnull]
    text = "".join(f'#include "{unit}"\n' for unit in units)
    return subprocess.run(command, input=text, text=True, capture_output=True, check=False).stderr.strip()


def precompile(shared, options, folder):
    """The options by which units read the headers that they share, with the definitions that all units have"""
    common = set.intersection(*(set(words) for words in options))
    header = folder / f"{len(list(folder.iterdir()))}.pch"
    text = "".join(f"#include <{name}>\n" for name in shared)
    words = [word for word in options[0] if word in common or not word.startswith("-D")]
    subprocess.run([*words, "-x", "c++-header", "-", "-o", str(header)], input=text, text=True, check=True)
    return ["-include-pch", str(header)]


def main():
    build, wanted = Path(sys.argv[1]), sys.argv[2:]
    files_but_concepts = ["git", "ls-files", "*.h", "*.cpp", ":!doc/*/Concepts/*"]  # concepts are for Doxygen alone
    listed = subprocess.run(files_but_concepts, cwd=ROOT, check=True, capture_output=True, text=True)
    files = [ROOT / name for name in listed.stdout.split() if ROOT / name not in MUST_NOT_COMPILE]
    sources = {file: words for file, words in options_of_sources(build).items() if file in files}
    includes = Includes(files, [ROOT / "include", ROOT / "apps", ROOT / "python/src"])

    options = options_of_all(files, sources, includes)

    shared = {file: includes.shared(file) for file in files
              if not wanted or any(part in str(file) for part in wanted)}
    counts = Counter(shared.values())
    kinds = sorted((kind for kind in counts if counts[kind] >= LEAST_UNITS), key=len)
    wrong, jobs = 0, int(os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count()))
    with (tempfile.TemporaryDirectory(dir=build) as folder, concurrent.futures.ThreadPoolExecutor(jobs) as pool):
        of_kind = {}
        for kind in filter(None, kinds):
            units = [file for file in shared if set(kind) <= set(shared[file])]
            of_kind[kind] = precompile(kind, [options[unit] for unit in units], Path(folder))

        def parse_chain(kind, chain):
            """What is wrong, by unit"""
            base = next((other for other in reversed(kinds) if set(other) <= set(kind)), ())
            more = of_kind.get(base, [])
            if not parse(options[chain[-1]], chain, *more):
                return {}
            messages = {unit: parse(options[unit], [unit], *more) for unit in chain}
            return {unit: message for unit, message in messages.items() if message}

        tasks = [pool.submit(parse_chain, kind, chain) for kind in counts
                 for chain in includes.chains([unit for unit in shared if shared[unit] == kind], options)]
        for task in concurrent.futures.as_completed(tasks):
            for unit, message in task.result().items():
                print(f"{unit.relative_to(ROOT)} does not compile alone:\n{message}\n", flush=True)
                wrong += 1
    print(f"{len(shared)} units parsed in {len(tasks)} runs with {len(of_kind)} precompiled headers, {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
