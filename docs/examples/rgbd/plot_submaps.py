"""
Merge TSDF volumes and submaps
==============================

On this page you merge two TSDF volumes of different scans into one with ``fuse_volumes``, and divide a long run into
submaps whose poses are corrected by loop closures.
"""

import numpy as np

import pointloom as loom

# %%
# Two volumes
# -----------
#
# Each volume contains half of the frames, in the coordinates of its own first camera.

frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
frame_sets, volume_poses = [frames[:14], frames[10:]], []
volumes = []
for part in frame_sets:
    T_world_volume = part[0].T_world_camera
    volume = loom.TSDFVolume(voxel_size=0.03)
    for frame in part:
        T_camera_volume = np.linalg.inv(frame.T_world_camera) @ T_world_volume
        volume.integrate(frame.depth, camera, T_camera_volume, frame.color, depth_scale=1.0, depth_max=4.0)
    volumes.append(volume)
    volume_poses.append(T_world_volume)

# %%
# Merge
# -----
#
# The poses of the volumes are known here. Otherwise register their clouds with ``loom.registration.register_globally``.

merged = loom.meshing.fuse_volumes(volumes, volume_poses)
mesh = merged.extract_triangle_mesh(weight_threshold=3)
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
error = scene.compute_distance(mesh.vertices)
print(f"{volumes[0].frame_count} and {volumes[1].frame_count} frames; {len(mesh.triangles)} triangles, "
      f"{np.median(error) * 1e3:.1f} mm median error")  # fmt: skip
assert merged.frame_count == len(frame_sets[0]) + len(frame_sets[1]) and np.median(error) < 0.01

# %%
# The merged volume accepts further frames and can be stored in a file.

next_frame = frames[5]
assert (
    merged.integrate(
        next_frame.depth,
        camera,
        np.linalg.inv(next_frame.T_world_camera),
        next_frame.color,
        depth_scale=1.0,
        depth_max=4.0,
    )
    > 0
)

# %%
# Submaps
# -------
#
# ``SubmapRecorder`` divides a run of posed frames into submaps with shared frames. The script adds drift: an error that
# increases with each pose. ``close_loops`` detects submaps of the same location and corrects their poses.
# ``corrected_trajectory`` applies the correction to the poses of the frames.

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


def largest_error(estimated):
    """Largest position error [mm], relative to the first frame."""
    return 1e3 * float(
        np.linalg.norm(estimated[:, :3, 3] - true[:, :3, 3] - estimated[0, :3, 3] + true[0, :3, 3], axis=1).max()
    )


print(
    f"{len(submaps)} submaps, {len(closure.loops)} loops; largest error "
    f"{largest_error(np.array(drifted)[numbers]):.0f} mm, corrected {largest_error(poses):.0f} mm"
)
assert len(closure.loops) > 0 and largest_error(poses) < largest_error(np.array(drifted)[numbers])
model = loom.rgbd.fuse_submaps(submaps, closure.T_world_submap).extract_triangle_mesh(weight_threshold=3)
assert len(model.triangles) > 10_000

# %%
# The two volumes in different colors, and the merged volume:

T = frames[12].T_world_camera.copy()
T[:3, 3] -= 0.6 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(640, 640, 560.0, 560.0, 319.5, 319.5), T)
pieces = [
    volume.extract_triangle_mesh(weight_threshold=3).transform(start)
    for volume, start in zip(volumes, volume_poses, strict=False)
]
colors = {"first scan": (0.9, 0.6, 0.25), "second scan": (0.3, 0.55, 0.8)}
scene = {
    name: {"geometry": piece, "color": color, "back_faces": False}
    for piece, (name, color) in zip(pieces, colors.items(), strict=False)
}
parts = loom.render(scene, view, legend=True)
joined = loom.render({"geometry": mesh, "shaded": False, "back_faces": False}, view)

# %%
# What to change
# --------------
# - ``frames`` per submap and ``shared``, the fraction of shared frames.
# - The drift [m per frame]: 0.002. At which value are loops no longer detected?
# - ``weight_threshold`` [frames]: removes surfaces that few frames observed.
#
# Next
# ----
# - :ref:`Pose graphs and loop closure <sphx_glr_gallery_registration_plot_pose_graph_loop_closure.py>`
# - :doc:`RGB-D SLAM and odometry </slam>`
