"""Examples of the documentation run as printed."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import hgp

ROOT = pathlib.Path(__file__).resolve().parents[2]


def example(file: str) -> str:
    (text,) = re.findall(r"^```py\n(.*?)^```$", (ROOT / file).read_text(encoding="utf-8"), re.M | re.S)
    return str(text)


def test_the_example_of_the_readme(tmp_path: Any, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    names: Any = {}
    exec(example("README.md"), names)
    assert names["m"].certified
    assert hgp.Mesh.load("mapped.glb").verify()["certified"]


def test_the_example_of_the_package(tmp_path: Any, monkeypatch: Any, pretzel: Any) -> None:
    monkeypatch.chdir(tmp_path)
    V, F = pretzel
    cones = hgp.suggest_cones(V, F, cones_for="few")
    text = example("python/README.md")
    assert "cones={12: 3, 40: 5}" in text
    names: Any = {"V": V, "F": F, "cones": cones}
    exec(text.replace("cones={12: 3, 40: 5}", "cones=cones"), names)
    assert names["m"].certified
    assert hgp.Mesh.load("out.glb").verify()["certified"]


def test_the_readme_names_everything_public() -> None:
    text = (ROOT / "python/README.md").read_text(encoding="utf-8")
    documents = {"Certificate", "Check", "ConesDocument", "MeshInfo", "Report"}
    pieces = {"Cones", "Distortion", "Features", "FileResult", "Loops", "MeshOutcome", "Place", "Progress", "Quads", "Seams"}
    for name in set(hgp.__all__) - documents - pieces:
        assert name in text, name


def test_the_reference_has_everything_public() -> None:
    sources = (ROOT / "site/sphinx/python").glob("*.rst")
    named = set(re.findall(r"^.. auto\w+:: hgp\.(\w+)$", "\n".join(path.read_text() for path in sources), re.M))
    assert {"_documents"} <= named  # with all members
    documents = {"Certificate", "Check", "ConesDocument", "MeshInfo", "Report"}
    assert set(hgp.__all__) - documents - named == set()


@pytest.mark.full
def test_the_picture_of_the_documentation_is_what_the_example_draws(tmp_path: Any, pretzel_file: str) -> None:
    import matplotlib.image

    script = ROOT / "python/examples/plot_map.py"
    env = {**os.environ, "PYTHONPATH": str(pathlib.Path(hgp.__file__).parents[1])}
    subprocess.run([sys.executable, str(script), pretzel_file, str(tmp_path / "p.png")], check=True, env=env)
    drawn, kept = (matplotlib.image.imread(path) for path in (tmp_path / "p.png", ROOT / "docs/images/python.png"))
    assert drawn.shape == kept.shape
    assert float(np.abs(drawn - kept).mean()) < 0.02
