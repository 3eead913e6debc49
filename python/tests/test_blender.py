"""The add-on in Blender, and what of it needs no Blender."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
import zipfile
from typing import Any

import numpy as np
import pytest

import hgp

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / os.environ.get("HGP_BUILD", "build/native-release")
sys.path.insert(0, str(ROOT / "blender/hgp_uv"))
import exchange  # noqa: E402


def pack(out: pathlib.Path) -> None:
    command = [sys.executable, str(ROOT / "blender/pack.py"), str(out), str(BUILD / "python/hgp")]
    subprocess.run(command, check=True)


def prism() -> Any:
    """A closed mesh of triangles, quads and a hexagon, float32."""
    turn = np.exp(2j * np.pi * np.arange(6) / 6)
    ring = np.stack([turn.real, turn.imag], axis=1)
    positions = np.vstack([np.c_[ring, np.zeros(6)], np.c_[ring, np.ones(6)], [[0, 0, 1.5]]]).astype(np.float32)
    faces = [list(range(6))[::-1]]
    faces += [[i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i] for i in range(6)]
    faces += [[6 + i, 6 + (i + 1) % 6, 12] for i in range(6)]
    corners = np.array([v for face in faces for v in face], np.int32)
    return exchange.Polygons(positions, corners, np.array([len(face) for face in faces], np.int32))


def test_polygons_travel_through_ply_and_back(tmp_path: Any) -> None:
    given = prism()
    exchange.write_ply(tmp_path / "in.ply", given)
    mesh = hgp.Mesh.load(tmp_path / "in.ply")
    assert (mesh.vertices == given.positions).all()
    m = mesh.parametrize()
    assert m.certified
    m.save(tmp_path / "out.ply")
    uv = exchange.read_uv(tmp_path / "out.ply", given.sizes)
    assert uv.shape == (len(given.corners), 2)
    # Every corner of a triangle is a corner of its polygon, with the same uv.
    here = {(int(v), *map(float, row)) for v, row in zip(given.corners, uv)}
    assert here == {(int(v), *map(float, row)) for v, row in zip(m.triangles.ravel(), m.uv[m.fuv.ravel()])}
    exchange.write_ply(tmp_path / "again.ply", given, uv)
    assert hgp.Mesh.load(tmp_path / "again.ply").verify(m.cones)["certified"]
    with pytest.raises(ValueError, match="other polygons"):
        exchange.read_uv(tmp_path / "out.ply", given.sizes[:-1])


def test_the_zip_is_reproducible_and_complete(tmp_path: Any) -> None:
    for name in ("a.zip", "b.zip"):
        pack(tmp_path / name)
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        names = archive.namelist()
        text = archive.read("hgp_uv/__init__.py").decode()
    assert f'"version": ({hgp.__version__.replace(".", ", ")})' in text
    assert {f"hgp_uv/{path.name}" for path in (ROOT / "blender/hgp_uv").glob("*.py")} <= set(names)
    assert any(name.startswith("hgp_uv/bundled/hgp/_core.") for name in names)


@pytest.mark.blender
def test_in_blender(tmp_path: Any) -> None:
    """Ten models compared with the command line, cones, seams, quads, both engines, cancelling."""
    pack(tmp_path / "addon.zip")
    script = ROOT / "blender/tests/in_blender.py"
    env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    words = ["--", str(tmp_path / "addon.zip"), str(BUILD / "bin/hgp"), str(tmp_path)]
    ran = subprocess.run(
        ["blender", "--background", "--factory-startup", "--python", str(script), *words],
        env={**env, "HOME": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert "ALL OK" in ran.stdout, ran.stdout + ran.stderr
    assert ran.returncode == 0
