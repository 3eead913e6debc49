"""Runs in Blender: installs the add-on from its zip, maps ten models, and compares with the command line.

    blender --background --factory-startup --python blender/tests/in_blender.py -- ADDON.zip PROGRAM FOLDER
"""

import json
import math
import pathlib
import subprocess
import sys
import traceback

import bmesh
import bpy
import numpy as np

ADDON, PROGRAM, FOLDER = sys.argv[sys.argv.index("--") + 1 :]
FOLDER = pathlib.Path(FOLDER)


def grid():
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=12, y_subdivisions=9)
    for vertex in bpy.context.object.data.vertices:
        vertex.co.z = 0.3 * math.sin(3 * vertex.co.x) * math.cos(2 * vertex.co.y)


def divided_cube():
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.subdivide(number_cuts=5, smoothness=0.6)
    bpy.ops.object.mode_set(mode="OBJECT")


def two_parts():
    bpy.ops.mesh.primitive_torus_add(major_segments=24, minor_segments=10)
    other = bpy.context.object
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, location=(3, 0, 0))
    other.select_set(True)
    bpy.ops.object.join()


def ngons():
    bpy.ops.mesh.primitive_cylinder_add(vertices=24, end_fill_type="NGON")


def triangulated_monkey():
    """What the warning about the monkey advises."""
    bpy.ops.mesh.primitive_monkey_add()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.quads_convert_to_tris()
    bpy.ops.object.mode_set(mode="OBJECT")


# Each with the options of the operator and the same for the command line.
MODELS = [
    ("cube", divided_cube, {}, []),
    ("sphere", lambda: bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=16), {}, []),
    ("icosphere", lambda: bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4), {"q": 2}, ["--q", "2"]),
    ("torus", lambda: bpy.ops.mesh.primitive_torus_add(), {}, []),
    ("monkey", lambda: bpy.ops.mesh.primitive_monkey_add(), {}, []),
    ("triangulated monkey", triangulated_monkey, {}, []),
    ("cylinder", ngons, {}, []),
    ("cone", lambda: bpy.ops.mesh.primitive_cone_add(vertices=20, end_fill_type="TRIFAN"), {}, []),
    ("grid", grid, {"improve": "conformal"}, ["--improve", "conformal"]),
    ("two parts", two_parts, {}, []),
    ("on a grid", divided_cube, {"cells": 150, "quads": True}, ["--cells", "150", "--grid-mode", "quad"]),
]


def written(mesh, path):
    """The mesh as an OBJ, written here and not by the add-on."""
    lines = ["v %r %r %r" % tuple(vertex.co) for vertex in mesh.vertices]
    lines += ["f " + " ".join(str(v + 1) for v in polygon.vertices) for polygon in mesh.polygons]
    path.write_text("\n".join(lines) + "\n")


def uv_of(path):
    """The uv of every corner of an OBJ."""
    uv, corners = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["vt"]:
            uv.append([float(word) for word in words[1:3]])
        elif words[:1] == ["f"]:
            corners += [int(word.split("/")[1]) - 1 for word in words[1:]]
    return np.array(uv)[corners]


def stored(mesh, name="Seamless"):
    values = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers[name].data.foreach_get("uv", values)
    return values.reshape(-1, 2)


def negative(mesh, uv):
    """How many triangles of Blender's own triangulation are not positive: exactly."""
    mesh.calc_loop_triangles()
    values = uv.astype(np.float64)
    count = 0
    for triangle in mesh.loop_triangles:
        a, b, c = (values[loop] for loop in triangle.loops)
        # float64 holds the products of float32 numbers exactly, and their differences to 2^-53.
        if (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0:
            count += 1
    return count


def positive(mesh, uv):
    return negative(mesh, uv) == 0


def clear():
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()


def model(name, make, options, flags):
    clear()
    make()
    thing = bpy.context.object
    if name == "cube":
        thing.scale = (2, 1, 1)  # as in Blender's own unwrapping, not applied
    loops = [loop.vertex_index for loop in thing.data.loops]
    written(thing.data, FOLDER / "model.obj")
    improve = [] if "--improve" in flags else ["--improve", "isometric"]
    run = [PROGRAM, "param", FOLDER / "model.obj", "-o", FOLDER / "native.obj", "--quiet", *flags, *improve]
    native = subprocess.run([*map(str, run), "--json", str(FOLDER / "native.json")])
    if native.returncode == 6:
        refused(lambda: bpy.ops.object.hgp_seamless(**options), "no certified map")
        print("ok model", name, "is refused by both", flush=True)
        return 0
    assert native.returncode == 0, name
    assert bpy.ops.object.hgp_seamless(**options) == {"FINISHED"}, name
    assert [loop.vertex_index for loop in thing.data.loops] == loops
    facts = json.loads(thing.data["hgp"])
    assert facts["certified"] and facts["flipped"] == 0, (name, facts)
    expected = uv_of(FOLDER / "native.obj").astype(np.float32)
    assert np.array_equal(stored(thing.data), expected), (name, np.abs(stored(thing.data) - expected).max())
    report = json.loads((FOLDER / "native.json").read_text())
    cones = {cone["vertex"]: cone["k"] for cone in report["cones"]["cones"]}
    found = {v: entry.value for v, entry in enumerate(thing.data.attributes["hgp_cone"].data) if entry.value}
    assert found == cones, name
    # Blender divides polygons in its own way, which may be another one than that of the certificate.
    assert facts["drawn_flipped"] == negative(thing.data, stored(thing.data)), (name, facts)
    assert name in ("cylinder", "monkey") or facts["drawn_flipped"] == 0, (name, facts)
    if options.get("quads"):
        (made,) = [one for one in bpy.data.objects if one is not thing and one.type == "MESH"]
        sizes = {len(polygon.vertices) for polygon in made.data.polygons}
        assert sizes == {4} and len(made.data.vertices) - len(made.data.edges) + len(made.data.polygons) == 2
        assert facts["integer_seams"] == facts["seams"] > 0
    print("ok model", name, flush=True)
    return 1


def refused(call, words):
    """In a script, reports of errors are exceptions."""
    try:
        call()
    except RuntimeError as error:
        assert words in str(error), error
    else:
        raise AssertionError("not refused")


def test_cones_of_selected_vertices():
    clear()
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    assert bpy.ops.object.hgp_seamless(cones="SELECTED", k=3) == {"FINISHED"}
    assert bpy.context.object.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    mesh = bpy.context.object.data
    assert [entry.value for entry in mesh.attributes["hgp_cone"].data] == [3] * 8
    assert positive(mesh, stored(mesh))
    # The attribute prescribes the same again.
    first = stored(mesh)
    assert bpy.ops.object.hgp_seamless(cones="ATTRIBUTE") == {"FINISHED"}
    assert np.array_equal(stored(mesh), first)
    assert len(mesh.uv_layers) == 2 and mesh.uv_layers.active.name == "Seamless"


def test_impossible_cones_are_refused_with_the_reason():
    clear()
    bpy.ops.mesh.primitive_cube_add()
    mesh = bpy.context.object.data
    for vertex in mesh.vertices:
        vertex.select = vertex.index == 0
    refused(lambda: bpy.ops.object.hgp_seamless(cones="SELECTED", k=3), "Gauss–Bonnet")
    assert "Seamless" not in mesh.uv_layers and "hgp" not in mesh


def test_marked_seams_are_the_boundaries_of_the_map():
    clear()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
    mesh = bpy.context.object.data
    top, bottom = (max(mesh.vertices, key=lambda v, s=s: s * v.co.z).index for s in (1, -1))
    for edge in mesh.edges:
        a, b = (mesh.vertices[v].co for v in edge.vertices)
        edge.use_seam = all(abs(p.y) < 1e-5 and p.x > -1e-5 for p in (a, b))
    assert sum(edge.use_seam for edge in mesh.edges) == 8
    assert bpy.ops.object.hgp_seamless(use_seams=True) == {"FINISHED"}
    uv = stored(mesh)
    assert positive(mesh, uv)
    # Uv differ between polygons exactly at marked edges, if there is no cone inside.
    seams = json.loads(mesh["hgp"])["seams"]
    at = {}
    for polygon in mesh.polygons:
        loops = list(polygon.loop_indices)
        for here, there in zip(loops, loops[1:] + loops[:1]):
            ends = sorted((mesh.loops[i].vertex_index, tuple(uv[i])) for i in (here, there))
            at.setdefault(mesh.loops[here].edge_index, []).append(tuple(end[1] for end in ends))
    differing = {edge for edge, sides in at.items() if len(sides) == 2 and sides[0] != sides[1]}
    marked = {edge.index for edge in mesh.edges if edge.use_seam}
    assert marked <= differing and len(differing) == len(marked) + seams
    assert {top, bottom}


def test_set_cone_and_undo():
    clear()
    bpy.ops.mesh.primitive_cube_add()
    mesh = bpy.context.object.data
    for vertex in mesh.vertices:
        vertex.select = vertex.index in (2, 5)
    assert bpy.ops.mesh.hgp_set_cone(k=5) == {"FINISHED"}
    assert [entry.value for entry in mesh.attributes["hgp_cone"].data] == [0, 0, 5, 0, 0, 5, 0, 0]
    assert bpy.ops.mesh.hgp_set_cone(k=0) == {"FINISHED"}
    assert not any(entry.value for entry in mesh.attributes["hgp_cone"].data)
    assert "UNDO" in bpy.types.OBJECT_OT_hgp_seamless.bl_options


def test_the_command_line_is_the_other_engine():
    preferences = bpy.context.preferences.addons["hgp_uv"].preferences
    clear()
    divided_cube()
    mesh = bpy.context.object.data
    assert bpy.ops.object.hgp_seamless(cells=150, quads=True) == {"FINISHED"}
    first, facts = stored(mesh), mesh["hgp"]
    preferences.program = PROGRAM
    try:
        assert bpy.ops.object.hgp_seamless(cells=150, quads=True) == {"FINISHED"}
        assert np.array_equal(stored(mesh), first) and json.loads(mesh["hgp"]) == json.loads(facts)
        for vertex in mesh.vertices:
            vertex.select = vertex.index == 0
        refused(lambda: bpy.ops.object.hgp_seamless(cones="SELECTED", k=3), "Gauss–Bonnet")
    finally:
        preferences.program = ""


def test_a_run_in_the_background_can_be_cancelled():
    from hgp_uv import engine, exchange

    clear()
    bpy.ops.mesh.primitive_torus_add(major_segments=200, minor_segments=100)
    job = engine.Job(exchange.polygons_of(bpy.context.object.data), improve="isometric")
    for program in ("", PROGRAM):
        run = engine.Run(job._replace(program=program)).start()
        run.cancel()
        try:
            run.wait()
        except engine.Failed:
            assert run.is_cancelled and not run.is_running
        else:
            raise AssertionError("not cancelled")


def test_an_empty_mesh_is_refused():
    clear()
    bpy.context.collection.objects.link(bpy.data.objects.new("empty", bpy.data.meshes.new("empty")))
    bpy.context.view_layer.objects.active = bpy.data.objects["empty"]
    refused(bpy.ops.object.hgp_seamless, "the mesh has no faces")


def main():
    bpy.ops.preferences.addon_install(filepath=ADDON, overwrite=True)
    bpy.ops.preferences.addon_enable(module="hgp_uv")
    from hgp_uv import engine

    assert engine.describe("").startswith("Python package"), engine.describe("")
    assert "bundled" in engine.package().__file__
    mapped = sum(model(*one) for one in MODELS)
    assert mapped >= len(MODELS) - 1, mapped
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("ok", name, flush=True)
    bpy.ops.preferences.addon_disable(module="hgp_uv")
    assert not hasattr(bpy.types, "OBJECT_OT_hgp_seamless")
    print("ALL OK", flush=True)


try:
    main()
except BaseException:
    traceback.print_exc()
    sys.exit(1)
