"""
Marching cubes: a surface from a scalar field
=============================================

A scalar field has an isosurface at each value: formulas, simulations, CT scans, networks. On this page you extract
isosurfaces from samples on a grid with ``marching_cubes``, as meshes with shared vertices.
"""

import numpy as np

import pointloom as loom

# %%
# A formula
# ---------
#
# The gyroid, intersected with a ball, is a structure used as infill in 3D printing. Values below the level are inside.
# ``spacing`` [m] is the distance of the samples, ``origin`` the position of the first one.

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
print(f"{len(mesh.triangles)} triangles, {mesh.get_volume() * 1e6:.2f} cm^3, sum of samples {inside * 1e6:.2f}")
assert mesh.is_watertight() and abs(mesh.get_volume() / inside - 1) < 0.02

# %%
# Accuracy
# --------
#
# A distance field is linear across its surface, so only the curvature within a cell causes an error. On a sphere, twice
# the resolution has a quarter of the error.

for count in (20, 40, 80):
    axis = np.linspace(-1.2, 1.2, count)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    sphere = loom.meshing.marching_cubes(
        (np.linalg.norm(grid, axis=-1) - 1).astype(np.float32), spacing=(axis[1] - axis[0],) * 3, origin=(-1.2,) * 3
    )
    error = np.abs(np.linalg.norm(sphere.vertices, axis=1) - 1).max()
    print(f"{count}^3 samples: {len(sphere.triangles):6} triangles, maximum error {error:.5f} of the radius")
    assert error < 0.6 * (axis[1] - axis[0]) ** 2

# %%
# Several levels
# --------------
#
# ``create_isosurfaces`` takes a list of values. The coordinates of the result are in units of samples.

shells = loom.TriangleMesh.create_isosurfaces(radius.astype(np.float32), [0.02, 0.03, 0.04])
assert len(shells.cluster_connected_triangles()[1]) == 3

# %%
# The gyroid, colored by the distance from the center:

mesh = mesh.compute_vertex_normals()
mesh.vertex_attributes["distance from the center [m]"] = np.linalg.norm(mesh.vertices, axis=1)
view = {"front": [0.6, -1, 0.55], "up": [0, 0, 1], "field_of_view": 30, "zoom": 0.62}
image = loom.render(
    {"geometry": mesh, "color_by": "distance from the center [m]", "colormap": "turbo"}, view, (960, 640)
)

# %%
# What to change
# --------------
# - ``n`` [samples]: 60 is faster, 240 has more detail.
# - The period of the gyroid [m]: 0.03.
# - The level: 0.0. A positive value makes the walls thicker.
#
# Next
# ----
# - :ref:`TSDF fusion of depth frames with known poses <sphx_glr_gallery_rgbd_plot_fuse_posed_frames.py>`: the
#   isosurface
#   of a TSDF.
# - :doc:`Occupancy grids and distance fields </occupancy>`
