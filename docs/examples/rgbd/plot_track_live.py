"""
Track a depth camera live
=========================

Where is the camera, right now, and what has it seen? ``DenseSLAM`` tracks each frame against a model that grows, and
reports the status of each frame. ``LatestFrames`` keeps up with a camera: it reads in a thread and hands out the
newest frame. A list of frames stands in for the camera; ``loom.RealSenseCamera()`` or ``loom.AzureKinectCamera()`` take
its place.
"""

import time

import pointloom as loom

# %%
# A camera that does not wait
# ---------------------------
#
# Any iterable of frames is a source. This one gives 30 frames a second, as a camera does.

recorded = loom.datasets.room_frames(24)
camera = recorded[0].intrinsic


def live(frames, rate):
    """Hand out frames at the pace of a camera."""
    for frame in frames:
        time.sleep(1.0 / rate)
        yield frame


# %%
# Follow it
# ---------
#
# ``step`` takes a frame and returns its status: tracked, uncertain or lost, with warnings. A lost frame gets no
# pose. Frames that come while we compute are dropped and counted: late ones would be worth nothing. A slow computer
# sees fewer frames, which are farther apart, and still knows where it is. The thread ends with the ``with`` block, by
# an error or Ctrl-C too.

start = recorded[0].T_world_camera  # only so that the map stands upright; a camera at home starts where it is
slam = loom.rgbd.DenseSLAM(camera, voxel_size=0.04, T_init=start, depth_scale=1.0)
stream = loom.frames_from(live(recorded, rate=8.0), camera, depth_scale=1.0)
with loom.LatestFrames(stream) as frames:
    results = [slam.step(frame) for frame in frames]
print(f"{len(results)} frames taken, {frames.dropped} dropped")
print("frames by status:", {str(status): count for status, count in slam.status_counts.items()})
assert len(results) + frames.dropped == len(recorded)

# %%
# One call for a recording
# ------------------------
#
# Where nothing is live, ``track`` takes all frames, and compares the path with the true one if the frames bring it: ATE
# is how far the camera's places are off.

path = loom.rgbd.track(loom.frames_from(recorded, camera, depth_scale=1.0), voxel_size=0.03)
print(path)
error = path.error
print(f"off the true path by {error.absolute_translation.rmse * 1e3:.1f} mm (rms)")
assert path.reliable and not path.lost and len(path.trajectory) == len(recorded)

# %%
# The same bits come out each time, and each pose can be asked: what did the last frame look like?

last = results[-1]
print(f"last frame: {last.status}, fitness {last.fitness:.2f}, {last.inlier_rmse * 1e3:.1f} mm off the model")
assert last.pose is not None

# %%
# The model that grew, and the path through it.

mesh = slam.extract_triangle_mesh()
poses = [result.pose for result in results if result.pose is not None]
cameras = [loom.CameraFrustum(camera, T, scale=0.15, color=(0.85, 0.3, 0.1)) for T in poses[::3]]
T = poses[len(poses) // 2].copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
shown = [
    {"geometry": mesh, "shaded": False, "back_faces": False},
    *cameras,
    {"geometry": slam.trajectory, "color": (0.1, 0.3, 0.8)},
]
image = loom.render(shown, view)
