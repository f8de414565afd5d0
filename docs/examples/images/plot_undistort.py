"""
Straighten a lens
=================

Wide lenses bend lines. Depth, stereo and fusion want a pinhole: ``undistort_image`` gives the straight image and
its camera. ``CameraModel`` knows the lenses of COLMAP, OpenCV and Metashape.
"""

import numpy as np

import pointloom as loom
from pointloom.cameras.undistortion import Undistortion

# %%
# A lens
# ------
#
# OpenCV's model: focal lengths, principal point, two radial and two tangential coefficients. The numbers are as
# COLMAP's files have them; pixels that ``project`` gives have the middle of the first one at (0, 0).

lens = loom.CameraModel("OPENCV", 960, 640, [620.0, 620.0, 480.0, 320.0, -0.28, 0.07, 0.0005, -0.0004])
rays = np.array([[0.0, 0, 1], [0.5, 0.3, 1], [-0.6, 0.35, 1]])
pixels = lens.project(rays)
print("pixels", pixels.round(2).tolist())
assert np.allclose(lens.unproject(pixels)[:, :2] / lens.unproject(pixels)[:, 2:], rays[:, :2], atol=1e-9)

# %%
# A bent image
# --------------
#
# What this lens would have taken: we draw the scene with a wide pinhole and look up, for each pixel of the lens, where
# its ray goes.

mesh = loom.datasets.room_mesh()
eye = loom.datasets.room_frames(1)[0].T_world_camera
wide = loom.PinholeCameraIntrinsic(1600, 1100, 620.0, 620.0, 799.5, 549.5)
ideal = loom.render({"geometry": mesh, "shaded": False}, loom.View(wide, eye))
columns, rows = np.meshgrid(np.arange(960), np.arange(640))
seen = lens.unproject(np.stack([columns, rows], axis=-1).reshape(-1, 2))
projected = seen[:, :2] / seen[:, 2:] * 620 + [799.5, 549.5]
x, y = np.rint(np.nan_to_num(projected, nan=-1)).astype(int).T
inside = (x >= 0) & (x < 1600) & (y >= 0) & (y < 1100)
colors = np.zeros((960 * 640, 3), np.uint8)
colors[inside] = ideal[y[inside], x[inside]]
bent = ideal[:640, :960].copy()
bent[:] = colors.reshape(640, 960, 3)
del ideal

# %%
# Straight
# --------
#
# ``blank_fraction`` 0 keeps the rectangle that is full everywhere, 1 all that the lens saw. The camera that comes with
# it
# is a pinhole.

straight, camera = loom.undistort_image(bent, lens, size=(960, 640))
print(camera)
assert straight.shape == (640, 960, 3)

# %%
# Is it straight? A pixel of the new image shows the ray that the pinhole says: project any place by both.

probe = np.array([[0.3, 0.2, 1.0]])
u, v = (probe[0, :2] * [camera.fx, camera.fy] + [camera.cx, camera.cy]).round().astype(int)
bu, bv = lens.project(probe)[0].round().astype(int)
difference = np.abs(straight[v, u].astype(int) - bent[bv, bu].astype(int)).max()
print(f"pixel ({u}, {v}) of the straight image is ({bu}, {bv}) of the bent one; colors differ by {difference} of 255")
assert difference < 30

# %%
# Many images of one lens: the places are computed once, and ``seen`` tells which pixels the lens showed.

undistortion = Undistortion(lens, blank_fraction=1.0)
full_view = undistortion.apply(bent)
print(full_view.shape, undistortion.intrinsic, f"{100 * undistortion.seen.mean():.0f} % of it seen")
assert 0.5 < undistortion.seen.mean() < 1.0

# %%
# As the lens took it, and straightened.

image = np.hstack([bent, straight])
