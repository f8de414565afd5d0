"""
12. Watch an algorithm work
===========================

An algorithm that fails is understood when one sees its steps. You learn to record them: as a page that plays in any
browser without a server, as an animation for slides, and by hand for a loop of your own.
"""

# %%
# By itself
# ---------
# What runs inside ``with loom.record(...)`` is recorded: ICP, global registration, fusion, tracking, odometry,
# clusters, planes. Nothing has to be changed in the code, and results are the same bits.
#
# In Open3D one opens a ``Visualizer`` and calls ``update_geometry``, ``poll_events`` and ``update_renderer`` in a
# loop, with a window open; here no window is needed.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
scans = loom.datasets.object_scans(10)
to_first = np.linalg.inv(scans.poses[0])


def perturbation(degrees: float) -> np.ndarray:
    """A turn about the camera's vertical axis, through a point 60 cm before it, where the figure stands."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    middle = np.array([0, 0, 0.6])
    T[:3, 3] = middle - T[:3, :3] @ middle
    return T


target = scans.scans[0].voxel_down_sample(0.004).estimate_normals(radius=0.012, max_nn=30)
source = scans.scans[9].transform(to_first @ scans.poses[9]).voxel_down_sample(0.004).transform(perturbation(14.0))
print("source", source, "target", target)

with loom.record(folder / "icp.html", title="ICP brings two scans together") as recording:
    result = reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimation.point_to_plane())
print(result)
print(len(recording.timeline.frames), "frames: the start, and one for each iteration")
assert len(recording.timeline.frames) == result.iterations + 1

unwatched = reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimation.point_to_plane())
assert np.array_equal(result.transformation, unwatched.transformation), "watching changes nothing"

# %%
# The page is one file: send it by mail, put it on a web site. It plays, stops, goes step by step, turns, and shows
# fitness and error as plots.

page = folder / "icp.html"
print(f"{page.stat().st_size / 1e6:.1f} MB")
assert page.stat().st_size < 5e6

# %%
# As an animation
# ---------------
# The suffix says what is written: ``.html``, ``.gif``, or ``.mp4`` where the program ffmpeg is installed.
# A .gif plays in slides. Its view is chosen beforehand.

small = loom.View.from_open3d(
    (target.get_min_bound(), target.get_max_bound()),
    front=[0.3, -0.3, -1],
    up=[0, -1, 0],
    zoom=0.8,
    width=320,
    height=240,
)
with loom.record(folder / "icp.gif", fps=5, size=(320, 240), view=small):
    reg.registration_icp(source, target, 0.02, np.eye(4), reg.TransformationEstimation.point_to_plane())
print("icp.gif:", (folder / "icp.gif").stat().st_size // 1000, "kB")
assert (folder / "icp.gif").stat().st_size > 1000

# %%
# By hand
# -------
# A loop of your own says what a frame is: ``add`` a shape, ``set_pose`` moves it, ``update`` replaces it, ``plot``
# adds a number, ``step`` ends the frame. Here ICP runs one iteration at a time, and the points take the color of
# their distance.

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
one = reg.ICPConvergenceCriteria(max_iteration=1)
T, history = np.eye(4), []
with loom.record(folder / "by_hand.html", automatic=False, title="By hand") as recording:
    recording.add("target", target, color=BLUE)
    for k in range(25):
        shown = source.transform(T)
        shown["apart"] = shown.compute_point_cloud_distance(target) * 1000
        recording.update("source", shown, color_by="apart", limits=(0.0, 20.0)) if k else recording.add(
            "source", shown, color_by="apart", limits=(0.0, 20.0)
        )
        history.append(float(np.median(shown["apart"])))
        recording.plot("half of the points within [mm]", history[-1])
        recording.step(f"step {k}")
        T = reg.registration_icp(
            source, target, 0.02, T, reg.TransformationEstimation.point_to_plane(), one
        ).transformation
page = folder / "by_hand.html"
print(f"half of the points within {history[0]:.1f} mm at first, {history[-1]:.1f} mm at last")
assert history[-1] < 0.5 * history[0]

# %%
# The first and the last step as images, and in one image the way of each step. An image is an array: put two
# side by side with NumPy.

view = {"front": [0.35, -0.35, -1], "up": [0, -1, 0], "zoom": 0.62}


def drawn(T: np.ndarray) -> np.ndarray:
    """Both clouds with the source at a pose."""
    moved = {"geometry": source, "pose": T, "color": ORANGE}
    return loom.render({"source": moved, "target": {"geometry": target, "color": BLUE}}, view, (960, 640), legend=True)


first = drawn(np.eye(4))
last = drawn(T)
both = np.hstack([first[:, 180:660], last[:, 180:660]])
loom.write_image(folder / "both.png", both)
assert both.shape == (640, 960, 3)

# %%
# What goes wrong
# ---------------
# **The wrong suffix** is an error before any work, and not after an hour:

try:
    loom.record(folder / "icp.avi")
except loom.FileError as error:
    message = str(error).replace(str(folder), "...")
    print(message)
assert "html" in message

# %%
# **No** ``with``. The file is written at the end of the block: ``loom.record(path)`` alone records nothing.
#
# **Large clouds.** More than ``max_points`` (200,000) are sampled, which the title says; the page would be slow
# otherwise. **Ctrl-C** in the middle: what was recorded until then is written.
#
# Try it
# ------
# - Record ``cluster_dbscan`` of chapter 3, or ``register_globally`` of chapter 8.
# - ``pointloom register a.ply b.ply --record icp.html`` does it from the shell.
#
# Where to go next
# ----------------
# The page :doc:`Recordings </recordings>` lists what records itself. For a window that follows a running program see
# ``loom.Viewer`` on the page :doc:`The viewer </viewer>`.
# :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>` follows a camera.
