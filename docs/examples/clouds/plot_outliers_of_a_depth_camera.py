"""
Outliers of a depth camera
==========================

A depth camera measures wrong depth at discontinuities, and its noise increases with the distance. On this page you
remove the former in the image and the latter among the points, and evaluate the result with the ground truth.
"""

import numpy as np

import pointloom as loom

# %%
# A noisy frame
# -------------
# The depth is in meters, and 0 where there is no measurement. The same frame without noise is the ground truth.
noisy = loom.datasets.room_frames(24)[10]
exact = loom.datasets.room_frames(24, noise=False)[10]
extrinsic = np.linalg.inv(noisy.T_world_camera)


def cloud_of(depth, color=noisy.color):
    """Points of the frame in room coordinates [m], up to 6 m from the camera."""
    image = loom.RGBDImage(color, depth, depth_scale=1.0, depth_trunc=6.0)
    return loom.PointCloud.create_from_rgbd_image(image, noisy.intrinsic, extrinsic)


raw, truth = cloud_of(noisy.depth), cloud_of(exact.depth)
raw["error [mm]"] = 1000 * raw.compute_point_cloud_distance(truth)
print(f"{len(raw)} points, {(raw['error [mm]'] > 30).sum()} of them with an error above 3 cm")

# %%
# Filters of the image
# --------------------
# ``filter_depth_bilateral`` smooths surfaces and preserves discontinuities: depths that differ by more than about
# ``value_sigma`` (10 cm, above the noise of the most distant wall) are not averaged. ``erode_depth_edges`` removes one
# pixel on both sides of discontinuities above 15 cm, where a pixel may contain two surfaces.
smooth = loom.filter_depth_bilateral(noisy.depth, 7, value_sigma=0.1)
smooth = loom.erode_depth_edges(smooth, 1, 0.15)
in_image = cloud_of(smooth)
in_image["error [mm]"] = 1000 * in_image.compute_point_cloud_distance(truth)

# %%
# Filters of the points
# ---------------------
# The statistical filter removes points whose mean distance to 20 neighbors is more than two standard deviations above
# the mean. The radius filter removes points with fewer than 12 neighbors within 5 cm. The former adapts to the density.
# The latter has a parameter in meters.
filtered, rows = in_image.remove_statistical_outlier(20, 2.0)
filtered, rows = filtered.remove_radius_outlier(12, 0.05)

for name, cloud in {"raw": raw, "in the image": in_image, "both": filtered}.items():
    error = cloud["error [mm]"]
    print(
        f"{name:15} {len(cloud):6} points, median error {np.median(error):.1f} mm, "
        f"{100 * (error > 30).mean():.2f} % beyond 3 cm"
    )
assert (filtered["error [mm]"] > 30).mean() < 0.5 * (raw["error [mm]"] > 30).mean()
assert len(filtered) > 0.6 * len(raw)  # most points remain

# %%
# The unfiltered cloud, from a position behind the camera, colored by error:
pose_behind = noisy.T_world_camera.copy()
pose_behind[:3, 3] -= 1.0 * pose_behind[:3, 2]
camera = loom.PinholeCameraIntrinsic(960, 640, 620.0, 620.0, 479.5, 319.5)
style = {"color_by": "error [mm]", "limits": (0, 40), "colormap": "turbo"}
before = loom.render({"geometry": raw} | style, loom.View(camera, pose_behind), color_bar=True)

# %%
# The filtered cloud:
after = loom.render({"geometry": filtered} | style, loom.View(camera, pose_behind), color_bar=True)

# %%
# What to change
# --------------
# - ``value_sigma`` [m]: 0.02 smooths less, 0.5 averages across edges.
# - The depth threshold of ``erode_depth_edges`` [m]: 0.05 removes more pixels.
# - The radius [m] and count of the radius filter: a smaller radius removes more distant points.
#
# Next
# ----
# - :ref:`Depth filters and normal maps <sphx_glr_gallery_rgbd_plot_depth_filters.py>`
# - :ref:`Chapter 4 <sphx_glr_chapters_plot_04_downsampling_and_outliers.py>`: outlier removal in point clouds.
