#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of the tutorial by its own commands, and a browser: draw_tutorial.py FLATTEN_MESH PICTURE_FOLDER."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import tutorial

ROOT = Path(__file__).resolve().parents[2]

# What the browser shows, as a file beside what the commands write; the size of the window; the picture
SHOTS = [("mask.png.html", (1100, 440), "tutorial_atlas.png"),
         ("look.html", (1560, 860), "tutorial_report.png")]


def main():
    program, pictures = map(Path, sys.argv[1:])
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not browser:
        print("no Chromium: the pictures of the tutorial stay as they are")
        return
    with tempfile.TemporaryDirectory() as folder:
        clone = tutorial.Clone(folder, ROOT, program.resolve())
        page = (ROOT / "doc/guides/tutorial.txt").read_text()
        for words in [content for kind, content in tutorial.steps(page) if kind == "command"][:4]:
            status, _, errors = clone.run(words)
            if status != 0:
                sys.exit(errors)
        (clone.folder / "mask.png.html").write_text(
            '<body style="margin:0"><img src="mask.png" style="display:block;width:100%"></body>')
        for file, (width, height), picture in SHOTS:
            subprocess.run([browser, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                            "--hide-scrollbars", "--force-device-scale-factor=1", "--virtual-time-budget=20000",
                            f"--window-size={width},{height}", f"--screenshot={(pictures / picture).resolve()}",
                            (clone.folder / file).as_uri()],
                           check=True, stderr=subprocess.DEVNULL)
            print(pictures / picture)


if __name__ == "__main__":
    main()
