"""Maps: what parametrize returns."""

from __future__ import annotations

import dataclasses
import json
import os
from typing import List, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._cones import Cones
from ._documents import Certificate, Report

Reals = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int32]


class Seams(NamedTuple):
    """The seam edges of a map, one row each."""

    #: s × 2 rows of uv: one side of each edge
    a: Integers
    #: s × 2 rows of uv: the other side, in corresponding order
    b: Integers
    #: s rotations r in Z_q: side b is side a turned by 2πr/q and shifted
    r: Integers


class Solved(NamedTuple):
    """The triangles that the certificate is about, one row each: those of `Map.triangles` without the ones that are no
    surface (copies of others, a vertex named twice), turned over where neighbours disagreed."""

    #: s × 3 rows of Map.vertices
    triangles: Integers
    #: s × 3 rows of Map.uv, corner by corner; in a certified map each has exactly positive area
    fuv: Integers
    #: s: the row of Map.triangles that each comes from, ascending
    origin: Integers


@dataclasses.dataclass(frozen=True, eq=False)
class Distortion:
    """Measurements of a map. Arrays have one entry per triangle, unless stated otherwise."""

    #: ratio of the singular values, at least 1; 1 preserves angles (float32)
    stretch: "npt.NDArray[np.float32]"
    #: log2 of uv area per area, minus that of all triangles together (float32)
    log_area: "npt.NDArray[np.float32]"
    #: numbers of triangles without positive area in uv, oriented as verified; none in a certified map
    not_positive: Integers
    #: of all triangles, in the mesh's unit squared
    surface_area: float
    #: of all triangles, in uv units squared
    uv_area: float
    #: pairs of triangles that overlap in the plane and share no row of uv; allowed in a seamless map
    overlap_pairs: int
    #: numbers of the triangles in such pairs
    overlapping: Integers
    #: whether counting stopped early, so that there are more pairs
    more_overlaps: bool
    #: number of the seam that each row of Map.seams belongs to
    seam_chain: Integers


class Quads:
    """The cells of a map that is aligned to a grid, as a mesh of quads."""

    def __init__(self, core: _core.Map) -> None:
        made = core.quads()
        self._core = core
        lines: List[bytes] = made["obj"].split(b"\n")
        vertices = b" ".join(line[2:] for line in lines if line.startswith(b"v "))
        #: n × 3 positions, on the surface
        self.vertices: Reals = np.array(vertices.split(), dtype=np.float64).reshape(-1, 3)
        faces = [line[2:].split() for line in lines if line.startswith(b"f ")]
        corners = [corner.partition(b"/")[0] for face in faces for corner in face]
        #: m × 4 rows of vertices, counterclockwise
        self.quads: Integers = np.array(corners, dtype=np.int32).reshape(-1, 4) - np.int32(1)
        #: cells that the boundary cuts; they are left out
        self.clipped: int = made["clipped"]
        #: strips that were cut lengthwise, so that no two vertices are joined by several edges
        self.cuts: int = made["cuts"]
        #: edges that were replaced by a vertex of three edges, where strips are long
        self.replaced: int = made["replaced"]
        #: how often every cell was cut into four, where neither removes such edges
        self.halvings: int = made["halvings"]
        #: quads with a corner that is turned over in space
        self.folded_in_space: int = made["folded_in_space"]
        #: quads at cones of k = 1, which meet themselves
        self.folded: int = made["folded"]
        #: quads across a seam of the input's texture coordinates, or across the border of a material
        self.across_seams: int = made["across_seams"]

    def save(self, path: "Union[str, os.PathLike[str]]", *, overwrite: bool = False) -> List[str]:
        """Writes the quads as .obj or .ply, or as triangles in a .glb with the quads beside it (x-quads.obj beside
        x.glb), with the attributes, materials and pictures of the input. All files appear whole, or none.

        Args:
            path: its extension is the format.
            overwrite: allow to replace the loaded file and other side files.

        Returns:
            Notes on what was written.

        Raises:
            WriteError: a file cannot be written.
        """
        return self._core.save_quads(os.fspath(path), {"overwrite": overwrite})

    def __repr__(self) -> str:
        return f"<hgp.Quads {len(self.vertices)} vertices, {len(self.quads)} quads>"


class Map:
    """A map of a mesh into the plane. Look at `certified` before you use it.

    Arrays are read-only views: the certificate holds for exactly these numbers. `array.copy()` can be changed.
    """

    def __init__(self, core: _core.Map) -> None:
        self._core = core
        self._report: Optional[Report] = None

    @property
    def certified(self) -> bool:
        """Whether every row of `solved.fuv` has exactly positive area in `uv`, cones and turnings are as prescribed, and
        every seam is a rotation by a multiple of 2π/q and a shift. Rows of `fuv` are the same unless repairs turned
        triangles over or left some out, which `certificate["stored"]` counts."""
        return self._core.certified

    @property
    def aligned(self) -> bool:
        """Whether the map is certified and aligned to the grid that was asked for."""
        return self._core.aligned

    @property
    def uv(self) -> Reals:
        """n × 2: a row per vertex of the surface cut along its seams."""
        return self._core.uv

    @property
    def fuv(self) -> Integers:
        """m × 3 rows of uv; row f belongs to row f of `triangles`, corner by corner. What is verified is `solved.fuv`."""
        return self._core.fuv

    @property
    def vertices(self) -> Reals:
        """The positions that were mapped, #V × 3: the given ones, or those of the refined mesh."""
        return self._core.positions

    @property
    def triangles(self) -> Integers:
        """The triangles that were mapped, m × 3 rows of `vertices`: the given ones, or those of the refined mesh."""
        return self._core.triangles

    @property
    def solved(self) -> Solved:
        """The triangles as solved, with their rows of uv and the rows of `triangles` that they come from."""
        return Solved(*self._core.solved)

    @property
    def uv_to_vertex(self) -> Integers:
        """n: the row of `vertices` of every row of uv."""
        return self._core.uv_to_vertex

    @property
    def seams(self) -> Seams:
        """The seam edges with their rotations."""
        rows = self._core.seams
        return Seams(rows[:, 0:2], rows[:, 2:4], rows[:, 4])

    @property
    def cones(self) -> Cones:
        """The cones of the map: from vertex to k, with q, turnings and handle rotations."""
        return Cones(json.loads(self._core.cones))

    @property
    def certificate(self) -> Certificate:
        """The verdict and the measurements behind it: docs/schema/hgp-certificate.schema.json."""
        return self.report["certificate"]

    @property
    def report(self) -> Report:
        """Certificate, cones, rounds, times and notes: docs/schema/hgp-report.schema.json."""
        if self._report is None:
            self._report = json.loads(self._core.report)
        assert self._report is not None
        return self._report

    @property
    def notes(self) -> List[str]:
        """Sentences on what was repaired, joined or found; `report["notes"]` has the codes (docs/notes.md)."""
        return [_core.phrase(json.dumps(note)) for note in self.report["notes"]]

    def distortion(self) -> Distortion:
        """Measures angles, areas and overlaps per triangle."""
        return Distortion(**self._core.measure())

    def quads(self) -> Quads:
        """The cells as quads. The map must have been asked for with `cells` or `grid` and `grid_mode="quad"`.

        Raises:
            NoMapError: the map is not aligned; `report["components"][…]["grid"]` says why.
        """
        return Quads(self._core)

    def save(
        self,
        path: "Union[str, os.PathLike[str]]",
        *,
        overwrite: bool = False,
        allow_uncertified: bool = False,
        uv_set: Optional[int] = None,
        use: Optional[bool] = None,
        embed: bool = False,
        embed_cones: bool = False,
        compress: bool = False,
        grid_material: Optional[float] = None,
    ) -> List[str]:
        """Writes the loaded file with the map, everything else unchanged, if `path` has its format (see Mesh.load,
        `target`); otherwise the mesh alone as .obj, .glb or .gltf, the map as a flat mesh (.flat.obj) or its edges
        (.svg). The file appears whole or not at all.

        Args:
            path: its extension is the format.
            overwrite: allow to replace the loaded file and other side files.
            allow_uncertified: also write a map that is not certified.
            uv_set: glTF: the set to write; by default the one after the last.
            use: glTF: make the materials' textures use the new set, or keep theirs; None: those use it whose own set
                is missing or has no area.
            embed: .gltf: embed buffers and images.
            embed_cones: store the cones in the file.
            compress: glTF: compress with meshopt, losing nothing.
            grid_material: a grid as the material, this many tiles per unit of uv; 0: large enough to see.

        Returns:
            Notes on what was written.

        Raises:
            NoMapError: the map is not certified, or no longer is in the numbers of this format.
            WriteError: the file cannot be written.
        """
        options = {
            "overwrite": overwrite,
            "allow_uncertified": allow_uncertified,
            "uv_set": uv_set,
            "use": use,
            "embed": embed,
            "embed_cones": embed_cones,
            "compress": compress,
            "grid_material": grid_material,
        }
        return self._core.save(os.fspath(path), options)

    def __repr__(self) -> str:
        verdict = "certified" if self.certified else "not certified"
        return f"<hgp.Map {verdict}: {len(self.fuv)} triangles, {len(self.uv)} uv, {len(self.cones)} cones>"
