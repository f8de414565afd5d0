"""
Remesh to an edge length, and subdivide
=======================================

Simulation, physics and learning want triangles of one size and good shape. ``remesh_isotropic`` makes them;
``subdivide_loop`` rounds a coarse cage into a smooth surface, and ``subdivide_midpoint`` makes more triangles without
moving the surface.
"""

import numpy as np

import pointloom as loom

# %%
# What is wrong with the triangles of a CAD export
# ------------------------------------------------
#
# They are needles: as few as the shape allows. We measure the smallest angle of each triangle; 60 degrees is the best
# there is.


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
    f"before: {len(part.triangles)} triangles, smallest angles {smallest_angles(part).mean():.1f} degrees in the mean"
)

# %%
# Edges of 4 mm
# -------------
#
# Borders and creases of more than ``feature_angle`` (30 degrees) stay where they are, so the part keeps its edges.

even = part.remesh_isotropic(0.004)
edges = loom.LineSet.create_from_triangle_mesh(even)
lengths = np.linalg.norm(np.diff(edges.points[edges.lines], axis=1)[:, 0], axis=1)
print(f"after: {len(even.triangles)} triangles, smallest angles {smallest_angles(even).mean():.1f} degrees in the mean")
print(f"edges {lengths.mean() * 1e3:.2f} mm in the mean, nine tenths from {np.quantile(lengths, 0.05) * 1e3:.2f} to "
      f"{np.quantile(lengths, 0.95) * 1e3:.2f}")  # fmt: skip
off = loom.meshing.compare_meshes(even, part, samples=20_000)
print(f"the surface moved by {max(off.metrics.mean) * 1e6:.1f} um in the mean")
assert even.is_watertight() and smallest_angles(even).mean() > 45
assert abs(even.get_volume() / part.get_volume() - 1) < 0.005
assert 0.8 < lengths.mean() / 0.004 < 1.2

# %%
# From a cage to a smooth surface
# -------------------------------
#
# Each round of either subdivision makes four triangles of one. Loop's moves vertices, so that the limit has no creases:
# the volume of a cube shrinks. Midpoints change nothing but the number.

cube = loom.TriangleMesh.create_box(0.07, 0.07, 0.07)
smooth, same = cube.subdivide_loop(4), cube.subdivide_midpoint(4)
assert len(smooth.triangles) == len(same.triangles) == 4**4 * 12
assert np.isclose(same.get_volume(), cube.get_volume()) and smooth.get_volume() < 0.6 * cube.get_volume()
print(
    f"cube {cube.get_volume() * 1e6:.0f} cm^3, by midpoints "
    f"{same.get_volume() * 1e6:.0f}, by Loop {smooth.get_volume() * 1e6:.0f}"
)

# %%
# The CAD part before and after, the cube as it is, and after two rounds of Loop.

shown = [
    part,
    even.translate([0.15, 0, 0]),
    cube.translate([0.3, 0.01, 0]),
    cube.subdivide_loop(2).translate([0.39, 0.01, 0]),
]
colors = [(0.85, 0.6, 0.45), (0.55, 0.7, 0.82), (0.85, 0.6, 0.45), (0.55, 0.7, 0.82)]
scene = [{"geometry": mesh, "color": color, "wireframe": True} for mesh, color in zip(shown, colors, strict=False)]
view = {"front": [0.15, -1, 1.1], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.37}
image = loom.render(scene, view, (960, 640), shading="flat")
