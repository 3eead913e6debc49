"""Edges that lines of a map follow."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Dict, List, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import integers


class Features:
    """Edges that become straight lines of a map if they are given as its `features`, in vertices of the mesh."""

    def __init__(self, core: _core.Surface, asked: Dict[str, Any]) -> None:
        made = core.features(asked, "edges.txt")
        self._core, self._asked = core, asked
        #: n × 2 vertices: every edge once
        self.edges: "npt.NDArray[np.int32]" = np.array(made["text"].split(), dtype=np.int32).reshape(-1, 2)
        #: of these, edges between two triangles
        self.crease_edges: int = made["crease_edges"]
        #: and edges of the boundary
        self.rim_edges: int = made["rim_edges"]
        #: runs of edges between ends and crossings
        self.chains: int = made["chains"]
        #: sentences on what was found
        self.notes: List[str] = made["notes"]

    def __len__(self) -> int:
        return len(self.edges)

    def save(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Writes .sharp, .obj (lines l), .json (hgp-cones) or, under any other name, rows of two vertices, which
        `features` and `hgp param --features` read."""
        text: str = self._core.features(self._asked, os.fspath(path))["text"]
        pathlib.Path(path).write_text(text, encoding="utf-8")

    def __repr__(self) -> str:
        return f"<hgp.Features {self.crease_edges} crease edges, {self.rim_edges} rim edges, {self.chains} chains>"


#: A file (.sharp, OBJ with l lines, hgp-cones, or rows of two vertices) by its path, Features, or n × 2 vertices.
FeaturesLike = Union[str, "os.PathLike[str]", Features, npt.ArrayLike]


def listed(features: FeaturesLike) -> Dict[str, str]:
    """The argument as src/options.cpp takes it."""
    if isinstance(features, (str, os.PathLike)):
        return {"features": os.fspath(features)}
    rows = features.edges if isinstance(features, Features) else features
    edges = integers(np.zeros((0, 2), np.int32) if np.size(rows) == 0 else rows, "features", 2)
    return {"features_text": "".join(f"{a} {b}\n" for a, b in edges.tolist())}
