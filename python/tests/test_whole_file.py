"""Files of several meshes: mapped and written at once, as by the command line."""

from __future__ import annotations

import base64
import inspect
import json
import os
import pathlib
from typing import Any, List, Tuple

import numpy as np
import pytest

import hgp

Arrays = Tuple["np.ndarray[Any, Any]", "np.ndarray[Any, Any]"]


def scene(path: pathlib.Path, meshes: List[Arrays]) -> pathlib.Path:
    """A .gltf with these meshes, written here and not by hgp."""
    data, views, accessors = b"", [], []
    for V, F in meshes:
        for array, kind in ((V.astype("<f4"), 5126), (F.astype("<u4").ravel(), 5125)):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
            entry = {"bufferView": len(accessors), "componentType": kind, "count": len(array)}
            if kind == 5126:
                entry.update(type="VEC3", min=array.min(0).tolist(), max=array.max(0).tolist())
            accessors.append({"type": "SCALAR", **entry})
            data += array.tobytes()
    parts = [{"primitives": [{"attributes": {"POSITION": 2 * i}, "indices": 2 * i + 1}]} for i in range(len(meshes))]
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    whole = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(data), "uri": uri}], "bufferViews": views}
    path.write_text(json.dumps({**whole, "accessors": accessors, "meshes": parts}))
    return path


@pytest.fixture(scope="module")
def fan() -> Arrays:
    """Three triangles at one edge, which is no surface with one side and another, closed so that no repair helps."""
    V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0.5]], float)
    return V, np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]])


@pytest.fixture()
def three(tmp_path: Any, pretzel: Any, cube: Any, square: Any) -> pathlib.Path:
    return scene(tmp_path / "three.gltf", [cube, pretzel, square])


def test_all_meshes_have_the_bytes_of_the_command_line(three: Any, tmp_path: Any, hgp_program: Any) -> None:
    for name, options, flags in (
        ("a.gltf", {}, []),
        ("b.glb", {"improve": "isometric", "grid_material": 0}, ["--improve", "isometric", "--grid-material"]),
        ("c.gltf", {"cells": 1200, "embed": True}, ["--cells", "1200", "--embed"]),
    ):
        done = hgp.parametrize_file(three, tmp_path / name, reproducible=True, **options)  # type: ignore[arg-type]
        assert done.certified and done.path == str(tmp_path / name)
        assert [one.mesh for one in done.meshes] == [0, 1, 2] and all(one.good and one.report for one in done.meshes)
        hgp_program("param", three, "-o", tmp_path / f"native-{name}", "--reproducible", *flags)
        assert (tmp_path / name).read_bytes() == (tmp_path / f"native-{name}").read_bytes()
        for mesh in range(3):
            assert hgp.Mesh.load(tmp_path / name, mesh=mesh).verify()["certified"]


def test_polygon_files_become_gltf_and_stay_what_they_are(pretzel_file: str, tmp_path: Any, hgp_program: Any) -> None:
    for name in ("one.obj", "one.glb"):
        done = hgp.parametrize_file(pretzel_file, tmp_path / name, reproducible=True)
        assert done.certified and len(done.meshes) == 1
        hgp_program("param", pretzel_file, "-o", tmp_path / f"native-{name}", "--reproducible")
        assert (tmp_path / name).read_bytes() == (tmp_path / f"native-{name}").read_bytes()


def test_a_mesh_without_a_map_is_in_the_outcome_and_left_as_it_was(
    tmp_path: Any, pretzel: Any, fan: Any, cube: Any
) -> None:
    source = scene(tmp_path / "bad.gltf", [pretzel, fan, cube])
    options: Any = {"fix": []}
    strict = hgp.parametrize_file(source, tmp_path / "x.gltf", **options)
    assert not strict.certified and strict.path is None and not (tmp_path / "x.gltf").exists()
    assert [one.certified for one in strict.meshes] == [True, False, True]
    bad = strict.meshes[1]
    assert isinstance(bad.error, hgp.UnsupportedError) and bad.error.places and bad.report is None
    kept = hgp.parametrize_file(source, tmp_path / "x.gltf", keep_going=True, **options)
    assert not kept.certified and kept.path == str(tmp_path / "x.gltf")
    written = json.loads((tmp_path / "x.gltf").read_text())
    has_uv = ["TEXCOORD_0" in mesh["primitives"][0]["attributes"] for mesh in written["meshes"]]
    assert has_uv == [True, False, True]


def test_progress_names_the_mesh_and_cancels_the_file(three: Any, tmp_path: Any) -> None:
    reports: List[hgp.Progress] = []
    hgp.parametrize_file(three, tmp_path / "x.gltf", progress=reports.append)
    assert list(dict.fromkeys(report.mesh for report in reports)) == [0, 1, 2]
    with pytest.raises(hgp.Cancelled):
        hgp.parametrize_file(three, tmp_path / "y.gltf", progress=lambda p: p.mesh < 1)
    with pytest.raises(hgp.NoMapError, match="time_limit"):
        hgp.parametrize_file(three, tmp_path / "y.gltf", time_limit=1e-9)
    assert not (tmp_path / "y.gltf").exists()


def test_what_cannot_be_is_refused_before_anything_is_solved(three: Any, tmp_path: Any) -> None:
    reports: List[hgp.Progress] = []
    for options, message in (
        ({"refine": True}, "refine is for one mesh"),
        ({"boundary": "convex", "creases": True}, "cannot be combined"),
        ({"method": "fast"}, "method must be"),
        ({"time_limit": 0}, "time_limit must be"),
    ):
        with pytest.raises(hgp.UsageError, match=message):
            hgp.parametrize_file(three, tmp_path / "x.gltf", progress=reports.append, **options)  # type: ignore[arg-type]
    with pytest.raises(hgp.UsageError, match="overwrite=True allows"):
        hgp.parametrize_file(three, three, progress=reports.append)
    with pytest.raises(hgp.WriteError):
        hgp.parametrize_file(three, tmp_path / "nowhere" / "x.gltf", progress=reports.append)
    assert reports == []
    assert hgp.parametrize_file(three, three, overwrite=True).certified


def test_features_are_those_of_every_mesh(tmp_path: Any, cube: Any) -> None:
    V, F = cube
    source = scene(tmp_path / "cubes.gltf", [(V, F), (2 * V, F)])
    done = hgp.parametrize_file(source, tmp_path / "x.gltf", creases=True)
    for one in done.meshes:
        assert one.certified and one.report
        assert one.report["certificate"]["features"]["straightEdges"] == 12


def test_maps_with_cones_of_their_own_go_into_one_file(three: Any, tmp_path: Any, hgp_program: Any) -> None:
    first = hgp.Mesh.load(three, mesh=0).parametrize(cones={v: 3 for v in range(8)})
    second = hgp.Mesh.load(three, mesh=1).parametrize(cones=hgp.Mesh.load(three, mesh=1).suggest_cones(q=2))
    hgp.combine([first, second], tmp_path / "both.gltf", embed_cones=True)
    again = [hgp.Mesh.load(tmp_path / "both.gltf", mesh=mesh) for mesh in range(3)]
    assert again[0].verify(first.cones)["certified"] and again[1].verify(second.cones)["certified"]
    assert [mesh.embedded_cones for mesh in again] == [first.cones, second.cones, None]
    with pytest.raises(hgp.HgpError):
        again[2].verify()
    hgp.combine([first], tmp_path / "alone.gltf")
    assert hgp.Mesh.load(tmp_path / "alone.gltf", mesh=0).verify()["certified"]


def test_maps_that_belong_to_different_files_are_not_combined(
    three: Any, tmp_path: Any, pretzel: Any, cube: Any, square: Any
) -> None:
    maps = [hgp.Mesh.load(three, mesh=mesh).parametrize() for mesh in range(2)]
    (tmp_path / "other").mkdir()
    other = scene(tmp_path / "other/three.gltf", [cube, pretzel, square])
    strange = [hgp.Mesh.load(other, mesh=1).parametrize(), hgp.parametrize(*square)]
    out = tmp_path / "out.gltf"
    for pair in ([maps[0], strange[0]], [maps[0], strange[1]], [strange[1], maps[0]], []):
        with pytest.raises(hgp.UsageError):
            hgp.combine(pair, out)
    with pytest.raises(hgp.UsageError, match="same mesh"):
        hgp.combine([maps[0], maps[0]], out)
    scene(pathlib.Path(three), [cube, pretzel, cube])
    with pytest.raises(hgp.UsageError, match="of one file"):
        hgp.combine([maps[0], hgp.Mesh.load(three, mesh=1).parametrize()], out)
    assert not os.path.exists(out)


def test_options_and_their_defaults_are_those_of_the_calls_for_one_mesh() -> None:
    whole = inspect.signature(hgp.parametrize_file).parameters
    for call in (hgp.Mesh.load, hgp.Mesh.parametrize, hgp.Map.save):
        for name, parameter in inspect.signature(call).parameters.items():
            if name in ("self", "path", "mesh", "target", "cones", "turning", "handles", "field"):
                continue  # of one mesh; the target is the ending of `out`
            assert (whole[name].default, whole[name].annotation) == (parameter.default, parameter.annotation), name
    for name, parameter in list(inspect.signature(hgp.combine).parameters.items())[2:]:
        assert whole[name] == parameter


def test_quads_take_the_pictures_of_a_gltf_along(pretzel: Any, tmp_path: Any, hgp_program: Any) -> None:
    path = scene(tmp_path / "painted.gltf", [pretzel])
    whole = json.loads(path.read_text())
    # Coordinates of a texture: x and y of the positions, which have a stride of twelve bytes.
    whole["bufferViews"][0]["byteStride"] = 12
    whole["accessors"].append({"bufferView": 0, "componentType": 5126, "type": "VEC2", "count": len(pretzel[0])})
    primitive = whole["meshes"][0]["primitives"][0]
    primitive["attributes"]["TEXCOORD_0"] = len(whole["accessors"]) - 1
    primitive["material"] = 0
    whole["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    whole["textures"], whole["images"] = [{"source": 0}], [{"uri": "paint.png"}]
    path.write_text(json.dumps(whole))
    (tmp_path / "paint.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(100))
    mapped = hgp.Mesh.load(path).parametrize(cells=1500, grid_mode="quad")
    assert mapped.quads().save(tmp_path / "all.glb") == []
    hgp_program("quads", path, "-o", tmp_path / "native.glb", "--cells", "1500")
    assert (tmp_path / "all.glb").read_bytes() == (tmp_path / "native.glb").read_bytes()
    assert (tmp_path / "paint.png").read_bytes() in (tmp_path / "all.glb").read_bytes()
    assert (tmp_path / "all-quads.obj").read_bytes() == (tmp_path / "native-quads.obj").read_bytes()
    with pytest.raises(hgp.UsageError, match="which is written beside"):
        hgp.Mesh.load(tmp_path / "all-quads.obj").parametrize(cells=1500, grid_mode="quad").quads().save(
            tmp_path / "all.glb"
        )
