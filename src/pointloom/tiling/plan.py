"""Plan tiles: files, steps and grid of a job, recorded once and verified later."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__  # pyright: ignore[reportMissingImports]
from ..core.checks import check_count, check_finite, check_positive, check_progress, check_shape, shown
from ..core.coordinates import choose_origin, lengths_of_axes, warn_if_rounded
from ..core.errors import FileError, FilePath
from ..core.paths import path_of
from ..core.progress import ReportProgress
from ..core.units import unit_of_text
from ..kernels.search.hilbert_order import levels_for
from .buckets import Window
from .epochs import describe_epochs
from .halos import far_files
from .job_folder import check_folder, make_folder, remove_on_failure
from .manifest import NAME, Manifest, canonical, damage_as_file_errors, files_of, hash_of, read_plan, write_manifest
from .plan_check import MAX_TILES, OUTPUTS
from .polygons import in_survey, overlapping_boxes, parse_area, to_json
from .sources import check_compatible, check_unchanged, describe_all, list_files, original_path, warn_of_lost_records
from .status import TileStatus, status_of
from .steps.function import Function, UserFunction, resolve_functions
from .steps.parse import naming_file, parse_steps
from .steps.step import Step

POINTS_PER_TILE = 2_000_000  # default per tile
MAX_POINTS = 8  # times the usual tile size: maximum points with halo, and its minimum
MIN_POINTS = 4_000_000
MIN_LEVELS = 12  # of the search curve, which defines the order of ties: 2^26 points per tile
_passed: dict[str, list[UserFunction]] = {}  # functions passed to `plan_tiles` in this process, by plan hash
_FLOAT32_ROUNDING = 2.0**-21  # relative float32 rounding of two points and their distance


class Plan:
    """Plan of a tiled job. `data` is the manifest's JSON form. `sources` describes the files; `epochs` those that steps
    compare with, as "paths" and "sources"; `files` all of them by number. `origin` (3,) is that of all tiles' clouds,
    `corner` (2,) that of the tile grid, of `shape` tiles of edge `size`.
    `slack` exceeds the rounding of coordinates. `max_points` is the maximum number of points of a tile with halo.
    `device` is not planned."""

    device = "cpu"

    def __init__(self, data: dict[str, Any]):
        self.data, self.sources, self.epochs = data, data["sources"], data["epochs"]
        self.files = files_of(data)
        self.steps: list[Step] = parse_steps(data["steps"])
        for step, radius in zip(self.steps, data["guesses"], strict=True):
            step.radius = radius
        self.origin = np.array(data["origin"])
        self.corner, self.size, self.shape = np.array(data["corner"]), data["size"], tuple(data["shape"])
        self.slack, self.max_points = data["slack"], data["most"]

    def numbered(self, epoch: int | None = None) -> list[tuple[int, dict[str, Any]]]:
        """Files of the survey or another epoch, with their numbers."""
        ends = np.cumsum([len(self.sources), *(len(other["sources"]) for other in self.epochs)]).tolist()
        first, last = (0, ends[0]) if epoch is None else (ends[epoch], ends[epoch + 1])
        return [*enumerate(self.files)][first:last]

    def tile_of(self, positions: NDArray[np.float64]) -> NDArray[np.int64]:
        """Tile number of each position (n, 2). The nearest tile's beyond the grid."""
        cells = np.floor((positions - self.corner) / self.size)
        cells = np.clip(cells, 0, np.array(self.shape) - 1).astype(np.int64)
        return cells[:, 1] * self.shape[0] + cells[:, 0]

    def tiles_in(self, window: Window) -> list[int]:
        """Numbers of the tiles that a window overlaps, ascending."""
        with np.errstate(invalid="ignore"):
            ends = np.floor((np.array(window).reshape(2, 2) - self.corner) / self.size)
        (x0, y0), (x1, y1) = (
            np.clip(ends + np.array([[-1], [1]]), 0, np.array(self.shape) - 1).astype(np.int64).tolist()
        )
        return [y * self.shape[0] + x for y in range(y0, y1 + 1) for x in range(x0, x1 + 1)]

    def window(self, ix: int, iy: int, halo: float, *, ends: bool = False) -> Window:
        """Window of a tile and its halo, open where there is no neighbor tile unless `ends`."""
        (nx, ny), (x, y), size = self.shape, self.corner.tolist(), self.size
        return (
            x + ix * size - halo if ix or ends else -math.inf,
            y + iy * size - halo if iy or ends else -math.inf,
            x + (ix + 1) * size + halo if ix + 1 < nx or ends else math.inf,
            y + (iy + 1) * size + halo if iy + 1 < ny or ends else math.inf,
        )

    @property
    def passed_functions(self) -> tuple[str, ...]:
        """Names, `module:function`, of functions passed in Python."""
        calls = [step.params["call"] for step in self.steps if isinstance(step, Function) and step.is_passed]
        return tuple(dict.fromkeys(calls))

    @property
    def passes(self) -> list[int | None]:
        """Step that each pass measures for. None for the last one, which runs all steps."""
        return [*(k for k, step in enumerate(self.steps) if step.needs_numbers or step.joins), None]

    @property
    def joined_passes(self) -> list[int]:
        """Passes whose results are joined before the next one."""
        return [number for number, k in enumerate(self.passes) if k is not None and self.steps[k].joins]


def plan_tiles(
    sources: Any,
    steps: Any,
    folder: FilePath,
    *,
    size: float | None = None,
    points: int | None = None,
    only: Any = None,
    only_crs: str | None = None,
    output: str = "laz",
    progress: ReportProgress | None = None,
) -> TileStatus:
    """Plan a tiled job in a folder: files, steps and tiles. Of LAS only headers are read.

    A folder with the same plan keeps its finished work. One with another plan is rejected. The result is bitwise that
    of the operations on the complete cloud, for any tile size, with these exceptions. The voxel grid starts half a
    voxel below the lowest coordinates of all files, also after steps that remove points, or at the step's `corner`.
    The status has this corner. Statistics of outliers are exact sums, so points within 1e-12 of the limit may differ.
    Ties for the k-th neighbor after a step that removed outer points may differ. Memory: 300 B per point of a tile and
    its halo. 4 million rows while sorting into tiles.

    Args:
        sources: Paths of .las and .laz files, folders of them, or a .vpc. COPC files are read by windows. Other LAS
            files are sorted into tiles on disk first. PLY, PCD, E57 and text files are first converted to LAZ in the
            folder, with a resolution of 1e-4 units, finer within 100. In a folder only if there is no LAS file.
        steps: Dictionaries such as `{"step": "voxel_down_sample", "voxel_size": 0.5}`, or a TOML file of [[step]]
            tables. Steps: voxel_down_sample, remove_radius_outlier, remove_statistical_outlier, estimate_normals,
            smooth_mls, crop, function, classify_ground, height_above_ground, rasterize, features, thin, distance, m3c2,
            cluster_dbscan, cluster_euclidean, reproject. The `call` of a function is a Python function (not in files)
            or an entry point of the group "pointloom.steps".
        folder: Folder of the job, created if missing.
        size: Edge of a tile [unit of the files].
        points: Approximate points per tile, default 2 million if there is no size.
        only: Process only tiles that touch an area: (x0, y0, x1, y1), or polygons: a .geojson, .json or .wkt file,
            POLYGON((...)), a GeoJSON dictionary, or corners (n, 2). Tile numbers stay those of the complete grid.
        only_crs: Coordinate system of these polygons, such as "EPSG:4326". If None: that of the files.
        output: Format of `finish_tiles`: "laz" or "copc".
        progress: Called with the activity, its progress and total while files are converted.

    Raises:
        FileError: If a file cannot be read, does not match the others or is in degrees, or the folder has another plan.
        ValueError: If a step or parameter is unknown, a step needs the complete cloud, or there are too many tiles.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((20_000, 3)) * (100, 100, 1)
        >>> loom.write_point_cloud("survey.laz", loom.PointCloud(points))
        >>> steps = [{"step": "voxel_down_sample", "voxel_size": 2}, {"step": "estimate_normals", "max_nn": 12}]
        >>> loom.tiling.plan_tiles("survey.laz", steps, "job", size=50).waiting
        4
        >>> loom.tiling.run_tiles("job").is_finished
        True
        >>> len(loom.read_point_cloud(loom.tiling.finish_tiles("job"))) < 5000
        True
    """
    parsed = parse_steps(steps)
    with naming_file(steps):
        passed = resolve_functions(parsed)
    if not isinstance(output, str) or output not in OUTPUTS:
        raise ValueError(f"output: expected {' or '.join(map(repr, OUTPUTS))}, got {shown(output)}")
    if size is not None and points is not None:
        raise ValueError("size, points: expected one of them, got both")
    paths, folder = list_files(sources), path_of(folder, "folder")
    if not (folder / NAME).exists():
        check_folder(folder)
    with remove_on_failure(folder):
        report = check_progress(progress)
        described = describe_all(paths, folder, report)
        check_compatible(described)
        warn_of_lost_records(described)
        with naming_file(steps):
            for step in parsed:
                step.adapt(described)
        data = _make(described, parsed, size, points, _area_of(only, only_crs, described), output)
        data["epochs"] = describe_epochs(parsed, described, folder, report)
        _passed[hash_of(data)] = passed
        if (folder / NAME).exists():
            with Manifest(folder) as manifest:
                check_same_plan(manifest, data)
                return status_of(manifest)
        joined = [step.name for step in parsed if step.joins]
        if only is not None and joined:
            raise ValueError(f"only: {joined[0]} needs all tiles. Add a crop step before it instead")
        make_folder(folder)
        plan = Plan(data)
        tiles = tiles_of(plan)
        write_manifest(folder, data, __version__, tiles, far_files(plan, tiles), plan.joined_passes)
    with Manifest(folder) as manifest:
        return status_of(manifest)


def open_plan(folder: FilePath) -> tuple[Manifest, Plan]:
    """Open a manifest and its plan. FileError if missing, or if version or files changed."""
    manifest = Manifest(path_of(folder, "folder"))
    try:
        if manifest.version != __version__:
            reason = f"was planned by pointloom {manifest.version}, this is {__version__}"
            raise FileError(manifest.folder / NAME, reason, remedy="Plan it again in another folder")
        for source in files_of(manifest.plan):
            check_unchanged(source)
        with damage_as_file_errors(manifest.folder / NAME):
            return manifest, Plan(manifest.plan)
    except BaseException:
        manifest.base.close()
        raise


def allow_functions(manifest: Manifest, plan: Plan, functions: Iterable[UserFunction | str]) -> None:
    """Set the functions of a plan's steps. FileError if the plan names another one."""
    if callable(functions) or isinstance(functions, str):
        raise TypeError(f"functions: expected a list of functions, got {shown(functions)}")
    try:
        resolve_functions(plan.steps, [*functions, *_passed.get(hash_of(manifest.plan), ())])
    except ValueError as error:
        remedy = "Pass the functions of a plan from another process: run_tiles(folder, functions=[...])"
        raise FileError(manifest.folder / NAME, str(error), remedy=remedy) from error


def plan_alone(folder: Path, functions: Iterable[str]) -> Plan:
    """Plan for a remote worker, without the manifest's locks, which require one machine."""
    plan = Plan(read_plan(folder))
    resolve_functions(plan.steps, functions)
    return plan


def check_same_plan(manifest: Manifest, plan: dict[str, Any]) -> None:
    changed = []
    if manifest.version != __version__:
        changed.append(f"pointloom is {__version__}, was {manifest.version}")
    if hash_of(manifest.plan) != hash_of(plan):
        for key in sorted({*manifest.plan, *plan}):
            before, now = manifest.plan.get(key), plan.get(key)
            if before == now:
                continue
            if key in ("sources", "epochs"):
                old, new = (_by_path(key, listed) for listed in (before, now))
                changed += [f"{path} is missing" for path in old if path not in new]
                changed += [f"{path} is new" for path in new if path not in old]
                changed += [f"{path} has changed" for path in new if path in old and new[path] != old[path]]
            else:
                changed.append(f"{key} {canonical(now)}, was {canonical(before)}")
    if changed:
        what = "a job" if "job" in plan else "the tiles"
        reason = f"contains {what} of another plan: {'; '.join(changed)}"
        raise FileError(manifest.folder, reason, remedy="Give another folder")


def _by_path(key: str, listed: Any) -> dict[str, Any]:
    if key == "epochs":
        listed = [source for epoch in listed or () for source in epoch["sources"]]
    return {source["path"]: source for source in listed or ()}


def _make(sources: Any, steps: list[Step], size: Any, points: Any, only: Any, output: str) -> dict[str, Any]:
    filled = [source for source in sources if source["points"]]
    if not filled:
        raise FileError(original_path(sources[0]), "the files contain no points")
    low = np.min([source["low"] for source in filled], axis=0)
    high = np.max([source["high"] for source in filled], axis=0)
    total = sum(source["points"] for source in filled)
    corners = np.array([end for source in filled for end in (source["low"], source["high"])])
    if not np.isfinite(corners).all():
        raise FileError(filled[0]["path"], "the bounds in a header are not finite")
    scales, unit = np.array(sources[0]["scales"]), unit_of_text(sources[0]["unit"] or "")
    origin = choose_origin(corners, scales)
    lengths = lengths_of_axes(None if unit is None else unit.meters, in_degrees=False)
    warn_if_rounded(original_path(sources[0]), corners, origin, scales, lengths)
    extent = np.maximum((high - low)[:2], np.max((high - low)[:2]) / 1000)  # also for collinear points
    area = max(float(np.prod(extent)), 1e-12)
    if size is None:
        fraction = check_count("points", POINTS_PER_TILE if points is None else points)
        size = math.sqrt(area * min(1.0, fraction / total)) * (1 + 1e-9)
        size = float(f"{size:.3g}") or float(np.max(sources[0]["scales"]))
    size = check_positive("size", size)
    with np.errstate(over="ignore"):
        columns, rows = (np.floor((high - low)[:2] / size) + 1).tolist()
    if columns * rows > MAX_TILES:
        raise ValueError(f"size: expected at most {MAX_TILES:,} tiles, got {columns:,g} x {rows:,g} of size {size}")
    max_coordinate = float(max(np.abs(low - origin).max(), np.abs(high - origin).max()))
    spacing = math.sqrt(area / total)
    guesses = [step.radius if step.neighbors is None else 2 * spacing * math.sqrt(step.neighbors) for step in steps]
    return {
        "sources": sources,
        "steps": [{"step": step.name} | step.params for step in steps],
        "guesses": guesses,
        "origin": origin.tolist(),
        "voxel_low": _lowest(filled).tolist(),
        "low": low.tolist(),
        "high": high.tolist(),
        "levels": max(levels_for(total), MIN_LEVELS),
        "corner": low[:2].tolist(),
        "size": size,
        "shape": [int(columns), int(rows)],
        "slack": max(max_coordinate, 1.0) * _FLOAT32_ROUNDING,
        "most": max(MIN_POINTS, int(MAX_POINTS * total * min(1.0, size * size / area))),
        "only": only,
        "output": output,
    }


def _lowest(sources: list[dict[str, Any]]) -> NDArray[np.float64]:
    """Lowest coordinates of the files (3,) as their readers compute them: headers may have fewer or more digits."""
    ends = []
    for source in sources:
        low, scales, offsets = (np.array(source[name], np.float64) for name in ("low", "scales", "offsets"))
        ends.append(np.rint((low - offsets) / scales) * scales + offsets)
    return np.min(ends, axis=0)


def _area_of(only: Any, crs: str | None, sources: list[dict[str, Any]]) -> list[Any] | None:
    is_row = isinstance(only, list | tuple) and np.shape(only[0] if only else 0) == ()
    is_box = is_row or (isinstance(only, np.ndarray) and only.ndim < 2)
    if crs is not None and (only is None or is_box):
        raise ValueError("only_crs: expected polygons in only=")
    if only is None:
        return None
    if is_box:
        return check_finite("only", check_shape("only", only, (4,))).tolist()
    return to_json(in_survey("only", parse_area("only", only), crs, sources))


def tiles_of(plan: Plan) -> list[tuple[Any, ...]]:
    """All tiles row by row, without those outside `only`, whose numbers are skipped."""
    (nx, ny), (x, y), size = plan.shape, plan.corner.tolist(), plan.size
    cells = np.stack(np.divmod(np.arange(nx * ny), nx)[::-1], axis=1)
    wanted = _touched(plan.data["only"], plan.corner + cells * size, plan.corner + (cells + 1) * size)
    if not wanted.any():
        raise ValueError(f"only: expected an area that overlaps the tiles, got {plan.data['only']}")
    return [
        (iy * nx + ix, ix, iy, x + ix * size, y + iy * size, x + (ix + 1) * size, y + (iy + 1) * size)
        for ix, iy in cells[wanted].tolist()
    ]


def _touched(area: list[Any] | None, lows: NDArray[np.float64], highs: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Mask of boxes (n, 2) that overlap the plan's area."""
    if area is None:
        return np.ones(len(lows), np.bool_)
    if isinstance(area[0], list):
        return overlapping_boxes(parse_area("only", area), lows, highs)
    return np.logical_and(*((lows <= area[2:]) & (highs > area[:2])).T)
