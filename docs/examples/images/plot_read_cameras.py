"""
Read cameras of COLMAP, Metashape and NeRF files
================================================

Poses come in many files and conventions: world to camera or back, y up or down, pixel centers at halves. All of them
become one ``SfmModel``, and can be drawn, scaled, and written again.
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
# Binary or text; a folder with ``cameras``, ``images`` and ``points3D``, or the project above it.

points = loom.datasets.object_mesh().sample_points_poisson_disk(800)
lens = loom.CameraModel.from_intrinsic(shots.intrinsic)
model = loom.SfmModel(
    names, [lens] * len(names), np.linalg.inv(shots.poses), points.points, (points.colors * 255).astype(np.uint8)
)
loom.write_colmap_model(folder / "sparse", model, format="txt")
back = loom.read_cameras(folder / "sparse")
print(back)
assert back.names == tuple(names) or list(back.names) == names
assert np.allclose(back.T_world_camera, shots.poses, atol=1e-9)

# %%
# transforms.json (nerfstudio, instant-ngp)
# -----------------------------------------
#
# OpenGL's camera has y up and looks along -z. Reading turns it: x right, y down, z forward.

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
# File > Export > Export Cameras. What follows is such a file, shortened to two cameras; poses there are camera to
# chunk.

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
# To meters
# ---------
#
# Structure from motion does not know how large the world is. One known distance is enough: say the first two cameras
# stand that far apart.

unknown = model.scaled(3.7)  # as if it came out of COLMAP in a unit of its own
known_distance = float(np.linalg.norm(shots.poses[0, :3, 3] - shots.poses[1, :3, 3]))
model_distance = float(np.linalg.norm(unknown.centers[0] - unknown.centers[1]))
metric = unknown.scaled(known_distance / model_distance)
assert np.allclose(metric.centers, shots.poses[:, :3, 3], atol=1e-9)
print(f"scaled by {known_distance / model_distance:.4f}: cameras {known_distance:.3f} m apart")
loom.write_trajectory(folder / "poses.log", metric.trajectory())

# %%
# Drawn
# -----
#
# Each camera as a frustum, with the figure and the model's points.

frusta = [loom.CameraFrustum(camera, T, scale=0.1, color=(0.85, 0.35, 0.1)) for T in metric.T_world_camera]
axes = {"geometry": loom.TriangleMesh.create_coordinate_frame(0.1, [-0.25, -0.25, -0.15])}
labels = [(name, center) for name, center in zip(metric.names, metric.centers, strict=False)]
scene = [{"geometry": loom.datasets.object_mesh(), "shaded": False}, axes, *frusta]
view = {"front": [0.5, -1, 0.75], "up": [0, 0, 1], "field_of_view": 30, "zoom": 0.45}
image = loom.render(scene, view, (960, 640), labels=labels)
