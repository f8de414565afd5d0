"""
Mesh smoothing without shrinkage
================================

Laplacian smoothing moves each vertex to the mean of its neighbors. It removes noise, but also shrinks the mesh, most of
all in thin parts. Taubin smoothing alternates positive and negative steps, which preserves the volume. On this page you
compare both on a mesh with known noise.
"""

import numpy as np

import pointloom as loom

# %%
# A mesh with noise
# -----------------

truth = loom.datasets.object_mesh().compute_vertex_normals()
size = float(np.linalg.norm(truth.get_max_bound() - truth.get_min_bound()))
sigma = 0.002 * size  # [m] along the normal
noise = np.random.default_rng(0).normal(0.0, sigma, (len(truth.vertices), 1))
noisy = truth.copy()
noisy.vertices = truth.vertices + noise * truth.vertex_normals
print(f"{len(truth.vertices)} vertices, {size:.3f} m across, noise of {sigma * 1e3:.2f} mm")

# %%
# Two filters
# -----------
#
# ``smooth_mesh`` reports the displacement of the vertices and the change of area. More iterations smooth more. With
# "laplacian", each iteration also shrinks the mesh.

results = {name: loom.meshing.smooth_mesh(noisy, name, 30) for name in ("laplacian", "taubin")}
print(results["taubin"])

# %%
# Accuracy
# --------

true_volume = truth.get_volume()
errors, shrunk = {}, {}
for name, mesh in {"noisy": noisy, **{name: result.mesh for name, result in results.items()}}.items():
    compared = mesh.compute_metrics(truth, n_sampled_points=20_000)
    errors[name], shrunk[name] = max(compared.rms), 1.0 - mesh.get_volume() / true_volume
    print(f"{name:10} error {errors[name] * 1e3:.3f} mm (rms), {100 * shrunk[name]:+.2f} % of the volume lost")
assert errors["taubin"] < 0.7 * errors["noisy"], "Taubin smoothing removes noise"
assert errors["taubin"] < errors["laplacian"] and abs(shrunk["taubin"]) < 0.2 * shrunk["laplacian"]

# %%
# ``filter_sharpen`` has the opposite effect: it amplifies edges and noise, so smooth first. No filter changes colors,
# texture or attributes.

sharp = results["taubin"].mesh.filter_sharpen(1, 0.5)
assert len(sharp.vertices) == len(noisy.vertices)

# %%
# Comparison
# ----------

width = 1.12 * float((truth.get_max_bound() - truth.get_min_bound())[0])
meshes = {
    "noisy": noisy,
    "Laplacian, 30 iterations": results["laplacian"].mesh,
    "Taubin, 30 iterations": results["taubin"].mesh,
}
side_by_side = [mesh.translate([i * width, 0, 0]) for i, mesh in enumerate(meshes.values())]
view = loom.View.fit(
    np.vstack([mesh.vertices for mesh in side_by_side]), direction=(-0.25, 1, -0.3), width=960, height=640
)
top = truth.get_max_bound()[2] * 1.1
labels = [(name, [i * width, 0, top]) for i, name in enumerate(meshes)]
scene = [{"geometry": mesh, "color": (0.83, 0.78, 0.7)} for mesh in side_by_side]
image = loom.render(scene, view, (960, 640), shading="flat", labels=labels)

# %%
# What to change
# --------------
# - The number of iterations: 5 and 100.
# - ``sigma`` [m]: the noise along the normals.
# - The strength 0.5 of ``filter_sharpen``.
#
# Next
# ----
# - :ref:`Smoothing of point clouds <sphx_glr_gallery_clouds_plot_smooth_a_noisy_cloud.py>`
# - :ref:`Curvature and geodesic distances <sphx_glr_gallery_meshes_plot_curvature_and_geodesics.py>`
