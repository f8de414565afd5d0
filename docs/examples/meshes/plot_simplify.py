"""
Simplify a mesh, with its error
===============================

Fewer triangles load, draw and simulate faster. What matters is how far the surface moved, so ``simplify_mesh`` measures
that, both ways, and says so. Collapsing edges keeps corners and borders; merging the vertices of each voxel is quick
and blunt.
"""

import numpy as np

import pointloom as loom

# %%
# A tenth, a hundredth
# --------------------
#
# Give one of ``ratio``, ``triangles`` and ``voxel_size``. ``max_error`` [m] ends a simplification early, where the next
# collapse would move the surface further. The errors are distances [m] between the old and the new surface, measured
# from samples of either.

mesh = loom.datasets.object_mesh()
tenth = loom.meshing.simplify_mesh(mesh, ratio=0.1)
hundredth = loom.meshing.simplify_mesh(mesh, ratio=0.01)
print(tenth)

# %%
# Edges or voxels?
# ----------------
#
# Merging the vertices of voxels is quicker on very large meshes. With a voxel that leaves about as many triangles it is
# farther off.

voxel = float(np.sqrt(2.0 * mesh.get_surface_area() / len(tenth.mesh.triangles)))
blunt = loom.meshing.simplify_mesh(mesh, voxel_size=voxel)
rows = {"a tenth, by edges": tenth, "a hundredth, by edges": hundredth, f"voxels of {voxel * 1e3:.1f} mm": blunt}
for name, result in rows.items():
    print(f"{name:24} {len(result.mesh.triangles):6} triangles, rms error {result.errors.rms * 1e3:.3f} mm")
assert abs(len(tenth.mesh.triangles) / len(mesh.triangles) - 0.1) < 0.001
assert tenth.errors.rms < min(hundredth.errors.rms, blunt.errors.rms)
assert tenth.mesh.is_watertight() and tenth.reliable

# %%
# ``errors`` is ``None`` where nothing could be measured, and ``reliable`` is False if a quality check failed.
# ``to_dict()`` gives the figures.

print({key: value for key, value in tenth.to_dict().items() if not isinstance(value, (dict, list))})

# %%
# Three of them beside each other
# -------------------------------

width = 1.15 * float((mesh.get_max_bound() - mesh.get_min_bound())[0])
shown = [mesh, tenth.mesh, hundredth.mesh]
side_by_side = [reduced.translate([i * width, 0, 0]) for i, reduced in enumerate(shown)]
view = loom.View.fit(
    np.vstack([reduced.vertices for reduced in side_by_side]), direction=(-0.25, 1, -0.3), width=960, height=640
)
scene = [{"geometry": reduced, "wireframe": i > 0} for i, reduced in enumerate(side_by_side)]
top = mesh.get_max_bound()[2] * 1.1
labels = [(f"{len(reduced.triangles):,} triangles", [i * width, 0, top]) for i, reduced in enumerate(shown)]
image = loom.render(scene, view, (960, 640), shading="flat", labels=labels)
