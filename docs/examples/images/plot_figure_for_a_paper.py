"""
An image for a paper
=====================

Figures want the same view each time, a legend, labels, a scale and no window. ``loom.render`` draws without a display
or a graphics library, on any machine the same bits; views come from Open3D's viewer too.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp())

# %%
# What is drawn
# -------------
#
# A mapping from names to geometries, each with its style. The names make the legend.

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
# The same view each time
# -----------------------
#
# ``front``, ``up``, ``zoom`` and ``field_of_view`` are Open3D's. A ``View`` is a camera and its pose; it can be kept as
# the JSON that Open3D's viewer copies with Ctrl+C, so a view that you found there by hand is the figure's.

bounds = mesh.get_min_bound(), mesh.get_max_bound()
view = loom.View.from_open3d(
    bounds, zoom=0.75, front=[0.5, -1, 0.35], up=[0, 0, 1], field_of_view=30, width=960, height=640
)
loom.write_view(folder / "view.json", view, bounds)
again = loom.read_view(folder / "view.json", width=960, height=640)
assert np.allclose(again.T_world_camera, view.T_world_camera, atol=1e-6)

figure = loom.render(scene, view, legend=True, labels=labels)
assert np.array_equal(figure, loom.render(scene, view, legend=True, labels=labels)), "the same bits each time"

# %%
# Depth as numbers
# ----------------
#
# ``depth=True`` gives the depth of each pixel [m] along the optical axis, for a figure of your own or as a sensor.

depth = loom.render(mesh, view, depth=True)[1]
print(
    f"the model covers {100 * (depth > 0).mean():.0f} % of the "
    f"image, {depth[depth > 0].min():.3f} to {depth.max():.3f} m away"
)
assert (depth > 0).mean() > 0.05

# %%
# A value as color, with its scale
# ---------------------------------
#
# Of clouds and meshes: "height", "normal", "label", or any attribute. Color maps are viridis, turbo, coolwarm, gray
# and jet.

scene = loom.RaycastingScene()
scene.add_triangles(mesh)
scan["distance from the model [mm]"] = 1e3 * scene.compute_distance(scan.points)
values = scan["distance from the model [mm]"]
print(f"median distance of the scan from the model: {np.median(values):.2f} mm")
assert np.median(values) < 2

shown = {"geometry": scan, "color_by": "distance from the model [mm]", "colormap": "turbo", "point_size": 4}
errors = loom.render(shown, view, color_bar=True, background=(0.94, 0.95, 0.96))
loom.write_image(folder / "figure.png", errors)
