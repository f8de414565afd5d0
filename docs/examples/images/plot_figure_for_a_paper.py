"""
Figures for publications
========================

Figures need a reproducible view, a legend, labels and a color bar. On this page you create them with ``loom.render``,
which needs no display or graphics library. The images are bitwise identical on all machines.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp())

# %%
# The scene
# ---------
#
# The scene is a dictionary of names and geometries with styles. The names become the legend.

mesh = loom.datasets.object_mesh()
scan = loom.datasets.object_scans(3).in_world(0)
box: loom.OrientedBoundingBox = mesh.get_oriented_bounding_box()
scene = {
    "model": {"geometry": mesh, "color": (0.8, 0.77, 0.72)},
    "scan": {"geometry": scan, "color": (0.85, 0.3, 0.15), "point_size": 3},
    "oriented box": {"geometry": box, "color": (0.15, 0.35, 0.65), "line_width": 2},
}
height = float((mesh.get_max_bound() - mesh.get_min_bound())[2])
labels = [
    (f"{height * 100:.0f} cm", [mesh.get_max_bound()[0], 0, 0]),
    ("ear", mesh.vertices[mesh.vertices[:, 2].argmax()]),
]

# %%
# A reproducible view
# -------------------
#
# ``front``, ``up``, ``zoom`` and ``field_of_view`` are Open3D's parameters. A ``View`` is a camera with its pose. It is
# stored as the JSON that Open3D's viewer copies with Ctrl+C, so views selected there can be used here.

bounds = mesh.get_min_bound(), mesh.get_max_bound()
view = loom.View.from_open3d(
    bounds, zoom=0.75, front=[0.5, -1, 0.35], up=[0, 0, 1], field_of_view=30, width=960, height=640
)
loom.write_view(folder / "view.json", view, bounds)
from_file = loom.read_view(folder / "view.json", width=960, height=640)
assert np.allclose(from_file.T_world_camera, view.T_world_camera, atol=1e-6)

figure = loom.render(scene, view, legend=True, labels=labels)
assert np.array_equal(figure, loom.render(scene, view, legend=True, labels=labels)), "images are bitwise identical"

# %%
# Depth
# -----
#
# ``depth=True`` also returns the depth of each pixel along the optical axis [m].

depth = loom.render(mesh, view, depth=True)[1]
print(
    f"the model covers {100 * (depth > 0).mean():.0f} % of the "
    f"image, {depth[depth > 0].min():.3f} to {depth.max():.3f} m depth"
)
assert (depth > 0).mean() > 0.05

# %%
# Color by attribute
# ------------------
#
# ``color_by`` is "height", "normal", "label", or any attribute of clouds and meshes. The color maps are viridis, turbo,
# coolwarm, gray and jet.

scene = loom.RaycastingScene()
scene.add_triangles(mesh)
scan["distance from the model [mm]"] = 1e3 * scene.compute_distance(scan.points)
values = scan["distance from the model [mm]"]
print(f"median distance of the scan from the model: {np.median(values):.2f} mm")
assert np.median(values) < 2

style = {"geometry": scan, "color_by": "distance from the model [mm]", "colormap": "turbo", "point_size": 4}
errors = loom.render(style, view, color_bar=True, background=(0.94, 0.95, 0.96))
loom.write_image(folder / "figure.png", errors)

# %%
# What to change
# --------------
# - The size [pixels]: 1920 x 1280 for print.
# - ``background``: red, green and blue from 0 to 1.
# - ``colormap`` and ``limits``: use the same values in all figures of a publication.
#
# Next
# ----
# - :ref:`Colors, legends and saved views <sphx_glr_gallery_clouds_plot_colors_legends_and_views.py>`
# - :doc:`Rendering images and plots </pictures>`
