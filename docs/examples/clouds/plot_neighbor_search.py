"""
Neighbor search for all points at once
======================================

On this page you search the neighbors of all points of a cloud in one call: the k nearest, all within a radius, and the
nearest k within a radius. You use the results to transfer colors between clouds and to measure the density of a scan.
"""

import numpy as np

import pointloom as loom

# %%
# Build the index
# ---------------
# The index is built once. Queries are arrays of shape ``(m, 3)`` or clouds.
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
search = loom.NearestNeighborSearch(room)
print(room)

# %%
# k nearest neighbors
# -------------------
# The result has k columns, sorted by distance. Distances are squared, in square meters. The nearest neighbor of a point
# of the cloud is the point itself with distance 0.
indices, sqdists, counts = search.knn_search(room, 8)
print("knn:", indices.shape, indices.dtype, "median distance to the 8th", f"{np.median(np.sqrt(sqdists[:, -1])):.3f} m")
assert (counts == 8).all() and (sqdists[:, 0] == 0).all() and (np.diff(sqdists, axis=1) >= 0).all()

# %%
# A comparison with brute force for one point:
query = np.array([[2.0, 1.5, 1.0]])
row = search.knn_search(query, 5)
expected = np.sort(((room.points - query) ** 2).sum(axis=1))[:5]
assert np.allclose(np.ravel(row.sqdists), expected, rtol=1e-4)

# %%
# ``KDTree`` has the call and the results of ``scipy.spatial.KDTree``: distances that are not squared, and indices.
distances, rows = loom.KDTree(room).query(query, 5)
assert np.allclose(np.ravel(distances) ** 2, expected, rtol=1e-4)

# %%
# Radius search
# -------------
# The number of neighbors within a radius varies, so ``radius_search`` returns one array with all indices, and
# ``counts``. ``hybrid_search`` returns at most k of them in k columns, padded with -1. It is the fastest for varying
# density. ``estimate_normals(radius=..., max_nn=...)`` uses it.
within = search.radius_search(room.points[:1000], 0.1)
hybrid = search.hybrid_search(room, 0.1, 12)
neighbor_counts = np.asarray(hybrid.counts)
print(
    f"within 10 cm of the first 1000 points: {len(np.ravel(within.indices))} neighbors; hybrid: "
    f"{neighbor_counts.mean():.1f} of at most 12"
)
assert hybrid.indices.shape == (len(room), 12) and (np.asarray(hybrid.indices)[neighbor_counts < 12, -1] == -1).all()

# %%
# Transfer attributes
# -------------------
# Each point of the dense cloud gets the weighted mean color of its three nearest points in the coarse cloud, without a
# loop in Python.
coarse = room.voxel_down_sample(0.10)
three = loom.NearestNeighborSearch(coarse).knn_search(room, 3)
weights = 1.0 / (np.asarray(three.sqdists) + 1e-6)
weights /= weights.sum(axis=1, keepdims=True)
transferred = np.einsum("ij,ijk->ik", weights, coarse.colors[np.asarray(three.indices)])
error = np.abs(transferred - room.colors).mean()
print(f"colors from {len(coarse)} points on {len(room)}: {255 * error:.1f} of 255 mean error")
assert error < 0.1

# %%
# Point density
# -------------
# The number of neighbors within 10 cm divided by the area of the disk, in points per square meter:
dense = np.asarray(search.radius_search(room, 0.1).counts)
room["points per m2"] = (dense / (np.pi * 0.1**2)).astype(np.float32)
low, high = room.get_min_bound(), room.get_max_bound()
without_ceiling = room.crop(
    loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
)
view = loom.View.fit(without_ceiling.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
density = loom.render(
    {"geometry": without_ceiling, "color_by": "points per m2", "colormap": "viridis"}, view, color_bar=True
)

# %%
# The transferred colors:
painted = loom.render(
    loom.PointCloud(room.points, colors=transferred.clip(0, 1)).crop(
        loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
    ),
    view,
)

# %%
# What to change
# --------------
# - k of ``knn_search``: 3 nearest points give a smoother transfer than 1.
# - The radius [m]: 0.2 instead of 0.1 has about four times as many neighbors on a surface.
# - ``max_nn`` of ``hybrid_search``: limits time and memory.
#
# Next
# ----
# - :ref:`Downsampling methods <sphx_glr_gallery_clouds_plot_down_sampling.py>`
# - :ref:`Write your own GPU operator <sphx_glr_gallery_kernels_plot_own_operator.py>`: neighbor search inside your own
#   kernel.
