"""`hgp-batch`: batches on the command line (docs/batch.md)."""

from __future__ import annotations

import argparse
import sys
from typing import Any, Dict, List, Optional

from ._batch import Row, batch
from ._errors import HgpError

EXAMPLES = """examples:
  hgp-batch meshes -o mapped --improve isometric --time-limit 600
  hgp-batch meshes -o mapped --scheduler tcp://10.0.0.1:8786
"""


def _improve(word: str) -> Any:
    try:
        return float(word)
    except ValueError:
        return word


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        "hgp-batch", description="Maps every mesh of many files, and continues where it stopped.", epilog=EXAMPLES
    )
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("paths", nargs="+", metavar="PATH", help="files, or folders that are searched")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER", help="for maps, reports, table and page")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="a Dask scheduler (default: processes of this machine)")
    parser.add_argument("--workers", type=int, metavar="N", help="local processes (default: one per core)")
    parser.add_argument("--threads", type=int, metavar="N", help="of each process, 1 to 16 (default: 1)")
    parser.add_argument("--format", choices=["obj", "glb"], help="of the maps (default: that of the file)")
    parser.add_argument("--table", default="results.csv", metavar="NAME", help="name.csv or name.parquet")
    parser.add_argument("--memory-limit", type=float, metavar="MB", help="of address space, per file")
    parser.add_argument("--hard-limit", type=float, metavar="SECONDS", help="kill the process of a file after this time")
    parser.add_argument("--quiet", action="store_true", help="print errors only")
    solve = parser.add_argument_group("as for hgp param")
    solve.add_argument("--q", type=int)
    solve.add_argument("--count", type=int, metavar="N")
    solve.add_argument("--cones-for", choices=["balanced", "few", "fewer", "more", "low-distortion"])
    solve.add_argument("--improve", type=_improve, metavar="isometric|conformal|area|X")
    solve.add_argument("--cells", type=float, metavar="N")
    solve.add_argument("--grid", type=float, metavar="LENGTH")
    solve.add_argument("--grid-mode", choices=["tile", "quad"])
    solve.add_argument("--scale", choices=["solved", "unit", "fit"])
    solve.add_argument("--time-limit", type=float, metavar="SECONDS")
    solve.add_argument("--refine", action="store_true", default=None)
    solve.add_argument("--reproducible", action="store_true", default=None)
    solve.add_argument("--strict", action="store_true", default=None)
    solve.add_argument("--embed-cones", action="store_true", default=None)
    return parser


def _line(row: Row, done: int, total: int) -> None:
    verdict = "certified" if row["certified"] else f"{row['code']}: {row['message']}"
    print(f"[{done}/{total}] {row['file']}: {verdict}", file=sys.stderr, flush=True)


def main(words: Optional[List[str]] = None) -> int:
    """Runs the command line; exit code 0 if every mesh has a certified map, else 6."""
    asked: Dict[str, Any] = {name: value for name, value in vars(_parser().parse_args(words)).items() if value is not None}
    paths, out, is_quiet = asked.pop("paths"), asked.pop("output"), asked.pop("quiet")
    if "memory_limit" in asked:
        asked["memory_limit"] = int(asked["memory_limit"] * 1e6)
    try:
        done = batch(paths, out, on_row=None if is_quiet else _line, **asked)
    except HgpError as error:
        print(f"hgp-batch: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("hgp-batch: interrupted; the same command continues", file=sys.stderr)
        return 130
    print(f"{done.certified} of {len(done.rows)} meshes certified; {done.kept} files were done before: {done.folder}/index.html")
    return 0 if done.certified == len(done.rows) else 6


if __name__ == "__main__":
    sys.exit(main())
