"""
TSDF fusion of depth frames with known poses
============================================

On this page you fuse depth frames with known poses to a mesh, in one call and frame by frame. Each frame provides the
signed distance of the voxels from the surface. The mean over all frames reduces the noise.
"""

import numpy as np

import pointloom as loom

# %%
# Frames
# ------
#
# The data consists of 24 frames of a trajectory through a furnished room: color, depth in meters with the noise of a
# structured-light camera, and true poses (camera to world). Use ``loom.open_dataset(folder)`` for your own data, or
# ``loom.frames_from`` for other sources.

frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
source = loom.frames_from(frames, camera, depth_scale=1.0)

# %%
# One call
# --------
#
# ``voxel_size`` [m] is the size of the smallest detail. The result contains the mesh, the volume, the fraction of used
# depth, and ``warnings`` if it is unreliable.

result = loom.rgbd.fuse(source, voxel_size=0.03)
print(result)
assert result.reliable and result.frame_count == 24

# %%
# Frame by frame
# --------------
#
# As in Open3D, ``integrate`` expects world to camera, the inverse of the pose. A mesh can be extracted after any frame.

volume = loom.TSDFVolume(voxel_size=0.03)
for frame in frames:
    volume.integrate(
        frame.depth, camera, np.linalg.inv(frame.T_world_camera), frame.color, depth_scale=1.0, depth_max=4.0
    )
mesh = volume.extract_triangle_mesh(weight_threshold=3)
print(f"{volume.block_count} blocks, {volume.memory_bytes / 1e6:.0f} MB, {len(mesh.triangles)} triangles")

# %%
# Accuracy
# --------
#
# The median error of the vertices is a few millimeters. The error of a single depth value of this camera is up to 14 mm
# at 3 m.

scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
error = scene.compute_distance(result.mesh.vertices)
print(f"fused: median {np.median(error) * 1e3:.1f} mm, 90th percentile {np.quantile(error, 0.9) * 1e3:.1f} mm")
cloud = loom.PointCloud.create_from_rgbd_image(
    loom.RGBDImage(frames[3].color, frames[3].depth, depth_scale=1.0, depth_trunc=4.0),
    camera,
    np.linalg.inv(frames[3].T_world_camera),
)
single = scene.compute_distance(cloud.points)
print(f"one frame: median {np.median(single) * 1e3:.1f} mm, 90th percentile {np.quantile(single, 0.9) * 1e3:.1f} mm")
assert np.median(error) < 0.01
assert len(mesh.triangles) > 50_000

# %%
# Ray casting of the volume
# -------------------------
#
# ``ray_cast`` computes depth, color and normals for any pose without a mesh.

cast = volume.ray_cast(camera, np.linalg.inv(frames[3].T_world_camera), depth_max=5.0)
both = (cast.depth > 0) & (frames[3].depth > 0)
print(
    f"{100 * both.mean():.0f} % of the pixels, "
    f"{np.median(np.abs(cast.depth - frames[3].depth)[both]) * 1e3:.1f} mm median difference from the frame"
)
assert both.mean() > 0.3

# %%
# The mesh and the camera poses:

path = loom.Trajectory(np.array([frame.T_world_camera for frame in frames]))
cameras = [
    loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.85, 0.3, 0.1)) for frame in frames[::2]
]
T = frames[12].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
scene_items = [
    {"geometry": result.mesh, "shaded": False, "back_faces": False},
    *cameras,
    {"geometry": path, "color": (0.1, 0.3, 0.8)},
]
image = loom.render(scene_items, view)

# %%
# What to change
# --------------
# - ``voxel_size`` [m]: 0.015 has about four times as many triangles.
# - ``weight_threshold`` [frames]: larger values remove surfaces that few frames observed.
# - ``depth_max`` [m]: 2.0 excludes distant, less accurate depth.
#
# Next
# ----
# - :ref:`Color map optimization and texture <sphx_glr_gallery_rgbd_plot_texture_a_scan.py>`
# - :ref:`Reconstruct a room without camera poses <sphx_glr_gallery_rgbd_plot_reconstruct_a_room.py>`:
#   reconstruction without poses.
