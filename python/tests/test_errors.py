"""Errors have the code, the place and the words of the command line."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest

import hgp


def test_each_code_has_its_class(square: Any, cube: Any, tmp_path: Any) -> None:
    V, F = square
    cases = [
        (hgp.UsageError, "usage", lambda: hgp.parametrize(V, F, q=0)),
        (hgp.MalformedError, "malformed", lambda: hgp.Mesh.load(tmp_path / "missing.obj")),
        (hgp.UnsupportedError, "unsupported", lambda: hgp.parametrize(V, np.vstack([F, F[:1, [1, 0, 2]]]), strict=True)),
        (hgp.PrescriptionError, "prescription", lambda: hgp.parametrize(*cube, cones={0: 3})),
        (hgp.WriteError, "write-failed", lambda: hgp.parametrize(V, F).save(tmp_path / "no/folder.obj")),
        (hgp.Cancelled, "cancelled", lambda: hgp.parametrize(V, F, progress=lambda p: False)),
        (hgp.NoMapError, "no-map", lambda: hgp.parametrize(V, F, time_limit=1e-9)),
    ]
    for kind, code, call in cases:
        with pytest.raises(kind) as caught:
            call()
        assert type(caught.value) is kind and caught.value.code == code
        assert isinstance(caught.value, hgp.HgpError) and caught.value.message == str(caught.value)


def test_errors_of_files_have_line_and_name(tmp_path: Any) -> None:
    path = tmp_path / "bad.obj"
    path.write_text("v 0 0 0\nv 1 0\n")
    with pytest.raises(hgp.MalformedError) as caught:
        hgp.Mesh.load(path)
    assert caught.value.places == (hgp.Place("line", 2),)
    assert caught.value.stage == "read"
    path = tmp_path / "large.obj"
    path.write_text("v 0 0 0\n" * 100)
    with pytest.raises(hgp.LimitError):
        hgp.Mesh.load(path, max_bytes=100)


def test_a_mesh_that_cannot_be_used_says_where() -> None:
    V = np.vstack([np.eye(3), -np.eye(3)])
    F = [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
    with pytest.raises(hgp.UnsupportedError) as caught:
        hgp.parametrize(V, F, strict=True)
    assert any(place.kind == "edge" and {place.id, place.other} == {0, 1} for place in caught.value.places)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"q": 65}, "q must be from 1 to 64, not 65"),
        ({"method": "fast"}, "method must be 'auto', 'harmonic'"),
        ({"cones_for": "many"}, "cones_for must be 'balanced'"),
        ({"improve": "all"}, "improve must be 'isometric'"),
        ({"improve": 2}, "improve must be"),
        ({"improve": float("nan")}, "improve must be"),
        ({"count": -3}, "count must be at least 0, not -3"),
        ({"cells": 0}, "cells must be at least 1"),
        ({"cells": 9, "grid": 1.0}, "cells and grid exclude each other"),
        ({"grid": -1.0}, "grid must be above 0, not -1.0"),
        ({"cells": "auto", "grid": 1.0}, "cells and grid exclude each other"),
        ({"cells": 9, "scale": "fit"}, "would undo a grid"),
        ({"boundary": "open"}, "boundary must be 'free', 'convex' or 'rectangle'"),
        ({"boundary": "convex", "cones": {}}, "cannot be combined"),
        ({"max_rounds": 0}, "max_rounds must be from 1 to 1000"),
        ({"time_limit": 0}, "time_limit must be"),
        ({"weld": "all"}, "weld must be"),
        ({"fix": ["holes"]}, "fix must be"),
        ({"strict": True, "fix": ["orient"]}, "exclude each other"),
        ({"cones": {0.5: 3}}, "cones must be a dictionary or pairs of integers: 0.5 is not an integer"),
        ({"cones": {2**40: 3}}, "is too large"),
        ({"cones": 7}, "cones must be a dictionary or pairs"),
        ({"progress": 7}, "progress must be a function"),
        ({"cells": 1e20}, r"cells must be at most 1e\+15, not 1e\+20"),
    ],
)
def test_wrong_options_are_refused_by_name(square: Any, options: Any, message: str) -> None:
    with pytest.raises(hgp.UsageError, match=message):
        hgp.parametrize(*square, **options)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"q": "4"}, "q must be an integer, not '4'"),
        ({"q": True}, "q must be an integer, not True"),
        ({"refine": 1}, "refine must be True or False, not 1"),
        ({"rims": "yes"}, "rims must be True or False, not 'yes'"),
        ({"reproducible": 1}, "reproducible must be True or False, not 1"),
        ({"time_limit": "2"}, "time_limit must be a number of seconds, not '2'"),
        ({"time_limit": True}, "time_limit must be a number of seconds, not True"),
        ({"Q": 4}, "unexpected keyword argument 'Q'"),
    ],
)
def test_options_of_the_wrong_type_are_type_errors(square: Any, options: Any, message: str) -> None:
    with pytest.raises(TypeError, match=message):
        hgp.parametrize(*square, **options)


def test_errors_survive_pickling(cube: Any) -> None:
    with pytest.raises(hgp.PrescriptionError) as caught:
        hgp.parametrize(*cube, cones={99: 3})
    again = pickle.loads(pickle.dumps(caught.value))
    assert type(again) is hgp.PrescriptionError
    assert (again.message, again.places, again.stage) == (
        caught.value.message,
        caught.value.places,
        caught.value.stage,
    )
