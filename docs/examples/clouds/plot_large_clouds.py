"""
A cloud larger than the screen, or the memory
=============================================

A survey has hundreds of millions of points; an image has one million pixels. Three ways of working with what does
not fit: a first look taken evenly from the file, parts read one after the other, and a tree of details of which a
view takes what it can show.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A survey to try it with: hills of 400 by 400 m with a road, made here in parts and written as LAZ.
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
# **A first look**: some 50,000 points taken evenly, before anything large is read.
look = loom.DetailTree.sample(survey, 50_000)
print(f"first look: {len(look):,} points, from {look.get_min_bound().round(1)} to {look.get_max_bound().round(1)} m")
assert len(look) <= 50_000

# %%
# **Parts**: memory for 250,000 points at a time, whatever the file holds. All parts have one origin, so what is found
# in them fits together: here, the mean height on a grid of 4 m, summed part by part.
cell, columns = 4.0, 100
total, hits = np.zeros(columns**2), np.zeros(columns**2)
parts = 0
for part in loom.read_las_chunks(survey, 250_000):
    parts += 1
    x, y = (part.points[:, :2] - [512_000, 5_403_000]).T
    cells = (y // cell).astype(int).clip(0, 99) * columns + (x // cell).astype(int).clip(0, 99)
    total += np.bincount(cells, part.points[:, 2], columns**2)
    hits += np.bincount(cells, minlength=columns**2)
print(f"{parts} parts; {int(hits.sum()):,} points in {(hits > 0).sum():,} cells")
assert hits.sum() == len(cloud) and parts == 4
cells = (north // cell).astype(int) * columns + (east // cell).astype(int)
by_hand = np.bincount(cells, height + 420, columns**2) / np.bincount(cells, minlength=columns**2)
assert np.abs(total / hits - by_hand).max() < 0.1  # LAZ holds millimeters: a point on a cell's edge may change sides

# %%
# **A tree of details.** Each node holds points no two of which are nearer than its spacing; coarse nodes come first.
# A view takes nodes until its budget is used, those first whose points are farthest apart on the screen.
tree = loom.DetailTree.from_file(survey, attributes=["intensity"])
middle = cloud.get_center()
far = loom.View.fit(look.points, direction=(0.1, 0.8, -0.6), width=960, height=640)
near = loom.View.fit(
    look.points[np.linalg.norm(look.points[:, :2] - middle[:2], axis=1) < 25],
    direction=(0.1, 0.8, -0.5),
    width=960,
    height=640,
)
budget = 150_000
views = {}
for name, view in {"far": far, "near": near}.items():
    nodes = tree.select(view, budget=budget)
    indices = np.concatenate([tree.indices_of(node) for node in nodes])
    points = np.vstack([tree.points_of(node) for node in nodes])
    views[name] = loom.PointCloud(points, intensity=tree.attributes["intensity"][indices])
    print(
        f"{name:5}{len(nodes):4} of {len(tree)} nodes, {len(indices):,} points, spacings "
        f"{tree.spacings[nodes].max():.2f} to {tree.spacings[nodes].min():.2f} m"
    )
    assert len(indices) <= budget and len(np.unique(indices)) == len(indices)
finest = {name: min(tree.spacings[tree.select(view, budget=budget)]) for name, view in (("far", far), ("near", near))}
assert finest["near"] <= finest["far"]  # what is near is shown in more detail

# %%
# From afar: 150,000 of a million points. The road is brighter, and so are its points.
style = {"color_by": "intensity", "colormap": "viridis", "limits": (200, 900), "metric": True}
overview = loom.render({"geometry": views["far"], "point_size": 1.6} | style, far, color_bar=True)

# %%
# From near: other nodes, finer ones. ``pointloom view survey.laz`` does the same in a browser while one moves.
detail = loom.render({"geometry": views["near"], "point_size": 0.8} | style, near, color_bar=True)
