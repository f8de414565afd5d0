"""
Colors, legends and saved views
===============================

On this page you color points by attributes, add color bars, legends and labels, and save a view to a file, so that
later images have the same camera.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

cloud = loom.datasets.object_mesh().sample_points_uniformly(40_000, seed=1)
size = np.linalg.norm(cloud.get_max_bound() - cloud.get_min_bound())
print(cloud, f"{100 * size:.1f} cm across")

# %%
# Color by an attribute
# ---------------------
# ``color_by`` is "height", "normal", "label", "rgb" or any attribute. ``limits`` are the values at both ends of the
# color map. Set them to compare images. Use perceptually uniform maps such as viridis for quantities, and turbo to show
# small differences.
cloud = loom.estimate_curvature(cloud, radius=0.03 * size, max_nn=None)
cloud["side"] = (np.floor(6 * np.arctan2(*cloud.points[:, :2].T) / (2 * np.pi)) % 6).astype(np.int32)
curvature_limit = np.percentile(cloud["curvature"], 98)
styles = {
    "rgb": {"color_by": "rgb"},
    "height": {"color_by": "height", "colormap": "viridis"},
    "curvature": {"color_by": "curvature", "colormap": "turbo", "limits": (0, curvature_limit)},
    "normal": {"color_by": "normal"},
}
scene, labels = {}, []
for index, (name, style) in enumerate(styles.items()):
    shift = np.array([0.8 * size * index, 0, 0])
    scene[name] = {"geometry": cloud.translate(shift), "point_size": 3} | style
    labels.append((name, shift + cloud.get_center() + [0, 0, 0.55 * size]))
corners = np.vstack([style["geometry"].points for style in scene.values()] + [[position] for _, position in labels])
row = loom.render(scene, loom.View.fit(corners, direction=(0.0, 1.0, -0.3), width=1120, height=420), labels=labels)

# %%
# Color bar
# ---------
# A color bar shows the values of the first ``color_by``.
view = loom.View.fit(cloud.points, direction=(-0.4, 0.8, -0.4), width=960, height=640)
bar = loom.render(
    {"geometry": cloud, "color_by": "curvature", "limits": (0, curvature_limit), "colormap": "turbo"},
    view,
    color_bar=True,
)

# %%
# Legend
# ------
# If a scene is a dictionary, its names become the entries of the legend.
palette = [(0.9, 0.35, 0.2), (0.2, 0.55, 0.85), (0.3, 0.7, 0.35), (0.95, 0.7, 0.15), (0.6, 0.35, 0.75), (0.2, 0.7, 0.7)]
sides = {f"side {k + 1}": {"geometry": cloud.select_by_mask(cloud["side"] == k), "color": palette[k]} for k in range(6)}
assert sum(len(style["geometry"]) for style in sides.values()) == len(cloud)
named = loom.render(sides, view, legend=True)

# %%
# Saved views
# -----------
# A view is a camera and its pose. The file has the format that Open3D's viewer copies with Ctrl+C.
bounds = (cloud.get_min_bound(), cloud.get_max_bound())
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "view.json"
    saved = loom.View.from_open3d(bounds, zoom=0.7, front=[0.5, -0.8, 0.4], up=[0, 0, 1], width=960, height=640)
    loom.write_view(path, saved, bounds)
    first = loom.render(cloud, saved)
    from_file = loom.render(cloud, loom.read_view(path, width=960, height=640))
difference = np.abs(first.astype(int) - from_file.astype(int)).mean()
print(f"images from the view and from its file differ by {difference:.3f} of 255 on average")
assert difference < 1.0

# %%
# Depth of an image
# -----------------
# With ``depth=True``, ``loom.render`` also returns the depth of each pixel: meters along the optical axis, 0 for the
# background. With the camera, a pixel can be converted to a 3D point.
shot, depth = loom.render(cloud, view, depth=True)
row_, column = np.argwhere(depth > 0)[len(np.argwhere(depth > 0)) // 2]
camera = view.intrinsic.intrinsic_matrix
ray = np.linalg.solve(camera, [column, row_, 1.0]) * depth[row_, column]
position = view.T_world_camera[:3, :3] @ ray + view.T_world_camera[:3, 3]
nearest = float(np.sqrt(loom.NearestNeighborSearch(cloud).knn_search(position[None], 1).sqdists[0, 0]))
print(f"pixel ({column}, {row_}) shows {position.round(3)} m, {1000 * nearest:.2f} mm from the nearest point")
assert nearest < 0.02 * size

# %%
# What to change
# --------------
# - ``limits``: a smaller upper limit increases the contrast of small values.
# - ``point_size`` [pixels]: 1 to 10. With ``"metric": True`` it is in meters.
# - ``direction`` of ``View.fit``: the viewing direction in world coordinates.
#
# Next
# ----
# - :doc:`Rendering images and plots </pictures>`: all styles.
# - :ref:`Figures for publications <sphx_glr_gallery_images_plot_figure_for_a_paper.py>`
