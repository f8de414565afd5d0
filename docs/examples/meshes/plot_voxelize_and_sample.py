"""
Voxelize a mesh and sample points
=================================

Path planning uses voxels, neural networks use points. On this page you convert a mesh to surface or solid voxels with
``voxelize``, and sample points from its surface, randomly or evenly.
"""

import numpy as np

import pointloom as loom

# %%
# Voxels of 8 mm
# --------------
#
# ``solid=True`` also fills the interior and requires a closed mesh. The volume of the voxels exceeds that of the mesh
# by about half of the surface voxels.

mesh = loom.datasets.object_mesh()
shell, solid = mesh.voxelize(0.008), mesh.voxelize(0.008, solid=True)
filled = len(solid.coordinates) * 0.008**3
surface_volume = len(shell.coordinates) * 0.008**3
print(
    f"{len(shell.coordinates)} voxels on the surface, "
    f"{len(solid.coordinates)} with the interior, {np.prod(solid.counts)} in the grid"
)
print(
    f"mesh {mesh.get_volume() * 1e6:.0f} cm^3, voxels {filled * 1e6:.0f}, "
    f"minus half of the surface voxels {(filled - surface_volume / 2) * 1e6:.0f}"
)
assert abs((filled - surface_volume / 2) / mesh.get_volume() - 1) < 0.05

# %%
# Queries of a grid: occupancy of points, the voxel of a point, and the complete grid as an array.

center = mesh.get_center()
assert solid.check_if_included([center, center + 1.0]).tolist() == [True, False]
assert solid.dense()[tuple(solid.get_voxel(center))]
print(f"the center is in voxel {solid.get_voxel(center).tolist()}, dense array {solid.dense().shape}")

# %%
# Points
# ------
#
# Random samples are fast, but some are close to each other. Poisson-disk samples have a minimum distance, so the same
# number of points covers the surface more evenly. Both include colors and normals.

uniform = mesh.sample_points_uniformly(6000, seed=0)
disk = mesh.sample_points_poisson_disk(6000, seed=0)
gaps = {}
for name, cloud in {"uniform": uniform, "Poisson disk": disk}.items():
    distances = cloud.compute_nearest_neighbor_distance()
    gaps[name] = np.quantile(distances, 0.01)
    print(
        f"{name:12} {len(cloud)} points, nearest neighbor {distances.mean() * 1e3:.2f} "
        f"mm, 1st percentile {gaps[name] * 1e3:.2f} mm"
    )
assert gaps["Poisson disk"] > 4 * gaps["uniform"]

# %%
# Two voxel sizes, random points and evenly spaced points:

width = 0.24
offsets = [np.array([i * width, 0, 0]) for i in range(4)]
poses = np.tile(np.eye(4), (4, 1, 1))
poses[:, :3, 3] = offsets
fine = loom.VoxelGrid.create_from_triangle_mesh_within_bounds(mesh, 0.004, mesh.get_min_bound(), mesh.get_max_bound())
scene = [
    {"geometry": shell, "color": (0.55, 0.68, 0.8), "wireframe": True},
    {"geometry": fine, "color": (0.86, 0.66, 0.42), "pose": poses[1], "wireframe": True},
    {"geometry": uniform, "pose": poses[2], "point_size": 4},
    {"geometry": disk, "pose": poses[3], "point_size": 4},
]
top = float(mesh.get_max_bound()[2]) + 0.02
labels = [
    (name, offset + np.array([0, 0, top]))
    for name, offset in zip(["voxels of 8 mm", "voxels of 4 mm", "random", "Poisson disk"], offsets, strict=False)
]
view = {"front": [-0.2, -1, 0.3], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.36}
image = loom.render(scene, view, (1080, 600), labels=labels)

# %%
# What to change
# --------------
# - The voxel size [m]: 0.004 has about four times as many surface voxels.
# - The number of points: 1,000 instead of 6,000.
# - ``seed``: other samples with the same statistics.
#
# Next
# ----
# - :ref:`Downsampling methods <sphx_glr_gallery_clouds_plot_down_sampling.py>`
# - :doc:`Occupancy grids and distance fields </occupancy>`
