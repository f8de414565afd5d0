"""
15. From frames to a model
==========================

The last step: many images of a depth camera become one model. You learn to put frames together where their poses
are known, to fuse them into a surface that averages the noise, to do it where nobody knows the poses, and to ask how
good the model is.
"""

# %%
# Cameras and paths in files
# --------------------------
# A camera is a JSON file, a path a file of poses. Open3D's files are read and written as they stand. In Open3D a
# trajectory holds extrinsics (world to camera); here it holds poses (camera to world): ``np.linalg.inv`` goes from
# one to the other.

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
# Merge clouds
# ------------
# The simplest way: a cloud of each frame, moved by its pose, all of them in one, thinned. Every wrong pixel is in it,
# and surfaces are as thick as the noise.

clouds = []
for frame in frames[::3]:
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=4.0)
    clouds.append(loom.PointCloud.create_from_rgbd_image(image, camera, np.linalg.inv(frame.T_world_camera)))
merged = loom.PointCloud.concatenate(clouds)
thin = merged.voxel_down_sample(0.02)
print(f"{len(merged)} points of {len(clouds)} frames, {len(thin)} after thinning")


def inside(geometry: loom.PointCloud | loom.TriangleMesh) -> loom.PointCloud | loom.TriangleMesh:
    """What is below the ceiling and before the window's wall, so that one sees in."""
    return geometry.crop(loom.AxisAlignedBoundingBox([-1, -1, -1], [6, 3.8, 2.45]))


view = {"front": [0.62, 0.62, 0.55], "up": [0, 0, 1], "zoom": 0.54}
as_points = loom.render(inside(thin), view, (960, 640))

# %%
# Fuse a surface
# --------------
# A **TSDF volume** keeps, for each voxel near a surface, how far the surface is, as the mean over all frames. Noise
# averages out, and what one frame alone saw is outvoted by the others. The surface is where the distance is 0. Two
# numbers: the voxel (as fine as the detail you want, 1 to 2 cm for rooms), and the truncation: how far beside the
# surface is kept, some four voxels, and more than the noise.
#
# In Open3D: ``ScalableTSDFVolume(voxel_length, sdf_trunc, color_type)``, ``integrate(rgbd, intrinsic, extrinsic)``.

volume = loom.TSDFVolume(voxel_size=0.02, truncation=0.08)
for frame in frames:
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=4.0)
    volume.integrate(image, camera, np.linalg.inv(frame.T_world_camera))
mesh = volume.extract_triangle_mesh()
print(mesh)
fused = loom.render(inside(mesh), view, (960, 640), shading="none")

# %%
# Is it better than the points? The data has the room's true surface, so we ask both how far they are off.

scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.room_mesh())


def errors(points: np.ndarray) -> np.ndarray:
    """How far points are from the room's surface [mm]."""
    return 1000 * np.asarray(scene.compute_distance(points[:: max(len(points) // 20_000, 1)].astype(np.float32)))


for name, points in (("points", merged.points), ("surface", mesh.vertices)):
    far = errors(points)
    print(f"{name}: half within {np.median(far):.1f} mm of the room, nine tenths within {np.quantile(far, 0.9):.0f} mm")
assert np.median(errors(mesh.vertices)) < np.median(errors(merged.points))

# %%
# All of it is one call where frames have poses: ``loom.rgbd.fuse``, which checks the result. Frames come from
# ``loom.open_dataset(folder)``, a camera, or a list:

source = loom.frames_from(frames[::2], camera)
result = loom.rgbd.fuse(source, voxel_size=0.03)
print(result)
assert result.reliable

# %%
# Nobody knows the poses
# ----------------------
# That is the usual case. ``loom.rgbd.reconstruct`` holds each frame against the model of all frames before it, adds it
# there, and closes loops where the camera comes back to a place. It is told no pose, not even the first, so its world
# is the first camera's. We give it the frames without their poses:

blind = loom.frames_from([(frame.color, frame.depth) for frame in frames], camera)
reconstruction = loom.rgbd.reconstruct(blind, voxel_size=0.02)
print(reconstruction)
assert reconstruction.reliable
assert len(reconstruction.trajectory) == len(frames)

# %%
# How good is the path? It is laid onto the true one, and compared (chapter 13). "se3" says how: by a turn and a
# step ("sim3" would scale it too). **ATE** is how far positions are off then, **RPE** what one step is off.
#
# Where frames are lost the path is shorter than the truth; ``reconstruction.trajectory.ids[:, 0]`` holds the numbers of
# the frames that have a pose.

tracked = reconstruction.trajectory.ids[:, 0]
path_errors = loom.registration.evaluate_trajectory(reconstruction.trajectory, loom.Trajectory(truth.poses[tracked]))
print(path_errors)

at_home = reconstruction.mesh.transform(truth.poses[0] @ np.linalg.inv(reconstruction.trajectory.poses[0]))
far = errors(at_home.vertices)
print(f"the model: half within {np.median(far):.1f} mm of the room, nine tenths within {np.quantile(far, 0.9):.0f} mm")
assert np.median(far) < 15

path = loom.Trajectory(
    truth.poses[0] @ np.linalg.inv(reconstruction.trajectory.poses[0]) @ reconstruction.trajectory.poses
)
model = loom.render(
    {
        "room": inside(at_home),
        "path": {"geometry": path, "color": (0.9, 0.15, 0.1), "line_width": 4},
        **{f"camera {k}": {"geometry": loom.CameraFrustum(camera, path.poses[k], 0.2), "color": (0.9, 0.15, 0.1)}
           for k in range(0, 24, 4)},
    },
    view, (960, 640), shading="none",
)  # fmt: skip

# %%
# The reconstruction system
# -------------------------
# Open3D's system works in stages: fragments of some hundred frames, their registration, its refinement, and the
# integration of the scene. ``loom.rgbd`` has them under the same names, reads the same configuration, and
# goes on where it was interrupted. Take it for long recordings, or where tracking loses the camera: fragments find
# each other again.
#
# .. code-block:: python
#
#    stages = loom.rgbd.FragmentOptions("kitchen-job", resume=True)
#    result = loom.rgbd.reconstruct(loom.open_frames("kitchen"), fragments=stages)
#
# Watch the model grow:

with loom.record(folder / "fusion.html", max_points=30_000, title="Frames become a model") as recording:
    loom.rgbd.fuse(loom.frames_from(frames[::4], camera), voxel_size=0.04)
page = folder / "fusion.html"
print(f"{page.stat().st_size / 1e6:.1f} MB")

# %%
# Keep it
# -------

loom.write_triangle_mesh(folder / "room.ply", reconstruction.mesh)
loom.write_trajectory(folder / "found.log", reconstruction.trajectory)
assert len(loom.read_triangle_mesh(folder / "room.ply").triangles) == len(reconstruction.mesh.triangles)

# %%
# What goes wrong
# ---------------
# **Extrinsics and poses mixed up** (chapter 5): the fused room is fog. ``integrate`` takes the extrinsic,
# trajectories hold poses.
#
# **A voxel in millimeters.** ``voxel_size=20`` makes a room of one voxel; nothing is left of it. ``loom.rgbd.fuse``
# says so:

huge = loom.rgbd.fuse(loom.frames_from(frames[:3], camera), voxel_size=20.0)
print(huge.warnings)
assert "voxel_size: 20 m is larger than the scene" in huge.warnings[0]

# %%
# **Too fast a camera.** Frames that overlap by less than two thirds, or that are blurred, are lost;
# ``reconstruction.warnings`` and ``print(reconstruction)`` name them. Film slowly, at 10 frames a second and more, and
# come back to where you began.
#
# Try it
# ------
# - A voxel of 1 cm: how many triangles more, and what for?
# - ``frames[::2]``, ``frames[::4]``: from where on does ``loom.rgbd.reconstruct`` lose the camera?
# - ``pointloom reconstruct FOLDER -o room.ply --picture room.png`` does this chapter from the shell.
#
# Where to go next
# ----------------
# The page :doc:`Reconstruction </reconstruction>` has the stages, :doc:`SLAM </slam>` how tracking and loops work,
# :doc:`Surfaces from points </surfaces>` how to sharpen colors. The gallery has some fifty more examples, each about
# one task.
