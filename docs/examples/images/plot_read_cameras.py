"""
Read cameras of COLMAP, Metashape and NeRF
==========================================

Programs store camera poses in different conventions: world to camera or its inverse, y up or down, pixel centers at
integers or at halves. On this page you read them into an ``SfmModel`` with a single convention, display and scale them,
and write them.
"""

import json
import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

folder = Path(tempfile.mkdtemp())
shots = loom.datasets.photographs(12)
names = [f"{i:02}.png" for i in range(len(shots))]

# %%
# COLMAP
# ------
#
# Binary and text models are supported. The path is a folder with ``cameras``, ``images`` and ``points3D``, or the
# project folder above it.

points = loom.datasets.object_mesh().sample_points_poisson_disk(800)
lens = loom.CameraModel.from_intrinsic(shots.intrinsic)
model = loom.SfmModel(
    names, [lens] * len(names), np.linalg.inv(shots.poses), points.points, (points.colors * 255).astype(np.uint8)
)
loom.write_colmap_model(folder / "sparse", model, format="txt")
read_back = loom.read_cameras(folder / "sparse")
print(read_back)
assert read_back.names == tuple(names) or list(read_back.names) == names
assert np.allclose(read_back.T_world_camera, shots.poses, atol=1e-9)

# %%
# transforms.json (nerfstudio, instant-ngp)
# -----------------------------------------
#
# OpenGL cameras have y up and look along -z. The reader converts them to x right, y down, z forward.

flip = np.diag([1.0, -1, -1, 1])
camera = shots.intrinsic
content = {
    "fl_x": camera.fx, "fl_y": camera.fy, "cx": camera.cx + 0.5, "cy": camera.cy + 0.5,
    "w": camera.width, "h": camera.height,
    "frames": [
        {"file_path": f"images/{name}", "transform_matrix": (T @ flip).tolist()}
        for name, T in zip(names, shots.poses, strict=True)
    ],
}  # fmt: skip
(folder / "transforms.json").write_text(json.dumps(content))
nerf = loom.read_cameras(folder / "transforms.json")
print(nerf, nerf.names[0], nerf.cameras[0].intrinsic)
assert np.allclose(nerf.T_world_camera, shots.poses, atol=1e-9)

# %%
# Metashape
# ---------
#
# Export the cameras with File > Export > Export Cameras. The script writes a short example with two cameras. Its poses
# are camera to chunk.

cameras = "".join(
    f'<camera id="{i}" sensor_id="0" label="{name}"><transform>'
    f"{' '.join(f'{v:.17g}' for v in T.ravel())}</transform></camera>"
    for i, (name, T) in enumerate(zip(names[:2], shots.poses, strict=False))
)
(folder / "cameras.xml").write_text(
    '<?xml version="1.0" encoding="UTF-8"?><document version="1.5.0"><chunk>'
    '<sensors><sensor id="0" label="lens" type="frame">'
    f'<resolution width="{camera.width}" height="{camera.height}"/><calibration type="frame" class="adjusted">'
    f'<resolution width="{camera.width}" height="{camera.height}"/><f>{camera.fx}</f></calibration></sensor></sensors>'
    f"<cameras>{cameras}</cameras></chunk></document>"
)
metashape = loom.read_cameras(folder / "cameras.xml")
print(metashape, metashape.cameras[0].intrinsic)
assert np.allclose(metashape.T_world_camera, shots.poses[:2], atol=1e-9)

# %%
# Scale to meters
# ---------------
#
# Structure from motion has an arbitrary scale. One known distance determines it, here that of the first two cameras.

unscaled = model.scaled(3.7)  # a model with arbitrary scale, as from COLMAP
known_distance = float(np.linalg.norm(shots.poses[0, :3, 3] - shots.poses[1, :3, 3]))
model_distance = float(np.linalg.norm(unscaled.centers[0] - unscaled.centers[1]))
metric = unscaled.scaled(known_distance / model_distance)
assert np.allclose(metric.centers, shots.poses[:, :3, 3], atol=1e-9)
print(f"scaled by {known_distance / model_distance:.4f}: distance of the cameras {known_distance:.3f} m")
loom.write_trajectory(folder / "poses.log", metric.trajectory())

# %%
# Display
# -------
#
# Each camera is displayed as a frustum, together with the object.

frusta = [loom.CameraFrustum(camera, T, scale=0.1, color=(0.85, 0.35, 0.1)) for T in metric.T_world_camera]
axes = {"geometry": loom.TriangleMesh.create_coordinate_frame(0.1, [-0.25, -0.25, -0.15])}
labels = [(name, center) for name, center in zip(metric.names, metric.centers, strict=False)]
scene = [{"geometry": loom.datasets.object_mesh(), "shaded": False}, axes, *frusta]
view = {"front": [0.5, -1, 0.75], "up": [0, 0, 1], "field_of_view": 30, "zoom": 0.45}
image = loom.render(scene, view, (960, 640), labels=labels)

# %%
# What to change
# --------------
# - ``format``: ``"bin"`` writes a smaller COLMAP model.
# - ``scale`` of the frusta [m]: the size of the displayed cameras.
# - The known distance: a distance between points of your own model.
#
# Next
# ----
# - :ref:`Scale and georeference a photogrammetric model <sphx_glr_gallery_registration_plot_scale_a_model.py>`
# - :doc:`Cameras and models from photographs </models>`
