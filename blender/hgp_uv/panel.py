"""The panel in the sidebar, and the entries of menus."""

from __future__ import annotations

import json
from typing import Any

import bpy

from . import engine
from .operators import HGP_OT_seamless, HGP_OT_set_cone, is_good, program_of


class HGP_PT_panel(bpy.types.Panel):
    bl_label = "Seamless UV"
    bl_idname = "HGP_PT_panel"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "hgp"

    def draw(self, context: Any) -> None:
        layout = self.layout
        used = engine.describe(program_of(context))
        if not used:
            layout.label(text="There is no engine:", icon="ERROR")
            layout.label(text="name the program hgp in the preferences")
            return
        thing = context.object
        column = layout.column()
        column.operator(HGP_OT_seamless.bl_idname, icon="UV")
        column.operator(HGP_OT_set_cone.bl_idname, icon="VERTEXSEL")
        layout.label(text=f"Engine: {used}")
        if thing is None or thing.type != "MESH" or "hgp" not in thing.data:
            return
        facts = json.loads(thing.data["hgp"])
        box = layout.box()
        good = is_good(facts)
        box.label(text="Certified" if good else "Not certified as stored", icon="CHECKMARK" if good else "ERROR")
        for text in (
            f"UV map {facts['uv_map']}, q = {facts['q']}, {facts['cones']} cones",
            f"{facts['triangles']} triangles, {facts['flipped']} not positive",
            *([f"As Blender divides polygons: {facts['drawn_flipped']} flipped"] if facts.get("drawn_flipped") else []),
            f"Seams off by {facts['worst_seam']:.1e} of their length",
            f"Angles off by {facts['worst_angle']:.1e} rad",
        ):
            box.label(text=text)
        if facts["integer_seams"] is not None and facts["seams"]:
            box.label(text=f"On the grid: {facts['integer_seams']} of {facts['seams']} seam edges")
        for note in facts["notes"]:
            box.label(text=note, icon="INFO")


def entries(self: Any, context: Any) -> None:
    """UV › Seamless (hgp)."""
    self.layout.separator()
    self.layout.operator(HGP_OT_seamless.bl_idname)


class HGP_MT_uv(bpy.types.Menu):
    bl_label = "UV"
    bl_idname = "HGP_MT_uv"

    def draw(self, context: Any) -> None:
        self.layout.operator(HGP_OT_seamless.bl_idname)
        self.layout.operator(HGP_OT_set_cone.bl_idname)


def submenu(self: Any, context: Any) -> None:
    """Object › UV: in object mode, Blender has no menu UV."""
    self.layout.separator()
    self.layout.menu(HGP_MT_uv.bl_idname)


CLASSES = (HGP_PT_panel, HGP_MT_uv)


def add_entries() -> None:
    bpy.types.VIEW3D_MT_uv_map.append(entries)
    bpy.types.VIEW3D_MT_object.append(submenu)


def remove_entries() -> None:
    bpy.types.VIEW3D_MT_uv_map.remove(entries)
    bpy.types.VIEW3D_MT_object.remove(submenu)
