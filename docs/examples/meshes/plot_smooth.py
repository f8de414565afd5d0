"""
Smooth a mesh without shrinking it
==================================

Scans are noisy. Moving each vertex to the mean of its neighbors (Laplacian) takes the noise away and the volume with
it: thin parts melt. Taubin's filter goes one step in and one step out, so the size stays. We add known noise and see
which one comes nearer to the truth.
"""

import numpy as np

import pointloom as loom

# %%
# Noise of known size
# -------------------

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
# ``smooth_mesh`` tells how far vertices moved and how the area changed. More iterations smooth more; with "laplacian"
# each of them shrinks the figure as well.

results = {name: loom.meshing.smooth_mesh(noisy, name, 30) for name in ("laplacian", "taubin")}
print(results["taubin"])

# %%
# Against the truth
# -----------------

true_volume = truth.get_volume()
errors, shrunk = {}, {}
for name, mesh in {"noisy": noisy, **{name: result.mesh for name, result in results.items()}}.items():
    compared = mesh.compute_metrics(truth, n_sampled_points=20_000)
    errors[name], shrunk[name] = max(compared.rms), 1.0 - mesh.get_volume() / true_volume
    print(f"{name:10} off by {errors[name] * 1e3:.3f} mm (rms), {100 * shrunk[name]:+.2f} % of the volume lost")
assert errors["taubin"] < 0.7 * errors["noisy"], "Taubin's filter takes noise away"
assert errors["taubin"] < errors["laplacian"] and abs(shrunk["taubin"]) < 0.2 * shrunk["laplacian"]

# %%
# ``filter_sharpen`` goes the other way: it makes edges stand out, and noise too, so smooth first. All filters leave
# colors, texture and attributes where they are.

sharp = results["taubin"].mesh.filter_sharpen(1, 0.5)
assert len(sharp.vertices) == len(noisy.vertices)

# %%
# Noisy, Laplacian, Taubin
# ------------------------

width = 1.12 * float((truth.get_max_bound() - truth.get_min_bound())[0])
shown = {"noisy": noisy, "laplacian, 30 times": results["laplacian"].mesh, "taubin, 30 times": results["taubin"].mesh}
side_by_side = [mesh.translate([i * width, 0, 0]) for i, mesh in enumerate(shown.values())]
view = loom.View.fit(
    np.vstack([mesh.vertices for mesh in side_by_side]), direction=(-0.25, 1, -0.3), width=960, height=640
)
top = truth.get_max_bound()[2] * 1.1
labels = [(name, [i * width, 0, top]) for i, name in enumerate(shown)]
scene = [{"geometry": mesh, "color": (0.83, 0.78, 0.7)} for mesh in side_by_side]
image = loom.render(scene, view, (960, 640), shading="flat", labels=labels)
