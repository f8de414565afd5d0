"""
4. Thin and clean
=================

Every scan has points that belong to nothing: rays that hit an edge half, dust, people who walked by. And it has more
points than you need. You learn four ways of thinning and two ways of cleaning, what their numbers mean, and to check
that what went was rubbish.
"""

# %%
# Four ways to have fewer points
# ------------------------------
# ================================= ====================================================== ==========================
# call                              what it keeps                                          take it
# ================================= ====================================================== ==========================
# ``voxel_down_sample(0.05)``       one mean point for each cube of 5 cm                   as a rule
# ``uniform_down_sample(10)``       every tenth point, in the order of the file            to look at a large file
# ``random_down_sample(0.1)``       a tenth, drawn at random                               for statistics
# ``farthest_point_down_sample(n)`` n points as far from each other as can be              for a fixed count: networks
# ================================= ====================================================== ==========================
#
# In Open3D all four have the same names and numbers. What is drawn at random takes a ``seed`` here, and the same call
# gives the same points.

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
ways = {
    "voxels": by_voxels,
    "every k-th": cloud.uniform_down_sample(len(cloud) // len(by_voxels)),
    "random": cloud.random_down_sample(len(by_voxels) / len(cloud), seed=0),
    "farthest": cloud.farthest_point_down_sample(len(by_voxels)),
}
for name, thin in ways.items():
    holes = cloud.compute_point_cloud_distance(thin).max()
    print(
        f"{name:11} {len(thin):5} points; no point of the cloud is farther than {holes / size:.1%} of its size from one"
    )

step = np.array([1.15 * (figure.get_max_bound() - figure.get_min_bound())[0], 0, 0])
row = [thin.translate(k * step) for k, thin in enumerate(ways.values())]
labels = [(name, figure.get_center() + k * step - [0, 0, 0.62 * size]) for k, name in enumerate(ways)]
front = {"front": [0, -1, 0.12], "up": [0, 0, 1], "zoom": 0.42}
four_ways = loom.render([{"geometry": thin, "point_size": 5} for thin in row], front, (960, 640), labels=labels)

gaps = {name: cloud.compute_point_cloud_distance(thin).max() for name, thin in ways.items()}
assert gaps["farthest"] < gaps["voxels"] < gaps["random"], "even samples leave smaller holes"

# %%
# Farthest points and voxels leave no holes; random ones do, as rain leaves dry spots. ``uniform_down_sample`` depends
# on the order of the points in the file: on a scan that was written line by line it draws stripes.
#
# Rubbish
# -------
# Now we make rubbish ourselves, so that we know what it is: points anywhere in the box around the figure, and a crust
# of points that are a little off the surface.

rng = np.random.default_rng(0)
low, high = cloud.get_min_bound(), cloud.get_max_bound()
anywhere = rng.uniform(low - 0.1 * size, high + 0.1 * size, (600, 3))
scan = cloud.random_down_sample(0.5, seed=2)
noisy = loom.PointCloud(np.vstack([scan.points, anywhere]))
noisy.colors = np.vstack([scan.colors, np.full((600, 3), 0.5)])
is_rubbish = np.arange(len(noisy)) >= len(scan)
# those that happened to fall on the surface cannot be told, by anybody
is_rubbish &= np.asarray(noisy.compute_point_cloud_distance(cloud)) > 0.01 * size
print(len(noisy), "points,", is_rubbish.sum(), "of them rubbish")

# %%
# Statistical outliers
# --------------------
# For each point: the mean distance to its 20 nearest neighbors. Over the whole cloud these distances have a mean and a
# standard deviation. Points with more than the mean plus ``std_ratio`` deviations go. No length is to be chosen, so it
# fits any unit; a smaller ratio cuts more. Try 2, then 1, then 0.5, and look at what went; the 0.5 taken below suits
# this evenly dense cloud only.


def judged(rows: np.ndarray) -> tuple[float, float]:
    """The fraction of the rubbish that went, and the fraction of good points that went with it."""
    went = np.ones(len(noisy), bool)
    went[np.asarray(rows)] = False
    return float(went[is_rubbish].mean()), float(went[~is_rubbish].mean())


for ratio in (2.0, 1.0, 0.5, 0.1):
    _, rows = noisy.remove_statistical_outlier(nb_neighbors=20, std_ratio=ratio)
    caught, lost = judged(rows)
    print(f"std_ratio {ratio:3}: {caught:4.0%} of the rubbish went, and {lost:5.1%} of the good points")

inliers, rows = noisy.remove_statistical_outlier(nb_neighbors=20, std_ratio=0.5)
caught, lost = judged(rows)
assert caught > 0.9 and lost < 0.02

# %%
# Look at what goes, always, and not only at what stays. Red goes:

gone = noisy.select_by_index(rows, invert=True)
side = {"front": [0.3, -1, 0.25], "up": [0, 0, 1], "zoom": 0.62}
cleaned = loom.render(
    [inliers, {"geometry": gone, "color": (0.9, 0.1, 0.1), "point_size": 5}], side, (960, 640),
    legend=[("goes", (0.9, 0.1, 0.1))],
)  # fmt: skip

# %%
# Outliers by radius
# ------------------
# Points with fewer than ``nb_points`` others within ``radius`` go. Here a length is to be chosen: six times the
# spacing of the points is a start, which ``compute_nearest_neighbor_distance`` tells. Both ways
# suit clouds that are evenly dense. Where a scanner's points thin out with the distance, both eat the far end, as in a
# LiDAR scan: look at the range of what went, and thin by voxels first or clean the near part alone.

spacing = float(np.median(noisy.compute_nearest_neighbor_distance()))
for radius in (1.5 * spacing, 6 * spacing, 20 * spacing):
    _, rows = noisy.remove_radius_outlier(nb_points=6, radius=radius)
    caught, lost = judged(rows)
    print(f"radius {radius / spacing:4.1f} spacings: {caught:4.0%} of the rubbish went, {lost:5.1%} of the good points")

_, by_radius = noisy.remove_radius_outlier(nb_points=6, radius=6 * spacing)
caught, lost = judged(by_radius)
assert caught > 0.9 and lost < 0.02
_, nothing = noisy.remove_radius_outlier(nb_points=6, radius=1000 * spacing)
assert len(nothing) == len(noisy), "a radius larger than the cloud removes nothing"

# %%
# The same to turn: gray stays, red goes.

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "outliers.html", automatic=False, title="What goes is red") as recording:
    recording.add("kept", inliers, color=(0.6, 0.65, 0.7))
    recording.add("gone", gone, color=(0.9, 0.1, 0.1), point_size=4)
    recording.step("before")
    recording.remove("gone")
    recording.step("after")
page = folder / "outliers.html"

# %%
# What goes wrong
# ---------------
# **The two numbers swapped.** Both cleaners take a count and a length. The wrong way round is an error:

try:
    noisy.remove_radius_outlier(0.05, 16)
except TypeError as error:
    message = str(error)
    print(message)
assert "nb_points" in message

# %%
# **Twice is too often.** Each pass of the statistical way finds a new mean, and cuts again: thin but true parts (a
# cable, a chair's leg) go in the end. Clean once, look, stop.
#
# **A smooth crust is no outlier.** Noise that lies close to the surface has neighbors. Chapter 11 averages it away
# by a surface; ``smooth_mls`` moves points onto theirs.
#
# Try it
# ------
# - Give 5 and 100 for ``nb_neighbors``. Which one catches rubbish that comes in small clumps?
# - Thin to a tenth first, then clean. Which order is better, and which is quicker?
#
# Where to go next
# ----------------
# :ref:`Chapter 5 <sphx_glr_chapters_plot_05_depth_pictures_to_clouds.py>` makes clouds of depth images. The shell
# does this chapter as ``pointloom clean scan.ply clean.ply``. For scans larger than the memory see the page
# :doc:`Large clouds </large-clouds>`.
