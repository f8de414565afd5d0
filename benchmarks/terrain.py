"""Accuracy of terrain operations on real surveys: heights between ground points, and ground classification with
finite reach.

    POINTLOOM_DATA=... python benchmarks/terrain.py [hillshade.png]

One in ten ground points of PDAL's autzen data is left out, and its height predicted from the others; rasters are
compared
with SciPy's LinearNDInterpolator. The tiles with known ground are those of benchmarks/ground.py.
"""

from __future__ import annotations

import sys
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from real_data import real_data

FOOT = 0.3048


def main() -> None:
    """Print the tables of docs/terrain.md; write the hillshade if a file name is given."""
    import pointloom as loom

    data = real_data()
    warnings.simplefilter("ignore", loom.UnitWarning)
    cloud = loom.read_point_cloud(data / "lidar-pdal" / "laz" / "autzen_trim.laz")
    print("| ground points left out | inverse distance: rms, median [m] | triangles |\n|---|---|---|")
    for name, cell in (("laz/autzen_trim.laz", 3.0), ("autzen/autzen-thin-srs.las", 30.0)):
        print(left_out(loom.read_point_cloud(data / "lidar-pdal" / name), Path(name).stem, cell))
    print(beside_scipy(cloud, 3.0))
    print(ground(data / "lidar-pcl-terrain"))
    if len(sys.argv) > 1:
        dtm, dsm = (loom.rasterize(cloud, 3.0, kind, reach=200) for kind in ("dtm", "dsm"))
        shades = [hillshade(raster.fill_gaps(200).values, 3.0) for raster in (dsm, dtm)]
        loom.write_image(sys.argv[1], np.repeat(np.vstack(shades)[:, :, None], 3, axis=2))


def left_out(cloud: Any, name: str, cell: float) -> str:
    """A row of the table: errors at ground points that were left out."""
    from scipy.interpolate import LinearNDInterpolator

    import pointloom as loom

    classes = np.array(cloud["classification"])
    ground = np.flatnonzero(classes == 2)
    out = ground[np.random.default_rng(0).random(len(ground)) < 0.1]
    classes[out] = 0
    ground_only = loom.PointCloud(cloud.points, origin=cloud.origin, classification=classes)
    heights = loom.height_above_ground(ground_only, reach=100 * cell, cell=cell)[out]
    positions = cloud.points - cloud.origin
    linear = LinearNDInterpolator(positions[classes == 2][:, :2], positions[classes == 2][:, 2])
    errors = positions[out][:, 2] - linear(positions[out][:, :2])
    inside = np.isfinite(errors)
    figures = [
        f"{FOOT * np.sqrt(np.mean(differences[inside] ** 2)):.3f}, {FOOT * np.median(abs(differences[inside])):.3f}"
        for differences in (heights, errors)
    ]
    return f"| {name}, {int(inside.sum()):,} of {len(ground):,} | {figures[0]} | {figures[1]} |"


def beside_scipy(cloud: Any, cell: float) -> str:
    """Differences from SciPy's rasters of the same cells."""
    from scipy.interpolate import LinearNDInterpolator

    import pointloom as loom

    rasters, seconds = {}, {}
    for method in ("idw", "tin"):
        loom.rasterize(cloud, cell, method=method)  # compiles
        begin = time.process_time()
        rasters[method] = loom.rasterize(cloud, cell, method=method)
        seconds[method] = time.process_time() - begin
    x0, _, _, y1 = rasters["tin"].bounds
    rows, columns = rasters["tin"].values.shape
    x, y = np.meshgrid(x0 + (np.arange(columns) + 0.5) * cell, y1 - (np.arange(rows) + 0.5) * cell)
    begin = time.process_time()
    ground = (cloud.points - cloud.origin)[np.asarray(cloud["classification"]) == 2]
    linear = LinearNDInterpolator(ground[:, :2], ground[:, 2])(x - cloud.origin[0], y - cloud.origin[1])
    seconds["scipy"] = time.process_time() - begin
    lines = [f"{columns} x {rows} cells, CPU s {seconds}"]
    for method, raster in rasters.items():
        differences = FOOT * abs(raster.values - (linear + cloud.origin[2]))
        quantiles = [f"{np.nanpercentile(differences, fraction):.2g}" for fraction in (50, 95, 100)]
        lines.append(f"{method}: median, 95 %, most {quantiles} m; {int((~np.isfinite(raster.values)).sum())} empty")
    return "\n".join(lines)


def ground(folder: Path) -> str:
    """Errors on tiles with known ground, with the cloud's own corner and with a fixed one."""
    import ground as scoring

    import pointloom as loom

    lines = ["| tile | total | kappa | total, finite reach | kappa |", "|---|---:|---:|---:|---:|"]
    scores_of_tiles = []
    for name, (points, truth) in scoring.tiles(folder).items():
        cloud = loom.PointCloud(points)
        pair = [scoring.compare(loom.classify_ground(cloud, corner=corner), truth) for corner in (None, (0, 0))]
        scores_of_tiles.append([value for score in pair for value in (score.total, score.kappa)])
        lines.append(f"| {name} | " + " | ".join(f"{value:.2f}" for value in scores_of_tiles[-1]) + " |")
    return "\n".join(
        [*lines, "| mean | " + " | ".join(f"{value:.2f}" for value in np.mean(scores_of_tiles, axis=0)) + " |"]
    )


def hillshade(heights: NDArray[np.float32], cell: float) -> NDArray[np.uint8]:
    """Hillshade with light from the north-west at 45 degrees."""
    north, east = np.gradient(heights.astype(np.float64), -cell, cell)
    light = (1 + (east - north) / np.sqrt(2)) / np.sqrt(1 + east**2 + north**2) / np.sqrt(2)
    return (255 * np.clip(np.nan_to_num(light), 0, 1)).astype(np.uint8)


if __name__ == "__main__":
    main()
