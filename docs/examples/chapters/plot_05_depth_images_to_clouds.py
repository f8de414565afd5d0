"""
5. Depth images to clouds
===========================

A depth camera gives two images: colors, and for each pixel how far away it is. You learn to make a cloud of them in
every convention that you will meet: meters and millimeters, the formats of Redwood, TUM, SUN3D and NYU, poses as camera
to world or as extrinsics, y up or y down. Each of them goes wrong without an error if it is taken for another.
"""

# %%
# What a depth image is
# -----------------------
# A frame of the package's own walk through a room: colors as ``uint8`` [h, w, 3], depth as ``float32`` [h, w] in
# meters, 0 where nothing was measured. Depth is not the distance from the camera: it is measured along the optical
# axis, so a wall that the camera faces has one depth all over.

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

frames = loom.datasets.room_frames(24)
frame = frames[20]
camera = frame.intrinsic
print(camera)
print("depth from", frame.depth[frame.depth > 0].min().round(2), "to", frame.depth.max().round(2), "m")
print(f"{(frame.depth == 0).mean():.1%} of the pixels have no depth")

# %%
# The camera is four numbers: the focal lengths fx and fy, and where the optical axis meets the image, cx and cy,
# all in pixels. With them a pixel becomes a point: x right, y **down**, z away from the camera.

v, u = np.mgrid[: camera.height, : camera.width]
z = frame.depth.astype(np.float64)
by_hand = np.stack([(u - camera.cx) * z / camera.fx, (v - camera.cy) * z / camera.fy, z], axis=-1)[z > 0]

cloud = loom.PointCloud.create_from_depth_image(frame.depth, camera)
print(cloud, "- the greatest difference to the formula:", abs(cloud.points - by_hand).max().round(6), "m")
assert np.allclose(cloud.points, by_hand, atol=1e-5)

# %%
# With colors it takes two steps. ``depth_trunc`` drops what is farther, as cheap cameras see badly far away; mind
# that it is 3 m unless you say otherwise. Open3D: ``RGBDImage.create_from_color_and_depth(...,
# convert_rgb_to_intensity=False)``, then ``PointCloud.create_from_rgbd_image``; those names work here too.

image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=6.0)
colored = loom.PointCloud.create_from_rgbd_image(image, camera)
short = loom.RGBDImage(frame.color, frame.depth)
print(f"kept within 6 m: {(image.depth > 0).mean():.0%} of the pixels, within 3 m: {(short.depth > 0).mean():.0%}")
assert len(colored) == (image.depth > 0).sum()

# %%
# Seen as the camera saw it, and from beside. What the camera could not see is empty: a depth image is a relief.

wide = loom.PinholeCameraIntrinsic(960, 640, 780.0, 780.0, 479.5, 319.5)
as_seen = loom.render(colored, loom.View(wide, np.eye(4)), point_size=4)
from_beside = loom.render(
    [colored, {"geometry": loom.CameraFrustum(camera, np.eye(4), 0.5), "color": (0.1, 0.4, 0.9), "line_width": 3}],
    {"front": [0.8, -0.55, -0.75], "up": [0, -1, 0], "zoom": 0.48},
    (960, 640),
)  # fmt: skip

# %%
# Which numbers a file holds
# --------------------------
# Files hold whole numbers of 16 bits, and each data set has its own idea of what 1 means. We write our frame in each
# format, as its camera would, and read it back. All but the last two calls give gray clouds, as Open3D's do, unless
# ``convert_rgb_to_intensity=False`` says that colors stay. Each drops what is farther than its own ``depth_trunc``.
#
# .. list-table::
#    :header-rows: 1
#
#    * - data set
#      - what a number d means
#      - call
#      - drops beyond
#    * - Redwood, 7-Scenes
#      - d / 1000 m (millimeters)
#      - ``RGBDImage.create_from_redwood_format(color, depth, convert_rgb_to_intensity=False)``
#      - 4 m
#    * - TUM
#      - d / 5000 m
#      - ``create_from_tum_format(color, depth, convert_rgb_to_intensity=False)``
#      - 4 m
#    * - SUN3D
#      - millimeters, the bits turned left by three
#      - ``create_from_sun_format(color, depth, convert_rgb_to_intensity=False)``
#      - 7 m
#    * - NYU
#      - 351.3 / (1092.5 - d) m, the bytes swapped
#      - ``create_from_nyu_format(color, depth, convert_rgb_to_intensity=False)``
#      - 7 m
#    * - your own
#      - d / ``depth_scale`` m
#      - ``RGBDImage(color, depth, depth_scale=..., depth_trunc=...)``
#      - 3 m, or yours
#    * - floats
#      - meters
#      - ``RGBDImage(color, depth, depth_trunc=...)``
#      - 3 m, or yours

millimeters = np.rint(z * 1000).astype(np.uint16)
with np.errstate(divide="ignore"):
    nyu = np.where(z > 0, np.rint(1092.5 - 351.3 / z), 0).clip(0, 65535).astype(np.uint16)
files = {
    "Redwood": (loom.RGBDImage.create_from_redwood_format, millimeters),
    "TUM": (loom.RGBDImage.create_from_tum_format, np.rint(z * 5000).astype(np.uint16)),
    "SUN3D": (loom.RGBDImage.create_from_sun_format, (millimeters << 3) | (millimeters >> 13)),
    "NYU": (loom.RGBDImage.create_from_nyu_format, nyu.byteswap()),
}
for name, (read, numbers) in files.items():
    depth = read(frame.color, numbers, convert_rgb_to_intensity=False).depth
    both = (depth > 0) & (z > 0) & (z < 3.9)
    off = abs(depth - z)[both]
    print(f"{name:8} numbers up to {numbers.max():5}: off by at most {off.max() * 1000:6.3f} mm ({both.sum()} pixels)")
    assert both.sum() > 0.95 * ((z > 0) & (z < 3.9)).sum()
    assert off.max() < (0.03 if name == "NYU" else 0.001)

# %%
# NYU's numbers are coarse far away: one step is 22 mm at 2.8 m. No reading makes that finer.
#
# **The wrong scale** gives a room of the wrong size. TUM's numbers taken for millimeters make it five times too large;
# most of it then lies beyond ``depth_trunc``. Where nothing at all is left, there is a warning with the likely cause:

with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    loom.RGBDImage(frame.color, np.rint(z * 5000).astype(np.uint16), depth_scale=1.0)
print(caught[0].message)
assert issubclass(caught[0].category, loom.UnitWarning)

# %%
# Where was the camera? Poses and extrinsics
# ------------------------------------------
# A pose says where the camera stands: ``T_world_camera`` takes the camera's coordinates to the world's. An extrinsic
# says where the world is, seen from the camera: ``T_camera_world``. Each is the inverse of the other, and files hold
# now this, now that. ``create_from_rgbd_image`` takes the **extrinsic**, as in Open3D. Trajectories (``.log``, TUM's
# ``.txt``, ARKit, 7-Scenes) hold **poses**.

pose = frame.T_world_camera
right = loom.PointCloud.create_from_rgbd_image(image, camera, np.linalg.inv(pose))
wrong = loom.PointCloud.create_from_rgbd_image(image, camera, pose)
print("floor at", np.quantile(right.points[:, 2], 0.005).round(2), "m; with the wrong one at",
      np.quantile(wrong.points[:, 2], 0.005).round(2), "m")  # fmt: skip
assert np.allclose(right.points, colored.transform(pose).points, atol=1e-5)
assert right.points[:, 2].min() > -0.2
assert not np.allclose(right.points, wrong.points, atol=0.5)

# %%
# How to find out which one you have: put several frames together. With the right one walls fall onto each other; with
# the wrong one the scene is torn into fans. Five frames, right and wrong:


def together(inverted: bool) -> loom.PointCloud:
    """Five frames in one cloud, with their poses or, wrongly, with the inverse."""
    clouds = []
    for each in frames[::5]:
        rgbd = loom.RGBDImage(each.color, each.depth, depth_trunc=6.0)
        extrinsic = each.T_world_camera if inverted else np.linalg.inv(each.T_world_camera)
        clouds.append(loom.PointCloud.create_from_rgbd_image(rgbd, camera, extrinsic, stride=2))
    return loom.PointCloud.concatenate(clouds)


joined, torn = together(inverted=False), together(inverted=True)
above = {"front": [0.45, 0.75, 0.6], "up": [0, 0, 1], "zoom": 0.55}
good = loom.render(joined.crop(loom.AxisAlignedBoundingBox([-1, -1, -1], [6, 6, 2.4])), above, (960, 640))
bad = loom.render(torn, above, (960, 640))

extents = [cloud.get_max_bound() - cloud.get_min_bound() for cloud in (joined, torn)]
print("together:", extents[0].round(1), "m; torn:", extents[1].round(1), "m")
assert np.all(extents[0] < [5.6, 4.8, 3.0]) and np.prod(extents[1]) > 1.5 * np.prod(extents[0])

# %%
# Which way is up?
# ----------------
# Cameras here count y downwards and look along +z, as OpenCV's and Open3D's do. Those of OpenGL, Blender, ARKit and
# NeRF count y upwards and look along -z. To use their poses, turn two axes of the camera; to show a camera's cloud in
# a viewer with y up, turn the cloud:

to_opengl = np.diag([1.0, -1.0, -1.0, 1.0])
pose_of_arkit = pose @ to_opengl  # as ARKit would write it
assert np.allclose(pose_of_arkit @ to_opengl, pose), "the same matrix turns it back"
upright = colored.transform(to_opengl)
assert upright.points[:, 2].max() < 0, "everything lies before the camera, along -z"

# %%
# A smaller image is another camera
# -----------------------------------
# Halve an image and its focal length is half, too. The camera of the whole image would make a room that is
# squeezed to a quarter; sizes that disagree are an error:

half = frame.depth[::2, ::2]
try:
    loom.PointCloud.create_from_depth_image(half, camera)
except ValueError as error:
    message = str(error)
    print(message)
assert "160" in message

small = loom.PinholeCameraIntrinsic(160, 120, camera.fx / 2, camera.fy / 2, camera.cx / 2, camera.cy / 2)
same = loom.PointCloud.create_from_depth_image(half, small)
assert np.allclose(same.get_max_bound(), cloud.get_max_bound(), atol=0.1)

# %%
# The five frames to turn, each camera with its pyramid:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "frames.html", automatic=False, max_points=60_000, title="Frames and cameras") as recording:
    for k, each in enumerate(frames[::5]):
        rgbd = loom.RGBDImage(each.color, each.depth, depth_trunc=6.0)
        part = loom.PointCloud.create_from_rgbd_image(rgbd, camera, np.linalg.inv(each.T_world_camera), stride=2)
        recording.add(f"frame {k}", part.select_by_mask(part.points[:, 2] < 2.4))
        recording.add(f"camera {k}", loom.CameraFrustum(camera, each.T_world_camera, 0.3), color=(0.1, 0.4, 0.9))
        recording.step(f"{k + 1} frames")
page = folder / "frames.html"

# %%
# From your own files
# -------------------
# ``loom.read_color`` and ``loom.read_depth`` read images as they are stored, ``loom.read_trajectory`` poses. Here a
# frame is written as a camera would, so that there is something to read:

loom.write_image(folder / "color.png", frame.color)
loom.write_image(folder / "depth.png", millimeters)
loom.write_trajectory(folder / "trajectory.log", loom.Trajectory(pose[None]))

poses = loom.read_trajectory(folder / "trajectory.log").poses
color, depth = loom.read_color(folder / "color.png"), loom.read_depth(folder / "depth.png")
read = loom.RGBDImage(color, depth, depth_scale=1000, depth_trunc=6.0)
world = loom.PointCloud.create_from_rgbd_image(read, camera, np.linalg.inv(poses[0]))
print(f"poses {poses.shape}, color {color.shape} {color.dtype}, depth {depth.shape} {depth.dtype}; {world}")
assert np.allclose(world.points, right.points, atol=1e-3)

# %%
# Try it
# ------
# - Give ``stride=4``: every fourth pixel of every fourth row.
# - Multiply the depth by 1.1 and put frames together. How do you see that the scale is off by a tenth?
# - ``loom.open_frames("your/folder")`` reads folders of Redwood, TUM and 7-Scenes without any of this.
#
# Where to go next
# ----------------
# :ref:`Chapter 6 <sphx_glr_chapters_plot_06_depth_of_one_photograph.py>` gets depth from a plain photograph,
# :ref:`chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>` finds poses,
# :ref:`chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>` fuses frames. The page :doc:`Frames in </frames>`
# has folders, streams and cameras.
