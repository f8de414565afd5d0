"""
Smooth a noisy cloud, and keep its edges
========================================

Noise of a scanner makes surfaces thick. Four ways of smoothing move points back onto the surface that they were
measured on; they differ in what they do to edges and to the size of things. Judged here by the distance to the true
surface. Take this page before a surface is made, or when flat things look rough.
"""

import numpy as np

import pointloom as loom

# %%
# An owl of 30 cm, with 1.2 mm of noise along the normals.
mesh = loom.datasets.object_mesh()
exact = mesh.sample_points_uniformly(30_000, seed=3)
rng = np.random.default_rng(4)
noisy = loom.PointCloud(exact.points + exact.normals * rng.normal(scale=0.0012, size=(len(exact), 1)))
scene = loom.RaycastingScene()
scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)


def error(cloud):
    """Distance of each point from the true surface [mm]."""
    return 1000 * np.asarray(scene.compute_distance(cloud.points.astype(np.float32)))


# %%
# **MLS** fits a surface around each point and moves the point onto it: the first to try. **Bilateral** moves along
# the normal, and neighbors across an edge count little. **Laplacian** moves to the mean of its neighbors: quick,
# shrinks things and rounds edges; **Taubin** inflates in between, so that they keep their size. The radius is what to
# choose: some four times the noise, and no larger than what has to stay.
ways = {
    "noisy": noisy,
    "MLS": noisy.smooth_mls(radius=0.006, max_nn=60),
    "bilateral": noisy.estimate_normals(max_nn=30).smooth_bilateral(radius=0.006, sigma_s=0.004, sigma_r=0.002),
    "Laplacian": noisy.smooth_laplacian(iterations=3, knn=20),
    "Taubin": noisy.smooth_taubin(iterations=3, knn=20),
}
median, height = {}, {}
for name, cloud in ways.items():
    median[name] = np.median(error(cloud))
    height[name] = 1000 * np.ptp(cloud.points[:, 2])
    print(
        f"{name:10} {median[name]:.2f} mm off in the median, 95 % within {np.percentile(error(cloud), 95):.2f} "
        f"mm; {height[name]:.1f} mm tall"
    )
assert median["MLS"] < 0.7 * median["noisy"]
assert median["bilateral"] < 0.9 * median["noisy"]
assert height["Laplacian"] < height["Taubin"]  # the one shrinks

# %%
# Smoothing makes normals better, too: those that were fitted before and after, against the true ones.
for name in ("noisy", "MLS"):
    normals = ways[name].estimate_normals(max_nn=20).normals
    angle = np.degrees(np.arccos(np.abs(np.einsum("ij,ij->i", normals, exact.normals)).clip(0, 1)))
    print(f"normals of {name}: {np.median(angle):.1f} degrees off")

# %%
# The errors in color, in the order above.
drawn, labels = {}, []
for index, (name, cloud) in enumerate(ways.items()):
    shift = np.array([0.23 * index, 0.0, 0.0])
    shown = loom.PointCloud(cloud.points)
    shown["off [mm]"] = error(cloud).astype(np.float32)
    drawn[name] = {
        "geometry": shown.translate(shift),
        "color_by": "off [mm]",
        "limits": (0, 2),
        "colormap": "turbo",
        "point_size": 3,
    }
    labels.append((name, shift + np.array([0, 0, 0.175])))
corners = np.vstack([style["geometry"].points for style in drawn.values()] + [[position] for _, position in labels])
image = loom.render(
    drawn, loom.View.fit(corners, direction=(0, 1.0, -0.2), width=1120, height=400), labels=labels, color_bar=True
)
