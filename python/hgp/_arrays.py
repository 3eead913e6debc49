"""Arrays as the core takes them: what differs is converted, what cannot be meant is refused by name."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._errors import UsageError


def _described(value: Any) -> str:
    if value.ndim == 0:
        return f"a single value of {value.dtype}"
    if value.ndim == 1:
        return f"an array of {value.size} values of {value.dtype}"
    return f"a {' × '.join(map(str, value.shape))} array of {value.dtype}"


def _array(value: Any, name: str, columns: int, what: str) -> "npt.NDArray[Any]":
    if isinstance(value, np.ma.MaskedArray) and bool(np.any(value.mask)):
        raise UsageError(f"{name} has masked entries; leave out their rows first", "arguments")
    try:
        array: "npt.NDArray[Any]" = np.asarray(value)
    except ValueError as error:  # rows of different lengths
        raise UsageError(f"{name} must be an n × {columns} array of {what}: {error}", "arguments") from error
    if array.ndim != 2 or array.shape[1] != columns:
        advice = ""
        if columns == 3 and what == "vertex numbers" and array.ndim == 2 and array.shape[1] == 4:
            advice = f"; for quads, pass np.vstack([{name}[:, [0, 1, 2]], {name}[:, [0, 2, 3]]])"
        raise UsageError(
            f"{name} must be an n × {columns} array of {what}, not {_described(array)}{advice}", "arguments"
        )
    return array


def reals(value: Any, name: str, columns: int) -> "npt.NDArray[np.float64]":
    """An n × columns array of float64 in C order; the same object if it is one already."""
    array = _array(value, name, columns, "real numbers")
    if array.dtype.kind not in "fiu":
        raise UsageError(f"{name} must have real numbers, not {array.dtype}", "arguments")
    return np.ascontiguousarray(array, dtype=np.float64)


def triangles(value: Any, name: str) -> "npt.NDArray[Any]":
    """An n × 3 array of int32 or int64 in C order; the same object if it is one already."""
    return integers(value, name, 3)


def integers(value: Any, name: str, columns: int) -> "npt.NDArray[Any]":
    """Likewise n × columns."""
    array = _array(value, name, columns, "vertex numbers")
    if array.size == 0:
        return np.ascontiguousarray(array, dtype=np.int32)
    if array.dtype.kind not in "iu":
        advice = f"; {name}.astype(int) converts" if array.dtype.kind == "f" else ""
        raise UsageError(f"{name} must have integers, not {array.dtype}{advice}", "arguments")
    if array.dtype.kind == "u" and array.dtype.itemsize == 8 and int(array.max()) > np.iinfo(np.int64).max:
        raise UsageError(f"{name} has the vertex number {int(array.max())}", "arguments")
    wide = array.dtype.itemsize > 4 or array.dtype == np.uint32
    return np.ascontiguousarray(array, dtype=np.int64 if wide else np.int32)
