"""
Isotropic remeshing and subdivision
===================================

Simulation and learning need triangles of uniform size and good shape. On this page you create them with
``remesh_isotropic``, smooth a coarse mesh with ``subdivide_loop``, and increase the number of triangles without
changing the surface with ``subdivide_midpoint``.
"""

import numpy as np

import pointloom as loom

# %%
# Triangle quality
# ----------------
#
# CAD exports contain long, narrow triangles. The smallest angle of each triangle measures the quality. The optimum is
# 60 degrees.


def smallest_angles(mesh):
    """The smallest angle of each triangle [degrees]."""
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles], 1, 0)
    sides = np.sort(
        [np.linalg.norm(b - c, axis=1), np.linalg.norm(c - a, axis=1), np.linalg.norm(a - b, axis=1)], axis=0
    )
    cosine = (sides[1] ** 2 + sides[2] ** 2 - sides[0] ** 2) / (2 * sides[1] * sides[2])
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
circle = np.column_stack([np.cos(angles), np.sin(angles)])
plate = loom.TriangleMesh.from_polygon(
    [[0, 0], [0.12, 0], [0.12, 0.08], [0, 0.08]], [0.025 * circle[::-1] + [0.045, 0.04]]
)
part = plate.extrude_linear([0, 0, 0.03])
print(
    f"before: {len(part.triangles)} triangles, mean of the smallest angles {smallest_angles(part).mean():.1f} degrees"
)

# %%
# Remesh to edges of 4 mm
# -----------------------
#
# Boundaries and edges with an angle above ``feature_angle`` (30 degrees) are preserved.

remeshed = part.remesh_isotropic(0.004)
edges = loom.LineSet.create_from_triangle_mesh(remeshed)
lengths = np.linalg.norm(np.diff(edges.points[edges.lines], axis=1)[:, 0], axis=1)
print(
    f"after: {len(remeshed.triangles)} triangles, "
    f"mean of the smallest angles {smallest_angles(remeshed).mean():.1f} degrees"
)
print(f"edges {lengths.mean() * 1e3:.2f} mm mean, 90 % from {np.quantile(lengths, 0.05) * 1e3:.2f} to "
      f"{np.quantile(lengths, 0.95) * 1e3:.2f}")  # fmt: skip
difference = loom.meshing.compare_meshes(remeshed, part, samples=20_000)
print(f"the surface moved by {max(difference.metrics.mean) * 1e6:.1f} um (mean)")
assert remeshed.is_watertight() and smallest_angles(remeshed).mean() > 45
assert abs(remeshed.get_volume() / part.get_volume() - 1) < 0.005
assert 0.8 < lengths.mean() / 0.004 < 1.2

# %%
# Subdivision
# -----------
#
# Each step of both methods replaces a triangle by four. Loop subdivision moves vertices to a smooth limit surface, so
# the volume of a cube decreases. Midpoint subdivision does not change the shape.

cube = loom.TriangleMesh.create_box(0.07, 0.07, 0.07)
smooth, by_midpoints = cube.subdivide_loop(4), cube.subdivide_midpoint(4)
assert len(smooth.triangles) == len(by_midpoints.triangles) == 4**4 * 12
assert np.isclose(by_midpoints.get_volume(), cube.get_volume()) and smooth.get_volume() < 0.6 * cube.get_volume()
print(
    f"cube {cube.get_volume() * 1e6:.0f} cm^3, midpoints "
    f"{by_midpoints.get_volume() * 1e6:.0f}, Loop {smooth.get_volume() * 1e6:.0f}"
)

# %%
# The part before and after remeshing, the cube, and the cube after two steps of Loop subdivision:

meshes = [
    part,
    remeshed.translate([0.15, 0, 0]),
    cube.translate([0.3, 0.01, 0]),
    cube.subdivide_loop(2).translate([0.39, 0.01, 0]),
]
colors = [(0.85, 0.6, 0.45), (0.55, 0.7, 0.82), (0.85, 0.6, 0.45), (0.55, 0.7, 0.82)]
scene = [{"geometry": mesh, "color": color, "wireframe": True} for mesh, color in zip(meshes, colors, strict=False)]
view = {"front": [0.15, -1, 1.1], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.37}
image = loom.render(scene, view, (960, 640), shading="flat")

# %%
# What to change
# --------------
# - The edge length [m]: 0.002 instead of 0.004 has four times as many triangles.
# - ``feature_angle`` [degrees]: 100 does not preserve the edges of the part.
# - The steps of subdivision: each one multiplies the number of triangles by 4.
#
# Next
# ----
# - :ref:`Mesh simplification with error measurement <sphx_glr_gallery_meshes_plot_simplify.py>`
# - :ref:`As-rigid-as-possible deformation <sphx_glr_gallery_meshes_plot_deform.py>`
