"""Fusion by cubes gives the mesh of one volume for any cube size, and recovers from errors."""

import json
import os
import shutil
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.io.images.image_files import write_png
from pointloom.io.points.ply import read_ply_mesh
from pointloom.meshing.volume.volume_part import VolumePart
from pointloom.tiling.jobs import fusion
from pointloom.tiling.jobs.run_jobs import job_status, retry_job
from pointloom.tiling.manifest import Manifest, worker_lock

from .scenes import watch_calls

VOXEL = 0.08
# [m] six blocks, three blocks, and the whole room in eight cubes.
SIZES = [4.0, *(pytest.param(size, marks=pytest.mark.slow) for size in (2.0, 20.0))]


@pytest.fixture(scope="module")
def frames(tmp_path_factory):
    folder = tmp_path_factory.mktemp("frames") / "room"
    write_room_sequence(folder, frame_count=14, width=80, height=60)
    return folder


@pytest.fixture
def frames_copy(frames, tmp_path):
    return Path(shutil.copytree(frames, tmp_path / "own"))


@pytest.fixture(scope="module")
def expected(frames):
    return triangles_of(fused(frames))


def fused(frames, **options):
    """The mesh of one volume, read from a file."""
    intrinsic = options.pop("intrinsic", None)
    mesh = loom.rgbd.fuse(loom.open_frames(frames, intrinsic=intrinsic), **{"voxel_size": VOXEL} | options).mesh
    with TemporaryDirectory() as folder:
        loom.write_triangle_mesh(Path(folder) / "mesh.ply", mesh)
        return read_ply_mesh(Path(folder) / "mesh.ply")


def triangles_of(mesh, *, sort=True):
    """Bit patterns of the corner positions and colors of each triangle, in a fixed order."""
    values = np.asarray(mesh.vertices, np.float64).view(np.int64)
    if mesh.vertex_colors is not None:
        colors = np.rint(np.asarray(mesh.vertex_colors, np.float64) * 255).astype(np.int64)
        values = np.concatenate([values, colors], axis=1)
    rows = values[np.asarray(mesh.triangles)].reshape(len(mesh.triangles), -1)
    return rows[np.lexsort(rows.T)] if sort else rows


def by_cubes(frames, job, *, device="cpu", workers=0, **options):
    loom.tiling.plan_fusion(frames, job, **{"voxel_size": VOXEL} | options)
    status = loom.tiling.run_job(job, device=device, workers=workers)
    assert status.is_finished, status
    return read_ply_mesh(loom.tiling.finish_fusion(job))


def moved(frames, shift):
    for path in frames.glob("*.pose.txt"):
        pose = np.loadtxt(path)
        pose[:3, 3] += shift
        np.savetxt(path, pose, fmt="%.17g")
    return frames


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
def test_cubes_of_any_size_match_one_volume(device, frames, expected, tmp_path, size):
    np.testing.assert_array_equal(triangles_of(by_cubes(frames, tmp_path / "job", device=device, size=size)), expected)


@pytest.mark.slow
def test_scenes_far_from_the_origin_match_one_volume(frames_copy, tmp_path):
    moved(frames_copy, (20_000.0, -3_000.0, 100.0))
    one = fused(frames_copy, weight_threshold=0)
    mesh = by_cubes(frames_copy, tmp_path / "job", size=2.0, weight_threshold=0)
    np.testing.assert_array_equal(triangles_of(mesh), triangles_of(one))
    assert len(mesh.vertices) == len(one.vertices)


def test_a_wall_on_the_sides_of_cubes_is_neither_lost_nor_duplicated(tmp_path):
    folder, camera = tmp_path / "wall", loom.PinholeCameraIntrinsic(64, 48, 50.0, 50.0, 31.5, 23.5)
    folder.mkdir()
    for number in range(2):
        write_png(folder / f"frame-{number:06d}.depth.png", np.full((48, 64), 1280, np.uint16))
        np.savetxt(folder / f"frame-{number:06d}.pose.txt", np.eye(4))
    how = {"voxel_size": 0.08, "truncation": 0.32, "weight_threshold": 0}
    one = fused(folder, intrinsic=camera, **how)
    mesh = by_cubes(folder, tmp_path / "job", size=0.64, intrinsic=camera, **how)
    assert mesh.vertex_colors is None and (np.asarray(one.vertices)[:, 2] == np.float32(1.28)).all()
    np.testing.assert_array_equal(triangles_of(mesh), triangles_of(one))
    assert len(mesh.vertices) == len(one.vertices)


@pytest.mark.slow
def test_parts_match_bitwise_at_their_borders(frames, expected, tmp_path):
    job = tmp_path / "job"
    by_cubes(frames, job, size=2.0)
    folder = loom.tiling.finish_fusion(job, tmp_path / "parts")
    files = sorted(folder.glob("*.ply"))
    listed = [part["file"] for part in json.loads((folder / "parts.json").read_text())["parts"]]
    assert sorted(listed) == [path.name for path in files]
    parts = [read_ply_mesh(path) for path in files]
    rows = np.concatenate([triangles_of(part, sort=False) for part in parts])
    np.testing.assert_array_equal(rows[np.lexsort(rows.T)], expected)
    assert loom.tiling.finish_fusion(job, folder) == folder
    with pytest.raises(FileError, match="exists already"):
        loom.tiling.finish_fusion(job, folder, overwrite=False)
    with pytest.raises(FileError, match=r"written as a \.ply file or a folder"):
        loom.tiling.finish_fusion(job, tmp_path / "mesh.obj")
    with pytest.raises(FileError, match=r"contains other files"):
        loom.tiling.finish_fusion(job, frames)


@pytest.mark.slow
def test_a_cube_contains_its_blocks_and_one_layer_around_them(frames, tmp_path, monkeypatch):
    """Only one cube is in memory, and each frame is read only for the cubes that it touches."""
    block_counts, read = [], Counter()
    watch_calls(monkeypatch, VolumePart, "extract_part", lambda part, *_: block_counts.append(part.block_count))
    count = lambda job, volume, frame: read.update([type(volume).__name__])  # noqa: E731
    watch_calls(monkeypatch, fusion.FusionJob, "_integrate", count)
    by_cubes(frames, tmp_path / "job", size=3 * 8 * VOXEL)
    cubes = job_status(tmp_path / "job").done - 1
    assert max(block_counts) <= 4**3 and len(block_counts) == cubes and read["BlockFinder"] == 14
    assert 14 <= read["VolumePart"] < 14 * cubes / 3


@pytest.mark.slow
def test_a_damaged_frame_is_named_and_can_be_replaced(frames_copy, expected, tmp_path):
    job, path = tmp_path / "job", frames_copy / "frame-000007.depth.png"
    content = path.read_bytes()
    path.write_bytes(content[:-200] + bytes(200))
    loom.tiling.plan_fusion(frames_copy, job, voxel_size=VOXEL, size=2.0)
    status = loom.tiling.run_job(job)
    assert (status.failed, status.stage, status.is_finished) == (1, "frames", False)
    assert "frame-000007.depth.png" in str(status) and "frames 0 to 13" in status.troubles
    with pytest.raises(FileError, match=r"(?s)is not finished: .*frame-000007"):
        loom.tiling.finish_fusion(job)
    path.write_bytes(content)
    assert retry_job(job).waiting == 1 and loom.tiling.run_job(job).is_finished
    np.testing.assert_array_equal(triangles_of(read_ply_mesh(loom.tiling.finish_fusion(job))), expected)


@pytest.mark.slow
def test_frames_without_a_pose_are_named_or_left_out(frames_copy, tmp_path):
    (frames_copy / "frame-000003.pose.txt").unlink()
    (frames_copy / "frame-000005.color.png").unlink()
    path = frames_copy / "frame-000009.depth.png"
    path.write_bytes(path.read_bytes()[:-200] + bytes(200))
    with pytest.raises(FileError, match=r"frame-000005"):
        loom.tiling.plan_fusion(frames_copy, tmp_path / "job", voxel_size=VOXEL)
    assert not (tmp_path / "job").exists()
    mesh = by_cubes(frames_copy, tmp_path / "job", size=2.0, leave_out=True)
    message = str(job_status(tmp_path / "job"))
    assert all(f"frame-00000{number}" in message for number in (3, 5, 9))
    for number in (3, 5, 9):
        for frame_file in frames_copy.glob(f"frame-00000{number}.*"):
            frame_file.unlink()
    threshold = 1  # of 12 frames that could be planned with, and of the 11 that can be read
    np.testing.assert_array_equal(triangles_of(mesh), triangles_of(fused(frames_copy, weight_threshold=threshold)))


def test_a_missing_pose_is_an_error_that_names_leave_out(frames_copy, tmp_path):
    (frames_copy / "frame-000003.pose.txt").unlink()
    with pytest.raises(FileError, match=r"frame-000003.*leave_out"):
        loom.tiling.plan_fusion(frames_copy, tmp_path / "job", voxel_size=VOXEL)


@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"size": 0.6}, "size"),
        ({"size": -1}, "size"),
        ({"truncation": 0.01}, "truncation"),
        ({"weight_threshold": -1}, "weight_threshold"),
        ({"every": 0}, "every"),
        ({"depth_max": float("nan")}, "depth_max"),
    ],
)
def test_invalid_arguments_are_rejected_before_files_are_written(frames, tmp_path, how, message):
    with pytest.raises(ValueError, match=message):
        loom.tiling.plan_fusion(frames, tmp_path / "job", **{"voxel_size": VOXEL} | how)
    assert not (tmp_path / "job").exists()


def test_a_cube_of_one_block_may_be_given_as_its_size(frames, tmp_path):
    loom.tiling.plan_fusion(frames, tmp_path / "job", voxel_size=VOXEL, size=8 * VOXEL)
    with Manifest(tmp_path / "job", is_job=True) as manifest:
        assert manifest.plan["blocks"] == 1


def test_another_plan_other_frames_and_another_kind_of_job_are_rejected(frames_copy, tmp_path):
    job = tmp_path / "job"
    first = loom.tiling.plan_fusion(frames_copy, job, voxel_size=VOXEL, size=20.0)
    assert loom.tiling.plan_fusion(frames_copy, job, voxel_size=VOXEL, size=20.0) == first
    with pytest.raises(FileError, match=r"blocks 6, was 31"):
        loom.tiling.plan_fusion(frames_copy, job, voxel_size=VOXEL, size=4.0)
    with pytest.raises(FileError, match="plan_fusion"):
        loom.tiling.run_tiles(job)
    loom.tiling.run_job(job)
    path = frames_copy / "frame-000007.depth.png"
    stat = path.stat()
    os.utime(path, ns=(0, 0))
    with pytest.raises(FileError, match=r"/own:.*0.*13"):
        loom.tiling.run_job(job)
    os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
    moved(frames_copy, (0.1, 0, 0))
    with pytest.raises(FileError, match="/own:"):
        loom.tiling.run_job(job)
    with pytest.raises(FileError, match="plan_fusion"):
        loom.tiling.run_job(tmp_path)


@pytest.mark.slow
def test_a_damaged_surface_is_named(frames, tmp_path):
    job = tmp_path / "job"
    by_cubes(frames, job, size=2.0)
    path = max((job / "cubes").iterdir(), key=lambda path: path.stat().st_size)
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(FileError, match=rf"{path.name} \(byte 1000\): a cube's surface cannot be read"):
        loom.tiling.finish_fusion(job)


def test_tasks_of_dead_workers_are_repeated_and_quarantined_after_three_deaths(frames, expected, tmp_path):
    job = tmp_path / "job"
    loom.tiling.plan_fusion(frames, job, voxel_size=VOXEL, size=20.0)
    with Manifest(job, is_job=True) as manifest:
        for death in range(3):
            assert manifest.claim("tasks", f"dead {death}")["name"] == "frames 0 to 13"
            manifest.release_claims()
    assert loom.tiling.run_job(job).aside == 1
    retry_job(job)
    with Manifest(job, is_job=True) as manifest, worker_lock(job) as alive:
        manifest.claim("tasks", alive)
        manifest.release_claims()
        assert job_status(job).running == 1
    assert loom.tiling.run_job(job).is_finished
    np.testing.assert_array_equal(triangles_of(read_ply_mesh(loom.tiling.finish_fusion(job))), expected)


@pytest.mark.slow
def test_parts_and_concurrent_runs_do_every_task_once(frames, expected, tmp_path, monkeypatch):
    job, done = tmp_path / "job", Counter()
    watch_calls(monkeypatch, fusion.FusionJob, "do", lambda job, stage, name, *_: done.update([name]))
    loom.tiling.plan_fusion(frames, job, voxel_size=VOXEL, size=2.0)
    assert loom.tiling.run_job(job, part=(1, 3)).done == 0
    assert not loom.tiling.run_job(job, part=(2, 3)).is_finished
    with ThreadPoolExecutor() as pool:
        [*pool.map(loom.tiling.run_job, [job, job])]
    assert job_status(job).is_finished and set(done.values()) == {1}
    np.testing.assert_array_equal(triangles_of(read_ply_mesh(loom.tiling.finish_fusion(job))), expected)


def test_progress_is_reported_for_frames_and_cubes(frames, tmp_path, monkeypatch):
    monkeypatch.setattr(fusion, "FRAMES_PER_TASK", 4)
    events = []
    loom.tiling.plan_fusion(frames, tmp_path / "job", voxel_size=VOXEL, size=20.0)
    loom.tiling.run_job(tmp_path / "job", progress=lambda *words: events.append(words))
    assert list(dict.fromkeys(stage for stage, _, _ in events)) == ["frames", "cubes"]
    assert events[0] == ("frames", 0, 4) and ("frames", 4, 4) in events and events[-1][1] == events[-1][2] > 0


def test_depth_units_of_a_plan_are_those_of_its_frames(frames, tmp_path):
    mesh = by_cubes(frames, tmp_path / "job", depth_scale=1250.0)
    one = loom.rgbd.fuse(loom.open_frames(frames, depth_scale=1250.0), voxel_size=VOXEL).mesh
    assert len(mesh.triangles) == len(one) > 100
