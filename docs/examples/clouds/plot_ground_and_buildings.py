"""
Ground, buildings and trees in an airborne scan
===============================================

On this page you classify the ground of an airborne laser scan, compute heights above the ground, separate roofs from
trees, and fit a box to each building. The true classes are known, so each step is evaluated.
"""

import numpy as np

import pointloom as loom

# %%
# Airborne data
# -------------
# The scan has about 300,000 points on 200 x 200 m, in UTM coordinates in meters. ``classification`` contains the true
# classes (2 ground, 5 trees, 6 buildings). It is only used for the evaluation.
cloud = loom.datasets.terrain()
truth = cloud["classification"]
print(cloud, cloud.get_min_bound().round(), "to", cloud.get_max_bound().round())

# %%
# Ground classification
# ---------------------
# ``classify_ground`` computes morphological openings of the lowest points with windows of increasing size. Points above
# the opened surface are not ground. ``max_window`` must exceed half the width of the largest building [m], and
# ``slope`` must exceed the slope of the terrain. The defaults are suitable for most terrain.
is_ground = loom.classify_ground(cloud)
wrong_ground = is_ground != (truth == 2)
print(f"{100 * is_ground.mean():.1f} % ground; {100 * wrong_ground.mean():.2f} % of all points wrong")
assert wrong_ground.mean() < 0.05

# %%
# Height above ground
# -------------------
# The ground height below each point is the weighted mean of the three nearest ground points in plan view. Far from
# ground points, as below a large roof, it is less accurate.
ground = cloud.select_by_mask(is_ground)
origin = cloud.get_center()


def plan_coordinates(points):
    """Horizontal coordinates relative to the center [m]."""
    return (points - origin) * [1, 1, 0]


nearest = loom.NearestNeighborSearch(loom.PointCloud(plan_coordinates(ground.points))).knn_search(
    plan_coordinates(cloud.points), 3
)
weights = 1.0 / (np.asarray(nearest.sqdists) + 0.01)
weights /= weights.sum(axis=1, keepdims=True)
ground_height = (weights * ground.points[np.asarray(nearest.indices), 2]).sum(axis=1)
cloud["height above ground [m]"] = (cloud.points[:, 2] - ground_height).astype(np.float32)
height_above_ground = cloud["height above ground [m]"]
print(
    f"heights above ground up to {height_above_ground.max():.1f} m; median error on the true ground "
    f"{np.median(np.abs(height_above_ground[truth == 2])):.3f} m"
)
assert np.median(np.abs(height_above_ground[truth == 2])) < 0.1

# %%
# Roofs and trees
# ---------------
# Points at least 2 m above the ground belong to roofs or trees. Roofs are locally planar. Trees are not, and a pulse
# often has several returns in them: ``number_of_returns`` exceeds 1.
high = np.flatnonzero(height_above_ground > 2.0)
above_two_meters = loom.compute_eigen_features(cloud.select_by_index(high), radius=1.5, max_nn=30)
smooth = np.nan_to_num(above_two_meters["curvature"], nan=1.0) < 0.03
roof = smooth & (above_two_meters["number_of_returns"] == 1)

# %%
# Buildings
# ---------
# A building is a cluster of roof points. Points within 1.5 m are joined, and a cluster needs at least 120 points, about
# 15 square meters.
roofs = above_two_meters.select_by_mask(roof)
labels_of_roofs = roofs.cluster_dbscan(1.5, 6)
count = np.bincount(labels_of_roofs[labels_of_roofs >= 0])
buildings = [roofs.select_by_mask(labels_of_roofs == k) for k in np.flatnonzero(count >= 120)]
is_building = np.concatenate([building["classification"] == 6 for building in buildings])
true_roofs = (cloud["classification"] == 6).sum()
print(
    f"{len(buildings)} buildings; {100 * is_building.mean():.1f} % of their points are correct, which are "
    f"{100 * is_building.sum() / true_roofs:.0f} % of all building points"
)
assert is_building.mean() > 0.9
assert len(buildings) >= 3

# %%
# Bounding boxes
# --------------
# Each building has a vertical box with minimal area in plan view.
boxes, names = [], []
for number, building in enumerate(buildings):
    base = np.median(building.points[:, 2] - building["height above ground [m]"])
    plan = loom.PointCloud(
        np.vstack(
            [
                building.points * [1, 1, 0] + [0, 0, base],
                building.points * [1, 1, 0] + [0, 0, building.points[:, 2].max()],
            ]
        )
    )
    box = plan.get_minimal_oriented_bounding_box()
    boxes.append(box)
    names.append((f"{number + 1}: {building['height above ground [m]'].max():.1f} m", box.center + np.array([0, 0, 6])))
    print(
        f"building {number + 1}: " + " x ".join(f"{edge:.1f}" for edge in sorted(box.extent)[::-1]) + " m, ridge",
        f"{building['height above ground [m]'].max():.1f} m above ground",
    )

colors = np.where(is_ground[:, None], [0.72, 0.66, 0.52], [0.35, 0.6, 0.3])
colors[high[roof]] = [0.85, 0.4, 0.25]
view = loom.View.fit(cloud.points, direction=(-0.35, 0.7, -0.55), width=960, height=640)
parts = loom.render(
    [loom.PointCloud(cloud.points, colors=colors), *[{"geometry": box, "color": (0.6, 0.1, 0.1)} for box in boxes]],
    view,
    labels=names,
    legend=[("ground", (0.72, 0.66, 0.52)), ("trees and other points", (0.35, 0.6, 0.3)), ("roofs", (0.85, 0.4, 0.25))],
)

# %%
# The height above ground as a color:
heights = loom.render(
    {"geometry": cloud, "color_by": "height above ground [m]", "limits": (0, 15), "colormap": "turbo"},
    view,
    color_bar=True,
)

# %%
# What to change
# --------------
# - ``max_window`` [m] of ``classify_ground``: 5 classifies large roofs as ground.
# - The height threshold [m]: 3.0 instead of 2.0 excludes bushes and cars.
# - The minimum of 120 points: a smaller value also detects sheds.
#
# Next
# ----
# - :doc:`Ground classification and terrain models </terrain>`
# - :ref:`Count trees in an airborne scan <sphx_glr_gallery_clouds_plot_count_trees.py>`
# - :ref:`Terrain model with hillshade and contour lines <sphx_glr_gallery_clouds_plot_terrain_and_hillshade.py>`
