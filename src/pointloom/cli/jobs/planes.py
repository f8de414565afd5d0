"""Planes of point files: `extract_plane` and `label_planes`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FilePath
from ...core.reports import Fields
from ...core.wording import format_fraction
from ...io.points.formats import storing
from .job import Job, Settings
from .rows import Rows, RowsReport, label_rows, read_rows

PLANE = "plane"
_NO_PLANE = "no plane has {:,} points, or all samples are collinear"
MIN_POINTS = 100  # minimum size if several planes are searched


@dataclass(frozen=True)
class Plane:
    """A plane: `model` (a, b, c, d) with unit normal, number of points, and their fraction of the finite points."""

    model: tuple[float, ...]
    points: int
    fraction: float


@dataclass(frozen=True)
class PlaneReport(RowsReport):
    """Report of `extract_plane` or `label_planes`; `on_none` is the number of unlabeled points, None without labels."""

    distance: float
    iterations: int
    seed: int
    planes: tuple[Plane, ...]
    on_none: int | None = None
    replaced: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        report = super().to_dict()
        if self.on_none is None:
            del report["on_none"], report["replaced"]
        return report

    def fields(self) -> Fields:
        lines = []
        for plane in self.planes:
            a, b, c, d = plane.model
            lines.append(f"{a:.9f} {b:.9f} {c:.9f} {d:.6f}: {plane.points:,} points, {format_fraction(plane.fraction)}")
        count = f"{self.points:,} of {self.points_in:,}"
        if self.on_none is not None:
            count = f"{self.points:,}, {self.on_none:,} of them not on a plane"
        models = "\n".join(lines) or "none"
        return [("a b c d", models), ("points", count), *self.closing(self.device, self.replaced)]


def extract_plane(
    source: FilePath,
    output: FilePath,
    *,
    distance: float,
    iterations: int = 1000,
    invert: bool = False,
    seed: int = 0,
    **settings: Unpack[Settings],
) -> PlaneReport:
    """Write the points within `distance` [m] of the largest plane, or with `invert` all others.

    Uses at most `iterations` samples of 3 points. Nothing is written without a plane or without points.
    """
    job = Job("plane", source, **settings)
    job.check(output)
    rows = read_rows(job)
    labels, planes, warning = _find(job, rows, distance, iterations, seed, max_planes=1, min_points=3)
    selected = np.flatnonzero((labels == 0) != invert)
    if planes and len(selected):
        job.write_points(rows.take(selected), output)
    else:
        selected = selected[:0]
        warning = f"{warning or 'all points are on the plane, so no point is left'}; nothing was written"
    counts = len(labels), len(selected)
    return PlaneReport(job.done(warning), str(job.device), *counts, distance, iterations, seed, planes)


def label_planes(
    source: FilePath,
    output: FilePath,
    *,
    distance: float,
    max_planes: int,
    iterations: int = 1000,
    min_points: int = MIN_POINTS,
    seed: int = 0,
    **settings: Unpack[Settings],
) -> PlaneReport:
    """Write a cloud with the int32 attribute `plane`: index of the plane, -1 for none.

    Finds up to `max_planes` planes one after another. Fewer than `min_points` points end the search.
    """
    job = Job("plane", source, **settings)
    job.check(output, storing("labels"), what="labels")
    rows = read_rows(job)
    labels, planes, warning = _find(job, rows, distance, iterations, seed, max_planes=max_planes, min_points=min_points)
    table, replaced = label_rows(rows.table, PLANE, labels)
    job.write_points(table, output)
    counts, on_none = (len(labels), len(labels)), int((labels < 0).sum())
    search = distance, iterations, seed, planes
    return PlaneReport(job.done(warning), str(job.device), *counts, *search, on_none, tuple(replaced))


def _find(
    job: Job, rows: Rows, distance: float, iterations: int, seed: int, *, max_planes: int, min_points: int
) -> tuple[NDArray[np.int32], tuple[Plane, ...], str | None]:
    options = {"distance_threshold": "--distance", "num_iterations": "--iterations"}
    with job.assessed("planes", options):
        labels, models = rows.cloud.segment_planes(
            distance, num_iterations=iterations, min_points=min_points, max_planes=max_planes, seed=seed
        )
    finite = len(rows.cloud.remove_non_finite_points())
    counts = np.bincount(labels[labels >= 0], minlength=len(models)).tolist()
    planes = [Plane(tuple(model.tolist()), count, count / finite) for model, count in zip(models, counts, strict=True)]
    warning = None if planes or job.failed_checks else _NO_PLANE.format(min_points)
    return labels, tuple(planes), warning
