"""One table of options: what the command line has, Python has as well."""

from __future__ import annotations

import inspect
import os
import pathlib
import re
import subprocess
import sys
from typing import Any, Set

import pytest

import hgp

ROWS = hgp._core.option_rows()
CALLS = {"load": hgp.Mesh.load, "solve": hgp.Mesh.parametrize, "verify": hgp.Mesh.verify, "write": hgp.Map.save}
#: Options of the command line that concern its files and messages, with what does the same in Python.
ELSEWHERE = {
    "--also": hgp.Map.save,
    "--balance": hgp.Mesh.balance_cones,
    "--color": None,
    "--compress": hgp.Map.save,
    "--cone": hgp.Mesh.parametrize,
    "--convert": hgp.Mesh.convert_cones,
    "--embed": hgp.Map.save,
    "--faces": hgp.Map.distortion,
    "--force": hgp.Map.save,
    "--format": None,
    "--from": hgp.Mesh.transfer_cones,
    "--handle": hgp.Mesh.parametrize,
    "--help": None,
    "--json": hgp.Map.report,
    "--loops": hgp.Mesh.loops,
    "--no-progress": hgp.Mesh.parametrize,
    "--output": hgp.Map.save,
    "--quality": hgp.Mesh.parametrize,
    "--quiet": None,
    "--suggest": hgp.Mesh.suggest_cones,
    "--threads": hgp.set_threads,
    "--transfer": hgp.Mesh.transfer_cones,
    "--xref": hgp.Map.uv_to_vertex,
}


def keywords(call: Any) -> Set[str]:
    return set(inspect.signature(call).parameters)


def flags() -> Set[str]:
    """Every option of every command."""
    found: Set[str] = set()
    for command in ("inspect", "check", "cones", "features", "param", "quads", "verify"):
        words = [sys.executable, "-m", "hgp", command, "--help"]
        environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(hgp._core.__file__).parents[1])}
        folder = pathlib.Path(hgp._core.__file__).parent  # not one with the sources of the package
        ran = subprocess.run(words, capture_output=True, text=True, check=True, env=environment, cwd=folder)
        for names in re.findall(r"^  (-[-a-z,]+)", ran.stdout, re.M):
            found |= {name for name in names.split(",") if name.startswith("--")}
    return found


@pytest.mark.parametrize(("call", "name", "flag", "keyword"), [row[:4] for row in ROWS])
def test_every_option_of_the_core_is_a_keyword(call: str, name: str, flag: str, keyword: str) -> None:
    if keyword == "quality" or (call, name) == ("write", "format"):
        return  # improve="isometric"; the extension of the path
    assert keyword in keywords(CALLS[call]), (name, flag)


def test_every_option_of_the_command_line_is_somewhere_in_python() -> None:
    rows = {row[2]: row[3] for row in ROWS}
    of_calls = set().union(*(keywords(call) for call in CALLS.values()), keywords(hgp.Mesh.suggest_cones))
    found = flags()
    assert len(found) > 40, found
    missing = []
    for flag in sorted(found):
        keyword = rows.get(flag) or flag[2:].replace("-", "_")
        if keyword not in of_calls and flag not in ELSEWHERE:
            missing.append(flag)
    assert missing == []


def test_the_words_of_the_annotations_are_those_of_the_table() -> None:
    for call, name, _, keyword, words in ROWS:
        if not words or keyword not in keywords(CALLS[call]):
            continue
        annotation = inspect.signature(CALLS[call], eval_str=True).parameters[keyword].annotation
        quoted = set(re.findall(r"'([A-Za-z-]+)'", str(annotation)))
        assert quoted == set(words), name


def test_polygons_can_be_asked_to_be_convex(tmp_path: Any) -> None:
    path = tmp_path / "cube.obj"
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {a} {b} {c} {d}\n" for a, b, c, d in faces)
    path.write_text(text)
    m = hgp.Mesh.load(path).parametrize(convex_polygons=True)
    assert m.certified
    assert m.report["options"]["convexPolygons"] is True


def test_features_are_straight(square: Any, tmp_path: Any) -> None:
    V, F = square
    m = hgp.parametrize(V, F, rims=True)
    assert m.certified and m.report["certificate"]["features"]["straightEdges"] > 0
    file = tmp_path / "edges.txt"
    file.write_text(f"{F[0][0]} {F[0][1]}\n")
    assert hgp.parametrize(V, F, features=file).report["certificate"]["features"]["straightEdges"] > 0
    assert "features" in hgp.parametrize(V, F, creases=True).report["certificate"]
    with pytest.raises(hgp.UsageError, match="marked must be of 'lines'"):
        hgp.parametrize(V, F, marked=["seams"])  # type: ignore[list-item]
    with pytest.raises(hgp.UsageError, match="creases must be True or an angle between 0 and 180"):
        hgp.parametrize(V, F, creases=200)
    with pytest.raises(hgp.MalformedError, match="edges.txt"):
        file.write_text("a b c\n")
        hgp.parametrize(V, F, features=file)
