"""Arrays are taken as they are, converted, or refused by name."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import hgp
from hgp._arrays import reals, triangles


def test_arrays_of_the_right_kind_are_not_copied() -> None:
    V, F = np.zeros((3, 3)), np.array([[0, 1, 2]])
    assert reals(V, "V", 3) is V
    assert triangles(F, "F") is F
    assert triangles(F.astype(np.int32), "F").dtype == np.int32


def test_results_are_views_that_cannot_be_written(square: Any) -> None:
    m = hgp.parametrize(*square)
    for array in (m.uv, m.fuv, m.vertices, m.triangles, m.uv_to_vertex):
        assert array.base is not None and array.flags.c_contiguous
        with pytest.raises(ValueError, match="read-only"):
            array.flat[0] = 1
    assert m.uv.ctypes.data == m.uv.ctypes.data
    assert (m.uv.dtype, m.fuv.dtype) == (np.float64, np.int32)


@pytest.mark.parametrize(
    "convert",
    [
        lambda V, F: (V.tolist(), F.tolist()),
        lambda V, F: (np.asfortranarray(V), np.asfortranarray(F)),
        lambda V, F: (V[::-1][::-1], F.astype(np.uint64)),
        lambda V, F: (V.astype(">f8"), F.astype(">i4")),
        lambda V, F: (V, F.astype(np.uint8)),
        lambda V, F: (np.ma.masked_array(V), F),
    ],
    ids=["lists", "Fortran order", "strides", "byte order", "short", "no mask"],
)
def test_other_arrays_are_converted(square: Any, convert: Any) -> None:
    assert (hgp.parametrize(*convert(*square)).uv == hgp.parametrize(*square).uv).all()


@pytest.mark.parametrize(
    ("V", "F", "message"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], "V must be an n × 3 array of real numbers, not a 3 × 2 array of float64"),
        (np.zeros((3, 3), complex), [[0, 1, 2]], "V must have real numbers, not complex128"),
        ([["a", "b", "c"]], [[0, 1, 2]], "V must have real numbers"),
        ([[0, 0, 0], [1, 0]], [[0, 1, 2]], "V must be an n × 3 array"),
        (np.eye(3), [[0.0, 1.0, 2.0]], r"F must have integers, not float64; F.astype\(int\) converts"),
        (np.eye(3), [[True, False, True]], "F must have integers, not bool"),
        (np.eye(3), [[0, 1, 2, 3]], r"for quads, pass np.vstack\(\[F\[:, \[0, 1, 2\]\]"),
        (np.eye(3), [0, 1, 2], "F must be an n × 3 array of vertex numbers, not an array of 3 values of int64"),
        (None, [[0, 1, 2]], "V must be an n × 3 array of real numbers, not a single value of object"),
        (np.zeros((0, 3)), [[0, 1, 2]], r"F\[0, 0\] is 0; there are no vertices"),
        (np.ma.masked_equal(np.eye(3), 1.0), [[0, 1, 2]], "V has masked entries"),
        (np.eye(3), [[0, 1, 3]], r"F\[0, 2\] is 3; indices are from 0 to 2"),
        (np.eye(3), [[0, -1, 2]], r"F\[0, 1\] is -1; indices are from 0 to 2"),
        (np.eye(3), [[2**32, 1, 2]], r"F\[0, 0\] is 4294967296; indices are from 0 to 2"),
        (np.eye(3), np.array([[2**32 - 1, 1, 2]], np.uint32), r"F\[0, 0\] is 4294967295"),
        (np.eye(3), np.array([[2**64 - 1, 1, 2]], np.uint64), "F has the vertex number 18446744073709551615"),
    ],
)
def test_arrays_that_cannot_be_meant_are_refused_by_name(V: Any, F: Any, message: str) -> None:
    with pytest.raises(hgp.UsageError, match=message):
        hgp.parametrize(V, F)


def test_a_wrong_index_names_its_triangle() -> None:
    with pytest.raises(hgp.UsageError) as caught:
        hgp.parametrize(np.eye(3), [[0, 1, 2], [0, 7, 1]])
    assert caught.value.places == (hgp.Place("triangle", 1),)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_positions_must_be_finite(square: Any, bad: float) -> None:
    V = square[0].copy()
    V[4, 1] = bad
    with pytest.raises(hgp.HgpError):
        hgp.parametrize(V, square[1])


def test_no_triangles_are_an_error_and_not_a_map() -> None:
    with pytest.raises(hgp.MalformedError, match="there are no triangles"):
        hgp.parametrize(np.zeros((0, 3)), np.zeros((0, 3), int))
