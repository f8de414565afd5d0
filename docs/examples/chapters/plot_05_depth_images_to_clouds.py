"""
5. Point clouds from depth images
=================================

An RGB-D camera provides two images: the color, and the depth of each pixel. In this chapter you convert them to point
clouds. This includes depth in meters and in millimeters, the formats of Redwood, TUM, SUN3D and NYU, poses and
extrinsics, and cameras with y up or y down. A wrong convention often causes no error, so you also learn to detect
it.
"""

# %%
# Depth images
# ------------
# The example is a frame of a simulated camera trajectory through a room. The color is ``uint8`` of shape ``(h, w, 3)``.
# The depth is ``float32`` of shape ``(h, w)`` in meters, and 0 where there is no measurement. Depth is measured along
# the optical axis. It is not the distance from the camera center. A wall that is perpendicular to the optical axis has
# a constant depth.

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
# The intrinsic parameters of the camera are the focal lengths fx and fy and the principal point cx, cy, all in pixels.
# They map a pixel to a 3D point with x right, y **down** and z forward.

v, u = np.mgrid[: camera.height, : camera.width]
z = frame.depth.astype(np.float64)
by_hand = np.stack([(u - camera.cx) * z / camera.fx, (v - camera.cy) * z / camera.fy, z], axis=-1)[z > 0]

cloud = loom.PointCloud.create_from_depth_image(frame.depth, camera)
print(cloud, "- largest difference to the formula:", abs(cloud.points - by_hand).max().round(6), "m")
assert np.allclose(cloud.points, by_hand, atol=1e-5)

# %%
# A colored cloud takes two steps. ``depth_trunc`` removes distant points, whose depth is less accurate. The default is
# 3 m. Open3D's names also exist: ``RGBDImage.create_from_color_and_depth(..., convert_rgb_to_intensity=False)`` and
# ``PointCloud.create_from_rgbd_image``.

image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=6.0)
colored = loom.PointCloud.create_from_rgbd_image(image, camera)
short = loom.RGBDImage(frame.color, frame.depth)
print(f"pixels within 6 m: {(image.depth > 0).mean():.0%}, within 3 m: {(short.depth > 0).mean():.0%}")
assert len(colored) == (image.depth > 0).sum()

# %%
# The cloud from the camera pose and from the side. Surfaces that the camera did not observe are missing.

wide = loom.PinholeCameraIntrinsic(960, 640, 780.0, 780.0, 479.5, 319.5)
from_camera = loom.render(colored, loom.View(wide, np.eye(4)), point_size=4)
from_side = loom.render(
    [colored, {"geometry": loom.CameraFrustum(camera, np.eye(4), 0.5), "color": (0.1, 0.4, 0.9), "line_width": 3}],
    {"front": [0.8, -0.55, -0.75], "up": [0, -1, 0], "zoom": 0.48},
    (960, 640),
)  # fmt: skip

# %%
# Depth formats
# -------------
# Files store depth as 16-bit integers, and the unit depends on the data set. The script writes the frame in each format
# and reads it again. The first four functions return intensity images, as in Open3D, unless
# ``convert_rgb_to_intensity=False`` is given. Each function has its own default of ``depth_trunc``.
#
# .. list-table::
#    :header-rows: 1
#
#    * - data set
#      - depth of value d
#      - function
#      - ``depth_trunc``
#    * - Redwood, 7-Scenes
#      - d / 1000 m (millimeters)
#      - ``RGBDImage.create_from_redwood_format(color, depth, convert_rgb_to_intensity=False)``
#      - 4 m
#    * - TUM
#      - d / 5000 m
#      - ``create_from_tum_format(color, depth, convert_rgb_to_intensity=False)``
#      - 4 m
#    * - SUN3D
#      - millimeters, bits rotated left by three
#      - ``create_from_sun_format(color, depth, convert_rgb_to_intensity=False)``
#      - 7 m
#    * - NYU
#      - 351.3 / (1092.5 - d) m, bytes swapped
#      - ``create_from_nyu_format(color, depth, convert_rgb_to_intensity=False)``
#      - 7 m
#    * - other integers
#      - d / ``depth_scale`` m
#      - ``RGBDImage(color, depth, depth_scale=..., depth_trunc=...)``
#      - 3 m
#    * - floats
#      - meters
#      - ``RGBDImage(color, depth, depth_trunc=...)``
#      - 3 m

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
    error = abs(depth - z)[both]
    print(f"{name:8} values up to {numbers.max():5}: error at most {error.max() * 1000:6.3f} mm ({both.sum()} pixels)")
    assert both.sum() > 0.95 * ((z > 0) & (z < 3.9)).sum()
    assert error.max() < (0.03 if name == "NYU" else 0.001)

# %%
# The resolution of NYU's format decreases with the distance. At 2.8 m, one step is 22 mm.
#
# **A wrong depth scale** changes the size of the scene. TUM's values read as millimeters make the room five times too
# large, and most points exceed ``depth_trunc``. If no point remains, a warning reports the likely cause:

with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    loom.RGBDImage(frame.color, np.rint(z * 5000).astype(np.uint16), depth_scale=1.0)
print(caught[0].message)
assert issubclass(caught[0].category, loom.UnitWarning)

# %%
# Poses and extrinsics
# --------------------
# A pose is the transformation from camera to world coordinates, ``T_world_camera``. An extrinsic is the inverse
# transformation, ``T_camera_world``. ``create_from_rgbd_image`` expects the **extrinsic**, as in Open3D. Trajectory
# files (``.log``, TUM's ``.txt``, ARKit, 7-Scenes) contain **poses**.

pose = frame.T_world_camera
right = loom.PointCloud.create_from_rgbd_image(image, camera, np.linalg.inv(pose))
wrong = loom.PointCloud.create_from_rgbd_image(image, camera, pose)
print("floor at", np.quantile(right.points[:, 2], 0.005).round(2), "m; with the pose instead of the extrinsic at",
      np.quantile(wrong.points[:, 2], 0.005).round(2), "m")  # fmt: skip
assert np.allclose(right.points, colored.transform(pose).points, atol=1e-5)
assert right.points[:, 2].min() > -0.2
assert not np.allclose(right.points, wrong.points, atol=0.5)

# %%
# To find out which one a file contains, merge several frames. With the correct transformation, walls of different
# frames coincide. With the inverse, the frames are scattered. The script merges five frames with both:


def merge_frames(inverted: bool) -> loom.PointCloud:
    """Merge five frames, with the correct extrinsics or with their inverse."""
    clouds = []
    for each in frames[::5]:
        rgbd = loom.RGBDImage(each.color, each.depth, depth_trunc=6.0)
        extrinsic = each.T_world_camera if inverted else np.linalg.inv(each.T_world_camera)
        clouds.append(loom.PointCloud.create_from_rgbd_image(rgbd, camera, extrinsic, stride=2))
    return loom.PointCloud.concatenate(clouds)


joined, scattered = merge_frames(inverted=False), merge_frames(inverted=True)
above = {"front": [0.45, 0.75, 0.6], "up": [0, 0, 1], "zoom": 0.55}
correct_merge = loom.render(joined.crop(loom.AxisAlignedBoundingBox([-1, -1, -1], [6, 6, 2.4])), above, (960, 640))
wrong_merge = loom.render(scattered, above, (960, 640))

extents = [cloud.get_max_bound() - cloud.get_min_bound() for cloud in (joined, scattered)]
print("correct:", extents[0].round(1), "m; inverted:", extents[1].round(1), "m")
assert np.all(extents[0] < [5.6, 4.8, 3.0]) and np.prod(extents[1]) > 1.5 * np.prod(extents[0])

# %%
# Axis conventions
# ----------------
# As in OpenCV and Open3D, the camera has y down and looks along +z. Cameras of OpenGL, Blender, ARKit and NeRF have y
# up and look along -z. To use their poses, flip two axes of the camera. To display a camera's cloud in a viewer with y
# up, apply the same matrix to the cloud:

to_opengl = np.diag([1.0, -1.0, -1.0, 1.0])
pose_of_arkit = pose @ to_opengl  # in ARKit's convention
assert np.allclose(pose_of_arkit @ to_opengl, pose), "the matrix is its own inverse"
y_up = colored.transform(to_opengl)
assert y_up.points[:, 2].max() < 0, "all points are in front of the camera, along -z"

# %%
# Resized images
# --------------
# If an image is resized to half its size, the focal length and the principal point are halved, too. An image size that
# does not match the camera raises an error:

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
# An interactive page of the five frames with their cameras:

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
# Read files
# ----------
# ``loom.read_color`` and ``loom.read_depth`` read images without conversion, ``loom.read_trajectory`` reads poses. The
# script first writes one frame, so that the files exist:

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
# What to change
# --------------
# - ``stride``: 4 uses every fourth pixel of every fourth row, so a sixteenth of the points.
# - ``depth_trunc`` [m]: 2.0 removes the wall behind the objects.
# - The depth scale: multiply the depth by 1.1 and merge the frames. How does the error of 10% appear in the image?
#
# Next
# ----
# - :ref:`Chapter 6 <sphx_glr_chapters_plot_06_monocular_depth.py>`: depth from a single photograph.
# - :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>`: estimate the camera poses.
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: fuse frames into a mesh.
# - :doc:`RGB-D frames </frames>`: ``loom.open_frames`` reads folders of Redwood, TUM and 7-Scenes, streams and cameras.
