"""
13. RGB-D odometry
==================

RGB-D odometry estimates the motion of a depth camera between two frames, from color and depth. In this chapter you
estimate single motions with two methods, chain them to a trajectory, and measure how errors accumulate.
"""

# %%
# Two frames
# ----------
# Consecutive frames of a simulated handheld camera at about 10 frames per second differ by 3 degrees and 5 cm. Open3D
# requires intensity images, the default of ``create_from_color_and_depth``. Here color images can be used.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

odometry = loom.rgbd
frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
images = [loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0) for frame in frames]


def pose_error(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Error of a pose: rotation [degrees] and translation [mm]."""
    residual = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(residual[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 1000 * float(np.linalg.norm(residual[:3, 3]))


def true_step(source: int, target: int) -> np.ndarray:
    """The true T_target_source."""
    return np.linalg.inv(frames[target].T_world_camera) @ frames[source].T_world_camera


print("the camera moved {:.1f} degrees and {:.0f} mm".format(*pose_error(np.eye(4), true_step(1, 0))))

# %%
# Two methods
# -----------
# Both methods minimize the difference in intensity between source pixels and the target pixels onto which they are
# projected. The **intensity** method uses this term only. The **hybrid** method adds a geometric term, the distance
# from the surface of the target. Use hybrid by default, and intensity if the depth is very noisy.
#
# Open3D's function is ``o3d.pipelines.odometry.compute_rgbd_odometry(source, target, intrinsic, odo_init, jacobian,
# option)``. Here it is ``loom.rgbd.compute_rgbd_odometry`` with the parameter ``method``. It returns success, the pose
# ``T_target_source``, and an information matrix, the weight of the motion in a pose graph.

for method in ("intensity", "hybrid"):
    success, T, information = odometry.compute_rgbd_odometry(images[1], images[0], camera, method=method)
    print(f"{method}: success {success}, error {pose_error(T, true_step(1, 0))[0]:.2f} degrees,"
          f" {pose_error(T, true_step(1, 0))[1]:.1f} mm")  # fmt: skip
    assert success and pose_error(T, true_step(1, 0))[0] < 0.5 and pose_error(T, true_step(1, 0))[1] < 20

# %%
# Unreliable results
# ------------------
# If the motion is too large, the result is marked as unreliable, with the reason. Do not add such a result to a
# trajectory, not even as an identity matrix. That would assume that the camera did not move.

far = odometry.compute_rgbd_odometry(images[23], images[0], camera)
print(far.reliable, "-", far.warnings)
assert not far.reliable or pose_error(far.transformation, true_step(23, 0))[0] < 2

covered = loom.RGBDImage(np.zeros_like(frames[0].color), np.zeros_like(frames[0].depth))
blank = odometry.compute_rgbd_odometry(covered, images[0], camera)
print(blank.reliable, "-", blank.warnings)
assert not blank.reliable

# %%
# A trajectory
# ------------
# The pose of frame k is the pose of frame k - 1 times the relative motion. ``OdometryFrame`` preprocesses an image once
# for both of its pairs. ``align_frames`` is the same algorithm as ``compute_rgbd_odometry``. The depth of these frames
# is in meters. Data sets store integers, and their scale must be given:
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
# Evaluate the trajectory
# -----------------------
# The **relative pose error** (RPE) is the error of each motion. The **absolute trajectory error** (ATE) is the error of
# the positions. Each motion has a small error that affects all later poses. This accumulated error is called **drift**.
# It cannot be corrected from consecutive frames, but from a loop closure (chapter 15).

errors = loom.registration.evaluate_trajectory(path, truth, align=False)
print(errors)
end = pose_error(path.poses[-1], truth.poses[-1])
length = float(np.linalg.norm(np.diff(truth.poses[:, :3, 3], axis=0), axis=1).sum())
print(f"after {length:.2f} m and {len(frames) - 1} steps: error {end[0]:.2f} degrees and {end[1]:.0f} mm")
assert end[0] < 2 and end[1] < 0.05 * 1000 * length

# %%
# The trajectory in the room, with the ground truth in green and the estimate in red. At this scale they coincide.
# Camera pyramids are displayed for every sixth frame.


def cloud_of(k: int, pose: np.ndarray) -> loom.PointCloud:
    """A frame as points in world coordinates."""
    return loom.PointCloud.create_from_rgbd_image(images[k], camera, np.linalg.inv(pose), stride=2)


room = loom.PointCloud.concatenate([cloud_of(k, path.poses[k]) for k in range(0, 24, 4)])
room = room.select_by_mask((room.points[:, 2] < 2.45) & (room.points[:, 1] < 3.7)).voxel_down_sample(0.02)
GREEN, RED = (0.1, 0.65, 0.2), (0.9, 0.15, 0.1)
scene = {
    "room": room,
    "true": {"geometry": truth, "color": GREEN, "line_width": 4},
    "estimated": {"geometry": path, "color": RED, "line_width": 4},
}
cameras = {
    f"camera {k}": {"geometry": loom.CameraFrustum(camera, path.poses[k], 0.25), "color": RED, "line_width": 2}
    for k in range(0, 24, 6)
}
on_room = loom.render(
    scene | cameras, {"front": [0.75, 0.62, 0.6], "up": [0, 0, 1], "zoom": 0.5}, (960, 640),
    legend=[("true", GREEN), ("estimated", RED)],
)  # fmt: skip

# %%
# Frame rate
# ----------
# With fewer frames, fewer errors accumulate, as long as each motion can be estimated. Large motions fail first.

for every in (1, 4, 8):
    T, failed = frames[0].T_world_camera, ""
    for k in range(every, len(frames), every):
        step = odometry.align_frames(prepared[k], prepared[k - every])
        failed = failed or ("" if step.reliable else f"from frame {k - every} to {k} {step.warnings}")
        T = T @ step.transformation
    last = (len(frames) - 1) // every * every
    angle, distance = pose_error(T, truth.poses[last])
    print(f"every {every} frames:", failed or f"error at frame {last} {angle:.2f} degrees and {distance:.1f} mm")
    assert failed or distance < 50, "reliable results are correct"

# %%
# A recording of the growing trajectory:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(
    folder / "path.html", automatic=False, max_points=60_000, title="Odometry, frame by frame"
) as recording:
    recording.add("true", truth, color=GREEN)
    for k in range(0, 24, 2):
        part = cloud_of(k, path.poses[k])
        recording.add(f"frame {k}", part.select_by_mask(part.points[:, 2] < 2.4).voxel_down_sample(0.05))
        recording.add(f"camera {k}", loom.CameraFrustum(camera, path.poses[k], 0.2), color=RED)
        recording.plot("error [mm]", pose_error(path.poses[k], truth.poses[k])[1])
        recording.step(f"frame {k}")
page = folder / "path.html"

# %%
# Save the trajectory
# -------------------
# The suffix selects the format: ``.tum`` (time and quaternion), ``.log`` (Redwood's matrices), ``.kitti`` (3 x 4
# matrices).

loom.write_trajectory(folder / "path.log", path)
assert np.allclose(loom.read_trajectory(folder / "path.log").poses, path.poses, atol=1e-6)

# %%
# Common mistakes
# ---------------
# **A wrong depth scale.** TUM's depth values are in units of 0.2 mm. Without ``depth_scale=5000``, the trajectory is
# five times too long, and no check detects this.
#
# **A wrong image size** raises an error, as in chapter 5. **A wrong focal length** does not: with an error of 10%, all
# motions succeed and the trajectory is distorted. ``inlier_rmse`` changes little: from 4.8 to 5.1 mm in a real kitchen,
# by at most half here. ``loom.rgbd.check_focal`` detects it if the camera rotated sufficiently:

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
# **An inverted motion.** ``T_target_source`` maps source to target. If the trajectory runs backward, source and target
# are swapped.
#
# What to change
# --------------
# - ``every`` in the loop over frame rates: 2, 6 or 12 frames. From which value on is the result unreliable?
# - The brightness: reduce it by half in every second image. Which method is affected?
# - The implementation: ``pointloom.open3d.pipelines.odometry.compute_rgbd_odometry`` has Open3D's parameters. Is it as
#   accurate?
#
# Next
# ----
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: registration of each frame with a model, which
#   has much less drift.
# - :doc:`RGB-D SLAM and odometry </slam>`: reliability checks and loop closure.
