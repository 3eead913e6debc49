"""Lists of edges that lines of a map follow."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import hgp


def test_creases_of_a_cube_are_its_edges(cube: Any) -> None:
    V, F = cube
    for found in (hgp.list_features(V, F), hgp.list_features(V, F, creases=89), hgp.Mesh(V, F).list_features()):
        assert (found.crease_edges, found.rim_edges, found.chains, len(found)) == (12, 0, 12, 12)
        lengths = np.linalg.norm(V[found.edges[:, 0]] - V[found.edges[:, 1]], axis=1)
        assert found.edges.shape == (12, 2) and (lengths == 1).all()
    assert len(hgp.list_features(V, F, creases=91)) == 0


def test_rims_are_the_boundary(square: Any) -> None:
    found = hgp.list_features(*square, rims=True)
    assert found.rim_edges == 4 and {frozenset(edge) for edge in found.edges.tolist()} == {
        frozenset(edge) for edge in ((0, 1), (1, 2), (2, 3), (3, 0))
    }


@pytest.mark.parametrize("name", ["edges.txt", "edges.sharp", "edges.obj", "edges.json"])
def test_a_list_has_the_bytes_of_the_command_line_and_is_read_again(
    name: str, pretzel_file: str, tmp_path: Any, hgp_program: Any
) -> None:
    mesh = hgp.Mesh.load(pretzel_file)
    found = mesh.list_features(creases=30)
    found.save(tmp_path / name)
    hgp_program("features", pretzel_file, "--creases", "30", "-o", tmp_path / f"native-{name}")
    assert (tmp_path / name).read_bytes() == (tmp_path / f"native-{name}").read_bytes()
    again = mesh.list_features(features=tmp_path / name)
    assert len(found) > 0 and {*map(frozenset, again.edges.tolist())} == {*map(frozenset, found.edges.tolist())}


def test_lists_and_arrays_are_features_of_a_map(cube: Any, tmp_path: Any) -> None:
    V, F = cube
    found = hgp.list_features(V, F)
    found.save(tmp_path / "edges.sharp")
    maps = [hgp.parametrize(V, F, features=given) for given in (found, found.edges, tmp_path / "edges.sharp")]
    for m in maps:
        assert m.certified and m.certificate["features"]["straightEdges"] == 12
        assert (m.uv == maps[0].uv).all()
    m = hgp.Mesh(V, F).parametrize(features=[(0, 1)])
    assert m.certificate["features"]["straightEdges"] == 1
    assert "features" not in hgp.parametrize(V, F, features=[]).certificate


def test_what_is_no_list_of_edges_is_refused_by_name(cube: Any) -> None:
    for given, message in (
        ([(0.5, 1)], "features must have integers"),
        ([(0, 1, 2)], "features must be an n × 2 array"),
        ([(0, 99)], "99"),
        ([(0, 7)], "no edge|not an edge|is no edge"),
        ([(-1, 0)], "features"),
    ):
        with pytest.raises(hgp.HgpError, match=message):
            hgp.parametrize(*cube, features=given)


def test_the_document_of_a_list_is_one_of_cones(cube: Any, tmp_path: Any) -> None:
    hgp.list_features(*cube).save(tmp_path / "list.json")
    document = json.loads((tmp_path / "list.json").read_text())
    assert document["format"] == "hgp-cones" and "cones" not in document
