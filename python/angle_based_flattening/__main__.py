"""The program ``flatten_mesh``: ``python -m angle_based_flattening ARGUMENTS``."""

import os
import sys

from . import _core


def main() -> None:
    """Runs the program, and ends the process: a regular exit might wait for threads that a failure left behind."""
    os._exit(_core.run_program(sys.argv[1:]))


if __name__ == "__main__":
    main()
