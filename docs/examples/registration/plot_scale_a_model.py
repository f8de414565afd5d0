"""
A model without a unit becomes meters
=====================================

A model from photographs has no scale and lies anyhow. One known distance gives the scale; places of the cameras
from GPS give scale, position and north at once, though some of them are wrong. Here both, on a model whose truth is
known.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.registration.trajectories.similarity import read_positions

reg = loom.registration

# %%
# Twelve images round an owl, with their true poses in meters; the model is a copy of them that was scaled, turned
# and moved as a reconstruction leaves it.
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
# **One distance.** The cameras of the first and the fourth image were measured to be so far apart;
# ``scale_from_known`` takes names, or points of the model such as the two ends of a ruler in the image.
measured = np.linalg.norm(shots.poses[0, :3, 3] - shots.poses[3, :3, 3])
factor = reg.scale_from_known(model, names[0], names[3], measured)
metric = model.scaled(factor)
print(f"{measured:.4f} m between two cameras: one unit of the model is {factor:.5f} m")
assert abs(factor - 1 / unit) < 1e-9
apart = np.linalg.norm(metric.centers[6] - metric.centers[1])
assert abs(apart - np.linalg.norm(shots.poses[6, :3, 3] - shots.poses[1, :3, 3])) < 1e-9

# %%
# **Places from GPS**, in a file of lines ``name x y z``. Each has 3 mm of noise (the owl is small: read meters where
# this says millimeters), one image has none, and two are wrong by half a metre.
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
print(f"{len(positions)} of {len(names)} images have a place")

# %%
# The fit finds which places agree, and rests on those. ``residuals`` are in the unit of the places; look at them, and
# at ``rotation_uncertainty``: cameras on a line leave the turn about it open.
fit = reg.fit_to_positions(model, positions)
wrong = [name for name, good in zip(fit.names, fit.inliers, strict=True) if not good]
print(
    f"scale {fit.scale:.5f}, rmse {1000 * fit.rmse:.1f} mm, rotation to {fit.rotation_uncertainty:.2f} "
    f"degrees; left out: {wrong}"
)
assert wrong == [names[4], names[9]]
assert abs(fit.scale * unit - 1) < 0.01

# %%
# All of the model moves by it, poses and points.
metric_model = model.transform(fit.transformation)
error = np.linalg.norm(metric_model.centers - shots.poses[:, :3, 3], axis=1)
print(f"cameras within {1000 * error.max():.1f} mm of the truth")
assert error.max() < 0.006

# %%
# Cameras as they were found, the owl where it stands, and in red the places that were wrong.
frusta = [loom.CameraFrustum(camera, pose, 0.06) for pose in metric_model.T_world_camera]
marks = []
for name, position in positions.items():
    color = [0.9, 0.15, 0.1] if name in wrong else [0.1, 0.6, 0.3]
    marks.append(loom.TriangleMesh.create_sphere(0.014).translate(position).paint_uniform_color(color))
corners = np.vstack([np.array(list(positions.values())), owl.points])
view = loom.View.fit(corners, direction=(-0.4, 0.8, -0.5), width=960, height=640)
image = loom.render([owl, *frusta, *marks], view)
