"""Batches: every mesh of many files, on the workers of a Dask cluster."""

from __future__ import annotations

import contextlib
import csv
import dataclasses
import hashlib
import importlib
import inspect as _inspect
import io
import json
import logging
import os
import pathlib
import shutil
import subprocess
import sys
import time
import uuid
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Tuple, Union

from . import _core
from ._errors import HgpError, UsageError
from ._map import Map
from ._mesh import Mesh
from ._summary import summary

Path = Union[str, "os.PathLike[str]"]
Row = Dict[str, Any]
ENDINGS = (".obj", ".off", ".ply", ".stl", ".gltf", ".glb")
COLUMNS = [
    *["file", "mesh", "certified", "code", "message", "triangles", "components", "cones", "q", "flipped", "seam_edges"],
    *["aligned", "mean_mu", "max_mu", "rms_log_area", "solve_seconds", "cpu_seconds", "seconds", "peak_memory_mb"],
    *["map", "report", "thumbnail", "worker"],
]
#: Endings of the results of formats that are not written as they are.
WRITTEN = {".off": ".obj", ".stl": ".obj", ".gltf": ".glb"}
SAVED_SECONDS = 5.0


@dataclasses.dataclass(frozen=True)
class Batch:
    """What a batch did: one row per mesh, in the order of the files."""

    #: dictionaries with the columns of the table
    rows: List[Row]
    #: files that were done before and not again
    kept: int
    #: the folder with maps/, reports/, thumbnails/, results.csv and index.html
    folder: pathlib.Path

    @property
    def certified(self) -> int:
        """How many meshes have a certified map."""
        return sum(bool(row["certified"]) for row in self.rows)

    def __repr__(self) -> str:
        return f"<hgp.Batch {self.certified} of {len(self.rows)} meshes certified, in {self.folder}>"


def _stem(path: str) -> Tuple[str, str]:
    """Name without ending, and the ending in lower case without .gz."""
    name = path[:-3] if path.lower().endswith(".gz") else path
    stem, ending = os.path.splitext(name)
    return stem, ending.lower()


def _files(paths: Iterable[Path]) -> List[pathlib.Path]:
    """All files, those of folders in order; each once."""
    found: Dict[pathlib.Path, None] = {}
    for path in [paths] if isinstance(paths, (str, os.PathLike)) else paths:
        place = pathlib.Path(path)
        if place.is_dir():
            for file in sorted(place.rglob("*")):
                if file.is_file() and _stem(file.name)[1] in ENDINGS:
                    found[file.absolute()] = None
        else:
            found[place.absolute()] = None
    if not found:
        raise UsageError("there are no files with meshes (.obj, .off, .ply, .stl, .gltf, .glb)", "batch")
    return list(found)


def _names(files: List[pathlib.Path], ending: Optional[str]) -> List[Tuple[str, str]]:
    """For every file its name below the folder that all have in common, and the name of its result; all different."""
    top = os.path.commonpath([file.parent for file in files])
    named: List[Tuple[str, str]] = []
    taken = set()
    for file in files:
        name = os.path.relpath(file, top)
        stem, own = _stem(name)
        written: str = WRITTEN.get(own, own) if ending is None else ending
        result = name + written if stem + written in taken else stem + written
        taken.add(result)
        named.append((name, result))
    return named


def _split(options: Dict[str, Any]) -> Dict[str, Dict[str, Any]]:
    """The options by the call that takes them; unknown ones are refused."""
    takers: Dict[str, Callable[..., Any]] = {"load": Mesh.load, "solve": Mesh.parametrize, "save": Map.save}
    ours = {"self", "path", "mesh", "target", "progress", "overwrite", "allow_uncertified", "keep_going", "field", "features"}
    known = {name: set(_inspect.signature(taker).parameters) - ours for name, taker in takers.items()}
    parts: Dict[str, Dict[str, Any]] = {name: {} for name in takers}
    for option, value in options.items():
        names = [name for name in takers if option in known[name]]
        if not names:
            raise UsageError(f"batch has no option {option!r}", "batch")
        parts[names[0]][option] = value
    return parts


def _identity(file: pathlib.Path, asked: str) -> Optional[str]:
    """What a result depends on: the file, the options, the version of hgp."""
    try:
        status = file.stat()
    except OSError:
        return None
    text = f"{_core.version()} {asked} {status.st_size} {status.st_mtime_ns}"
    return hashlib.sha256(text.encode()).hexdigest()


def finished(out: str, name: str, identity: Optional[str]) -> Optional[List[Row]]:
    """The rows of a file that is done and certified, with its map; None if it is to be done."""
    try:
        with open(os.path.join(out, "rows", name + ".json"), encoding="utf-8") as file:
            record = json.load(file)
    except (OSError, ValueError):
        return None
    rows: List[Row] = record["rows"]
    is_good = identity is not None and record["identity"] == identity and all(row["certified"] for row in rows)
    return rows if is_good and rows and all(os.path.exists(os.path.join(out, row["map"])) for row in rows) else None


def _run(job: Dict[str, Any], folder: pathlib.Path) -> Tuple[List[Row], float, int]:
    """Runs a job in a process of its own: rows, peak memory in bytes, exit code."""
    (folder / "job.json").write_text(json.dumps(job), encoding="utf-8")
    place = str(pathlib.Path(str(_core.__file__)).parents[1])  # of this package, whose sources may be links
    paths = filter(None, [place, os.environ.get("PYTHONPATH", "")])
    # Pages of 2 MB, which only the start of a process can ask for (docs/decisions/102).
    env = {"GLIBC_TUNABLES": "glibc.malloc.hugetlb=1", **os.environ, "PYTHONPATH": os.pathsep.join(paths)}
    command = [sys.executable, "-m", "hgp._one", str(folder / "job.json")]
    with open(folder / "messages.txt", "wb") as messages:
        process = subprocess.Popen(command, env=env, stdout=messages, stderr=messages, stdin=subprocess.DEVNULL)
    deadline = time.monotonic() + job["hard_limit"] if job["hard_limit"] else None
    pause = 0.002
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        if deadline and time.monotonic() > deadline:
            process.kill()
        time.sleep(pause)
        pause = min(0.05, 1.3 * pause)
    process.returncode = os.waitstatus_to_exitcode(status)
    memory = usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024)
    with contextlib.suppress(OSError, ValueError):
        rows: List[Row] = json.loads((folder / "rows.json").read_text(encoding="utf-8"))
        return rows, memory, process.returncode
    return [], memory, process.returncode


def do_file(job: Dict[str, Any]) -> Tuple[str, List[Row], bool]:
    """One file on a worker: its name, its rows, whether it was done before."""
    out, name = job["out"], job["file"]
    # A task whose worker died after it had finished is given to another worker.
    known = finished(out, name, job["identity"])
    if known is not None:
        return name, known, True
    folder = pathlib.Path(out) / ".tmp" / uuid.uuid4().hex
    folder.mkdir(parents=True)
    begin = time.monotonic()
    rows, memory, status = _run(job, folder)
    if not rows:
        is_late = status == -9 and job["hard_limit"] and time.monotonic() - begin > job["hard_limit"]
        message = f"stopped after {job['hard_limit']:g} s" if is_late else f"the process ended with {status}"
        if (folder / "messages.txt").exists() and not is_late:
            message += ": " + (folder / "messages.txt").read_text(encoding="utf-8", errors="replace").strip()[-500:]
        code = "no-map" if is_late else "limit" if status in (-9, -6) else "internal"
        rows.append({"mesh": 0, "certified": False, "code": code, "message": message, "cpu_seconds": None})
    for row in rows:
        _place(row, job, folder)
        row.setdefault("peak_memory_mb", memory / 1e6)
        row.update(file=name, seconds=time.monotonic() - begin, worker=worker_name())
    if any(row["certified"] for row in rows):
        _move(folder / job["name"], pathlib.Path(out) / "maps" / job["result"])
    record = folder / "record.json"
    record.write_text(json.dumps({"identity": job["identity"], "rows": rows}), encoding="utf-8")
    _move(record, pathlib.Path(out) / "rows" / (name + ".json"))
    shutil.rmtree(folder, ignore_errors=True)
    return name, rows, False


def _place(row: Row, job: Dict[str, Any], folder: pathlib.Path) -> None:
    """Moves report and thumbnail of a mesh into place, and names them in its row."""
    number = f"-{row['mesh']}" if row["mesh"] else ""
    row["map"] = f"maps/{job['result']}" if row["certified"] else ""
    for kind, ending in (("report", ".json"), ("thumbnail", ".png")):
        made = folder / f"{kind}-{row['mesh']}{ending}"
        row[kind] = f"{kind}s/{job['file']}{number}{ending}" if made.exists() else ""
        if made.exists():
            _move(made, pathlib.Path(job["out"]) / row[kind])


def _move(source: pathlib.Path, target: pathlib.Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    os.replace(source, target)


def worker_name() -> str:
    """The worker that runs this task."""
    return str(_distributed().get_worker().name)


@contextlib.contextmanager
def _alone(out: pathlib.Path) -> Iterator[None]:
    """Only one batch writes into a folder; what an interrupted one left half done is removed."""
    out.mkdir(parents=True, exist_ok=True)
    with open(out / ".lock", "w", encoding="utf-8") as lock:
        try:
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except ImportError:
            pass
        except OSError as error:
            raise UsageError(f"another batch writes into {out}", "batch") from error
        shutil.rmtree(out / ".tmp", ignore_errors=True)
        try:
            yield
        finally:
            shutil.rmtree(out / ".tmp", ignore_errors=True)


class _Table:
    """Rows by file, written as a table and a page while the batch runs."""

    def __init__(self, out: pathlib.Path, names: List[str], table: str) -> None:
        self.out, self.names, self.table = out, names, table
        self.rows: Dict[str, List[Row]] = {}
        self.kept = 0
        self._saved = time.monotonic()

    def ordered(self) -> List[Row]:
        return [row for name in self.names for row in self.rows.get(name, [])]

    def add(self, name: str, rows: List[Row], is_kept: bool) -> None:
        self.rows[name] = rows
        self.kept += is_kept
        if time.monotonic() - self._saved > SAVED_SECONDS:
            self.save()

    def save(self) -> None:
        rows = self.ordered()
        if self.table.endswith(".parquet"):
            pandas: Any = importlib.import_module("pandas")
            pandas.DataFrame(rows, columns=COLUMNS).to_parquet(self.out / (self.table + ".new"))
        else:
            text = io.StringIO()
            writer = csv.DictWriter(text, COLUMNS, extrasaction="ignore", lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
            (self.out / (self.table + ".new")).write_text(text.getvalue(), encoding="utf-8")
        os.replace(self.out / (self.table + ".new"), self.out / self.table)
        (self.out / "index.html.new").write_text(summary(rows, len(self.names)), encoding="utf-8")
        os.replace(self.out / "index.html.new", self.out / "index.html")
        self._saved = time.monotonic()


def _distributed() -> Any:
    try:
        return importlib.import_module("distributed")
    except ImportError as error:
        raise UsageError("batch needs distributed (Debian: python3-distributed)", "batch") from error


@contextlib.contextmanager
def _client(scheduler: Optional[str], workers: int) -> Iterator[Any]:
    """A client of the scheduler, or of local processes."""
    distributed = _distributed()
    with contextlib.ExitStack() as stack:
        address = scheduler or stack.enter_context(
            distributed.LocalCluster(
                n_workers=workers,
                threads_per_worker=1,
                dashboard_address=None,
                memory_limit=None,
                silence_logs=logging.ERROR,
            )
        )
        yield stack.enter_context(distributed.Client(address, set_as_default=False))


def batch(
    paths: Union[Path, Iterable[Path]],
    out: Path,
    *,
    scheduler: Optional[str] = None,
    workers: Optional[int] = None,
    threads: int = 1,
    format: Optional[str] = None,
    table: str = "results.csv",
    memory_limit: Optional[int] = None,
    hard_limit: Optional[float] = None,
    on_row: Optional[Callable[[Row, int, int], Any]] = None,
    **options: Any,
) -> Batch:
    """See hgp.batch. Files are independent tasks of Dask, each computed in a process of its own, so that neither a crash
    nor a lack of memory ends the batch. Results appear whole; a file whose meshes are all certified is not done again with
    the same options, a file that failed is. If a worker dies, its file is given to another one."""
    if format not in (None, "obj", "glb"):
        raise UsageError(f"format must be 'obj' or 'glb', not {format!r}", "batch")
    if isinstance(threads, bool) or not isinstance(threads, int) or not 1 <= threads <= 16:
        raise UsageError(f"threads must be from 1 to 16, not {threads!r}", "batch")
    if not table.endswith((".csv", ".parquet")):
        raise UsageError(f"table must end in .csv or .parquet, not {table!r}", "batch")
    parts = _split(options)
    place = pathlib.Path(out).absolute()
    files = _files([paths] if isinstance(paths, (str, os.PathLike)) else paths)
    names = _names(files, f".{format}" if format else None)
    asked = json.dumps([parts, format], sort_keys=True)
    jobs: List[Dict[str, Any]] = []
    for file, (name, result) in zip(files, names):
        own = _stem(name)[1]
        ending = _stem(result)[1]
        target = ending[1:] if ending in (".glb", ".obj") and ending != own else None
        jobs.append(
            {
                **parts,
                "file": name,
                "source": str(file),
                "out": str(place),
                "result": result,
                "name": f"result{ending}",
                "target": target,
                "identity": _identity(file, asked),
                "threads": threads,
                "memory_limit": memory_limit,
                "hard_limit": hard_limit,
            }
        )
    with _alone(place):
        return _submit(jobs, place, _Table(place, [name for name, _ in names], table), scheduler, workers, on_row)


def _submit(
    jobs: List[Dict[str, Any]],
    place: pathlib.Path,
    rows: _Table,
    scheduler: Optional[str],
    workers: Optional[int],
    on_row: Optional[Callable[[Row, int, int], Any]],
) -> Batch:
    todo = []
    for job in jobs:
        known = finished(job["out"], job["file"], job["identity"])
        if known is None:
            todo.append(job)
        else:
            rows.add(job["file"], known, True)
    rows.save()
    if todo:
        with _client(scheduler, min(workers or os.cpu_count() or 1, len(todo))) as client:
            futures = {client.submit(do_file, job, pure=False): job for job in todo}
            try:
                for future in _distributed().as_completed(list(futures), loop=client.loop):
                    name, found, is_kept = _result(future, futures[future])
                    rows.add(name, found, is_kept)
                    if on_row is not None:
                        for row in found:
                            on_row(row, len(rows.rows), len(jobs))
            finally:
                rows.save()
                client.cancel([future for future in futures if not future.done()])
    return Batch(rows.ordered(), rows.kept, place)


def _result(future: Any, job: Dict[str, Any]) -> Tuple[str, List[Row], bool]:
    error = future.exception()
    if error is None:
        name, found, is_kept = future.result()
        return name, found, is_kept
    # Several workers died with this file, or the folder cannot be written by the worker.
    code = error.code if isinstance(error, HgpError) else "internal"
    row: Row = {"file": job["file"], "mesh": 0, "certified": False, "code": code, "message": f"{type(error).__name__}: {error}"}
    return job["file"], [row], False
