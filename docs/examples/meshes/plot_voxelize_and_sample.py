"""
A mesh as voxels and as points
==============================

Robots plan in voxels, networks eat points. ``voxelize`` gives the cells that a surface touches, or the whole solid;
points are drawn from a surface at random or evenly spread.
"""

import numpy as np

import pointloom as loom

# %%
# Voxels of 8 mm
# --------------
#
# ``solid=True`` fills the inside; the mesh has to be closed. The volume of the filled voxels is that of the mesh and
# half of the skin.

mesh = loom.datasets.object_mesh()
shell, solid = mesh.voxelize(0.008), mesh.voxelize(0.008, solid=True)
filled = len(solid.coordinates) * 0.008**3
skin = len(shell.coordinates) * 0.008**3
print(
    f"{len(shell.coordinates)} voxels on the surface, "
    f"{len(solid.coordinates)} in all, of {np.prod(solid.counts)} in the box"
)
print(
    f"mesh {mesh.get_volume() * 1e6:.0f} cm^3, voxels {filled * 1e6:.0f}, "
    f"less half of the skin {(filled - skin / 2) * 1e6:.0f}"
)
assert abs((filled - skin / 2) / mesh.get_volume() - 1) < 0.05

# %%
# Asking a grid: is a place occupied, which voxel is it in, and the whole grid as an array for a planner.

middle = mesh.get_center()
assert solid.check_if_included([middle, middle + 1.0]).tolist() == [True, False]
assert solid.dense()[tuple(solid.get_voxel(middle))]
print(f"the middle is in voxel {solid.get_voxel(middle).tolist()}, dense array {solid.dense().shape}")

# %%
# Points
# ------
#
# Uniform samples are quick, and by chance some lie close together. Poisson-disk samples keep apart: what a network or a
# registration gets of the same number of points is more even. Colors and normals come along.

uniform = mesh.sample_points_uniformly(6000, seed=0)
disk = mesh.sample_points_poisson_disk(6000, seed=0)
gaps = {}
for name, cloud in {"uniform": uniform, "Poisson disk": disk}.items():
    distances = cloud.compute_nearest_neighbor_distance()
    gaps[name] = np.quantile(distances, 0.01)
    print(
        f"{name:12} {len(cloud)} points, nearest neighbor {distances.mean() * 1e3:.2f} "
        f"mm, 1 of 100 nearer than {gaps[name] * 1e3:.2f} mm"
    )
assert gaps["Poisson disk"] > 4 * gaps["uniform"]

# %%
# Two sizes of voxels, random points, even points.

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
    for name, offset in zip(["voxels of 8 mm", "of 4 mm", "random points", "even points"], offsets, strict=False)
]
view = {"front": [-0.2, -1, 0.3], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.36}
image = loom.render(scene, view, (1080, 600), labels=labels)
