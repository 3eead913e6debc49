"""The wheel: built twice it has the same bytes, and it contains what it lists."""

from __future__ import annotations

import base64
import hashlib
import importlib.util
import os
import pathlib
import re
import zipfile
from typing import Any

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("HGP_BUILD", "build/native-release")


@pytest.fixture(scope="module")
def backend() -> Any:
    spec = importlib.util.spec_from_file_location("hgp_build", ROOT / "python/backend/hgp_build.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_wheel_is_complete_and_reproducible(backend: Any, tmp_path: Any) -> None:
    wheels = []
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        wheels.append(tmp_path / name / backend.build_wheel(str(tmp_path / name), {"builddir": BUILD}))
    first, second = (wheel.read_bytes() for wheel in wheels)
    assert first == second
    with zipfile.ZipFile(wheels[0]) as archive:
        names = set(archive.namelist())
        (info,) = {name.split("/")[0] for name in names if ".dist-info/" in name}
        record = archive.read(f"{info}/RECORD").decode().splitlines()
        assert {line.split(",")[0] for line in record} == names
        for line in record:
            path, digest, _ = line.split(",")
            if digest:
                actual = base64.urlsafe_b64encode(hashlib.sha256(archive.read(path)).digest()).rstrip(b"=").decode()
                assert digest == f"sha256={actual}", path
        # The files that other languages' package managers would call licences.
        assert {f"{info}/{name}" for name in backend.LEGAL} <= names
        # Everything that the module needs from outside the C and C++ runtime travels along.
        assert any(name.startswith("hgp/libdraco.so") for name in names)
        assert {path.name for path in (ROOT / "python/hgp").iterdir() if path.is_file()} <= {
            name.split("/")[1] for name in names
        }
        assert "Requires-Dist: numpy" in archive.read(f"{info}/METADATA").decode()


def test_version_and_metadata_are_those_of_the_project(backend: Any, monkeypatch: Any) -> None:
    import hgp

    assert backend.version() == hgp.__version__
    whole = backend.metadata()
    # The same without tomllib, as in older Pythons.
    monkeypatch.setattr(backend, "tomllib", None)
    assert backend.metadata() == whole and backend.scripts().startswith("[console_scripts]\nhgp = ")


def test_the_version_is_the_same_in_all_manifests(backend: Any) -> None:
    package = (ROOT / "wasm/package/package.json").read_text(encoding="utf-8")
    (found,) = re.findall(r'^  "version": "([^"]+)"', package, re.M)
    assert found == backend.version()


def test_the_sources_are_complete(backend: Any, tmp_path: Any) -> None:
    import tarfile

    name = backend.build_sdist(str(tmp_path))
    with tarfile.open(tmp_path / name) as archive:
        names = set(archive.getnames())
    top = name[: -len(".tar.gz")]
    for file in ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "python/backend/hgp_build.py", "core/hgp/eigen.h"):
        assert f"{top}/{file}" in names
    assert not any(pathlib.PurePath(path).parts[1:2] == ("build",) for path in names)
