"""
Fuse posed depth frames into a mesh (TSDF)
==========================================

A depth camera and known poses give a surface: each frame says for each voxel how far in front of or behind the surface
it is, and the mean of all frames takes the noise away. One call makes the mesh; a volume of your own takes frames as
they come.
"""

import numpy as np

import pointloom as loom

# %%
# Frames
# ------
#
# 24 frames of a walk through a furnished room: color, depth in meters with the noise of a structured-light camera, and
# the true pose, camera to world. For your own folder take ``loom.open_dataset(folder)``; for anything else
# ``loom.frames_from``.

frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
source = loom.frames_from(frames, camera, depth_scale=1.0)

# %%
# One call
# --------
#
# ``voxel_size`` [m] is the finest detail that stays. The result is a record: the mesh, the volume, what fraction of the
# depth was used, and ``warnings`` if it is unreliable.

result = loom.rgbd.fuse(source, voxel_size=0.03)
print(result)
assert result.reliable and result.frame_count == 24

# %%
# The same by hand
# ----------------
#
# ``integrate`` takes world to camera, as Open3D's does: the inverse of the pose. Here frames can come one at a time,
# and the surface be looked at in between.

volume = loom.TSDFVolume(voxel_size=0.03)
for frame in frames:
    volume.integrate(
        frame.depth, camera, np.linalg.inv(frame.T_world_camera), frame.color, depth_scale=1.0, depth_max=4.0
    )
mesh = volume.extract_triangle_mesh(weight_threshold=3)
print(f"{volume.block_count} blocks, {volume.memory_bytes / 1e6:.0f} MB, {len(mesh.triangles)} triangles")

# %%
# How good is it?
# ---------------
#
# Against the room as it is: half of the vertices are off by a few millimeters, though a single depth of this camera is
# off by up to 14 mm at 3 m.

scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())
error = scene.compute_distance(result.mesh.vertices)
print(f"fused: median {np.median(error) * 1e3:.1f} mm, 9 of 10 within {np.quantile(error, 0.9) * 1e3:.1f} mm")
cloud = loom.PointCloud.create_from_rgbd_image(
    loom.RGBDImage(frames[3].color, frames[3].depth, depth_scale=1.0, depth_trunc=4.0),
    camera,
    np.linalg.inv(frames[3].T_world_camera),
)
single = scene.compute_distance(cloud.points)
print(f"one frame: median {np.median(single) * 1e3:.1f} mm, 9 of 10 within {np.quantile(single, 0.9) * 1e3:.1f} mm")
assert np.median(error) < 0.01
assert len(mesh.triangles) > 50_000

# %%
# What another camera would see of it
# -----------------------------------
#
# ``ray_cast`` looks into the volume without a mesh: depth, colors and normals from any pose.

seen = volume.ray_cast(camera, np.linalg.inv(frames[3].T_world_camera), depth_max=5.0)
both = (seen.depth > 0) & (frames[3].depth > 0)
print(
    f"{100 * both.mean():.0f} % of the pixels, "
    f"{np.median(np.abs(seen.depth - frames[3].depth)[both]) * 1e3:.1f} mm from the frame (median)"
)
assert both.mean() > 0.3

# %%
# The mesh and where the camera was, from behind it.

path = loom.Trajectory(np.array([frame.T_world_camera for frame in frames]))
cameras = [
    loom.CameraFrustum(camera, frame.T_world_camera, scale=0.15, color=(0.85, 0.3, 0.1)) for frame in frames[::2]
]
T = frames[12].T_world_camera.copy()
T[:3, 3] -= 0.7 * T[:3, 2]
view = loom.View(loom.PinholeCameraIntrinsic(960, 640, 760.0, 760.0, 479.5, 319.5), T)
shown = [
    {"geometry": result.mesh, "shaded": False, "back_faces": False},
    *cameras,
    {"geometry": path, "color": (0.1, 0.3, 0.8)},
]
image = loom.render(shown, view)
