"""Score classify_ground on airborne scans with known ground. `--write` writes the table into docs/terrain.md.

    POINTLOOM_DATA=... python benchmarks/ground.py [--write]

The tiles are those of ISPRS's filter test (Sithole and Vosselman 2004) as PCL's test data hold them: all points in
sampNN-utm.pcd, and the true ground among them in sampNN-utm-ground.pcd, matched by exact coordinates.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

PAGE = Path(__file__).parents[1] / "docs" / "terrain.md"


@dataclass(frozen=True)
class Errors:
    """How a classification differs from the truth, in percent."""

    objects: float  # their fraction of the points
    first: float
    second: float
    total: float
    kappa: float


def tiles(folder: Path) -> dict[str, tuple[NDArray[np.float64], NDArray[np.bool_]]]:
    """Points and true ground of each tile by name."""
    from pointloom import read_point_cloud

    tile_paths = {}
    for path in sorted(folder.glob("samp*-utm.pcd")):
        points = read_point_cloud(path).points
        ground = read_point_cloud(path.with_name(f"{path.stem}-ground.pcd")).points
        tile_paths[path.stem.removesuffix("-utm")] = points, np.isin(_rows(points), _rows(ground))
    return tile_paths


def _rows(points: NDArray[np.float64]) -> NDArray[np.void]:
    """Each point of a float32 file as one item."""
    return np.ascontiguousarray(points.astype(np.float32)).view("V12").ravel()


def compare(result: NDArray[np.bool_], truth: NDArray[np.bool_]) -> Errors:
    """The errors of a classification (Sithole and Vosselman 2004, section 4)."""
    count = len(truth)
    missed, accepted = (truth & ~result).sum(), (~truth & result).sum()
    chance = (truth.sum() * result.sum() + (~truth).sum() * (~result).sum()) / count**2
    right = 1 - (missed + accepted) / count
    return Errors(
        objects=100 * (~truth).sum() / count,
        first=100 * missed / truth.sum(),
        second=100 * accepted / (~truth).sum(),
        total=100 * (1 - right),
        kappa=100 * (right - chance) / (1 - chance),
    )


def score(folder: Path) -> dict[str, tuple[int, Errors]]:
    """Points and errors of each tile."""
    from pointloom import PointCloud, classify_ground

    return {n: (len(p), compare(classify_ground(PointCloud(p)), truth)) for n, (p, truth) in tiles(folder).items()}


def table(scores: dict[str, tuple[int, Errors]]) -> str:
    """The scores in Markdown, their means last."""
    lines = ["| tile | points | objects | type I | type II | total | kappa |", "|---|---:|---:|---:|---:|---:|---:|"]
    figures = [(e.objects, e.first, e.second, e.total, e.kappa) for _, e in scores.values()]
    for (name, (count, _)), row in zip(scores.items(), figures, strict=True):
        lines.append(" | ".join([f"| {name}", f"{count:,}", *(f"{x:.2f}" for x in row)]) + " |")
    lines.append(" | ".join(["| mean", "", *(f"{x:.2f}" for x in np.mean(figures, axis=0))]) + " |")
    return "\n".join(lines)


def main() -> None:
    """Print the table, or write it into the page."""
    from pages import write_between  # the scores alone are also those of a test, which loads this file by its path
    from real_data import real_data

    text = table(score(real_data("lidar-pcl-terrain")))
    print(text)
    if "--write" in sys.argv[1:]:
        write_between(PAGE, "ground", text)


if __name__ == "__main__":
    main()
