"""
Clouds larger than the memory
=============================

A survey can have hundreds of millions of points. An image has one million pixels. On this page you read an evenly
distributed preview of a file, process a file in chunks, and use a level-of-detail tree that selects points for a view.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A survey file
# -------------
# The file contains hills of 400 x 400 m with a road, written as LAZ.
folder = Path(tempfile.mkdtemp())
rng = np.random.default_rng(3)
east, north = rng.uniform(0, 400, (2, 1_000_000))
height = (
    12 * np.sin(east / 55) * np.cos(north / 70)
    + 4 * np.sin((east + 2 * north) / 23)
    + rng.normal(scale=0.05, size=east.size)
)
is_road = np.abs(north - 200 - 40 * np.sin(east / 60)) < 4
cloud = loom.PointCloud(
    np.column_stack([east + 512_000, north + 5_403_000, height + 420]),
    intensity=np.where(is_road, 900, 300).astype(np.uint16),
)
survey = folder / "survey.laz"
loom.write_point_cloud(survey, cloud)
print(f"{len(cloud):,} points, {survey.stat().st_size / 2**20:.1f} MiB")

# %%
# Preview
# -------
# ``DetailTree.sample`` reads about 50,000 evenly distributed points of the file.
preview = loom.DetailTree.sample(survey, 50_000)
print(
    f"preview: {len(preview):,} points, from {preview.get_min_bound().round(1)} to {preview.get_max_bound().round(1)} m"
)
assert len(preview) <= 50_000

# %%
# Chunks
# ------
# ``read_las_chunks`` needs memory for 250,000 points at a time, for a file of any size. All chunks have the same
# origin, so their results can be combined. Here the mean height on a grid of 4 m is accumulated over all chunks.
cell, columns = 4.0, 100
total, hits = np.zeros(columns**2), np.zeros(columns**2)
chunk_count = 0
for chunk in loom.read_las_chunks(survey, 250_000):
    chunk_count += 1
    x, y = (chunk.points[:, :2] - [512_000, 5_403_000]).T
    cells = (y // cell).astype(int).clip(0, 99) * columns + (x // cell).astype(int).clip(0, 99)
    total += np.bincount(cells, chunk.points[:, 2], columns**2)
    hits += np.bincount(cells, minlength=columns**2)
print(f"{chunk_count} chunks; {int(hits.sum()):,} points in {(hits > 0).sum():,} cells")
assert hits.sum() == len(cloud) and chunk_count == 4
cells = (north // cell).astype(int) * columns + (east // cell).astype(int)
expected = np.bincount(cells, height + 420, columns**2) / np.bincount(cells, minlength=columns**2)
assert (
    np.abs(total / hits - expected).max() < 0.1
)  # LAZ rounds to millimeters, which may move a point to the adjacent cell

# %%
# Level-of-detail tree
# --------------------
# Each node contains points with a minimum spacing. Nodes closer to the root have a larger spacing. For a view, nodes
# are selected until the point budget is exhausted, in the order of their spacing on the screen.
tree = loom.DetailTree.from_file(survey, attributes=["intensity"])
center = cloud.get_center()
far_view = loom.View.fit(preview.points, direction=(0.1, 0.8, -0.6), width=960, height=640)
close_view = loom.View.fit(
    preview.points[np.linalg.norm(preview.points[:, :2] - center[:2], axis=1) < 25],
    direction=(0.1, 0.8, -0.5),
    width=960,
    height=640,
)
budget = 150_000
views = {}
for name, view in {"far": far_view, "near": close_view}.items():
    nodes = tree.select(view, budget=budget)
    indices = np.concatenate([tree.indices_of(node) for node in nodes])
    points = np.vstack([tree.points_of(node) for node in nodes])
    views[name] = loom.PointCloud(points, intensity=tree.attributes["intensity"][indices])
    print(
        f"{name:5}{len(nodes):4} of {len(tree)} nodes, {len(indices):,} points, spacings "
        f"{tree.spacings[nodes].max():.2f} to {tree.spacings[nodes].min():.2f} m"
    )
    assert len(indices) <= budget and len(np.unique(indices)) == len(indices)
finest = {
    name: min(tree.spacings[tree.select(view, budget=budget)])
    for name, view in (("far", far_view), ("near", close_view))
}
assert finest["near"] <= finest["far"]  # closer views have more detail

# %%
# The distant view displays 150,000 of a million points. The road has a higher intensity.
style = {"color_by": "intensity", "colormap": "viridis", "limits": (200, 900), "metric": True}
overview = loom.render({"geometry": views["far"], "point_size": 1.6} | style, far_view, color_bar=True)

# %%
# The close view uses other nodes with a smaller spacing. ``pointloom view survey.laz`` does the same in a browser while
# the camera moves.
detail = loom.render({"geometry": views["near"], "point_size": 0.8} | style, close_view, color_bar=True)

# %%
# What to change
# --------------
# - ``budget`` [points]: 20,000 displays coarser nodes.
# - The chunk size [points]: smaller chunks need less memory and more time.
# - ``cell`` [m]: the resolution of the grid of heights. The number of columns must change accordingly.
#
# Next
# ----
# - :doc:`Large clouds in the viewer </large-clouds>`
# - :doc:`Tiled and out-of-core processing </tiles>`
