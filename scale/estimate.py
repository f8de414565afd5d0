"""What a job of tiles will take, from a calibration: some tiles worked off, and a count or sample of all points."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_progress
from ..core.dropped_results import returns_new
from ..core.progress import ReportProgress, say_nothing
from ..core.reports import Fields, Report
from .buckets import MOST_ROWS
from .calibration import Counts, Measured, calibrate
from .halos import far_files, halos_of
from .plan import Plan, open_plan, plan_tiles, tiles_of

_CLAIM = 0.01  # [s] of a tile beside its points: the manifest's transactions
_NOISE = 1.25  # that the same tile may take longer or shorter another time
_THINNED, _SAMPLED = 1.5, 1.15  # and where tiles were thinned, or counts are of a sample
_SHARES = (0.25, 0.5, 1.0)  # of all points that are in tiles of fewer points than those that are worked off


@dataclass(frozen=True)
class Estimate:
    """A figure with its range."""

    value: float = 0.0
    low: float = 0.0
    high: float = 0.0

    @classmethod
    def of(cls, value: float) -> Estimate:
        """A figure without a range."""
        return cls(value, value, value)

    @returns_new
    def times(self, factor: float) -> Estimate:
        """The figure so many times."""
        return Estimate(self.value * factor, self.low * factor, self.high * factor)

    @returns_new
    def spread(self, factor: float) -> Estimate:
        """The figure with a range that is wider by a factor on both sides."""
        return Estimate(self.value, self.low / factor, self.high * factor)

    def __add__(self, other: Estimate) -> Estimate:
        return Estimate(self.value + other.value, self.low + other.low, self.high + other.high)


@dataclass(frozen=True)
class TileEstimate(Report):
    """What a job of tiles will take.

    Attributes:
        workers: Processes.
        tiles: Tiles with points.
        points: Points in the files.
        seconds: From the first tile to the last, without `finish_tiles`.
        cpu_seconds: Of all workers together.
        memory: Of a worker [bytes].
        temporary: On disk while tiles are worked off [bytes].
        output: Of the tiles' files, and of the file made of them once more [bytes].
        points_out: That the steps leave.
        calibration: What was measured.
        poor: What speaks against the plan, or None.
    """

    workers: int
    tiles: int
    points: int
    seconds: Estimate
    cpu_seconds: Estimate
    memory: Estimate
    temporary: Estimate
    output: Estimate
    points_out: Estimate
    calibration: str
    poor: str | None

    def fields(self) -> Fields:
        """Each figure with its range."""
        return [
            (
                "tiles",
                f"{self.tiles:,} with {self.points:,} points, for {self.workers} worker{'s' * (self.workers > 1)}",
            ),
            ("time", _in_words(self.seconds, _time)),
            ("CPU time", _in_words(self.cpu_seconds, _time)),
            ("memory", f"{_in_words(self.memory, _size)} a worker"),
            ("temporary", f"{_in_words(self.temporary, _size)} on disk"),
            ("output", f"{_in_words(self.output, _size)}, {_in_words(self.points_out, _count)} points"),
            ("measured", self.calibration),
        ]


def estimate_tiles(
    sources: Any,
    steps: Any,
    *,
    size: float | None = None,
    points: int | None = None,
    only: Any = None,
    only_crs: str | None = None,
    output: str = "laz",
    workers: int = 1,
    progress: ReportProgress = say_nothing,
) -> TileEstimate:
    """Estimate what a job of tiles takes, before it is planned: time, memory, temporary disk, output.

    Three tiles, of median and high density, are worked off in a temporary folder, each in a process of its own whose
    CPU time and peak of memory are measured; of files without windows the rows of these tiles go through the pass that
    lays points by tile. How many points the other tiles hold is counted, or from 8 million points on estimated from a
    sample of rows; of COPC files the octree tells it.

    Args:
        sources, steps, size, points, only, only_crs, output: As of `plan_tiles`.
        workers: Processes, on one machine.
        progress: Called with "calibration", how many tasks are done, and how many there are.

    Returns:
        A TileEstimate; each figure has a range. Its time is that of this machine with nothing else to do.

    Raises:
        FileError: As of `plan_tiles`; there is no room in the temporary folder.
        ValueError: As of `plan_tiles`; a step fails at a tile.

    Notes:
        On surveys of uneven density the figures were within a factor of 2 of the runs (docs/tiles.md). Where the
        files of the chosen tiles hold more than 33 million rows, and know no windows, only every so-manieth row is
        read: steps then see fewer neighbours than they will, which the range and `calibration` say.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((20_000, 3)) * (100, 100, 1)
        >>> loom.write_point_cloud("survey.laz", loom.PointCloud(points))
        >>> steps = [{"step": "voxel_down_sample", "voxel_size": 2}]
        >>> told = loom.scale.estimate_tiles("survey.laz", steps, size=50, workers=2)
        >>> told.tiles, told.points, told.memory.low <= told.memory.value <= told.memory.high
        (4, 20000, True)
    """
    workers, report, cores = check_count("workers", workers), check_progress(progress), os.cpu_count() or 1
    threads = int(os.environ.get("POINTLOOM_CPU_THREADS") or max(1, cores // workers))
    with tempfile.TemporaryDirectory(prefix="pointloom-estimate-") as place:
        folder = Path(place)
        options: Any = {"size": size, "points": points, "only": only, "only_crs": only_crs, "output": output}
        plan_tiles(sources, steps, folder / "plan", progress=report, **options)
        manifest, plan = open_plan(folder / "plan")
        with manifest:
            ids = np.array([row["id"] for row in manifest.rows("SELECT id FROM tiles ORDER BY id")])
        counts = Counts(plan)
        own = counts.within(0.0).ravel()[ids]
        halo = halos_of(plan.steps, [step.reach for step in plan.steps], plan.slack)[0]
        chosen = _choose(own, counts.within(halo).ravel()[ids], plan.most)
        (folder / "tiles").mkdir()
        laid, measured, share = calibrate(plan, ids[chosen].tolist(), folder / "tiles", threads, report)
    reads = [counts.within(_halo_of(measured, number)).ravel()[ids] for number in range(len(measured[0].read))]
    spread = _NOISE * (_THINNED if share < 1 else 1.0) * (_SAMPLED if counts.is_sample else 1.0)
    cpu, seconds = _times(plan, measured, laid, reads, workers, threads)
    join, left = _joins(own, measured)
    cpu, seconds = cpu + join, seconds + join
    crowded = max(1.0, workers * threads / cores)
    out = _over(own, [one.points for one in measured], [one.out for one in measured])
    file_size = sum(one.size for one in measured) / max(1, sum(one.out for one in measured))
    written = out.spread(1.2).times(file_size)
    densest = max(float(read.max()) for read in reads)
    return TileEstimate(
        workers=workers,
        tiles=int((own > 0.5).sum()),
        points=sum(source["points"] for source in plan.sources),
        seconds=seconds.times(crowded).spread(spread),
        cpu_seconds=cpu.spread(spread),
        memory=_memory(plan, measured, laid, densest).spread(1.25),
        temporary=_buckets(plan, laid) + left + (written if output == "copc" else Estimate()),
        output=written,
        points_out=out.spread(1.1),
        calibration=_said(measured, laid, threads, share, counts.is_sample),
        poor=None if densest <= plan.most else _too_dense(densest, plan.most),
    )


def _choose(own: NDArray[np.float64], read: NDArray[np.float64], most: int) -> NDArray[np.int64]:
    """Tiles of median and high density, of those that may be worked off: half of the points are in tiles of fewer."""
    filled = np.flatnonzero((own > 0.5) & (read <= most))
    if not len(filled):
        filled = np.array([int(np.where(own > 0.5, read, np.inf).argmin())])
    order = filled[np.argsort(own[filled], kind="stable")]
    below = np.cumsum(own[order]) / own[order].sum()
    return order[sorted({min(int(np.searchsorted(below, share)), len(order) - 1) for share in _SHARES})]


def _halo_of(measured: list[Measured], number: int) -> float:
    return float(np.median([one.halos[number] for one in measured]))


def _over(
    counts: NDArray[np.float64],
    at: list[int],
    costs: list[float] | list[int],
    *,
    intercept: float = 0.0,
    among: int = 0,
) -> Estimate:
    """The cost of all tiles by their points, along the lines through what was measured; or the time of workers.

    The range is that of the least and the most cost of a point among the measured tiles.
    """
    order = np.argsort(at, kind="stable")
    points = np.maximum(1.0, np.array(at, np.float64)[order])
    values = np.array(costs, np.float64)[order]
    rates = values / points
    cells = np.interp(counts, [0.0, *points], [intercept, *values])
    beyond = counts > points[-1]
    cells[beyond] = counts[beyond] * rates[-1]
    whole = max(float(cells.sum()), 1e-30)
    total = max(whole / among, float(cells.max())) if among else whole
    ends = [float(counts.sum() * rate) * total / whole for rate in (rates.min(), rates.max())]
    return Estimate(total, min(total, ends[0]), max(total, ends[1]))


def _times(
    plan: Plan, measured: list[Measured], laid: Measured | None, reads: list[Any], workers: int, threads: int
) -> tuple[Estimate, Estimate]:
    """CPU time of all workers, and time from the beginning to the end."""
    cpu = seconds = Estimate()
    for number, read in enumerate(reads):
        at = [one.read[number] for one in measured]
        busy = [one.cpu[number] for one in measured]
        took = busy if threads == 1 else [one.wall[number] for one in measured]
        cpu += _over(read, at, busy, intercept=_CLAIM)
        seconds += _over(read, at, took, intercept=_CLAIM, among=workers)
    if laid is not None:
        rows = [source["points"] for source in plan.files if source["kind"] != "copc"]
        rate = laid.cpu[0] / max(1, laid.points)
        cpu += Estimate.of(rate * sum(rows))
        seconds += Estimate.of(rate * max(sum(rows) / workers, max(rows)))
    start = float(np.median([one.start for one in measured]))
    return cpu + Estimate.of(start * workers), seconds + Estimate.of(start)


def _joins(own: NDArray[np.float64], measured: list[Measured]) -> tuple[Estimate, Estimate]:
    """CPU time of joins, each by one worker while the others wait, and bytes on disk for them."""
    if not any(one.left for one in measured):
        return Estimate(), Estimate()
    at = [one.points for one in measured]
    seconds, size = _over(own, at, [one.join for one in measured]), _over(own, at, [one.left for one in measured])
    return seconds, size.spread(1.5)


def _memory(plan: Plan, measured: list[Measured], laid: Measured | None, densest: float) -> Estimate:
    """The most of a worker: of the densest tile, or of the pass that lays points by tile."""
    base = min(one.base for one in measured)
    rates = [(one.peak - one.base) / max(1, *one.read) for one in measured]
    peaks = [base + rate * densest for rate in rates]
    most = max(measured, key=lambda one: max(one.read))
    value = base + (most.peak - base) * max(1.0, densest / max(1, *most.read))
    if laid is not None:
        rows = max(min(source["points"], MOST_ROWS) for source in plan.files if source["kind"] != "copc")
        value = max(value, base + (laid.peak - laid.base) * max(1.0, rows / max(1, min(laid.points, MOST_ROWS))))
    return Estimate(value, min(value, *peaks), value)


def _buckets(plan: Plan, laid: Measured | None) -> Estimate:
    if laid is None:
        return Estimate()
    far = far_files(plan, tiles_of(plan))
    rows = sum(f["points"] for number, f in enumerate(plan.files) if f["kind"] != "copc" and number not in far)
    return Estimate.of(laid.size / max(1, laid.points) * rows).spread(1.2)


def _said(measured: list[Measured], laid: Measured | None, threads: int, share: float, is_sample: bool) -> str:
    """What the calibration was made on."""
    points = ", ".join(f"{one.points:,}" for one in measured)
    told = [
        f"{len(measured)} tile{'s' * (len(measured) > 1)} of {points} points, by {threads} thread{'s' * (threads > 1)}"
    ]
    if laid is not None:
        told.append(f"{laid.points:,} rows laid by tile")
    if share < 1:
        told.append(f"of every {1 / share:.1f} rows one: neighbours are fewer than they will be")
    told.append("points of tiles " + ("from a sample of rows" if is_sample else "counted"))
    return "; ".join(told)


def _too_dense(densest: float, most: int) -> str:
    return f"a tile and its halo hold about {densest:,.0f} points, at most {most:,} may be: take smaller tiles"


def _in_words(figure: Estimate, word: Any) -> str:
    if not figure.high:
        return "none"
    return f"{word(figure.value)} ({word(figure.low)} to {word(figure.high)})"


def _time(seconds: float) -> str:
    if seconds < 120:
        return f"{seconds:.1f} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 120 else f"{minutes / 60:.1f} h"


def _size(size: float) -> str:
    return f"{size / 1e6:,.1f} MB" if size < 1e8 else f"{size / 1e9:,.2f} GB"


def _count(count: float) -> str:
    return f"{count:,.0f}"
