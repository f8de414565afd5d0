"""
A terrain model with hill shade and contour lines
=================================================

From a scan to a map: the ground on a regular grid, gaps under houses closed, shaded by a sun in the north-west as
maps are, with contour lines. The grid is NumPy's, so that any other program of maps can go on with it.
"""

import numpy as np

import pointloom as loom

# %%
# The ground of an airborne scan in UTM meters.
cloud = loom.datasets.terrain()
ground = cloud.select_by_mask(loom.classify_ground(cloud))
low, high = cloud.get_min_bound(), cloud.get_max_bound()
print(f"{len(ground):,} of {len(cloud):,} points are ground")

# %%
# **The grid**: cells of 1 m. Each node takes the inverse-distance mean of the 6 ground points nearest in plan, so
# that nothing stays empty: under a roof it is bridged. 1 m suits some points a square metre; take the spacing of your
# own ground points.
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
# How good is it? Ground points that the classification knows to be ground (the truth of this scan) against the grid
# at their place.
true_ground = cloud.points[cloud["classification"] == 2]
columns = np.rint((true_ground[:, 0] - east[0]) / cell).astype(int)
rows = np.rint((true_ground[:, 1] - north[0]) / cell).astype(int)
inside = (columns >= 0) & (columns < len(east)) & (rows >= 0) & (rows < len(north))
error = z[rows[inside], columns[inside]] - true_ground[inside, 2]
print(f"median {np.median(error):+.3f} m, 95 % within {np.percentile(np.abs(error), 95):.2f} m")
assert abs(np.median(error)) < 0.05 and np.percentile(np.abs(error), 95) < 0.5

# %%
# **Slope, and hill shade**: a sun in the north-west, 45 degrees up, 1 where the ground faces it.
dz_north, dz_east = np.gradient(z, cell)
normals = np.dstack([-dz_east, -dz_north, np.ones_like(z)])
normals /= np.linalg.norm(normals, axis=2, keepdims=True)
slope = np.degrees(np.arccos(normals[..., 2]))
sun = np.array([-1, 1, np.sqrt(2)]) / 2
shade = (normals @ sun).clip(0, 1)
print(f"slope: median {np.median(slope):.1f}, steepest hundredth above {np.percentile(slope, 99):.0f} degrees")

# %%
# **The surface** as a mesh: two triangles a cell, colored by height and shade.
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
# **Contour lines** every metre: where an edge of a cell crosses a height. Between two crossings of a cell goes a
# line.
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
        has = c0 | c1
        segments.append(np.stack([first[has], second[has]], axis=1))
lines = np.concatenate(segments)
assert np.abs(lines[..., 2] - np.rint(lines[..., 2])).max() < 1e-6  # each lies on a whole metre
contours = loom.LineSet(
    lines.reshape(-1, 3) + np.array([0, 0, 0.1]), np.arange(2 * len(lines)).reshape(-1, 2).astype(np.int32)
)
print(contours)

view = loom.View.fit(surface.vertices, direction=(0.25, 0.7, -0.6), width=960, height=640)
relief = loom.render(
    [{"geometry": surface, "shaded": False}, {"geometry": contours, "color": (0.35, 0.25, 0.15), "line_width": 1}], view
)

# %%
# From straight above: the map.
above = loom.View.fit(surface.vertices, direction=(0, 0.001, -1), up=(0, 1, 0), width=960, height=900)
plan = loom.render(
    [{"geometry": surface, "shaded": False}, {"geometry": contours, "color": (0.35, 0.25, 0.15), "line_width": 1}],
    above,
)
