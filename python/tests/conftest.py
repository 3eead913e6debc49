"""What all tests use. They test what is in build/native-release, or in the build folder that HGP_BUILD names."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys
from typing import Any, Callable, List, Tuple

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / os.environ.get("HGP_BUILD", "build/native-release")
sys.path.insert(0, str(BUILD / "python"))

import hgp  # noqa: E402

Arrays = Tuple["np.ndarray[Any, Any]", "np.ndarray[Any, Any]"]


def pytest_collection_modifyitems(config: pytest.Config, items: List[pytest.Item]) -> None:
    """Long tests, and those that need large packages, run only with scripts/test --full; those in Blender, which takes five
    seconds, wherever it is installed."""
    left_out = {"full"} if os.environ.get("HGP_FULL") != "1" else set()
    if shutil.which("blender") is None and left_out:
        left_out.add("blender")
    out = [item for item in items if any(item.get_closest_marker(marker) for marker in left_out)]
    items[:] = [item for item in items if item not in out]
    config.hook.pytest_deselected(items=out)
    if any(item.get_closest_marker("blender") for item in out):
        reporter: Any = config.pluginmanager.get_plugin("terminalreporter")
        reporter.write_line("SKIPPING the add-on in Blender: scripts/setup full installs Blender, which is large")


@pytest.fixture(scope="session")
def pretzel_file() -> str:
    """2080 triangles, genus 3."""
    return str(ROOT / "examples/meshes/pretzel.obj")


@pytest.fixture(scope="session")
def pretzel(pretzel_file: str) -> Arrays:
    mesh = hgp.Mesh.load(pretzel_file)
    return mesh.vertices, mesh.triangles


@pytest.fixture(scope="session")
def square() -> Arrays:
    """A square with a raised middle."""
    V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.4, 0.5, 0.3]])
    return V, np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])


@pytest.fixture(scope="session")
def cube() -> Arrays:
    V = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return V, np.array([t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])])


@pytest.fixture(scope="session")
def hgp_program() -> Callable[..., "subprocess.CompletedProcess[str]"]:
    """Runs the native command line."""

    def run(*words: object) -> "subprocess.CompletedProcess[str]":
        command = [str(BUILD / "bin/hgp"), *map(str, words)]
        return subprocess.run(command, check=True, capture_output=True, text=True)

    return run
