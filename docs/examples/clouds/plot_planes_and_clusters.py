"""
Planes of a room, and the things that stand in it
=================================================

Floor, walls and table tops are planes; what is left when they are taken away falls apart into objects. That is how
a robot finds what it may grasp, and a surveyor the walls. Planes are found one after the other here, and objects by
density, each with the smallest box around it.
"""

import numpy as np

import pointloom as loom

# %%
# A furnished room, in meters, with normals and colors; 3 cm are enough to find planes.
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
print(room)

# %%
# ``segment_planes`` finds the plane with most points, takes it away and goes on. 3 cm is how far a point may lie off
# its plane: above the noise of the scanner. A plane with fewer than ``min_points`` is none; label -1 lies on none.
labels, planes = room.segment_planes(0.03, num_iterations=400, min_points=1500, max_planes=8, seed=0)
for number, (a, b, c, d) in enumerate(planes):
    kind = "level" if abs(c) > 0.98 else "upright" if abs(c) < 0.1 else "sloped"
    print(
        f"plane {number}: {(labels == number).sum():6} points, {kind}, normal ({a:+.2f} {b:+.2f} {c:+.2f}), d "
        f"{d:+.2f} m"
    )
level = np.abs(planes[:, 2]) > 0.98
upright = np.abs(planes[:, 2]) < 0.1
assert level.sum() >= 1  # the floor
assert upright.sum() >= 2  # walls
low = room.get_min_bound()[2]
floor = np.argmin([abs(-d / c - low) if flat else np.inf for (a, b, c, d), flat in zip(planes, level, strict=True)])
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
cut = room.select_by_mask(room.points[:, 2] < low + 2.2)  # without the ceiling, to look in
plane_image = loom.render({"geometry": cut, "point_size": 5}, view, labels=plane_labels)

# %%
# What is left, above the floor and below the ceiling, falls apart: DBSCAN joins points that have at least 10
# neighbors within 8 cm. Widen that radius when objects break up, narrow it when they grow together.
loose = room.select_by_mask((labels < 0) & (room.points[:, 2] > low + 0.05) & (room.points[:, 2] < low + 2.2))
cluster = loose.cluster_dbscan(0.08, 10)
sizes = np.bincount(cluster[cluster >= 0])
big = [int(k) for k in np.argsort(-sizes) if sizes[k] >= 150][:8]
objects = [loose.select_by_mask(cluster == k) for k in big]
print(f"{len(sizes)} clusters, {len(objects)} of at least 150 points")
assert len(objects) >= 3

# %%
# Each gets the smallest box that holds it, turned as it likes: its edges are the object's measures.
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
things = loom.render(scene, view, labels=[(f"object {k}", box.center) for k, box in enumerate(boxes)])
