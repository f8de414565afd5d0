"""Label the points of a file by cluster: `cluster_file`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FilePath
from ...core.reports import Fields
from ...core.wording import format_fraction
from ...io.points.formats import WRITTEN, storing
from ...visualization.render.colormaps import LABEL_COLORS
from .job import Job, Settings
from .rows import RowsReport, label_rows, read_rows, take_rows, why_no_points

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
    formats, what = (storing("colors"), "labels or colors") if paint else (storing("labels"), "labels")
    if largest is not None:
        formats, what = WRITTEN, "clouds"
    job = Job("cluster", source, **settings)
    job.check(output, formats, what=what)
    rows = read_rows(job)
    with job.assessed("cluster", {"eps": "--radius"}):
        labels = rows.cloud.cluster_dbscan(eps, min_points)
    sizes = np.bincount(labels[labels >= 0])
    ranked = np.argsort(-sizes, kind="stable")
    warning = why_no_points(rows)
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
