"""The planes of a file's points: `extract_plane` and `label_planes`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .cloud_job import LABELLED, CloudJob, label_rows, take_rows
from .clouds import FilePath, closing_fields
from .console import format_share

PLANE = "plane"
MIN_POINTS = 100  # fewer are no plane, where several are looked for

# The largest plane holds at least this share of the finite points, or the scene has none, or the distance is too small.
_LEAST_SHARE = 0.05


def extract_plane(
    source: FilePath,
    output: FilePath,
    *,
    distance: float,
    iterations: int = 1000,
    invert: bool = False,
    seed: int = 0,
    **settings: Any,
) -> dict[str, Any]:
    """Write the points on the plane that has the most of them, or with `invert` all others.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud.
        distance: Points closer to the plane than this [m] lie on it.
        iterations: Samples of three points at most, as of `PointCloud.segment_plane`.
        invert: Write what does not lie on it.
        seed: Of the samples.
        settings: device, as_text, overwrite and progress as of `CloudJob`.

    Returns:
        What was done, in JSON's types; "planes" holds the model (a, b, c, d) with ax + by + cz + d = 0. Nothing is
        written where there is no plane or no point is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    job = CloudJob("plane", source, output, **settings)
    labels, figures, poor = _find(job, distance, iterations, seed, most=1, min_points=3)
    kept = np.flatnonzero((labels == 0) != invert)
    if figures["planes"] and len(kept):
        job.write(take_rows(job.table, kept))
    else:
        kept = kept[:0]
        poor = f"{poor or 'all points lie on the plane, so none is left'}; nothing was written"
    return job.report(len(kept), poor=poor) | figures


def label_planes(
    source: FilePath,
    output: FilePath,
    *,
    distance: float,
    most: int,
    iterations: int = 1000,
    min_points: int = MIN_POINTS,
    seed: int = 0,
    **settings: Any,
) -> dict[str, Any]:
    """Write a cloud with the plane of each point as the attribute `plane`: int32, -1 for points on none.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud in a format that holds labels.
        distance: As of `extract_plane`, like iterations and seed.
        most: Planes at most; each is the one with the most of the points that those before it left.
        iterations: Samples at most for each plane.
        min_points: Fewer points are no plane, and end the search.
        seed: Of the samples.
        settings: device, as_text, overwrite and progress as of `CloudJob`.

    Returns:
        What was done, in JSON's types; "planes" holds models and counts in the order of the labels.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    job = CloudJob("plane", source, output, formats=LABELLED, what="labels", **settings)
    labels, figures, poor = _find(job, distance, iterations, seed, most=most, min_points=min_points)
    table, replaced = label_rows(job.table, PLANE, labels)
    job.write(table)
    return job.report(len(labels), poor=poor) | figures | {"on_none": int((labels < 0).sum()), "replaced": replaced}


def plane_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    lines = []
    for plane in report["planes"]:
        a, b, c, d = plane["model"]
        lines.append(f"{a:.9f} {b:.9f} {c:.9f} {d:.6f}: {plane['points']:,} points, {format_share(plane['share'])}")
    count = f"{report['points']:,} of {report['points_in']:,}"
    if "on_none" in report:
        count = f"{report['points']:,}, {report['on_none']:,} of them on no plane"
    models = "\n".join(lines) or "none"
    return [("a b c d", models), ("points", count), *closing_fields(report)]


def _find(
    job: CloudJob, distance: float, iterations: int, seed: int, *, most: int, min_points: int
) -> tuple[NDArray[np.int32], dict[str, Any], str | None]:
    """The plane of each point, what was found, and why it is poor."""
    with job.stage("planes"):
        labels, models = job.cloud.segment_planes(
            distance, num_iterations=iterations, min_points=min_points, max_planes=most, seed=seed
        )
    finite = len(job.cloud.remove_non_finite_points())
    counts = np.bincount(labels[labels >= 0], minlength=len(models)).tolist()
    planes = [
        {"model": model.tolist(), "points": count, "share": count / finite}
        for model, count in zip(models, counts, strict=True)
    ]
    figures = {"distance": distance, "iterations": iterations, "seed": seed, "planes": planes}
    return labels, figures, _why_poor(planes, finite, distance, min_points)


def _why_poor(planes: list[dict[str, Any]], finite: int, distance: float, min_points: int) -> str | None:
    if not planes and finite < min_points:
        return f"no plane: of {finite:,} finite points, {min_points:,} would have to lie on it"
    if not planes:
        reason = f"no plane has {min_points:,} points within {distance:g} m, or all samples lie on lines"
        return f"{reason}; take a larger --distance or more --iterations"
    share = planes[0]["share"]
    if share >= _LEAST_SHARE:
        return None
    return (
        f"the largest plane has only {format_share(share)} of the points within {distance:g} m; "
        "take a larger --distance or more --iterations"
    )
