"""
Sharp colors for a scan
========================

The colors of a fused mesh are means of voxels: blurred, and smeared where poses are a little wrong. The frames
themselves are sharp. ``texture_mesh`` moves the poses until the frames agree and gives the mesh their colors, at its
vertices or as a texture.
"""

import numpy as np

import pointloom as loom

# %%
# A coarse mesh of slightly wrong poses
# -------------------------------------
#
# Six frames; each pose is up to 3 mm and 0.3 degrees wrong, as tracking leaves them.

frames = loom.datasets.room_frames(6, noise=False)
camera = frames[0].intrinsic
random = np.random.default_rng(0)
poses = []
for frame in frames:
    w, T = np.radians(0.2) * random.normal(size=3), frame.T_world_camera.copy()
    T[:3, :3] = T[:3, :3] @ np.array([[1, -w[2], w[1]], [w[2], 1, -w[0]], [-w[1], w[0], 1]])
    T[:3, :3] = np.linalg.qr(T[:3, :3])[0] * np.sign(np.diag(np.linalg.qr(T[:3, :3])[1]))
    T[:3, 3] += 0.002 * random.normal(size=3)
    poses.append(T)
volume = loom.TSDFVolume(voxel_size=0.04)
for frame, T in zip(frames, poses, strict=False):
    volume.integrate(frame.depth, camera, np.linalg.inv(T), frame.color, depth_scale=1.0, depth_max=4.0)
mesh = volume.extract_triangle_mesh(weight_threshold=2)

# %%
# Colors at vertices
# -------------------
#
# The residual is the root mean square of a frame's brightness (0 to 1) less the vertex's. It falls as the frames come
# to agree. Where walls are plain little holds a pose: it may then move by more than it was off. ``method="none"``
# leaves poses as they are.

source = loom.frames_from(frames, camera, depth_scale=1.0)
result = loom.meshing.texture_mesh(mesh, source, poses)
print(result)
colors = result.colors
print(f"residual {colors.residual_before:.4f} before, {colors.residual:.4f} after {colors.iterations} turns")
assert colors.residual < colors.residual_before and result.reliable

# %%
# ``optimize_color_map`` has the options of Open3D's optimizers. With ``method="non-rigid"`` it also warps the images.

images = [loom.RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=4.0) for frame in frames]
option = loom.meshing.ColorMapOption(maximum_iteration=10, maximum_allowable_depth=4.0)
world_to_camera = loom.Trajectory(np.array(poses))
rigid = loom.meshing.optimize_color_map(mesh, images, world_to_camera, option, intrinsic=camera)
print(
    f"residual {rigid.residual_before:.4f} before, {rigid.residual:.4f} "
    f"after; {100 * rigid.seen.mean():.0f} % of the vertices seen"
)
assert rigid.residual < rigid.residual_before

# %%
# A texture
# ---------
#
# ``size`` texels a side: the mesh gets an atlas (extra "mesh") and the pixels of the frames, far finer than its
# triangles.

textured = loom.meshing.texture_mesh(mesh, source, colors.trajectory.poses, method="none", size=1024)
print(f"{textured.size} x {textured.size} texels, {100 * (textured.texel_fraction or 0):.0f} % of them seen")
assert textured.mesh.has_textures

# %%
# As fused, and with the texture, from where a frame was taken.

view = loom.View(loom.PinholeCameraIntrinsic(640, 640, 640.0, 640.0, 319.5, 319.5), frames[3].T_world_camera)
fused = loom.render({"geometry": mesh, "shaded": False}, view, labels=None)
sharp = loom.render(textured.mesh, view)
image = np.hstack([fused, sharp])
del fused, sharp
