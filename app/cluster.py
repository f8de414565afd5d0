"""The points of a file, labelled by cluster: `cluster_file`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.cloud import PointCloud
from ..pcd.io.formats import WRITTEN
from ..pcd.search import NearestNeighborSearch
from .cloud_job import LABELLED, CloudJob, label_rows, take_rows
from .clouds import FilePath, closing_fields
from .console import format_share
from .pictures.colormaps import PALETTE
from .probes import distance_of_nearest, probe_points, rounded_up

LABEL = "label"
_COLORED = (*LABELLED, ".xyzrgb", ".pts", ".e57")
_SHOWN = 10  # the largest clusters, whose sizes are reported

# Those of matplotlib's "tab20", which label files have been painted with so far.
TAB20 = PALETTE[:20]


def cluster_file(
    source: FilePath,
    output: FilePath,
    *,
    eps: float,
    min_points: int = 10,
    largest: int | None = None,
    paint: bool = False,
    **settings: Any,
) -> dict[str, Any]:
    """Write a cloud with the cluster of each point as the attribute `label`: int32, -1 for noise.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud, in a format that holds labels, or colours with `paint`, or any with `largest`.
        eps: Distance of neighbours [m], as of `PointCloud.cluster_dbscan`.
        min_points: Neighbours that make a core, the point included.
        largest: Keep only so many clusters, the largest, under the labels that they have anyway; None keeps all points.
        paint: Colour the points by their label, noise black.
        settings: device, as_text, overwrite and progress as of `CloudJob`.

    Returns:
        What was done, in JSON's types: how many clusters, the sizes of the largest, the share of noise. Nothing is
        written where no point is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A limit out of range.
        DeviceError: No such device.
    """
    formats, what = (_COLORED, "labels or colours") if paint else (LABELLED, "labels")
    if largest is not None:
        formats, what = WRITTEN, "clouds"
    job = CloudJob("cluster", source, output, formats=formats, what=what, **settings)
    with job.stage("cluster"):
        labels = job.cloud.cluster_dbscan(eps, min_points)
    sizes = np.bincount(labels[labels >= 0])
    ranked = np.argsort(-sizes, kind="stable")
    with job.stage("check"):
        poor = _why_poor(job.cloud, sizes, eps, min_points)
    table, replaced = label_rows(job.table, LABEL, labels)
    if paint:
        replaced = ["colors"] * (table.colors is not None) + replaced
        table.colors = _paint(labels)
    kept = np.arange(len(labels)) if largest is None else np.flatnonzero(np.isin(labels, ranked[:largest]))
    if len(kept):
        job.write(table if largest is None else take_rows(table, kept))
    else:
        poor = f"{poor or 'no point is left'}; nothing was written"
    return job.report(len(kept), poor=poor) | {
        "eps": eps,
        "min_points": min_points,
        "clusters": len(sizes),
        "largest": [{"label": int(i), "points": int(sizes[i])} for i in ranked[:_SHOWN]],
        "noise": int((labels < 0).sum()),
        "replaced": replaced,
    }


def cluster_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    total = report["points_in"]
    sizes = ", ".join(f"{cluster['points']:,} (label {cluster['label']})" for cluster in report["largest"])
    fields = [
        ("clusters", f"{report['clusters']:,}, eps {report['eps']:g} m, min points {report['min_points']}"),
        ("largest", sizes or "none"),
        ("noise", f"{report['noise']:,} of {total:,} points, {format_share(report['noise'] / max(total, 1))}"),
    ]
    if report["points"] != total:
        fields.append(("kept", f"{report['points']:,} points"))
    return [*fields, *closing_fields(report)]


def _paint(labels: NDArray[np.int32]) -> NDArray[np.float32]:
    """A colour for each label, the same again after 20; black for -1."""
    colors = (TAB20 / 255).astype(np.float32)[labels % len(TAB20)]
    colors[labels < 0] = 0
    return colors


def _why_poor(cloud: PointCloud, sizes: NDArray[Any], eps: float, min_points: int) -> str | None:
    """Whether the clusters tell no points apart, with the eps that may."""
    finite = len(cloud.remove_non_finite_points())
    if not finite:
        return "no point is finite, so none is in a cluster"
    if len(sizes) > 1 or (len(sizes) == 1 and sizes[0] < finite):
        return None
    search, probes = NearestNeighborSearch(cloud), probe_points(cloud)
    if len(sizes):
        distance = distance_of_nearest(search, probes, min_points, share=0.9)
        hint = f"one cluster holds all {finite:,} finite points; take a smaller --eps"
        return f"{hint}, such as {rounded_up(distance):g}" if distance and rounded_up(distance) < eps else hint
    distance = distance_of_nearest(search, probes, min_points)
    lonely = f"all points are noise: none has {min_points} within {eps:g} m, itself included"
    if distance is None:
        return f"{lonely}; take a larger --eps or fewer --min-points"
    return f"{lonely}; half of them have as many within {rounded_up(distance):g} m: take a larger --eps"
