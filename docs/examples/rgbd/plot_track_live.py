"""
Track a depth camera in real time
=================================

On this page you track a camera with ``DenseSLAM``, which registers each frame with a growing model and reports its
status. ``LatestFrames`` reads a camera in a thread and returns the newest frame. The camera is simulated by a list of
frames. Use ``loom.RealSenseCamera()`` or ``loom.AzureKinectCamera()`` instead.
"""

import time

import pointloom as loom

# %%
# A simulated camera
# ------------------
#
# Any iterable of frames is a source. This one has a fixed frame rate, as a camera.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic


def live(frames, rate):
    """Yield frames at a fixed rate [frames/s]."""
    for frame in frames:
        time.sleep(1.0 / rate)
        yield frame


# %%
# Track
# -----
#
# ``step`` processes a frame and returns its status: tracked, uncertain or lost, with warnings. A lost frame has no
# pose. Frames that arrive during the computation are dropped and counted, so the latency does not grow. A slow computer
# processes fewer frames with larger motions in between. The thread ends with the ``with`` block, also after an error or
# Ctrl-C.

start = recorded[0].T_world_camera  # makes the map upright, not needed with a real camera
slam = loom.rgbd.DenseSLAM(camera, voxel_size=0.04, T_init=start, depth_scale=1.0)
stream = loom.frames_from(live(recorded, rate=8.0), camera, depth_scale=1.0)
with loom.LatestFrames(stream) as frames:
    results = [slam.step(frame) for frame in frames]
print(f"{len(results)} frames processed, {frames.dropped} dropped")
print("frames by status:", {str(status): count for status, count in slam.status_counts.items()})
assert len(results) + frames.dropped == len(recorded)

# %%
# Recorded frames
# ---------------
#
# ``track`` processes all frames of a recording. If the frames have true poses, the result contains the trajectory
# error.

path = loom.rgbd.track(loom.frames_from(recorded, camera, depth_scale=1.0), voxel_size=0.03)
print(path)
error = path.error
print(f"trajectory error {error.absolute_translation.rmse * 1e3:.1f} mm (rms)")
assert path.reliable and not path.lost and len(path.trajectory) == len(recorded)

# %%
# The results are bitwise identical in each run. Each result contains fitness and rmse:

last = [result for result in results if result.pose is not None][-1]  # a slow computer may lose later frames
print(f"last tracked frame: {last.status}, fitness {last.fitness:.2f}, {last.inlier_rmse * 1e3:.1f} mm rmse")

# %%
# The model and the trajectory:

mesh = slam.extract_triangle_mesh()
poses = [result.pose for result in results if result.pose is not None]
cameras = [loom.CameraFrustum(camera, T, scale=0.15, color=(0.85, 0.3, 0.1)) for T in poses[::3]]
T = poses[len(poses) // 2].copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
scene_items = [
    {"geometry": mesh, "shaded": False, "back_faces": False},
    *cameras,
    {"geometry": slam.trajectory, "color": (0.1, 0.3, 0.8)},
]
image = loom.render(scene_items, view)

# %%
# What to change
# --------------
# - ``rate`` [frames/s]: 30 instead of 8. How many frames are dropped on your computer?
# - ``voxel_size`` [m]: a larger value is faster and less accurate.
# - The source: a real camera, ``loom.RealSenseCamera()``.
#
# Next
# ----
# - :doc:`RGB-D SLAM and odometry </slam>`: status and loop closure.
# - :doc:`RGB-D frames </frames>`: supported cameras.
