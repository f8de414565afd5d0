"""
Ground, houses and trees of an airborne scan
============================================

From the points of an airborne laser scan to the heights of houses and trees above the ground, in four steps: tell
the ground from the rest, subtract it, tell roofs from crowns, and put a box around each house. The truth is known
here, so each step is judged.
"""

import numpy as np

import pointloom as loom

# %%
# Some 300,000 points of 200 by 200 m, in UTM meters. ``classification`` is the truth (2 ground, 5 trees, 6 houses)
# and is used to judge alone.
cloud = loom.datasets.terrain()
truth = cloud["classification"]
print(cloud, cloud.get_min_bound().round(), "to", cloud.get_max_bound().round())

# %%
# **Ground.** ``classify_ground`` opens the lowest points by windows of growing size; what sticks out is no ground.
# ``max_window`` has to be larger than half of the widest building [m], ``slope`` steeper than the terrain. The
# defaults suit most land.
is_ground = loom.classify_ground(cloud)
wrong_ground = is_ground != (truth == 2)
print(f"{100 * is_ground.mean():.1f} % ground; {100 * wrong_ground.mean():.2f} % of all points wrong")
assert wrong_ground.mean() < 0.05

# %%
# **Height above ground.** Under each point: the mean height of its three nearest ground points, by their distance in
# plan. Points far from any ground (under a large roof) get a coarser value.
ground = cloud.select_by_mask(is_ground)
origin = cloud.get_center()


def flat(points):
    """The points in plan, about the middle [m]."""
    return (points - origin) * [1, 1, 0]


near = loom.NearestNeighborSearch(loom.PointCloud(flat(ground.points))).knn_search(flat(cloud.points), 3)
weights = 1.0 / (np.asarray(near.sqdists) + 0.01)
weights /= weights.sum(axis=1, keepdims=True)
below = (weights * ground.points[np.asarray(near.indices), 2]).sum(axis=1)
cloud["height above ground [m]"] = (cloud.points[:, 2] - below).astype(np.float32)
above = cloud["height above ground [m]"]
print(
    f"heights above ground up to {above.max():.1f} m; of the true ground the median is "
    f"{np.median(np.abs(above[truth == 2])):.3f} m"
)
assert np.median(np.abs(above[truth == 2])) < 0.1

# %%
# **Roofs and crowns.** What stands 2 m and more above ground is one or the other. A roof is smooth: its neighbors
# lie on a plane. A crown is not, and a pulse goes through it: ``number_of_returns`` above 1 tells it.
high = np.flatnonzero(above > 2.0)
standing = loom.compute_eigen_features(cloud.select_by_index(high), radius=1.5, max_nn=30)
smooth = np.nan_to_num(standing["curvature"], nan=1.0) < 0.03
roof = smooth & (standing["number_of_returns"] == 1)

# %%
# Single points err; a house is a cluster of many. 1.5 m joins points of one roof; 120 points are some 15 m².
roofs = standing.select_by_mask(roof)
label = roofs.cluster_dbscan(1.5, 6)
count = np.bincount(label[label >= 0])
buildings = [roofs.select_by_mask(label == k) for k in np.flatnonzero(count >= 120)]
on_buildings = np.concatenate([building["classification"] == 6 for building in buildings])
true_roofs = (cloud["classification"] == 6).sum()
print(
    f"{len(buildings)} houses; {100 * on_buildings.mean():.1f} % of their points are houses, which are "
    f"{100 * on_buildings.sum() / true_roofs:.0f} % of all points of houses"
)
assert on_buildings.mean() > 0.9
assert len(buildings) >= 3

# %%
# A box around each, upright and turned in plan: its edges are the house's measures.
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
        f"house {number + 1}: " + " x ".join(f"{edge:.1f}" for edge in sorted(box.extent)[::-1]) + " m, ridge",
        f"{building['height above ground [m]'].max():.1f} m above ground",
    )

colors = np.where(is_ground[:, None], [0.72, 0.66, 0.52], [0.35, 0.6, 0.3])
colors[high[roof]] = [0.85, 0.4, 0.25]
view = loom.View.fit(cloud.points, direction=(-0.35, 0.7, -0.55), width=960, height=640)
parts = loom.render(
    [loom.PointCloud(cloud.points, colors=colors), *[{"geometry": box, "color": (0.6, 0.1, 0.1)} for box in boxes]],
    view,
    labels=names,
    legend=[("ground", (0.72, 0.66, 0.52)), ("trees and the rest", (0.35, 0.6, 0.3)), ("roofs", (0.85, 0.4, 0.25))],
)

# %%
# Heights above ground as a color.
heights = loom.render(
    {"geometry": cloud, "color_by": "height above ground [m]", "limits": (0, 15), "colormap": "turbo"},
    view,
    color_bar=True,
)
