"""
Photographs with known poses to points and a mesh
=================================================

With a turntable, a robot or Metashape, the poses of photographs are known. On this page you triangulate sparse points,
which also verifies the poses, estimate the depth of each pixel, and fuse the depth maps to a cloud and a mesh.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# Photographs
# -----------
#
# The photographs are synthetic, so the ground truth is known. They are stored as files, since the matcher (COLMAP,
# extra "sfm") reads files. ``shots.poses`` are camera to world. Photogrammetry uses world to camera.

count = 8  # of 24 around the object, 15 degrees between them
shots = loom.datasets.photographs(24)
camera = shots.intrinsic.scaled(0.25)
folder = Path(tempfile.mkdtemp()) / "photos"
folder.mkdir()
names = [f"{i:02}.png" for i in range(count)]
for name, photograph in zip(names, shots.images, strict=False):
    loom.write_image(folder / name, photograph)
T_camera_world = np.linalg.inv(shots.poses[:count])
lens = loom.CameraModel.from_intrinsic(shots.intrinsic)
known = loom.SfmModel(names, [lens] * len(names), T_camera_world)

# %%
# Sparse points
# -------------
#
# The poses do not change. ``warnings`` reports poses that are inconsistent with the images: a wrong lens, a wrong
# order, mirrored axes.

settings = loom.photogrammetry.SfmSettings(max_size=480, max_features=1000)
result = loom.photogrammetry.triangulate(folder, known, settings)
model = result.model
print(model, "|", "; ".join(result.warnings) or "the poses fit")
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.object_mesh())
on_object = model.points[:, 2] > loom.datasets.object_mesh().get_min_bound()[2] + 0.01  # without the ground
error = scene.compute_distance(model.points[on_object])
print(f"{on_object.sum()} points on the object, median error {np.median(error) * 1e3:.2f} mm")
assert result.reliable and np.median(error) < 0.003

# %%
# Depth maps
# ----------
#
# To save time, the images are reduced to a quarter of the size. Each image is matched with images with a similar view
# and a sufficient baseline. Depth that fewer than two other images confirm is removed.

posed = [loom.photogrammetry.PosedCamera(camera, T) for T in T_camera_world]
small = [
    photograph.reshape(camera.height, 4, camera.width, 4, 3).mean(axis=(1, 3)).round().astype(np.uint8)
    for photograph in shots.images[:count]
]
maps = loom.photogrammetry.estimate_depth_maps(small, posed, model)
filtered = loom.photogrammetry.filter_depth_maps(maps)
errors, fractions = [], []
for depth_result, depth in zip(filtered, shots.depths, strict=False):
    true, depth_map = 0.5 * (depth[1::4, 1::4] + depth[2::4, 2::4]), np.asarray(depth_result.depth)
    known_here = (depth_map > 0) & (true > 0)
    errors.append(np.abs(depth_map - true)[known_here])
    fractions.append(known_here.sum() / (true > 0).sum())
median_error = float(np.median(np.concatenate(errors)))
print(f"{100 * np.mean(fractions):.0f} % of the pixels confirmed, median error {median_error * 1e3:.2f} mm at 0.6 m")
assert np.mean(fractions) > 0.3 and median_error < 0.003

# %%
# Cloud and mesh
# --------------
#
# The cloud has normals, colors, and the number of views of each point. ``to="tsdf"`` or ``to="poisson"`` returns a
# mesh.

cloud = loom.photogrammetry.fuse_depth_maps(filtered, small)
mesh = loom.photogrammetry.fuse_depth_maps(filtered, small, to="tsdf")
print(f"{len(cloud)} points, {np.mean(cloud['views']):.1f} views per point; mesh of {len(mesh.triangles)} triangles")
assert len(cloud) > 3000 and len(mesh.triangles) > 5000

# %%
# The cameras with the sparse points, and the mesh:

frusta = [loom.CameraFrustum(camera, T, scale=0.08, color=(0.85, 0.35, 0.1)) for T in shots.poses[:count]]
view = loom.View.fit(
    np.vstack([shots.poses[:count, :3, 3], loom.datasets.object_mesh().vertices]),
    direction=(-0.6, 1, -0.7),
    width=640,
    height=640,
)
cameras = loom.render([{"geometry": model.point_cloud(), "point_size": 3}, *frusta], view)
close_view = loom.View.fit(
    loom.datasets.object_mesh().vertices, direction=tuple(shots.poses[count // 2, :3, 2]), width=640, height=640
)
surface = loom.render({"geometry": mesh, "shaded": False}, close_view)

# %%
# What to change
# --------------
# - ``count``: 4 photographs cover less of the object.
# - ``max_features``: more features give more sparse points and take longer.
# - The scale of the images: 0.5 instead of 0.25 is more accurate and four times as slow.
#
# Next
# ----
# - :ref:`Chapter 9 <sphx_glr_chapters_plot_09_photographs_to_a_cloud.py>`: multi-view stereo, step by step.
# - :doc:`Multi-view stereo </mvs>`
# - :doc:`Video or photographs to mesh </video>`: unknown poses.
