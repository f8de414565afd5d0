"""
Photographs with known poses to points, depth and a mesh
========================================================

A turntable, a robot or Metashape knows where each photograph was taken. ``loom.photogrammetry.triangulate`` finds
points that they share and checks the poses; ``loom.photogrammetry`` finds the depth of every pixel, keeps what several
images confirm, and makes a cloud or a mesh.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# Photographs
# -----------
#
# Made ones, round a figure on a cloth, so that the truth is known. On disk, since the matcher (COLMAP's, of the extra
# "sfm") reads files. Poses here are camera to world; photogrammetry keeps world to camera.

count = 8  # of 24 round the figure: 15 degrees apart
shots = loom.datasets.photographs(24)
camera = shots.intrinsic.scaled(0.25)
folder = Path(tempfile.mkdtemp()) / "photos"
folder.mkdir()
names = [f"{i:02}.png" for i in range(count)]
for name, taken in zip(names, shots.images, strict=False):
    loom.write_image(folder / name, taken)
T_camera_world = np.linalg.inv(shots.poses[:count])
lens = loom.CameraModel.from_intrinsic(shots.intrinsic)
known = loom.SfmModel(names, [lens] * len(names), T_camera_world)

# %%
# Points that images share
# --------------------------
#
# Poses stay as they are. ``warnings`` reports poses that do not fit the images: a wrong lens, another order,
# mirrored axes.

settings = loom.photogrammetry.SfmSettings(max_size=480, max_features=1000)
result = loom.photogrammetry.triangulate(folder, known, settings)
model = result.model
print(model, "|", "; ".join(result.warnings) or "the poses fit")
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.object_mesh())
above = model.points[:, 2] > loom.datasets.object_mesh().get_min_bound()[2] + 0.01  # not of the cloth
error = scene.compute_distance(model.points[above])
print(f"{above.sum()} points on the figure, {np.median(error) * 1e3:.2f} mm off its surface (median)")
assert result.reliable and np.median(error) < 0.003

# %%
# Depth of every pixel
# --------------------
#
# A quarter of the size here, for time. Each image is compared with others that see the same under good angles; then
# depth that fewer than two others confirm goes.

posed = [loom.photogrammetry.PosedCamera(camera, T) for T in T_camera_world]
small = [
    taken.reshape(camera.height, 4, camera.width, 4, 3).mean(axis=(1, 3)).round().astype(np.uint8)
    for taken in shots.images[:count]
]
maps = loom.photogrammetry.estimate_depth_maps(small, posed, model)
filtered = loom.photogrammetry.filter_depth_maps(maps)
errors, fractions = [], []
for one, depth in zip(filtered, shots.depths, strict=False):
    true, depth_map = 0.5 * (depth[1::4, 1::4] + depth[2::4, 2::4]), np.asarray(one.depth)
    known_here = (depth_map > 0) & (true > 0)
    errors.append(np.abs(depth_map - true)[known_here])
    fractions.append(known_here.sum() / (true > 0).sum())
middle = float(np.median(np.concatenate(errors)))
print(f"{100 * np.mean(fractions):.0f} % of the photographs is confirmed, {middle * 1e3:.2f} mm off (median) at 0.6 m")
assert np.mean(fractions) > 0.3 and middle < 0.003

# %%
# One cloud, or one mesh
# ----------------------
#
# Each place once, with normals, colors, and by how many images it was seen. ``to="tsdf"`` or ``to="poisson"`` gives
# a mesh.

cloud = loom.photogrammetry.fuse_depth_maps(filtered, small)
mesh = loom.photogrammetry.fuse_depth_maps(filtered, small, to="tsdf")
print(
    f"{len(cloud)} points, seen by {np.mean(cloud['views']):.1f} "
    f"images in the mean; mesh of {len(mesh.triangles)} triangles"
)
assert len(cloud) > 3000 and len(mesh.triangles) > 5000

# %%
# One of the photographs, the cameras with the shared points, and the mesh with its colors.

frusta = [loom.CameraFrustum(camera, T, scale=0.08, color=(0.85, 0.35, 0.1)) for T in shots.poses[:count]]
view = loom.View.fit(
    np.vstack([shots.poses[:count, :3, 3], loom.datasets.object_mesh().vertices]),
    direction=(-0.6, 1, -0.7),
    width=640,
    height=640,
)
cameras = loom.render([{"geometry": model.point_cloud(), "point_size": 3}, *frusta], view)
near = loom.View.fit(
    loom.datasets.object_mesh().vertices, direction=tuple(shots.poses[count // 2, :3, 2]), width=640, height=640
)
surface = loom.render({"geometry": mesh, "shaded": False}, near)
