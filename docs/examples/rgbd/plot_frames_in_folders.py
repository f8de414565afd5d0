"""
Record and read RGB-D frames
============================

On this page you record a depth camera, read the recording, and read data sets in the layouts of 7-Scenes, Redwood and
TUM, or as plain images. All functions that process frames accept any of these sources.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.io.frames.recordings import FrameRecorder

folder = Path(tempfile.mkdtemp())

# %%
# Frames from your own code
# -------------------------
#
# A source consists of pairs of color and depth from a list, a generator or the loop of a camera. Depth is uint16 in
# units of ``depth_scale``, or float32 in meters. 8-bit images raise an error, since they do not contain depth.

frames = loom.datasets.room_frames(12)
camera = frames[0].intrinsic
source = loom.frames_from(frames, camera, depth_scale=1000.0)
try:
    list(loom.frames_from([(frames[0].color, frames[0].color[..., 0])], camera))
except TypeError as error:
    print("rejected:", error)

# %%
# Record
# ------
#
# A recording is a folder of PNG files in the layout of 7-Scenes, with camera parameters and timestamps. It is readable
# at any time, even after an interruption. ``FrameRecorder`` writes single frames in your own loop.

count = loom.record_frames(source, folder / "take-1")
print(count, "frames,", sorted(path.name for path in (folder / "take-1").iterdir())[:4])
recorder = FrameRecorder(folder / "take-2", camera, depth_scale=1000.0)
for frame in loom.frames_from(frames[:5], camera, depth_scale=1000.0):
    recorder.write(frame)
assert count == 12 and recorder.count == 5

# %%
# Read
# ----
#
# ``open_frames`` detects the layout. Frames are decoded on demand. Depth is rounded to millimeters.

recorded = loom.open_frames(folder / "take-1")
print(recorded.intrinsic, "depth scale", recorded.depth_scale)
read_back = list(recorded)
assert np.array_equal(read_back[3].color, frames[3].color)
difference = np.abs(read_back[3].depth / recorded.depth_scale - frames[3].depth).max()
print(f"largest difference of the depth: {difference * 1e3:.2f} mm")
assert difference <= 0.00051
assert len(list(loom.open_frames(folder / "take-1", every=4))) == 3

# %%
# Images, cameras and trajectories can also be read separately.

color = loom.read_color(folder / "take-1" / "frame-000003.color.png")
depth = loom.read_depth(folder / "take-1" / "frame-000003.depth.png")
lens = loom.PinholeCameraIntrinsic.read(folder / "take-1" / "camera-intrinsics.json")
lens.write(folder / "camera.json")
path = loom.Trajectory(np.array([frame.T_world_camera for frame in frames]))
loom.write_trajectory(folder / "trajectory.log", path)
assert np.allclose(loom.read_trajectory(folder / "trajectory.log").poses, path.poses, atol=1e-6)
print(color.shape, color.dtype, depth.shape, depth.dtype, lens)

# %%
# A folder that is not a data set raises an error with the missing files. A misspelled path raises an error with similar
# names.

for wrong in (folder, folder / "take-3"):
    try:
        loom.open_dataset(wrong)
    except loom.PointloomError as error:
        print(str(error).replace(str(folder), "..."))

# %%
# Use a recording
# ---------------
#
# This cell fuses the recording to a mesh. ``open_dataset`` requires poses, which this recording contains.

result = loom.rgbd.fuse(loom.open_dataset(folder / "take-1"), voxel_size=0.03)
assert result.reliable and result.frame_count == 12

T = frames[6].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.9, 0.35, 0.1)) for frame in frames]
image = loom.render([{"geometry": result.mesh, "shaded": False, "back_faces": False}, *cameras], view)

# %%
# What to change
# --------------
# - ``every``: 4 reads every fourth frame.
# - ``depth_scale``: 5000 stores depth in units of 0.2 mm, as TUM.
# - The path: open a folder of your own data set.
#
# Next
# ----
# - :doc:`RGB-D frames: folders, streams, cameras </frames>`
# - :ref:`TSDF fusion of depth frames with known poses <sphx_glr_gallery_rgbd_plot_fuse_posed_frames.py>`
