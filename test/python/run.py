# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tests with pytest, and ends with 77 if what they need is not there: run.py FILE..."""

import sys
from pathlib import Path

try:
    import numpy  # noqa: F401
    import pytest
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

here = Path(__file__).resolve().parent
files = [str(here / name) for name in sys.argv[1:]]
sys.exit(pytest.main(["-q", "-rs", "--durations=5", "-p", "no:cacheprovider", "--rootdir", str(here), *files]))
