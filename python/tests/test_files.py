"""Files are read and written as by the command line, byte for byte."""

from __future__ import annotations

import gzip
import json
import pathlib
import shutil
import subprocess
import sys
from typing import Any

import pytest

import hgp


@pytest.fixture(scope="module")
def glb(pretzel_file: str, tmp_path_factory: Any, hgp_program: Any) -> pathlib.Path:
    made: pathlib.Path = tmp_path_factory.mktemp("glb") / "pretzel.glb"
    hgp_program("param", pretzel_file, "-o", made)
    return made


def same_bytes(mesh: hgp.Mesh, source: object, name: str, folder: Any, program: Any, **words: Any) -> None:
    options, flags = words.get("options", {}), words.get("flags", [])
    mesh.parametrize(reproducible=True, **options).save(folder / name)
    program("param", source, "-o", folder / f"native-{name}", "--reproducible", *flags)
    assert (folder / name).read_bytes() == (folder / f"native-{name}").read_bytes()


def test_same_bytes_as_the_command_line(pretzel_file: str, tmp_path: Any, hgp_program: Any) -> None:
    mesh = hgp.Mesh.load(pretzel_file)
    same_bytes(mesh, pretzel_file, "plain.obj", tmp_path, hgp_program)
    more = {"improve": "isometric", "q": 2}
    flags = ["--improve", "isometric", "--q", "2"]
    same_bytes(mesh, pretzel_file, "improved.obj", tmp_path, hgp_program, options=more, flags=flags)
    flags = ["--cells", "900", "--grid-mode", "quad"]
    more = {"cells": 900, "grid_mode": "quad"}
    same_bytes(mesh, pretzel_file, "grid.obj", tmp_path, hgp_program, options=more, flags=flags)


def test_same_bytes_of_gltf_and_after_conversion(
    pretzel_file: str, glb: pathlib.Path, tmp_path: Any, hgp_program: Any
) -> None:
    same_bytes(hgp.Mesh.load(glb), glb, "again.glb", tmp_path, hgp_program)
    same_bytes(hgp.Mesh.load(pretzel_file, target="glb"), pretzel_file, "new.glb", tmp_path, hgp_program)


def test_other_formats_are_those_of_also(pretzel_file: str, tmp_path: Any, hgp_program: Any) -> None:
    m = hgp.Mesh.load(pretzel_file).parametrize(reproducible=True)
    names = ["x.glb", "x.flat.obj", "x.svg"]
    also = [word for name in names for word in ("--also", tmp_path / f"native-{name}")]
    hgp_program("param", pretzel_file, "-o", tmp_path / "x.obj", "--reproducible", *also)
    for name in names:
        m.save(tmp_path / name)
        assert (tmp_path / name).read_bytes() == (tmp_path / f"native-{name}").read_bytes(), name


def test_arrays_are_saved_as_files_that_the_command_line_certifies(
    square: Any, tmp_path: Any, hgp_program: Any
) -> None:
    m = hgp.parametrize(*square)
    for name in ("square.obj", "square.glb"):
        m.save(tmp_path / name)
        assert hgp.Mesh.load(tmp_path / name).verify()["certified"]
        hgp_program("verify", tmp_path / name)


def test_the_report_is_that_of_the_command_line(pretzel_file: str, tmp_path: Any, hgp_program: Any) -> None:
    report = hgp.Mesh.load(pretzel_file).parametrize(reproducible=True).report
    hgp_program("param", pretzel_file, "-o", tmp_path / "x.obj", "--reproducible", "--json", tmp_path / "r.json")
    other = json.loads((tmp_path / "r.json").read_text())
    assert report["certificate"] == other["certificate"] and report["cones"] == other["cones"]


def test_the_loaded_file_is_replaced_only_if_asked(pretzel_file: str, tmp_path: Any) -> None:
    path = tmp_path / "mesh.obj"
    shutil.copy(pretzel_file, path)
    m = hgp.Mesh.load(path).parametrize()
    with pytest.raises(hgp.UsageError, match="overwrite=True allows"):
        m.save(path)
    m.save(path, overwrite=True)
    assert hgp.Mesh.load(path).verify(m.cones)["certified"]


def test_side_files_travel_along(glb: pathlib.Path, tmp_path: Any) -> None:
    hgp.Mesh.load(glb, target="gltf").parametrize().save(tmp_path / "m.gltf")
    names = sorted(path.name for path in tmp_path.iterdir())
    assert len(names) == 2 and hgp.Mesh.load(tmp_path / "m.gltf").verify()["certified"]
    other = tmp_path / "other"
    other.mkdir()
    hgp.Mesh.load(tmp_path / "m.gltf").parametrize().save(other / "m.gltf")
    assert hgp.Mesh.load(other / "m.gltf").verify()["certified"]


def test_gzip_is_read(pretzel_file: str, tmp_path: Any) -> None:
    packed = tmp_path / "mesh.obj.gz"
    packed.write_bytes(gzip.compress(pathlib.Path(pretzel_file).read_bytes()))
    assert len(hgp.Mesh.load(packed).triangles) == 2080


def test_cones_can_be_stored_in_the_file(pretzel_file: str, tmp_path: Any) -> None:
    m = hgp.Mesh.load(pretzel_file).parametrize(q=2)
    m.save(tmp_path / "m.obj", embed_cones=True)
    again = hgp.Mesh.load(tmp_path / "m.obj")
    assert again.embedded_cones == m.cones
    assert again.parametrize().cones.q == 2
    assert again.parametrize(ignore_embedded=True).cones.q == 4


def test_the_module_is_the_command_line(pretzel_file: str, tmp_path: Any, hgp_program: Any) -> None:
    env = {"PYTHONPATH": str(pathlib.Path(hgp.__file__).parents[1]), "PATH": "/usr/bin:/bin"}

    def run(*words: object) -> "subprocess.CompletedProcess[str]":
        command = [sys.executable, "-m", "hgp", *map(str, words)]
        return subprocess.run(command, env=env, capture_output=True, text=True)

    assert run("--version").stdout == hgp_program("--version").stdout
    assert run("param", "--help").stdout == hgp_program("param", "--help").stdout
    assert run("param", pretzel_file, "-o", tmp_path / "m.obj", "--reproducible").returncode == 0
    hgp_program("param", pretzel_file, "-o", tmp_path / "n.obj", "--reproducible")
    assert (tmp_path / "m.obj").read_bytes() == (tmp_path / "n.obj").read_bytes()
    assert run("inspect", tmp_path / "missing.obj").returncode == 3
    assert run("param", pretzel_file).returncode == 2
