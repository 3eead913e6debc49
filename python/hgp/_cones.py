"""Prescriptions: cones, turnings of boundaries, rotations along handles."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Dict, Iterable, Iterator, List, Literal, Mapping, Optional, Tuple, Union, get_args

from ._documents import ConesDocument
from ._errors import UsageError
from ._features import FeaturesLike, listed
from ._options import flag


class Cones(Mapping[int, int]):
    """Cones as a mapping from vertex to k (the cone angle is 2πk/q), with everything else that a map needs.

    It cannot be changed: `dict(cones)` gives a dictionary that can, of the cones alone.

    Attributes:
        q: rotation order.
        turning: from boundary loop to l; the loop turns by 2πl/q.
        handles: from handle generator to r; the rotation along it is 2πr/q.
        document: all of it as hgp-cones (docs/schema/hgp-cones.schema.json).
    """

    def __init__(self, document: ConesDocument) -> None:
        self.document = document
        self.q: int = document["q"]
        self._cones = {cone["vertex"]: cone["k"] for cone in document.get("cones", [])}
        self.turning: Dict[int, int] = {loop["loop"]: loop["l"] for loop in document.get("boundaries", [])}
        self.handles: Dict[int, int] = {handle["generator"]: handle["r"] for handle in document.get("handles", [])}

    def __getitem__(self, vertex: int) -> int:
        return self._cones[vertex]

    def __iter__(self) -> Iterator[int]:
        return iter(self._cones)

    def __len__(self) -> int:
        return len(self._cones)

    def __repr__(self) -> str:
        return f"<hgp.Cones q={self.q} {self._cones}>"

    def save(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Writes a file that `hgp param --cones` and the argument `cones` read."""
        pathlib.Path(path).write_text(json.dumps(self.document, indent=2) + "\n", encoding="utf-8")


#: How a file itself marks edges: OBJ l lines, smoothing groups, materials, split normals.
Mark = Literal["lines", "smoothing", "materials", "normals"]
#: A mapping or pairs of integers.
Pairs = Union[Mapping[int, int], Iterable[Tuple[int, int]]]
#: A file by its path, Cones, a document (ConesDocument), or cones as pairs (vertex, k).
ConesLike = Union[str, "os.PathLike[str]", Cones, Mapping[str, object], Pairs]


def _pairs(value: Any, name: str) -> List[Tuple[int, int]]:
    items = value.items() if isinstance(value, Mapping) else value
    pairs = []
    try:
        for first, second in items:
            pairs.append((_integer(first), _integer(second)))
    except (TypeError, ValueError) as error:
        raise UsageError(f"{name} must be a dictionary or pairs of integers: {error}", "arguments") from error
    return pairs


def _integer(value: Any) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{value!r} is not an integer")
    number = int(value.__index__())
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{number} is too large")
    return number


def _degrees(creases: Any) -> float:
    if creases is True:
        return 30.0
    if not hasattr(creases, "__float__") or not 0 < float(creases) < 180:
        raise UsageError(f"creases must be True or an angle between 0 and 180 degrees, not {creases!r}", "arguments")
    return float(creases)


def prescription(
    q: Optional[int],
    cones: Optional[ConesLike],
    turning: Optional[Pairs],
    handles: Optional[Pairs],
    field: "Optional[Union[str, os.PathLike[str]]]",
    ignore_embedded: bool,
    rims: bool = False,
    creases: Union[bool, float, None] = None,
    features: Optional[FeaturesLike] = None,
    marked: "Union[bool, Iterable[Mark]]" = False,
) -> Dict[str, Any]:
    """The arguments of a prescription as src/options.cpp takes them."""
    asked: Dict[str, Any] = {
        "q": q,
        "ignore_embedded": flag(ignore_embedded, "ignore_embedded"),
        "rims": flag(rims, "rims"),
    }
    if creases is not None and creases is not False:
        asked["creases"] = _degrees(creases)
    if marked:
        words = list(get_args(Mark)) if marked is True else [marked] if isinstance(marked, str) else list(marked)
        asked["marked"] = words
    if features is not None:
        asked.update(listed(features))
    if isinstance(cones, (str, os.PathLike)):
        asked["cones_file"] = os.fspath(cones)
    elif isinstance(cones, Cones):
        asked["cones_text"] = json.dumps(cones.document)
    elif isinstance(cones, Mapping) and "q" in cones:
        asked["cones_text"] = json.dumps(cones)
    elif cones is not None:
        asked["cones"] = _pairs(cones, "cones")
    if turning is not None:
        asked["turning"] = _pairs(turning, "turning")
    if handles is not None:
        asked["handles"] = _pairs(handles, "handles")
    if field is not None:
        asked["field"] = os.fspath(field)
    return asked
