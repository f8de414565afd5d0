"""The small files and names that the examples of a page begin with: what a reader would bring."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.datasets.scenes.room import room_sequence, write_room_sequence

from .io.sfm_models import ring_model
from .io.test_bags import file_of
from .io.test_recordings import robot as recorded_robot
from .registration.bent_fragments import BentRoom

SLOW = {
    "src/pointloom/cli/shell/SKILL.md",
    "docs/bending.md", "docs/change.md", "docs/frames.md",
    "docs/logging.md", "docs/meshes.md", "docs/reconstruction.md", "docs/recordings.md", "docs/slam.md",
    "docs/surfaces.md", "docs/terrain.md", "docs/tiles.md",
}  # fmt: skip
FRAMES = 12


def room(count: int = 20_000, seed: int = 0) -> loom.PointCloud:
    """Some furniture on a floor before two walls."""
    parts = [
        ((3.0, 2.5, 0.02), (0, 0, 0)), ((3.0, 0.02, 2.0), (0, 0, 0)), ((0.02, 2.5, 2.0), (0, 0, 0)),
        ((0.8, 0.5, 0.7), (0.3, 0.4, 0.05)), ((0.4, 0.9, 0.4), (1.8, 1.2, 0.05)), ((0.3, 0.3, 1.4), (2.4, 0.2, 0.05)),
    ]  # fmt: skip
    boxes = [loom.TriangleMesh.create_box(*size).translate(position) for size, position in parts]
    ball = loom.TriangleMesh.create_sphere(0.3).translate([1.2, 1.7, 0.4])
    mesh = sum([*boxes[1:], ball], boxes[0])
    return mesh.sample_points_uniformly(count, seed=seed)


def example_pose() -> np.ndarray:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_euler("z", 20, degrees=True).as_matrix(), [0.3, -0.2, 0.1]
    return T


def two_scans() -> dict[str, Any]:
    loom.write_point_cloud("scan.ply", room())
    loom.write_point_cloud("scan2.ply", room(seed=1).transform(example_pose()))
    return {}


def source_and_target() -> dict[str, Any]:
    return {"target": room(), "source": room(seed=1).transform(example_pose())}


def pair_nearby() -> dict[str, Any]:
    method = loom.registration.TransformationEstimation.point_to_point()
    one_iteration = loom.registration.ICPConvergenceCriteria(max_iteration=1)
    target, source = room(3000), room(3000, seed=1).translate([0.02, 0.01, 0])
    return {
        "np": np, "loom": loom, "source": source, "target": target, "method": method, "one_iteration": one_iteration
    }  # fmt: skip


def sequence_in_folder(folder: str) -> dict[str, Any]:
    """A folder of frames of a room with their poses, in the format of 7-Scenes."""
    write_room_sequence(folder, frame_count=FRAMES, width=320, height=240)
    return {"loom": loom, "frames": loom.open_dataset(folder)}


def two_frames() -> dict[str, Any]:
    """A folder of two neighboring frames of a room."""
    sequence = room_sequence(120)
    pair = [(frame.color, frame.depth) for frame in (sequence.read(0), sequence.read(1))]
    loom.record_frames(loom.frames_from(pair, sequence.intrinsic), "desk")
    return {}


def parts_and_sequence() -> dict[str, Any]:
    """Three overlapping parts of a room, each in its own coordinates, and frames."""
    full = room(40_000)
    x = full.points[:, 0]
    parts = [full.select_by_mask((x > low) & (x < low + 2.0)) for low in (0.0, 0.5, 1.0)]
    return sequence_in_folder("kitchen") | {"clouds": [part.transform(example_pose()) for part in parts]}


def bunny() -> dict[str, Any]:
    """A small mesh with a well-known name."""
    loom.write_triangle_mesh("bun_zipper.ply", loom.TriangleMesh.create_torus(0.06, 0.03, 100, 60))
    return {}


def surfaces() -> dict[str, Any]:
    loom.write_point_cloud("scan.ply", room(8000))
    Path("redkitchen").mkdir()
    frames = sequence_in_folder("redkitchen/seq-01")["frames"]
    return bunny() | {"room": loom.rgbd.fuse(frames, voxel_size=0.05).mesh}


def survey() -> dict[str, Any]:
    """A small airborne scan, and a viewer of it."""
    cloud = room()
    cloud["intensity"] = np.arange(len(cloud), dtype=np.uint16)
    loom.write_point_cloud("survey.laz", cloud)
    return {"view": loom.View.fit(cloud.points)}


def colmap_project() -> dict[str, Any]:
    """COLMAP's model of a few images, the images, and where they were taken by a receiver of satellites."""
    ring = ring_model(8)
    names = [f"IMG_{number}.jpg" for number in range(1, len(ring.names) + 1)]
    model = dataclasses.replace(ring, names=names)
    loom.write_colmap_model("project", model)
    Path("project/images").mkdir()
    camera = model.cameras[0]
    image = np.full((camera.height, camera.width, 3), 128, np.uint8)
    Image.fromarray(image).save(f"project/images/{names[0]}")
    centers = -np.einsum("nij,ni->nj", model.T_camera_world[:, :3, :3], model.T_camera_world[:, :3, 3])
    rows = [f"{name} {x:.6f} {y:.6f} {z:.6f}" for name, (x, y, z) in zip(names, 3 * centers, strict=True)]
    Path("gps.txt").write_text("\n".join(rows) + "\n")
    return {"image": image}


def bent_fragments() -> dict[str, Any]:
    bent = BentRoom(bend=0.01)
    camera = loom.PinholeCameraIntrinsic(64, 48, 52.5, 52.5, 31.5, 23.5)
    return {
        "clouds": bent.clouds, "graph": bent.graph, "volume": loom.TSDFVolume(voxel_size=0.05, color=False),
        "depth": np.full((48, 64), 1.5, np.float32), "intrinsic": camera, "T_fragment_camera": np.eye(4),
    }  # fmt: skip


def scans_and_frames() -> dict[str, Any]:
    sequence_in_folder("frames")
    return two_scans()


def robot() -> dict[str, Any]:
    """A robot's recording of three rotations of its scanner, and of its positions."""
    file_of(recorded_robot(Path.cwd(), scan_times=(11.0, 12.0, 13.0))).rename("run.mcap")
    return {}


def sequence_and_scans() -> dict[str, Any]:
    sequence_in_folder("walk")
    Path("scans").mkdir()
    for number, T in enumerate((np.eye(4), example_pose(), np.linalg.inv(example_pose()))):
        loom.write_point_cloud(f"scans/scan{number}.ply", room(seed=number).transform(T))
    return {}


SCENES: dict[str, Callable[[], dict[str, Any]]] = {
    "README.md": two_scans,
    "src/pointloom/cli/shell/SKILL.md": scans_and_frames,
    "docs/files.md": robot,
    "docs/frames.md": lambda: sequence_in_folder("kitchen"),
    "docs/large-clouds.md": survey,
    "docs/logging.md": parts_and_sequence,
    "docs/meshes.md": bunny,
    "docs/models.md": colmap_project,
    "docs/reconstruction.md": lambda: bent_fragments() | sequence_in_folder("kitchen"),
    "docs/recordings.md": pair_nearby,
    "docs/registration.md": source_and_target,
    "docs/slam.md": lambda: sequence_in_folder("folder") | two_frames(),
    "docs/surfaces.md": surfaces,
    "docs/tiles.md": sequence_and_scans,
}
