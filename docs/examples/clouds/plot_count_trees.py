"""
Count the trees of a scan
=========================

How many trees are there, how tall, and how wide are their crowns? The highest point of a crown is its top; every
other point belongs to the nearest top. This is how forests are counted from the air; the truth here says which
points are trees.
"""

import numpy as np

import pointloom as loom

# %%
# The scan, and heights above its ground (the page on ground and houses says more of that step).
cloud = loom.datasets.terrain()
ground = cloud.select_by_mask(loom.classify_ground(cloud))
origin = cloud.get_center()
plan = loom.NearestNeighborSearch(loom.PointCloud((ground.points - origin) * [1, 1, 0]))
nearest = plan.knn_search((cloud.points - origin) * [1, 1, 0], 1)
above = cloud.points[:, 2] - ground.points[np.ravel(nearest.indices), 2]

# %%
# **What belongs to trees**: 2 m and more above ground, and rough. A crown scatters points all around, so that the
# smallest eigenvalue of a neighborhood is no small part; on a roof it is.
high = cloud.select_by_mask(above > 2.0)
high["above"] = above[above > 2.0].astype(np.float32)
shapes = loom.compute_eigen_features(high, radius=1.5, max_nn=40)
crown = (np.nan_to_num(shapes["curvature"]) > 0.04) | (shapes["number_of_returns"] > 1)
crowns, _ = high.select_by_mask(crown).remove_radius_outlier(5, 1.5)
right = (crowns["classification"] == 5).mean()
print(f"{len(crowns):,} points of crowns, {100 * right:.1f} % of them are trees")
assert right > 0.85

# %%
# **Tops**: a point is one where nothing within ``radius`` in plan is higher. The radius is half of the least distance
# between two trees [m]; too small, and a crown has two tops.
radius = 3.0
flat = (crowns.points - origin) * [1, 1, 0]
around = loom.NearestNeighborSearch(loom.PointCloud(flat)).radius_search(flat, radius)
counts = np.asarray(around.counts)
owner = np.repeat(np.arange(len(crowns)), counts)
highest = np.full(len(crowns), -np.inf)
np.maximum.at(highest, owner, crowns["above"][np.ravel(around.indices)])
tops = np.flatnonzero((crowns["above"] >= highest) & (crowns["above"] > 3.0))
print(f"{len(tops)} tops, {crowns['above'][tops].min():.1f} to {crowns['above'][tops].max():.1f} m high")

# %%
# **Crowns**: each point goes to the nearest top in plan; few points are no tree.
belongs = np.ravel(loom.NearestNeighborSearch(loom.PointCloud(flat[tops])).knn_search(flat, 1).indices)
size = np.bincount(belongs, minlength=len(tops))
trees = np.flatnonzero(size >= 40)
print(f"{len(trees)} trees of at least 40 points")

# %%
# Judged by clusters of the true tree points, which are apart where crowns do not touch: each has to hold a top.
true = cloud.select_by_mask(cloud["classification"] == 5)
groups = true.cluster_dbscan(1.2, 8)
big = np.flatnonzero(np.bincount(groups[groups >= 0]) >= 60)
tree_tops = loom.PointCloud(flat[tops[trees]])
to_top = [
    loom.PointCloud((true.points[groups == k] - origin) * [1, 1, 0]).compute_point_cloud_distance(tree_tops).min()
    for k in big
]
hit = np.mean(np.array(to_top) < 1.0)
print(f"{100 * hit:.0f} % of {len(big)} groups of true trees contain a detected top")
assert hit > 0.9
on_tree = crowns["classification"][tops[trees]] == 5
print(f"{100 * on_tree.mean():.0f} % of the tops are on a tree")
assert on_tree.mean() > 0.8

# %%
# The numbers that a forester wants: heights, and crown diameters from the crown's area in plan.
heights = crowns["above"][tops[trees]]
width = np.array(
    [
        2 * np.sqrt(loom.PointCloud(flat[belongs == k]).voxel_down_sample(0.5).points.shape[0] * 0.25 / np.pi)
        for k in trees
    ]
)
print(f"heights {np.median(heights):.1f} m in the median, crowns {np.median(width):.1f} m wide")

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
        loom.PointCloud(crowns.points, colors=palette[belongs]),
        {"geometry": stems, "color": (0.35, 0.2, 0.1), "line_width": 3},
    ],
    loom.View.fit(cloud.points, direction=(-0.35, 0.7, -0.5), width=960, height=640),
)
