"""
15. From frames to a model
==========================

The final chapter reconstructs a model from many frames of a depth camera. You merge frames with known poses, fuse them
to a surface that averages the noise, reconstruct a scene with unknown poses, and measure the accuracy of the model.
"""

# %%
# Files of cameras and trajectories
# ---------------------------------
# A camera is stored as JSON, a trajectory as a text file. Both are compatible with Open3D. Open3D's trajectories
# contain extrinsics (world to camera). pointloom's contain poses (camera to world). ``np.linalg.inv`` converts between
# them.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
frames = loom.datasets.room_frames(24)
camera = frames[0].intrinsic
truth = loom.Trajectory(np.stack([frame.T_world_camera for frame in frames]))

camera.write(folder / "camera.json")
loom.write_trajectory(folder / "path.log", truth)
print(loom.PinholeCameraIntrinsic.read(folder / "camera.json"))
print(loom.read_trajectory(folder / "path.log"))
assert loom.PinholeCameraIntrinsic.read(folder / "camera.json") == camera

# %%
# Merge point clouds
# ------------------
# The simplest model is the union of all point clouds in world coordinates, downsampled. It contains every wrong pixel,
# and its surfaces are as thick as the noise.

clouds = []
for frame in frames[::3]:
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=4.0)
    clouds.append(loom.PointCloud.create_from_rgbd_image(image, camera, np.linalg.inv(frame.T_world_camera)))
merged = loom.PointCloud.concatenate(clouds)
thin = merged.voxel_down_sample(0.02)
print(f"{len(merged)} points of {len(clouds)} frames, {len(thin)} after downsampling")


def interior(geometry: loom.PointCloud | loom.TriangleMesh) -> loom.PointCloud | loom.TriangleMesh:
    """Remove the ceiling and the wall with the window, which hide the interior."""
    return geometry.crop(loom.AxisAlignedBoundingBox([-1, -1, -1], [6, 3.8, 2.45]))


view = {"front": [0.62, 0.62, 0.55], "up": [0, 0, 1], "zoom": 0.54}
merged_points = loom.render(interior(thin), view, (960, 640))

# %%
# Fuse a surface
# --------------
# A **TSDF volume** stores, for each voxel close to a surface, the mean signed distance from the surface over all
# frames. This averages noise and suppresses errors of single frames. The surface is at distance 0. There are two
# parameters. The voxel size is the size of the smallest detail, 1 to 2 cm for rooms. The truncation is the largest
# stored distance, about four voxels and more than the noise.
#
# In Open3D: ``ScalableTSDFVolume(voxel_length, sdf_trunc, color_type)`` and ``integrate(rgbd, intrinsic, extrinsic)``.

volume = loom.TSDFVolume(voxel_size=0.02, truncation=0.08)
for frame in frames:
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=4.0)
    volume.integrate(image, camera, np.linalg.inv(frame.T_world_camera))
mesh = volume.extract_triangle_mesh()
print(mesh)
fused = loom.render(interior(mesh), view, (960, 640), shading="none")

# %%
# The true surface of the room is known, so the errors of the points and of the fused surface can be compared:

scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())


def errors(points: np.ndarray) -> np.ndarray:
    """Distances [mm] of points from the surface of the room."""
    return 1000 * np.asarray(scene.compute_distance(points[:: max(len(points) // 20_000, 1)].astype(np.float32)))


for name, points in (("points", merged.points), ("surface", mesh.vertices)):
    distances = errors(points)
    print(f"{name}: median error {np.median(distances):.1f} mm, 90th percentile {np.quantile(distances, 0.9):.0f} mm")
assert np.median(errors(mesh.vertices)) < np.median(errors(merged.points))

# %%
# ``loom.rgbd.fuse`` performs all steps in one call and checks the result. Its frames come from
# ``loom.open_dataset(folder)``, a camera or a list:

source = loom.frames_from(frames[::2], camera)
result = loom.rgbd.fuse(source, voxel_size=0.03)
print(result)
assert result.reliable

# %%
# Unknown poses
# -------------
# Usually the poses are unknown. ``loom.rgbd.reconstruct`` registers each frame with a model of all previous frames,
# adds it to the model, and closes loops when the camera returns to a known location. Its world coordinates are those of
# the first camera. The input here consists of the frames without poses:

frames_without_poses = loom.frames_from([(frame.color, frame.depth) for frame in frames], camera)
reconstruction = loom.rgbd.reconstruct(frames_without_poses, voxel_size=0.02)
print(reconstruction)
assert reconstruction.reliable
assert len(reconstruction.trajectory) == len(frames)

# %%
# To evaluate the trajectory, it is aligned with the ground truth and compared (chapter 13). "se3" is an alignment by
# rotation and translation, "sim3" would include scale. **ATE** is the error of the positions, **RPE** that of single
# motions.
#
# If frames are lost, the trajectory has fewer poses than the ground truth. ``reconstruction.trajectory.ids[:, 0]``
# contains the indices of the tracked frames.

tracked = reconstruction.trajectory.ids[:, 0]
path_errors = loom.registration.evaluate_trajectory(reconstruction.trajectory, loom.Trajectory(truth.poses[tracked]))
print(path_errors)

in_room_frame = reconstruction.mesh.transform(truth.poses[0] @ np.linalg.inv(reconstruction.trajectory.poses[0]))
distances = errors(in_room_frame.vertices)
print(f"the model: median error {np.median(distances):.1f} mm, 90th percentile {np.quantile(distances, 0.9):.0f} mm")
assert np.median(distances) < 15

path = loom.Trajectory(
    truth.poses[0] @ np.linalg.inv(reconstruction.trajectory.poses[0]) @ reconstruction.trajectory.poses
)
model = loom.render(
    {
        "room": interior(in_room_frame),
        "path": {"geometry": path, "color": (0.9, 0.15, 0.1), "line_width": 4},
        **{f"camera {k}": {"geometry": loom.CameraFrustum(camera, path.poses[k], 0.2), "color": (0.9, 0.15, 0.1)}
           for k in range(0, 24, 4)},
    },
    view, (960, 640), shading="none",
)  # fmt: skip

# %%
# The reconstruction system
# -------------------------
# Open3D's reconstruction system has stages: fragments of about 100 frames, their registration, its refinement, and the
# integration. ``loom.rgbd`` has the same stages, reads the same configuration, and can resume an interrupted run. Use
# it for long recordings, or if tracking loses the camera. Fragments are registered with each other.
#
# .. code-block:: python
#
#    stages = loom.rgbd.FragmentOptions("kitchen-job", resume=True)
#    result = loom.rgbd.reconstruct(loom.open_frames("kitchen"), fragments=stages)
#
# A recording of the fusion:

with loom.record(folder / "fusion.html", max_points=30_000, title="Fusion of frames") as recording:
    loom.rgbd.fuse(loom.frames_from(frames[::4], camera), voxel_size=0.04)
page = folder / "fusion.html"
print(f"{page.stat().st_size / 1e6:.1f} MB")

# %%
# Save the model
# --------------

loom.write_triangle_mesh(folder / "room.ply", reconstruction.mesh)
loom.write_trajectory(folder / "estimated.log", reconstruction.trajectory)
assert len(loom.read_triangle_mesh(folder / "room.ply").triangles) == len(reconstruction.mesh.triangles)

# %%
# Common mistakes
# ---------------
# **Extrinsics instead of poses**, or the reverse (chapter 5): the fused surface is noise. ``integrate`` expects the
# extrinsic. Trajectories contain poses.
#
# **A voxel size in millimeters.** With ``voxel_size=20``, the whole room is smaller than a voxel. ``loom.rgbd.fuse``
# warns:

huge = loom.rgbd.fuse(loom.frames_from(frames[:3], camera), voxel_size=20.0)
print(huge.warnings)
assert "voxel_size: 20 m is larger than the scene" in huge.warnings[0]

# %%
# **Fast camera motion.** Frames with less than two thirds of overlap, and blurred frames, are lost.
# ``reconstruction.warnings`` and ``print(reconstruction)`` list them. Move slowly, record at least 10 frames per
# second, and return to the start.
#
# What to change
# --------------
# - ``voxel_size`` [m]: 0.01 instead of 0.02. How many more triangles are created, and how does the error change?
# - The frame rate: ``frames[::2]``, ``frames[::4]``. At which rate does ``loom.rgbd.reconstruct`` lose the camera?
# - ``truncation`` [m]: values below the noise leave holes.
# - The command line: ``pointloom reconstruct FOLDER -o room.ply --picture room.png``.
#
# Next
# ----
# - :doc:`RGB-D reconstruction </reconstruction>`: the stages and their options.
# - :doc:`RGB-D SLAM and odometry </slam>`: tracking and loop closure.
# - :doc:`Surface reconstruction </surfaces>`: sharper colors.
# - The gallery: more than sixty examples, each for one task.
