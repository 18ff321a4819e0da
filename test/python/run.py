# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tests with pytest, and ends with 77 if what they need is not there: run.py [--python PYTHON] FILE..."""

import os
import sys
from pathlib import Path

if sys.argv[1] == "--python":
    if not Path(sys.argv[2]).exists():
        print(f"skipped: no {sys.argv[2]}")
        sys.exit(77)
    os.execv(sys.argv[2], [sys.argv[2], sys.argv[0], *sys.argv[3:]])

try:
    import numpy  # noqa: F401
    import pytest
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

here = Path(__file__).resolve().parent
files = [str(here / name) for name in sys.argv[1:]]
sys.exit(pytest.main(["-q", "-rs", "--durations=5", "-p", "no:cacheprovider", "--rootdir", str(here), *files]))
