"""Host work of every operation, counted exactly: Python calls, launches and allocations.

The operations are those of benchmarks/digests.py on small scenes, clouds that share their arrays with the caller, and
single scans of LiDAR odometry. Operations on clouds are counted at three sizes, the others on their one scene. The
table emulated_cuda/host_calls.json contains the limits for the CPU (test_host_calls.py) and for the emulated CUDA
device (emulated_cuda/test_host_calls.py). emulated_cuda/host_calls.py writes it.
"""

from __future__ import annotations

import gc
import inspect
import json
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp

import pointloom as loom
from pointloom.kernels import lang  # noqa: F401  starts Warp without its banner
from pointloom.kernels.arrays.scattered_sums import sum_by_index
from pointloom.kernels.language import device_arrays, prepared_launches, warp_parts
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling.farthest_in_batch import choose_in_batch
from pointloom.kernels.search.batch_neighbors import search_batch
from pointloom.kernels.search.cloud_batch import CloudRows

from .small_scenes import COUNT, ON_CLOUDS, ON_HOST, ONCE, SmallScenes, digest_scenes, scenes

TABLE = Path(__file__).parent / "emulated_cuda" / "host_calls.json"
SIZES = (COUNT, 2_503, 4_001)  # points; no block size divides them
CPU, CUDA = "cpu", "cuda:0"
MAX_RUNS = 6  # of an operation, until two successive counts are equal
DENSE, SPARSE = 20_000, 6_000  # points of a room: each voxel has a plane, or only wide neighborhoods have one
WRITER = "python tests/emulated_cuda/host_calls.py"
WHY = "why"  # the key of a row's reason
FILES = (
    *("file ", "write and read", "read_las_chunks", "tsdf, save and load", "distance field, save", "occupancy, save"),
    *("mesh, write", "pose graph, write and read"),
)
# Over 0.05 s of CPU time each; they are counted on the emulated device only.
SLOW_ON_CPU = (
    *("coherent_point_drift", "detect_shapes", "fit_shape", "icp, held", "iterate_odometry", "mesh, create_from_point"),
    *("mesh, texture", "mvs, estimate_depth", "mvs, fuse", "odometry", "points picked", "ransac, pairs", "register_"),
    *(
        "rgbd odometry",
        "robust registration",
        "room, film",
        "run_reconstruction_system",
        "SLAC",
        "slam, ",
        "tsdf, paged",
    ),
)
Counts = dict[str, int]
Row = dict[str, Any]  # a number for each column, or a list of one for each size; "why": the reason of the last rise
Table = dict[str, dict[str, Row]]  # by device and operation
Work = Callable[[], Any]
Preparation = Callable[[int], Work]  # makes the input for a size, and returns the work on it


class UnstableCountsError(AssertionError):
    """An operation does different work each time it runs."""


class CountedScenes(SmallScenes):
    """Small scenes of a device. Clouds on a GPU return Warp arrays, so downloads are results or internal transfers."""

    def __init__(self, device: str) -> None:
        super().__init__(device)
        self._surfaces: dict[int, digest_scenes.SampledSurface] = {}

    def cloud(self, points: Any, **attributes: Any) -> Any:
        cloud = super().cloud(points, **attributes)
        return cloud if self.device == CPU else cloud.to(self.device, arrays="warp")

    @property
    def surface(self) -> digest_scenes.SampledSurface:
        return self.surfaces(COUNT)

    def surfaces(self, count: int) -> digest_scenes.SampledSurface:
        if count not in self._surfaces:
            made = self._surfaces[count] = self.sample(count, 10)
            _ = made.facing, made.source  # inputs of some operations
        return self._surfaces[count]


@contextmanager
def conditions(device: str) -> Iterator[None]:
    """The conditions of all counts. On a GPU the clouds of the scenes return Warp arrays.

    On the CPU there is one thread, since loops until nothing changes take fewer iterations if threads are lucky. Small
    arrays of a GPU are in blocks.
    """
    plain, blocks = digest_scenes.textured, device_arrays.blocks
    device_arrays.blocks = device_arrays.BLOCKS
    if device == CPU:
        loom.set_num_threads(1)
    else:
        digest_scenes.textured = lambda *given: plain(*given).to(device, arrays="warp")
    try:
        yield
    finally:
        digest_scenes.textured, device_arrays.blocks = plain, blocks
        if device == CPU:
            loom.set_num_threads(None)


class Operations:
    """The operations of a device. `on_clouds` run at three sizes, `on_scenes` on one scene."""

    def __init__(self, device: str) -> None:
        data = CountedScenes(device)
        left_out = (*ON_HOST, *FILES, "ransac, checkers", *(SLOW_ON_CPU if device == CPU else ()))
        self.device = device
        self.on_clouds: dict[str, Preparation] = {
            name: lambda count, run=run: lambda: run(data.surfaces(count)) for name, run in ON_CLOUDS.items()
        }
        self.on_clouds |= shared_arrays(data)
        self.on_scenes: dict[str, Preparation] = {
            name: lambda _, run=run: lambda: run(data) for name, run in ONCE.items() if not name.endswith("far")
        }
        for works in (self.on_clouds, self.on_scenes):
            for name in [name for name in works if name.startswith(left_out)]:
                del works[name]
        self.on_scenes |= {**lidar_scans(data), **cloud_batches(data)}
        self.all = {**self.on_clouds, **self.on_scenes}

    def sizes_of(self, name: str) -> tuple[int, ...]:
        """Numbers of points. For an operation on a scene one number without a meaning."""
        return SIZES if name in self.on_clouds else SIZES[:1]


def shared_arrays(data: CountedScenes) -> dict[str, Preparation]:
    """Clouds over arrays of the caller: the constructor, a first operation, and operations after the tree has been
    built, which compare the points with those of the tree unless they are frozen."""
    again: dict[str, Callable[[Any], Any]] = {
        "estimate_normals": lambda cloud: cloud.estimate_normals(max_nn=15),
        "cluster_dbscan": lambda cloud: cloud.cluster_dbscan(0.1, 5),
    }

    def arrays(count: int, library: str) -> tuple[Callable[..., Any], dict[str, Any]]:
        points = scenes.bumpy_surface(count, 90).astype(np.float32)
        given = {"points": points, "normals": points.copy(), "intensity": np.arange(count, dtype=np.float32)}
        if library == "NumPy":
            return loom.PointCloud.from_dlpack, given
        types = {"intensity": wp.float32}
        return loom.PointCloud, {
            name: wp.array(values, dtype=types.get(name, wp.vec3), device=data.device) for name, values in given.items()
        }

    def work(count: int, library: str, title: str) -> Work:
        make, given = arrays(count, library)
        if title == "constructor":
            return lambda: make(**given)
        if title == "constructor and estimate_normals":
            return lambda: make(**given).estimate_normals(max_nn=15)
        cloud, operation = make(**given, frozen=title.endswith("frozen")), again[title.split(" ")[0]]
        _ = operation(cloud)
        return lambda: operation(cloud)

    libraries = ("NumPy", "Warp") if data.device == CPU else ("Warp",)  # a GPU cannot share arrays of NumPy
    return {
        f"shared {library} arrays, {title}": lambda count, library=library, title=title: work(count, library, title)
        for library in libraries
        for title in (
            *("constructor", "constructor and estimate_normals"),
            *(f"{name} again{frozen}" for name in again for frozen in ("", ", frozen")),
        )
    }


def cloud_batches(data: CountedScenes) -> dict[str, Preparation]:
    """What pointloom.torch runs on a batch: few large clouds and many small ones of the same points, as Warp arrays."""
    points = scenes.bumpy_surface(4_096, 91).astype(np.float32)

    def work(count: int, run: Callable[[Any, Any], Any]) -> Work:
        size = len(points) // count
        tables = np.arange(count) * size, np.full(count, size)
        rows = CloudRows(*(upload(table, wp.int32, data.device) for table in tables), len(points))
        given = upload(points, wp.vec3, data.device)
        return lambda: run(given, rows)

    index = upload(np.arange(3 * len(points)) * 7 % len(points), wp.int64, data.device)
    values = upload(np.ones((index.size, 3), np.float32), wp.float32, data.device)
    runs: dict[str, Callable[[Any, Any], Any]] = {
        "neighbors": lambda p, rows: search_batch(p, rows, p, rows, 8, np.inf, True),
        "farthest points": lambda p, rows: choose_in_batch(p, rows, 8),
        "sums by index": lambda p, rows: sum_by_index(values, index, len(points)),
    }
    return {
        f"batch of {count} clouds, {name}": lambda _, run=run, count=count: work(count, run)
        for name, run in runs.items()
        for count in (4, 512)
    }


def room_seen_from(x: float, count: int) -> np.ndarray:
    """Points of the walls of a room relative to a position in it, the same ones for each position."""
    rng, rows = np.random.default_rng(0), np.arange(count)
    room = rng.uniform(-8, 8, (count, 3)) * [1, 1, 0.3]
    room[rows, rows % 3] = np.where(rng.random(count) < 0.5, -1, 1) * 8.0
    return room - [x, 0, 0]


def lidar_scans(data: CountedScenes) -> dict[str, Preparation]:
    """A scan of LiDAR odometry after some others. In the street every motion is undetermined."""

    def last_of(scans: list[Any], **options: Any) -> Work:
        odometry = loom.registration.LidarOdometry(device=data.device, **options)
        for scan in scans[:-1]:
            odometry.register(scan)
        return lambda: odometry.register(scans[-1])

    def in_room(count: int) -> Work:
        scans = [data.cloud(room_seen_from(0.1 * k, count)) for k in range(4)]
        return last_of(scans, max_range=30, min_range=0.5)

    return {
        "odometry, a scan of a dense room": lambda _: in_room(DENSE),
        "odometry, a scan of a sparse room": lambda _: in_room(SPARSE),
        "odometry, a scan of a sparse street": lambda _: last_of(data.scans, voxel_size=1.0),
    }


class PythonCalls:
    """Counts calls of the library's functions, and launches on the CPU, in the calling thread.

    Frames of comprehensions and of generators do not count, since Python versions differ in them. The garbage collector
    is off meanwhile: finalizers of reference cycles would count.
    """

    package = str(Path(loom.__file__).parent) + "/"
    launcher = prepared_launches.__file__
    launches_of = ("WarpLaunch.run", "WarpLaunch.bound_packed.<locals>.<lambda>")  # bound_alone is host algebra
    not_counted = inspect.CO_GENERATOR | inspect.CO_COROUTINE | inspect.CO_ASYNC_GENERATOR
    comprehensions = ("<listcomp>", "<setcomp>", "<dictcomp>")

    def __init__(self) -> None:
        self.calls = self.launches = 0
        self._is_counted: dict[str, bool] = {}  # by file

    def _record(self, frame: Any, event: str, _: Any) -> None:
        if event != "call":
            return
        code = frame.f_code
        file = code.co_filename
        is_counted = self._is_counted.get(file)
        if is_counted is None:
            is_counted = self._is_counted[file] = file.startswith(self.package)
        if not is_counted or code.co_flags & self.not_counted or code.co_name in self.comprehensions:
            return
        self.calls += 1
        self.launches += file == self.launcher and code.co_qualname in self.launches_of

    def __enter__(self) -> PythonCalls:
        self._was_collecting, self._before = gc.isenabled(), sys.getprofile()
        gc.disable()
        sys.setprofile(self._record)
        return self

    def __exit__(self, *_: object) -> None:
        sys.setprofile(self._before)
        if self._was_collecting:
            gc.enable()


def count_on_cpu(work: Work) -> Counts:
    """Launches, arrays of Warp's CPU allocator with their bytes, and Python calls of a call."""
    core, sizes = warp_parts.core(), []
    allocate = core.wp_alloc_host

    def counting(size: int, tag: Any) -> Any:
        sizes.append(size)
        return allocate(size, tag)

    core.wp_alloc_host = counting
    try:
        with PythonCalls() as calls:
            result = work()  # released after the count
    finally:
        core.wp_alloc_host = allocate
    del result
    return {"launches": calls.launches, "allocations": len(sizes), "allocated": sum(sizes), "python": calls.calls}


def settled_counts(count: Callable[[], Counts], limits: Mapping[str, int] | None = None) -> Counts:
    """Count until no count exceeds its limit, or two successive counts are equal. The first runs are warm-up."""
    before: Counts | None = None
    for _ in range(MAX_RUNS):
        counts = count()
        if limits is not None and not exceeded(counts, limits):
            return counts
        if counts == before:
            return counts
        before, last = counts, before
    assert last is not None
    changed = {column: (last[column], n) for column, n in counts.items() if n != last[column]}
    raise UnstableCountsError(
        f"expected two successive equal counts in {MAX_RUNS} runs, got {changed} (the last two runs). "
        "Work that depends on time, addresses or earlier calls cannot be counted."
    )


def exceeded(counts: Mapping[str, int], limits: Mapping[str, int]) -> list[str]:
    """The columns whose count exceeds the limit. A column without a limit has not been counted before."""
    return [column for column, n in counts.items() if n > limits.get(column, n)]


def read_table() -> Table:
    return json.loads(TABLE.read_text()) if TABLE.exists() else {}


def limits_at(row: Row, k: int) -> Counts:
    """The limits of a row at size k. A shorter list has no limit there yet."""
    limits = {column: n for column, n in row.items() if column != WHY}
    lists = {column: n[k] for column, n in limits.items() if isinstance(n, list) and k < len(n)}
    return {column: n for column, n in limits.items() if not isinstance(n, list)} | lists


def row_of(counts: list[Counts]) -> Row:
    """A row of the counts at each size."""
    row: Row = {}
    for column in counts[0]:
        values = [at_size[column] for at_size in counts]
        row[column] = values[0] if len(set(values)) == 1 else values
    return row


def rises(name: str, device: str, sizes: tuple[int, ...], row: Row, counts: list[Counts]) -> list[str]:
    """A message for each count that exceeds its limit."""
    return [
        message
        for k, at_size in enumerate(counts)
        for message in rises_at(name, device, sizes, k, limits_at(row, k), at_size)
    ]


def rises_at(name: str, device: str, sizes: tuple[int, ...], k: int, limits: Counts, counts: Counts) -> list[str]:
    """A message for each count at size k that exceeds its limit."""
    where = f"at {sizes[k]:,} points" if len(sizes) > 1 else "on its scene"
    return [
        f"{name} on {device} {where}: {column}: limit {limits[column]:,}, got {counts[column]:,}"
        for column in exceeded(counts, limits)
    ]


def assert_within_limits(
    works: Operations, name: str, count: Callable[[Work], Counts], row: Row, sizes: slice = slice(None)
) -> None:
    """Fail if an operation exceeds the limits of its row at one of the sizes."""
    indices = range(len(works.sizes_of(name)))[sizes]
    messages = []
    for k in indices:
        size = works.sizes_of(name)[k]
        limits = limits_at(row, k)
        counts = settled_counts(lambda size=size: count(works.all[name](size)), limits)
        messages += rises_at(name, works.device, works.sizes_of(name), k, limits, counts)
    if messages:
        command = f"{WRITER} --device {works.device} --only {json.dumps(name)} --write --why REASON"
        raise AssertionError("\n".join([*messages, f"Reduce the work, or raise the limits: {command}"]))


def merged(row: Row, counts: list[Counts], why: str | None) -> Row:
    """A row with the new counts. Without a reason no limit rises."""
    lowered = [
        {column: n if why else min(n, limits_at(row, k).get(column, n)) for column, n in at_size.items()}
        for k, at_size in enumerate(counts)
    ]
    reason = why or row.get(WHY)
    return row_of(lowered) | ({WHY: reason} if reason else {})


def write_table(table: Table) -> None:
    """Write one line for each operation of each device."""
    devices = []
    for device, rows in sorted(table.items()):
        lines = [f"    {json.dumps(name)}: {json.dumps(row)}" for name, row in sorted(rows.items())]
        devices.append(f"  {json.dumps(device)}: {{\n" + ",\n".join(lines) + "\n  }")
    TABLE.write_text("{\n" + ",\n".join(devices) + "\n}\n")
