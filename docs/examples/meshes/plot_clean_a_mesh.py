"""
Clean a broken mesh
===================

A mesh from a scanner, a CAD export or a game is rarely whole: triangles share no vertex, some are turned inside out,
some stand there twice, crumbs float about and holes are open. ``clean_mesh`` mends what it can, and says what it did
and what is still wrong. Do this before you print, simulate, subtract or measure a volume.
"""

import numpy as np

import pointloom as loom

# %%
# A whole mesh, broken on purpose
# -------------------------------
#
# We break a figure whose true volume we know in six ways: as an STL file does, each triangle gets three vertices of its
# own; a tenth of the triangles is turned over; 300 are given twice; one is NaN; a hole is cut; and forty crumbs are
# scattered.

original = loom.datasets.object_mesh()
assert original.is_watertight()
size = float(np.linalg.norm(original.get_max_bound() - original.get_min_bound()))
print(f"original: {len(original.triangles)} triangles, {size:.3f} m across, {original.get_volume() * 1e6:.1f} cm^3")

random = np.random.default_rng(0)
corners = original.vertices[original.triangles]  # [t, 3, 3]
middles = corners.mean(axis=1)
look = np.array([-0.25, 1.0, -0.3])  # the direction in which the image looks
hole_center = middles[np.argmin(middles @ look)]
hole = np.linalg.norm(middles - hole_center, axis=1) < 0.06 * size
corners = corners[~hole]
is_flipped = random.random(len(corners)) < 0.1
corners[is_flipped] = corners[is_flipped][:, ::-1]
twice = corners[random.choice(len(corners), 300, replace=False)]
crumbs = random.uniform(original.get_min_bound(), original.get_max_bound(), (40, 1, 3)) + random.normal(
    0, 0.01 * size, (40, 3, 3)
)
nothing = np.full((1, 3, 3), np.nan)
soup = np.concatenate([corners, twice, crumbs, nothing])
broken = loom.TriangleMesh(soup.reshape(-1, 3), np.arange(len(soup) * 3).reshape(-1, 3))

parts = broken.cluster_connected_triangles()[1]
print(f"broken: {len(broken.triangles)} triangles in {len(parts)} parts")

# %%
# Mend it
# -------
#
# ``hole_size`` [m] is the largest hole that may be closed: the radius of the ball around its border. Larger ones stay,
# since a hole of that size may be the bottom of the scan. ``min_triangles`` drops parts with fewer triangles: the
# crumbs.

result = loom.meshing.clean_mesh(broken, hole_size=0.1 * size, min_triangles=100)
print(result)

# %%
# The result has the mesh and its figures. ``repair`` counts the changes, ``reliable`` is True if all quality checks
# passed, and ``warnings`` has those that failed. We also compare the mesh with the truth.

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
# Faces that look away are left out of the left half, so that turned triangles and the hole show as gaps.

side = [1.15 * (original.get_max_bound() - original.get_min_bound())[0], 0.0, 0.0]
left, right = broken.remove_triangles_by_mask(np.isnan(soup).any(axis=(1, 2))), result.mesh.translate(side)
view = loom.View.fit(np.vstack([left.vertices, right.vertices]), direction=look, width=960, height=640)
scene = {
    "broken": {"geometry": left, "color": (0.85, 0.45, 0.35), "back_faces": False},
    "mended": {"geometry": right.compute_vertex_normals(), "color": (0.45, 0.65, 0.8)},
}
image = loom.render(scene, view, (960, 640), legend=True)
