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
# Each stage leaves its result in the job's folder and a record of what it was made from. A pair of frames whose
# odometry is unreliable ends a fragment: no motion is assumed.

fragments = system.make_fragments(frames, config, job)
for fragment in fragments.fragments:
    print(f"fragment {fragment.number}: frames {fragment.indices[0]} to {fragment.indices[-1]}")
registration = system.register_fragments(config, job)
refined = system.refine_registration(config, job)
scene = system.integrate_scene(frames, config, job)
assert registration.placed.all() and refined.placed.all() and not fragments.lost

# %%
# Or all at once
# --------------
#
# ``run_reconstruction_system`` runs what is not done yet. With ``resume=True`` everything is kept here, since nothing
# changed: an
# interrupted job loses at most the fragment that it was at, and ends with the same bits.

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
    loom.CameraFrustum(camera, start @ path.poses[i], scale=0.15, color=colors[fragment.number % 3])
    for fragment in fragments.fragments
    for i in fragment.indices
]
image = loom.render([{"geometry": mesh, "shaded": False, "back_faces": False}, *cameras], view)
