"""
1. Read a point cloud and display it
====================================

A point cloud is a set of 3D points, often with a color for each point. In this chapter you read a point cloud from a
file, measure its extent and position, and render it from any viewpoint. Do this first with every new file. Most
mistakes are visible here, before anything is computed.
"""

# %%
# Create a file
# -------------
# pointloom generates synthetic data, so no download is needed. The example is a furnished room of 5 x 4.2 x 2.6 m, as
# measured by a scanner. The script writes it to a file and reads it again. Other suffixes work the same way: ``.pcd``,
# ``.las``, ``.laz``, ``.e57``, ``.xyz``, ``.csv``, ``.npz`` and more. LAS, LAZ and E57 require optional packages: ``pip
# install "pointloom[las,e57]"``.
#
# The function has the name of Open3D's: ``o3d.io.read_point_cloud`` becomes ``loom.read_point_cloud``.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
path = folder / "room.ply"
loom.write_point_cloud(path, loom.datasets.room_cloud(voxel_size=0.02))

cloud = loom.read_point_cloud(path)
print(cloud)

# %%
# Inspect the data
# ----------------
# ``cloud.points`` is a NumPy array of shape ``(n, 3)`` with x, y and z of each point. ``cloud.colors`` has the same
# shape and contains red, green and blue from 0 to 1. A cloud has no unit unless its file defines one. The usual unit is
# meters.

print("first point:", cloud.points[0].round(3))
print("colors from", cloud.colors.min().round(2), "to", cloud.colors.max().round(2))
print("has normals:", cloud.has_normals(), " has colors:", cloud.has_colors())

assert cloud.points.shape == (len(cloud), 3)
assert cloud.colors.min() >= 0 and cloud.colors.max() <= 1

# %%
# Measure the extent
# ------------------
# The extent shows the unit: a room of ``[5 4.2 2.6]`` is in meters, a room of ``[5000 4200 2600]`` in millimeters. The
# center shows whether the coordinates are local or those of a map projection. In rooms and streets, the shortest extent
# is usually vertical. Here it is z.

low, high = cloud.get_min_bound(), cloud.get_max_bound()
extent = high - low
print("extent:", extent.round(2), "m")
print("center:", ((low + high) / 2).round(2), "m")
print(f"{len(cloud) / np.prod(extent[:2]):.0f} points per square meter of floor")

assert np.allclose(extent, [5.0, 4.2, 2.6], atol=0.25)

# %%
# Render an image
# ---------------
# ``loom.render`` creates an image without a window or a display. From outside, the ceiling and two walls hide the
# interior of the room. The script removes them with a bounding box.
#
# ``front`` is the direction from the center of the cloud to the camera. ``up`` is the vertical direction of the image.
# A smaller ``zoom`` moves the camera closer. These are the parameters of Open3D's ``draw_geometries``.

inside = cloud.crop(loom.AxisAlignedBoundingBox([-0.1, 0.06, -0.1], [4.92, 4.3, 2.5]))
above = {"front": [0.55, -0.75, 0.62], "up": [0, 0, 1], "zoom": 0.6}
image = loom.render(inside, above, (960, 640))

# %%
# Use a camera
# ------------
# A ``View`` combines a pinhole camera and its pose. This one uses a pose from the trajectory of the simulated scan.

frame = loom.datasets.room_frames(24)[0]
camera_view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 620.0, 620.0, 479.5, 319.5), frame.T_world_camera)
interior = loom.render(cloud, camera_view)

# %%
# Color by an attribute
# ---------------------
# Points can be colored by an attribute instead of their own color. Height separates the floor from the objects on it.
# The color bar shows the scale in meters.

by_height = loom.render(
    {"geometry": inside, "color_by": "height", "colormap": "turbo"}, above, (960, 640), color_bar=True
)
loom.write_image(folder / "by_height.png", by_height)

# %%
# Rotate it interactively
# -----------------------
# ``loom.draw(cloud)`` opens the cloud in the browser, where the mouse rotates it. ``loom.record`` writes a single HTML
# page that works without a server and can be sent to others. This is the page of this script:

with loom.record(folder / "room.html", automatic=False, max_points=60_000, title="The room") as recording:
    recording.add("room", inside)
    recording.step("drag to rotate")
page = folder / "room.html"

# %%
# Common mistakes
# ---------------
# **A wrong path** raises an error immediately. The result is never an empty cloud:

try:
    loom.read_point_cloud(folder / "rooms.ply")
except loom.FileError as error:
    message = str(error)
    print(message.replace(str(folder), "..."))
assert "rooms.ply" in message

# %%
# **The wrong unit.** Many scanners write millimeters. An image looks the same, since the camera adapts to the extent.
# Only the extent shows the unit. In millimeters, a voxel of 0.05 or a radius of 0.1 would be 1,000 times too small.

in_millimeters = cloud.scale(1000.0, center=[0, 0, 0])
print("extent:", (in_millimeters.get_max_bound() - in_millimeters.get_min_bound()).round(0), "- a room in millimeters")

in_millimeters.unit = "millimetre"  # declares the unit, does not change the coordinates
meters = in_millimeters.to_unit("metre")
assert np.allclose(meters.points, cloud.points, atol=1e-4)

# %%
# **The wrong orientation.** In camera coordinates, y points down and z points away from the camera. A cloud from a
# depth image is therefore upside down in a viewer that uses y as up. Rotate it by 180 degrees about x:

flip = np.diag([1.0, -1.0, -1.0, 1.0])
from_camera = loom.PointCloud.create_from_depth_image(frame.depth, frame.intrinsic)
y_up = from_camera.transform(flip)
print("y of the floor before:", from_camera.points[:, 1].max().round(2), " after:", y_up.points[:, 1].min().round(2))
assert np.isclose(y_up.points[:, 1].min(), -from_camera.points[:, 1].max())

# %%
# **A discarded result.** Operations return a new cloud and do not modify their input. Write ``cloud =
# cloud.scale(0.001)``. In Open3D, ``transform``, ``scale`` and ``estimate_normals`` modify the cloud in place.
# pointloom emits a warning if a result is discarded.
#
# **Missing measurements.** Organized scans and depth cameras store missing measurements as NaN. The bounds ignore these
# points, but other computations may not. Remove them first:

points = cloud.points.copy()
points[:5] = np.nan
with_nan = loom.PointCloud(points)
finite = with_nan.remove_non_finite_points()
print("mean with NaN:", with_nan.points.mean(axis=0), " without:", finite.points.mean(axis=0).round(2))
assert len(finite) == len(cloud) - 5

# %%
# What to change
# --------------
# - ``voxel_size`` of ``room_cloud`` [m]: 0.05 instead of 0.02 leaves fewer points and less detail.
# - ``zoom``: 0.3 moves the camera closer, 1.2 farther away.
# - ``"color_by"``: ``"normal"`` colors walls, floor and ceiling by their orientation.
# - The file: read one of your own files, print its extent first, and determine its unit.
#
# Next
# ----
# - :ref:`Chapter 2 <sphx_glr_chapters_plot_02_voxels_and_normals.py>`: downsample the cloud and estimate normals.
# - :doc:`Rendering images and plots </pictures>`: all parameters of ``loom.render``.
# - :doc:`The viewer </viewer>`: all parameters of ``loom.draw``.
# - :doc:`File formats and units </files>`: which formats store a unit.
