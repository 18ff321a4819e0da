# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the manual and of README.md, and a folder that looks like a clone to run them in."""

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

DATA = "examples/Angle_based_flattening/data"


def steps(page):
    """The code blocks of a page in their order: ("command", words) for each command, ("output", lines) for what is printed."""
    found = []
    for kind, text in re.findall(r"\\code\{\.(sh|unparsed)\}\n(.*?)\\endcode", page, re.S):
        if kind == "sh":
            found += [("command", words) for words in commands(text)]
        else:
            found.append(("output", text.splitlines()))
    return found


def commands(text):
    """The words of each command of a shell script of plain commands."""
    lines = text.replace("\\\n", " ").splitlines()
    return [words for words in (shlex.split(line, comments=True) for line in lines) if words]


def write_script(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


class Clone:
    """Runs commands as if in a clone of the repository, with a program that is built already.

    scripts/flatten is that of the repository. What it calls to install and to build does nothing."""

    def __init__(self, folder, source, program):
        self.folder, self.source, self.program = Path(folder), Path(source), Path(program)

    def make(self):
        for name in ("scripts/flatten", "scripts/common.bash"):
            write_script(self.folder / name, (self.source / name).read_text())
        for name in ("scripts/install-dependencies", "tools/cmake"):
            write_script(self.folder / name, "#!/bin/sh\n")
        write_script(self.folder / "build/apps/flatten_mesh/flatten_mesh",
                     f'#!/bin/sh\nexec {shlex.quote(str(self.program))} "$@"\n')
        shutil.copytree(self.source / DATA, self.folder / DATA)

    def run(self, words):
        """Its exit status, and what it prints. An unknown command is an error."""
        if words[:2] == ["git", "clone"] and len(words) == 4:
            self.folder = self.folder / words[3]
            self.make()
        elif words[0] == "cd" and len(words) == 2:
            if self.folder.name != words[1]:
                raise ValueError(f"{words[1]} is not the clone")
        elif words[0] == "scripts/flatten":
            environment = {**os.environ, "PATH": f"{self.folder / 'tools'}{os.pathsep}{os.environ['PATH']}"}
            done = subprocess.run(words, cwd=self.folder, env=environment, capture_output=True, text=True, timeout=600)
            return done.returncode, done.stdout, done.stderr
        else:
            raise ValueError(f"an unknown command: {shlex.join(words)}")
        return 0, "", ""


def outputs(words):
    """The names of the files that a command writes."""
    named = ("--output", "-o", "--picture", "--svg", "--json", "--seams-to", "--report", "--chart-image")
    return [value for option, value in zip(words, words[1:]) if option in named]
