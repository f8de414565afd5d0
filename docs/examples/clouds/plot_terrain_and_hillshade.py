"""
Terrain model with hillshade and contour lines
==============================================

On this page you convert an airborne scan to a regular grid of heights, fill the gaps below buildings, compute slope and
hillshade, and draw contour lines. The grid is a NumPy array that other GIS software can use.
"""

import numpy as np

import pointloom as loom

# %%
# Ground points
# -------------
# The scan is in UTM coordinates in meters.
cloud = loom.datasets.terrain()
ground = cloud.select_by_mask(loom.classify_ground(cloud))
low, high = cloud.get_min_bound(), cloud.get_max_bound()
print(f"{len(ground):,} of {len(cloud):,} points are ground")

# %%
# Interpolate a grid
# ------------------
# Each node of the grid is the inverse-distance weighted mean of the six nearest ground points in plan view, so gaps
# below roofs are filled. The cell size is 1 m. Use the spacing of your ground points.
cell = 1.0
east = np.arange(low[0] + 1, high[0] - 1, cell)
north = np.arange(low[1] + 1, high[1] - 1, cell)
x, y = np.meshgrid(east, north)
search = loom.NearestNeighborSearch(loom.PointCloud(ground.points * [1, 1, 0], origin=low * [1, 1, 0]))
nearest = search.knn_search(np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)]), 6)
weights = 1.0 / (np.asarray(nearest.sqdists) + 0.05)
weights /= weights.sum(axis=1, keepdims=True)
z = (weights * ground.points[np.asarray(nearest.indices), 2]).sum(axis=1).reshape(x.shape)
print(f"grid of {z.shape[1]} x {z.shape[0]} nodes, {z.min():.1f} to {z.max():.1f} m")

# %%
# Measure the error
# -----------------
# The true ground points are compared with the height of the grid at their position.
true_ground = cloud.points[cloud["classification"] == 2]
columns = np.rint((true_ground[:, 0] - east[0]) / cell).astype(int)
rows = np.rint((true_ground[:, 1] - north[0]) / cell).astype(int)
inside = (columns >= 0) & (columns < len(east)) & (rows >= 0) & (rows < len(north))
error = z[rows[inside], columns[inside]] - true_ground[inside, 2]
print(f"median error {np.median(error):+.3f} m, 95th percentile {np.percentile(np.abs(error), 95):.2f} m")
assert abs(np.median(error)) < 0.05 and np.percentile(np.abs(error), 95) < 0.5

# %%
# Slope and hillshade
# -------------------
# The light comes from the northwest at an elevation of 45 degrees. The shade is 1 for surfaces that face the light.
dz_north, dz_east = np.gradient(z, cell)
normals = np.dstack([-dz_east, -dz_north, np.ones_like(z)])
normals /= np.linalg.norm(normals, axis=2, keepdims=True)
slope = np.degrees(np.arccos(normals[..., 2]))
sun = np.array([-1, 1, np.sqrt(2)]) / 2
shade = (normals @ sun).clip(0, 1)
print(f"slope: median {np.median(slope):.1f}, 99th percentile {np.percentile(slope, 99):.0f} degrees")

# %%
# Surface mesh
# ------------
# The mesh has two triangles per cell and is colored by height and shade.
rows, columns = z.shape
index = np.arange(rows * columns).reshape(rows, columns)
a, b, c, d = index[:-1, :-1].ravel(), index[:-1, 1:].ravel(), index[1:, 1:].ravel(), index[1:, :-1].ravel()
triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])]).astype(np.int32)
fraction = ((z - z.min()) / np.ptp(z))[..., None]
tint = np.array([0.45, 0.62, 0.38]) * (1 - fraction) + np.array([0.86, 0.78, 0.62]) * fraction
colors = (tint * (0.35 + 0.8 * shade[..., None])).clip(0, 1).reshape(-1, 3)
surface = loom.TriangleMesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), triangles)
surface.vertex_colors = colors
area, flat_area = surface.get_surface_area(), (rows - 1) * (columns - 1) * cell**2
print(f"{area:.0f} m2 of ground on {flat_area:.0f} m2 of map")
assert area > flat_area

# %%
# Contour lines
# -------------
# Contour lines at intervals of 1 m connect the points at which edges of the triangles cross the height.
segments = []
for level in np.arange(np.ceil(z.min()), z.max(), 1.0):
    for u, v, w in ((a, b, c), (a, c, d)):
        crossings = []
        for p, q in ((u, v), (v, w), (w, u)):
            zp, zq = z.ravel()[p], z.ravel()[q]
            with np.errstate(divide="ignore", invalid="ignore"):
                t = (level - zp) / (zq - zp)
            crosses = (zp < level) != (zq < level)
            crossing = surface.vertices[p] + np.where(crosses, t, 0)[:, None] * (
                surface.vertices[q] - surface.vertices[p]
            )
            crossings.append((crosses, crossing))
        (c0, p0), (c1, p1), (c2, p2) = crossings
        first = np.where(c0[:, None], p0, p1)
        second = np.where(c2[:, None], p2, p1)
        is_crossed = c0 | c1
        segments.append(np.stack([first[is_crossed], second[is_crossed]], axis=1))
lines = np.concatenate(segments)
assert np.abs(lines[..., 2] - np.rint(lines[..., 2])).max() < 1e-6  # heights are integers [m]
contours = loom.LineSet(
    lines.reshape(-1, 3) + np.array([0, 0, 0.1]), np.arange(2 * len(lines)).reshape(-1, 2).astype(np.int32)
)
print(contours)

view = loom.View.fit(surface.vertices, direction=(0.25, 0.7, -0.6), width=960, height=640)
relief = loom.render(
    [{"geometry": surface, "shaded": False}, {"geometry": contours, "color": (0.35, 0.25, 0.15), "line_width": 1}], view
)

# %%
# The map from above:
from_above = loom.View.fit(surface.vertices, direction=(0, 0.001, -1), up=(0, 1, 0), width=960, height=900)
map_image = loom.render(
    [{"geometry": surface, "shaded": False}, {"geometry": contours, "color": (0.35, 0.25, 0.15), "line_width": 1}],
    from_above,
)

# %%
# What to change
# --------------
# - ``cell`` [m]: 0.5 has four times as many nodes.
# - The contour interval [m] in ``np.arange``: 0.5 instead of 1.0.
# - ``sun``: the direction of the light. A lower elevation emphasizes small features.
#
# Next
# ----
# - :doc:`Ground classification and terrain models </terrain>`
# - :ref:`Ground, buildings and trees in an airborne scan <sphx_glr_gallery_clouds_plot_ground_and_buildings.py>`
