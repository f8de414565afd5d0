"""Process one tile, as a pure function of files, plan and results of earlier passes.

Rows are read in canonical order and search trees use one global curve, so sums and ties equal those of the complete
cloud. After each step only verified points are kept, at the end those of the tile.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..core.paths import job_file
from ..io.points.las_records import for_tiles
from ..io.points.las_wkt import with_system
from ..io.points.las_writer import fits_steps, with_scan_angle, write_las
from ..io.points.point_cloud import cloud_of, table_of
from ..io.table import PointTable
from ..kernels.memory import download
from ..kernels.search.distinct_points import distinct_points
from ..kernels.search.hilbert_order import HilbertCurve, levels_for
from ..kernels.search.point_tree import PointTree
from ..kernels.segmentation.neighbor_counts import mask_crowded
from ..pcd.search import NearestNeighborSearch
from .border_merging import read_joined, write_border_data
from .buckets import inside
from .epochs import read_epoch
from .exact_sums import ExactSums
from .halos import RADIUS_SLACK, halos_of
from .plan import Plan
from .rasters import write_raster
from .sources import file_of, read_rows
from .steps.raster import Rasterize
from .steps.reprojection import Reproject
from .steps.step import Part, Sight, Step

FOLDER = "tiles"
MAX_DOUBLINGS = 40


@dataclass(frozen=True)
class Outcome:
    """Result of a tile in one pass: points in and out, sums (for a join the count), CRC-32 of its file or None."""

    points_in: int
    points_out: int
    sums: ExactSums | None
    checksum: int | None = None


class HaloError(Exception):
    """A step of the k nearest saw too little data to verify its result."""

    def __init__(self, step: int):
        super().__init__(step)
        self.step = step


def work_tile(
    plan: Plan, folder: Path, tile: int, number: int, numbers: dict[int, ExactSums], fulls: dict[int, int]
) -> Outcome:
    """Run one pass over a tile. The last one writes its file if it has points."""
    iy, ix = divmod(tile, plan.shape[0])
    target = plan.passes[number]
    steps = plan.steps if target is None else plan.steps[: target + 1]
    chain = plan.steps if any(step.joins for step in steps) else steps  # steps whose halos must be equal in each pass
    radii = [step.radius for step in chain]
    for _ in range(MAX_DOUBLINGS):
        halos = halos_of(chain, radii, plan.slack)
        # Borders are rounded: read slightly more. The tile number decides.
        window = plan.window(ix, iy, max(halos[0], 4 * plan.slack))
        table, keys = read_rows(plan, folder, fulls, window)
        if not len(table.points):
            return Outcome(0, 0, ExactSums())
        part = _first_part(plan, table, keys)
        own = int((plan.tile_of(part.homes) == tile).sum())
        try:
            if not own and _keeps_homes(chain) and not any(step.writes for step in chain):
                return Outcome(0, 0, ExactSums())
            part, sums = _run(plan, folder, (ix, iy), part, steps, (radii, halos), numbers, fulls, target)
        except HaloError as error:
            radii[error.step] *= 2
            continue
        if target is None:
            part = part.select(plan.tile_of(part.homes) == tile)
        out = len(part.cloud) if target is None else 0
        checksum = write_tile(plan, folder, tile, part) if out else None
        return Outcome(own, out, sums, checksum)
    raise FileError(folder, f"tile {ix}_{iy}: the halo doubled {MAX_DOUBLINGS} times and was still too small")


def _keeps_homes(steps: list[Step]) -> bool:
    return all(step.spread_after(0.0) == 0.0 for step in steps)


def _first_part(plan: Plan, table: PointTable, keys: NDArray[np.int64]) -> Part:
    path = plan.sources[0]["path"]
    exact = np.asarray(table.points, np.float64)
    cloud = cloud_of(table, path, device=plan.device, origin=plan.origin)
    return Part(cloud, exact, exact[:, :2], keys=keys)


def _run(
    plan: Plan,
    folder: Path,
    index: tuple[int, int],
    part: Part,
    steps: list[Step],
    radii_halos: tuple[list[float], list[float]],
    numbers: dict[int, ExactSums],
    fulls: dict[int, int],
    target: int | None,
) -> tuple[Part, ExactSums | None]:
    radii, halos = radii_halos
    for k, step in enumerate(steps):
        if not len(part.cloud):
            return part, ExactSums()
        if step.searches and (step.radius > 0 or step.neighbors is not None):
            _adopt_tree(plan, part)
        after = plan.window(*index, halos[k + 1])
        wanted = _at_home(plan, part.homes, after, index)
        if step.neighbors is not None:
            _certify(plan, k, part, wanted, step.neighbors, radii[k], plan.window(*index, halos[k]))
        if k == target and step.joins:
            left = step.gather(part, _sight_of(plan, index, part, (halos[k] + halos[k + 1]) / 2))
            count = int(left["count"][0])
            if count:
                write_border_data(folder, k, index[1] * plan.shape[0] + index[0], left)
            return part, ExactSums(count)
        if k == target:
            return part, ExactSums.of(step.measure(part)[wanted])
        if isinstance(step, Rasterize) and target is None:
            write_raster(step, part.cloud, plan, folder, index)
        if step.epoch:
            halo = halos[k + 1] + step.radius * RADIUS_SLACK + part.spread + 4 * plan.slack
            around = plan.window(*index, halo, ends=True)
            part = part.with_epoch(read_epoch(plan, folder, fulls, step, around))
        global_result: Any = (
            read_joined(folder, k, index[1] * plan.shape[0] + index[0]) if step.joins else numbers.get(k)
        )
        part = step.run(part, plan, global_result).with_epoch(None)
        part = part.select(_at_home(plan, part.homes, plan.window(*index, halos[k + 1]), index))
    return part, None


def _at_home(plan: Plan, homes: NDArray[np.float64], window: Any, index: tuple[int, int]) -> NDArray[np.bool_]:
    """Mask of homes in a tile and its halo. Without a halo by tile number, which defines the rounding."""
    if window == plan.window(*index, 0.0):
        return plan.tile_of(homes) == index[1] * plan.shape[0] + index[0]
    x, y = homes[:, 0], homes[:, 1]
    return (x >= window[0]) & (y >= window[1]) & (x < window[2]) & (y < window[3])


def _sight_of(plan: Plan, index: tuple[int, int], part: Part, halo: float) -> Sight:
    """Sight of a tile within a halo. Other tiles have the same halo."""
    owners = plan.tile_of(part.homes)
    own = owners == index[1] * plan.shape[0] + index[0]
    unseen = inside(part.homes, plan.window(*index, -halo - plan.slack))
    return Sight(owners, own, own & ~unseen, _at_home(plan, part.homes, plan.window(*index, halo), index))


def _adopt_tree(plan: Plan, part: Part) -> None:
    """Build a cloud's search tree on the global curve."""
    points = part.cloud.arrays["points"]
    low, high = ((np.array(plan.data[end]) - plan.origin).astype(np.float32) for end in ("low", "high"))
    levels = plan.data["levels"]
    if levels > levels_for(points.size):
        raise ValueError(f"size: {points.size:,} points in a tile and its halo are too many. Plan smaller tiles")
    if part.cloud.arrays.tree.known is None:
        part.cloud.arrays.tree.adopt(PointTree(points, HilbertCurve(low, high, levels)))


def _certify(plan: Plan, number: int, part: Part, wanted: Any, k: int, radius: float, window: Any) -> None:
    """Raise HaloError unless each wanted point has k points nearer than missing data.

    If copies of a position may fill neighborhoods, k positions.
    """
    if not np.isfinite(window).any():
        return  # complete
    cloud, tree = part.cloud, part.cloud.search_tree()
    distinct = distinct_points(tree, k)
    if distinct is None:
        crowded = download(mask_crowded(tree, radius, k)) != 0
    else:
        cloud = cloud.select_by_index(download(distinct.firsts))
        crowded = download(mask_crowded(distinct.tree, radius, k))[download(distinct.rows)] != 0
    uncertain = np.flatnonzero(wanted & ~crowded)
    if not len(uncertain):
        return
    positions = part.cloud.points[uncertain]
    edges = np.array(window)
    free = np.minimum(positions[:, :2] - edges[:2], edges[2:] - positions[:, :2]).min(axis=1) - part.spread - plan.slack
    if k > len(cloud):
        raise HaloError(number)
    result = NearestNeighborSearch(cloud).knn_search(positions, k)
    farthest = np.sqrt(np.asarray(result.sqdists, np.float64)[:, -1]) * RADIUS_SLACK
    if not (farthest < free).all():
        raise HaloError(number)


def write_tile(plan: Plan, folder: Path, tile: int, part: Part) -> int:
    """Write a tile's points in the files' scale, unmoved positions exactly. Returns the CRC-32."""
    table = table_of(part.cloud)
    if part.exact is not None:
        table.points, table.origin = part.exact, None
    table = with_scan_angle(table)
    table.unit = None if plan.sources[0]["unit"] is None else table.unit
    first = file_of(plan.sources[0])
    header = for_tiles(first.header, first.layout, is_only=len(plan.sources) == 1)
    scales, offsets = header.scales, offset_of(plan)
    if isinstance(plan.steps[-1] if plan.steps else None, Reproject):
        params, table.unit, table.crs = plan.steps[-1].params, None, None
        scales, offsets, header = params["scales"], params["offsets"], with_system(header, params["wkt"])
    path = job_file(tile_path(plan, folder, tile))
    write_las(path, table, scale=scales, offset=offsets, like=header)
    return checksum_of(path)


def checksum_of(path: Path) -> int:
    checksum = 0
    with path.open("rb") as stream:
        while block := stream.read(1 << 20):
            checksum = zlib.crc32(block, checksum)
    return checksum


def tile_path(plan: Plan, folder: Path, tile: int) -> Path:
    iy, ix = divmod(tile, plan.shape[0])
    return folder / FOLDER / f"{ix}_{iy}.laz"


def offset_of(plan: Plan) -> list[float]:
    """Common offset of all tiles: the first file's, if all files are within its integer range."""
    first = plan.sources[0]
    low, high = np.array(plan.data["low"]), np.array(plan.data["high"])
    if fits_steps(low, high, first["scales"], first["offsets"]):
        return first["offsets"]
    return np.round((low + high) / 2).tolist()
