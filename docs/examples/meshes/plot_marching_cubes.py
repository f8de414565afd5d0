"""
A surface from your own function
================================

Anything that gives a number for each place has a surface where the number passes a level: formulas, simulations, CT
scans, networks. ``marching_cubes`` takes the samples on a grid and gives a mesh with shared vertices.
"""

import numpy as np

import pointloom as loom

# %%
# A formula
# ---------
#
# The gyroid, cut by a ball: a body that 3D printers fill parts with. The field is below the level inside. ``spacing``
# [m] is the distance of samples and ``origin`` where the first one lies.

n, size = 120, 0.1
step = size / (n - 1)
x, y, z = np.meshgrid(*[np.linspace(-size / 2, size / 2, n)] * 3, indexing="ij")
wave = 2 * np.pi / 0.03
gyroid = (
    np.abs(
        np.sin(wave * x) * np.cos(wave * y) + np.sin(wave * y) * np.cos(wave * z) + np.sin(wave * z) * np.cos(wave * x)
    )
    - 0.35
)
radius = np.sqrt(x**2 + y**2 + z**2)
body = np.maximum(gyroid / wave, radius - 0.045)
mesh = loom.meshing.marching_cubes(body.astype(np.float32), 0.0, spacing=(step,) * 3, origin=(-size / 2,) * 3)
inside = (body < 0).sum() * step**3
print(f"{len(mesh.triangles)} triangles, {mesh.get_volume() * 1e6:.2f} cm^3, by counting samples {inside * 1e6:.2f}")
assert mesh.is_watertight() and abs(mesh.get_volume() / inside - 1) < 0.02

# %%
# How exact?
# ----------
#
# A distance field is linear across its surface, so vertices lie on it but for the curvature within a cell. Of a ball we
# know the truth; twice the samples are four times as exact.

for count in (20, 40, 80):
    axis = np.linspace(-1.2, 1.2, count)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    ball = loom.meshing.marching_cubes(
        (np.linalg.norm(grid, axis=-1) - 1).astype(np.float32), spacing=(axis[1] - axis[0],) * 3, origin=(-1.2,) * 3
    )
    error = np.abs(np.linalg.norm(ball.vertices, axis=1) - 1).max()
    print(f"{count}^3 samples: {len(ball.triangles):6} triangles, worst vertex off by {error:.5f} of the radius")
    assert error < 0.6 * (axis[1] - axis[0]) ** 2

# %%
# Several levels at once
# ----------------------
#
# ``create_isosurfaces`` takes a list of values, in units of samples: shells of a simulation, layers of a scan.

shells = loom.TriangleMesh.create_isosurfaces(radius.astype(np.float32), [0.02, 0.03, 0.04])
assert len(shells.cluster_connected_triangles()[1]) == 3

# %%
# The gyroid, colored by how far from the middle it is.

mesh = mesh.compute_vertex_normals()
mesh.vertex_attributes["from the middle [m]"] = np.linalg.norm(mesh.vertices, axis=1)
view = {"front": [0.6, -1, 0.55], "up": [0, 0, 1], "field_of_view": 30, "zoom": 0.62}
image = loom.render({"geometry": mesh, "color_by": "from the middle [m]", "colormap": "turbo"}, view, (960, 640))
