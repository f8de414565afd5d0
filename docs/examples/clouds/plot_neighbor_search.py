"""
Neighbors of a million places at once
======================================

Which points are near this one? Asked for a whole cloud at once, it is the base of nearly everything that clouds are
used for. One search structure answers three kinds of question here: the k nearest, all within a radius, and the
nearest k within a radius. The answers are arrays, to compute with.
"""

import numpy as np

import pointloom as loom

# %%
# The structure is built once for a cloud; queries may be any array of shape [m, 3] or another cloud.
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
search = loom.NearestNeighborSearch(room)
print(room)

# %%
# **The k nearest**: rows of equal length, nearest first; distances are squared, in square meters, as one mostly
# compares them. A point is its own nearest neighbor, at distance 0.
indices, sqdists, counts = search.knn_search(room, 8)
print("knn:", indices.shape, indices.dtype, "median distance to the 8th", f"{np.median(np.sqrt(sqdists[:, -1])):.3f} m")
assert (counts == 8).all() and (sqdists[:, 0] == 0).all() and (np.diff(sqdists, axis=1) >= 0).all()

# %%
# Checked by hand for one place: nothing is nearer than what was found.
query = np.array([[2.0, 1.5, 1.0]])
row = search.knn_search(query, 5)
by_hand = np.sort(((room.points - query) ** 2).sum(axis=1))[:5]
assert np.allclose(np.ravel(row.sqdists), by_hand, rtol=1e-4)

# %%
# **All within a radius** differ in number, so they lie end to end, and ``counts`` says how many belong to each place.
# **Hybrid** takes at most k of them: rows of equal length again, -1 where there are fewer. It is the quickest where
# the density varies, and what ``estimate_normals(radius=..., max_nn=...)`` uses.
within = search.radius_search(room.points[:1000], 0.1)
hybrid = search.hybrid_search(room, 0.1, 12)
neighbor_counts = np.asarray(hybrid.counts)
print(
    f"within 10 cm of the first 1000 points: {len(np.ravel(within.indices))} neighbors; hybrid: "
    f"{neighbor_counts.mean():.1f} of at most 12"
)
assert hybrid.indices.shape == (len(room), 12) and (np.asarray(hybrid.indices)[neighbor_counts < 12, -1] == -1).all()

# %%
# What it is good for, an example: carry a value over from another cloud. The colors of a coarse copy go to the dense
# one, each point taking the mean of its three nearest, weighted by distance. No loop in Python.
coarse = room.voxel_down_sample(0.10)
three = loom.NearestNeighborSearch(coarse).knn_search(room, 3)
weights = 1.0 / (np.asarray(three.sqdists) + 1e-6)
weights /= weights.sum(axis=1, keepdims=True)
carried = np.einsum("ij,ijk->ik", weights, coarse.colors[np.asarray(three.indices)])
error = np.abs(carried - room.colors).mean()
print(f"colors from {len(coarse)} points on {len(room)}: {255 * error:.1f} of 255 off on average")
assert error < 0.1

# %%
# Another one: how densely was it scanned? Neighbors within 10 cm over the area of that disc, in points a square
# metre.
dense = np.asarray(search.radius_search(room, 0.1).counts)
room["points per m2"] = (dense / (np.pi * 0.1**2)).astype(np.float32)
low, high = room.get_min_bound(), room.get_max_bound()
shown = room.crop(loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2]))
view = loom.View.fit(shown.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
density = loom.render({"geometry": shown, "color_by": "points per m2", "colormap": "viridis"}, view, color_bar=True)

# %%
# The colors that were carried over.
painted = loom.render(
    loom.PointCloud(room.points, colors=carried.clip(0, 1)).crop(
        loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
    ),
    view,
)
