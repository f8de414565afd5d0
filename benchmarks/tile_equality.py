"""Compare each tiled step with the in-memory operation on real surveys and a synthetic city: number of different rows.

    python benchmarks/tile_equality.py DATA        # the folder of real data; takes minutes

Surveys are given as two LAZ files with some common points, and points on borders and corners of tiles. Each step runs
with three tile sizes, the last of which contains everything. Complete rows are compared bitwise: positions, attributes
and normals. Every step of the tiling has a line here.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pointloom as loom
from pointloom.io.points.las import read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable
from pointloom.tiling.manifest import Manifest
from pointloom.tiling.steps.parse import KNOWN

from made_survey import SIDE, made_rows  # isort: skip
from pointloom.pcd.raster import Raster

SURVEYS = {
    "slope": ("lidar-pcl-terrain/CSite1_red2-utm.pcd", 1.0),
    "town": ("lidar-pcl-terrain/samp11-utm.pcd", 1.0),
    "autzen [ft]": ("lidar-pdal/laz/autzen_trim.laz", 3.28),
}
CITY, PER_LINE = 500, 3162  # number of lines and points per kilometer of line
SIZES = (41.0, 60.0, 5000.0)  # times a survey's scale; the second has borders at added points
BORDER = 20.0
Steps = list[dict[str, Any]]


def changed(cloud: Any, **columns: Any) -> Any:
    """A copy with attributes."""
    cloud = cloud.copy()
    for name, values in columns.items():
        cloud[name] = values
    return cloud


def classified(cloud: Any, s: float) -> Any:
    """Ground as the step writes it."""
    ground = loom.classify_ground(cloud, s, 0.15, 6 * s, 0.5 * s, 1.25 * s, corner=(0, 0))
    before = np.asarray(cloud["classification"])
    stays = (before != 0) & (before != 2)
    return changed(cloud, classification=np.where(ground, 2, np.where(stays, before, 1)).astype(np.uint8))


def with_distance(cloud: Any, other: Any, s: float) -> Any:
    """Distances to the other epoch as the step writes them."""
    distances = np.asarray(cloud.compute_point_cloud_distance(other))
    return changed(cloud, distance=np.where(distances <= 3 * s, distances, np.nan).astype(np.float32))


def with_change(cloud: Any, other: Any, s: float) -> Any:
    """M3C2 as the step writes it."""
    result = loom.m3c2(cloud, other, normal_radii=[3 * s, 6 * s], cylinder_radius=3 * s, max_distance=4 * s)
    before, after = result.counts.T.copy()
    return changed(
        cloud,
        m3c2_distance=result.distances.astype(np.float32),
        level_of_detection=result.level_of_detection.astype(np.float32),
        significant=result.is_significant.astype(np.uint8),
        points_before=before,
        points_after=after,
    )


def with_features(cloud: Any, s: float) -> Any:
    """Eigenvalue features as the step writes them."""
    features = loom.compute_eigen_features(cloud, radius=4 * s, max_nn=None)
    return changed(cloud, **{name: features[name] for name in ("linearity", "verticality", "density")})


def dimmer(cloud: Any) -> Any:
    """A user-defined function."""
    return changed(cloud, intensity=(np.asarray(cloud["intensity"]) // 2).astype(np.uint16))


def steps_of(s: float, other: Path, box: NDArray[Any]) -> dict[str, tuple[Steps, Callable[[Any, Any], Any]]]:
    """The steps by name, with the in-memory equivalents of (cloud, other epoch)."""
    low, high = box.tolist()
    ground = {"step": "classify_ground", "cell_size": s, "max_window": 6 * s, "elevation_threshold": 0.5 * s,
              "scaling": 1.25 * s}  # fmt: skip
    above = {"step": "height_above_ground", "reach": 9 * s, "cell": s}
    change = {"normal_radii": [3 * s, 6 * s], "cylinder_radius": 3 * s, "max_distance": 4 * s, "other": str(other)}
    up = "orient_normals_to_align_with_direction"
    return {
        "voxel_down_sample": (
            [{"step": "voxel_down_sample", "voxel_size": 2 * s}],
            lambda c, o: c.voxel_down_sample(2 * s),
        ),
        "remove_radius_outlier": (
            [{"step": "remove_radius_outlier", "nb_points": 4, "radius": 2 * s}],
            lambda c, o: c.remove_radius_outlier(nb_points=4, radius=2 * s)[0],
        ),
        "remove_statistical_outlier": (
            [{"step": "remove_statistical_outlier", "nb_neighbors": 12, "std_ratio": 1.5}],
            lambda c, o: c.remove_statistical_outlier(nb_neighbors=12, std_ratio=1.5)[0],
        ),
        "estimate_normals": (
            [{"step": "estimate_normals", "max_nn": 15}],
            lambda c, o: getattr(c.estimate_normals(max_nn=15), up)(),
        ),
        "smooth_mls": (
            [{"step": "smooth_mls", "radius": 4 * s, "max_nn": None}],
            lambda c, o: c.smooth_mls(radius=4 * s, max_nn=None),
        ),
        "crop": (
            [{"step": "crop", "min_bound": low, "max_bound": high}],
            lambda c, o: c.crop(loom.AxisAlignedBoundingBox(low, high)),
        ),
        "function": (
            [{"step": "function", "call": import_module("tile_equality").dimmer, "reach": 0}],
            lambda c, o: dimmer(c),
        ),
        "classify_ground": ([ground], lambda c, o: classified(c, s)),
        "height_above_ground": (
            [ground, above],
            lambda c, o: changed(
                classified(c, s), height_above_ground=loom.height_above_ground(classified(c, s), reach=9 * s, cell=s)
            ),
        ),
        "features": (
            [{"step": "features", "radius": 4 * s, "max_nn": None, "names": ["linearity", "verticality", "density"]}],
            lambda c, o: with_features(c, s),
        ),
        "cluster_dbscan": (
            [{"step": "cluster_dbscan", "eps": 1.5 * s, "min_points": 6}],
            lambda c, o: changed(c, cluster=c.cluster_dbscan(1.5 * s, 6)),
        ),
        "cluster_euclidean": (
            [{"step": "cluster_euclidean", "tolerance": s, "min_cluster_size": 3}],
            lambda c, o: changed(c, cluster=c.cluster_euclidean(s, 3)),
        ),
        "thin": ([{"step": "thin", "spacing": 3 * s}], lambda c, o: c.thin(3 * s)),
        "distance": (
            [{"step": "distance", "other": str(other), "max_distance": 3 * s}],
            lambda c, o: with_distance(c, o, s),
        ),
        "m3c2": ([{"step": "m3c2", **change}], lambda c, o: with_change(c, o, s)),
        "rasterize": (
            [ground, {"step": "rasterize", "cell": 2 * s, "reach": 9 * s}],
            lambda c, o: loom.rasterize(classified(c, s), 2 * s, reach=9 * s),
        ),
    }


def tables_of(name: str, data: Path, folder: Path) -> tuple[PointTable, float]:
    """A survey with intensities, times and classes, some points on borders, and its length unit."""
    if name == "city":
        rows, scale = made_rows(0, 0, range(CITY), PER_LINE, np.random.default_rng(0)), 1.0
        points = np.column_stack([rows[axis] for axis in "xyz"])
        points = points[points[:, 0] < points[:, 0].min() + CITY * SIDE / PER_LINE]
    else:
        path, scale = SURVEYS[name]
        points = loom.read_point_cloud(data / path).points
    rng, count = np.random.default_rng(0), len(points)
    points = points.copy()
    which = rng.choice(count, count // 50, replace=False)
    points[which, 0] = np.rint(points[which, 0] / (BORDER * scale)) * BORDER * scale
    both = which[: len(which) // 2]
    points[both, 1] = np.rint(points[both, 1] / (BORDER * scale)) * BORDER * scale
    return PointTable(points, attributes={
        "intensity": rng.integers(0, 60000, count).astype(np.uint16),
        "gps_time": rng.random(count),
        "classification": np.where(rng.random(count) < 0.01, 7, 0).astype(np.uint8),
    }), scale  # fmt: skip


def write_parts(table: PointTable, folder: Path, shift: float) -> list[Path]:
    """Write two files with half of the points each, 200 of them in both; raised for large x."""
    rng, points = np.random.default_rng(1), table.points.copy()
    points[points[:, 0] > np.median(points[:, 0]), 2] += shift
    one, two = np.array_split(rng.permutation(len(points)), 2)
    paths = []
    for number, rows in enumerate((one, np.concatenate([two, one[:200]]))):
        part = PointTable(points[rows], attributes={name: v[rows] for name, v in table.attributes.items()})
        paths.append(folder / f"part{number}.laz")
        write_las(paths[-1], part, scale=1e-4, offset=np.floor(points.min(axis=0)))
    return paths


def read_all(paths: list[Path], origin: Any) -> Any:
    """All points in memory, in the order of the files."""
    tables = [read_las(path) for path in paths]
    columns = {
        n: np.concatenate([t.attributes[n] for t in tables]) for n in ("intensity", "gps_time", "classification")
    }
    return loom.PointCloud(np.concatenate([table.points for table in tables]), origin=origin, **columns)


def rows_of(cloud: Any, names: list[str]) -> NDArray[np.int64]:
    """The complete cloud as sorted rows, with positions in steps of the files."""
    columns = [np.rint((cloud.points - cloud.origin) / 1e-4).astype(np.int64)]
    for name in names:
        values = np.asarray(cloud[name])
        wide = values.astype(np.float64 if values.dtype.kind == "f" else np.int64).reshape(len(cloud), -1)
        columns.append((wide + 0).view(np.int64))
    if cloud.has_normals:
        columns.append((cloud.normals + np.float32(0)).view(np.int32).astype(np.int64))
    rows = np.column_stack(columns)
    return rows[np.lexsort(rows.T)]


def differing(result: Path, job: Path, expected: Any) -> tuple[int, int]:
    """Number of rows, or cells, that differ from the expected ones, and their total."""
    if isinstance(expected, Raster):
        import rasterio

        with rasterio.open(job / "result.dtm.tif") as file:
            values = file.read(1, masked=True).filled(np.nan)
        if values.shape != expected.values.shape:
            return expected.values.size, expected.values.size
        same = (values == expected.values) | (np.isnan(values) & np.isnan(expected.values))
        return int((~same).sum()), values.size
    actual = loom.read_point_cloud(result)
    actual = loom.PointCloud(actual.points, normals=actual.normals if actual.has_normals else None,
                            origin=expected.origin, **dict(actual.attributes))  # fmt: skip
    names = sorted(expected.attributes)
    a, b = rows_of(actual, names), rows_of(expected, names)
    if a.shape != b.shape:
        return max(len(a), len(b)), len(b)
    return int((a != b).any(axis=1).sum()), len(b)


def check(name: str, data: Path, folder: Path, only: str | None) -> int:
    """Run all steps on a survey; returns the number of differing rows."""
    (folder / "after").mkdir(parents=True)
    table, s = tables_of(name, data, folder)
    paths, second_paths = write_parts(table, folder, 0.0), write_parts(table, folder / "after", 0.4 * s)
    low, high = (np.quantile(table.points, fraction, axis=0) for fraction in (0.2, 0.8))
    low[2], high[2] = table.points[:, 2].min(), table.points[:, 2].max()
    bad = 0
    for step, (steps, in_memory) in steps_of(s, folder / "after", np.array([low, high])).items():
        if only not in (None, step):
            continue
        reports, expected = [], None
        for size in SIZES:
            job = folder / "job"
            loom.tiling.plan_tiles(paths, steps, job, size=size * s)
            status = loom.tiling.run_tiles(job)
            if not status.is_finished:
                raise SystemExit(f"{name}, {step}: {status}")
            with Manifest(job) as manifest:
                plan = manifest.plan
            if expected is None:
                cloud, other = (read_all(some, plan["origin"]) for some in (paths, second_paths))
                expected = in_memory(cloud, other)
            rows, total = differing(loom.tiling.finish_tiles(job), job, expected)
            reports.append(f"{rows} of {total:,} in {status.done + status.empty} tiles")
            bad += rows
            shutil.rmtree(job)
        print(f"{name:12} {step:27} {'; '.join(reports)}", flush=True)
    return bad


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path)
    parser.add_argument("--step", choices=sorted(KNOWN), help="this one alone")
    parser.add_argument("--survey", choices=[*SURVEYS, "city"], help="this one alone")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        missing = set(KNOWN) - set(steps_of(1.0, Path(folder), np.zeros((2, 3))))
        if missing:
            raise SystemExit(f"no comparison is defined for {', '.join(sorted(missing))}")
        names = [options.survey] if options.survey else [*SURVEYS, "city"]
        bad = sum(check(name, options.data, Path(folder) / name.split()[0], options.step) for name in names)
    print(f"{bad} rows differ")
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
