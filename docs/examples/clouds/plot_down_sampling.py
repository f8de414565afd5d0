"""
Thin a cloud: which way when
============================

Most steps want fewer points than a scanner gives, and evenly spread ones. Five ways of thinning are set side by
side here, each asked for about as many points, and judged by how evenly these lie. Take this page when a cloud is
too large or lies in clumps.
"""

import numpy as np

import pointloom as loom

# %%
# A sphere that a scanner saw from one side: four fifths of its points lie on a fifth of it.
rng = np.random.default_rng(0)
directions = rng.normal(size=(60_000, 3))
directions /= np.linalg.norm(directions, axis=1, keepdims=True)
is_selected = (directions[:, 0] > 0.6) | (rng.random(len(directions)) < 0.06)
cloud = loom.PointCloud(0.5 * directions[is_selected])  # 0.5 m in radius
print(cloud)

# %%
# **Voxels** keep one mean point for each cube of an edge: the first thing to try, the fastest, the same everywhere.
# The edge [m] is about the spacing that comes out. **Farthest points** add, one after the other, the point that lies
# farthest from all chosen ones: the most even, exactly as many as asked for, and the dearest. **Every k-th** and
# **random** points keep the clumps as they are. **A Poisson disk** wants a surface; here that of the true sphere.
voxels = cloud.voxel_down_sample(0.06)
count = len(voxels)
every = cloud.uniform_down_sample(len(cloud) // count)
random = cloud.random_down_sample(count / len(cloud), seed=1)
farthest = cloud.farthest_point_down_sample(count)
disk = loom.TriangleMesh.create_sphere(0.5, 40).sample_points_poisson_disk(count, seed=0)
ways = {"voxels": voxels, "farthest points": farthest, "Poisson disk": disk, "every k-th": every, "random": random}

# %%
# How even is even? The distance from each point to its nearest neighbor tells: a good spacing has a least distance
# that is not far below the median one.
lowest, median = {}, {}
for name, thin in ways.items():
    apart = thin.compute_nearest_neighbor_distance()
    lowest[name], median[name] = apart.min(), np.median(apart)
    print(
        f"{name:16} {len(thin):5} points, {1000 * median[name]:5.1f} mm apart, "
        f"the nearest {1000 * lowest[name]:5.2f} mm"
    )

assert lowest["farthest points"] > 0.8 * median["farthest points"]  # nothing crowds
assert lowest["Poisson disk"] > 0.5 * median["Poisson disk"]
assert median["random"] < 0.5 * median["voxels"]  # still in clumps
assert len(farthest) == count

# %%
# Side by side, seen from the dense side. Colors are those distances: blue crowds, red is wide.
scene, labels = {}, []
for index, (name, thin) in enumerate(ways.items()):
    shift = np.array([0.0, 1.08 * index, 0.0])
    thin["apart [mm]"] = 1000 * thin.compute_nearest_neighbor_distance()
    scene[name] = {
        "geometry": thin.translate(shift),
        "color_by": "apart [mm]",
        "colormap": "turbo",
        "limits": (0, 70),
        "point_size": 0.022,
        "metric": True,
    }
    labels.append((name, shift + np.array([0.0, 0.0, 0.62])))
corners = [[-0.5, -0.55, -0.5], [0.5, 5.6, 0.75]]
view = loom.View.fit(corners, direction=(-1.0, 0.0, -0.2), width=1120, height=320)
side_by_side = loom.render(scene, view, labels=labels, color_bar=True)

# %%
# A mean is no measured point. ``reduction="nearest"`` keeps the point nearest to it instead, with its own attributes.
# Classes are whole numbers and are not averaged in either case: between class 2 and class 6 lies no class 4.
cloud["class"] = np.where(cloud.points[:, 2] > 0, 6, 2).astype(np.int32)
thin = cloud.voxel_down_sample(0.06, reduction="nearest")
print("classes after thinning:", np.unique(thin["class"]))
assert set(np.unique(thin["class"])) <= {2, 6}
assert thin.compute_point_cloud_distance(cloud).max() == 0.0  # each was measured
assert voxels.compute_point_cloud_distance(cloud).max() > 0.001  # a mean lies up to millimeters off the sphere
