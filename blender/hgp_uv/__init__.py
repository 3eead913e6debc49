"""Seamless UV maps without flipped triangles, with cones of your choice and a certificate: hgp in Blender."""

from typing import Any

import bpy
from bpy.props import StringProperty

from . import engine, operators, panel

bl_info = {
    "name": "hgp: Seamless UV",
    "author": "the authors of hgp",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "View3D › UV › Seamless (hgp), Object › UV, sidebar hgp",
    "description": "Seamless UV maps without flipped triangles, with cones of your choice and a certificate",
    "category": "UV",
}


class HGP_AP_preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(  # type: ignore[valid-type]
        name="Program",
        description="The command line hgp, to be used instead of the Python package",
        subtype="FILE_PATH",
    )

    def draw(self, context: Any) -> None:
        self.layout.prop(self, "program")
        self.layout.label(text="Engine: " + (engine.describe(self.program) or "none: name the program hgp"))


CLASSES = (HGP_AP_preferences, *operators.CLASSES, *panel.CLASSES)


def register() -> None:
    for one in CLASSES:
        bpy.utils.register_class(one)
    panel.add_entries()


def unregister() -> None:
    panel.remove_entries()
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
