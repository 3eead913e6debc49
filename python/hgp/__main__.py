"""The command line: `python3 -m hgp param mesh.obj -o mapped.obj` (docs/cli.md)."""

from __future__ import annotations

import sys

from ._core import run_command_line


def main() -> int:
    """Runs the command line with the words of sys.argv, and returns the exit code."""
    return run_command_line(["hgp", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
