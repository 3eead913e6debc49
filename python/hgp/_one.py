"""One file of a batch, in a process of its own: `python3 -m hgp._one JOB.json`. A crash or a lack of memory ends only
this process; its folder has the results, which the worker moves into place."""

from __future__ import annotations

import json
import pathlib
import sys
import time
from typing import Any, Dict, List

from . import _core
from ._errors import HgpError
from ._map import Map
from ._mesh import Mesh
from ._thumbnail import thumbnail


def _limit(job: Dict[str, Any]) -> None:
    """Ends this process with the worker that started it, and limits its memory."""
    if not sys.platform.startswith("linux"):
        return
    import ctypes
    import resource
    import signal

    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG
    if job["memory_limit"]:
        resource.setrlimit(resource.RLIMIT_AS, (job["memory_limit"], job["memory_limit"]))


def _peak() -> int:
    """The largest memory of this process so far, in bytes."""
    if sys.platform == "win32":
        return 0
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def _measured(m: Map) -> Dict[str, Any]:
    """The columns of a map."""
    certificate = m.certificate
    parts = certificate["components"]
    # A component without positive triangles has no distortion.
    found = [(part["triangles"], part["distortion"]) for part in parts if part.get("distortion")]
    total = sum(count for count, _ in found) or 1
    return {
        "certified": m.certified,
        "triangles": certificate["triangles"],
        "components": len(parts),
        "cones": len(m.cones),
        "q": certificate["q"],
        "flipped": certificate["flipped"],
        "seam_edges": certificate["seamEdges"],
        "aligned": m.aligned,
        "mean_mu": sum(count * d["meanMu"] for count, d in found) / total,
        "max_mu": max((d["maxMu"] for _, d in found), default=None),
        "rms_log_area": (sum(count * d["rmsLogArea"] ** 2 for count, d in found) / total) ** 0.5,
        "solve_seconds": m.report["seconds"],
    }


def _solve(job: Dict[str, Any], folder: pathlib.Path, number: int, source: str) -> Dict[str, Any]:
    """The row of one mesh of the file; its map is written into the file that the next mesh reads."""
    row: Dict[str, Any] = {"mesh": number, "certified": False, "code": "", "message": ""}
    begin = time.process_time()
    try:
        mesh = Mesh.load(source, mesh=number, target=job["target"] if source == job["source"] else None, **job["load"])
        m = mesh.parametrize(**job["solve"])
        (folder / f"report-{number}.json").write_text(json.dumps(m.report, indent=2) + "\n", encoding="utf-8")
        row.update(_measured(m))
        if m.certified:
            m.save(folder / job["name"], overwrite=True, **job["save"])
        else:
            row["code"], row["message"] = "no-map", "the map is not certified"
            reasons = [reason["message"] for part in m.certificate["components"] for reason in part["reasons"]]
            if reasons:
                row["message"] += ": " + "; ".join(reasons[:3])
        row["peak_memory_mb"] = _peak() / 1e6
        (folder / f"thumbnail-{number}.png").write_bytes(thumbnail(m))
    except HgpError as error:
        row["certified"], row["code"], row["message"] = False, error.code, error.message
        places = [{"kind": p.kind, "id": p.id, "other": p.other} for p in error.places[:1000]]
        document = {"code": error.code, "stage": error.stage, "message": error.message, "where": places}
        (folder / f"report-{number}.json").write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")
    except MemoryError:
        row["certified"], row["code"], row["message"] = False, "limit", "out of memory"
    row["cpu_seconds"] = time.process_time() - begin
    return row


def main(path: str) -> None:
    """Does the job of this file, and writes rows.json beside it."""
    job = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    _limit(job)
    _core.set_threads(job["threads"])
    folder = pathlib.Path(path).parent
    rows: List[Dict[str, Any]] = []
    try:
        count = Mesh.load(job["source"], **job["load"]).mesh_count
    except HgpError as error:
        rows.append({"mesh": 0, "certified": False, "code": error.code, "message": error.message, "cpu_seconds": 0.0})
        count = 0
    for number in range(count):
        written = folder / job["name"]
        rows.append(_solve(job, folder, number, str(written) if written.exists() else job["source"]))
    temporary = folder / "rows.new"
    temporary.write_text(json.dumps(rows), encoding="utf-8")
    temporary.replace(folder / "rows.json")


if __name__ == "__main__":
    main(sys.argv[1])
