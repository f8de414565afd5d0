"""A calibration of a plan: some of its tiles worked off in a folder beside it, each in a process that is measured.

Files with windows are read as they are. Of others the rows of the chosen tiles and their halos are written to files of
their own, which go through the pass that lays points by tile as all rows will.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__  # pyright: ignore[reportMissingImports]
from ..core.errors import FileError
from ..core.progress import ReportProgress
from ..core.timing import peak_bytes
from ..files.foreign import foreign_errors, import_for
from ..files.points.copc import octree_of
from ..files.points.las import LasFile, open_las
from ..files.points.laszip import unpack_beginnings
from .borders import JOINED, LEFT, Leavings, join_step
from .buckets import FOLDER as BUCKETS
from .buckets import Window, fill_buckets, inside, positions_of
from .exact_sums import ExactSums
from .halos import halos_of
from .manifest import files_of, write_manifest
from .plan import Plan, allow_functions, open_plan
from .sources import describe
from .work_tile import FOLDER as TILES
from .work_tile import tile_path, work_tile

WHOLE = 8_000_000  # rows up to which all of a survey's are counted, and more are a sample
SAMPLE = 400_000
MOST_REPEATED = 20.0  # [s] that a tile takes which is worked off twice, to know what loading kernels takes
MOST_READ = 1 << 25  # rows that are read for the chosen tiles; of more every so-manieth
_READ = 1 << 18
FILES = "files"
_PROGRAM = "from pointloom.scale.calibration import main; main()"


@dataclass(frozen=True)
class Measured:
    """What a tile, or the pass that lays points by tile, took.

    Attributes:
        points: Of the tile, or rows that were laid.
        read: With the halo, of each pass.
        halos: Their widths.
        cpu, wall: Seconds of each pass.
        start: Seconds before the first one, with the loading of kernels.
        base, peak: Memory before and at most [bytes].
        out: Points that the steps left.
        size: Of the tile's file, or of the buckets [bytes].
        left: Of what it leaves for joins, and of what they give it [bytes].
        join: CPU seconds of joins.
    """

    points: int
    read: list[int]
    halos: list[float]
    cpu: list[float]
    wall: list[float]
    start: float
    base: int
    peak: int
    out: int
    size: int
    left: int = 0
    join: float = 0.0


class Counts:
    """Where the points of a plan are, from all rows of a small survey and from a sample of a large one.

    Attributes:
        is_sample: Whether it is a sample.
    """

    def __init__(self, plan: Plan):
        self._plan, self.is_sample = plan, False
        nx, ny = plan.shape
        self._cells = max(1, min(8, int((4_000_000 / (nx * ny)) ** 0.5)))
        self._grid = np.zeros((ny * self._cells, nx * self._cells))
        total = sum(source["points"] for source in plan.sources)
        for source in plan.sources:
            file = open_las(source["path"])
            if total <= WHOLE:
                for block in file.rows(_READ):
                    self._add(positions_of(file, block), 1.0)
            elif source["kind"] == "copc":
                self._add_nodes(file)
            elif source["points"]:
                self.is_sample = True
                places = file.sample(max(1, SAMPLE * source["points"] // total)).points[:, :2]
                self._add(np.asarray(places), source["points"] / len(places))

    def _add(self, places: NDArray[np.float64], weight: Any) -> None:
        ny, nx = self._grid.shape
        cell = np.floor((places - self._plan.corner) / (self._plan.size / self._cells)).astype(np.int64)
        cell = np.clip(cell, 0, (nx - 1, ny - 1))
        weights = np.broadcast_to(weight, len(cell))
        self._grid += np.bincount(cell[:, 1] * nx + cell[:, 0], weights, self._grid.size).reshape(ny, nx)

    def _add_nodes(self, file: LasFile) -> None:
        """Points of a COPC file, as if even in each node."""
        copc = octree_of(file)
        widths = copc.side / 2.0 ** copc.nodes["level"]
        lows = (copc.corner + copc.nodes["cell"] * widths[:, None])[:, :2]
        ends = np.minimum(lows + widths[:, None], file.header.bounds[1][:2])
        lows = np.maximum(lows, file.header.bounds[0][:2])
        parts = (np.arange(8) + 0.5) / 8
        for x in parts:
            for y in parts:
                self._add(lows + (ends - lows) * (x, y), copc.nodes["count"] / 64)

    def within(self, halo: float) -> NDArray[np.float64]:
        """About how many points each tile and its halo have, [ny, nx]."""
        total = np.pad(self._grid, ((1, 0), (1, 0))).cumsum(0).cumsum(1)
        for axis in range(2):
            count = self._plan.shape[1 - axis]
            begins = np.arange(count) * self._cells
            wide = halo / self._plan.size * self._cells
            ends = [_between(total, np.clip(at, 0, total.shape[axis] - 1), axis)
                    for at in (begins - wide, begins + self._cells + wide)]  # fmt: skip
            total = ends[1] - ends[0]
        return total


def _between(values: NDArray[np.float64], at: NDArray[np.float64], axis: int) -> NDArray[np.float64]:
    """Values between the rows or columns, linear."""
    low = np.minimum(np.floor(at).astype(np.int64), values.shape[axis] - 2)
    share = (at - low).reshape((-1, 1) if axis == 0 else (1, -1))
    return values.take(low, axis) * (1 - share) + values.take(low + 1, axis) * share


def calibrate(
    plan: Plan, tiles: list[int], folder: Path, threads: int, report: ReportProgress
) -> tuple[Measured | None, list[Measured], float]:
    """Work tiles of a plan off in a folder; what the files' pass took, what each tile took, and the share of rows read.

    Raises:
        FileError: A file cannot be read, or the folder's disk is full.
        ValueError: A step fails at a tile.
    """
    told, share = _sampled(plan, tiles, folder)
    for name in (TILES, BUCKETS):
        (folder / name).mkdir()
    write_manifest(folder, told, __version__, [])
    report("calibration", 0, len(tiles) + 1)
    laid, functions = None, plan.passed_functions
    if any(source["kind"] != "copc" for source in files_of(told)):
        laid = _measured(folder, FILES, threads, functions)
    report("calibration", 1, len(tiles) + 1)
    found = []
    for tile in tiles:
        found.append(_measured(folder, str(tile), threads, functions))
        report("calibration", len(found) + 1, len(tiles) + 1)
    return laid, found, share


def _sampled(plan: Plan, tiles: list[int], folder: Path) -> tuple[dict[str, Any], float]:
    """The plan with files that hold the rows of some tiles alone, and the least share of rows that was read."""
    halo = halos_of(plan.steps, [step.reach for step in plan.steps], plan.slack)[0]
    nx = plan.shape[0]
    windows = [plan.window(tile % nx, tile // nx, 2.5 * halo) for tile in tiles]
    sources, least = _sample_of(plan.sources, windows, folder)
    if not sources:
        raise FileError(plan.sources[0]["path"], "no points were found in the tiles that were chosen for a calibration")
    epochs = []
    for number, epoch in enumerate(plan.epochs):
        there, share = _sample_of(epoch["sources"], windows, folder, f"{number}-")
        epochs.append(epoch | {"sources": there or epoch["sources"][:1]})
        least = min(least, share)
    return plan.told | {"sources": sources, "epochs": epochs}, least


def _sample_of(
    listed: list[dict[str, Any]], windows: list[Window], folder: Path, mark: str = ""
) -> tuple[list[dict[str, Any]], float]:
    """Files beside a folder with the rows of some windows, those that know windows themselves, and the share read."""
    chosen = [source for source in listed if source["points"] and _meets_any(source, windows)]
    rows = sum(source["points"] for source in chosen if source["kind"] != "copc")
    least, sources = 1.0, []
    for number, source in enumerate(chosen):
        if source["kind"] == "copc":
            sources.append(source)
            continue
        path = folder.with_name(f"{mark}{number:06d}{Path(source['path']).suffix}")
        most = source["points"] if rows <= MOST_READ else max(1, MOST_READ * source["points"] // rows)
        least = min(least, most / source["points"])
        if _write_rows(Path(source["path"]), path, windows, most):
            sources.append(describe(path))
    return sources, least


def _meets_any(source: dict[str, Any], windows: list[Window]) -> bool:
    low, high = source["low"], source["high"]
    return any(low[0] <= w[2] and low[1] <= w[3] and high[0] >= w[0] and high[1] >= w[1] for w in windows)


def _write_rows(path: Path, target: Path, windows: list[Window], most: int) -> int:
    """Write the rows of a file that are in some windows, of at most so many that are read; how many they are."""
    file = open_las(path)
    laspy: Any = import_for(path, "laspy", "las")
    with laspy.open(path) as first:
        header = first.header
    written = 0
    with (
        target.open("wb") as stream,
        foreign_errors(target, "cannot be written"),
        laspy.LasWriter(stream, header, do_compress=file.header.is_compressed, closefd=False) as writer,
    ):
        for rows in _rows(file, most):
            places = positions_of(file, rows)
            keep = np.any([inside(places, window) for window in windows], axis=0)
            record = laspy.ScaleAwarePointRecord(
                np.ascontiguousarray(rows[keep]), file.layout, header.scales, header.offsets
            )
            if len(record):
                writer.write_points(record)
            written += len(record)
        if header.evlrs:
            writer.write_evlrs(header.evlrs)
    return written


def _rows(file: LasFile, most: int) -> Any:
    if file.header.point_count <= most:
        yield from file.rows(_READ)
    elif file.header.is_compressed:
        yield np.frombuffer(unpack_beginnings(file.path, file.header, most), file.layout.dtype())
    else:
        step = -(-file.header.point_count // most)
        for rows in file.rows(_READ * step):
            yield rows[::step]


def _measured(folder: Path, what: str, threads: int, functions: tuple[str, ...]) -> Measured:
    """Do a task in a process of its own, `files` or the number of a tile; what it took."""
    paths = os.pathsep.join(path or os.getcwd() for path in sys.path)  # noqa: PTH109
    environment = os.environ | {"PYTHONPATH": paths, "POINTLOOM_CPU_THREADS": str(threads)}
    command = [sys.executable, "-P", "-c", _PROGRAM, str(folder.absolute()), what, *functions]
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines() or [f"it ended with {done.returncode}"]
        place = "the pass over files" if what == FILES else f"tile {what}"
        raise ValueError(f"steps: the calibration failed at {place}: {lines[-1]}")
    return Measured(**json.loads(done.stdout.splitlines()[-1]))


def main() -> None:
    """A process of a calibration: `main FOLDER TILE FUNCTION...`, or `files` for TILE; prints a Measured as JSON."""
    begin = time.monotonic() - time.process_time()  # which imports have taken
    folder, what = Path(sys.argv[1]), sys.argv[2]
    manifest, plan = open_plan(folder)
    allow_functions(manifest, plan, sys.argv[3:])
    manifest.base.close()
    base = _peak()
    told = _lay(plan, folder) if what == FILES else _work(plan, folder, int(what), begin)
    print(json.dumps({"base": base, "peak": _peak()} | told))


def _lay(plan: Plan, folder: Path) -> dict[str, Any]:
    filled, begin, cpu = [], time.monotonic(), time.process_time()
    for number, source in enumerate(plan.files):
        if source["kind"] != "copc":
            filled.append(fill_buckets(plan, folder, number, "calibration"))
    took = {"cpu": [time.process_time() - cpu], "wall": [time.monotonic() - begin], "start": 0.0}
    points, size = (sum(getattr(one, name) for one in filled) for name in ("points", "size"))
    return took | {"points": points, "read": [points], "halos": [0.0], "out": points, "size": size}


def _work(plan: Plan, folder: Path, tile: int, begin: float) -> dict[str, Any]:
    fulls = {}
    for number in range(len(plan.files)):
        index = folder / BUCKETS / f"{number:06d}" / "index.json"
        fulls[number] = json.loads(index.read_text())["full"] if index.exists() else 65535
    before = time.monotonic() - begin
    rounds: list[dict[str, Any]] = []
    while len(rounds) < 2:  # the first loads kernels, too
        took: dict[str, Any] = {"read": [], "halos": [], "cpu": [], "wall": [], "left": 0, "join": 0.0}
        numbers: dict[int, ExactSums] = {}
        for number, step in enumerate(plan.passes):
            at, cpu = time.monotonic(), time.process_time()
            found = work_tile(plan, folder, tile, number, numbers, fulls)
            took |= {"points": found.points_in, "out": found.points_out}
            took["read"].append(found.points_read)
            took["halos"].append(found.halo)
            took["cpu"].append(time.process_time() - cpu)
            took["wall"].append(time.monotonic() - at)
            if step is not None and plan.steps[step].joins:
                size, seconds = _join(plan, folder, step, {tile: found.sums.count if found.sums else 0})
                took |= {"left": took["left"] + size, "join": took["join"] + seconds}
            elif step is not None:
                numbers[step] = found.sums or ExactSums()
        rounds.append(took)
        if sum(took["wall"]) > MOST_REPEATED:
            break
    start = before + max(0.0, sum(rounds[0]["wall"]) - sum(rounds[-1]["wall"]))
    path = tile_path(plan, folder, tile)
    return rounds[-1] | {"start": start, "size": path.stat().st_size if path.exists() else 0}


def _join(plan: Plan, folder: Path, step: int, counts: dict[int, int]) -> tuple[int, float]:
    """Join what a tile left alone; its bytes with what it gets, and CPU seconds."""
    cpu, counts = time.process_time(), {tile: count for tile, count in counts.items() if count}
    join_step(folder, step, plan.steps[step], Leavings(folder, step, counts, is_whole=False), "calibration")
    paths = [folder / name / str(step) / f"{tile}.npy" for name in (LEFT, JOINED) for tile in counts]
    return sum(path.stat().st_size for path in paths), time.process_time() - cpu


def _peak() -> int:
    """The most memory since the program began; the system's own count has that of the process that started it, too."""
    try:
        for line in Path("/proc/self/status").read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
    except OSError:
        pass
    return peak_bytes()
