"""
Record what an algorithm does, and send it
==========================================

A fusion, a registration or a track as one page that plays offline: turn it, scrub it, no server and no install. The
same as .gif or .mp4 for slides. And a viewer's scene saved as a page for others.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp())

# %%
# Watch a fusion
# --------------
#
# Everything that fuses, registers, tracks or clusters inside the block is recorded; results are the same bits with and
# without. The suffix says the format.

frames = loom.datasets.room_frames(16)
camera = frames[0].intrinsic
page = folder / "fusion.html"
with loom.record(page, title="Fusion of 16 frames") as recorder:
    result = loom.rgbd.fuse(loom.frames_from(frames, camera, depth_scale=1.0), voxel_size=0.04)
print(f"{page.name}: {page.stat().st_size / 1e6:.1f} MB; mesh of {len(result.mesh.triangles)} triangles")
assert page.read_text(encoding="utf-8", errors="ignore").lstrip().lower().startswith("<!doctype html")

# %%
# Steps of your own
# -----------------
#
# ``add`` shows a geometry, ``set_pose`` moves it, ``plot`` adds a number, ``step`` ends a frame of the recording. Here
# as an animation file.

figure = loom.datasets.object_mesh().simplify_quadric_decimation(6000)
turning = folder / "turn.gif"
with loom.record(turning, fps=12, size=(240, 240), automatic=False) as recorder:
    recorder.add("figure", figure)
    for i in range(12):
        angle = 2 * np.pi * i / 12
        T = np.eye(4)
        T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        recorder.set_pose("figure", T)
        recorder.plot("angle [degrees]", np.degrees(angle))
        recorder.step(f"{np.degrees(angle):.0f} degrees")
print(f"{turning.name}: {turning.stat().st_size / 1e3:.0f} kB")
assert turning.read_bytes()[:4] == b"GIF8"

# %%
# A scene for a colleague
# -----------------------
#
# ``loom.Viewer`` is the live viewer; ``save_html`` writes what it shows as one page that opens anywhere. No browser is
# needed for that.

viewer = loom.Viewer(port=0)
viewer.add("room", result.mesh)
viewer.add("path", loom.Trajectory(result.T_world_camera))
viewer.save_html(folder / "room.html")
viewer.close()
print(f"room.html: {(folder / 'room.html').stat().st_size / 1e6:.1f} MB")

# %%
# The room that was fused, from behind the camera.

T = frames[8].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.9, 0.35, 0.1)) for frame in frames]
image = loom.render([{"geometry": result.mesh, "shaded": False, "back_faces": False}, *cameras], view)
loom.write_image(folder / "room.png", image)
