"""
Clean the cloud of a depth camera
=================================

A depth camera smears points between an edge and what lies behind it, and measures noise far away. Each has its own
cure: the first in the image, the second among the points. One noisy frame of a room is cleaned here, and what
went is counted with the truth at hand.
"""

import numpy as np

import pointloom as loom

# %%
# One frame, as the camera measured it: depth in meters, 0 where nothing came back. The same frame without noise is
# the truth.
noisy = loom.datasets.room_frames(24)[10]
exact = loom.datasets.room_frames(24, noise=False)[10]
extrinsic = np.linalg.inv(noisy.T_world_camera)


def cloud_of(depth, color=noisy.color):
    """The frame's points in the room's coordinates [m], no farther than 6 m."""
    image = loom.RGBDImage(color, depth, depth_scale=1.0, depth_trunc=6.0)
    return loom.PointCloud.create_from_rgbd_image(image, noisy.intrinsic, extrinsic)


raw, truth = cloud_of(noisy.depth), cloud_of(exact.depth)
raw["error [mm]"] = 1000 * raw.compute_point_cloud_distance(truth)
print(f"{len(raw)} points, {(raw['error [mm]'] > 30).sum()} of them more than 3 cm off")

# %%
# **In the image.** ``filter_depth_bilateral`` evens out noise within a surface and leaves jumps alone: depths that
# differ by more than some 10 cm (``value_sigma``, above the noise of the farthest wall) do not mix. Then
# ``erode_depth_edges`` drops a pixel on either side of a jump of 15 cm, where one pixel sees two surfaces.
smooth = loom.filter_depth_bilateral(noisy.depth, 7, value_sigma=0.1)
smooth = loom.erode_depth_edges(smooth, 1, 0.15)
in_image = cloud_of(smooth)
in_image["error [mm]"] = 1000 * in_image.compute_point_cloud_distance(truth)

# %%
# **Among the points.** The statistical filter drops points whose mean distance to 20 neighbors is far above what is
# usual (2 standard deviations); the radius filter those with fewer than 12 neighbors within 5 cm. The first adapts
# to the density, the second says what it means in meters.
filtered, rows = in_image.remove_statistical_outlier(20, 2.0)
filtered, rows = filtered.remove_radius_outlier(12, 0.05)

for name, cloud in {"raw": raw, "in the image": in_image, "both": filtered}.items():
    error = cloud["error [mm]"]
    print(
        f"{name:15} {len(cloud):6} points, median {np.median(error):.1f} mm off, "
        f"{100 * (error > 30).mean():.2f} % beyond 3 cm"
    )
assert (filtered["error [mm]"] > 30).mean() < 0.5 * (raw["error [mm]"] > 30).mean()
assert len(filtered) > 0.6 * len(raw)  # the room is still there

# %%
# Raw, from somewhat behind the camera, with the errors in color.
behind = noisy.T_world_camera.copy()
behind[:3, 3] -= 1.0 * behind[:3, 2]
camera = loom.PinholeCameraIntrinsic(960, 640, 620.0, 620.0, 479.5, 319.5)
style = {"color_by": "error [mm]", "limits": (0, 40), "colormap": "turbo"}
before = loom.render({"geometry": raw} | style, loom.View(camera, behind), color_bar=True)

# %%
# Cleaned.
after = loom.render({"geometry": filtered} | style, loom.View(camera, behind), color_bar=True)
