"""
Scale and georeference a photogrammetric model
==============================================

A model from photographs has an arbitrary scale and pose. On this page you determine its scale from one known distance,
and scale, position and orientation from GPS positions with outliers. The true model is known.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.registration.trajectories.similarity import read_positions

reg = loom.registration

# %%
# A model with arbitrary scale
# ----------------------------
# The data consists of 12 images of an object with true poses in meters. The model is a copy with a different scale,
# rotation and translation.
shots = loom.datasets.photographs(12)
names = [f"photo_{k:02}.jpg" for k in range(len(shots.poses))]
owl = loom.datasets.object_mesh().sample_points_uniformly(20_000, seed=1)
camera = shots.intrinsic
lens = loom.CameraModel(
    "PINHOLE", camera.width, camera.height, [*camera.get_focal_length(), *camera.get_principal_point()]
)
unit, angle = 3.7, np.radians(65)
rotation = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
to_model = np.eye(4)
to_model[:3, :3], to_model[:3, 3] = unit * rotation, [4.0, -1.0, 2.0]
poses = shots.poses.copy()
poses[:, :3, :3] = rotation @ shots.poses[:, :3, :3]
poses[:, :3, 3] = shots.poses[:, :3, 3] @ (unit * rotation).T + to_model[:3, 3]
model = loom.SfmModel(names, [lens] * len(names), np.linalg.inv(poses))  # camera from world
print(model)

# %%
# One known distance
# ------------------
# The distance of the first and the fourth camera is known. ``scale_from_known`` accepts image names or points of the
# model, such as the ends of a ruler.
measured = np.linalg.norm(shots.poses[0, :3, 3] - shots.poses[3, :3, 3])
factor = reg.scale_from_known(model, names[0], names[3], measured)
metric = model.scaled(factor)
print(f"{measured:.4f} m between two cameras: one model unit = {factor:.5f} m")
assert abs(factor - 1 / unit) < 1e-9
separation = np.linalg.norm(metric.centers[6] - metric.centers[1])
assert abs(separation - np.linalg.norm(shots.poses[6, :3, 3] - shots.poses[1, :3, 3])) < 1e-9

# %%
# GPS positions
# -------------
# The file has lines ``name x y z``. The positions have noise of 3 mm (the object is small, real GPS has meters). One
# image has no position, and two positions have an error of half a meter.
rng = np.random.default_rng(2)
gps = shots.poses[:, :3, 3] + rng.normal(scale=0.003, size=(len(names), 3))
gps[4] += [0.4, 0.1, -0.3]
gps[9] += [-0.2, 0.5, 0.1]
with tempfile.TemporaryDirectory() as folder:
    file = Path(folder) / "gps.txt"
    file.write_text(
        "".join(f"{name} {x:.4f} {y:.4f} {z:.4f}\n" for name, (x, y, z) in zip(names[:-1], gps[:-1], strict=True))
    )
    positions = read_positions(file, names)
print(f"{len(positions)} of {len(names)} images have a position")

# %%
# The fit selects consistent positions. Check ``residuals``, in the unit of the positions, and ``rotation_uncertainty``:
# if all cameras are on a line, the rotation about it is not determined.
fit = reg.fit_to_positions(model, positions)
outliers = [name for name, good in zip(fit.names, fit.inliers, strict=True) if not good]
print(
    f"scale {fit.scale:.5f}, rmse {1000 * fit.rmse:.1f} mm, rotation uncertainty {fit.rotation_uncertainty:.2f} "
    f"degrees; outliers: {outliers}"
)
assert outliers == [names[4], names[9]]
assert abs(fit.scale * unit - 1) < 0.01

# %%
# The transformation is applied to poses and points.
metric_model = model.transform(fit.transformation)
error = np.linalg.norm(metric_model.centers - shots.poses[:, :3, 3], axis=1)
print(f"largest error of a camera position: {1000 * error.max():.1f} mm")
assert error.max() < 0.006

# %%
# The cameras, the object, and the GPS positions, with outliers in red:
frusta = [loom.CameraFrustum(camera, pose, 0.06) for pose in metric_model.T_world_camera]
markers = []
for name, position in positions.items():
    color = [0.9, 0.15, 0.1] if name in outliers else [0.1, 0.6, 0.3]
    markers.append(loom.TriangleMesh.create_sphere(0.014).translate(position).paint_uniform_color(color))
corners = np.vstack([np.array(list(positions.values())), owl.points])
view = loom.View.fit(corners, direction=(-0.4, 0.8, -0.5), width=960, height=640)
image = loom.render([owl, *frusta, *markers], view)

# %%
# What to change
# --------------
# - The GPS noise [m]: 0.05 instead of 0.003. How accurate is the scale?
# - The number of outliers: at which fraction does the fit fail?
# - The positions: with all cameras on a line, ``rotation_uncertainty`` increases.
#
# Next
# ----
# - :ref:`Read cameras of COLMAP, Metashape and NeRF <sphx_glr_gallery_images_plot_read_cameras.py>`
# - :doc:`Cameras and models from photographs </models>`
