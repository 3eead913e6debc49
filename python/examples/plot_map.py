"""A seamless map of the pretzel: the map, its distortion and its seams.

Cells begin with `# %%` (VS Code, Spyder and Jupytext show them as a notebook). As a script:

    python3 plot_map.py pretzel.obj picture.png
"""

# %% A mesh and its map
from __future__ import annotations

import sys

import matplotlib

matplotlib.use("Agg")  # remove this line in a notebook
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import hgp

source, picture = sys.argv[1:3] if len(sys.argv) > 2 else ("pretzel.obj", "picture.png")
mesh = hgp.Mesh.load(source)
m = mesh.parametrize(q=4, cones_for="few", improve="isometric")
print(m)
assert m.certified, "see docs/not-certified.md"

# %% How much angles change: the ratio of the singular values, 1 where they do not
d = m.distortion()
print(f"stretch: median {np.median(d.stretch):.2f}, largest {d.stretch.max():.2f}")
colours = plt.get_cmap("magma_r")((d.stretch - 1) / 1.5)
seam_colours = plt.get_cmap("tab10")(d.seam_chain % 10)

figure = plt.figure(figsize=(11, 8.4))
grid = figure.add_gridspec(2, 2, left=0.01, right=0.99, bottom=0.0, top=0.96, hspace=0.02, wspace=0.0)

# %% The map. Both sides of a seam have one colour: turned by a multiple of 90° and shifted, they are equal
plane = figure.add_subplot(grid[0, :])
plane.add_collection(PolyCollection(m.uv[m.fuv], facecolors=colours, edgecolors="#0002", linewidths=0.2))
for side in (m.seams.a, m.seams.b):
    plane.add_collection(LineCollection(m.uv[side], colors=seam_colours, linewidths=1.8))
plane.autoscale()
plane.set_aspect("equal")
plane.set_axis_off()
plane.set_title("the map, coloured by stretch")


# %% The surface, with the same colours
def surface(place: int, title: str, faces: object) -> None:
    axes = figure.add_subplot(grid[1, place], projection="3d", proj_type="ortho")
    axes.add_collection3d(Poly3DCollection(m.vertices[m.triangles], facecolors=faces, edgecolors="#777", linewidths=0.1))
    low, high = m.vertices.min(axis=0), m.vertices.max(axis=0)
    for set_limits, a, b in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), low, high):
        set_limits(a, b)
    axes.set_box_aspect(high - low, zoom=1.3)
    axes.view_init(elev=62, azim=-75)
    axes.set_axis_off()
    axes.set_title(title, y=0.93)


surface(0, "the distortion on the surface", colours)

# %% Seams and cones: triangles at a seam have its colour, triangles at a cone are black
sides = np.sort(m.fuv[:, [[0, 1], [1, 2], [2, 0]]], axis=2)  # the uv edges of every triangle
number = dict(zip(map(tuple, np.sort(np.vstack([m.seams.a, m.seams.b]), axis=1)), np.tile(d.seam_chain, 2)))
painted = np.full((len(m.triangles), 3), 0.9)
for f, edges in enumerate(sides):
    for edge in map(tuple, edges):
        if edge in number:
            painted[f] = plt.get_cmap("tab10")(number[edge] % 10)[:3]
painted[np.isin(m.triangles, list(m.cones)).any(axis=1)] = 0
surface(1, "seams and cones", painted)

figure.savefig(picture, dpi=80)
