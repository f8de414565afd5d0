"""Small input files for the commands."""

import shutil
import threading
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from benchmarks.room_loops import room_loop_sequence
from pointloom.cli.shell import console
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.io.frames.recordings import record_frames
from pointloom.kernels.language import compile_notices

from ..rgbd.sequences import Part
from .surface_poses import NEAR, bumpy, colors_at, moved, path_of

pytest.register_assert_rewrite("tests.cli.commands")  # show the compared values of its asserts


@pytest.fixture(autouse=True)
def no_lines_of_progress(monkeypatch):
    """Print no compile notices and no progress to stderr."""
    monkeypatch.setattr(console, "LINE_INTERVAL", float("inf"))
    monkeypatch.setattr(compile_notices, "NOTICE_DELAY", threading.TIMEOUT_MAX)


@pytest.fixture
def cloud(tmp_path, rng) -> Path:
    """A file of 500 points in a unit cube, with colors and an intensity."""
    path = tmp_path / "cloud.ply"
    points, colors = rng.random((500, 3)), rng.integers(0, 256, (500, 3)).astype(np.uint8)
    loom.write_point_cloud(path, loom.PointCloud(points, colors=colors, intensity=np.arange(500, dtype=np.float32)))
    return path


@pytest.fixture
def mesh(tmp_path) -> Path:
    """A file of two triangles with colors."""
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


@pytest.fixture(scope="session")
def recorded_sequence(tmp_path_factory) -> Path:
    """The first 8 small frames of a camera moving through the room, 1 cm apart, with timestamps."""
    folder = tmp_path_factory.mktemp("walk") / "walk"
    record_frames(Part(room_loop_sequence(600, width=160, height=120), 8), folder)
    return folder


@pytest.fixture
def sequence_folder(recorded_sequence, tmp_path) -> Path:
    """A folder of the recorded frames, with their poses, that a test may damage."""
    return Path(shutil.copytree(recorded_sequence, tmp_path / "walk"))


@pytest.fixture
def near(tmp_path, rng) -> tuple[Path, Path]:
    """A surface sampled twice, the second 2 degrees and 4 cm off, with colors."""
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, points, T in zip(paths, (bumpy(rng), bumpy(rng)), (np.linalg.inv(NEAR), np.eye(4)), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(moved(points, T), colors=colors_at(points)))
    return paths


@pytest.fixture
def drive(tmp_path, rng) -> Path:
    """A folder of 5 scans of a room as KITTI .bin files; the numbers in their names have no leading zeros."""
    room = rng.uniform(-8, 8, (5000, 3)) * [1, 1, 0.3]
    room[np.arange(5000), np.arange(5000) % 3] = np.where(rng.random(5000) < 0.5, -1, 1) * 8.0
    folder = tmp_path / "drive"
    folder.mkdir()
    for number, T in zip((8, 9, 10, 11, 100), path_of(5), strict=True):
        points = moved(room, np.linalg.inv(T))
        np.column_stack([points, np.ones(len(points))]).astype(np.float32).tofile(folder / f"scan{number}.bin")
    return folder


@pytest.fixture
def points(rng):
    """A floor of 600 points, blobs of 150 and 100 points above it, an outlier, a duplicate and a NaN point."""
    floor = np.column_stack([rng.random((600, 2)), np.zeros(600)])
    centers = [[0.2, 0.2, 0.5]] * 150 + [[0.8, 0.8, 0.5]] * 100
    return np.vstack([floor, centers + 0.05 * rng.random((250, 3)), [[9, 9, 9]], floor[:1], [[np.nan, 0, 0]]])


@pytest.fixture
def scene(tmp_path, points) -> Path:
    """`points` in float64 with row numbers, a float64 time, normals and colors."""
    path, rows = tmp_path / "scene.npz", np.arange(len(points), dtype=np.int32)
    normals, colors = np.tile(np.float32([0, 0, 1]), (len(rows), 1)), np.full((len(rows), 3), 0.25, np.float32)
    np.savez(path, points=points, row=rows, time=rows / 3, normals=normals, colors=colors)
    return path
