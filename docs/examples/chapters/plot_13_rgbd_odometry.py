"""
13. Follow a depth camera
=========================

How did the camera move from one image to the next? RGB-D odometry answers from the two images themselves, by
brightness and shape together. You learn its two kinds, how to chain steps into a path, how errors add up, and to
measure them.
"""

# %%
# Two images
# ------------
# Frames of a hand-held camera 3 degrees and 5 cm apart, as they come at some ten a second. Open3D wants them as
# intensity, its default in ``create_from_color_and_depth``; here colors will do.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

odometry = loom.rgbd
frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
images = [loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0) for frame in frames]


def off(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """How far a pose is from the true one: degrees and millimeters."""
    rest = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(rest[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 1000 * float(np.linalg.norm(rest[:3, 3]))


def true_step(source: int, target: int) -> np.ndarray:
    """T_target_source, which the data knows."""
    return np.linalg.inv(frames[target].T_world_camera) @ frames[source].T_world_camera


print("the camera moved {:.1f} degrees and {:.0f} mm".format(*off(np.eye(4), true_step(1, 0))))

# %%
# Brightness alone, or with shape
# -------------------------------
# Both ask: if the source's pixels are moved to the target by this pose, are they as bright as what they meet there?
# The **color term** asks that alone. The **hybrid term** also asks whether they lie on the target's surface. Hybrid
# is the one to take; color alone where depth is noisy.
#
# In Open3D this is ``o3d.pipelines.odometry.compute_rgbd_odometry(source, target, intrinsic, odo_init, jacobian,
# option)``. Here it is ``loom.rgbd.compute_rgbd_odometry``, with ``method=`` for the term. It returns success, the pose
# T_target_source, and an information matrix, by which a pose graph weighs the step.

for method in ("intensity", "hybrid"):
    success, T, information = odometry.compute_rgbd_odometry(images[1], images[0], camera, method=method)
    print(f"{method}: success {success}, off by {off(T, true_step(1, 0))[0]:.2f} degrees,"
          f" {off(T, true_step(1, 0))[1]:.1f} mm")  # fmt: skip
    assert success and off(T, true_step(1, 0))[0] < 0.5 and off(T, true_step(1, 0))[1] < 20

# %%
# When it does not work it says so
# --------------------------------
# A step that is too far is refused, with the reason. Do not chain a failed step as if the camera had stood still,
# which is what an identity means.

far = odometry.compute_rgbd_odometry(images[23], images[0], camera)
print(far.reliable, "-", far.warnings)
assert not far.reliable or off(far.transformation, true_step(23, 0))[0] < 2

covered = loom.RGBDImage(np.zeros_like(frames[0].color), np.zeros_like(frames[0].depth))
blank = odometry.compute_rgbd_odometry(covered, images[0], camera)
print(blank.reliable, "-", blank.warnings)
assert not blank.reliable

# %%
# A path
# ------
# Steps are chained: the pose of frame k is that of frame k - 1 times the step. ``OdometryFrame`` prepares an image
# once for both steps that it takes part in, and ``align_frames`` does what ``compute_rgbd_odometry`` does. The depth of
# these frames is in meters. That of a dataset is in whole numbers, whose unit is to be told:
#
# .. code-block:: python
#
#    source = loom.open_frames("desk", depth_scale=5000)  # loose images of TUM
#    prepared = [odometry.OdometryFrame(f.depth, source.intrinsic, f.color, depth_scale=source.depth_scale)
#                for f in source]

prepared = [odometry.OdometryFrame(frame.depth, camera, frame.color) for frame in frames]
poses = [frames[0].T_world_camera]
for k in range(1, len(frames)):
    step = odometry.align_frames(prepared[k], prepared[k - 1])
    if not step.reliable:
        raise SystemExit(f"frame {k}: {step.warnings}")
    poses.append(poses[-1] @ step.transformation)

path, truth = loom.Trajectory(np.stack(poses)), loom.Trajectory(np.stack([frame.T_world_camera for frame in frames]))
print(path)

# %%
# How good is the path?
# ---------------------
# **Relative error** (RPE): of each step, what a step costs. **Absolute error** (ATE): how far positions of the whole
# path are off the true ones. Steps err a little each, and all later poses inherit it: that is **drift**. It cannot be
# mended frame by frame; coming back to a known place can (chapter 15).

errors = loom.registration.evaluate_trajectory(path, truth, align=False)
print(errors)
end = off(path.poses[-1], truth.poses[-1])
length = float(np.linalg.norm(np.diff(truth.poses[:, :3, 3], axis=0), axis=1).sum())
print(f"after {length:.2f} m and {len(frames) - 1} steps: {end[0]:.2f} degrees and {end[1]:.0f} mm off")
assert end[0] < 2 and end[1] < 0.05 * 1000 * length

# %%
# The path on the room, true in green, found in red: they lie on each other at this scale, so the cameras' pyramids
# are drawn at every sixth frame.


def cloud_of(k: int, pose: np.ndarray) -> loom.PointCloud:
    """A frame as points in the world."""
    return loom.PointCloud.create_from_rgbd_image(images[k], camera, np.linalg.inv(pose), stride=2)


room = loom.PointCloud.concatenate([cloud_of(k, path.poses[k]) for k in range(0, 24, 4)])
room = room.select_by_mask((room.points[:, 2] < 2.45) & (room.points[:, 1] < 3.7)).voxel_down_sample(0.02)
GREEN, RED = (0.1, 0.65, 0.2), (0.9, 0.15, 0.1)
drawn = {
    "room": room,
    "true": {"geometry": truth, "color": GREEN, "line_width": 4},
    "found": {"geometry": path, "color": RED, "line_width": 4},
}
cameras = {
    f"camera {k}": {"geometry": loom.CameraFrustum(camera, path.poses[k], 0.25), "color": RED, "line_width": 2}
    for k in range(0, 24, 6)
}
on_room = loom.render(
    drawn | cameras, {"front": [0.75, 0.62, 0.6], "up": [0, 0, 1], "zoom": 0.5}, (960, 640),
    legend=[("true", GREEN), ("found", RED)],
)  # fmt: skip

# %%
# What noise and speed do
# -----------------------
# Every frame, every fourth, every eighth: fewer steps drift less as long as each still succeeds. Large steps fail
# first.

for every in (1, 4, 8):
    T, failed = frames[0].T_world_camera, ""
    for k in range(every, len(frames), every):
        step = odometry.align_frames(prepared[k], prepared[k - every])
        failed = failed or ("" if step.reliable else f"from frame {k - every} to {k} {step.warnings}")
        T = T @ step.transformation
    last = (len(frames) - 1) // every * every
    angle, distance = off(T, truth.poses[last])
    print(f"every {every} frames:", failed or f"at frame {last} {angle:.2f} degrees and {distance:.1f} mm off")
    assert failed or distance < 50, "reliable results are correct"

# %%
# The path as it grows:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(
    folder / "path.html", automatic=False, max_points=60_000, title="Odometry, frame by frame"
) as recording:
    recording.add("true", truth, color=GREEN)
    for k in range(0, 24, 2):
        part = cloud_of(k, path.poses[k])
        recording.add(f"frame {k}", part.select_by_mask(part.points[:, 2] < 2.4).voxel_down_sample(0.05))
        recording.add(f"camera {k}", loom.CameraFrustum(camera, path.poses[k], 0.2), color=RED)
        recording.plot("off the truth [mm]", off(path.poses[k], truth.poses[k])[1])
        recording.step(f"frame {k}")
page = folder / "path.html"

# %%
# Keep the path
# -------------
# Files of trajectories differ in what a line is; the suffix decides: ``.tum`` (time and quaternion), ``.log``
# (Redwood's matrices), ``.kitti`` (3 x 4).

loom.write_trajectory(folder / "path.log", path)
assert np.allclose(loom.read_trajectory(folder / "path.log").poses, path.poses, atol=1e-6)

# %%
# What goes wrong
# ---------------
# **The unit of depth.** TUM's depth is in fifths of a millimetre: without ``depth_scale=5000`` the path is five times
# too long, and nothing says so.
#
# **The camera of another image size.** It is an error, as in chapter 5. **A focal length that is off** by a tenth
# is not: every step then succeeds, the path is bent, and ``inlier_rmse`` hardly moves: in a
# real kitchen from 4.8 to 5.1 mm, here by half at most. ``loom.rgbd.check_focal`` tells, where the camera turned
# enough:

long_lens = loom.PinholeCameraIntrinsic(
    camera.width, camera.height, 1.1 * camera.fx, 1.1 * camera.fy, camera.cx, camera.cy
)
step = odometry.align_frames(*(odometry.OdometryFrame(frames[k].depth, long_lens, frames[k].color) for k in (1, 0)))
right = odometry.align_frames(prepared[1], prepared[0])
print(f"inlier_rmse {1000 * right.inlier_rmse:.1f} mm, with the wrong lens {1000 * step.inlier_rmse:.1f} mm")
assert step.reliable and step.inlier_rmse < 2 * right.inlier_rmse

check = loom.rgbd.check_focal(loom.frames_from([(frame.color, frame.depth) for frame in frames], long_lens))
print(check)
assert check is not None and not check.reliable

# %%
# **The wrong direction**: T_target_source takes the source into the target. If the path runs backwards,
# source and target are swapped.
#
# Try it
# ------
# - Call ``pointloom.open3d.pipelines.odometry.compute_rgbd_odometry`` for Open3D's numbers. Is it as accurate?
# - Darken every second image by half. Which of the two terms minds?
#
# Where to go next
# ----------------
# :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>` holds each frame against a model of all before it,
# which drifts far less. The page :doc:`RGB-D odometry </slam>` lists the checks of its reliability.
# :doc:`SLAM </slam>` describes loop closure.
