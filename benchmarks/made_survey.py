"""A synthetic survey of any size: LAZ files of one square kilometer each, created in pieces, reproducible bit by bit.

    python benchmarks/made_survey.py FOLDER --points 1e8        # 10 files of 10 million points
    python benchmarks/made_survey.py FOLDER --points 1e9 --workers 2

Hills, streets of houses and rows of trees, scanned line by line at 10 points per square meter: format 6 in steps of
1 mm,
with intensity, GPS time, returns and source number; about 5 bytes per point. The true class, ground (2), house (6) or
tree (5), is in `user_data`; `classification` is 0 as in a raw survey.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

SIDE = 1000.0  # [m] per file
DENSITY = 10.0  # points per square meter
CORNER = np.array([447_000.0, 5_411_000.0])  # [m] UTM zone 32 north
LINES = 64  # rows generated at once


def ground_height(x: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
    """Hills of four wavelengths [m]."""
    height = 300 + 40 * np.sin(x / 911) * np.cos(y / 1207) + 12 * np.sin(x / 173 + y / 311)
    return height + 2.5 * np.sin(x / 41) * np.sin(y / 53) + 0.2 * np.sin(x / 7) * np.cos(y / 5)


def cover(x: NDArray[Any], y: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
    """Height of objects above the ground and their class: houses and trees along a street grid of 40 m."""
    block_x, block_y = np.floor(x / 40), np.floor(y / 40)
    u, v = x - 40 * block_x - 20, y - 40 * block_y - 20
    chance = np.abs(np.sin(block_x * 12.9898 + block_y * 78.233) * 43758.5453) % 1
    height, kind = np.zeros(len(x)), np.full(len(x), 2, np.uint8)
    wide = 5 + 6 * (chance * 7 % 1)
    is_building = (chance < 0.45) & (np.abs(u) < wide) & (np.abs(v) < 7)
    height[is_building] = (4 + 6 * (chance * 13 % 1) + 2.5 * (1 - np.abs(v) / 7))[is_building]
    kind[is_building] = 6
    crown = 3 + 3 * (chance * 5 % 1)
    far = np.hypot(u, v) / crown
    tree = (chance >= 0.45) & (chance < 0.8) & (far < 1)
    height[tree] = ((6 + 10 * (chance * 11 % 1)) * (1 - 0.4 * far**2))[tree]
    kind[tree] = 5
    return height, kind


def made_rows(ix: int, iy: int, lines: range, per_line: int, rng: np.random.Generator) -> dict[str, NDArray[Any]]:
    """The points of some scan lines of a file, as columns of a LAS file."""
    step = SIDE / per_line
    count = per_line * len(lines)
    along = np.tile(np.arange(per_line), len(lines))
    across = np.repeat(np.asarray(lines), per_line)
    x = np.minimum((along + rng.random(count)) * step, SIDE - 1e-3) + CORNER[0] + ix * SIDE
    y = np.minimum((across + rng.random(count)) * step, SIDE - 1e-3) + CORNER[1] + iy * SIDE
    top, kind = cover(x, y)
    through = (kind == 5) & (rng.random(count) < 0.4)
    kind[through] = 2
    inner = (kind == 5) & (rng.random(count) < 0.5)
    height = np.where(through, 0, np.where(inner, top * rng.random(count), top))
    z = ground_height(x, y) + height + rng.normal(0, 0.03, count)
    stray = rng.random(count) < 1e-5
    z[stray] += rng.uniform(20, 80, int(stray.sum()))
    return {
        "x": x, "y": y, "z": z, "user_data": kind,
        "intensity": (2000 + 400 * kind.astype(int) + rng.integers(0, 300, count)).astype(np.uint16),
        "return_number": np.where(through, 2, 1).astype(np.uint8),
        "number_of_returns": np.where(through | (kind == 5), 2, 1).astype(np.uint8),
        "gps_time": 1e8 + iy * 1e4 + ix * 700 + (across + along / per_line) * 0.2,
    }  # fmt: skip


def make_file(folder: str, ix: int, iy: int, side_points: int) -> int:
    """Write a file of side_points squared points unless it exists; returns the number of points."""
    import laspy
    import pyproj

    path = Path(folder) / f"{int(CORNER[0] + ix * SIDE) // 1000}_{int(CORNER[1] + iy * SIDE) // 1000}.laz"
    if path.exists():
        return side_points**2
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 0.001), np.array([*CORNER, 0])
    header.add_crs(pyproj.CRS.from_epsg(25832))
    rng = np.random.default_rng([ix, iy])
    part = path.with_suffix(".part")
    with part.open("wb") as stream, laspy.LasWriter(stream, header, do_compress=True, closefd=False) as writer:
        for begin in range(0, side_points, LINES):
            lines = range(begin, min(side_points, begin + LINES))
            columns = made_rows(ix, iy, lines, side_points, rng)
            record = laspy.ScaleAwarePointRecord.zeros(len(columns["x"]), header=header)
            for name, values in columns.items():
                record[name] = values
            record["point_source_id"][:] = 1 + iy % 50
            writer.write_points(record)
    part.rename(path)
    return side_points**2


def main() -> None:
    """Create the survey, with a progress line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--points", type=float, default=1e8, help="approximate number of points (1e8)")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    side = round(math.sqrt(DENSITY) * SIDE)
    files = max(1, round(options.points / side**2))
    if options.points < side**2:
        side = round(math.sqrt(options.points))
    across = math.ceil(math.sqrt(files))
    tiles = [(k % across, k // across) for k in range(files)]
    done = 0
    with ProcessPoolExecutor(options.workers) as pool:
        waiting = [pool.submit(make_file, str(options.folder), ix, iy, side) for ix, iy in tiles]
        for one in as_completed(waiting):
            done += one.result()
            print(f"\r{done:,} points", end="", file=sys.stderr, flush=True)
    size = sum(path.stat().st_size for path in options.folder.glob("*.laz"))
    print(f"\r{done:,} points in {files} files, {size / 1e9:.2f} GB, {size / done:.2f} B per point", file=sys.stderr)


if __name__ == "__main__":
    main()
