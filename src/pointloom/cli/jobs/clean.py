"""Remove outliers from a file: `clean_file`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.reports import Fields
from ...pcd.cloud import PointCloud
from .job import Job, Settings
from .rows import RowsReport, read_rows, why_no_points


@dataclass(frozen=True)
class CleanReport(RowsReport):
    """Report of `clean_file`; `filters` has the "removed" points and options of each filter."""

    filters: dict[str, dict[str, float]]

    def fields(self) -> Fields:
        lines = []
        for name, figures in self.filters.items():
            options = {option: value for option, value in figures.items() if option != "removed"}
            stated = ", ".join(f"{option.replace('_', ' ')} {value:,}" for option, value in options.items())
            lines.append(f"{figures['removed']:,} {name.replace('_', '-')}" + (f" ({stated})" if stated else ""))
        count = f"{self.points:,} of {self.points_in:,}"
        return [("points", count), ("removed", "\n".join(lines)), *self.closing(self.device)]


def clean_file(
    source: FilePath,
    output: FilePath,
    *,
    duplicates: bool = False,
    statistical: tuple[int, float] | None = None,
    radius: tuple[float, int] | None = None,
    removed: FilePath | None = None,
    **settings: Unpack[Settings],
) -> CleanReport:
    """Write a cloud without outliers. Non-finite points are always removed first, then filters run in this order.

    `duplicates` keeps the first point of each position, compared in float32 relative to the origin; `statistical` and
    `radius` are the arguments of `remove_statistical_outlier` and `remove_radius_outlier`, or None. `removed` is a file
    for the removed points.
    """
    if removed is not None and Path(removed).resolve() == Path(output).resolve():
        raise FileError(
            removed, "is the output of both the remaining and the removed points", remedy="Pass two different names"
        )
    job = Job("clean", source, **settings)
    job.check(output)
    job.check(removed)
    rows = read_rows(job)
    left, counts, warning = rows.cloud, {}, None
    for name, (keep, options) in _filters(duplicates, statistical, radius).items():
        with job.assessed(name.replace("_", "-"), {"radius": "--radius"}):
            before, left = left, keep(left, **options)
        counts[name] = {"removed": len(before) - len(left), **options}
    if len(left):
        remaining = rows.of(left)
        removed_rows = np.setdiff1d(rows.of(rows.cloud), remaining, assume_unique=True)
        if removed is not None and len(removed_rows):
            job.write_points(rows.take(removed_rows), removed)
        job.write_points(rows.take(remaining), output)
    else:
        warning = f"{why_no_points(rows) or 'no point is left'}; nothing was written"
    return CleanReport(job.done(warning), str(job.device), len(rows.cloud), len(left), counts)


def _filters(
    duplicates: bool, statistical: tuple[int, float] | None, radius: tuple[float, int] | None
) -> dict[str, tuple[Callable[..., PointCloud], dict[str, Any]]]:
    """Filters by name in order: function and options."""
    filters: dict[str, Any] = {"non_finite": (PointCloud.remove_non_finite_points, {})}
    if duplicates:
        filters["duplicate"] = (PointCloud.remove_duplicated_points, {})
    if statistical is not None:
        filters["statistical"] = (_without_statistical, dict(zip(("neighbors", "ratio"), statistical, strict=True)))
    if radius is not None:
        filters["radius"] = (_without_isolated, dict(zip(("radius", "min_neighbors"), radius, strict=True)))
    return filters


def _without_statistical(cloud: PointCloud, neighbors: int, ratio: float) -> PointCloud:
    return cloud.remove_statistical_outlier(neighbors, ratio)[0]


def _without_isolated(cloud: PointCloud, radius: float, min_neighbors: int) -> PointCloud:
    return cloud.remove_radius_outlier(min_neighbors, radius)[0]
