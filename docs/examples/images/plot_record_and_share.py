"""
Record an algorithm and share the result
========================================

On this page you record a fusion as a web page that plays offline, create an animation for slides, and save a scene of
the viewer as a page for others.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp())

# %%
# Record a fusion
# ---------------
#
# Fusion, registration, tracking and clustering inside the block are recorded. The results are bitwise identical with
# and without recording. The suffix selects the format.

frames = loom.datasets.room_frames(16)
camera = frames[0].intrinsic
page = folder / "fusion.html"
with loom.record(page, title="Fusion of 16 frames") as recorder:
    result = loom.rgbd.fuse(loom.frames_from(frames, camera, depth_scale=1.0), voxel_size=0.04)
print(f"{page.name}: {page.stat().st_size / 1e6:.1f} MB; mesh of {len(result.mesh.triangles)} triangles")
assert page.read_text(encoding="utf-8", errors="ignore").lstrip().lower().startswith("<!doctype html")

# %%
# Record your own steps
# ---------------------
#
# ``add`` adds a geometry, ``set_pose`` moves it, ``plot`` adds a value to a plot, and ``step`` ends a frame. The output
# is an animation.

figure = loom.datasets.object_mesh().simplify_quadric_decimation(6000)
animation = folder / "rotation.gif"
with loom.record(animation, fps=12, size=(240, 240), automatic=False) as recorder:
    recorder.add("figure", figure)
    for i in range(12):
        angle = 2 * np.pi * i / 12
        T = np.eye(4)
        T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        recorder.set_pose("figure", T)
        recorder.plot("angle [degrees]", np.degrees(angle))
        recorder.step(f"{np.degrees(angle):.0f} degrees")
print(f"{animation.name}: {animation.stat().st_size / 1e3:.0f} kB")
assert animation.read_bytes()[:4] == b"GIF8"

# %%
# Share a scene
# -------------
#
# ``loom.Viewer`` is the live viewer. ``save_html`` writes its scene as a single page. This does not need a browser.

viewer = loom.Viewer(port=0)
viewer.add("room", result.mesh)
viewer.add("path", loom.Trajectory(result.T_world_camera))
viewer.save_html(folder / "room.html")
viewer.close()
print(f"room.html: {(folder / 'room.html').stat().st_size / 1e6:.1f} MB")

# %%
# The fused room, from behind the camera:

T = frames[8].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
cameras = [loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.9, 0.35, 0.1)) for frame in frames]
image = loom.render([{"geometry": result.mesh, "shaded": False, "back_faces": False}, *cameras], view)
loom.write_image(folder / "room.png", image)

# %%
# What to change
# --------------
# - ``fps`` and ``size`` [frames/s, pixels] of the animation.
# - ``automatic``: ``True`` also records pointloom's algorithms.
# - The suffix: ``.mp4`` if ffmpeg is installed.
#
# Next
# ----
# - :ref:`Chapter 12 <sphx_glr_chapters_plot_12_animation.py>`: recordings, step by step.
# - :doc:`Recordings </recordings>`
