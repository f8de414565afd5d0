"""
Frames in and out of folders
============================

Record a depth camera, look into the recording, and read data sets in the layouts of others (7-Scenes, Redwood, TUM,
plain images). Whatever gives frames is a source, and every source goes into everything that takes frames.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.io.frames.recordings import FrameRecorder

folder = Path(tempfile.mkdtemp())

# %%
# A source of your own
# --------------------
#
# Pairs of color and depth, from a list, a generator or your camera's loop. Depth is uint16 in units of
# ``depth_scale``, or float32 in meters; 8-bit depth is refused, since it is an image of depth and holds none.

frames = loom.datasets.room_frames(12)
camera = frames[0].intrinsic
source = loom.frames_from(frames, camera, depth_scale=1000.0)
try:
    list(loom.frames_from([(frames[0].color, frames[0].color[..., 0])], camera))
except TypeError as error:
    print("refused:", error)

# %%
# Record it
# ---------
#
# A recording is a folder of PNGs in the layout of 7-Scenes, with the camera and the times. It can be read at any
# moment, after a full disk too. ``FrameRecorder`` writes single frames, for a loop that does something else as well.

count = loom.record_frames(source, folder / "take-1")
print(count, "frames,", sorted(path.name for path in (folder / "take-1").iterdir())[:4])
recorder = FrameRecorder(folder / "take-2", camera, depth_scale=1000.0)
for frame in loom.frames_from(frames[:5], camera, depth_scale=1000.0):
    recorder.write(frame)
assert count == 12 and recorder.count == 5

# %%
# Read it back
# ------------
#
# ``open_frames`` finds the layout by itself; frames are decoded when they come. Depth was rounded to whole millimeters.

recorded = loom.open_frames(folder / "take-1")
print(recorded.intrinsic, "depth scale", recorded.depth_scale)
back = list(recorded)
assert np.array_equal(back[3].color, frames[3].color)
difference = np.abs(back[3].depth / recorded.depth_scale - frames[3].depth).max()
print(f"depth differs by {difference * 1e3:.2f} mm at most")
assert difference <= 0.00051
assert len(list(loom.open_frames(folder / "take-1", every=4))) == 3

# %%
# Single images, cameras and paths have readers of their own.

color = loom.read_color(folder / "take-1" / "frame-000003.color.png")
depth = loom.read_depth(folder / "take-1" / "frame-000003.depth.png")
lens = loom.PinholeCameraIntrinsic.read(folder / "take-1" / "camera-intrinsics.json")
lens.write(folder / "camera.json")
path = loom.Trajectory(np.array([frame.T_world_camera for frame in frames]))
loom.write_trajectory(folder / "trajectory.log", path)
assert np.allclose(loom.read_trajectory(folder / "trajectory.log").poses, path.poses, atol=1e-6)
print(color.shape, color.dtype, depth.shape, depth.dtype, lens)

# %%
# A folder that is no data set says what it lacks, and a typo names what is near.

for wrong in (folder, folder / "take-3"):
    try:
        loom.open_dataset(wrong)
    except loom.PointloomError as error:
        print(str(error).replace(str(folder), "..."))

# %%
# Straight into the rest: the recording as a mesh. Our frames came with poses, so the folder has them; ``open_dataset``
# wants them.

result = loom.rgbd.fuse(loom.open_dataset(folder / "take-1"), voxel_size=0.03)
assert result.reliable and result.frame_count == 12

T = frames[6].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.9, 0.35, 0.1)) for frame in frames]
image = loom.render([{"geometry": result.mesh, "shaded": False, "back_faces": False}, *cameras], view)
