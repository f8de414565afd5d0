"""The planes of a file's points: `extract_plane` and `label_planes`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FilePath
from ...core.reports import Fields
from ...core.units import symbol_of
from ...core.wording import format_share
from .job import Job, Settings
from .rows import LABELLED, Rows, RowsReport, label_rows, read_rows

PLANE = "plane"
MIN_POINTS = 100  # fewer are no plane, where several are looked for

# The largest plane holds at least this share of the finite points, or the scene has none, or the distance is too small.
_LEAST_SHARE = 0.05


@dataclass(frozen=True)
class Plane:
    """A plane of a cloud.

    Attributes:
        model: (a, b, c, d) with ax + by + cz + d = 0 and a unit normal.
        points: How many points lie on it.
        share: Their share of the finite points.
    """

    model: tuple[float, ...]
    points: int
    share: float


@dataclass(frozen=True)
class PlaneReport(RowsReport):
    """What `extract_plane` or `label_planes` did.

    Attributes:
        distance, iterations, seed: As of `extract_plane`.
        planes: What was found.
        on_none: How many points lie on no plane; None where they were not labelled.
        replaced: Names of what the file had already.
    """

    distance: float
    iterations: int
    seed: int
    planes: tuple[Plane, ...]
    on_none: int | None = None
    replaced: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """All of it; without what goes with labels where there are none."""
        report = super().to_dict()
        if self.on_none is None:
            del report["on_none"], report["replaced"]
        return report

    def fields(self) -> Fields:
        """The planes, and the counts."""
        lines = []
        for plane in self.planes:
            a, b, c, d = plane.model
            lines.append(f"{a:.9f} {b:.9f} {c:.9f} {d:.6f}: {plane.points:,} points, {format_share(plane.share)}")
        count = f"{self.points:,} of {self.points_in:,}"
        if self.on_none is not None:
            count = f"{self.points:,}, {self.on_none:,} of them on no plane"
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
    """Write the points on the plane that has the most of them, or with `invert` all others.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud.
        distance: Points closer to the plane than this [m] lie on it.
        iterations: Samples of three points at most, as of `PointCloud.segment_plane`.
        invert: Write what does not lie on it.
        seed: Of the samples.
        settings: As of `Settings`.

    Returns:
        What was done. Nothing is written where there is no plane or no point is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    job = Job("plane", source, **settings)
    job.check(output)
    rows = read_rows(job)
    labels, planes, warning = _find(job, rows, distance, iterations, seed, most=1, min_points=3)
    kept = np.flatnonzero((labels == 0) != invert)
    if planes and len(kept):
        job.write_points(rows.take(kept), output)
    else:
        kept = kept[:0]
        warning = f"{warning or 'all points lie on the plane, so none is left'}; nothing was written"
    counts = len(labels), len(kept)
    return PlaneReport(job.done(warning), str(job.device), *counts, distance, iterations, seed, planes)


def label_planes(
    source: FilePath,
    output: FilePath,
    *,
    distance: float,
    most: int,
    iterations: int = 1000,
    min_points: int = MIN_POINTS,
    seed: int = 0,
    **settings: Unpack[Settings],
) -> PlaneReport:
    """Write a cloud with the plane of each point as the attribute `plane`: int32, -1 for points on none.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud in a format that holds labels.
        distance: As of `extract_plane`, like iterations and seed.
        most: Planes at most; each is the one with the most of the points that those before it left.
        iterations: Samples at most for each plane.
        min_points: Fewer points are no plane, and end the search.
        seed: Of the samples.
        settings: As of `Settings`.

    Returns:
        What was done, with the planes in the order of their labels.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    job = Job("plane", source, **settings)
    job.check(output, LABELLED, what="labels")
    rows = read_rows(job)
    labels, planes, warning = _find(job, rows, distance, iterations, seed, most=most, min_points=min_points)
    table, replaced = label_rows(rows.table, PLANE, labels)
    job.write_points(table, output)
    counts, on_none = (len(labels), len(labels)), int((labels < 0).sum())
    found = distance, iterations, seed, planes
    return PlaneReport(job.done(warning), str(job.device), *counts, *found, on_none, tuple(replaced))


def _find(
    job: Job, rows: Rows, distance: float, iterations: int, seed: int, *, most: int, min_points: int
) -> tuple[NDArray[np.int32], tuple[Plane, ...], str | None]:
    """The plane of each point, the planes, and why they are unreliable."""
    with job.stage("planes"):
        labels, models = rows.cloud.segment_planes(
            distance, num_iterations=iterations, min_points=min_points, max_planes=most, seed=seed
        )
    finite = len(rows.cloud.remove_non_finite_points())
    counts = np.bincount(labels[labels >= 0], minlength=len(models)).tolist()
    planes = [Plane(tuple(model.tolist()), count, count / finite) for model, count in zip(models, counts, strict=True)]
    return labels, tuple(planes), _warning(planes, finite, f"{distance:g} {symbol_of(rows.cloud.unit)}", min_points)


def _warning(planes: Sequence[Plane], finite: int, distance: str, min_points: int) -> str | None:
    if not planes and finite < min_points:
        return f"no plane: of {finite:,} finite points, {min_points:,} would have to lie on it"
    if not planes:
        reason = f"no plane has {min_points:,} points within {distance}, or all samples lie on lines"
        return f"{reason}; take a larger --distance or more --iterations"
    if planes[0].share >= _LEAST_SHARE:
        return None
    return (
        f"the largest plane has only {format_share(planes[0].share)} of the points within {distance}; "
        "take a larger --distance or more --iterations"
    )
