"""
Reconstruct a room without camera poses
=======================================

On this page you reconstruct a room from the frames of a depth camera without poses. One call tracks the camera, fuses
the frames, and checks whether the result is reliable. ``check_focal`` checks the focal length.
"""

import numpy as np

import pointloom as loom

# %%
# Frames without poses
# --------------------
#
# The true poses are removed and only used for the evaluation. Use ``loom.open_frames(folder)`` for your own data.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic
source = loom.frames_from([(frame.color, frame.depth) for frame in recorded], camera, depth_scale=1.0)

# %%
# One call
# --------
#
# Use a ``voxel_size`` of 3 cm for a preview, 1 cm for the final model. ``print`` displays the status of the frames.

result = loom.rgbd.reconstruct(source, voxel_size=0.03)
print(result)

# %%
# Reliability
# -----------
#
# ``warnings`` lists failed checks: lost frames with their reasons, maps that could not be joined, a wrong focal length.

print("reliable:", result.reliable)
assert result.reliable
assert len(result.trajectory) == len(recorded), "all frames have a pose"

# %%
# Accuracy
# --------
#
# The trajectory is relative to the first camera. It is transformed to the coordinates of the room and compared with the
# ground truth.

poses = recorded[0].T_world_camera @ result.trajectory.poses
true = np.array([frame.T_world_camera for frame in recorded])
error = np.linalg.norm(poses[:, :3, 3] - true[:, :3, 3], axis=1)
path_length = np.linalg.norm(np.diff(true[:, :3, 3], axis=0), axis=1).sum()
print(
    f"path length {path_length:.1f} m; position error {np.sqrt((error**2).mean()) * 1e3:.1f} "
    f"mm (rms), {error.max() * 1e3:.1f} mm maximum"
)
assert error.max() < 0.05

mesh = result.mesh.transform(recorded[0].T_world_camera)
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
surface_error = scene.compute_distance(mesh.vertices)
print(
    f"surface error {np.median(surface_error) * 1e3:.1f} mm (median), "
    f"90th percentile {np.quantile(surface_error, 0.9) * 1e3:.0f} mm"
)
assert np.median(surface_error) < 0.02

# %%
# Check the focal length
# ----------------------
#
# A focal length with an error of 20% gives a plausible room with wrong dimensions. ``check_focal`` projects frames onto
# other frames and estimates the best focal length. ``factor`` is its ratio to the given one.

check = loom.rgbd.check_focal(loom.frames_from(recorded, camera, depth_scale=1.0), result.trajectory)
print("focal length:", "not observable" if check is None else f"factor {check.factor:.2f}; reliable {check.reliable}")
assert check is None or check.reliable

# %%
# The room and the trajectory, from behind the camera:

path = loom.Trajectory(poses)
T = poses[12].copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
image = loom.render(
    [
        {"geometry": mesh, "shaded": False, "back_faces": False},
        {"geometry": path, "color": (0.1, 0.3, 0.8), "line_width": 3},
    ],
    view,
)

# %%
# What to change
# --------------
# - ``voxel_size`` [m]: 0.01 has more detail and takes longer.
# - The frame rate: use every second frame. Are all frames tracked?
# - The focal length: multiply it by 1.2. Does ``check_focal`` detect it?
#
# Next
# ----
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: from frames to a model, step by step.
# - :ref:`RGB-D reconstruction in stages that can resume <sphx_glr_gallery_rgbd_plot_reconstruct_in_stages.py>`
