"""
Smoothing of point clouds
=========================

Noise of the scanner makes surfaces thick. On this page you compare four smoothing methods by their distance from the
true surface and by their effect on edges and size. Use them before surface reconstruction.
"""

import numpy as np

import pointloom as loom

# %%
# A noisy cloud
# -------------
# The object is 30 cm high. The noise is 1.2 mm along the normals.
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
# Four methods
# ------------
# MLS fits a surface around each point and projects the point onto it. It is the recommended default. Bilateral
# smoothing moves points along their normals, with a low weight of neighbors beyond an edge. Laplacian smoothing moves
# points to the mean of their neighbors. It is fast, but shrinks the object and rounds edges. Taubin smoothing
# compensates the shrinkage. The radius should be about four times the noise and smaller than the details.
methods = {
    "noisy": noisy,
    "MLS": noisy.smooth_mls(radius=0.006, max_nn=60),
    "bilateral": noisy.estimate_normals(max_nn=30).smooth_bilateral(radius=0.006, sigma_s=0.004, sigma_r=0.002),
    "Laplacian": noisy.smooth_laplacian(iterations=3, knn=20),
    "Taubin": noisy.smooth_taubin(iterations=3, knn=20),
}
median, height = {}, {}
for name, cloud in methods.items():
    median[name] = np.median(error(cloud))
    height[name] = 1000 * np.ptp(cloud.points[:, 2])
    print(
        f"{name:10} median error {median[name]:.2f} mm, 95th percentile {np.percentile(error(cloud), 95):.2f} "
        f"mm; {height[name]:.1f} mm tall"
    )
assert median["MLS"] < 0.7 * median["noisy"]
assert median["bilateral"] < 0.9 * median["noisy"]
assert height["Laplacian"] < height["Taubin"]  # Laplacian smoothing shrinks

# %%
# Smoothing also improves the normals:
for name in ("noisy", "MLS"):
    normals = methods[name].estimate_normals(max_nn=20).normals
    angle = np.degrees(np.arccos(np.abs(np.einsum("ij,ij->i", normals, exact.normals)).clip(0, 1)))
    print(f"normals of {name}: {np.median(angle):.1f} degrees median error")

# %%
# The errors as colors, in the same order:
scene_styles, labels = {}, []
for index, (name, cloud) in enumerate(methods.items()):
    shift = np.array([0.23 * index, 0.0, 0.0])
    colored = loom.PointCloud(cloud.points)
    colored["error [mm]"] = error(cloud).astype(np.float32)
    scene_styles[name] = {
        "geometry": colored.translate(shift),
        "color_by": "error [mm]",
        "limits": (0, 2),
        "colormap": "turbo",
        "point_size": 3,
    }
    labels.append((name, shift + np.array([0, 0, 0.175])))
corners = np.vstack(
    [style["geometry"].points for style in scene_styles.values()] + [[position] for _, position in labels]
)
image = loom.render(
    scene_styles,
    loom.View.fit(corners, direction=(0, 1.0, -0.2), width=1120, height=400),
    labels=labels,
    color_bar=True,
)

# %%
# What to change
# --------------
# - ``radius`` [m]: 0.003 leaves noise, 0.012 removes details.
# - ``iterations`` of the Laplacian: 10 instead of 3 shrinks the object visibly.
# - ``sigma_r`` of the bilateral filter [m]: a larger value smooths across edges.
#
# Next
# ----
# - :ref:`Mesh smoothing without shrinkage <sphx_glr_gallery_meshes_plot_smooth.py>`
# - :ref:`Chapter 11 <sphx_glr_chapters_plot_11_surfaces.py>`: surface reconstruction, which also averages noise.
