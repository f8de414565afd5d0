"""Small files for the commands to work on."""

import shutil
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.app.room import write_room_sequence


@pytest.fixture
def cloud(tmp_path, rng) -> Path:
    """A file of 500 points in a unit cube, with colours and an intensity."""
    path = tmp_path / "cloud.ply"
    points, colors = rng.random((500, 3)), rng.integers(0, 256, (500, 3)).astype(np.uint8)
    loom.write_point_cloud(path, loom.PointCloud(points, colors=colors, intensity=np.arange(500, dtype=np.float32)))
    return path


@pytest.fixture
def mesh(tmp_path) -> Path:
    """A file of two triangles with colours."""
    path = tmp_path / "mesh.ply"
    square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    loom.write_triangle_mesh(path, loom.TriangleMesh(square, [[0, 1, 2], [0, 2, 3]], vertex_colors=np.ones((4, 3))))
    return path


@pytest.fixture(scope="session")
def made_frames(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("frames") / "room"
    write_room_sequence(folder, frame_count=6, width=160, height=120)
    return folder


@pytest.fixture
def frames(made_frames, tmp_path) -> Path:
    """A folder of 6 small frames that a test may damage."""
    return Path(shutil.copytree(made_frames, tmp_path / "frames"))
