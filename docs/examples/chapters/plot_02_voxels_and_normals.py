"""
2. Voxel downsampling and normals
=================================

Scans contain more points than most algorithms need, and their density decreases with the distance from the scanner.
Voxel downsampling makes the density uniform. A normal is the direction of the surface at a point. Registration, surface
reconstruction and plane detection use normals. In this chapter you downsample a cloud, estimate and orient its normals,
and choose the voxel size and the radius.
"""

# %%
# Voxel downsampling
# ------------------
# Space is divided into cubes, the voxels. All points in a voxel are replaced by one point: the mean of their positions,
# colors and normals. The voxel size is the edge length in the unit of the cloud, here meters. Details smaller than a
# voxel are lost.
#
# The method has the name of Open3D's: ``voxel_down_sample(voxel_size)``.

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

frame = loom.datasets.room_frames(24, noise=False)[20]
image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=6.0)
cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))
print("one image of a depth camera:", len(cloud), "points")

for voxel_size in (0.01, 0.03, 0.1, 0.3):
    print(f"voxels of {voxel_size:5} m: {len(cloud.voxel_down_sample(voxel_size)):6} points")

# %%
# Doubling the voxel size leaves about a quarter of the points, since surfaces are two-dimensional.

counts = [len(cloud.voxel_down_sample(size)) for size in (0.1, 0.2, 0.4)]
ratios = np.divide(counts[:-1], counts[1:])
print("0.1, 0.2, 0.4 m:", counts, "points, ratios", ratios.round(1))
assert (ratios > 2.5).all() and (ratios < 4.5).all()

# %%
# A voxel larger than the cloud leaves a single point. The usual cause is a cloud in millimeters and a voxel size in
# meters. A warning reports this:

with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    print(len(cloud.voxel_down_sample(10.0)), "point remains")
print(caught[0].category.__name__, "-", caught[0].message)
assert "voxel_size: 10 m exceeds the extent" in str(caught[0].message)

# %%
# The images show the cloud before and after downsampling, from behind the camera. Before, the density decreases with
# the distance. After, it is nearly uniform.

thin = cloud.voxel_down_sample(0.04)
side_view = {"front": [0.75, 0.62, 0.5], "up": [0, 0, 1], "zoom": 0.5}
before = loom.render({"geometry": cloud, "point_size": 2.0}, side_view, (960, 640))
after = loom.render({"geometry": thin, "point_size": 0.025, "metric": True}, side_view, (960, 640))


def neighbor_counts(points: loom.PointCloud) -> tuple[float, float]:
    """Median number of neighbors within 15 cm: for points within 2 m of the camera, and beyond 3 m."""
    distances = np.linalg.norm(points.points - frame.T_world_camera[:3, 3], axis=1)
    counts = loom.NearestNeighborSearch(points).radius_search(points.points, 0.15)[2]
    return float(np.median(counts[distances < 2.0])), float(np.median(counts[distances > 3.0]))


for name, points in (("before", cloud), ("after", thin)):
    count_near, count_far = neighbor_counts(points)
    print(f"{name}: {count_near:.0f} points within 15 cm close to the camera, {count_far:.0f} at a distance")
assert neighbor_counts(cloud)[0] > 2 * neighbor_counts(cloud)[1]
assert neighbor_counts(thin)[0] < 1.5 * neighbor_counts(thin)[1]

# %%
# Estimate normals
# ----------------
# A normal is a unit vector perpendicular to the surface. It is estimated by fitting a plane to the neighbors of a
# point. ``radius`` is the maximum distance of a neighbor, ``max_nn`` the maximum number of neighbors. A good first
# value is a radius of two to three voxels. A smaller radius makes normals noisy, a larger one rounds edges.
#
# Open3D's ``estimate_normals(KDTreeSearchParamHybrid(radius, max_nn))`` modifies the cloud in place. Here the result is
# a new cloud.

thin = thin.estimate_normals(radius=0.12, max_nn=30)
print(thin)
print("length of a normal:", np.linalg.norm(thin.normals[0]).round(6))

# %%
# A plane fit does not determine the sign of a normal. If the camera position is known, orient normals toward the
# camera, since a camera only observes surfaces that face it. If it is unknown, as in airborne or merged LiDAR scans,
# orient the normals of the ground upward: ``orient_normals_to_align_with_direction([0, 0, 1])``.

thin = thin.orient_normals_towards_camera_location(frame.T_world_camera[:3, 3])
cosine_times_distance = np.einsum("ij,ij->i", thin.normals, frame.T_world_camera[:3, 3] - thin.points)
assert (cosine_times_distance >= 0).all()

with_arrows = loom.render(
    {"geometry": thin.voxel_down_sample(0.1), "point_size": 6.0}, side_view, (960, 640), point_show_normal=True
)

# %%
# Check the normals
# -----------------
# The components x, y and z of a normal are displayed as red, green and blue. A planar surface has a single color. The
# floor of the room is horizontal, so the normals of points below 3 cm should be close to ``(0, 0, 1)``. This simulated
# camera has no noise, and most of these normals are within a degree. With a real camera, expect several degrees.

by_normal = loom.render(
    {"geometry": thin, "color_by": "normal", "point_size": 0.04, "metric": True}, side_view, (960, 640)
)

floor = thin.points[:, 2] < 0.03
tilt = np.degrees(np.arccos(np.clip(thin.normals[floor, 2], -1, 1)))
print(f"{floor.sum()} points of the floor; the normals of {np.mean(tilt < 1):.0%} are vertical within a degree")
assert np.median(tilt) < 8

# %%
# The effect of the radius
# ------------------------
# Real cameras have noise. This cell adds noise of 5 mm and estimates the normals again with three radii. A small radius
# has too few neighbors to average the noise. A large radius includes points on both sides of an edge. Compare the error
# on the floor, and the fraction of points with a sloped normal. The room has few sloped surfaces.

noise = np.random.default_rng(0).normal(0, 0.005, thin.points.shape)
noisy = loom.PointCloud(thin.points + noise)
errors, slanted = {}, {}
for radius in (0.06, 0.12, 0.5):
    up = abs(noisy.estimate_normals(radius=radius, max_nn=200).normals[:, 2])
    errors[radius] = float(np.median(np.degrees(np.arccos(np.clip(up[floor], 0, 1)))))
    slanted[radius] = float(((up > 0.2) & (up < 0.8)).mean())
    print(
        f"radius {radius} m: floor {errors[radius]:4.1f} degrees error, {slanted[radius]:.0%} of all points on a slope"
    )

assert errors[0.12] < errors[0.06], "a small radius does not average the noise"
assert slanted[0.12] < slanted[0.5], "a large radius rounds edges"

# %%
# The normals as an interactive page:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "normals.html", automatic=False, title="Normals as colors") as recording:
    recording.add("normals", thin, color_by="normal")
    recording.step("by normal")
page = folder / "normals.html"

# %%
# Common mistakes
# ---------------
# **Missing normals.** A method that requires normals raises an error with the call that estimates them:

plain = thin.without("normals")
try:
    plain.orient_normals_towards_camera_location([0, 0, 0])
except (ValueError, AttributeError) as error:
    message = str(error)
    print(message)
assert "estimate_normals" in message

# %%
# **Unknown camera position.** ``orient_normals_consistent_tangent_plane(30)`` makes the normals of neighbors
# consistent. All normals of a connected surface then point inward or all point outward. Chapter 11 uses it.
#
# What to change
# --------------
# - ``voxel_size`` [m]: find the size that leaves 5,000 points. Which objects of the room can you still recognize?
# - ``reduction="nearest"`` in ``voxel_down_sample``: keeps input points instead of means.
# - ``radius`` [m] and ``max_nn``: use ``max_nn=8`` without a radius. What happens where points are sparse?
#
# Next
# ----
# - :ref:`Chapter 3 <sphx_glr_chapters_plot_03_segmentation.py>`: separate a cloud into planes and clusters.
# - :ref:`Chapter 4 <sphx_glr_chapters_plot_04_downsampling_and_outliers.py>`: other downsampling methods, and outlier
#   removal.
# - :doc:`Coming from Open3D </open3d>`: the corresponding names in Open3D.
