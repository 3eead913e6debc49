"""Seamless texture coordinates without flipped triangles, with cones where you place them, and a certificate::

    import hgp
    m = hgp.parametrize(V, F, q=4, cones={12: 3, 40: 5})
    m.certified, m.uv, m.fuv

[BCW17] Bright, Chien, Weber: Harmonic Global Parametrization with Rational Holonomy. ACM TOG 36(4), 2017.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Iterable, Literal, Optional, Union

import numpy.typing as npt

from . import _core
from ._cones import Cones, ConesLike, Mark, Pairs
from ._documents import Certificate, Check, ConesDocument, MeshInfo, Report
from ._errors import (
    Cancelled,
    HgpError,
    InternalError,
    LimitError,
    MalformedError,
    NoMapError,
    Place,
    PrescriptionError,
    UnsupportedError,
    UsageError,
    WriteError,
)
from ._features import Features, FeaturesLike
from ._map import Distortion, Map, Quads, Seams, Solved
from ._mesh import ConesFor, Fix, Improve, Loops, Mesh, Method, OnProgress, Path, Progress, Weld, _mapped_mesh
from ._whole_file import FileResult, MeshOutcome, combine, parametrize_file

if TYPE_CHECKING:
    from ._batch import Batch, Row

__version__: str = _core.version()

__all__ = [
    "Cancelled",
    "Certificate",
    "Check",
    "Cones",
    "ConesDocument",
    "Distortion",
    "Features",
    "FileResult",
    "HgpError",
    "InternalError",
    "LimitError",
    "Loops",
    "MalformedError",
    "Map",
    "Mesh",
    "MeshInfo",
    "MeshOutcome",
    "NoMapError",
    "Place",
    "PrescriptionError",
    "Progress",
    "Quads",
    "Report",
    "Seams",
    "Solved",
    "UnsupportedError",
    "UsageError",
    "WriteError",
    "batch",
    "check",
    "combine",
    "inspect",
    "list_features",
    "parametrize",
    "parametrize_file",
    "set_threads",
    "suggest_cones",
    "verify",
]

for _name in __all__:
    if isinstance(globals().get(_name), type):
        globals()[_name].__module__ = "hgp"


def set_threads(threads: Optional[int] = None) -> None:
    """With how many threads, 1 to 16, later calls of this process compute; None: one per processor. Results do not
    depend on it."""
    if threads is not None and (isinstance(threads, bool) or not isinstance(threads, int) or not 1 <= threads <= 16):
        raise UsageError(f"threads must be from 1 to 16, or None, not {threads!r}", "options")
    _core.set_threads(threads or 0)


def parametrize(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    *,
    q: Optional[int] = None,
    cones: Optional[ConesLike] = None,
    turning: Optional[Pairs] = None,
    handles: Optional[Pairs] = None,
    field: Optional[Path] = None,
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
) -> Map:
    """Maps a mesh given as arrays: `Mesh(V, F, …).parametrize(…)`, where the arguments are explained.

    Args:
        V: #V × 3 positions.
        F: #F × 3 rows of V, counterclockwise from outside; any number of components.

    Returns:
        A Map, which may be not certified: `m.certified`, `m.uv`, `m.fuv`, `m.cones`, `m.certificate`.
    """
    return Mesh(V, F, weld=weld, fix=fix, strict=strict, write_repairs=write_repairs).parametrize(
        q=q,
        cones=cones,
        turning=turning,
        handles=handles,
        field=field,
        rims=rims,
        creases=creases,
        features=features,
        marked=marked,
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
        reproducible=reproducible,
        time_limit=time_limit,
        progress=progress,
    )


def suggest_cones(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    *,
    q: int = 4,
    count: int = 0,
    cones_for: ConesFor = "balanced",
    align_to_curvature: bool = False,
    reproducible: bool = False,
    progress: OnProgress = None,
) -> Cones:
    """Chooses cones for a mesh given as arrays; see Mesh.suggest_cones."""
    return Mesh(V, F).suggest_cones(
        q=q,
        count=count,
        cones_for=cones_for,
        align_to_curvature=align_to_curvature,
        reproducible=reproducible,
        progress=progress,
    )


def list_features(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    *,
    rims: bool = False,
    creases: Union[bool, float, None] = None,
    features: Optional[FeaturesLike] = None,
) -> Features:
    """Edges of a mesh given as arrays that lines of a map can follow; see Mesh.list_features."""
    return Mesh(V, F).list_features(rims=rims, creases=creases, features=features)


def check(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    cones: Optional[ConesLike] = None,
    *,
    q: Optional[int] = None,
    turning: Optional[Pairs] = None,
    handles: Optional[Pairs] = None,
) -> Check:
    """Whether any map of this mesh can have these cones; solves nothing. See Mesh.check."""
    return Mesh(V, F).check(cones, q=q, turning=turning, handles=handles)


def verify(
    V: npt.ArrayLike,
    F: npt.ArrayLike,
    uv: npt.ArrayLike,
    fuv: Optional[npt.ArrayLike] = None,
    *,
    q: Optional[int] = None,
    cones: Optional[ConesLike] = None,
    turning: Optional[Pairs] = None,
    handles: Optional[Pairs] = None,
    tolerance: float = 0.0,
) -> Certificate:
    """Verifies any map, whoever made it, on exactly these numbers.

    Args:
        V: #V × 3 positions.
        F: #F × 3 rows of V.
        uv: n × 2.
        fuv: #F × 3 rows of uv; by default uv has a row per vertex, or three rows per triangle.
        q: order of the rotations across seams; by default that of the cones, or 4.
        cones, turning, handles: what the map must have; by default any cones are accepted.
        tolerance: of seams, relative to the length of each edge, and of angles in radians; 0: 1e-6.

    Returns:
        docs/schema/hgp-certificate.schema.json; `["certified"]` is the verdict.
    """
    return _mapped_mesh(V, F, uv, fuv).verify(
        cones, q=q, turning=turning, handles=handles, tolerance=tolerance
    )


def inspect(V: npt.ArrayLike, F: npt.ArrayLike) -> MeshInfo:
    """Topology and defects of a mesh; see Mesh.inspect."""
    return Mesh(V, F).inspect()


def batch(
    paths: "Union[Path, Iterable[Path]]",
    out: Path,
    *,
    scheduler: Optional[str] = None,
    workers: Optional[int] = None,
    threads: int = 1,
    format: Optional[Literal["obj", "glb"]] = None,
    table: str = "results.csv",
    memory_limit: Optional[int] = None,
    hard_limit: Optional[float] = None,
    on_row: "Optional[Callable[[Row, int, int], Any]]" = None,
    **options: Any,
) -> "Batch":
    """Maps every mesh of many files on the workers of a Dask cluster, and continues where an earlier call ended.

    Args:
        paths: files, and folders that are searched for OBJ, OFF, PLY, STL, glTF and GLB, also gzipped.
        out: folder for maps/, reports/, thumbnails/, the table and index.html; for a cluster, one that all workers share.
        scheduler: address of a Dask scheduler, such as "tcp://10.0.0.1:8786"; by default processes of this machine.
        workers: how many of them; by default one per core.
        threads: of each of them.
        format: of the maps; by default that of the file (OBJ for OFF and STL, GLB for .gltf).
        table: "….csv", or "….parquet" where pandas and pyarrow are installed.
        memory_limit: bytes of address space that a file may take; beyond, its code is "limit".
        hard_limit: seconds after which a process is killed; `time_limit` ends a solve in order.
        on_row: called with each new row, the number of files that are done, and the number of all.
        **options: those of Mesh.load, Mesh.parametrize and Map.save.

    Returns:
        An object with `rows` (a dictionary per mesh), `certified` and `kept` (files that were done before).
    """
    from ._batch import batch as run

    return run(
        paths,
        out,
        scheduler=scheduler,
        workers=workers,
        threads=threads,
        format=format,
        table=table,
        memory_limit=memory_limit,
        hard_limit=hard_limit,
        on_row=on_row,
        **options,
    )
