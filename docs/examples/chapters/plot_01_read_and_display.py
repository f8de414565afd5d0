"""
1. Read a cloud and look at it
==============================

A point cloud is a list of places in space, often with a color for each. You learn to read one from a file, to ask how
large it is and where it lies, and to look at it from wherever you like. Do this first with every file that you are
given: most mistakes show here, before anything is computed.
"""

# %%
# Get a file
# ----------
# The package makes its own data, so that you need no download: a furnished room of 5 x 4.2 x 2.6 m, as a scanner sees
# it. We write it to a file and read it again, as you would read your own. Other suffixes work the same way: ``.pcd``,
# ``.las``, ``.laz``, ``.e57``, ``.xyz``, ``.csv``, ``.npz`` and more. Three of them want packages that are not there by
# default: ``pip install "pointloom[las,e57]"``.
#
# In Open3D this is ``o3d.io.read_point_cloud``; here it is ``loom.read_point_cloud``.

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
# What is in it
# -------------
# ``cloud.points`` is a NumPy array of shape [n, 3]: one row a point, its x, y and z. ``cloud.colors`` has the same
# shape, with red, green and blue from 0 to 1. A cloud has no unit unless its file tells one; by custom it is meters.

print("first point:", cloud.points[0].round(3))
print("colors from", cloud.colors.min().round(2), "to", cloud.colors.max().round(2))
print("has normals:", cloud.has_normals(), " has colors:", cloud.has_colors())

assert cloud.points.shape == (len(cloud), 3)
assert cloud.colors.min() >= 0 and cloud.colors.max() <= 1

# %%
# How large it is
# ---------------
# The three numbers to look at first. The extent tells the unit: a room of ``[5 4.2 2.6]`` is in meters, one of
# ``[5000 4200 2600]`` in millimeters. The center tells whether the cloud lies near zero, or at coordinates of a map.
# In rooms and streets the shortest extent is mostly
# the one upwards: here z.

low, high = cloud.get_min_bound(), cloud.get_max_bound()
extent = high - low
print("extent:", extent.round(2), "m")
print("center:", ((low + high) / 2).round(2), "m")
print(f"{len(cloud) / np.prod(extent[:2]):.0f} points a square metre of floor")

assert np.allclose(extent, [5.0, 4.2, 2.6], atol=0.25)

# %%
# Look at it
# ----------
# ``loom.render`` makes an image without a window or a display. A closed room shows its outside, so we leave out what
# would hide the inside: the ceiling and the two walls on our side. A box in space says what stays.
#
# ``front`` is the direction from the middle of the cloud to the eye, ``up`` is what points upwards in the image,
# and a smaller ``zoom`` is nearer. They are Open3D's parameters of ``draw_geometries``.

inside = cloud.crop(loom.AxisAlignedBoundingBox([-0.1, 0.06, -0.1], [4.92, 4.3, 2.5]))
above = {"front": [0.55, -0.75, 0.62], "up": [0, 0, 1], "zoom": 0.6}
image = loom.render(inside, above, (960, 640))

# %%
# Stand in the room
# -----------------
# A ``View`` is a camera and the place where it stands. This one is a camera of the walk that scanned the room.

frame = loom.datasets.room_frames(24)[0]
eye = loom.View(loom.PinholeCameraIntrinsic(960, 640, 620.0, 620.0, 479.5, 319.5), frame.T_world_camera)
from_within = loom.render(cloud, eye)

# %%
# Color by what you ask
# ----------------------
# Colors need not be those of the camera. By height one sees at once what is floor and what stands on it; the bar on
# the image tells the meters.

by_height = loom.render(
    {"geometry": inside, "color_by": "height", "colormap": "turbo"}, above, (960, 640), color_bar=True
)
loom.write_image(folder / "by_height.png", by_height)

# %%
# Turn it yourself
# ----------------
# On your own machine ``loom.draw(cloud)`` opens the cloud in the browser, where you turn it with the mouse. A page that
# works without a server is made by a recording of one step: send the file to anybody. Here it is:

with loom.record(folder / "room.html", automatic=False, max_points=60_000, title="The room") as recording:
    recording.add("room", inside)
    recording.step("turn me")
page = folder / "room.html"

# %%
# What goes wrong
# ---------------
# **A typing error in the path.** It is an error at once, and not an empty cloud:

try:
    loom.read_point_cloud(folder / "rooms.ply")
except loom.FileError as error:
    message = str(error)
    print(message.replace(str(folder), "..."))
assert "rooms.ply" in message

# %%
# **The wrong unit.** Many scanners write millimeters. Nothing looks wrong in an image, since the view fits itself; the
# extent tells it. Every later number (a voxel of 0.05, a radius of 0.1) would be a thousand times too small.

in_millimeters = cloud.scale(1000.0, center=[0, 0, 0])
print(
    "extent:", (in_millimeters.get_max_bound() - in_millimeters.get_min_bound()).round(0), "- of a room? Millimeters."
)

in_millimeters.unit = "millimetre"  # says what the numbers are, and changes none
meters = in_millimeters.to_unit("metre")
assert np.allclose(meters.points, cloud.points, atol=1e-4)

# %%
# **Upside down.** Cameras count y downwards and z away from themselves. A cloud that comes straight from a depth camera
# therefore hangs upside down in a viewer that takes y for up. It is turned about x by half a turn:

flip = np.diag([1.0, -1.0, -1.0, 1.0])
from_camera = loom.PointCloud.create_from_depth_image(frame.depth, frame.intrinsic)
upright = from_camera.transform(flip)
print("y of the floor before:", from_camera.points[:, 1].max().round(2), " after:", upright.points[:, 1].min().round(2))
assert np.isclose(upright.points[:, 1].min(), -from_camera.points[:, 1].max())

# %%
# **A change that is lost.** Operations give a new cloud and leave the old one alone: write ``cloud =
# cloud.scale(0.001)``. In Open3D ``transform``, ``scale`` and ``estimate_normals`` change the cloud in place. Whoever
# drops a result is warned.
#
# **Holes.** Depth cameras and scanners of a fixed raster write "nothing measured" as NaN, not a number. The bounds pass
# over such points, but means of your own and some calls do not. Take them out first:

points = cloud.points.copy()
points[:5] = np.nan
holed = loom.PointCloud(points)
finite = holed.remove_non_finite_points()
print("mean with holes:", holed.points.mean(axis=0), " without:", finite.points.mean(axis=0).round(2))
assert len(finite) == len(cloud) - 5

# %%
# Try it
# ------
# - Read a file of your own and print its extent before anything else. Which unit is it in?
# - Give ``"color_by": "normal"``. What do walls, floor and ceiling have in common?
# - Take ``frame`` 12 of the walk in place of 0.
#
# Where to go next
# ----------------
# :ref:`Chapter 2 <sphx_glr_chapters_plot_02_voxels_and_normals.py>` makes the cloud smaller and finds which way its
# surfaces look. The page :doc:`Images </pictures>` has all of ``loom.render``, the page :doc:`The viewer </viewer>`
# all of ``loom.draw``, :doc:`Units of length </files>` what a file tells of its unit.
