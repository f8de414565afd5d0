"""
Reconstruct a room from frames without poses
============================================

A depth camera was carried through a room and nothing else is known. One call tracks it, fuses its frames and
checks whether the result is reliable. ``check_focal`` checks whether the camera's focal length fits its frames.
"""

import numpy as np

import pointloom as loom

# %%
# Frames alone
# ------------
#
# The true poses are taken away, to be compared with at the end. For a folder: ``loom.open_frames(folder)``.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic
source = loom.frames_from([(frame.color, frame.depth) for frame in recorded], camera, depth_scale=1.0)

# %%
# One call
# --------
#
# ``voxel_size`` [m]: 3 cm for a quick look, 1 cm for keeps. ``print`` tells what happened to the frames.

result = loom.rgbd.reconstruct(source, voxel_size=0.03)
print(result)

# %%
# Reliability
# -----------
#
# ``warnings`` names failed checks: frames that were lost and why, maps that could not be joined, a focal length that
# does not fit.

print("reliable:", result.reliable)
assert result.reliable
assert len(result.trajectory) == len(recorded), "all frames have a pose"

# %%
# Against the truth
# -----------------
#
# The path lies in the frame of its first camera. We move it to where the room is and compare.

poses = recorded[0].T_world_camera @ result.trajectory.poses
true = np.array([frame.T_world_camera for frame in recorded])
error = np.linalg.norm(poses[:, :3, 3] - true[:, :3, 3], axis=1)
way = np.linalg.norm(np.diff(true[:, :3, 3], axis=0), axis=1).sum()
print(
    f"a way of {way:.1f} m; places off by {np.sqrt((error**2).mean()) * 1e3:.1f} "
    f"mm (rms), {error.max() * 1e3:.1f} mm at most"
)
assert error.max() < 0.05

mesh = result.mesh.transform(recorded[0].T_world_camera)
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
off = scene.compute_distance(mesh.vertices)
print(
    f"surface off by {np.median(off) * 1e3:.1f} mm (median), 9 of 10 places within {np.quantile(off, 0.9) * 1e3:.0f} mm"
)
assert np.median(off) < 0.02

# %%
# Is it the right camera?
# -----------------------
#
# Frames that are a fifth wrong in focal length make a room that looks right and has wrong lengths. ``check_focal``
# turns other frames onto each other and asks which focal length fits best: ``factor`` 1 means the one given.

check = loom.rgbd.check_focal(loom.frames_from(recorded, camera, depth_scale=1.0), result.trajectory)
print("focal length:", "not observable" if check is None else f"factor {check.factor:.2f}; reliable {check.reliable}")
assert check is None or check.reliable

# %%
# The room as the camera saw it, from behind its path.

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
