"""The program ``flatten_mesh``: ``python -m angle_based_flattening ARGUMENTS``."""

import sys

from . import _core


def main() -> int:
    """Runs the program, and returns its exit status."""
    return _core.run_program(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
