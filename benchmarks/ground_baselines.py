"""Compare `classify_ground` with PMF and CSF on tiles with known ground and on synthetic quarries.

    POINTLOOM_DATA=... python benchmarks/ground_baselines.py [--write]     needs pip install cloth-simulation-filter

PMF is the progressive morphological filter (Zhang et al., IEEE TGRS 41, 2003) with windows that grow exponentially, as
PDAL's `filters.pmf`. CSF is the cloth simulation filter (Zhang et al., Remote Sensing 8, 2016), by its authors. Both
have the settings with the highest mean kappa on the tiles, of 24 and 7 settings (2026-11-29). `--write` writes the
table into docs/terrain.md.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator

import numpy as np
from ground import PAGE, Errors, compare, tiles
from numpy.typing import NDArray
from pages import write_between
from real_data import real_data

Array = NDArray[np.float64]
Labels = NDArray[np.bool_]

CELL = 1.0  # [m], of all filters
PMF_WINDOW, PMF_SLOPE, PMF_INITIAL, PMF_MAX = 33.0, 0.3, 0.5, 2.5  # [m], rise over run, [m], [m]
CLOTH_CELL, RIGIDNESS, SMOOTH_SLOPES, CLOTH_DISTANCE = 1.0, 1, True, 0.5  # [m], 1 to 3, post-processing, [m]
TIME_STEP, ITERATIONS = 0.65, 500  # as the authors recommend
QUARRIES, SEEDS = ("pit", "wall", "hill"), range(10, 14)  # no constant was chosen on these seeds
SIDE, GROUND_POINTS = 150.0, 45_000  # of a quarry: [m], points


def progressive_filter(points: Array) -> Labels:
    """Ground by PMF."""
    from scipy import ndimage
    from scipy.spatial import KDTree

    at = np.floor((points[:, :2] - points[:, :2].min(0)) / CELL).astype(int)
    heights = np.full(at.max(0) + 1, np.inf)
    np.minimum.at(heights, tuple(at.T), points[:, 2])
    known, empty = np.argwhere(np.isfinite(heights)), np.argwhere(np.isinf(heights))
    if len(empty):
        heights[tuple(empty.T)] = heights[tuple(known[KDTree(known).query(empty)[1]].T)]
    ground, before, limit = np.ones(len(points), bool), 1, PMF_INITIAL
    for width in (2**k + 1 for k in range(1, 30)):
        if width * CELL > PMF_WINDOW:
            break
        if before > 1:
            limit = min(PMF_SLOPE * (width - before) * CELL + PMF_INITIAL, PMF_MAX)
        heights, before = ndimage.grey_opening(heights, (width, width), mode="nearest"), width
        ground &= points[:, 2] - heights[tuple(at.T)] < limit
    return ground


def cloth_filter(points: Array) -> Labels:
    """Ground by CSF."""
    import CSF  # pyright: ignore[reportMissingImports]

    cloth = CSF.CSF()
    cloth.params.cloth_resolution, cloth.params.rigidness = CLOTH_CELL, RIGIDNESS
    cloth.params.bSloopSmooth, cloth.params.class_threshold = SMOOTH_SLOPES, CLOTH_DISTANCE
    cloth.params.time_step, cloth.params.interations = TIME_STEP, ITERATIONS
    cloth.setPointCloud(points - points.mean(0))
    rows, others = CSF.VecInt(), CSF.VecInt()
    cloth.do_filtering(rows, others, False)
    ground = np.zeros(len(points), bool)
    ground[np.array(rows, int)] = True
    return ground


def own_filter(points: Array) -> Labels:
    """Ground by pointloom with the slope that is adapted to quarries. Those of the tiles are as by default."""
    import pointloom as loom

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # steep terrain
        return np.asarray(loom.classify_ground(loom.PointCloud(points), slope=None))


FILTERS: dict[str, Callable[[Array], Labels]] = {
    "pointloom": own_filter,
    "PMF": progressive_filter,
    "CSF": cloth_filter,
}


def quarry(kind: str, seed: int) -> tuple[Array, Labels]:
    """Points of terraces of 5 to 10 m with vehicles and trees, and their ground.

    "pit" rises to all borders, "wall" to one of them, "hill" to its center.
    """
    rng = np.random.default_rng(seed)
    x, y = rng.random((2, GROUND_POINTS)) * SIDE
    height, width, face = rng.uniform(5, 10), rng.uniform(10, 16), rng.uniform(1, 3)
    radius = np.hypot(x - SIDE / 2, y - SIDE / 2)
    if kind == "pit":
        distance = radius - rng.uniform(15, 30)
    elif kind == "wall":
        distance = x - rng.uniform(20, 50) + 5 * np.sin(y / 20)
    else:
        distance = rng.uniform(50, 65) - radius
    terraces = np.maximum(distance, 0) / width
    steps, slant = np.floor(terraces), face / width
    z = height * (steps + np.clip((terraces - steps - 1 + slant) / slant, 0, 1)) + 0.02 * x
    z += rng.normal(0, 0.05, GROUND_POINTS)
    objects = np.zeros(GROUND_POINTS, bool)
    for _ in range(12):
        center, angle = rng.random(2) * SIDE, rng.uniform(0, np.pi)
        u = (x - center[0]) * np.cos(angle) + (y - center[1]) * np.sin(angle)
        v = (y - center[1]) * np.cos(angle) - (x - center[0]) * np.sin(angle)
        inside = (abs(u) < rng.uniform(2, 5)) & (abs(v) < rng.uniform(1.2, 2))
        if inside.any():
            z[inside] = np.median(z[inside]) + rng.uniform(2.5, 4.5)
            objects |= inside
    for _ in range(40):
        center, crown = rng.random(2) * SIDE, rng.uniform(1.5, 4)
        inside = (np.hypot(x - center[0], y - center[1]) < crown) & (rng.random(GROUND_POINTS) < 0.6)
        z[inside] += rng.uniform(1.5, 8, inside.sum())
        objects |= inside
    return np.column_stack([x, y, z]), ~objects


def rows() -> Iterator[tuple[str, list[Errors]]]:
    """Name and errors by filter, of each tile and of eight quarries of each kind."""
    for name, (points, truth) in tiles(real_data("lidar-pcl-terrain")).items():
        yield name, [compare(run(points), truth) for run in FILTERS.values()]
    for kind in QUARRIES:
        cases = [[compare(run(p), truth) for run in FILTERS.values()] for p, truth in (quarry(kind, s) for s in SEEDS)]
        yield f"quarry, {kind}", [_mean(errors) for errors in zip(*cases, strict=True)]


def _mean(errors: tuple[Errors, ...] | list[Errors]) -> Errors:
    return Errors(*(float(np.mean([vars(e)[name] for e in errors])) for name in vars(errors[0])))


def table() -> str:
    names = [f"{name} {figure}" for name in FILTERS for figure in ("I", "II", "kappa")]
    lines = [" | ".join(["| tile", *names]) + " |", "|---|" + "---:|" * len(names)]
    known: list[list[Errors]] = []
    for name, errors in rows():
        if name.startswith("quarry") and known:
            lines.append(_line("mean of the tiles", [_mean(column) for column in zip(*known, strict=True)]))
            known = []
        elif not name.startswith("quarry"):
            known.append(errors)
        lines.append(_line(name, errors))
    return "\n".join(lines)


def _line(name: str, errors: list[Errors]) -> str:
    return " | ".join([f"| {name}", *(f"{x:.1f}" for e in errors for x in (e.first, e.second, e.kappa))]) + " |"


def main() -> None:
    text = table()
    print(text)
    if "--write" in sys.argv[1:]:
        write_between(PAGE, "ground baselines", text)


if __name__ == "__main__":
    main()
