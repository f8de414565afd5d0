"""Readers of formats without a short grammar: GLB, glTF, NPZ, text tables, trajectories, cameras, polygons, models.

The oracles of these formats check less: that the result is valid, and for GLB that trimesh reads the same number of
triangles with the same coordinates, if it reads the file at all.
"""

from __future__ import annotations

import base64
import contextlib
import json
import re
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mutations
import numpy as np

from pointloom.cameras.camera import (
    PinholeCameraIntrinsic,
    read_pinhole_camera_intrinsic,
    write_pinhole_camera_intrinsic,
)
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb
from pointloom.io.models.metashape import read_metashape_cameras
from pointloom.io.points.npz import read_npz, write_npz
from pointloom.io.points.text import read_text, write_text
from pointloom.io.points.text_table import read_text_table
from pointloom.io.table import MeshTable, PointTable


def _mesh(*, textured: bool = False) -> MeshTable:
    rng = np.random.default_rng(4)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    mesh = MeshTable(
        rng.normal(size=(4, 3)).astype(np.float32), triangles, attributes={"_heat": np.arange(4.0, dtype="f4")}
    )
    if textured:
        mesh.vertex_normals = np.eye(4, 3, dtype=np.float32)
        mesh.triangle_uvs = rng.random((12, 2)).astype(np.float32)
        mesh.triangle_material_ids = np.array([0, 1, 0, 1], np.int32)
        mesh.textures = tuple(rng.integers(0, 256, (8, 8, 3), dtype=np.uint8) for _ in range(2))
    return mesh


def _cloud() -> PointTable:
    rng = np.random.default_rng(6)
    return PointTable(rng.normal(size=(5, 3)), rng.normal(size=(5, 3)).astype(np.float32), rng.random((5, 3)))


def _made(suffix: str, write: Callable[[Path], Any]) -> list[bytes]:
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        write(Path(folder) / f"x{suffix}")
        return [(Path(folder) / f"x{suffix}").read_bytes()]


def glbs() -> list[bytes]:
    """Plain and textured GLB files."""
    return [
        data
        for t in (False, True)
        for data in _made(".glb", lambda p, t=t: write_glb(p, _mesh(textured=t), overwrite=True))
    ]


def gltfs() -> list[bytes]:
    """The same as glTF text with an embedded buffer."""
    documents = []
    for data in glbs():
        size = int.from_bytes(data[12:16], "little")
        content = json.loads(data[20 : 20 + size])
        buffer = data[20 + size + 8 :]
        uri = "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()
        content["buffers"] = [{"byteLength": len(buffer), "uri": uri}]
        documents.append(json.dumps(content, indent=1).encode())
    return documents


def npzs() -> list[bytes]:
    """A point cloud."""
    return _made(".npz", lambda path: write_npz(path, _cloud(), overwrite=True))


def texts() -> list[bytes]:
    """Points as text rows."""
    return _made(".xyz", lambda path: write_text(path, PointTable(_cloud().points), overwrite=True))


def tables() -> list[bytes]:
    """Points below a header line."""
    return [b"x,y,z,r,g,b,label\n1,2,3,255,0,0,4\n-1.5,2e3,3,0,128,9,5\n0,0,0,1,1,1,6\n"]


def _path() -> Trajectory:
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, :3, 3] = [[0, 0, 0], [1, 0, 0.5], [2, -0.25, 1]]
    return Trajectory(poses, timestamps=np.arange(3.0))


def trajectories(suffix: str) -> Callable[[], list[bytes]]:
    """Three poses."""
    return lambda: _made(suffix, lambda path: write_trajectory(path, _path()))


def cameras() -> list[bytes]:
    """A pinhole camera as JSON."""
    camera = PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
    return _made(".json", lambda path: write_pinhole_camera_intrinsic(path, camera))


def metashapes() -> list[bytes]:
    """Two cameras of one sensor."""
    pose = b"<transform>1 0 0 %d 0 1 0 0 0 0 1 2 0 0 0 1</transform>"
    camera = b'<camera id="%d" sensor_id="0" label="p%d.jpg">' + pose + b"</camera>"
    sensor = (
        b'<sensor id="0" label="s" type="frame"><resolution width="640" height="480"/><calibration type="frame" '
        b'class="adjusted"><resolution width="640" height="480"/><f>525</f><cx>1</cx><cy>-2</cy><k1>0.01</k1>'
        b"</calibration></sensor>"
    )
    body = b"<sensors>" + sensor + b"</sensors><cameras>" + camera % (0, 0, 1) + camera % (1, 1, 3) + b"</cameras>"
    chunk = b'<chunk label="c" enabled="1">' + body + b"</chunk>"
    return [b'<?xml version="1.0" encoding="UTF-8"?><document version="1.2.0">' + chunk + b"</document>"]


def sound_mesh(path: Path, mesh: MeshTable) -> str | None:
    """Check that a mesh is valid and has the triangles that trimesh reads."""
    vertices, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    if not np.isfinite(vertices).all():
        return "some vertices are not finite"
    if not len(triangles) or triangles.min() < 0 or triangles.max() >= len(vertices):
        return "triangle indices are out of range"
    if mesh.triangle_uvs is not None and np.shape(mesh.triangle_uvs) != (3 * len(triangles), 2):
        return "the number of texture coordinates is wrong"
    if re.search(rb'"mode"\s*:\s*[56]\b', path.read_bytes()):  # strips and fans, which trimesh interprets differently
        return None
    expected = _by_trimesh(path)
    if expected is None or len(expected) == 0:
        return None
    actual = np.sort(vertices[triangles].reshape(len(triangles), -1).sum(axis=1))
    if len(expected) != len(triangles):
        return f"{len(triangles)} triangles, trimesh reads {len(expected)}"
    size = np.abs(vertices).max()
    both = np.abs(actual - np.sort(expected.reshape(len(expected), -1).sum(axis=1))).max()
    return None if both <= 1e-4 * max(size, 1e-30) else "the corners differ from trimesh's"


def _by_trimesh(path: Path) -> Any:
    """Corners of all triangles as read by trimesh, [t, 3, 3]; None if it reads none."""
    import trimesh

    with contextlib.suppress(Exception), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        scene = trimesh.load(path, process=False, force="scene", file_type=path.suffix[1:])
        parts = [part.triangles for part in scene.dump() if len(getattr(part, "faces", ()))]
        return np.concatenate(parts) if parts else None
    return None


def sound_cloud(path: Path, table: PointTable) -> str | None:
    """Check that all arrays of a cloud have the same number of rows."""
    count = len(table.points)
    arrays = [table.normals, table.colors, *table.attributes.values()]
    return None if all(a is None or len(a) == count for a in arrays) else "the arrays differ in length"


def sound_path(path: Path, trajectory: Any) -> str | None:
    """Check that poses are rigid and finite."""
    R = trajectory.poses[:, :3, :3]
    if not np.isfinite(trajectory.poses).all():
        return "some poses are not finite"
    error = np.abs(R @ R.transpose(0, 2, 1) - np.eye(3)).max(initial=0)
    return None if error < 1e-3 and (np.linalg.det(R) > 0).all() else "some poses are not rigid"


def sound_camera(path: Path, camera: PinholeCameraIntrinsic) -> str | None:
    """Check that a camera has a size and focal lengths."""
    numbers = [camera.width, camera.height, camera.fx, camera.fy]
    return None if min(numbers) > 0 and np.isfinite([*numbers, camera.cx, camera.cy]).all() else "no camera"


def sound_model(path: Path, model: Any) -> str | None:
    """Check that cameras of a project have finite, rigid poses."""
    poses = np.asarray(model.T_world_camera if hasattr(model, "T_world_camera") else model.centers)
    return None if np.isfinite(poses).all() else "some cameras have no finite pose"


# name, suffix, seeds, mutate, read, oracle: as in cases.Case
OTHERS = [
    ("GLB", ".glb", glbs, mutations.binary, read_glb, sound_mesh),
    ("glTF", ".gltf", gltfs, mutations.text, read_glb, sound_mesh),
    ("NPZ", ".npz", npzs, mutations.binary, read_npz, sound_cloud),
    ("XYZ", ".xyz", texts, mutations.text, read_text, sound_cloud),
    ("CSV", ".csv", tables, mutations.text, read_text_table, sound_cloud),
    ("trajectory .log", ".log", trajectories(".log"), mutations.text, read_trajectory, sound_path),
    ("trajectory .tum", ".tum", trajectories(".tum"), mutations.text, read_trajectory, sound_path),
    ("trajectory .kitti", ".kitti", trajectories(".kitti"), mutations.text, read_trajectory, sound_path),
    ("camera .json", ".json", cameras, mutations.text, read_pinhole_camera_intrinsic, sound_camera),
    ("Metashape", ".xml", metashapes, mutations.text, read_metashape_cameras, sound_model),
]
