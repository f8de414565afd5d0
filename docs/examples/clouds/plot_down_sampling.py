"""
Downsampling methods
====================

Many algorithms need fewer and evenly spaced points. On this page you compare five downsampling methods with about the
same number of points, and measure how even their spacing is.
"""

import numpy as np

import pointloom as loom

# %%
# A scan with uneven density
# --------------------------
# The cloud is a sphere, scanned from one side: four fifths of the points are on a fifth of the surface.
rng = np.random.default_rng(0)
directions = rng.normal(size=(60_000, 3))
directions /= np.linalg.norm(directions, axis=1, keepdims=True)
is_selected = (directions[:, 0] > 0.6) | (rng.random(len(directions)) < 0.06)
cloud = loom.PointCloud(0.5 * directions[is_selected])  # 0.5 m in radius
print(cloud)

# %%
# Five methods
# ------------
# Voxel downsampling replaces the points of each voxel by their mean. It is the fastest method and the default. The
# voxel size [m] is about the resulting spacing. Farthest point sampling repeatedly adds the point with the largest
# distance from all selected points. It is the most even one, returns an exact count, and is the slowest. Uniform (every
# k-th point) and random downsampling preserve the uneven density. Poisson-disk sampling requires a surface, here the
# true sphere.
voxels = cloud.voxel_down_sample(0.06)
count = len(voxels)
every = cloud.uniform_down_sample(len(cloud) // count)
random = cloud.random_down_sample(count / len(cloud), seed=1)
farthest = cloud.farthest_point_down_sample(count)
poisson_disk = loom.TriangleMesh.create_sphere(0.5, 40).sample_points_poisson_disk(count, seed=0)
methods = {
    "voxels": voxels,
    "farthest points": farthest,
    "Poisson disk": poisson_disk,
    "every k-th": every,
    "random": random,
}

# %%
# Measure the spacing
# -------------------
# The distance from each point to its nearest neighbor measures evenness: the minimum should not be much smaller than
# the median.
minimum, median = {}, {}
for name, thin in methods.items():
    spacing = thin.compute_nearest_neighbor_distance()
    minimum[name], median[name] = spacing.min(), np.median(spacing)
    print(
        f"{name:16} {len(thin):5} points, spacing {1000 * median[name]:5.1f} mm, minimum {1000 * minimum[name]:5.2f} mm"
    )

assert minimum["farthest points"] > 0.8 * median["farthest points"]  # evenly spaced
assert minimum["Poisson disk"] > 0.5 * median["Poisson disk"]
assert median["random"] < 0.5 * median["voxels"]  # still uneven
assert len(farthest) == count

# %%
# The results side by side. The color is the spacing: blue is dense, red is sparse.
scene, labels = {}, []
for index, (name, thin) in enumerate(methods.items()):
    shift = np.array([0.0, 1.08 * index, 0.0])
    thin["spacing [mm]"] = 1000 * thin.compute_nearest_neighbor_distance()
    scene[name] = {
        "geometry": thin.translate(shift),
        "color_by": "spacing [mm]",
        "colormap": "turbo",
        "limits": (0, 70),
        "point_size": 0.022,
        "metric": True,
    }
    labels.append((name, shift + np.array([0.0, 0.0, 0.62])))
corners = [[-0.5, -0.55, -0.5], [0.5, 5.6, 0.75]]
view = loom.View.fit(corners, direction=(-1.0, 0.0, -0.2), width=1120, height=320)
side_by_side = loom.render(scene, view, labels=labels, color_bar=True)

# %%
# Keep measured points
# --------------------
# The mean of a voxel is not a measured point. ``reduction="nearest"`` selects the point closest to the mean, with its
# attributes. Integer classes are never averaged: the result has no class 4 between classes 2 and 6.
cloud["class"] = np.where(cloud.points[:, 2] > 0, 6, 2).astype(np.int32)
thin = cloud.voxel_down_sample(0.06, reduction="nearest")
print("classes after downsampling:", np.unique(thin["class"]))
assert set(np.unique(thin["class"])) <= {2, 6}
assert thin.compute_point_cloud_distance(cloud).max() == 0.0  # all points are measured points
assert voxels.compute_point_cloud_distance(cloud).max() > 0.001  # a mean is up to some millimeters inside the sphere

# %%
# What to change
# --------------
# - The voxel size [m]: half the value gives about four times as many points.
# - ``seed`` of ``random_down_sample``: other points, the same statistics.
# - ``reduction``: ``"nearest"`` for classified clouds.
#
# Next
# ----
# - :ref:`Chapter 4 <sphx_glr_chapters_plot_04_downsampling_and_outliers.py>`: downsampling and outlier removal.
# - :ref:`Neighbor search for all points at once <sphx_glr_gallery_clouds_plot_neighbor_search.py>`
