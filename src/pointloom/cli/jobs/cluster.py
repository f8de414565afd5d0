"""Label the points of a file by cluster: `cluster_file`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FilePath
from ...core.reports import Fields
from ...core.units import symbol_of
from ...core.wording import format_fraction
from ...io.points.formats import WRITTEN
from ...pcd.cloud import PointCloud
from ...pcd.point_spacing import distance_of_nearest, probe_points, rounded_up
from ...pcd.search import NearestNeighborSearch
from ...visualization.render.colormaps import LABEL_COLORS
from .job import Job, Settings
from .rows import COLORED, LABELLED, RowsReport, label_rows, read_rows, take_rows

LABEL = "label"
_LISTED_CLUSTERS = 10  # reported sizes of the largest clusters

# matplotlib's "tab20", used for label files so far.
TAB20_PALETTE = LABEL_COLORS[:20]


@dataclass(frozen=True)
class ClusterSize:
    label: int
    points: int


@dataclass(frozen=True)
class ClusterReport(RowsReport):
    """Report of `cluster_file`; `replaced` are names of replaced attributes."""

    eps: float
    min_points: int
    clusters: int
    largest: tuple[ClusterSize, ...]
    noise: int
    replaced: tuple[str, ...] = ()

    def fields(self) -> Fields:
        total = self.points_in
        sizes = ", ".join(f"{cluster.points:,} (label {cluster.label})" for cluster in self.largest)
        fields = [
            ("clusters", f"{self.clusters:,}, eps {self.eps:g} {self.m}, min points {self.min_points}"),
            ("largest", sizes or "none"),
            ("noise", f"{self.noise:,} of {total:,} points, {format_fraction(self.noise / max(total, 1))}"),
        ]
        if self.points != total:
            fields.append(("kept", f"{self.points:,} points"))
        return [*fields, *self.closing(self.device, self.replaced)]


def cluster_file(
    source: FilePath,
    output: FilePath,
    *,
    eps: float,
    min_points: int = 10,
    largest: int | None = None,
    paint: bool = False,
    **settings: Unpack[Settings],
) -> ClusterReport:
    """Write a cloud with the int32 attribute `label` of its clusters, -1 for noise (DBSCAN).

    `largest` keeps only the largest clusters under their labels; `paint` colors the points by label, noise black. The
    output format must store labels, or colors if `paint`, unless `largest` is given.
    """
    formats, what = (COLORED, "labels or colors") if paint else (LABELLED, "labels")
    if largest is not None:
        formats, what = WRITTEN, "clouds"
    job = Job("cluster", source, **settings)
    job.check(output, formats, what=what)
    rows = read_rows(job)
    with job.stage("cluster", judged=True):
        labels = rows.cloud.cluster_dbscan(eps, min_points)
    sizes = np.bincount(labels[labels >= 0])
    ranked = np.argsort(-sizes, kind="stable")
    with job.stage("check"):
        warning = _warning(rows.cloud, sizes, eps, min_points)
    table, replaced = label_rows(rows.table, LABEL, labels)
    if paint:
        replaced = ["colors"] * (table.colors is not None) + replaced
        table.colors = _paint(labels)
    selected = np.arange(len(labels)) if largest is None else np.flatnonzero(np.isin(labels, ranked[:largest]))
    if len(selected):
        job.write_points(table if largest is None else take_rows(table, selected), output)
    else:
        warning = f"{warning or 'no point is left'}; nothing was written"
    counts = [ClusterSize(int(label), int(sizes[label])) for label in ranked[:_LISTED_CLUSTERS]]
    return ClusterReport(
        job.done(warning),
        str(job.device),
        len(labels),
        len(selected),
        eps,
        min_points,
        clusters=len(sizes),
        largest=tuple(counts),
        noise=int((labels < 0).sum()),
        replaced=tuple(replaced),
    )


def _paint(labels: NDArray[np.int32]) -> NDArray[np.float32]:
    """A color for each label, repeated after 20; black for -1."""
    colors = (TAB20_PALETTE / 255).astype(np.float32)[labels % len(TAB20_PALETTE)]
    colors[labels < 0] = 0
    return colors


def _warning(cloud: PointCloud, sizes: NDArray[Any], eps: float, min_points: int) -> str | None:
    """Warn if the clusters are meaningless, with a proposed eps."""
    finite = len(cloud.remove_non_finite_points())
    if not finite:
        return "no point is finite, so there are no clusters"
    if len(sizes) > 1 or (len(sizes) == 1 and sizes[0] < finite):
        return None
    m = symbol_of(cloud.unit)
    search, probes = NearestNeighborSearch(cloud), probe_points(cloud)
    if len(sizes):
        distance = distance_of_nearest(search, probes, min_points, fraction=0.9)
        hint = f"one cluster contains all {finite:,} finite points; use a smaller --radius"
        return f"{hint}, such as {rounded_up(distance):g}" if distance and rounded_up(distance) < eps else hint
    distance = distance_of_nearest(search, probes, min_points)
    message = f"all points are noise: no point has {min_points} points within {eps:g} {m}, itself included"
    if distance is None:
        return f"{message}; use a larger --radius or fewer --neighbors"
    return f"{message}; half of the points have that many within {rounded_up(distance):g} {m}: use a larger --radius"
