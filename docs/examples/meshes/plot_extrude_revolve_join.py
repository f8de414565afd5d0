"""
Create solids: extrusion, revolution, boolean operations
========================================================

On this page you create solids from outlines by extrusion, revolution and sweeping, and combine them by boolean
operations. The volumes are verified with formulas.
"""

import numpy as np

import pointloom as loom

# %%
# Linear extrusion
# ----------------
#
# The outline of a plate with two holes is a counterclockwise polygon in the plane z = 0. All lengths are in meters.

angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
circle = np.column_stack([np.cos(angles), np.sin(angles)])
outline = [[0, 0], [0.12, 0], [0.12, 0.03], [0.05, 0.08], [0, 0.08]]
holes = [0.012 * circle[::-1] + [0.095, 0.018], 0.02 * circle[::-1] + [0.03, 0.04]]
plate = loom.TriangleMesh.from_polygon(outline, holes).extrude_linear([0, 0, 0.015])

area = 0.12 * 0.08 - 0.5 * 0.07 * 0.05  # of the outline, the holes are polygons with 48 corners
drilled = 24 * np.sin(2 * np.pi / 48) * (0.012**2 + 0.02**2)
print(f"plate: {plate.get_volume() * 1e6:.3f} cm^3, exact {(area - drilled) * 0.015 * 1e6:.3f}")
assert plate.is_watertight() and np.isclose(plate.get_volume(), (area - drilled) * 0.015)

# %%
# Revolution
# ----------
#
# ``revolve`` rotates a profile of radius and height about z. A larger ``resolution`` gives a more accurate volume.

heights = np.linspace(0.0, 0.1, 40)
radii = 0.025 + 0.01 * np.sin(45 * heights)
profile = np.column_stack([np.r_[0, radii, 0], np.r_[0, heights, 0.1]])
vase = loom.TriangleMesh.revolve(profile, resolution=96)
true = np.pi * np.trapezoid(radii**2, heights)
print(f"vase: {vase.get_volume() * 1e6:.2f} cm^3, integral {true * 1e6:.2f}")
assert vase.is_watertight() and abs(vase.get_volume() / true - 1) < 0.01

# %%
# Sweep
# -----
#
# ``extrude_rotation`` sweeps a profile about an axis. With ``translation`` the result is a helix, here a spring of
# three turns.

section = loom.TriangleMesh.from_polygon(0.004 * circle[::4]).rotate(
    np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), [0, 0, 0]
)
spring = section.translate([0.028, 0, 0]).extrude_rotation(3 * 360, [0, 0, 1], resolution=180, translation=0.09)
assert spring.is_watertight()
print(f"spring: {len(spring.triangles)} triangles, {spring.get_volume() * 1e6:.2f} cm^3")

# %%
# Boolean operations
# ------------------
#
# Boolean operations require closed meshes and the extra "mesh" (``pip install "pointloom[mesh]"``, manifold3d). The
# part is the intersection of a sphere and a cube, minus three cylindrical holes.

sphere = loom.TriangleMesh.create_sphere(0.05, resolution=48)
cube = loom.TriangleMesh.create_box(0.076, 0.076, 0.076).translate([0, 0, 0], relative=False)
bore = loom.TriangleMesh.create_cylinder(0.02, 0.12, resolution=48, split=1)
quarter = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
bores = [bore, bore.rotate(quarter, [0, 0, 0]), bore.rotate(quarter[[1, 0, 2]] * [1, 1, -1], [0, 0, 0])]
rounded = sphere.boolean_intersection(cube)
cube_part = rounded
for bore_mesh in bores:
    cube_part = cube_part.boolean_difference(bore_mesh)
all_bores = bores[0].boolean_union(bores[1]).boolean_union(bores[2])
assert cube_part.is_watertight() and cube_part.euler_poincare_characteristic() == -8, "six openings that are connected"
removed = rounded.get_volume() - cube_part.get_volume()
assert np.isclose(removed, rounded.boolean_intersection(all_bores).get_volume(), rtol=1e-3)
print(f"cube: {cube_part.get_volume() * 1e6:.1f} cm^3, {removed * 1e6:.1f} cm^3 removed")

# %%
# ``a + b`` concatenates two meshes without intersecting them. ``concatenate`` does the same for any number of meshes.

positions = [[-0.16, 0.02, 0], [-0.02, 0, 0], [0.07, 0, 0], [0.19, 0, 0.038]]
solids = [plate, vase, spring, cube_part]
placed_solids = [
    mesh.translate(np.subtract(position, mesh.get_center() * [1, 1, 0]))
    for mesh, position in zip(solids, positions, strict=False)
]
joined = loom.TriangleMesh.concatenate(placed_solids)
assert len(joined.triangles) == sum(len(mesh.triangles) for mesh in solids)

colors = [(0.55, 0.66, 0.76), (0.83, 0.52, 0.38), (0.62, 0.62, 0.66), (0.87, 0.72, 0.36)]
scene = [{"geometry": mesh, "color": color} for mesh, color in zip(placed_solids, colors, strict=False)]
scene.append(
    {
        "geometry": loom.TriangleMesh.create_box(0.46, 0.16, 0.004).translate([-0.225, -0.08, -0.0041]),
        "color": (0.93, 0.93, 0.92),
    }
)
view = {"front": [0.1, -1, 0.75], "up": [0, 0, 1], "field_of_view": 30, "zoom": 0.38}
image = loom.render(scene, view, (960, 640))

# %%
# What to change
# --------------
# - ``resolution`` of ``revolve``: 12 instead of 96. How large is the error of the volume?
# - The height of the extrusion [m] and the holes of the outline.
# - The radius of the bores [m]: how many openings does the part have with 0.01?
#
# Next
# ----
# - :ref:`Cut a mesh and compute sections <sphx_glr_gallery_meshes_plot_cut_and_section.py>`
# - :ref:`File formats of meshes: GLB, PLY, OBJ, STL <sphx_glr_gallery_meshes_plot_mesh_files.py>`
