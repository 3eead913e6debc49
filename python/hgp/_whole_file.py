"""Files of several meshes: all of them mapped and written at once."""

from __future__ import annotations

import dataclasses
import json
import os
from typing import Any, Iterable, List, Literal, Optional, Union

from . import _core
from ._cones import Mark, prescription
from ._documents import Report
from ._errors import HgpError
from ._features import FeaturesLike
from ._map import Map
from ._mesh import ConesFor, Fix, Improve, Method, OnProgress, Path, Weld, _caller, _load_options, _solve_options
from ._options import flag, seconds

#: Formats to which a file is converted when it is read, if the result has this ending.
_TARGETS = {".obj": "obj", ".glb": "glb", ".gltf": "gltf", ".ply": "ply"}


@dataclasses.dataclass(frozen=True)
class MeshOutcome:
    """What happened to one mesh of a file."""

    #: its number in the file, from 0, as `Mesh.load(path, mesh=…)` takes it
    mesh: int
    #: whether it has a map, and the certificate holds
    certified: bool
    #: False if a grid was asked for and the map is not on it
    aligned: bool
    #: docs/schema/hgp-report.schema.json; None if there is no map
    report: Optional[Report]
    #: why there is no map; not raised
    error: Optional[HgpError]

    @property
    def good(self) -> bool:
        """Certified and, if a grid was asked for, aligned to it."""
        return self.certified and self.aligned


@dataclasses.dataclass(frozen=True)
class FileResult:
    """What happened to the meshes of a file. Look at `certified` before you use it."""

    #: in the order of the file
    meshes: List[MeshOutcome]
    #: the file that was written; None if nothing was, because a mesh is not good
    path: Optional[str]
    #: sentences on what was written, with the meshes that they are about
    notes: List[str]

    @property
    def certified(self) -> bool:
        """Whether every mesh is certified."""
        return all(one.certified for one in self.meshes)

    def __repr__(self) -> str:
        certified = sum(one.certified for one in self.meshes)
        return f"<hgp.FileResult {certified} of {len(self.meshes)} meshes certified, {self.path or 'nothing written'}>"


def parametrize_file(
    path: Path,
    out: Path,
    *,
    q: Optional[int] = None,
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
    weld: Weld = None,
    fix: Optional[Fix] = None,
    strict: bool = False,
    write_repairs: bool = False,
    root: Optional[Path] = None,
    max_bytes: Optional[int] = None,
    max_triangles: Optional[int] = None,
    overwrite: bool = False,
    allow_uncertified: bool = False,
    uv_set: Optional[int] = None,
    use: Optional[bool] = None,
    embed: bool = False,
    embed_cones: bool = False,
    compress: bool = False,
    grid_material: Optional[float] = None,
) -> FileResult:
    """Maps every mesh of a file and writes all maps at once, as `hgp param FILE -o OUT` does.

    Every mesh has the cones stored in the file, or automatic ones. For cones of your own load each mesh with
    `Mesh.load(path, mesh=…)`, and write their maps with `combine`.

    Args:
        path: OBJ, OFF, PLY, STL, glTF or GLB, also gzipped.
        out: the file to write; its ending is the format.
        cells: about so many on all meshes together: their cells have the same size.
        keep_going, allow_uncertified: write also if not every mesh is certified (and aligned to the grid that was asked
            for); a mesh without a map is left as it was. Otherwise nothing is written then.
        time_limit: seconds for the file.
        progress: see OnProgress; `Progress.mesh` is the mesh that is being mapped.
        weld, fix, strict, write_repairs, root, max_bytes, max_triangles: see Mesh.load.
        overwrite, uv_set, use, embed, embed_cones, compress, grid_material: see Map.save.

    All others: see Mesh.parametrize.

    Returns:
        The outcome of every mesh. That a mesh has no map is no error: it is in its outcome.

    Raises:
        UsageError: wrong or contradictory arguments.
        MalformedError: the file cannot be read.
        NoMapError: the time limit, or maps that are no longer certified in the numbers of this format.
        WriteError: the file cannot be written.
        Cancelled: `progress` returned False.
    """
    asked = prescription(q, None, None, None, None, ignore_embedded, rims, creases, features, marked)
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
    saving = {
        "overwrite": overwrite,
        "allow_uncertified": allow_uncertified,
        "uv_set": uv_set,
        "use": use,
        "embed": embed,
        "embed_cones": embed_cones,
        "compress": compress,
        "grid_material": grid_material,
    }
    to = os.fspath(out)
    target = _TARGETS.get(os.path.splitext(to)[1].lower())
    loading = _load_options(
        weld, fix, strict, write_repairs, target=target, max_bytes=max_bytes, max_triangles=max_triangles
    )
    surface = _core.Surface.of_file(os.fspath(path), "" if root is None else os.fspath(root), loading)
    alike, limit = flag(reproducible, "reproducible"), seconds(time_limit, "time_limit")
    made = surface.parametrize_file(asked, options, to, saving, alike, limit, _caller(progress))
    meshes = [
        MeshOutcome(mesh, certified, aligned, json.loads(report) if report else None, error)
        for mesh, certified, aligned, report, error in made["meshes"]
    ]
    return FileResult(meshes, to if made["is_written"] else None, made["notes"])


def combine(
    maps: Iterable[Map],
    out: Path,
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
    """Writes maps of different meshes of one file (`Mesh.load(path, mesh=…)`) into that file; other meshes stay as they were.

    Args:
        maps: of one file that was loaded with the same `target`.
        out: the file to write, in that format.

    The others: see Map.save.

    Returns:
        Notes on what was written.
    """
    options: "dict[str, Any]" = {
        "overwrite": overwrite,
        "allow_uncertified": allow_uncertified,
        "uv_set": uv_set,
        "use": use,
        "embed": embed,
        "embed_cones": embed_cones,
        "compress": compress,
        "grid_material": grid_material,
    }
    return _core.Map.save_all([one._core for one in maps], os.fspath(out), options)
