"""
RGB-D reconstruction in stages that can resume
==============================================

On this page you reconstruct a long recording in stages: fragments by odometry, registration of the fragments,
integration. The stages have the names of Open3D's reconstruction system, write their results atomically, and can resume
after an interruption.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

system = loom.rgbd
job = Path(tempfile.mkdtemp()) / "job"

# %%
# Frames and configuration
# ------------------------
#
# The input consists of 24 frames without poses. They are read three times, so they are stored in a folder.
# ``ReconstructionConfig.read`` reads Open3D's JSON files. An unknown name raises an error with the most similar name.
# Lengths are in meters.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic
source = loom.frames_from([(frame.color, frame.depth) for frame in recorded], camera, depth_scale=1000.0)
loom.record_frames(source, job.parent / "frames")
frames = loom.open_frames(job.parent / "frames")
config = system.ReconstructionConfig(n_frames_per_fragment=12, tsdf_voxel_size=0.03, depth_max=4.0)

# %%
# Single stages
# -------------
#
# Each stage writes its result and a record of its inputs to the folder of the job. A pair of frames with unreliable
# odometry ends a fragment. Without the optional ``stages``, the run ends with registered fragments.

registered = system.run_reconstruction_system(frames, config, job, stages=())
for fragment in registered.fragments:
    print(fragment)
assert registered.reliable and not registered.lost and not registered.files

# %%
# All stages
# ----------
#
# With ``resume=True``, results of completed stages are reused. An interrupted job repeats at most one fragment. Its
# result is bitwise identical.

report = system.run_reconstruction_system(frames, config, job, resume=True)
print(report)
assert report.reliable and not report.lost

# %%
# Accuracy
# --------
#
# The trajectory is relative to the first camera.

path = loom.read_trajectory(job / "scene" / "trajectory.log")
mesh = loom.read_triangle_mesh(job / "scene" / "integrated.ply")
T_room_path = recorded[0].T_world_camera @ np.linalg.inv(path.poses[0])
positions = (T_room_path @ path.poses)[:, :3, 3]
error = np.linalg.norm(positions - np.array([frame.T_world_camera[:3, 3] for frame in recorded]), axis=1)
print(f"{len(path)} poses, error {np.sqrt((error**2).mean()) * 1e3:.1f} mm (rms), {error.max() * 1e3:.1f} mm maximum")
assert len(path) == len(recorded) and error.max() < 0.05

# %%
# The scene with the camera poses. Each fragment has its own color.

mesh = mesh.transform(T_room_path)
colors = [(0.9, 0.35, 0.1), (0.1, 0.4, 0.85), (0.2, 0.6, 0.3)]
T = recorded[12].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [
    loom.CameraFrustum(camera, T_room_path @ pose, scale=0.15, color=colors[i // config.n_frames_per_fragment])
    for i, pose in enumerate(path.poses)
]
image = loom.render([{"geometry": mesh, "shaded": False, "back_faces": False}, *cameras], view)

# %%
# What to change
# --------------
# - ``n_frames_per_fragment``: 100 in a recording at 30 frames per second.
# - ``tsdf_voxel_size`` [m]: 0.01 for a final model.
# - ``depth_max`` [m]: 3.0 for cameras with noisy distant depth.
#
# Next
# ----
# - :doc:`RGB-D reconstruction </reconstruction>`: all stages and options.
# - :ref:`Merge TSDF volumes and submaps <sphx_glr_gallery_rgbd_plot_submaps.py>`
