"""
Lens undistortion
=================

Wide-angle lenses distort straight lines. Depth estimation, stereo and fusion require a pinhole camera. On this page you
convert an image to a pinhole image with ``undistort_image``. ``CameraModel`` supports the lens models of COLMAP, OpenCV
and Metashape.
"""

import numpy as np

import pointloom as loom
from pointloom.cameras.undistortion import Undistortion

# %%
# A lens model
# ------------
#
# OpenCV's model has focal lengths, the principal point, two radial and two tangential coefficients. The parameters are
# those of COLMAP's files. In the pixel coordinates of ``project``, the center of the first pixel is (0, 0).

lens = loom.CameraModel("OPENCV", 960, 640, [620.0, 620.0, 480.0, 320.0, -0.28, 0.07, 0.0005, -0.0004])
rays = np.array([[0.0, 0, 1], [0.5, 0.3, 1], [-0.6, 0.35, 1]])
pixels = lens.project(rays)
print("pixels", pixels.round(2).tolist())
assert np.allclose(lens.unproject(pixels)[:, :2] / lens.unproject(pixels)[:, 2:], rays[:, :2], atol=1e-9)

# %%
# A distorted image
# -----------------
#
# The script renders the scene with a wide pinhole camera. For each pixel of the lens, it takes the color in the
# direction of its ray.

mesh = loom.datasets.room_mesh()
camera_pose = loom.datasets.room_frames(1)[0].T_world_camera
wide = loom.PinholeCameraIntrinsic(1600, 1100, 620.0, 620.0, 799.5, 549.5)
ideal = loom.render({"geometry": mesh, "shaded": False}, loom.View(wide, camera_pose))
columns, rows = np.meshgrid(np.arange(960), np.arange(640))
lens_rays = lens.unproject(np.stack([columns, rows], axis=-1).reshape(-1, 2))
projected = lens_rays[:, :2] / lens_rays[:, 2:] * 620 + [799.5, 549.5]
x, y = np.rint(np.nan_to_num(projected, nan=-1)).astype(int).T
inside = (x >= 0) & (x < 1600) & (y >= 0) & (y < 1100)
colors = np.zeros((960 * 640, 3), np.uint8)
colors[inside] = ideal[y[inside], x[inside]]
distorted = ideal[:640, :960].copy()
distorted[:] = colors.reshape(640, 960, 3)
del ideal

# %%
# Undistort
# ---------
#
# With ``blank_fraction`` 0, the image only contains valid pixels. With 1, it contains the complete field of view. The
# function also returns the pinhole camera.

undistorted, camera = loom.undistort_image(distorted, lens, size=(960, 640))
print(camera)
assert undistorted.shape == (640, 960, 3)

# %%
# To verify the result, a 3D point is projected with both cameras. The colors at both pixels agree.

test_point = np.array([[0.3, 0.2, 1.0]])
u, v = (test_point[0, :2] * [camera.fx, camera.fy] + [camera.cx, camera.cy]).round().astype(int)
lens_u, lens_v = lens.project(test_point)[0].round().astype(int)
difference = np.abs(undistorted[v, u].astype(int) - distorted[lens_v, lens_u].astype(int)).max()
print(
    f"pixel ({u}, {v}) of the undistorted image is ({lens_u}, {lens_v}) of the distorted one; "
    f"colors differ by {difference} of 255"
)
assert difference < 30

# %%
# For many images of the same lens, ``Undistortion`` computes the pixel map once. ``seen`` is the mask of valid pixels.

undistortion = Undistortion(lens, blank_fraction=1.0)
full_view = undistortion.apply(distorted)
print(full_view.shape, undistortion.intrinsic, f"{100 * undistortion.seen.mean():.0f} % valid pixels")
assert 0.5 < undistortion.seen.mean() < 1.0

# %%
# The distorted and the undistorted image:

image = np.hstack([distorted, undistorted])

# %%
# What to change
# --------------
# - ``blank_fraction``: 0 to 1.
# - The radial coefficients: -0.28 and 0.07. Positive values give a pincushion distortion.
# - ``size`` [pixels]: the size of the undistorted image.
#
# Next
# ----
# - :ref:`Read cameras of COLMAP, Metashape and NeRF <sphx_glr_gallery_images_plot_read_cameras.py>`
# - :doc:`Cameras and models from photographs </models>`
