"""A map is what its documentation says, checked here without hgp."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import hgp


def signed_areas(uv: Any, fuv: Any) -> Any:
    a, b, c = (uv[fuv[:, k]] for k in range(3))
    return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def angle_sums(m: hgp.Map) -> Any:
    """The sum of the uv angles at every vertex."""
    sums = np.zeros(len(m.vertices))
    for k in range(3):
        p, a, b = (m.uv[m.fuv[:, (k + j) % 3]] for j in range(3))
        turn = np.angle(((b - p) @ [1, 1j]) / ((a - p) @ [1, 1j]))
        np.add.at(sums, m.triangles[:, k], turn)
    return sums


@pytest.fixture(scope="module")
def mapped(pretzel: Any) -> hgp.Map:
    return hgp.parametrize(*pretzel, q=4)


def test_every_triangle_is_positive(mapped: hgp.Map) -> None:
    assert mapped.certified
    assert signed_areas(mapped.uv, mapped.fuv).min() > 0


def test_every_solved_row_is_positive_whatever_was_repaired(pretzel: Any) -> None:
    V, F = pretzel
    healthy = hgp.parametrize(V, F)
    assert (healthy.solved.fuv == healthy.fuv).all() and (healthy.solved.triangles == F).all()
    given = F.copy()
    turned = [3, 40, 41, 900]
    given[turned] = given[turned][:, [1, 0, 2]]
    more = [[given[7, 1], given[7, 2], given[7, 0]], [5, 5, 6]]
    m = hgp.parametrize(V, np.vstack([more[1:], given, more[:1]]))
    assert m.certified
    assert len(m.fuv) == len(F) + 2
    triangles, fuv, origin = m.solved
    assert signed_areas(m.uv, fuv).min() > 0
    assert (origin == np.arange(1, len(F) + 1)).all()
    assert (np.sort(m.triangles[origin]) == np.sort(triangles)).all()
    assert (m.uv_to_vertex[fuv] == triangles).all()
    # As given, the turned ones are negative.
    assert signed_areas(m.uv, m.fuv[origin[turned]]).max() < 0
    with pytest.raises(ValueError, match="read-only"):
        fuv[0, 0] = 1
    with pytest.raises(hgp.UnsupportedError):
        hgp.parametrize(V, given, strict=True)


def test_angles_at_cones_are_as_stated_and_full_elsewhere(mapped: hgp.Map) -> None:
    k = np.full(len(mapped.vertices), 4)
    for vertex, index in mapped.cones.items():
        k[vertex] = index
    assert len(mapped.cones) > 0
    np.testing.assert_allclose(angle_sums(mapped), k * np.pi / 2, atol=1e-6)


def test_prescribed_cones_are_the_cones_of_the_map(cube: Any) -> None:
    m = hgp.parametrize(*cube, q=4, cones={v: 3 for v in range(8)})
    assert m.certified
    assert dict(m.cones) == {v: 3 for v in range(8)}
    np.testing.assert_allclose(angle_sums(m), np.full(8, 1.5 * np.pi), atol=1e-6)


def test_seams_are_rotations_by_quarter_turns(mapped: hgp.Map) -> None:
    seams = mapped.seams
    assert len(seams.r) == mapped.certificate["seamEdges"] > 0
    a, b = (mapped.uv[rows] @ [1, 1j] for rows in (seams.a, seams.b))
    turned = (a[:, 1] - a[:, 0]) * 1j**seams.r
    np.testing.assert_allclose(b[:, 1] - b[:, 0], turned, atol=1e-9)
    # Both sides are the same edge of the surface.
    assert (mapped.uv_to_vertex[seams.a] == mapped.uv_to_vertex[seams.b]).all()


def test_corners_belong_to_the_vertices_of_their_triangle(mapped: hgp.Map) -> None:
    assert (mapped.uv_to_vertex[mapped.fuv] == mapped.triangles).all()


def test_improve_lowers_the_distortion(pretzel: Any) -> None:
    plain, improved = (hgp.parametrize(*pretzel, improve=how).distortion() for how in (None, "isometric"))
    spread = [float(np.abs(d.log_area).mean() + np.log(d.stretch).mean()) for d in (plain, improved)]
    assert spread[1] < spread[0]
    assert len(improved.stretch) == len(pretzel[1])
    assert len(improved.not_positive) == 0


def test_quads_are_a_closed_mesh_of_quads_on_the_surface(pretzel: Any, tmp_path: Any) -> None:
    m = hgp.parametrize(*pretzel, cells=1500, grid_mode="quad")
    assert m.aligned
    quads = m.quads()
    V, Q = quads.vertices, quads.quads
    edges = np.sort(np.stack([Q, np.roll(Q, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    unique, count = np.unique(edges, axis=0, return_counts=True)
    assert (count == 2).all()
    assert len(V) - len(unique) + len(Q) == 2 - 2 * 3
    quads.save(tmp_path / "quads.obj")
    lines = (tmp_path / "quads.obj").read_text().splitlines()
    assert sum(line.startswith("f ") for line in lines) == len(Q)
    quads.save(tmp_path / "all.glb")
    assert (tmp_path / "all-quads.obj").read_text() == (tmp_path / "quads.obj").read_text()


def test_quads_need_no_density(pretzel: Any) -> None:
    m = hgp.parametrize(*pretzel, grid_mode="quad")
    assert m.aligned and 600 <= len(m.quads().quads) <= 1100


def test_without_a_grid_there_are_no_quads(mapped: hgp.Map) -> None:
    with pytest.raises(hgp.NoMapError, match="not aligned"):
        mapped.quads()


def test_suggested_cones_give_the_same_map(pretzel: Any, mapped: hgp.Map, tmp_path: Any) -> None:
    cones = hgp.suggest_cones(*pretzel)
    assert cones == mapped.cones
    cones.save(tmp_path / "cones.json")
    for given in (cones, cones.document, tmp_path / "cones.json"):
        assert (hgp.parametrize(*pretzel, cones=given).uv == mapped.uv).all()


def test_a_mesh_makes_several_maps_which_stay_as_they_are(pretzel: Any) -> None:
    mesh = hgp.Mesh(*pretzel)
    first = mesh.parametrize()
    kept = first.uv.copy()
    second = mesh.parametrize(q=2)
    assert first.certificate["q"] == 4 and second.certificate["q"] == 2
    assert (first.uv == kept).all()
    assert (mesh.parametrize().uv == kept).all()


def test_a_map_outlives_its_mesh_and_arrays_outlive_their_map(square: Any) -> None:
    uv = hgp.parametrize(*square).uv
    again = [hgp.parametrize(*square).uv for _ in range(3)]
    assert all((other == uv).all() for other in again)


def test_check_and_inspect_solve_nothing_and_say_what_is_wrong(cube: Any) -> None:
    assert hgp.check(*cube, {v: 3 for v in range(8)})["valid"]
    verdict = hgp.check(*cube, {0: 3})
    assert not verdict["valid"]
    assert verdict["components"][0]["error"]["code"] == "prescription"
    info = hgp.inspect(*cube)
    assert info["usable"] and info["components"][0]["genus"] == 0


def test_verify_accepts_a_map_of_ours_and_refuses_what_is_not_one(mapped: hgp.Map) -> None:
    given = (mapped.vertices, mapped.triangles)
    good = hgp.verify(*given, mapped.uv, mapped.fuv, cones=mapped.cones)
    assert good["certified"] and good["flipped"] == 0 and good["brokenSeams"] == 0

    moved = mapped.uv.copy()
    moved[mapped.fuv[0, 0]] += 100.0
    bad = hgp.verify(*given, moved, mapped.fuv)
    assert not bad["certified"] and bad["flipped"] > 0

    mirrored = hgp.verify(*given, mapped.uv * [1, -1], mapped.fuv)
    assert mirrored["flipped"] == len(mapped.fuv)

    other = dict(mapped.cones)
    vertex = next(iter(other))
    other[vertex] -= 1
    assert not hgp.verify(*given, mapped.uv, mapped.fuv, cones=other)["certified"]


def test_verify_takes_uv_per_corner_and_per_vertex(mapped: hgp.Map, square: Any) -> None:
    corners = mapped.uv[mapped.fuv.ravel()]
    assert hgp.verify(mapped.vertices, mapped.triangles, corners)["certified"]
    V, F = square
    assert hgp.verify(V, F, V[:, :2])["certified"]
    with pytest.raises(hgp.UsageError, match="uv has 7 rows, which is neither"):
        hgp.verify(V, F, np.zeros((7, 2)))
    with pytest.raises(hgp.UsageError, match=r"fuv\[0, 0\] is 9; indices are from 0 to 4"):
        hgp.verify(V, F, V[:, :2], F + 9)


def test_verify_reads_numbers_to_the_last_bit(square: Any) -> None:
    V, F = square
    uv = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 5e-324]])
    assert hgp.verify(V, F, uv)["flipped"] == 0
    uv[4, 1] = 0.0
    assert hgp.verify(V, F, uv)["flipped"] == 1


def test_cones_are_completed_and_move_to_another_version(pretzel: Any) -> None:
    V, F = pretzel
    mesh = hgp.Mesh(V, F)
    given = {5: 5}
    made = mesh.balance_cones(given, q=4)
    assert made[5] == 5
    (component,) = mesh.inspect()["components"]
    assert sum(4 - k for k in made.values()) == 4 * component["eulerCharacteristic"]
    assert mesh.check(made)["valid"]
    last = len(V) - 1
    newer = hgp.Mesh(V[::-1].copy(), last - F)
    moved, lost = newer.transfer_cones(made, mesh)
    assert lost == []
    assert dict(moved) == {last - vertex: k for vertex, k in made.items()}
    none, lost = hgp.Mesh(V + 1, F).transfer_cones({5: 3}, mesh)
    assert len(none) == 0
    assert "vertex 5" in lost[0]


def test_quads_need_no_density(pretzel: Any) -> None:
    m = hgp.parametrize(*pretzel, grid_mode="quad")
    assert m.aligned and 600 <= len(m.quads().quads) <= 1100


def test_cells_are_chosen(pretzel: Any) -> None:
    chosen = hgp.parametrize(*pretzel, cells="auto")
    assert chosen.aligned
    assert chosen.report["options"]["grid"]["cells"] >= 800
    with pytest.raises(hgp.UsageError):
        hgp.parametrize(*pretzel, cells="auto", grid=1.0)
