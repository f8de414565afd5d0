"""
Depth filters and normal maps
=============================

Depth images contain noise, wrong pixels at discontinuities, and holes. On this page you smooth depth without averaging
across discontinuities, remove pixels at edges, compute normals, and downsample depth images.
"""

import numpy as np

import pointloom as loom
from pointloom.cameras.depth_filters import create_depth_pyramid, create_normal_map

# %%
# A frame with and without noise
# ------------------------------
#
# Depth is float32 in meters. Depth of type uint16 needs ``depth_scale`` (1000 for millimeters). The value 0 is a
# missing measurement.

noisy = loom.datasets.room_frames(4, width=640, height=480)[3]
exact = loom.datasets.room_frames(4, width=640, height=480, noise=False)[3].depth
camera, depth = noisy.intrinsic, noisy.depth


def rmse(estimate, inner):
    """Root mean square error [mm] of valid pixels that are not at edges."""
    return 1e3 * float(np.sqrt(np.mean((estimate - exact)[inner & (estimate > 0)] ** 2)))


# %%
# Bilateral filter
# ----------------
#
# Neighbors whose depth differs by more than about ``value_sigma`` [m] have a low weight.

smooth = loom.filter_depth_bilateral(depth, kernel_size=7, value_sigma=0.05, dist_sigma=3.0, depth_scale=1.0)
inner = loom.erode_depth_edges(exact, radius=4, depth_threshold=0.1, depth_scale=1.0) > 0
inner &= (depth > 0) & (exact > 0) & (exact < 4)
print(f"rmse {rmse(depth, inner):.1f} mm as measured, {rmse(smooth, inner):.1f} mm smoothed")
assert rmse(smooth, inner) < 0.8 * rmse(depth, inner)

# %%
# Remove edges
# ------------
#
# At discontinuities, sensors measure depth between both surfaces. ``erode_depth_edges`` removes pixels within
# ``radius`` of a discontinuity.

cut = loom.erode_depth_edges(smooth, radius=2, depth_threshold=0.1, depth_scale=1.0)
print(f"{100 * (smooth > 0).mean():.1f} % of the pixels have depth, {100 * (cut > 0).mean():.1f} % without edges")
assert ((cut > 0) & (smooth == 0)).sum() == 0 and (cut > 0).sum() < (smooth > 0).sum()

# %%
# Normals
# -------
#
# A normal map has shape ``(h, w, 3)`` in camera coordinates. Missing normals are 0.

raw = create_normal_map(depth, camera, depth_scale=1.0)
normals = create_normal_map(smooth, camera, depth_scale=1.0)
true = create_normal_map(exact, camera, depth_scale=1.0)
angles = {}
for name, estimate in {"measured": raw, "smoothed": normals}.items():
    is_valid = inner & (np.linalg.norm(estimate, axis=-1) > 0.5) & (np.linalg.norm(true, axis=-1) > 0.5)
    angles[name] = float(np.degrees(np.median(np.arccos(np.clip((estimate * true).sum(axis=-1)[is_valid], -1, 1)))))
    print(f"median error of the normals of the {name} depth: {angles[name]:.1f} degrees")
assert angles["smoothed"] < 0.7 * angles["measured"]

# %%
# Image pyramid
# -------------
#
# Coarse-to-fine algorithms use a pyramid. Depth is only averaged with similar depth, color always. Pixel (u, v) of a
# level is pixel (2 u, 2 v) of the previous level, so all four camera parameters are halved. ``camera.scaled(0.5)`` is
# for images resized by area, whose borders coincide.

levels = create_depth_pyramid(smooth, 3, depth_scale=1.0)
color = loom.create_depth_pyramid(loom.RGBDImage(noisy.color, noisy.depth, depth_scale=1.0), 2)[1].color
half = loom.PinholeCameraIntrinsic(
    camera.width // 2, camera.height // 2, *(0.5 * np.array([camera.fx, camera.fy, camera.cx, camera.cy]))
)
print([level.shape for level in levels], color.shape, f"focal length {camera.fx:.0f} to {half.fx:.0f} px")
assert levels[1].shape == color.shape[:2] == (half.height, half.width)

# %%
# The point cloud before and after filtering, shaded by its normals:

images = []
for values in (depth, cut):
    cloud = loom.PointCloud.create_from_depth_image(values, camera, depth_scale=1.0, depth_trunc=3.5).estimate_normals(
        radius=0.02, max_nn=12
    )
    cloud = cloud.orient_normals_towards_camera_location([0, 0, 0])
    view = loom.View.fit(cloud.points, direction=(0.35, 0.3, 1.0), up=(0, -1, 0), width=640, height=640)
    images.append(loom.render({"geometry": cloud, "color": (0.8, 0.76, 0.7)}, view, (640, 640), shading="smooth"))
image = np.hstack(images)

# %%
# What to change
# --------------
# - ``value_sigma`` [m]: 0.01 smooths less, 0.3 averages across edges.
# - ``kernel_size`` [pixels]: larger values smooth more and take longer.
# - ``radius`` of ``erode_depth_edges`` [pixels]: each pixel removes more of the border of an object.
#
# Next
# ----
# - :ref:`Outliers of a depth camera <sphx_glr_gallery_clouds_plot_outliers_of_a_depth_camera.py>`
# - :ref:`RGB-D odometry of two frames <sphx_glr_gallery_rgbd_plot_odometry.py>`
