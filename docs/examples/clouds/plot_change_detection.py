"""
What changed between two scans
==============================

Scan a place twice, and subtract: what is only in the second came, what is only in the first went. The distance from
each point to the other scan tells it, if the scans lie in one frame and one knows how far apart two scans of the
same thing lie.
"""

import numpy as np

import pointloom as loom

# %%
# Two scans of a room in one frame, in meters. In the second one a box was put onto the floor, and what stood in a
# corner was carried away. Both have their own points and 3 mm of noise, as two scans have.
room = loom.datasets.room_cloud()
rng = np.random.default_rng(5)
low, high = room.get_min_bound(), room.get_max_bound()
room = room.select_by_mask(room.points[:, 2] < low[2] + 2.2)
is_first = rng.random(len(room)) < 0.5
first = room.select_by_mask(is_first).voxel_down_sample(0.03)
base = room.select_by_mask(~is_first).voxel_down_sample(0.03)

floor = low[2]
gone_box = loom.AxisAlignedBoundingBox(
    [0.5 * (low[0] + high[0]), low[1] + 0.3, floor + 0.06], [high[0] - 0.3, 0.5 * (low[1] + high[1]), floor + 1.1]
)
gone = gone_box.get_point_indices_within_bounding_box(base.points)
went = base.select_by_index(gone)
stayed = base.select_by_index(gone, invert=True)
corner = [0.5 * (low[0] + high[0]) - 1.0, high[1] - 1.9, floor]
came = loom.TriangleMesh.create_box(0.5, 0.4, 0.35).translate(corner).sample_points_uniformly(1500, seed=3)
second = loom.PointCloud(np.vstack([stayed.points, came.points]))
truth = np.r_[np.zeros(len(stayed), bool), np.ones(len(came), bool)]
first = loom.PointCloud(first.points + rng.normal(scale=0.003, size=(len(first), 3)))
second = loom.PointCloud(second.points + rng.normal(scale=0.003, size=(len(second), 3)))
print(f"{len(first)} and {len(second)} points; {len(went)} went and {len(came)} came")

# %%
# How far do two scans of the *same* thing lie apart? About the spacing of the points, 3 cm here: nothing below two
# spacings is a change that anybody can see. 8 cm is the limit taken.
apart = second.compute_point_cloud_distance(first)
back = first.compute_point_cloud_distance(second)
limit = 0.08
print(f"median {1000 * np.median(apart):.0f} mm, 95th percentile {1000 * np.percentile(apart, 95):.0f} mm")
new, missing = apart > limit, back > limit

# %%
# Single points beyond the limit are gaps of a scan; a change is a cluster. DBSCAN keeps those.
detected_new = second.select_by_mask(new)
came_label = detected_new.cluster_dbscan(0.1, 15)
detected_missing = first.select_by_mask(missing)
went_label = detected_missing.cluster_dbscan(0.1, 15)
detected_new = detected_new.select_by_mask(came_label >= 0)
detected_missing = detected_missing.select_by_mask(went_label >= 0)
on_new = detected_new.compute_point_cloud_distance(came) < 0.02
print(f"came: {len(detected_new)} points, {100 * on_new.mean():.1f} % of them on the new box")
print(f"went: {len(detected_missing)} points")
assert on_new.mean() > 0.98
assert np.linalg.norm(detected_new.get_center() - came.get_center()) < 0.15
assert len(detected_missing) > 0.3 * len(went)

# %%
# What is one number for it? ``compute_metrics`` gives Chamfer distance, Hausdorff distance and F-scores, in meters
# and percent.
chamfer, hausdorff, fscore = loom.compute_metrics(first, second, fscore_radius=[0.03, 0.08])
print(
    f"Chamfer {chamfer:.4f} m, Hausdorff {hausdorff:.2f} m, F-score within 3 cm {fscore[0]:.1f} %, within "
    f"8 cm {fscore[1]:.1f} %"
)
assert fscore[1] > fscore[0]

view = loom.View.fit(first.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
change = loom.render(
    {
        "same": {"geometry": second.select_by_mask(~new), "color": (0.78, 0.78, 0.76)},
        "came": {"geometry": detected_new, "color": (0.1, 0.6, 0.25), "point_size": 6},
        "went": {"geometry": detected_missing, "color": (0.85, 0.2, 0.15), "point_size": 6},
    },
    view,
    legend=True,
)

# %%
# The same numbers as a color, and their distribution as a plot.
second["apart [m]"] = apart
distances = loom.render(
    {"geometry": second, "color_by": "apart [m]", "limits": (0, 0.3), "colormap": "turbo"}, view, color_bar=True
)
