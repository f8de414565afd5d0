"""
Colors that mean something, legends, and the same view again
=============================================================

An image of a cloud answers a question when its colors do. Here the ways of coloring, what belongs beside them,
and how a view is kept so that tomorrow's image is taken from the same place.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

cloud = loom.datasets.object_mesh().sample_points_uniformly(40_000, seed=1)
size = np.linalg.norm(cloud.get_max_bound() - cloud.get_min_bound())
print(cloud, f"{100 * size:.1f} cm across")

# %%
# **By what?** "height", "normal", "label", "rgb", or any attribute; ``limits`` fixes what the ends of the map mean,
# so that two images compare. Perceptually even maps (viridis) for amounts, turbo to see small steps.
cloud = loom.estimate_curvature(cloud, radius=0.03 * size, max_nn=None)
cloud["side"] = (np.floor(6 * np.arctan2(*cloud.points[:, :2].T) / (2 * np.pi)) % 6).astype(np.int32)
bend = np.percentile(cloud["curvature"], 98)
ways = {
    "rgb": {"color_by": "rgb"},
    "height": {"color_by": "height", "colormap": "viridis"},
    "curvature": {"color_by": "curvature", "colormap": "turbo", "limits": (0, bend)},
    "normal": {"color_by": "normal"},
}
scene, labels = {}, []
for index, (name, style) in enumerate(ways.items()):
    shift = np.array([0.8 * size * index, 0, 0])
    scene[name] = {"geometry": cloud.translate(shift), "point_size": 3} | style
    labels.append((name, shift + cloud.get_center() + [0, 0, 0.55 * size]))
corners = np.vstack([style["geometry"].points for style in scene.values()] + [[position] for _, position in labels])
row = loom.render(scene, loom.View.fit(corners, direction=(0.0, 1.0, -0.3), width=1120, height=420), labels=labels)

# %%
# **A color bar** for what the first ``color_by`` means, **a legend** for what is what.
view = loom.View.fit(cloud.points, direction=(-0.4, 0.8, -0.4), width=960, height=640)
bar = loom.render(
    {"geometry": cloud, "color_by": "curvature", "limits": (0, bend), "colormap": "turbo"}, view, color_bar=True
)

# %%
# Labels and masks: give the parts names, and the legend makes itself.
palette = [(0.9, 0.35, 0.2), (0.2, 0.55, 0.85), (0.3, 0.7, 0.35), (0.95, 0.7, 0.15), (0.6, 0.35, 0.75), (0.2, 0.7, 0.7)]
sides = {f"side {k + 1}": {"geometry": cloud.select_by_mask(cloud["side"] == k), "color": palette[k]} for k in range(6)}
assert sum(len(style["geometry"]) for style in sides.values()) == len(cloud)
named = loom.render(sides, view, legend=True)

# %%
# **The same view again.** A view is a camera and a pose; the file is the one that Open3D's viewer copies with Ctrl+C.
bounds = (cloud.get_min_bound(), cloud.get_max_bound())
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "view.json"
    saved = loom.View.from_open3d(bounds, zoom=0.7, front=[0.5, -0.8, 0.4], up=[0, 0, 1], width=960, height=640)
    loom.write_view(path, saved, bounds)
    first = loom.render(cloud, saved)
    again = loom.render(cloud, loom.read_view(path, width=960, height=640))
difference = np.abs(first.astype(int) - again.astype(int)).mean()
print(f"images from the view and from its file differ by {difference:.3f} of 255 on average")
assert difference < 1.0

# %%
# **Depth of the image** comes along when asked for: meters along the axis, 0 where nothing is. So places of the
# image are places of the scene.
shot, depth = loom.render(cloud, view, depth=True)
row_, column = np.argwhere(depth > 0)[len(np.argwhere(depth > 0)) // 2]
camera = view.intrinsic.intrinsic_matrix
ray = np.linalg.solve(camera, [column, row_, 1.0]) * depth[row_, column]
position = view.T_world_camera[:3, :3] @ ray + view.T_world_camera[:3, 3]
nearest = float(np.sqrt(loom.NearestNeighborSearch(cloud).knn_search(position[None], 1).sqdists[0, 0]))
print(f"pixel ({column}, {row_}) shows {position.round(3)} m, {1000 * nearest:.2f} mm from the nearest point")
assert nearest < 0.02 * size
