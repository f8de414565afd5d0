"""
12. Recordings and animations of algorithms
===========================================

A recording shows each step of an algorithm, which helps to find the cause of a failure. In this chapter you record a
registration as a web page that plays without a server, as an animation for slides, and step by step in your own loop.
"""

# %%
# Automatic recording
# -------------------
# Algorithms that run inside ``with loom.record(...)`` are recorded: ICP, global registration, fusion, tracking,
# odometry, clustering, plane segmentation. The code does not change, and the results are bitwise identical.
#
# In Open3D, a ``Visualizer`` with an open window calls ``update_geometry``, ``poll_events`` and ``update_renderer`` in
# a loop. pointloom needs no window.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
scans = loom.datasets.object_scans(10)
to_first = np.linalg.inv(scans.poses[0])


def perturbation(degrees: float) -> np.ndarray:
    """A rotation about the vertical axis through the object, which is 60 cm in front of the camera."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    center = np.array([0, 0, 0.6])
    T[:3, 3] = center - T[:3, :3] @ center
    return T


target = scans.scans[0].voxel_down_sample(0.004).estimate_normals(radius=0.012, max_nn=30)
source = scans.scans[9].transform(to_first @ scans.poses[9]).voxel_down_sample(0.004).transform(perturbation(14.0))
print("source", source, "target", target)

with loom.record(folder / "icp.html", title="ICP of two scans") as recording:
    result = reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimationPointToPlane())
print(result)
print(len(recording.timeline.frames), "frames: the initial pose, and one for each iteration")
assert len(recording.timeline.frames) == result.iterations + 1

without_recording = reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimationPointToPlane())
assert np.array_equal(result.transformation, without_recording.transformation), "recording does not change the result"

# %%
# The page is a single file. It has controls for playback and single steps, can be rotated, and plots fitness and rmse.

page = folder / "icp.html"
print(f"{page.stat().st_size / 1e6:.1f} MB")
assert page.stat().st_size < 5e6

# %%
# Animations
# ----------
# The suffix selects the format: ``.html``, ``.gif``, or ``.mp4`` if ffmpeg is installed. GIF and MP4 have a fixed view.

small = loom.View.from_open3d(
    (target.get_min_bound(), target.get_max_bound()),
    front=[0.3, -0.3, -1],
    up=[0, -1, 0],
    zoom=0.8,
    width=320,
    height=240,
)
with loom.record(folder / "icp.gif", fps=5, size=(320, 240), view=small):
    reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimationPointToPlane())
print("icp.gif:", (folder / "icp.gif").stat().st_size // 1000, "kB")
assert (folder / "icp.gif").stat().st_size > 1000

# %%
# Record your own loop
# --------------------
# In your own loop, ``add`` adds a geometry, ``set_pose`` moves it, ``update`` replaces it, ``plot`` adds a value to a
# plot, and ``step`` ends a frame. This loop runs ICP one iteration at a time and colors the points by their distance.

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
one = reg.ICPConvergenceCriteria(max_iteration=1)
T, history = np.eye(4), []
with loom.record(folder / "by_hand.html", automatic=False, title="ICP, step by step") as recording:
    recording.add("target", target, color=BLUE)
    for k in range(25):
        moved_source = source.transform(T)
        moved_source["distance"] = moved_source.compute_point_cloud_distance(target) * 1000
        recording.update("source", moved_source, color_by="distance", limits=(0.0, 20.0)) if k else recording.add(
            "source", moved_source, color_by="distance", limits=(0.0, 20.0)
        )
        history.append(float(np.median(moved_source["distance"])))
        recording.plot("median distance [mm]", history[-1])
        recording.step(f"step {k}")
        T = reg.registration_icp(
            source, target, 0.02, T, reg.TransformationEstimationPointToPlane(), one
        ).transformation
page = folder / "by_hand.html"
print(f"median distance {history[0]:.1f} mm at the start, {history[-1]:.1f} mm at the end")
assert history[-1] < 0.5 * history[0]

# %%
# The first and the last step as images. Images are NumPy arrays, so ``np.hstack`` combines them.

view = {"front": [0.35, -0.35, -1], "up": [0, -1, 0], "zoom": 0.62}


def scene_image(T: np.ndarray) -> np.ndarray:
    """Image of both clouds with the source at pose T."""
    moved = {"geometry": source, "pose": T, "color": ORANGE}
    return loom.render({"source": moved, "target": {"geometry": target, "color": BLUE}}, view, (960, 640), legend=True)


first = scene_image(np.eye(4))
last = scene_image(T)
both = np.hstack([first[:, 180:660], last[:, 180:660]])
loom.write_image(folder / "both.png", both)
assert both.shape == (640, 960, 3)

# %%
# Common mistakes
# ---------------
# **An unsupported suffix** raises an error before the computation:

try:
    loom.record(folder / "icp.avi")
except loom.FileError as error:
    message = str(error).replace(str(folder), "...")
    print(message)
assert "html" in message

# %%
# **A missing** ``with``. The file is written at the end of the block. ``loom.record(path)`` alone records nothing.
#
# **Large clouds.** Clouds with more than ``max_points`` (200,000) are sampled to keep the page responsive. The title
# reports this. **An interrupted run.** After Ctrl-C, the file contains all frames up to that moment.
#
# What to change
# --------------
# - ``max_points``: a smaller value makes the page smaller.
# - ``fps`` of the animation [frames/s]: the speed. ``size`` [pixels]: a larger image gives a larger file.
# - The algorithm: record ``cluster_dbscan`` of chapter 3 or ``register_globally`` of chapter 8.
# - The command line: ``pointloom register a.ply b.ply --record icp.html``.
#
# Next
# ----
# - :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>`: odometry of a depth camera.
# - :doc:`Recordings </recordings>`: all algorithms that can be recorded.
# - :doc:`The viewer </viewer>`: ``loom.Viewer`` displays a running program.
