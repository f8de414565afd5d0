"""
Count trees in an airborne scan
===============================

On this page you detect treetops in an airborne laser scan, assign points to crowns, and measure heights and crown
diameters. The method uses local maxima of the height. The true classes are known, so the result is evaluated.
"""

import numpy as np

import pointloom as loom

# %%
# Heights above ground
# --------------------
# :ref:`Ground, buildings and trees <sphx_glr_gallery_clouds_plot_ground_and_buildings.py>` explains this step.
cloud = loom.datasets.terrain()
ground = cloud.select_by_mask(loom.classify_ground(cloud))
origin = cloud.get_center()
plan = loom.NearestNeighborSearch(loom.PointCloud((ground.points - origin) * [1, 1, 0]))
nearest = plan.knn_search((cloud.points - origin) * [1, 1, 0], 1)
height_above_ground = cloud.points[:, 2] - ground.points[np.ravel(nearest.indices), 2]

# %%
# Points of trees
# ---------------
# Points of trees are at least 2 m above the ground and not on smooth surfaces. In a crown, the points are distributed
# in a volume, so the smallest eigenvalue is a large fraction of the sum. On a roof it is small.
high = cloud.select_by_mask(height_above_ground > 2.0)
high["above"] = height_above_ground[height_above_ground > 2.0].astype(np.float32)
shapes = loom.compute_eigen_features(high, radius=1.5, max_nn=40)
crown = (np.nan_to_num(shapes["curvature"]) > 0.04) | (shapes["number_of_returns"] > 1)
crowns, _ = high.select_by_mask(crown).remove_radius_outlier(5, 1.5)
fraction_correct = (crowns["classification"] == 5).mean()
print(f"{len(crowns):,} points of crowns, {100 * fraction_correct:.1f} % of them are trees")
assert fraction_correct > 0.85

# %%
# Treetops
# --------
# A treetop is a point without a higher point within ``radius`` in plan view. The radius is half of the minimum distance
# of two trees [m]. If it is too small, a crown has several tops.
radius = 3.0
plan_coordinates = (crowns.points - origin) * [1, 1, 0]
neighbors = loom.NearestNeighborSearch(loom.PointCloud(plan_coordinates)).radius_search(plan_coordinates, radius)
counts = np.asarray(neighbors.counts)
owner = np.repeat(np.arange(len(crowns)), counts)
highest = np.full(len(crowns), -np.inf)
np.maximum.at(highest, owner, crowns["above"][np.ravel(neighbors.indices)])
tops = np.flatnonzero((crowns["above"] >= highest) & (crowns["above"] > 3.0))
print(f"{len(tops)} tops, {crowns['above'][tops].min():.1f} to {crowns['above'][tops].max():.1f} m high")

# %%
# Crowns
# ------
# Each point is assigned to the nearest treetop in plan view. Crowns with few points are ignored.
crown_index = np.ravel(
    loom.NearestNeighborSearch(loom.PointCloud(plan_coordinates[tops])).knn_search(plan_coordinates, 1).indices
)
size = np.bincount(crown_index, minlength=len(tops))
trees = np.flatnonzero(size >= 40)
print(f"{len(trees)} trees of at least 40 points")

# %%
# Evaluation
# ----------
# The true tree points are clustered, which separates trees whose crowns do not touch. Each cluster should contain a
# treetop.
true = cloud.select_by_mask(cloud["classification"] == 5)
groups = true.cluster_dbscan(1.2, 8)
large_groups = np.flatnonzero(np.bincount(groups[groups >= 0]) >= 60)
tree_tops = loom.PointCloud(plan_coordinates[tops[trees]])
to_top = [
    loom.PointCloud((true.points[groups == k] - origin) * [1, 1, 0]).compute_point_cloud_distance(tree_tops).min()
    for k in large_groups
]
recall = np.mean(np.array(to_top) < 1.0)
print(f"{100 * recall:.0f} % of {len(large_groups)} groups of true trees contain a detected top")
assert recall > 0.9
on_tree = crowns["classification"][tops[trees]] == 5
print(f"{100 * on_tree.mean():.0f} % of the tops are on a tree")
assert on_tree.mean() > 0.8

# %%
# Heights and crown diameters
# ---------------------------
# The diameter follows from the area of the crown in plan view.
heights = crowns["above"][tops[trees]]
width = np.array(
    [
        2
        * np.sqrt(
            loom.PointCloud(plan_coordinates[crown_index == k]).voxel_down_sample(0.5).points.shape[0] * 0.25 / np.pi
        )
        for k in trees
    ]
)
print(f"median height {np.median(heights):.1f} m, median crown diameter {np.median(width):.1f} m")

rng = np.random.default_rng(2)
palette = np.column_stack(
    [rng.uniform(0.1, 0.9, len(tops)), rng.uniform(0.4, 0.9, len(tops)), rng.uniform(0.1, 0.6, len(tops))]
)
stems = loom.LineSet(
    np.vstack([crowns.points[tops[trees]], crowns.points[tops[trees]] - np.c_[np.zeros((len(trees), 2)), heights]]),
    np.column_stack([np.arange(len(trees)), np.arange(len(trees)) + len(trees)]).astype(np.int32),
)
image = loom.render(
    [
        ground.voxel_down_sample(0.8).paint_uniform_color([0.8, 0.76, 0.66]),
        loom.PointCloud(crowns.points, colors=palette[crown_index]),
        {"geometry": stems, "color": (0.35, 0.2, 0.1), "line_width": 3},
    ],
    loom.View.fit(cloud.points, direction=(-0.35, 0.7, -0.5), width=960, height=640),
)

# %%
# What to change
# --------------
# - ``radius`` [m]: 1.5 splits crowns, 6 merges adjacent trees.
# - The minimum height [m]: 3.0 excludes bushes.
# - The minimum of 40 points per tree: depends on the point density.
#
# Next
# ----
# - :ref:`Terrain model with hillshade and contour lines <sphx_glr_gallery_clouds_plot_terrain_and_hillshade.py>`
# - :doc:`Ground classification and terrain models </terrain>`
