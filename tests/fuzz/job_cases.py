"""Readers of jobs and of values: areas, steps, indexes, cameras of frames, configurations, saved volumes, manifests.

Mutations change values, not only bytes: a file with a valid checksum and a wrong value passes the format's own checks.
A manifest is placed in the folder of a job, whose tiles are then processed.
"""

from __future__ import annotations

import atexit
import contextlib
import copy
import functools
import io
import json
import random
import shutil
import sqlite3
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mutations
import numpy as np

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.models.frame_cameras import read_transforms
from pointloom.registration.deformable.control_grid import ControlGrid
from pointloom.registration.deformable.control_grid_files import read_control_grid, write_control_grid
from pointloom.tiling.manifest import NAME, canonical, hash_of
from pointloom.tiling.polygons import parse_area
from pointloom.tiling.sources import files_of_index
from pointloom.tiling.status import tile_status
from pointloom.tiling.steps.parse import parse_steps

VALUES: list[Any] = [
    *(None, True, False, 0, -1, 2, 1.5, -0.0, 1e300, -1e300, 5e-324, 10**19, 2**63, -(2**63), 10**400, float("nan")),
    *("", "x", "a\0b", "\ud800", "../../x", "/etc/passwd", "a\x1b[31m", "9" * 400, [], {}, [[]], [{}], [1], {"a": 1}),
    *([[[0, 0]]], [None] * 3, [1e300] * 3, ["x"] * 3, [[1.0], [1.0, 2.0]], [[[[[[1]]]]]]),
]
ARRAYS: list[Callable[[Any], Any]] = [
    lambda a: a.astype(np.float32) if a.dtype.kind == "f" else a.astype(np.float64),
    lambda a: a[:0] if a.ndim else a,
    lambda a: a[None],
    lambda a: a.ravel(),
    lambda a: np.concatenate([a, a]) if a.ndim else np.stack([a, a]),
    lambda a: a[::-1] if a.ndim else a,
    *(lambda a, v=v: _with(a, v) for v in (0, 1, -1, 2, 255, 2**31, -(2**62), 1e300, -1e300, 5e-324, np.nan, np.inf)),
    lambda a: np.array("text"),
    lambda a: np.array(["a", "b"]),
    lambda a: a.astype(complex) if a.dtype.kind in "fiu" else a,
]


def _with(array: Any, value: float) -> Any:
    """An array with one different value, or that value alone."""
    if array.dtype.kind not in "biuf":
        return array
    failures = (OverflowError, ValueError, DeprecationWarning)  # NumPy 1 warns where NumPy 2 raises OverflowError
    with np.errstate(all="ignore"), warnings.catch_warnings(), contextlib.suppress(*failures):
        warnings.simplefilter("error", DeprecationWarning)
        changed = array.copy()
        changed.reshape(-1)[: random.Random(array.size).choice([1, max(1, array.size)])] = value
        return changed
    return array


def values(rng: random.Random, data: bytes) -> bytes:
    """JSON with one to three changed values; sometimes with changed bytes."""
    if rng.random() < 0.2:
        return mutations.text(rng, data)
    try:
        content = json.loads(data)
    except ValueError:
        return mutations.text(rng, data)
    for _ in range(rng.choice([1, 1, 2, 3])):
        locations = list(_locations(content))
        if not locations:
            break
        holder, key = rng.choice(locations)
        if rng.random() < 0.2:
            del holder[key]
        else:
            holder[key] = copy.deepcopy(rng.choice(VALUES))
    return json.dumps(content).encode()


def _locations(content: Any) -> Any:
    waiting = [content]
    while waiting:
        holder = waiting.pop()
        keys = list(holder) if isinstance(holder, dict) else range(len(holder)) if isinstance(holder, list) else ()
        for key in keys:
            yield holder, key
            waiting.append(holder[key])


def arrays(rng: random.Random, data: bytes) -> bytes:
    """An archive of arrays with one or two changed arrays and valid checksums."""
    if rng.random() < 0.1:
        return mutations.binary(rng, data)
    with np.load(io.BytesIO(data)) as file:
        content = dict(file)
    for name in rng.sample(sorted(content), rng.choice([1, 1, 2])):
        if rng.random() < 0.1:
            del content[name]
        else:
            content[name] = rng.choice(ARRAYS)(content[name])
    if rng.random() < 0.05:
        content["more"] = np.zeros(3)
    buffer = io.BytesIO()
    np.savez(buffer, **content)
    return buffer.getvalue()


def areas() -> list[bytes]:
    """GeoJSON and well-known text."""
    ring = [[0, 0], [4.5, 0], [4, 4], [0, 4], [0, 0]]
    polygon = {"type": "Polygon", "coordinates": [ring, [[1, 1], [2, 1], [2, 2], [1, 1]]]}
    several = {"type": "MultiPolygon", "coordinates": [[ring], [ring]]}
    nested = {"type": "GeometryCollection", "geometries": [polygon, several]}
    features = [{"type": "Feature", "properties": {}, "geometry": geometry} for geometry in (polygon, nested)]
    geometries = [polygon, several, {"type": "FeatureCollection", "features": features}]
    text = [b"POLYGON((0 0, 4.5 0, 4 4, 0 4),(1 1, 2 1, 2 2))", b"SRID=25832;MULTIPOLYGON Z (((0 0 1, 4 0 1, 4 4 1)))"]
    return [*(json.dumps(each, separators=(",", ":")).encode() for each in geometries), *text]


def steps() -> list[bytes]:
    """Steps of every class as TOML."""
    return [
        b'[[step]]\nstep = "voxel_down_sample"\nvoxel_size = 0.5\n\n[[step]]\nname = "estimate_normals"\nmax_nn = 12\n',
        b'[[step]]\nstep = "crop"\nmin_bound = [0, 0, -1.5]\nmax_bound = [1e3, 10, 4]\n\n[[step]]\nstep = "rasterize"\n'
        b'cell = 1.0\nname = "dtm"\n\n[[step]]\nstep = "function"\ncall = "none"\nreach = 0\narguments = {a = 1}\n',
        b'[[step]]\nstep = "m3c2"\nother = ["x.las"]\nnormal_radii = [3, 6]\ncylinder_radius = 3\nmax_distance = 4\n\n'
        b'[[step]]\nstep = "cluster_dbscan"\neps = 1.0\nmin_points = 4\n',
    ]


def indexes() -> list[bytes]:
    """A virtual point cloud of two missing files: its metadata is read first."""
    item = {"assets": {"data": {"href": "./a.las", "roles": ["data"]}}, "properties": {"pc:count": 3}}
    other = {"assets": {"x": {"href": "b%20c.laz"}}, "properties": {"proj:bbox": [0, 0, 0, 1, 1, 1]}}
    return [json.dumps({"type": "FeatureCollection", "features": [item, other]}).encode()]


def transforms() -> list[bytes]:
    """Two frames with a shared lens, and with individual lenses."""
    pose = np.eye(4).tolist()
    lens = {"fl_x": 500.0, "fl_y": 500.0, "cx": 32.0, "cy": 24.0, "w": 64, "h": 48, "k1": 0.1, "k2": 0.0}
    frames = [{"file_path": f"{name}.png", "transform_matrix": pose} for name in ("a", "b")]
    shared = lens | {"camera_model": "OPENCV", "frames": frames}
    return [json.dumps(documents).encode() for documents in (shared, {"frames": [frame | lens for frame in frames]})]


def configs() -> list[bytes]:
    """A configuration of the reconstruction system."""
    return [json.dumps(loom.rgbd.ReconstructionConfig().to_names()).encode()]


def bundles() -> list[bytes]:
    """Depth and cameras as written by Depth Anything 3."""
    K, T = np.array([[60.0, 0, 8], [0, 60, 6], [0, 0, 1]]), np.eye(4)[:3]
    bundle = {"depth": np.full((2, 12, 16), 2.0, np.float32), "conf": np.full((2, 12, 16), 5.0, np.float32)}
    return [_archive(**bundle, extrinsics=np.stack([T, T]), intrinsics=np.stack([K, K]))]


def _archive(**arrays: Any) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def saved(make: Callable[[Path], Any]) -> Callable[[], list[bytes]]:
    """A file saved by an object of the library."""

    def seeds() -> list[bytes]:
        with tempfile.TemporaryDirectory() as folder:
            make(Path(folder) / "x.npz")
            return [(Path(folder) / "x.npz").read_bytes()]

    return seeds


def write_volume(path: Path) -> None:
    volume = loom.TSDFVolume(voxel_size=0.1)
    camera = loom.PinholeCameraIntrinsic(16, 12, 15, 15, 7.5, 5.5)
    volume.integrate(np.full((12, 16), 900, np.uint16), camera, np.eye(4), np.full((12, 16, 3), 9, np.uint8))
    volume.save(path)


def _grid(path: Path) -> None:
    grid = loom.OccupancyGrid(0.5)
    grid.insert_scan(np.random.default_rng(0).random((20, 3)) * 2, [0.0, 0.0, 0.0])
    grid.save(path)


def _field(path: Path) -> None:
    cloud = loom.PointCloud([[0.05, 0.05, 0.05], [0.95, 0.05, 0.05]])
    loom.DistanceField.from_point_cloud(cloud, voxel_size=0.1, max_distance=1).save(path)


def _control(path: Path) -> None:
    grid = ControlGrid(0.5)
    grid.touch(loom.PointCloud(np.random.default_rng(0).random((20, 3))))
    write_control_grid(path, grid)


@functools.cache
def job() -> Path:
    """The folder of a planned job of one tile; it is removed when the process ends."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    points = np.random.default_rng(0).random((60, 3)) * 20
    loom.write_point_cloud(folder / "in.laz", loom.PointCloud(points))
    chain = [
        {"step": "voxel_down_sample", "voxel_size": 2.0},
        {"step": "crop", "min_bound": [0] * 3, "max_bound": [99] * 3},
    ]
    loom.tiling.plan_tiles([folder / "in.laz"], chain, folder / "job", size=30.0)
    return folder / "job"


def plans() -> list[bytes]:
    """The plan of a manifest as JSON."""
    with contextlib.closing(sqlite3.connect(job() / NAME)) as base:
        return [base.execute("SELECT value FROM meta WHERE key = 'plan'").fetchone()[0].encode()]


def manifests() -> list[bytes]:
    """A manifest as it is on disk."""
    return [(job() / NAME).read_bytes()]


def run_plan(path: Path) -> Path:
    """Replace the plan of a manifest, with a valid hash, and run the job."""
    with _copy(path) as folder, contextlib.closing(sqlite3.connect(folder / NAME)) as base:
        text = path.read_bytes().decode("utf-8", "replace")
        with contextlib.suppress(ValueError, RecursionError):
            plan = json.loads(text)
            text = canonical(plan)
            base.execute("UPDATE meta SET value = ? WHERE key = 'hash'", (hash_of(plan),))
        base.execute("UPDATE meta SET value = ? WHERE key = 'plan'", (text.replace("\0", ""),))
        base.commit()
        return _work_off(folder)


def run_manifest(path: Path) -> Path:
    """Put a damaged manifest into a job and run it."""
    with _copy(path) as folder:
        shutil.copyfile(path, folder / NAME)
        return _work_off(folder)


@contextlib.contextmanager
def _copy(path: Path) -> Any:
    folder, other_file = path.parent / "job", path.parent / "kept"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(job(), folder)
    other_file.write_text("mine")
    try:
        yield folder
    except FileError as error:
        raise FileError(
            path, str(error)
        ) from error  # the error names the manifest, a source of it, or a file of the job


def _work_off(folder: Path) -> Path:
    tile_status(folder)
    status = loom.tiling.run_tiles(folder)
    if status.is_finished:
        loom.tiling.finish_tiles(folder)
    return folder


def check_other_files(path: Path, folder: Path) -> str | None:
    """Describe changes of files beside the job, or return None."""
    names = sorted(each.name for each in path.parent.iterdir() if each.name != "log")
    return None if names == sorted(["job", "kept", path.name]) else f"files beside the job: {names}"


def anything(path: Path, result: Any) -> str | None:
    """Accept any result: there is no reference."""
    return None


def _area(path: Path) -> Any:
    return parse_area("only", path)


# name, suffix, seeds, mutate, read, oracle: as in cases.Case
JOBS = [
    ("area", ".geojson", areas, values, _area, anything),
    ("steps", ".toml", steps, mutations.text, parse_steps, anything),
    ("VPC", ".vpc", indexes, values, files_of_index, anything),
    ("transforms.json", ".json", transforms, values, read_transforms, anything),
    ("configuration", ".json", configs, values, loom.rgbd.ReconstructionConfig.read, anything),
    ("depth bundle", ".npz", bundles, arrays, loom.photogrammetry.read_depth_bundle, anything),
    ("volume", ".npz", saved(write_volume), arrays, loom.TSDFVolume.load, anything),
    ("occupancy grid", ".npz", saved(_grid), arrays, loom.OccupancyGrid.load, anything),
    ("distance field", ".npz", saved(_field), arrays, loom.DistanceField.load, anything),
    ("control grid", ".npz", saved(_control), arrays, read_control_grid, anything),
    ("plan of a manifest", ".json", plans, values, run_plan, check_other_files),
    ("manifest", ".sqlite", manifests, mutations.binary, run_manifest, check_other_files),
]
