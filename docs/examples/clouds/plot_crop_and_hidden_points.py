"""
Cut a part out, and keep what is seen
=====================================

Three ways of cutting a cloud: by a box along the axes, by a box turned as you like, and by a polygon drawn on the
floor. And one of asking what a viewer at a place would see of it, though points have no surface that could hide
others. Take this page when a scan holds more than you want.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

room = loom.datasets.room_cloud().voxel_down_sample(0.025)
low, high = room.get_min_bound(), room.get_max_bound()
print(room, "from", low.round(2), "to", high.round(2), "m")

# %%
# **A box along the axes.** Everything below 2.2 m: the ceiling goes, and one looks into the room. ``invert=True``
# keeps the rest, so that nothing is lost or counted twice.
lower = loom.AxisAlignedBoundingBox(low, [high[0], high[1], low[2] + 2.2])
open_room, ceiling = room.crop(lower), room.crop(lower, invert=True)
print(f"{len(open_room)} points below 2.2 m, {len(ceiling)} above")
assert len(open_room) + len(ceiling) == len(room)

# %%
# **A polygon**, as drawn on a plan: corners in meters, swept along z between two heights. It may be kept in a file,
# which is the one that Open3D's editor writes.
middle = 0.5 * (low + high)
corners = middle + np.array([[-1.6, -0.6, 0], [-0.4, -1.5, 0], [1.5, -0.9, 0], [1.2, 1.1, 0], [-1.0, 1.4, 0]])
polygon = loom.SelectionPolygonVolume(corners, "Z", axis_min=low[2] + 0.05, axis_max=low[2] + 2.2)
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "polygon.json"
    polygon.to_json(path)
    same = loom.SelectionPolygonVolume.from_json(path)
chosen = polygon.crop_in_polygon(room)
assert np.array_equal(chosen, same.crop_in_polygon(room))
part, rest = room.select_by_index(chosen), open_room
print(f"{len(part)} points are inside the polygon")
assert (part.points[:, 2] >= low[2] + 0.05).all()

# %%
# **A turned box**, around a thing: crop with it and the thing comes out alone. Its axes are the columns of ``R``, its
# edges ``extent`` in meters.
angle = np.radians(30)
R = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
box = loom.OrientedBoundingBox(middle + np.array([0, 0, -0.5]), R, [2.0, 1.4, 1.2])
inside = room.crop(box)
local = (inside.points - box.center) @ R
print(f"{len(inside)} points in the rotated box of {box.volume():.2f} m3")
assert (np.abs(local) <= np.array([1.0, 0.7, 0.6]) + 1e-6).all()

outline = loom.LineSet(
    np.vstack([corners, corners[:1]]) * [1, 1, 0] + [0, 0, low[2] + 0.06], [[k, k + 1] for k in range(5)]
)
view = loom.View.fit(room.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
looked_into = open_room.crop(
    loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], high[2]])
)
cut = loom.render(
    [
        {"geometry": looked_into.paint_uniform_color([0.8, 0.8, 0.8])},
        {"geometry": part.paint_uniform_color([0.95, 0.6, 0.15]), "point_size": 6},
        {"geometry": outline, "color": (0.9, 0.3, 0.1), "line_width": 4},
        {"geometry": box, "color": (0.1, 0.4, 0.8)},
    ],
    view,
)

# %%
# **What is seen** from a place: points are turned inside out about it, and those on the hull of the result are seen
# (Katz, Tal and Basri 2007). ``radius`` is that of the sphere for it: 20 times the room's size here; larger takes
# more points for seen. It gives a mesh of what is seen, too.
eye = middle + np.array([1.2, -1.0, 0.2])
surface, seen = open_room.hidden_point_removal(eye, 20 * np.linalg.norm(high - low))
visible, hidden = open_room.select_by_index(seen), open_room.select_by_index(seen, invert=True)
print(f"from {eye.round(2)} m {len(visible)} of {len(open_room)} points are seen; {surface}")
assert len(surface.vertices) == len(seen)
assert 0.1 < len(visible) / len(open_room) < 0.9

marker = loom.TriangleMesh.create_sphere(0.12).translate(eye).paint_uniform_color([0.9, 0.1, 0.1])
seen_from = loom.render(
    {
        "seen": {"geometry": visible, "color": (0.95, 0.65, 0.2)},
        "hidden": {"geometry": hidden, "color": (0.45, 0.5, 0.58)},
        "viewer": marker,
    },
    view,
    legend=[("seen", (0.95, 0.65, 0.2)), ("hidden", (0.45, 0.5, 0.58)), ("the viewer", (0.9, 0.1, 0.1))],
)

# %%
# The smallest convex body around the part on the polygon: a cheap bound of its volume.
hull, on_hull = part.compute_convex_hull()
print(f"hull of {len(hull.vertices)} corners, {hull.volume:.2f} m3")
assert len(on_hull) == len(hull.vertices)
