"""
Depth filters and normal maps
=============================

A depth image is noisy, has flying pixels at edges and holes. Smooth it without rounding edges, cut the edges away,
make it smaller without mixing near and far, and see its normals.
"""

import numpy as np

import pointloom as loom
from pointloom.cameras.depth_filters import create_depth_pyramid, create_normal_map

# %%
# A frame with noise, and the same without
# ----------------------------------------
#
# Depth is float32 in meters here; uint16 is taken with its ``depth_scale`` (1000 for millimeters). 0 means nothing was
# measured.

noisy = loom.datasets.room_frames(4, width=640, height=480)[3]
exact = loom.datasets.room_frames(4, width=640, height=480, noise=False)[3].depth
camera, depth = noisy.intrinsic, noisy.depth


def rmse(estimate, inner):
    """Root mean square error [mm] where there is depth away from edges."""
    return 1e3 * float(np.sqrt(np.mean((estimate - exact)[inner & (estimate > 0)] ** 2)))


# %%
# Smooth, but not across edges
# ----------------------------
#
# Neighbors whose depth differs by more than about ``value_sigma`` [m] count little.

smooth = loom.filter_depth_bilateral(depth, kernel_size=7, value_sigma=0.05, dist_sigma=3.0, depth_scale=1.0)
inner = loom.erode_depth_edges(exact, radius=4, depth_threshold=0.1, depth_scale=1.0) > 0
inner &= (depth > 0) & (exact > 0) & (exact < 4)
print(f"off by {rmse(depth, inner):.1f} mm as measured, {rmse(smooth, inner):.1f} mm smoothed")
assert rmse(smooth, inner) < 0.8 * rmse(depth, inner)

# %%
# Cut edges away
# --------------
#
# Between a near and a far surface sensors measure places that are neither. ``erode_depth_edges`` blanks pixels within
# ``radius`` of a jump.

cut = loom.erode_depth_edges(smooth, radius=2, depth_threshold=0.1, depth_scale=1.0)
print(f"{100 * (smooth > 0).mean():.1f} % of the pixels have depth, {100 * (cut > 0).mean():.1f} % without edges")
assert ((cut > 0) & (smooth == 0)).sum() == 0 and (cut > 0).sum() < (smooth > 0).sum()

# %%
# Normals
# -------
#
# A unit vector a pixel in the camera's frame, shape [h, w, 3], 0 where there is none.

raw = create_normal_map(depth, camera, depth_scale=1.0)
normals = create_normal_map(smooth, camera, depth_scale=1.0)
true = create_normal_map(exact, camera, depth_scale=1.0)
angles = {}
for name, estimate in {"measured": raw, "smoothed": normals}.items():
    there = inner & (np.linalg.norm(estimate, axis=-1) > 0.5) & (np.linalg.norm(true, axis=-1) > 0.5)
    angles[name] = float(np.degrees(np.median(np.arccos(np.clip((estimate * true).sum(axis=-1)[there], -1, 1)))))
    print(f"normals of the {name} depth are off by {angles[name]:.1f} degrees (median)")
assert angles["smoothed"] < 0.7 * angles["measured"]

# %%
# Smaller images
# ----------------
#
# A pyramid for coarse-to-fine work: depth is averaged only with depth that lies near, color with all. Pixel (u, v) of
# a level lies at (2 u, 2 v) of the one before, so its camera has half of all four numbers. (``camera.scaled(0.5)`` is
# for images that were resized by area: their borders keep their place.)

levels = create_depth_pyramid(smooth, 3, depth_scale=1.0)
color = loom.create_depth_pyramid(loom.RGBDImage(noisy.color, noisy.depth, depth_scale=1.0), 2)[1].color
half = loom.PinholeCameraIntrinsic(
    camera.width // 2, camera.height // 2, *(0.5 * np.array([camera.fx, camera.fy, camera.cx, camera.cy]))
)
print([level.shape for level in levels], color.shape, f"focal length {camera.fx:.0f} to {half.fx:.0f} px")
assert levels[1].shape == color.shape[:2] == (half.height, half.width)

# %%
# The cloud of the frame as it was measured and as it is now, lit by its normals.

images = []
for values in (depth, cut):
    cloud = loom.PointCloud.create_from_depth_image(values, camera, depth_scale=1.0, depth_trunc=3.5).estimate_normals(
        radius=0.02, max_nn=12
    )
    cloud = cloud.orient_normals_towards_camera_location([0, 0, 0])
    view = loom.View.fit(cloud.points, direction=(0.35, 0.3, 1.0), up=(0, -1, 0), width=640, height=640)
    images.append(loom.render({"geometry": cloud, "color": (0.8, 0.76, 0.7)}, view, (640, 640), shading="smooth"))
image = np.hstack(images)
