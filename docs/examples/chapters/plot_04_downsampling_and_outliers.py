"""
4. Downsampling and outlier removal
===================================

Every scan contains outliers: rays that hit an edge partially, dust, moving people. It also contains more points than
needed. In this chapter you compare four downsampling methods and two outlier filters, choose their parameters, and
check which points were removed.
"""

# %%
# Four downsampling methods
# -------------------------
# ================================= ====================================================== ==========================
# call                              result                                                 use
# ================================= ====================================================== ==========================
# ``voxel_down_sample(0.05)``       one mean point for each voxel of 5 cm                  default
# ``uniform_down_sample(10)``       every tenth point, in the order of the file            preview of a large file
# ``random_down_sample(0.1)``       a random tenth of the points                           statistics
# ``farthest_point_down_sample(n)`` n points with the largest possible spacing             fixed count for networks
# ================================= ====================================================== ==========================
#
# All four have the names and parameters of Open3D. Random methods have a ``seed``. The same seed gives the same points.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

figure = loom.datasets.object_mesh()
size = float(np.linalg.norm(figure.get_max_bound() - figure.get_min_bound()))
cloud = figure.sample_points_uniformly(40_000, seed=1)
print(cloud, f"of a figure {size:.3f} m across")

voxel_size = 0.03 * size
by_voxels = cloud.voxel_down_sample(voxel_size)
methods = {
    "voxels": by_voxels,
    "every k-th": cloud.uniform_down_sample(len(cloud) // len(by_voxels)),
    "random": cloud.random_down_sample(len(by_voxels) / len(cloud), seed=0),
    "farthest": cloud.farthest_point_down_sample(len(by_voxels)),
}
for name, thin in methods.items():
    largest_gap = cloud.compute_point_cloud_distance(thin).max()
    print(f"{name:11} {len(thin):5} points; largest gap {largest_gap / size:.1%} of the size")

step = np.array([1.15 * (figure.get_max_bound() - figure.get_min_bound())[0], 0, 0])
row = [thin.translate(k * step) for k, thin in enumerate(methods.values())]
labels = [(name, figure.get_center() + k * step - [0, 0, 0.62 * size]) for k, name in enumerate(methods)]
front = {"front": [0, -1, 0.12], "up": [0, 0, 1], "zoom": 0.42}
method_comparison = loom.render([{"geometry": thin, "point_size": 5} for thin in row], front, (960, 640), labels=labels)

gaps = {name: cloud.compute_point_cloud_distance(thin).max() for name, thin in methods.items()}
assert gaps["farthest"] < gaps["voxels"] < gaps["random"], "uniform spacing leaves smaller gaps"

# %%
# Farthest point sampling and voxels leave no gaps. Random samples do. ``uniform_down_sample`` depends on the order of
# the points in the file. On a scan that is stored line by line, it leaves stripes.
#
# Add outliers
# ------------
# The script adds known outliers: 600 random points in a box around the object.

rng = np.random.default_rng(0)
low, high = cloud.get_min_bound(), cloud.get_max_bound()
anywhere = rng.uniform(low - 0.1 * size, high + 0.1 * size, (600, 3))
scan = cloud.random_down_sample(0.5, seed=2)
noisy = loom.PointCloud(np.vstack([scan.points, anywhere]))
noisy.colors = np.vstack([scan.colors, np.full((600, 3), 0.5)])
is_outlier = np.arange(len(noisy)) >= len(scan)
# outliers that are on the surface by chance cannot be detected
is_outlier &= np.asarray(noisy.compute_point_cloud_distance(cloud)) > 0.01 * size
print(len(noisy), "points,", is_outlier.sum(), "of them outliers")

# %%
# Statistical outlier removal
# ---------------------------
# For each point, the filter computes the mean distance to its 20 nearest neighbors. It removes points whose mean
# distance exceeds the mean over the cloud by more than ``std_ratio`` standard deviations. The parameter has no unit. A
# smaller ratio removes more points. Try 2, then 1, then 0.5, and check the removed points. The value 0.5 used below is
# suitable for this uniformly dense cloud only.


def removal_rates(rows: np.ndarray) -> tuple[float, float]:
    """Return the fraction of outliers that were removed, and the fraction of inliers that were removed."""
    removed = np.ones(len(noisy), bool)
    removed[np.asarray(rows)] = False
    return float(removed[is_outlier].mean()), float(removed[~is_outlier].mean())


for ratio in (2.0, 1.0, 0.5, 0.1):
    _, rows = noisy.remove_statistical_outlier(nb_neighbors=20, std_ratio=ratio)
    caught, lost = removal_rates(rows)
    print(f"std_ratio {ratio:3}: {caught:4.0%} of the outliers and {lost:5.1%} of the inliers removed")

inliers, rows = noisy.remove_statistical_outlier(nb_neighbors=20, std_ratio=0.5)
caught, lost = removal_rates(rows)
assert caught > 0.9 and lost < 0.02

# %%
# Always check the removed points, not only the remaining ones. Removed points are red:

removed_points = noisy.select_by_index(rows, invert=True)
side = {"front": [0.3, -1, 0.25], "up": [0, 0, 1], "zoom": 0.62}
cleaned = loom.render(
    [inliers, {"geometry": removed_points, "color": (0.9, 0.1, 0.1), "point_size": 5}], side, (960, 640),
    legend=[("removed", (0.9, 0.1, 0.1))],
)  # fmt: skip

# %%
# Radius outlier removal
# ----------------------
# The filter removes points with fewer than ``nb_points`` neighbors within ``radius``. A good first value is six times
# the point spacing, which ``compute_nearest_neighbor_distance`` returns. Both filters assume a uniform density. If the
# density decreases with the distance, as in LiDAR scans, both remove distant points. Check the range of the removed
# points. Downsample by voxels first, or filter only the points close to the scanner.

spacing = float(np.median(noisy.compute_nearest_neighbor_distance()))
for radius in (3 * spacing, 6 * spacing, 20 * spacing):
    _, rows = noisy.remove_radius_outlier(nb_points=6, radius=radius)
    caught, lost = removal_rates(rows)
    print(
        f"radius {radius / spacing:4.1f} spacings: {caught:4.0%} of the outliers and {lost:5.1%} of the inliers removed"
    )

_, by_radius = noisy.remove_radius_outlier(nb_points=6, radius=6 * spacing)
caught, lost = removal_rates(by_radius)
assert caught > 0.9 and lost < 0.02
_, nothing = noisy.remove_radius_outlier(nb_points=6, radius=1000 * spacing)
assert len(nothing) == len(noisy), "a radius larger than the cloud removes nothing"

# %%
# An interactive page: remaining points in gray, removed points in red.

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "outliers.html", automatic=False, title="Outliers are red") as recording:
    recording.add("inliers", inliers, color=(0.6, 0.65, 0.7))
    recording.add("outliers", removed_points, color=(0.9, 0.1, 0.1), point_size=4)
    recording.step("before")
    recording.remove("outliers")
    recording.step("after")
page = folder / "outliers.html"

# %%
# Common mistakes
# ---------------
# **Swapped parameters.** Both filters take a count and a number. The wrong order raises an error:

try:
    noisy.remove_radius_outlier(0.05, 16)
except TypeError as error:
    message = str(error)
    print(message)
assert "nb_points" in message

# %%
# **Repeated filtering.** Each pass of the statistical filter computes a new mean and removes more points. Thin
# structures such as cables and chair legs disappear. Filter once, and check the result.
#
# **Noise on the surface** is not removed, since these points have neighbors. ``smooth_mls`` moves points onto the local
# surface. Chapter 11 averages the noise by surface reconstruction.
#
# What to change
# --------------
# - ``nb_neighbors``: compare 5 and 100. Which value detects small groups of outliers?
# - ``std_ratio``: 2.0 removes 85% of the outliers, 0.1 also removes 2% of the inliers.
# - The order: downsample to a tenth first, then filter. Which order is more accurate, and which is faster?
#
# Next
# ----
# - :ref:`Chapter 5 <sphx_glr_chapters_plot_05_depth_images_to_clouds.py>`: point clouds from depth images.
# - :doc:`Command line </shell>`: ``pointloom clean scan.ply clean.ply`` does the same.
# - :doc:`Tiled processing </tiles>`: clouds larger than the memory.
