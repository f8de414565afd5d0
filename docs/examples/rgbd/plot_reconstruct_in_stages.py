"""
Reconstruct in stages that can resume
=====================================

Long recordings are cut into fragments, each is made by odometry, fragments are registered and fused. The
stages have Open3D's names, leave whole files, and go on where they were interrupted.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

system = loom.rgbd
job = Path(tempfile.mkdtemp()) / "job"

# %%
# Frames and a configuration
# --------------------------
#
# 24 frames without poses; frames are read three times, so they lie in a folder. ``ReconstructionConfig.read`` takes
# Open3D's JSON as it is; an unknown name in it is an error that names the nearest one. Lengths are meters.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic
source = loom.frames_from([(frame.color, frame.depth) for frame in recorded], camera, depth_scale=1000.0)
loom.record_frames(source, job.parent / "frames")
frames = loom.open_frames(job.parent / "frames")
config = system.ReconstructionConfig(n_frames_per_fragment=12, tsdf_voxel_size=0.03, depth_max=4.0)

# %%
# Stage by stage
# --------------
#
# Each stage writes its result and a record of its inputs to the job's folder. A pair of frames whose odometry is
# unreliable ends a fragment: no motion is assumed. Without the optional ``stages``, the run ends with registered
# fragments.

registered = system.run_reconstruction_system(frames, config, job, stages=())
for fragment in registered.fragments:
    print(fragment)
assert registered.reliable and not registered.lost and not registered.files

# %%
# Or all at once
# --------------
#
# With ``resume=True`` the results of finished stages are kept. An interrupted job loses at most one fragment, and its
# result is bitwise identical.

report = system.run_reconstruction_system(frames, config, job, resume=True)
print(report)
assert report.reliable and not report.lost

# %%
# Against the truth
# -----------------
#
# The path lies in the frame of its first camera.

path = loom.read_trajectory(job / "scene" / "trajectory.log")
mesh = loom.read_triangle_mesh(job / "scene" / "integrated.ply")
start = recorded[0].T_world_camera @ np.linalg.inv(path.poses[0])
positions = (start @ path.poses)[:, :3, 3]
error = np.linalg.norm(positions - np.array([frame.T_world_camera[:3, 3] for frame in recorded]), axis=1)
print(f"{len(path)} poses, {np.sqrt((error**2).mean()) * 1e3:.1f} mm off (rms), {error.max() * 1e3:.1f} mm at most")
assert len(path) == len(recorded) and error.max() < 0.05

# %%
# The scene, and the path in two colors: one for each fragment.

mesh = mesh.transform(start)
colors = [(0.9, 0.35, 0.1), (0.1, 0.4, 0.85), (0.2, 0.6, 0.3)]
T = recorded[12].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [
    loom.CameraFrustum(camera, start @ pose, scale=0.15, color=colors[i // config.n_frames_per_fragment])
    for i, pose in enumerate(path.poses)
]
image = loom.render([{"geometry": mesh, "shaded": False, "back_faces": False}, *cameras], view)
