"""What the user calls."""

import json
from typing import Any, Dict, Optional, Set

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from . import engine, exchange

ATTRIBUTE = "hgp_cone"


def program_of(context: Any) -> str:
    addon = context.preferences.addons.get(__package__)
    return str(addon.preferences.program) if addon else ""


def cone_attribute(mesh: Any, makes: bool = False) -> Any:
    found = mesh.attributes.get(ATTRIBUTE)
    if found is not None and (found.data_type, found.domain) != ("INT", "POINT"):
        raise engine.Failed(f"the attribute {ATTRIBUTE} is not an integer per vertex; rename it")
    return found or (mesh.attributes.new(ATTRIBUTE, "INT", "POINT") if makes else None)


def cones_of(mesh: Any) -> Dict[int, int]:
    """Vertex to k, of the vertex attribute; 0 is no cone."""
    attribute = cone_attribute(mesh)
    if attribute is None:
        return {}
    k = np.empty(len(mesh.vertices), np.int32)
    attribute.data.foreach_get("value", k)
    return {int(v): int(k[v]) for v in np.flatnonzero(k)}


def store_cones(mesh: Any, cones: Dict[int, int]) -> None:
    k = np.zeros(len(mesh.vertices), np.int32)
    for vertex, index in cones.items():
        k[vertex] = index
    cone_attribute(mesh, makes=True).data.foreach_set("value", k)


def selected(mesh: Any) -> Any:
    found = np.empty(len(mesh.vertices), bool)
    mesh.vertices.foreach_get("select", found)
    return np.flatnonzero(found)


class HGP_OT_set_cone(bpy.types.Operator):
    """Make the selected vertices cones of k · 360°/q; k = 0 removes them"""

    bl_idname = "mesh.hgp_set_cone"
    bl_label = "Set Cone (hgp)"
    bl_options = {"REGISTER", "UNDO"}

    k: IntProperty(name="k", description="The cone angle is k · 360°/q", default=3, min=0, max=64)  # type: ignore[valid-type]

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and context.object.type == "MESH"

    def execute(self, context: Any) -> Set[str]:
        with ObjectMode(context) as thing:
            cones = cones_of(thing.data)
            chosen = selected(thing.data)
            for vertex in chosen:
                cones[int(vertex)] = self.k
            store_cones(thing.data, cones)
        self.report({"INFO"}, f"k = {self.k} at {len(chosen)} vertices")
        return {"FINISHED"}


class ObjectMode:
    """The active object, in object mode meanwhile: mesh data and selection are complete only there."""

    def __init__(self, context: Any) -> None:
        self.object = context.object
        self.mode = context.object.mode

    def __enter__(self) -> Any:
        if self.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        return self.object

    def __exit__(self, *_: Any) -> None:
        if self.mode != "OBJECT":
            bpy.ops.object.mode_set(mode=self.mode)


class HGP_OT_seamless(bpy.types.Operator):
    """Compute a seamless UV map without flipped triangles, with a certificate"""

    bl_idname = "object.hgp_seamless"
    bl_label = "Seamless (hgp)"
    bl_options = {"REGISTER", "UNDO"}

    cones: EnumProperty(  # type: ignore[valid-type]
        name="Cones",
        items=[
            ("AUTOMATIC", "Automatic", "hgp chooses them"),
            ("SELECTED", "Selected vertices", "Every selected vertex is a cone of k · 360°/q"),
            ("ATTRIBUTE", "Vertex attribute", f"The integer attribute {ATTRIBUTE}, 0 where there is none"),
        ],
    )
    k: IntProperty(name="k", description="Of selected vertices: the cone angle is k · 360°/q", default=3, min=1, max=64)  # type: ignore[valid-type]
    q: IntProperty(name="q", description="Angles are multiples of 360°/q", default=4, min=1, max=64)  # type: ignore[valid-type]
    count: IntProperty(name="Count", description="Automatic cones: how many; 0: as needed", default=0, min=0)  # type: ignore[valid-type]
    improve: EnumProperty(  # type: ignore[valid-type]
        name="Improve",
        items=[
            ("NONE", "As solved", ""),
            ("isometric", "Isometric", "Angles and areas"),
            ("conformal", "Conformal", "Angles"),
            ("area", "Area", "Areas"),
        ],
        default="isometric",
    )
    cells: FloatProperty(name="Cells", description="Align to a grid of about this many cells; 0: no grid", default=0, min=0)  # type: ignore[valid-type]
    quads: BoolProperty(name="Quads", description="The cells of the grid as a new object")  # type: ignore[valid-type]
    use_seams: BoolProperty(name="Cut at Seams", description="The map has seams at edges marked as seams, which then are boundaries")  # type: ignore[valid-type]
    use_sharp: BoolProperty(name="Cut at Sharp Edges", description="The same at edges marked sharp")  # type: ignore[valid-type]
    uv_map: StringProperty(name="UV Map", default="Seamless")  # type: ignore[valid-type]

    _run: Optional[engine.Run] = None
    _timer: Any = None

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and context.object.type == "MESH"

    def _job(self, context: Any, thing: Any) -> engine.Job:
        mesh = thing.data
        if len(mesh.polygons) == 0:
            raise engine.Failed("the mesh has no faces")
        given = exchange.polygons_of(mesh)
        cones: Optional[Dict[int, int]] = None
        if self.cones == "SELECTED":
            cones = {int(v): self.k for v in selected(mesh)}
        elif self.cones == "ATTRIBUTE":
            cones = cones_of(mesh)
        self._origins = np.arange(len(given.positions))
        edges = np.zeros(len(mesh.edges), bool)
        for is_used, name in ((self.use_seams, "use_seam"), (self.use_sharp, "use_edge_sharp")):
            if is_used:
                marked = np.empty(len(mesh.edges), bool)
                mesh.edges.foreach_get(name, marked)
                edges |= marked
        if edges.any():
            given, self._origins = exchange.cut(mesh, given, edges)
        return engine.Job(
            given,
            q=self.q,
            cones=cones,
            count=self.count,
            improve=None if self.improve == "NONE" else self.improve,
            cells=self.cells,
            makes_quads=self.quads,
            program=program_of(context),
        )

    def _finish(self, context: Any, thing: Any, done: engine.Done) -> Set[str]:
        mesh = thing.data
        if len(done.uv) != len(mesh.loops):
            raise engine.Failed("the mesh was changed meanwhile")
        exchange.write_uv(mesh, self.uv_map, done.uv)
        cones = {int(self._origins[cone["vertex"]]): cone["k"] for cone in done.report["cones"]["cones"]}
        store_cones(mesh, cones)
        facts = summary(done, self.uv_map, len(cones))
        mesh["hgp"] = json.dumps({**facts, "drawn_flipped": exchange.drawn_flipped(mesh, done.uv)})
        if done.quads is not None:
            self._add_quads(context, thing, *done.quads)
        level, text = verdict(json.loads(mesh["hgp"]))
        self.report({level}, text)
        return {"FINISHED"}

    def _add_quads(self, context: Any, thing: Any, positions: Any, quads: Any) -> None:
        mesh = bpy.data.meshes.new(f"{thing.data.name} quads")
        mesh.vertices.add(len(positions))
        mesh.vertices.foreach_set("co", positions.astype(np.float32).ravel())
        mesh.loops.add(quads.size)
        mesh.loops.foreach_set("vertex_index", quads.ravel())
        mesh.polygons.add(len(quads))
        mesh.polygons.foreach_set("loop_start", np.arange(0, quads.size, 4, dtype=np.int32))
        mesh.polygons.foreach_set("loop_total", np.full(len(quads), 4, dtype=np.int32))
        mesh.update(calc_edges=True)
        mesh.validate()
        made = bpy.data.objects.new(mesh.name, mesh)
        made.matrix_world = thing.matrix_world
        context.collection.objects.link(made)

    def execute(self, context: Any) -> Set[str]:
        try:
            with ObjectMode(context) as thing:
                return self._finish(context, thing, engine.Run(self._job(context, thing)).start().wait())
        except (engine.Failed, ValueError) as error:
            return self._refuse(error)

    def _refuse(self, error: Exception) -> Set[str]:
        places = [f"{kind} {number}" for kind, number, _ in getattr(error, "places", [])[:5]]
        self.report({"ERROR"}, str(error) + (f" (at {', '.join(places)})" if places else ""))
        return {"CANCELLED"}

    def invoke(self, context: Any, event: Any) -> Set[str]:
        if bpy.app.background:
            return self.execute(context)
        try:
            self._object = context.object
            if context.object.mode != "OBJECT":
                bpy.ops.object.mode_set(mode="OBJECT")
            self._run = engine.Run(self._job(context, context.object)).start()
        except (engine.Failed, ValueError) as error:
            return self._refuse(error)
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.progress_begin(0, 100)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> Set[str]:
        run = self._run
        assert run is not None
        if event.type == "ESC":
            run.cancel()
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if run.is_running:
            context.window_manager.progress_update(100 * run.fraction)
            context.workspace.status_text_set(f"hgp: {run.stage} {run.fraction:.0%} – Esc cancels")
            return {"RUNNING_MODAL"}
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        if run.is_cancelled:
            self.report({"INFO"}, "hgp: cancelled")
            return {"CANCELLED"}
        try:
            return self._finish(context, self._object, run.wait())
        except (engine.Failed, ValueError) as error:
            return self._refuse(error)


def summary(done: engine.Done, name: str, cones: int) -> Dict[str, Any]:
    """What the panel shows."""
    solved, stored = done.report["certificate"], done.stored
    return {
        "uv_map": name,
        "q": solved["q"],
        "certified": solved["certified"],
        "triangles": solved["triangles"],
        "cones": cones,
        "flipped": stored["flipped"],
        "worst_seam": stored["maxSeamResidual"],
        "worst_angle": stored["maxConeDistance"],
        "integer_seams": solved["integerSeams"],
        "seams": solved["seamEdges"],
        "notes": done.notes[:8],
    }


def is_good(facts: Dict[str, Any]) -> bool:
    """Whether the map is certified, and still is one in float32; 1 % is what hgp accepts in float32 files, too."""
    return bool(facts["certified"] and facts["flipped"] == 0 and facts["worst_seam"] <= 0.01)


def verdict(facts: Dict[str, Any]) -> "tuple[str, str]":
    """A level of report() and one sentence. Blender stores float32: the triangles are judged as stored."""
    if not is_good(facts):
        return "WARNING", (
            f"hgp: in float32, which Blender stores, {facts['flipped']} triangles are not positive, and seams are off by "
            f"up to {facts['worst_seam']:.0e} of their length"
        )
    if facts["drawn_flipped"]:
        return "WARNING", (
            f"hgp: certified, {facts['triangles']} triangles, {facts['cones']} cones; but Blender divides some polygons along "
            f"the other diagonal, and {facts['drawn_flipped']} triangles that it draws are flipped: triangulate the mesh first "
            "(Edit Mode, Ctrl T)"
        )
    return "INFO", (
        f"hgp: certified, {facts['triangles']} triangles, {facts['cones']} cones; "
        f"in float32 none is flipped, and seams are off by at most {facts['worst_seam']:.0e} of their length"
    )


CLASSES = (HGP_OT_set_cone, HGP_OT_seamless)
