"""
Cropping and hidden point removal
=================================

On this page you select a part of a cloud by an axis-aligned box, an oriented box, and a polygon in the floor plan. You
also estimate which points are visible from a given position.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

room = loom.datasets.room_cloud().voxel_down_sample(0.025)
low, high = room.get_min_bound(), room.get_max_bound()
print(room, "from", low.round(2), "to", high.round(2), "m")

# %%
# Axis-aligned box
# ----------------
# This box contains all points below 2.2 m, so the ceiling is removed. ``invert=True`` returns all other points.
# Together, both results contain each point exactly once.
lower = loom.AxisAlignedBoundingBox(low, [high[0], high[1], low[2] + 2.2])
open_room, ceiling = room.crop(lower), room.crop(lower, invert=True)
print(f"{len(open_room)} points below 2.2 m, {len(ceiling)} above")
assert len(open_room) + len(ceiling) == len(room)

# %%
# Polygon
# -------
# A polygon in the floor plan, extruded along z between two heights. It can be stored in a file of the format of
# Open3D's editor.
center = 0.5 * (low + high)
corners = center + np.array([[-1.6, -0.6, 0], [-0.4, -1.5, 0], [1.5, -0.9, 0], [1.2, 1.1, 0], [-1.0, 1.4, 0]])
polygon = loom.SelectionPolygonVolume(corners, "Z", axis_min=low[2] + 0.05, axis_max=low[2] + 2.2)
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "polygon.json"
    polygon.to_json(path)
    from_file = loom.SelectionPolygonVolume.from_json(path)
selected_rows = polygon.crop_in_polygon(room)
assert np.array_equal(selected_rows, from_file.crop_in_polygon(room))
part, rest = room.select_by_index(selected_rows), open_room
print(f"{len(part)} points are inside the polygon")
assert (part.points[:, 2] >= low[2] + 0.05).all()

# %%
# Oriented box
# ------------
# The columns of ``R`` are the axes of the box. ``extent`` contains the lengths of its edges in meters.
angle = np.radians(30)
R = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
box = loom.OrientedBoundingBox(center + np.array([0, 0, -0.5]), R, [2.0, 1.4, 1.2])
inside = room.crop(box)
local = (inside.points - box.center) @ R
print(f"{len(inside)} points in the rotated box of {box.volume():.2f} m3")
assert (np.abs(local) <= np.array([1.0, 0.7, 0.6]) + 1e-6).all()

outline = loom.LineSet(
    np.vstack([corners, corners[:1]]) * [1, 1, 0] + [0, 0, low[2] + 0.06], [[k, k + 1] for k in range(5)]
)
view = loom.View.fit(room.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
without_front_walls = open_room.crop(
    loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], high[2]])
)
crop_image = loom.render(
    [
        {"geometry": without_front_walls.paint_uniform_color([0.8, 0.8, 0.8])},
        {"geometry": part.paint_uniform_color([0.95, 0.6, 0.15]), "point_size": 6},
        {"geometry": outline, "color": (0.9, 0.3, 0.1), "line_width": 4},
        {"geometry": box, "color": (0.1, 0.4, 0.8)},
    ],
    view,
)

# %%
# Hidden point removal
# --------------------
# The points are reflected about a sphere around the viewpoint. Points on the convex hull of the result are visible
# (Katz, Tal and Basri: Direct visibility of point sets, SIGGRAPH 2007). ``radius`` is the radius of this sphere, here
# 20 times the size of the room. A larger radius classifies more points as visible. The function also returns a mesh of
# the visible points.
viewpoint = center + np.array([1.2, -1.0, 0.2])
surface, visible_rows = open_room.hidden_point_removal(viewpoint, 20 * np.linalg.norm(high - low))
visible, hidden = open_room.select_by_index(visible_rows), open_room.select_by_index(visible_rows, invert=True)
print(f"from {viewpoint.round(2)} m {len(visible)} of {len(open_room)} points are visible; {surface}")
assert len(surface.vertices) == len(visible_rows)
assert 0.1 < len(visible) / len(open_room) < 0.9

marker = loom.TriangleMesh.create_sphere(0.12).translate(viewpoint).paint_uniform_color([0.9, 0.1, 0.1])
visibility_image = loom.render(
    {
        "visible": {"geometry": visible, "color": (0.95, 0.65, 0.2)},
        "hidden": {"geometry": hidden, "color": (0.45, 0.5, 0.58)},
        "viewpoint": marker,
    },
    view,
    legend=[("visible", (0.95, 0.65, 0.2)), ("hidden", (0.45, 0.5, 0.58)), ("viewpoint", (0.9, 0.1, 0.1))],
)

# %%
# Convex hull
# -----------
# The convex hull of the selected points gives an upper bound of their volume.
hull, on_hull = part.compute_convex_hull()
print(f"hull of {len(hull.vertices)} corners, {hull.volume:.2f} m3")
assert len(on_hull) == len(hull.vertices)

# %%
# What to change
# --------------
# - The corners of the polygon and its heights ``axis_min`` and ``axis_max`` [m].
# - ``angle`` of the oriented box [degrees].
# - The radius of ``hidden_point_removal``: 5 and 200 times the size of the room. How many points are visible?
#
# Next
# ----
# - :ref:`Chapter 3 <sphx_glr_chapters_plot_03_segmentation.py>`: planes, clusters and hidden points.
# - :ref:`Ray casting: visibility, distance, occupancy <sphx_glr_gallery_meshes_plot_ray_casting.py>`: exact visibility
#   for meshes.
