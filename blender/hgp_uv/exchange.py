"""Meshes of Blender and binary PLY files, by numpy: positions, polygons, texture coordinates of every corner."""

from __future__ import annotations

import pathlib
import re
from typing import Any, NamedTuple, Optional

import numpy as np


class Polygons(NamedTuple):
    """A mesh of polygons; corner c of polygon p is row starts[p] + c of `corners`."""

    positions: Any  # n × 3, float32
    corners: Any  # vertex of every corner, int32
    sizes: Any  # corners of every polygon, int32

    @property
    def starts(self) -> Any:
        return np.concatenate([[0], np.cumsum(self.sizes)[:-1]]).astype(np.int64)


def polygons_of(mesh: Any) -> Polygons:
    """The mesh data of an object."""
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    corners = np.empty(len(mesh.loops), np.int32)
    sizes = np.empty(len(mesh.polygons), np.int32)
    mesh.vertices.foreach_get("co", positions)
    mesh.loops.foreach_get("vertex_index", corners)
    mesh.polygons.foreach_get("loop_total", sizes)
    return Polygons(positions.reshape(-1, 3), corners, sizes)


def cut(mesh: Any, given: Polygons, edges: Any) -> "tuple[Polygons, Any]":
    """The mesh cut open along edges, and the original vertex of every vertex.

    Corners at a vertex stay together if an edge that is not cut joins their polygons.
    """
    count = len(given.corners)
    edge_of = np.empty(count, np.int32)  # from this corner to the next one
    mesh.loops.foreach_get("edge_index", edge_of)
    following = np.arange(count) + 1
    last = given.starts + given.sizes - 1
    following[last] = given.starts
    order = np.argsort(edge_of, kind="stable")
    same = (edge_of[order][1:] == edge_of[order][:-1]) & ~edges[edge_of[order][1:]]
    a, b = order[:-1][same], order[1:][same]
    # Corners of two neighbours at each end of their edge.
    turned = given.corners[a] == given.corners[b]
    pairs = [(a, np.where(turned, b, following[b])), (following[a], np.where(turned, following[b], b))]
    label = np.arange(count)
    while True:
        before = label.copy()
        for x, y in pairs:
            low = np.minimum(label[x], label[y])
            np.minimum.at(label, x, low)
            np.minimum.at(label, y, low)
        label = label[label]
        if (label == before).all():
            break
    # The first group of corners at a vertex keeps its number; others follow.
    groups, corner_group = np.unique(label, return_inverse=True)
    origin = given.corners[groups]
    is_first = np.zeros(len(groups), bool)
    is_first[np.unique(origin, return_index=True)[1]] = True
    vertex = np.where(is_first, origin, 0)
    more = np.flatnonzero(~is_first)
    vertex[more] = len(given.positions) + np.arange(len(more))
    origins = np.concatenate([np.arange(len(given.positions)), origin[more]])
    return Polygons(given.positions[origins], vertex[corner_group].astype(np.int32), given.sizes), origins


def _spread(sizes: Any) -> "tuple[Any, Any]":
    """For every corner its polygon, and its place in it."""
    polygon = np.repeat(np.arange(len(sizes)), sizes)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
    return polygon, np.arange(len(polygon)) - starts[polygon]


def drawn_flipped(mesh: Any, uv: Any) -> int:
    """How many of the triangles that Blender draws are not positive. It divides polygons in its own way: of a quad that
    is not convex in the map, one of the two diagonals gives a flipped triangle.

    @param uv  of every corner, rounded to the float32 that Blender stores
    """
    mesh.calc_loop_triangles()
    loops = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("loops", loops)
    # float64 holds the differences of float32 numbers of similar size, and their products, exactly.
    stored = uv.astype(np.float32).astype(np.float64)[loops].reshape(-1, 3, 2)
    (x, y), (s, t) = (stored[:, 1] - stored[:, 0]).T, (stored[:, 2] - stored[:, 0]).T
    return int((x * t - y * s <= 0).sum())


def write_ply(path: pathlib.Path, mesh: Polygons, uv: Optional[Any] = None) -> None:
    """@param uv  float64, two numbers per corner"""
    header = [
        *["ply", "format binary_little_endian 1.0", f"element vertex {len(mesh.positions)}"],
        *["property float x", "property float y", "property float z", f"element face {len(mesh.sizes)}"],
        "property list ushort int vertex_indices",
        *([] if uv is None else ["property list ushort double texcoord"]),
        *["end_header", ""],
    ]
    lengths = 2 + 4 * mesh.sizes.astype(np.int64) + (0 if uv is None else 2 + 16 * mesh.sizes.astype(np.int64))
    begin = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    data = np.empty(int(lengths.sum()), np.uint8)
    polygon, place = _spread(mesh.sizes)

    def put(offset: Any, values: Any) -> None:
        raw = np.ascontiguousarray(values).view(np.uint8).reshape(len(values), -1)
        data[offset[:, None] + np.arange(raw.shape[1])] = raw

    put(begin, mesh.sizes.astype("<u2"))
    put(begin[polygon] + 2 + 4 * place, mesh.corners.astype("<i4"))
    if uv is not None:
        put(begin + 2 + 4 * mesh.sizes, (2 * mesh.sizes).astype("<u2"))
        put((begin + 4 + 4 * mesh.sizes)[polygon] + 16 * place, uv.astype("<f8"))
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        file.write(mesh.positions.astype("<f4").tobytes())
        file.write(data.tobytes())


def read_uv(path: pathlib.Path, sizes: Any) -> Any:
    """The texture coordinates of every corner, float64, of a file that hgp wrote from one of write_ply."""
    content = path.read_bytes()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    header = content[:end].decode()
    vertices = int(re.search(r"element vertex (\d+)", header)[1])  # type: ignore[index]
    found = re.search(r"property list (uchar|ushort) double texcoord", header)
    if not found:
        raise ValueError(f"{path} has no coordinates in doubles")
    count = {"uchar": 1, "ushort": 2}[found[1]]
    wide = sizes.astype(np.int64)
    lengths = 2 + 4 * wide + count + 16 * wide
    data = np.frombuffer(content, np.uint8, offset=end + 12 * vertices)
    if len(data) != lengths.sum():
        raise ValueError(f"{path} has other polygons than the mesh")
    begin = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    polygon, place = _spread(sizes)
    offset = (begin + 2 + 4 * wide + count)[polygon] + 16 * place
    return data[offset[:, None] + np.arange(16)].view("<f8").reshape(-1, 2)


def read_quads(path: pathlib.Path) -> "tuple[Any, Any]":
    """Positions and quads of an OBJ that `hgp quads` wrote."""
    lines = path.read_text().splitlines()
    positions = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], dtype=np.float64)
    corners = [word.split("/")[0] for line in lines if line.startswith("f ") for word in line.split()[1:5]]
    return positions.reshape(-1, 3), np.array(corners, dtype=np.int32).reshape(-1, 4) - 1


def write_uv(mesh: Any, name: str, uv: Any) -> Any:
    """Writes a UV map, made if there is none of this name, and makes it the active one. Returns it."""
    layer = mesh.uv_layers.get(name) or mesh.uv_layers.new(name=name, do_init=False)
    if layer is None:
        raise ValueError("the mesh has eight UV maps, the most that Blender can have; remove one")
    layer.data.foreach_set("uv", np.ascontiguousarray(uv, dtype=np.float32).ravel())
    mesh.uv_layers.active = layer
    mesh.update()
    return layer
