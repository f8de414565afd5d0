"""Readers of folders: models, data sets, depth maps, paged volumes, recordings, jobs.

A sound folder is made once. One file of it is damaged at a time, in a copy. Plans and tasks of jobs are changed in
their database. The error must name a file of the copy.
"""

from __future__ import annotations

import atexit
import contextlib
import functools
import json
import shutil
import sqlite3
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mutations
import numpy as np
from job_cases import anything, arrays, check_other_files, values

import pointloom as loom
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.photogrammetry.mvs.depth_maps import DepthMap
from pointloom.registration.lidar.lidar_submaps import CompactPoints, PointStore
from pointloom.tiling.manifest import NAME, canonical, hash_of

Make = Callable[[Path], Any]
_ALLOWED = ("FileError", "DatasetError", "ValueError")  # of a task with damaged input
VOXEL = 0.1  # [m] of the job of fusion


@functools.cache
def made(make: Make) -> Path:
    """A folder that a function fills; it is removed when the process ends."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        make(folder / "sound")
    return folder / "sound"


@contextlib.contextmanager
def copied(path: Path, make: Make) -> Any:
    """A copy of a folder beside the damaged file. Errors must name a file, and get the name of the damaged one."""
    folder = path.parent / "job"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(made(make), folder)
    try:
        yield folder
    except loom.FileError as error:
        if not Path(error.path).is_absolute():
            raise ValueError(f"the error names no file: {error}") from error
        raise loom.FileError(path, error.reason) from error


def member(
    name: str, make: Make, file: str, mutate: mutations.Mutation, read: Callable[[Path], Any]
) -> tuple[Any, ...]:
    """A case: one file of a folder is damaged."""

    def read_copy(path: Path) -> Any:
        with copied(path, make) as folder:
            shutil.copyfile(path, folder / file)
            return read(folder)

    return name, Path(file).suffix or ".bin", lambda: [(made(make) / file).read_bytes()], mutate, read_copy, anything


def _model(folder: Path, format: str) -> None:
    rng = np.random.default_rng(13)
    lens = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50.0, 32.0, 24.0, -0.05])
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, 0, 3] = 0.5
    points, rows = rng.random((3, 3)) + np.array([0, 0, 2]), [(i, j) for i in range(2) for j in range(3)]
    model = loom.SfmModel(
        ["a.jpg", "b.jpg"], [lens, lens], poses, points, rng.integers(0, 255, (3, 3)).astype(np.uint8), rng.random(3),
        rows, rng.random((6, 2)) * 40,
    )  # fmt: skip
    loom.write_colmap_model(folder, model, format=format)


def text_model(folder: Path) -> None:
    _model(folder, "txt")


def binary_model(folder: Path) -> None:
    _model(folder, "bin")


def room(folder: Path) -> None:
    write_room_sequence(folder, frame_count=3, width=32, height=24)


def matrix_room(folder: Path) -> None:
    """The room with its camera as a text of 3 x 3 numbers."""
    shutil.copytree(made(room), folder)
    K = json.loads((folder / "camera-intrinsics.json").read_text())["intrinsic_matrix"]
    (folder / "camera-intrinsics.json").unlink()
    (folder / "camera-intrinsics.txt").write_text("".join(f"{K[i]} {K[i + 3]} {K[i + 6]}\n" for i in range(3)))


def tum(folder: Path) -> None:
    """A data set in the layout of TUM."""
    for kind, ending in (("rgb", "color"), ("depth", "depth")):
        (folder / kind).mkdir(parents=True)
        lines = []
        for i, path in enumerate(sorted(made(room).glob(f"*.{ending}.png"))):
            shutil.copyfile(path, folder / kind / f"{i}.png")
            lines.append(f"{i}.0 {kind}/{i}.png\n")
        (folder / f"{kind}.txt").write_text("".join(lines))
    poses = "".join(f"{i}.0 {i} 0 0 0 0 0 1\n" for i in range(3))
    (folder / "groundtruth.txt").write_text(poses)


def recorded(folder: Path) -> None:
    loom.record_frames(loom.open_frames(made(room)), folder)


def read_dataset(folder: Path) -> Any:
    """Open a data set and read all frames."""
    return _frames_of(loom.open_dataset(folder))


def read_tum(folder: Path) -> Any:
    """The same in the layout of TUM, whose default camera has another size."""
    return _frames_of(loom.open_dataset(folder, intrinsic=loom.PinholeCameraIntrinsic(32, 24, 30, 30, 15.5, 11.5)))


def _frames_of(dataset: Any) -> list[Any]:
    return [repr(dataset), dataset.notes, [dataset.read(i) for i in range(len(dataset))]]


def depth_maps(folder: Path) -> None:
    camera = loom.photogrammetry.PosedCamera(loom.PinholeCameraIntrinsic(8, 6, 10.0, 10.0, 3.5, 2.5), np.eye(4))
    one = DepthMap(np.ones((6, 8)), np.tile([0, 0, -1.0], (6, 8, 1)), np.ones((6, 8)))
    loom.photogrammetry.DepthMaps([camera, camera], [(1,), (0,)], [one, one], folder=folder)


def read_maps(folder: Path) -> Any:
    return list(loom.photogrammetry.DepthMaps.open(folder))


def paged(folder: Path) -> None:
    volume = loom.PagedTSDFVolume(folder, voxel_size=0.1, page_blocks=1)
    camera = loom.PinholeCameraIntrinsic(16, 12, 15, 15, 7.5, 5.5)
    volume.integrate(np.full((12, 16), 900, np.uint16), camera, np.eye(4), np.full((12, 16, 3), 9, np.uint8))
    volume.save()


def read_paged(folder: Path) -> Any:
    return loom.PagedTSDFVolume.load(folder).extract_triangle_mesh(0.0)


def submaps(folder: Path) -> None:
    folder.mkdir()
    PointStore(folder).add(0, CompactPoints.of(np.arange(60, dtype=np.float32).reshape(-1, 3)))


def read_submaps(folder: Path) -> Any:
    return PointStore(folder).points(0)


def lidar_map(folder: Path) -> None:
    """A saved map of one scan, and the position of its submap."""
    points = np.random.default_rng(15).random((200, 3)) * [10, 10, 3]
    slam = loom.registration.LidarSLAM(max_range=20, min_range=0.1, folder=folder)
    readings = loom.registration.PositionReadings([0.0], [[1.0, 2.0, 3.0]])
    slam.register(loom.PointCloud(points), time=0.0, positions=readings)
    slam.finish()


def scans(folder: Path) -> None:
    rng = np.random.default_rng(14)
    folder.mkdir()
    ground = np.column_stack([rng.random((600, 2)) * 4, np.zeros(600)])
    wall = np.column_stack([rng.random(400) * 4, np.zeros(400), rng.random(400) * 2])
    for number in range(2):
        points = np.concatenate([ground, wall]) + np.array([0.05 * number, 0, 0])
        loom.write_point_cloud(folder / f"{number}.ply", loom.PointCloud(points))


def registration(folder: Path) -> None:
    """A planned job of two scans."""
    loom.tiling.plan_registration(sorted(made(scans).iterdir()), folder, voxel_size=0.2, pairs=[(0, 1)])


def fusion(folder: Path) -> None:
    """A planned job of three frames."""
    loom.tiling.plan_fusion(made(room), folder, voxel_size=VOXEL, size=8.0)


def run_registration(folder: Path) -> None:
    """The job with prepared scans, whose pairs wait."""
    shutil.copytree(made(registration), folder)
    loom.tiling.run_job(folder)
    _change(folder, "DELETE FROM tasks WHERE stage > 1", "UPDATE tasks SET state = 'waiting', found = NULL WHERE stage")


def run_fusion(folder: Path) -> None:
    """The job with all cubes done."""
    shutil.copytree(made(fusion), folder)
    loom.tiling.run_job(folder)


CHAIN = [
    {"step": "voxel_down_sample", "voxel_size": 0.5},
    {"step": "cluster_dbscan", "eps": 2.0, "min_points": 3},
    {"step": "rasterize", "cell": 1.0, "name": "dtm"},
]


def run_tiles(folder: Path) -> None:
    """A job of four tiles with sorted points and labels, whose tiles wait for their last pass."""
    points = np.random.default_rng(15).random((400, 3)) * (20, 20, 2)
    loom.write_point_cloud(folder.parent / "in.laz", loom.PointCloud(points))
    loom.tiling.plan_tiles([folder.parent / "in.laz"], CHAIN, folder, size=10.0)
    loom.tiling.run_tiles(folder)


def wait_again(folder: Path, number: int) -> Path:
    """Set all tiles of a finished job to waiting in this pass, and run it."""
    _change(folder, f"UPDATE tiles SET state = 'waiting', pass = {number}", "DELETE FROM checksums")
    return _tiles_done(folder)


def _tiles_done(folder: Path) -> Path:
    status = loom.tiling.run_tiles(folder)
    _check_errors(status.troubles)
    if status.is_finished:
        loom.tiling.finish_tiles(folder, overwrite=True)
    return folder


def _change(folder: Path, *statements: str) -> None:
    with contextlib.closing(sqlite3.connect(folder / NAME)) as base:
        for statement in statements:
            base.execute(statement)
        base.commit()


def _rows(make: Make, query: str) -> list[bytes]:
    with contextlib.closing(sqlite3.connect(made(make) / NAME)) as base:
        return [text.encode() for (text,) in base.execute(query)]


def _work_off(folder: Path, finish: Callable[..., Any]) -> Path:
    """Run a job. Raises RuntimeError if a task failed by another error than a documented one."""
    loom.tiling.job_status(folder)
    status = loom.tiling.run_job(folder)
    _check_errors(status.troubles)
    if status.is_finished:
        finish(folder)
    return folder


def _check_errors(errors: dict[str, str]) -> None:
    for error in errors.values():
        if not error.startswith(_ALLOWED):
            raise RuntimeError(error)


def in_job(name: str, make: Make, finish: Callable[..., Any], column: str) -> tuple[Any, ...]:
    """A case: the plan of a job, or a column of the tasks of its last stage, is changed, and the job is run."""
    rows = f"{column} IS NOT NULL AND stage = (SELECT MAX(stage) FROM tasks WHERE {column} IS NOT NULL)"
    of_tasks = f"SELECT {column} FROM tasks WHERE {rows}"
    query = "SELECT value FROM meta WHERE key = 'plan'" if column == "plan" else of_tasks

    def run(path: Path) -> Path:
        (path.parent / "kept").write_text("mine")
        text = path.read_bytes().decode("utf-8", "replace").replace("\0", "")
        with copied(path, make) as folder:
            with contextlib.closing(sqlite3.connect(folder / NAME)) as base:
                if column == "plan":
                    with contextlib.suppress(ValueError, RecursionError):
                        plan = json.loads(text)
                        text = canonical(plan)
                        base.execute("UPDATE meta SET value = ? WHERE key = 'hash'", (hash_of(plan),))
                    base.execute("UPDATE meta SET value = ? WHERE key = 'plan'", (text,))
                else:
                    base.execute(f"UPDATE tasks SET {column} = ? WHERE {rows}", (text,))
                base.commit()
            return _work_off(folder, finish)

    return name, ".json", lambda: _rows(make, query), values, run, check_other_files


def finish_fusion(folder: Path) -> Any:
    return loom.tiling.finish_fusion(folder, folder / "mesh.ply")


COLMAP = loom.read_cameras
ROOM, TUM = "data set, {}", "TUM, {}"

# name, suffix, seeds, mutate, read, oracle: as in cases.Case
FOLDERS = [
    *(member(f"COLMAP {name}.txt", text_model, f"{name}.txt", mutations.text, COLMAP)
      for name in ("cameras", "images", "points3D")),
    *(member(f"COLMAP {name}.bin", binary_model, f"{name}.bin", mutations.binary, COLMAP)
      for name in ("cameras", "images", "points3D")),
    member(ROOM.format("camera"), room, "camera-intrinsics.json", values, read_dataset),
    member(ROOM.format("matrix"), matrix_room, "camera-intrinsics.txt", mutations.text, read_dataset),
    member(ROOM.format("pose"), room, "frame-000001.pose.txt", mutations.text, read_dataset),
    member(ROOM.format("depth"), room, "frame-000001.depth.png", mutations.binary, read_dataset),
    member(ROOM.format("color"), room, "frame-000001.color.png", mutations.binary, read_dataset),
    member(TUM.format("list"), tum, "depth.txt", mutations.text, read_tum),
    member(TUM.format("poses"), tum, "groundtruth.txt", mutations.text, read_tum),
    member("depth maps, index", depth_maps, "depth_maps.json", values, read_maps),
    member("depth maps, map", depth_maps, "000000.npz", arrays, read_maps),
    member("recorded frames, times", recorded, "frame-times.txt", mutations.text, read_dataset),
    member("paged volume, state", paged, "volume.npz", arrays, read_paged),
    member("paged volume, page", paged, "00000001.npz", arrays, read_paged),
    member("LiDAR submap", submaps, "submap-000000.npz", arrays, read_submaps),
    member("LiDAR map", lidar_map, "map.npz", arrays, loom.registration.LidarSLAM.open),
    in_job("job of registration, plan", registration, loom.tiling.finish_registration, "plan"),
    in_job("job of registration, task", registration, loom.tiling.finish_registration, "told"),
    in_job("job of fusion, plan", fusion, finish_fusion, "plan"),
    in_job("job of fusion, task", fusion, finish_fusion, "told"),
    in_job("job of registration, result", run_registration, loom.tiling.finish_registration, "found"),
    in_job("job of fusion, result", run_fusion, finish_fusion, "found"),
    member("job of registration, surface", run_registration, "surfaces/0.npz", arrays,
           lambda folder: _work_off(folder, loom.tiling.finish_registration)),
    member("job of fusion, cube", run_fusion, "cubes/0_0_0.npz", arrays, finish_fusion),
    member("job of tiles, buckets", run_tiles, "buckets/000000/index.json", values, lambda f: wait_again(f, 0)),
    member("job of tiles, blocks", run_tiles, "buckets/000000/0.blocks", mutations.binary, lambda f: wait_again(f, 0)),
    member("job of tiles, labels", run_tiles, "left/1/0.npy", mutations.binary, lambda f: wait_again(f, 1)),
    member("job of tiles, joined labels", run_tiles, "joined/1/0.npy", mutations.binary, lambda f: wait_again(f, 1)),
    member("job of tiles, summary", run_tiles, "joined/1/whole.json", values, lambda f: wait_again(f, 1)),
    member("job of tiles, tile", run_tiles, "tiles/0_0.laz", mutations.binary,
           lambda folder: loom.tiling.finish_tiles(folder, overwrite=True)),
    member("job of tiles, raster", run_tiles, "rasters/dtm/0_0.tif", mutations.binary,
           lambda folder: loom.tiling.finish_tiles(folder, overwrite=True)),
]  # fmt: skip
