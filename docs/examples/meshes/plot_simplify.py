"""
Mesh simplification with error measurement
==========================================

Meshes with fewer triangles load, render and simulate faster. On this page you simplify a mesh with ``simplify_mesh``,
which also measures the error in both directions. Edge collapse preserves corners and boundaries. Vertex clustering
merges the vertices of each voxel. It is faster and less accurate.
"""

import numpy as np

import pointloom as loom

# %%
# Edge collapse
# -------------
#
# Give ``ratio``, ``triangles`` or ``voxel_size``. ``max_error`` [m] stops the simplification before the error exceeds
# it. Errors are distances [m] between samples of both surfaces.

mesh = loom.datasets.object_mesh()
tenth = loom.meshing.simplify_mesh(mesh, ratio=0.1)
hundredth = loom.meshing.simplify_mesh(mesh, ratio=0.01)
print(tenth)

# %%
# Vertex clustering
# -----------------
#
# It is faster on very large meshes. With about the same number of triangles, its error is larger.

voxel = float(np.sqrt(2.0 * mesh.get_surface_area() / len(tenth.mesh.triangles)))
clustered = loom.meshing.simplify_mesh(mesh, voxel_size=voxel)
rows = {"edge collapse, 10 %": tenth, "edge collapse, 1 %": hundredth, f"voxels of {voxel * 1e3:.1f} mm": clustered}
for name, result in rows.items():
    print(f"{name:24} {len(result.mesh.triangles):6} triangles, rms error {result.errors.rms * 1e3:.3f} mm")
assert abs(len(tenth.mesh.triangles) / len(mesh.triangles) - 0.1) < 0.001
assert tenth.errors.rms < min(hundredth.errors.rms, clustered.errors.rms)
assert tenth.mesh.is_watertight() and tenth.reliable

# %%
# ``errors`` is ``None`` if the error could not be measured. ``reliable`` is False if a quality check failed.
# ``to_dict()`` returns all values.

print({key: value for key, value in tenth.to_dict().items() if not isinstance(value, (dict, list))})

# %%
# Three levels of detail
# ----------------------

width = 1.15 * float((mesh.get_max_bound() - mesh.get_min_bound())[0])
levels = [mesh, tenth.mesh, hundredth.mesh]
side_by_side = [reduced.translate([i * width, 0, 0]) for i, reduced in enumerate(levels)]
view = loom.View.fit(
    np.vstack([reduced.vertices for reduced in side_by_side]), direction=(-0.25, 1, -0.3), width=960, height=640
)
scene = [{"geometry": reduced, "wireframe": i > 0} for i, reduced in enumerate(side_by_side)]
top = mesh.get_max_bound()[2] * 1.1
labels = [(f"{len(reduced.triangles):,} triangles", [i * width, 0, top]) for i, reduced in enumerate(levels)]
image = loom.render(scene, view, (960, 640), shading="flat", labels=labels)

# %%
# What to change
# --------------
# - ``ratio``: 0.001. Which details remain?
# - ``max_error`` [m]: 0.0005 limits the error to 0.5 mm.
# - ``voxel_size`` [m]: half the value has about four times as many triangles.
#
# Next
# ----
# - :ref:`Isotropic remeshing and subdivision <sphx_glr_gallery_meshes_plot_remesh_and_subdivide.py>`
# - :ref:`Compare two meshes: distances, F-score, error map <sphx_glr_gallery_meshes_plot_compare_meshes.py>`
