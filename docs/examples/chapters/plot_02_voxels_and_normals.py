"""
2. Voxels and normals
=====================

Scans have far more points than a question needs, and unevenly: many near the scanner, few far away. Voxels thin them
evenly. Normals say which way the surface looks at each point; nearly every later step (registration, surfaces, planes)
needs them. You learn both, and how to choose their two numbers.
"""

# %%
# Thin by voxels
# --------------
# Space is cut into cubes, the voxels. All points in one cube become one: the mean of their places, colors and
# normals. The edge of a cube is the one number to choose, in the unit of the cloud, here meters. Nothing smaller than
# a voxel survives.
#
# In Open3D this is the same: ``voxel_down_sample(voxel_size)``.

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
# Twice the edge leaves about a quarter of the points, as surfaces are flat things: a sheet is cut into squares.

counts = [len(cloud.voxel_down_sample(size)) for size in (0.1, 0.2, 0.4)]
ratios = np.divide(counts[:-1], counts[1:])
print("0.1, 0.2, 0.4 m:", counts, "points, ratios", ratios.round(1))
assert (ratios > 2.5).all() and (ratios < 4.5).all()

# %%
# The mistake to know: a voxel larger than the cloud leaves a single point. It mostly means that the cloud is in
# millimeters and the voxel in meters, or the other way round. A warning says so:

with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    print(len(cloud.voxel_down_sample(10.0)), "point is left")
print(caught[0].category.__name__, "-", caught[0].message)
assert "voxel_size: 10 m exceeds the extent" in str(caught[0].message)

# %%
# Before and after, seen from behind the camera's shoulder. Before, the points thin out with the distance; after, their
# number no longer falls with it.

thin = cloud.voxel_down_sample(0.04)
side_view = {"front": [0.75, 0.62, 0.5], "up": [0, 0, 1], "zoom": 0.5}
before = loom.render({"geometry": cloud, "point_size": 2.0}, side_view, (960, 640))
after = loom.render({"geometry": thin, "point_size": 0.025, "metric": True}, side_view, (960, 640))


def crowd(points: loom.PointCloud) -> tuple[float, float]:
    """How many points lie within 15 cm of one (median): for points within 2 m of the camera, and beyond 3 m."""
    away = np.linalg.norm(points.points - frame.T_world_camera[:3, 3], axis=1)
    around = loom.NearestNeighborSearch(points).radius_search(points.points, 0.15)[2]
    return float(np.median(around[away < 2.0])), float(np.median(around[away > 3.0]))


for name, points in (("before", cloud), ("after", thin)):
    near, far = crowd(points)
    print(f"{name}: {near:.0f} points within 15 cm near the camera, {far:.0f} far from it")
assert crowd(cloud)[0] > 2 * crowd(cloud)[1]
assert crowd(thin)[0] < 1.5 * crowd(thin)[1]

# %%
# Normals
# -------
# A normal is an arrow of length 1 that stands on the surface. It is found by laying a plane through the neighbors of a
# point. ``radius`` says how far a neighbor may be, ``max_nn`` how many are taken at most. A radius of two to three
# voxels is a good start: less, and noise turns the arrows; more, and edges become round.
#
# In Open3D this is ``estimate_normals(KDTreeSearchParamHybrid(radius, max_nn))``, which changes the cloud in place.
# Here the result is a new cloud.

thin = thin.estimate_normals(radius=0.12, max_nn=30)
print(thin)
print("length of a normal:", np.linalg.norm(thin.normals[0]).round(6))

# %%
# Which side of the surface an arrow is on cannot be known from the neighbors. But it is known where the camera stood,
# and one only sees surfaces that look toward oneself. (Where it is not known, as in airborne or joined LiDAR scans,
# the ground at least looks up: ``orient_normals_to_align_with_direction([0, 0, 1])``.)

thin = thin.orient_normals_towards_camera_location(frame.T_world_camera[:3, 3])
toward = np.einsum("ij,ij->i", thin.normals, frame.T_world_camera[:3, 3] - thin.points)
assert (toward >= 0).all()

with_arrows = loom.render(
    {"geometry": thin.voxel_down_sample(0.1), "point_size": 6.0}, side_view, (960, 640), point_show_normal=True
)

# %%
# Are they right?
# ---------------
# As colors: red, green and blue are x, y and z of the arrow. What is flat has one color. The floor of a room looks
# up, so its points can be counted: those with a height below 3 cm should have a normal near (0, 0, 1). This
# camera is exact, so most of them are upright to a degree; with a real one expect several degrees.

by_normal = loom.render(
    {"geometry": thin, "color_by": "normal", "point_size": 0.04, "metric": True}, side_view, (960, 640)
)

floor = thin.points[:, 2] < 0.03
tilt = np.degrees(np.arccos(np.clip(thin.normals[floor, 2], -1, 1)))
print(f"{floor.sum()} points of the floor; the normals of {np.mean(tilt < 1):.0%} are upright to a degree")
assert np.median(tilt) < 8

# %%
# What the radius does
# --------------------
# Real cameras are not exact. So the points get a noise of 5 mm, and the normals are made again with a
# small and a large radius. Too small a one has too few neighbors to average the noise; too large a one reaches over
# edges. Look at the figures for the floor, then at the fraction of points that seem to lie on a slope, of which a room
# has few.

noise = np.random.default_rng(0).normal(0, 0.005, thin.points.shape)
noisy = loom.PointCloud(thin.points + noise)
errors, slanted = {}, {}
for radius in (0.06, 0.12, 0.5):
    up = abs(noisy.estimate_normals(radius=radius, max_nn=200).normals[:, 2])
    errors[radius] = float(np.median(np.degrees(np.arccos(np.clip(up[floor], 0, 1)))))
    slanted[radius] = float(((up > 0.2) & (up < 0.8)).mean())
    print(f"radius {radius} m: floor {errors[radius]:4.1f} degrees off, {slanted[radius]:.0%} of all points on a slope")

assert errors[0.12] < errors[0.06], "a small radius does not average the noise"
assert slanted[0.12] < slanted[0.5], "a large radius rounds edges off"

# %%
# In three dimensions, to turn:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "normals.html", automatic=False, title="Normals as colors") as recording:
    recording.add("normals", thin, color_by="normal")
    recording.step("by normal")
page = folder / "normals.html"

# %%
# What goes wrong
# ---------------
# A step that needs normals says so, and which call makes them:

plain = thin.without("normals")
try:
    plain.orient_normals_towards_camera_location([0, 0, 0])
except (ValueError, AttributeError) as error:
    message = str(error)
    print(message)
assert "estimate_normals" in message

# %%
# Where nobody knows where the camera stood, ``orient_normals_consistent_tangent_plane(30)`` makes neighbors agree. It
# settles all arrows of one piece alike, inwards or outwards; chapter 11 uses it.
#
# Try it
# ------
# - Give ``reduction="nearest"`` to ``voxel_down_sample``: points of the input stay, none is averaged.
# - Choose a voxel so that 5,000 points are left. Which of the things in the room can you still tell?
# - Estimate normals by ``max_nn=8`` alone, without a radius. What happens where points are thin?
#
# Where to go next
# ----------------
# :ref:`Chapter 3 <sphx_glr_chapters_plot_03_take_a_cloud_apart.py>` takes the cloud apart.
# :ref:`Chapter 4 <sphx_glr_chapters_plot_04_thin_and_clean.py>` has other ways of thinning. The page
# :doc:`From Open3D </open3d>` lists what each call is called there.
