"""
Planes and objects of a room
============================

On this page you segment the planes of a room (floor, walls, table tops), cluster the remaining points to objects, and
compute the minimal bounding box of each object. Robots use this for grasping, surveyors for floor plans.
"""

import numpy as np

import pointloom as loom

# %%
# A furnished room
# ----------------
# The cloud is in meters, has normals and colors, and is downsampled to 3 cm.
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
print(room)

# %%
# Plane segmentation
# ------------------
# ``segment_planes`` finds the plane with the most points, removes its points, and repeats. The distance threshold of 3
# cm must exceed the noise. Planes with fewer than ``min_points`` are ignored. Points with label -1 are on no plane.
labels, planes = room.segment_planes(0.03, num_iterations=400, min_points=1500, max_planes=8, seed=0)
for number, (a, b, c, d) in enumerate(planes):
    kind = "horizontal" if abs(c) > 0.98 else "vertical" if abs(c) < 0.1 else "sloped"
    print(
        f"plane {number}: {(labels == number).sum():6} points, {kind}, normal ({a:+.2f} {b:+.2f} {c:+.2f}), d "
        f"{d:+.2f} m"
    )
is_horizontal = np.abs(planes[:, 2]) > 0.98
is_vertical = np.abs(planes[:, 2]) < 0.1
assert is_horizontal.sum() >= 1  # the floor
assert is_vertical.sum() >= 2  # walls
low = room.get_min_bound()[2]
floor = np.argmin(
    [abs(-d / c - low) if flat else np.inf for (a, b, c, d), flat in zip(planes, is_horizontal, strict=True)]
)
print(f"the floor is plane {floor}")
palette = np.array(
    [
        (0.9, 0.35, 0.2),
        (0.2, 0.55, 0.85),
        (0.3, 0.7, 0.35),
        (0.95, 0.7, 0.15),
        (0.6, 0.35, 0.75),
        (0.2, 0.7, 0.7),
        (0.85, 0.45, 0.65),
        (0.5, 0.5, 0.3),
        (0.82, 0.82, 0.8),
    ]
)
room.colors = palette[labels]  # the last color, gray, is that of label -1
plane_labels = [(f"plane {k}", room.points[labels == k].mean(axis=0)) for k in range(len(planes))]
view = loom.View.fit(room.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
without_ceiling = room.select_by_mask(room.points[:, 2] < low + 2.2)  # without the ceiling, which hides the interior
plane_image = loom.render({"geometry": without_ceiling, "point_size": 5}, view, labels=plane_labels)

# %%
# Clusters
# --------
# DBSCAN joins the remaining points that have at least 10 neighbors within 8 cm. Increase the radius if objects break
# into parts, and decrease it if objects merge.
remaining = room.select_by_mask((labels < 0) & (room.points[:, 2] > low + 0.05) & (room.points[:, 2] < low + 2.2))
cluster = remaining.cluster_dbscan(0.08, 10)
sizes = np.bincount(cluster[cluster >= 0])
largest = [int(k) for k in np.argsort(-sizes) if sizes[k] >= 150][:8]
objects = [remaining.select_by_mask(cluster == k) for k in largest]
print(f"{len(sizes)} clusters, {len(objects)} of at least 150 points")
assert len(objects) >= 3

# %%
# Bounding boxes
# --------------
# Each object has a minimal oriented bounding box. The lengths of its edges are the dimensions of the object.
boxes = [part.get_minimal_oriented_bounding_box() for part in objects]
for number, box in enumerate(boxes):
    print(
        f"object {number}: {len(objects[number]):5} points, "
        + " x ".join(f"{edge:.2f}" for edge in sorted(box.extent))
        + " m"
    )
    inside = box.scale(1.001, box.center).get_point_indices_within_bounding_box(objects[number])
    assert len(inside) == len(objects[number])

scene = {"floor": {"geometry": room.select_by_mask(labels == floor), "color": (0.85, 0.85, 0.83)}}
for number, (part, box) in enumerate(zip(objects, boxes, strict=True)):
    scene[f"object {number}"] = {"geometry": part, "color": tuple(palette[number])}
    scene[f"box {number}"] = {"geometry": box, "color": tuple(0.6 * palette[number])}
object_image = loom.render(scene, view, labels=[(f"object {k}", box.center) for k, box in enumerate(boxes)])

# %%
# What to change
# --------------
# - The distance threshold [m]: 0.01 assigns fewer points to each plane.
# - ``min_points``: a smaller value also finds smaller planes.
# - The radius of ``cluster_dbscan`` [m]: 0.15 merges adjacent objects.
#
# Next
# ----
# - :ref:`Chapter 3 <sphx_glr_chapters_plot_03_segmentation.py>`: segmentation, step by step.
# - :doc:`Shape detection </shapes>`: spheres, cylinders, cones and tori.
