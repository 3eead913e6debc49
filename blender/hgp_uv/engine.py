"""Runs hgp: the Python package if this Python has it, otherwise the command line. Needs nothing of Blender."""

from __future__ import annotations

import importlib
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
from typing import Any, Dict, List, NamedTuple, Optional

import numpy as np

from . import exchange


class Failed(Exception):
    """What the user has to read; `places` as (kind, id, other)."""

    def __init__(self, message: str, places: Any = ()) -> None:
        super().__init__(message)
        self.places = list(places)


class Job(NamedTuple):
    """A mesh, what is asked, and where the engine is."""

    mesh: exchange.Polygons
    q: int = 4
    cones: Optional[Dict[int, int]] = None  # vertex to k; None: automatic
    count: int = 0
    improve: Optional[str] = None
    cells: float = 0.0
    makes_quads: bool = False
    program: str = ""  # of the command line; "": the package, or `hgp` on the PATH


class Done(NamedTuple):
    uv: Any  # float64, of every corner
    report: Dict[str, Any]
    quads: Optional[Any]  # (positions, quads)
    stored: Dict[str, Any]  # the certificate of the float32 numbers that Blender keeps
    notes: List[str]  # sentences of the package; of the command line's document the codes


def package() -> Any:
    """The module hgp: the one that came with the add-on, or an installed one; None if there is none for this Python."""
    bundled = str(pathlib.Path(__file__).parent / "bundled")
    if bundled not in sys.path:
        sys.path.append(bundled)
    try:
        return importlib.import_module("hgp")
    except ImportError:
        return None


def describe(program: str) -> str:
    """Which engine is used."""
    if not program and package() is not None:
        return f"Python package {package().__version__}"
    found = shutil.which(program or "hgp")
    return f"program {found}" if found else ""


class Run:
    """One job in a thread of its own."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.stage, self.fraction = "", 0.0
        self.done: Optional[Done] = None
        self.error: Optional[BaseException] = None
        self._cancelled = threading.Event()
        self._process: Optional["subprocess.Popen[str]"] = None
        self._thread = threading.Thread(target=self._work, daemon=True)

    def start(self) -> "Run":
        self._thread.start()
        return self

    def cancel(self) -> None:
        self._cancelled.set()
        if self._process is not None:
            self._process.terminate()

    @property
    def is_running(self) -> bool:
        return self._thread.is_alive()

    @property
    def is_cancelled(self) -> bool:
        return self._cancelled.is_set()

    def wait(self) -> Done:
        self._thread.join()
        if self.error is not None:
            raise self.error
        assert self.done is not None
        return self.done

    def _work(self) -> None:
        try:
            with tempfile.TemporaryDirectory(prefix="hgp-") as folder:
                self.done = self._solved(pathlib.Path(folder))
        except BaseException as error:  # noqa: B902 - raised again by wait()
            self.error = error

    def _solved(self, folder: pathlib.Path) -> Done:
        # With coordinates in doubles, which the program keeps: by default it would round them, and Blender would round again.
        corners = len(self.job.mesh.corners)
        exchange.write_ply(folder / "in.ply", self.job.mesh, np.zeros((corners, 2)))
        module = None if self.job.program else package()
        if module is not None:
            report, stored, notes = self._by_package(module, folder)
        else:
            report, stored = self._by_program(folder)
            notes = [str(note["code"]) for note in report["notes"]]
        uv = exchange.read_uv(folder / "out.ply", self.job.mesh.sizes)
        quads = exchange.read_quads(folder / "quads.obj") if self.job.makes_quads else None
        return Done(uv, report, quads, stored, notes)

    def _round(self, folder: pathlib.Path) -> None:
        """stored.ply: the map as Blender will store it."""
        uv = exchange.read_uv(folder / "out.ply", self.job.mesh.sizes)
        exchange.write_ply(folder / "stored.ply", self.job.mesh, uv.astype("f4").astype("f8"))

    def _by_package(self, hgp: Any, folder: pathlib.Path) -> Any:
        job = self.job

        def progress(report: Any) -> bool:
            self.stage, self.fraction = report.stage, report.fraction
            return not self._cancelled.is_set()

        try:
            m = hgp.Mesh.load(folder / "in.ply").parametrize(
                q=job.q,
                cones=job.cones,
                count=job.count,
                improve=job.improve,
                cells=job.cells or None,
                grid_mode="quad" if job.makes_quads else None,
                progress=progress,
            )
            if not m.certified:
                raise Failed(_why(m.report))
            m.save(folder / "out.ply")
            if job.makes_quads:
                m.quads().save(folder / "quads.obj")
            self._round(folder)
            stored = hgp.Mesh.load(folder / "stored.ply").verify(m.cones)
        except hgp.HgpError as error:
            raise Failed(error.message, error.places) from error
        return m.report, stored, m.notes

    def _by_program(self, folder: pathlib.Path) -> Any:
        job = self.job
        program = shutil.which(job.program or "hgp")
        if program is None:
            raise Failed(f"there is no program {job.program or 'hgp'}; name it in the preferences of the add-on")
        words = ["--q", str(job.q), "--count", str(job.count)]
        if job.cones is not None:
            cones = [{"vertex": v, "k": k} for v, k in job.cones.items()]
            (folder / "cones.json").write_text(json.dumps({"q": job.q, "cones": cones}))
            words = ["--cones", str(folder / "cones.json")]
        words += ["--improve", job.improve] if job.improve else []
        words += ["--cells", str(job.cells)] if job.cells else []
        words += ["--grid-mode", "quad"] if job.makes_quads else []
        report = self._run(program, folder, "param", "in.ply", "-o", "out.ply", *words)
        (folder / "made.json").write_text(json.dumps(report["cones"]))
        if job.makes_quads:
            few = [word for word in words if word not in ("--grid-mode", "quad")]
            if job.improve:
                few.remove("--improve")
                few.remove(job.improve)
            self._run(program, folder, "quads", "in.ply", "-o", "quads.obj", *few)
        self._round(folder)
        stored = self._run(program, folder, "verify", "stored.ply", "--cones", "made.json")
        return report, stored

    def _run(self, program: str, folder: pathlib.Path, command: str, *words: str) -> Dict[str, Any]:
        """The document of a command; of verify also if its verdict is negative."""
        named: List[str] = [program, command, *words, "--quiet", "--json", "report.json"]
        self._process = subprocess.Popen(
            named, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
        )
        _, errors = self._process.communicate()
        if self._cancelled.is_set():
            raise Failed("cancelled")
        path = folder / "report.json"
        document = json.loads(path.read_text()) if path.exists() else {}
        if self._process.returncode != 0 and command != "verify":
            if "message" in document:
                places = [(place["kind"], place["id"], place.get("other")) for place in document["where"]]
                raise Failed(document["message"], places)
            raise Failed(_why(document) if "certificate" in document else errors.strip() or "hgp ended without a result")
        path.unlink()
        return dict(document)


def _why(report: Dict[str, Any]) -> str:
    parts = report["certificate"]["components"]
    reasons = [reason["message"] for part in parts for reason in part["reasons"]]
    return "no certified map: " + ("; ".join(reasons[:3]) or "see docs/not-certified.md")
