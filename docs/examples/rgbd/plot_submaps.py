"""
Join volumes: several scans, one model
======================================

Two people scan two halves of a room, or a long scan is kept in pieces that move when a loop closes. ``fuse_volumes``
makes one volume of several, as if all frames had gone into one; submaps do it for a whole run.
"""

import numpy as np

import pointloom as loom

# %%
# Two volumes
# -----------
#
# Each has half of the frames, in coordinates of its own first camera: the second scanner knows nothing of the first.

frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
frame_sets, starts = [frames[:14], frames[10:]], []
volumes = []
for part in frame_sets:
    T_world_volume = part[0].T_world_camera
    volume = loom.TSDFVolume(voxel_size=0.03)
    for frame in part:
        T_camera_volume = np.linalg.inv(frame.T_world_camera) @ T_world_volume
        volume.integrate(frame.depth, camera, T_camera_volume, frame.color, depth_scale=1.0, depth_max=4.0)
    volumes.append(volume)
    starts.append(T_world_volume)

# %%
# One of both
# -----------
#
# Given where they lie: here by the true poses, else by registration of their clouds
# (``loom.registration.register_globally``).

both = loom.meshing.fuse_volumes(volumes, starts)
mesh = both.extract_triangle_mesh(weight_threshold=3)
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
error = scene.compute_distance(mesh.vertices)
print(f"{volumes[0].frame_count} and {volumes[1].frame_count} frames; {len(mesh.triangles)} triangles, "
      f"{np.median(error) * 1e3:.1f} mm off the room (median)")  # fmt: skip
assert both.frame_count == len(frame_sets[0]) + len(frame_sets[1]) and np.median(error) < 0.01

# %%
# It goes on: a joined volume takes more frames, and is kept in a file.

more = frames[5]
assert (
    both.integrate(more.depth, camera, np.linalg.inv(more.T_world_camera), more.color, depth_scale=1.0, depth_max=4.0)
    > 0
)

# %%
# A run in pieces
# ---------------
#
# ``SubmapRecorder`` cuts a run of posed frames into submaps that share their last frames. We add drift: each pose is a
# little more wrong than the one before. ``close_loops`` finds submaps that show the same place and moves them; poses
# follow by ``corrected_trajectory``.

drifted = []
for i, frame in enumerate(frames):
    T = frame.T_world_camera.copy()
    T[:3, 3] += 0.002 * i * np.array([1.0, 0.5, 0.0])
    drifted.append(T)
recorder = loom.rgbd.SubmapRecorder(camera, voxel_size=0.03, depth_scale=1.0, frames=8, shared=0.25)
for frame, T in zip(frames, drifted, strict=False):
    recorder.add(frame.depth, T, frame.color)
submaps = recorder.finish()
closure = loom.rgbd.close_loops(submaps)
numbers, poses = loom.rgbd.corrected_trajectory(submaps, closure.T_world_submap)
true = np.array([frames[i].T_world_camera for i in numbers])


def worst(estimated):
    """The largest error of a place [mm], counted from the first frame."""
    return 1e3 * float(
        np.linalg.norm(estimated[:, :3, 3] - true[:, :3, 3] - estimated[0, :3, 3] + true[0, :3, 3], axis=1).max()
    )


print(
    f"{len(submaps)} submaps, {len(closure.loops)} loops; worst place "
    f"{worst(np.array(drifted)[numbers]):.0f} mm, corrected {worst(poses):.0f} mm"
)
assert len(closure.loops) > 0 and worst(poses) < worst(np.array(drifted)[numbers])
model = loom.rgbd.fuse_submaps(submaps, closure.T_world_submap).extract_triangle_mesh(weight_threshold=3)
assert len(model.triangles) > 10_000

# %%
# The two volumes in two colors, and the one of both.

T = frames[12].T_world_camera.copy()
T[:3, 3] -= 0.6 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(640, 640, 560.0, 560.0, 319.5, 319.5), T)
pieces = [
    volume.extract_triangle_mesh(weight_threshold=3).transform(start)
    for volume, start in zip(volumes, starts, strict=False)
]
colors = {"first scan": (0.9, 0.6, 0.25), "second scan": (0.3, 0.55, 0.8)}
scene = {
    name: {"geometry": piece, "color": color, "back_faces": False}
    for piece, (name, color) in zip(pieces, colors.items(), strict=False)
}
parts = loom.render(scene, view, legend=True)
joined = loom.render({"geometry": mesh, "shaded": False, "back_faces": False}, view)
