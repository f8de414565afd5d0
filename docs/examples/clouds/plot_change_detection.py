"""
Change detection between two scans
==================================

Two scans of the same scene show which objects were added and which were removed. The distance from each point to the
other scan is the measure, if both scans are registered. On this page you choose the threshold, find added and removed
objects, and compute summary metrics.
"""

import numpy as np

import pointloom as loom

# %%
# Two registered scans
# --------------------
# Both scans of a room are in the same coordinate system in meters. In the second one, a box is added and the objects in
# a corner are removed. Each scan has its own points and noise of 3 mm.
room = loom.datasets.room_cloud()
rng = np.random.default_rng(5)
low, high = room.get_min_bound(), room.get_max_bound()
room = room.select_by_mask(room.points[:, 2] < low[2] + 2.2)
is_first = rng.random(len(room)) < 0.5
first = room.select_by_mask(is_first).voxel_down_sample(0.03)
base = room.select_by_mask(~is_first).voxel_down_sample(0.03)

floor = low[2]
removed_box = loom.AxisAlignedBoundingBox(
    [0.5 * (low[0] + high[0]), low[1] + 0.3, floor + 0.06], [high[0] - 0.3, 0.5 * (low[1] + high[1]), floor + 1.1]
)
removed_rows = removed_box.get_point_indices_within_bounding_box(base.points)
removed = base.select_by_index(removed_rows)
remaining = base.select_by_index(removed_rows, invert=True)
corner = [0.5 * (low[0] + high[0]) - 1.0, high[1] - 1.9, floor]
added = loom.TriangleMesh.create_box(0.5, 0.4, 0.35).translate(corner).sample_points_uniformly(1500, seed=3)
second = loom.PointCloud(np.vstack([remaining.points, added.points]))
truth = np.r_[np.zeros(len(remaining), bool), np.ones(len(added), bool)]
first = loom.PointCloud(first.points + rng.normal(scale=0.003, size=(len(first), 3)))
second = loom.PointCloud(second.points + rng.normal(scale=0.003, size=(len(second), 3)))
print(f"{len(first)} and {len(second)} points; {len(removed)} removed and {len(added)} added")

# %%
# Choose the threshold
# --------------------
# The distance between two scans of an unchanged surface is about the point spacing, here 3 cm. Changes below two
# spacings are not detectable. The threshold here is 8 cm.
distances = second.compute_point_cloud_distance(first)
reverse_distances = first.compute_point_cloud_distance(second)
limit = 0.08
print(f"median {1000 * np.median(distances):.0f} mm, 95th percentile {1000 * np.percentile(distances, 95):.0f} mm")
is_new, is_missing = distances > limit, reverse_distances > limit

# %%
# Cluster the changes
# -------------------
# Isolated points above the threshold are gaps in a scan. A changed object is a cluster. DBSCAN keeps clusters only.
detected_new = second.select_by_mask(is_new)
added_labels = detected_new.cluster_dbscan(0.1, 15)
detected_missing = first.select_by_mask(is_missing)
removed_labels = detected_missing.cluster_dbscan(0.1, 15)
detected_new = detected_new.select_by_mask(added_labels >= 0)
detected_missing = detected_missing.select_by_mask(removed_labels >= 0)
on_added = detected_new.compute_point_cloud_distance(added) < 0.02
print(f"added: {len(detected_new)} points, {100 * on_added.mean():.1f} % of them on the new box")
print(f"removed: {len(detected_missing)} points")
assert on_added.mean() > 0.98
assert np.linalg.norm(detected_new.get_center() - added.get_center()) < 0.15
assert len(detected_missing) > 0.3 * len(removed)

# %%
# Summary metrics
# ---------------
# ``compute_metrics`` returns the Chamfer distance and the Hausdorff distance in meters, and F-scores in percent.
chamfer, hausdorff, fscore = loom.compute_metrics(first, second, fscore_radius=[0.03, 0.08])
print(
    f"Chamfer {chamfer:.4f} m, Hausdorff {hausdorff:.2f} m, F-score within 3 cm {fscore[0]:.1f} %, within "
    f"8 cm {fscore[1]:.1f} %"
)
assert fscore[1] > fscore[0]

view = loom.View.fit(first.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
change = loom.render(
    {
        "unchanged": {"geometry": second.select_by_mask(~is_new), "color": (0.78, 0.78, 0.76)},
        "added": {"geometry": detected_new, "color": (0.1, 0.6, 0.25), "point_size": 6},
        "removed": {"geometry": detected_missing, "color": (0.85, 0.2, 0.15), "point_size": 6},
    },
    view,
    legend=True,
)

# %%
# The distances as colors:
second["distance [m]"] = distances
distance_image = loom.render(
    {"geometry": second, "color_by": "distance [m]", "limits": (0, 0.3), "colormap": "turbo"}, view, color_bar=True
)

# %%
# What to change
# --------------
# - ``limit`` [m]: 0.05 detects smaller objects and more noise.
# - ``eps`` and ``min_points`` of ``cluster_dbscan``: fewer points detect smaller changes and more noise.
# - The noise [m]: with ``scale=0.02`` the threshold must increase, too.
#
# Next
# ----
# - :doc:`Change detection between two epochs </change>`: significance tests and stable areas.
# - :ref:`Compare two meshes: distances, F-score, error map <sphx_glr_gallery_meshes_plot_compare_meshes.py>`
