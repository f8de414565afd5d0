"""
Terrain model with hillshade and contour lines
==============================================

On this page you convert an airborne scan to a regular grid of heights, compute slope and hillshade, and draw contour
lines. The grid can be written as GeoTIFF, and its heights are a NumPy array.
"""

import numpy as np

import pointloom as loom

# %%
# Ground points
# -------------
# The scan is in UTM coordinates in meters. ``loom.read_point_cloud("survey.laz")`` reads your own.
cloud = loom.datasets.terrain()
true_ground = cloud.points[np.asarray(cloud["classification"]) == 2]
is_ground = loom.classify_ground(cloud)
cloud["classification"] = np.where(is_ground, 2, 1).astype(np.uint8)
print(f"{is_ground.sum():,} of {len(cloud):,} points are ground")

# %%
# Terrain model
# -------------
# Each cell is interpolated between ground points (class 2). The cell size is 1 m. Use the spacing of your ground
# points. ``dtm.write("dtm.tif")`` writes a GeoTIFF. Rows are from north to south. They are reversed here, so that y
# increases.
cell = 1.0
dtm = loom.rasterize(cloud, cell, "dtm").fill_gaps(30)
print(dtm)
z = dtm.values[::-1].astype(float)
east = dtm.bounds[0] + cell * (np.arange(z.shape[1]) + 0.5)
north = dtm.bounds[1] + cell * (np.arange(z.shape[0]) + 0.5)
x, y = np.meshgrid(east, north)

# %%
# Measure the error
# -----------------
# The true ground points are compared with the height of the cell at their position.
columns, rows = np.floor((true_ground[:, :2] - dtm.bounds[:2]) / cell).astype(int).T
error = z[rows, columns] - true_ground[:, 2]
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
# Contour lines at intervals of 1 m connect the points between cell centers that have this height.
contours = dtm.contour_lines(1.0)
assert np.abs(contours.points[:, 2] - np.rint(contours.points[:, 2])).max() < 1e-6  # heights are integers [m]
print(contours)
contours = contours.translate([0, 0, 0.1])  # in front of the surface

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
# - ``cell`` [m]: 0.5 has four times as many cells.
# - The interval of ``contour_lines`` [m]: 0.5 instead of 1.0.
# - ``sun``: the direction of the light. A lower elevation emphasizes small features.
#
# Next
# ----
# - :doc:`Ground classification and terrain models </terrain>`
# - :ref:`Ground, buildings and trees in an airborne scan <sphx_glr_gallery_clouds_plot_ground_and_buildings.py>`
