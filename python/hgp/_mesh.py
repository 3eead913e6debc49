"""Meshes: files or arrays, and everything that can be asked of them."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, Iterable, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import reals, triangles
from ._cones import Cones, ConesLike, Mark, Pairs, prescription
from ._documents import Certificate, Check, MeshInfo
from ._errors import UsageError
from ._features import Features, FeaturesLike
from ._map import Integers, Map, Reals
from ._options import flag, seconds

Path = Union[str, "os.PathLike[str]"]
Fix = Sequence[Literal["orient", "split", "degenerate"]]
ConesFor = Literal["balanced", "few", "fewer", "more", "low-distortion"]
Method = Literal["auto", "harmonic", "soft", "printed", "all-frames"]
Improve = Union[Literal["isometric", "conformal", "area"], float, None]
Weld = Union[None, Literal["exact", "none"], float]


class Progress(NamedTuple):
    """A report of a run that is under way."""

    #: "prepare", "cones", "connection", "field", "cut", "assemble", "solve", "improve" or "align"
    stage: str
    #: of the stage, from 0 to 1
    fraction: float
    #: iteration of a solver, -1 outside
    iteration: int
    #: residual of a solver relative to its target, or an energy's excess over an isometry; -1 otherwise
    residual: float
    #: round of solve, verify, repair, from 1; 0 outside
    round: int
    #: largest number of rounds; 0 outside
    max_rounds: int
    #: since the call began
    seconds: float
    #: of the file, from 0: the one that parametrize_file maps
    mesh: int = 0


#: Called at every change of stage and about ten times a second, in the thread of the call. False cancels.
OnProgress = Optional[Callable[[Progress], Any]]


def _caller(progress: OnProgress) -> Optional[Callable[..., Any]]:
    if progress is None:
        return None
    if not callable(progress):
        raise UsageError(f"progress must be a function, not {progress!r}", "arguments")
    call = progress
    return lambda *values: call(Progress(*values))


class Loops(NamedTuple):
    """What the numbers of turnings and handles refer to."""

    #: for each boundary loop its vertices in order, the surface on their left
    boundaries: List[Integers]
    #: for each handle generator the edges that it crosses in order, n × 2 vertices
    handles: List[Integers]


def _load_options(
    weld: Weld, fix: Optional[Fix], strict: bool, write_repairs: bool, **others: Any
) -> Dict[str, Any]:
    options: Dict[str, Any] = {"strict": strict or None, "write_repairs": write_repairs, "weld": weld, **others}
    if fix is not None:
        options["fix"] = [fix] if isinstance(fix, str) else list(fix)
        if strict and options["fix"]:
            raise UsageError("strict and fix exclude each other", "arguments")
    return options


def _solve_options(asked: Dict[str, Any], **options: Any) -> Dict[str, Any]:
    """The options of parametrize as the core's table has them."""
    prescribes = set(asked) - {"q", "ignore_embedded", "rims"} or asked["rims"]
    if options["boundary"] == "convex" and prescribes:
        message = "boundary='convex' cannot be combined with cones, turning, handles, features or a field"
        raise UsageError(message, "arguments")
    cells, improve = options["cells"], options["improve"]
    if cells == "auto":
        if options["grid"] is not None:
            raise UsageError("cells and grid exclude each other", "arguments")
        options.update(cells=None, grid_mode=options["grid_mode"] or "tile")
    if improve is False:
        options["improve"] = None
    return options


class Mesh:
    """A triangle mesh: arrays, or a file by `Mesh.load`. Threads may share it; their calls follow one another.

    Args:
        V: #V × 3 positions. float64 in C order is copied once; other real numbers are converted.
        F: #F × 3 rows of V, counterclockwise from outside; any integers.
        weld: "exact" joins vertices at equal positions, a length those that are closer, "none" joins nothing.
            By default vertices at equal positions are joined if every triangle is a component of its own.
        fix: exactly these repairs; by default those that the mesh needs.
        strict: repair and join nothing; refuse meshes that need it.
        write_repairs: write repairs into saved files.

    Raises:
        UsageError: arrays of the wrong shape, type or range, by name.
    """

    def __init__(
        self,
        V: npt.ArrayLike,
        F: npt.ArrayLike,
        *,
        weld: Weld = None,
        fix: Optional[Fix] = None,
        strict: bool = False,
        write_repairs: bool = False,
    ) -> None:
        options = _load_options(weld, fix, strict, write_repairs)
        self._core = _core.Surface.of_arrays(reals(V, "V", 3), triangles(F, "F"), options)

    @classmethod
    def load(
        cls,
        path: Path,
        *,
        mesh: Optional[int] = None,
        target: Optional[Literal["obj", "glb", "gltf", "ply"]] = None,
        weld: Weld = None,
        fix: Optional[Fix] = None,
        strict: bool = False,
        write_repairs: bool = False,
        root: Optional[Path] = None,
        max_bytes: Optional[int] = None,
        max_triangles: Optional[int] = None,
    ) -> "Mesh":
        """Reads OBJ, OFF, PLY, STL, glTF or GLB, also gzipped, with everything that `hgp param` keeps.

        Args:
            path: the file. Side files are read from its folder only, or below `root`.
            mesh: which mesh of the file, from 0; by default the one with the most triangles.
            target: convert the file to this format when it is read, as `hgp param mesh.obj -o mapped.glb` does:
                "glb" or "gltf" from polygon files, "obj" from glTF. Ids are then those of the converted mesh. "ply" of a
                PLY stores the coordinates as float, which more programs read than double.
            weld, fix, strict, write_repairs: see Mesh.
            max_bytes, max_triangles: larger files are refused; by default 2 GiB and 16 million.

        Raises:
            MalformedError: the file cannot be read; `places` has its line or byte.
            LimitError: it is too large.
        """
        options = _load_options(
            weld,
            fix,
            strict,
            write_repairs,
            mesh=mesh,
            target=target,
            max_bytes=max_bytes,
            max_triangles=max_triangles,
        )
        made = cls.__new__(cls)
        made._core = _core.Surface.of_file(os.fspath(path), "" if root is None else os.fspath(root), options)
        return made

    @property
    def vertices(self) -> Reals:
        """#V × 3 positions of the loaded surface; ids of vertices are rows of it."""
        return self._core.positions()

    @property
    def triangles(self) -> Integers:
        """#F × 3 rows of `vertices`."""
        return self._core.triangles()

    @property
    def mesh_count(self) -> int:
        """The number of meshes with triangles in the file."""
        return self._core.mesh_count()

    @property
    def embedded_cones(self) -> Optional[Cones]:
        """The cones stored in the file."""
        text = self._core.embedded_cones()
        return None if text is None else Cones(json.loads(text))

    @property
    def loops(self) -> Loops:
        """Boundary loops and handle generators, as `turning` and `handles` number them."""
        found = self._core.loops()
        return Loops(found["boundaries"], found["handles"])

    def inspect(self) -> MeshInfo:
        """Topology, defects and uv sets: docs/schema/hgp-inspect.schema.json. Also of meshes that cannot be used."""
        info: MeshInfo = json.loads(self._core.inspect()[1])
        return info

    def check(
        self,
        cones: Optional[ConesLike] = None,
        *,
        q: Optional[int] = None,
        turning: Optional[Pairs] = None,
        handles: Optional[Pairs] = None,
        field: Optional[Path] = None,
        ignore_embedded: bool = False,
        rims: bool = False,
        creases: Union[bool, float, None] = None,
        features: Optional[FeaturesLike] = None,
        marked: Union[bool, Iterable[Mark]] = False,
    ) -> Check:
        """Whether any map can have these cones (Gauss–Bonnet in integers, [BCW17] Lemma 6.2); solves nothing.

        Returns:
            docs/schema/hgp-check.schema.json; `["valid"]` is the verdict, and `["error"]` why not.
        """
        asked = prescription(q, cones, turning, handles, field, ignore_embedded, rims, creases, features, marked)
        verdict: Check = json.loads(self._core.check(asked)[1])
        return verdict

    def suggest_cones(
        self,
        *,
        q: int = 4,
        count: int = 0,
        cones_for: ConesFor = "balanced",
        align_to_curvature: bool = False,
        reproducible: bool = False,
        progress: OnProgress = None,
    ) -> Cones:
        """Chooses cones; `parametrize` without cones has the same ones.

        Args:
            q: angles are multiples of 2π/q, 1 to 64.
            count: how many if possible; 0: chosen by `cones_for`.
            cones_for: "balanced": low distortion, boundaries are followed; "few"; "low-distortion": as many as lower
                distortion; "fewer", "more": a number halfway between "balanced" and these.
            align_to_curvature: follow the principal curvatures.
            reproducible: the same on every processor.
            progress: see OnProgress.
        """
        options = {
            "q": q,
            "count": count,
            "cones_for": cones_for,
            "align_to_curvature": align_to_curvature,
        }
        return Cones(json.loads(self._core.suggest(options, flag(reproducible, "reproducible"), _caller(progress))))

    def list_features(
        self,
        *,
        rims: bool = False,
        creases: Union[bool, float, None] = None,
        features: Optional[FeaturesLike] = None,
        marked: Union[bool, Iterable[Mark]] = False,
    ) -> Features:
        """Lists edges that lines of a map can follow, as `hgp features` does. Without arguments: creases above 30°.

        Args:
            rims, creases, features, marked: see parametrize, which takes the list as its `features`.

        Returns:
            `edges` (n × 2 vertices), their numbers, and `save`.
        """
        asked = prescription(None, None, None, None, None, True, rims, creases, features, marked)
        return Features(self._core, asked)

    def convert_cones(self, cones: ConesLike, *, q: Optional[int] = None) -> Cones:
        """Cones of any kind, complete and in vertices of this mesh."""
        return Cones(json.loads(self._core.convert(prescription(q, cones, None, None, None, True))))

    def balance_cones(self, cones: ConesLike, *, q: Optional[int] = None) -> Cones:
        """These cones and those that Gauss–Bonnet misses ([BCW17] Lemma 6.2), where they cause the least distortion."""
        return Cones(json.loads(self._core.balance(prescription(q, cones, None, None, None, True))))

    def transfer_cones(self, cones: ConesLike, source: "Mesh", *, q: Optional[int] = None) -> "Tuple[Cones, List[str]]":
        """The cones of another version of this mesh on this one, and sentences on those that have no place here.

        Vertices keep their numbers where both have the same vertices and triangles (read with other repairs);
        otherwise they are found by their exact positions.
        """
        made, lost = self._core.transfer(prescription(q, cones, None, None, None, True), source._core)
        return Cones(json.loads(made)), lost

    def parametrize(
        self,
        *,
        q: Optional[int] = None,
        cones: Optional[ConesLike] = None,
        turning: Optional[Pairs] = None,
        handles: Optional[Pairs] = None,
        field: Optional[Path] = None,
        ignore_embedded: bool = False,
        rims: bool = False,
        creases: Union[bool, float, None] = None,
        features: Optional[FeaturesLike] = None,
        marked: Union[bool, Iterable[Mark]] = False,
        count: int = 0,
        cones_for: ConesFor = "balanced",
        align_to_curvature: bool = False,
        boundary: Literal["free", "convex", "rectangle"] = "free",
        method: Method = "auto",
        max_rounds: int = 24,
        frames: Literal["auto", "file"] = "auto",
        improve: Improve = None,
        scale: Literal["solved", "unit", "fit"] = "solved",
        cells: Union[float, Literal["auto"], None] = None,
        grid: Optional[float] = None,
        grid_mode: Optional[Literal["tile", "quad"]] = None,
        refine: bool = False,
        keep_going: bool = False,
        convex_polygons: bool = False,
        symmetric: Optional[Literal["auto", "X", "Y", "Z"]] = None,
        reproducible: bool = False,
        time_limit: Optional[float] = None,
        progress: OnProgress = None,
    ) -> Map:
        """Computes a map and verifies it ([BCW17] §7). Other threads run meanwhile, and Ctrl-C interrupts it.

        Args:
            q: rotation order: angles are multiples of 2π/q, 1 to 64; by default that of the cones, or 4.
            cones: {vertex: k} with cone angles 2πk/q; pairs; Cones; a document; or the path of a file of cones.
                By default those stored in the file, or automatic ones. {}: none.
            turning: {loop: l}; boundary loop `loop` turns by 2πl/q.
            handles: {generator: r}; the rotation along the generator is 2πr/q.
            field: a file with a direction field whose cones and holonomy are prescribed.
            ignore_embedded: do not use cones stored in the file.
            rims: boundary edges become straight lines along the axes of the map, exactly (q = 4).
            creases: so do edges with a dihedral angle above so many degrees (True: 30), and boundary edges.
            features: so do these edges, and boundary edges: n × 2 vertices, Features, or a file (.sharp, OBJ with l lines, or
                rows of two vertices).
            marked: so do edges that the file itself marks in these ways: "lines" (OBJ), "smoothing" groups, "materials",
                split "normals"; True: all of them.
            count, cones_for, align_to_curvature: of automatic cones, see suggest_cones.
            boundary: "convex" maps a disk without cones onto a convex polygon, "rectangle" onto a rectangle
                whose corners are cones {vertex: 1} on the boundary, or chosen.
            method, max_rounds, frames: how to solve; see docs/cli.md.
            improve: lower the distortion of a certified map: "isometric" (angles and areas), "conformal" (angles),
                "area", or a number from -1 (angles) to 1 (areas).
            scale: as solved, mean edge length 1, or fitted into the unit square.
            cells, grid: align to a grid of about so many cells, or with cells of this edge length (q = 2 or 4): lines
                meet at every seam, and one cell is one unit of uv. cells="auto": 14 along the diagonal, at least 800
                and 40 per cone, 20 along features (in a file of several meshes, the size of those of the largest
                one), and another number where that gives no aligned map.
            grid_mode: "quad": cones on grid points as well, so that `Map.quads` gives a mesh of quads; the cells are chosen
                if neither `cells` nor `grid` is given.
            refine: if there is no map, split edges and solve again.
            keep_going: components without a map keep their uv or are cut open; the map is then not certified.
            convex_polygons: certify only maps in which every polygon of the file is convex, for readers that cut polygons
                along other diagonals.
            symmetric: one side of a plane that mirrors the mesh is solved and the map mirrored, to the last bit: across X, Y or Z
                through the centre of the bounding box, or whichever plane fits.
            reproducible: the same bytes on every processor, as `hgp param --reproducible`; calls that differ in it wait
                for each other.
            time_limit: seconds, after which the call ends with NoMapError.
            progress: see OnProgress.

        Returns:
            A Map; it may be not certified (docs/not-certified.md), which is no error.

        Raises:
            UsageError: wrong or contradictory arguments.
            UnsupportedError: a mesh that cannot be used.
            PrescriptionError: no map can have these cones.
            NoMapError: the time limit.
            Cancelled: `progress` returned False.
        """
        asked = prescription(q, cones, turning, handles, field, ignore_embedded, rims, creases, features, marked)
        options = _solve_options(
            asked,
            q=q,
            count=count,
            cones_for=cones_for,
            align_to_curvature=align_to_curvature,
            boundary=boundary,
            method=method,
            max_rounds=max_rounds,
            frames=frames,
            improve=improve,
            scale=scale,
            cells=cells,
            grid=grid,
            grid_mode=grid_mode,
            refine=refine,
            keep_going=keep_going,
            convex_polygons=convex_polygons,
            symmetric=symmetric,
        )
        alike, limit = flag(reproducible, "reproducible"), seconds(time_limit, "time_limit")
        made = self._core.parametrize(asked, options, alike, limit, _caller(progress))
        return Map(made)

    def verify(
        self,
        cones: Optional[ConesLike] = None,
        *,
        q: Optional[int] = None,
        turning: Optional[Pairs] = None,
        handles: Optional[Pairs] = None,
        field: Optional[Path] = None,
        ignore_embedded: bool = False,
        rims: bool = False,
        creases: Union[bool, float, None] = None,
        features: Optional[FeaturesLike] = None,
        marked: Union[bool, Iterable[Mark]] = False,
        uv_set: Optional[int] = None,
        tolerance: float = 0.0,
    ) -> Certificate:
        """Verifies the texture coordinates that the file has, whoever made them.

        Args:
            cones, turning, handles, field, ignore_embedded, rims, creases, features, marked: what the map must have, see
                parametrize; by default any cones are accepted.
            q: order of the rotations; by default that of the cones, or 4.
            uv_set: the set to verify; by default the last.
            tolerance: of seams, relative to the length of each edge, and of angles in radians; 0: 1e-6.
        """
        asked = prescription(q, cones, turning, handles, field, ignore_embedded, rims, creases, features, marked)
        options = {"q": q, "uv_set": uv_set, "tolerance": tolerance}
        certificate: Certificate = json.loads(self._core.verify(asked, options)[1])
        return certificate

    def __repr__(self) -> str:
        return f"<hgp.Mesh {len(self.vertices)} vertices, {len(self.triangles)} triangles>"


def _mapped_mesh(V: npt.ArrayLike, F: npt.ArrayLike, uv: npt.ArrayLike, fuv: Optional[npt.ArrayLike]) -> Mesh:
    """A mesh with texture coordinates. @param fuv  None: a row of uv per vertex, or three per triangle"""
    positions, faces, rows = reals(V, "V", 3), triangles(F, "F"), reals(uv, "uv", 2)
    if fuv is not None:
        corners = triangles(fuv, "fuv")
    elif len(rows) == len(positions):
        corners = faces
    elif len(rows) == 3 * len(faces):
        corners = np.arange(3 * len(faces), dtype=np.int64).reshape(-1, 3)
    else:
        raise UsageError(
            f"uv has {len(rows)} rows, which is neither one per vertex ({len(positions)}) nor three per triangle "
            f"({3 * len(faces)}): pass fuv",
            "arguments",
        )
    if len(corners) != len(faces):
        raise UsageError(f"fuv has {len(corners)} rows, and F has {len(faces)}", "arguments")
    made = Mesh.__new__(Mesh)
    made._core = _core.Surface.of_map(positions, faces, rows, corners, {})
    return made
