"""Batches: everything once, whole, and whatever happens to a worker."""

from __future__ import annotations

import base64
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
from typing import Any, Dict, Iterator, List

import numpy as np
import pytest

import hgp
from hgp._batch import _names
from hgp._batch_main import main

PLACE = str(pathlib.Path(str(hgp._core.__file__)).parents[1])


def two_meshes(path: pathlib.Path, cube: Any) -> None:
    """A .gltf with two cubes, one of them wrong: it has a triangle between three others at one edge."""
    V, F = (cube[0].astype("<f4"), cube[1].astype("<u2"))
    data = V.tobytes() + F.tobytes()
    buffer = {"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}
    primitive = {"attributes": {"POSITION": 0}, "indices": 1}
    path.write_text(
        json.dumps(
            {
                "asset": {"version": "2.0"},
                "buffers": [buffer],
                "bufferViews": [
                    {"buffer": 0, "byteLength": V.nbytes},
                    {"buffer": 0, "byteOffset": V.nbytes, "byteLength": F.nbytes},
                ],
                "accessors": [
                    {
                        **{"bufferView": 0, "componentType": 5126, "count": len(V), "type": "VEC3"},
                        **{"min": V.min(axis=0).tolist(), "max": V.max(axis=0).tolist()},
                    },
                    {"bufferView": 1, "componentType": 5123, "count": F.size, "type": "SCALAR"},
                ],
                "meshes": [{"primitives": [primitive]}, {"primitives": [primitive]}],
                "nodes": [{"mesh": 0}, {"mesh": 1}],
                "scenes": [{"nodes": [0, 1]}],
            }
        )
    )


def columns(folder: pathlib.Path) -> List[Dict[str, str]]:
    with open(folder / "results.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Cluster:
    """A scheduler and two workers as programs of their own."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.file = folder / "scheduler.json"
        self.folder = folder
        self.processes: Dict[str, "subprocess.Popen[bytes]"] = {}
        self.start("scheduler", "dask_scheduler", "--port", "0", "--host", "127.0.0.1", "--no-dashboard")
        for name in ("w0", "w1"):
            options = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--name", name]
            self.start(name, "dask_worker", *options, "--local-directory", str(folder))
        while not self.file.exists():
            time.sleep(0.05)
        self.address = json.loads(self.file.read_text())["address"]

    def start(self, name: str, module: str, *words: str) -> None:
        command = [sys.executable, "-m", f"distributed.cli.{module}", "--scheduler-file", str(self.file), *words]
        log = open(self.folder / f"{name}.log", "wb")
        env = {**os.environ, "PYTHONPATH": PLACE}
        self.processes[name] = subprocess.Popen(command, env=env, stdout=log, stderr=log)

    def stop(self) -> None:
        for process in self.processes.values():
            process.kill()
            process.wait()


@pytest.fixture
def cluster(tmp_path: pathlib.Path) -> Iterator[Cluster]:
    made = Cluster(tmp_path)
    yield made
    made.stop()


def test_a_worker_is_killed_midway(cluster: Cluster, pretzel_file: str, tmp_path: pathlib.Path) -> None:
    meshes, out = tmp_path / "meshes", tmp_path / "out"
    meshes.mkdir()
    for n in range(14):
        shutil.copy(pretzel_file, meshes / f"{n}.obj")
    workers: List[str] = []
    inodes: Dict[str, int] = {}

    def on_row(row: Any, done: int, total: int) -> None:
        workers.append(row["worker"])
        assert row["certified"] and row["file"] not in inodes
        inodes[row["file"]] = (out / row["map"]).stat().st_ino
        # The second worker has begun another file by then.
        if "w1" in workers and cluster.processes["w1"].poll() is None:
            cluster.processes["w1"].send_signal(signal.SIGKILL)
        assert total == 14

    done = hgp.batch(meshes, out, scheduler=cluster.address, on_row=on_row, improve="isometric", reproducible=True)
    assert cluster.processes["w1"].poll() == -signal.SIGKILL
    assert done.certified == len(done.rows) == 14 and done.kept == 0
    assert [row["file"] for row in done.rows] == sorted((f"{n}.obj" for n in range(14)))
    assert set(workers) == {"w0", "w1"} and workers.count("w1") < 7
    # Nothing that was certified has been done again, and nothing is left half done.
    assert {row["file"]: (out / row["map"]).stat().st_ino for row in done.rows} == inodes
    assert not (out / ".tmp").exists()
    first = (out / "maps/0.obj").read_bytes()
    assert all((out / row["map"]).read_bytes() == first for row in done.rows)
    assert hgp.Mesh.load(out / "maps/13.obj").verify()["certified"]

    # Again: everything is known, and no worker is asked.
    cluster.stop()
    again = hgp.batch(meshes, out, scheduler=cluster.address, improve="isometric", reproducible=True)
    assert again.kept == 14 and again.rows == done.rows


def test_every_kind_of_file_has_its_rows(cube: Any, square: Any, pretzel_file: str, tmp_path: pathlib.Path) -> None:
    meshes, out = tmp_path / "meshes", tmp_path / "out"
    (meshes / "sub").mkdir(parents=True)
    shutil.copy(pretzel_file, meshes / "a.obj")
    two_meshes(meshes / "b.gltf", cube)
    (meshes / "broken.obj").write_text("v 0 0 0\nf 1 2 3\n")
    hgp.parametrize(*square).save(meshes / "sub/a.obj")
    (meshes / "notes.txt").write_text("no mesh")
    assert main([str(meshes), "-o", str(out), "--workers", "2", "--quiet", "--q", "2"]) == 6
    rows = columns(out)
    assert [(row["file"], row["mesh"], row["certified"]) for row in rows] == [
        ("a.obj", "0", "True"),
        ("b.gltf", "0", "True"),
        ("b.gltf", "1", "True"),
        ("broken.obj", "0", "False"),
        ("sub/a.obj", "0", "True"),
    ]
    assert rows[3]["code"] == "malformed" and "line 2" in rows[3]["message"]
    assert rows[0]["triangles"] == "2080" and rows[0]["q"] == "2" and float(rows[0]["peak_memory_mb"]) > 10
    both = hgp.Mesh.load(out / "maps/b.glb")
    assert both.mesh_count == 2
    assert all(hgp.Mesh.load(out / "maps/b.glb", mesh=n).verify(q=2)["certified"] for n in (0, 1))
    assert json.loads((out / rows[2]["report"]).read_text())["certificate"]["certified"]
    assert (out / rows[0]["thumbnail"]).read_bytes().startswith(b"\x89PNG")
    page = (out / "index.html").read_text()
    assert "4 of 5 meshes certified, 1 malformed" in page and page.index("broken.obj") < page.index("sub/a.obj")
    assert "http" not in page and "<script" not in page

    # What failed is done again, and what is changed or asked with other options.
    (meshes / "broken.obj").write_text((meshes / "sub/a.obj").read_text())
    again = hgp.batch(meshes, out, workers=1, q=2)
    assert (again.certified, again.kept) == (5, 3)
    other = hgp.batch([meshes / "sub"], out, workers=1, q=1)
    assert (other.certified, other.kept) == (1, 0)


def test_a_process_that_takes_too_much_ends_alone(pretzel_file: str, tmp_path: pathlib.Path) -> None:
    out = tmp_path / "out"
    late = hgp.batch(pretzel_file, out, workers=1, hard_limit=0.01).rows[0]
    assert (late["code"], late["message"]) == ("no-map", "stopped after 0.01 s")
    small = hgp.batch(pretzel_file, out, workers=1, memory_limit=1).rows[0]
    assert small["code"] in ("limit", "internal") and not small["certified"]
    assert hgp.batch(pretzel_file, out, workers=1).certified == 1


def test_names_are_below_the_common_folder_and_all_different() -> None:
    files = [pathlib.Path("/m/x/a.obj"), pathlib.Path("/m/x/a.off"), pathlib.Path("/m/y/a.obj.gz"), pathlib.Path("/m/b.STL")]
    assert _names(files, None) == [
        ("x/a.obj", "x/a.obj"),
        ("x/a.off", "x/a.off.obj"),
        ("y/a.obj.gz", "y/a.obj"),
        ("b.STL", "b.obj"),
    ]
    assert _names(files[:1], ".glb") == [("a.obj", "a.glb")]


def test_wrong_calls_are_refused_by_name(pretzel_file: str, tmp_path: pathlib.Path) -> None:
    with pytest.raises(hgp.UsageError, match="batch has no option 'Q'"):
        hgp.batch(pretzel_file, tmp_path, Q=4)
    with pytest.raises(hgp.UsageError, match="there are no files"):
        hgp.batch(tmp_path, tmp_path)
    with pytest.raises(hgp.UsageError, match="table must end"):
        hgp.batch(pretzel_file, tmp_path, table="x.xls")
    (tmp_path / "out").mkdir()
    import fcntl

    with open(tmp_path / "out/.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with pytest.raises(hgp.UsageError, match="another batch writes into"):
            hgp.batch(pretzel_file, tmp_path / "out")


def test_a_picture_shows_the_surface(pretzel: Any) -> None:
    from hgp._thumbnail import thumbnail

    import zlib

    data = thumbnail(hgp.parametrize(*pretzel), 64)
    start = data.index(b"IDAT") + 4
    rows = np.frombuffer(zlib.decompress(data[start:-16]), np.uint8).reshape(64, 1 + 3 * 64)[:, 1:].reshape(64, 64, 3)
    drawn = (rows < 255).any(axis=2)
    assert 0.25 < drawn.mean() < 0.75 and drawn[:, 2:-2].any(axis=0).all()
    assert len(np.unique(rows[drawn], axis=0)) > 50
