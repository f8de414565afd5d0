"""
Color map optimization and texture
==================================

The colors of a fused mesh are means over voxels and frames, so they are blurred. The frames are sharp. On this page you
optimize the camera poses until the frames agree, and transfer their colors to the vertices or to a texture with
``texture_mesh``.
"""

import numpy as np

import pointloom as loom

# %%
# A coarse mesh from inaccurate poses
# -----------------------------------
#
# The data consists of six frames with pose errors of up to 3 mm and 0.3 degrees, as after tracking.

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
# Vertex colors
# -------------
#
# The residual is the root mean square difference of intensity (0 to 1) between frames and vertices. The optimization
# decreases it. On uniform walls, poses are not well determined and may move by more than their initial error.
# ``method="none"`` does not change the poses.

source = loom.frames_from(frames, camera, depth_scale=1.0)
result = loom.meshing.texture_mesh(mesh, source, poses)
print(result)
colors = result.colors
print(f"residual {colors.residual_before:.4f} before, {colors.residual:.4f} after {colors.iterations} iterations")
assert colors.residual < colors.residual_before and result.reliable

# %%
# ``optimize_color_map`` has the options of Open3D's optimizers. ``method="non-rigid"`` also warps the images.

images = [loom.RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=4.0) for frame in frames]
option = loom.meshing.ColorMapOption(maximum_iteration=10, maximum_allowable_depth=4.0)
world_to_camera = loom.Trajectory(np.array(poses))
rigid = loom.meshing.optimize_color_map(mesh, images, world_to_camera, option, intrinsic=camera)
print(
    f"residual {rigid.residual_before:.4f} before, {rigid.residual:.4f} "
    f"after; {100 * rigid.seen.mean():.0f} % of the vertices are visible"
)
assert rigid.residual < rigid.residual_before

# %%
# Texture
# -------
#
# The mesh gets a texture atlas of ``size`` texels per side (requires the extra "mesh") with the resolution of the
# frames, which is much finer than the triangles.

textured = loom.meshing.texture_mesh(mesh, source, colors.trajectory.poses, method="none", size=1024)
print(f"{textured.size} x {textured.size} texels, {100 * (textured.texel_fraction or 0):.0f} % of them visible")
assert textured.mesh.has_textures

# %%
# The fused colors and the texture, from the pose of a frame:

view = loom.View(loom.PinholeCameraIntrinsic(640, 640, 640.0, 640.0, 319.5, 319.5), frames[3].T_world_camera)
fused = loom.render({"geometry": mesh, "shaded": False}, view, labels=None)
sharp = loom.render(textured.mesh, view)
image = np.hstack([fused, sharp])
del fused, sharp

# %%
# What to change
# --------------
# - ``size`` [texels]: 2048 is sharper.
# - ``maximum_iteration``: 50 instead of 10. How much does the residual decrease?
# - ``voxel_size`` [m]: a coarser mesh with the same texture.
#
# Next
# ----
# - :ref:`TSDF fusion of depth frames with known poses <sphx_glr_gallery_rgbd_plot_fuse_posed_frames.py>`
# - :ref:`File formats of meshes: GLB, PLY, OBJ, STL <sphx_glr_gallery_meshes_plot_mesh_files.py>`: textured meshes in
#   files.
