"""
Repair a mesh
=============

Meshes from scanners, CAD exports and games often have defects: unconnected or inverted triangles, duplicates, isolated
parts, holes. On this page you repair a mesh with ``clean_mesh``, which reports its changes and the remaining defects.
Do this before 3D printing, simulation, boolean operations and volume measurement.
"""

import numpy as np

import pointloom as loom

# %%
# A mesh with known defects
# -------------------------
#
# The script adds six defects to a mesh of known volume. As in an STL file, each triangle has three vertices of its own.
# A tenth of the triangles is inverted, 300 are duplicated, one contains NaN, a hole is cut, and 40 isolated triangles
# are added.

original = loom.datasets.object_mesh()
assert original.is_watertight()
size = float(np.linalg.norm(original.get_max_bound() - original.get_min_bound()))
print(f"original: {len(original.triangles)} triangles, {size:.3f} m across, {original.get_volume() * 1e6:.1f} cm^3")

random = np.random.default_rng(0)
corners = original.vertices[original.triangles]  # [t, 3, 3]
centers = corners.mean(axis=1)
direction = np.array([-0.25, 1.0, -0.3])  # viewing direction of the image
hole_center = centers[np.argmin(centers @ direction)]
hole = np.linalg.norm(centers - hole_center, axis=1) < 0.06 * size
corners = corners[~hole]
is_flipped = random.random(len(corners)) < 0.1
corners[is_flipped] = corners[is_flipped][:, ::-1]
duplicates = corners[random.choice(len(corners), 300, replace=False)]
isolated = random.uniform(original.get_min_bound(), original.get_max_bound(), (40, 1, 3)) + random.normal(
    0, 0.01 * size, (40, 3, 3)
)
invalid = np.full((1, 3, 3), np.nan)
soup = np.concatenate([corners, duplicates, isolated, invalid])
broken = loom.TriangleMesh(soup.reshape(-1, 3), np.arange(len(soup) * 3).reshape(-1, 3))

parts = broken.cluster_connected_triangles()[1]
print(f"broken: {len(broken.triangles)} triangles in {len(parts)} parts")

# %%
# Repair
# ------
#
# ``hole_size`` [m] is the largest hole that is closed, given as the radius of the sphere around its boundary. Larger
# holes remain, since they may be unobserved parts of the surface. ``min_triangles`` removes parts with fewer triangles.

result = loom.meshing.clean_mesh(broken, hole_size=0.1 * size, min_triangles=100)
print(result)

# %%
# ``repair`` counts the changes, ``reliable`` is True if all quality checks passed, and ``warnings`` contains the failed
# checks. The volume is compared with the ground truth.

report = result.repair
volume = result.mesh.get_volume()
print(
    f"merged {report.merged_vertices} vertices, flipped {report.flipped_triangles} "
    f"triangles, filled {report.filled_holes} holes"
)
print(f"reliable: {result.reliable}; volume {volume * 1e6:.1f} cm^3, true {original.get_volume() * 1e6:.1f}")
assert result.is_watertight and result.mesh.is_orientable() and result.mesh.is_vertex_manifold()
assert report.removed_non_finite_triangles == 1
assert abs(volume / original.get_volume() - 1) < 0.01

# %%
# Before and after
# ----------------
#
# In the left part, back faces are not drawn, so inverted triangles and the hole appear as gaps.

shift = [1.15 * (original.get_max_bound() - original.get_min_bound())[0], 0.0, 0.0]
left, right = broken.remove_triangles_by_mask(np.isnan(soup).any(axis=(1, 2))), result.mesh.translate(shift)
view = loom.View.fit(np.vstack([left.vertices, right.vertices]), direction=direction, width=960, height=640)
scene = {
    "broken": {"geometry": left, "color": (0.85, 0.45, 0.35), "back_faces": False},
    "repaired": {"geometry": right.compute_vertex_normals(), "color": (0.45, 0.65, 0.8)},
}
image = loom.render(scene, view, (960, 640), legend=True)

# %%
# What to change
# --------------
# - ``hole_size`` [m]: 0.01 times the size leaves the hole open.
# - ``min_triangles``: 1 keeps isolated triangles.
#
# Next
# ----
# - :ref:`Mesh simplification with error measurement <sphx_glr_gallery_meshes_plot_simplify.py>`
# - :doc:`Triangle meshes </meshes>`: all checks and repairs.
