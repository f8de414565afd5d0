"""Crop the points of a file by a box or a polygon: `crop_file`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Unpack

from ...core.coordinates import finite_box
from ...core.errors import FilePath
from ...core.reports import Fields
from ...core.wording import format_triple
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.polygon_volume import SelectionPolygonVolume
from .job import Job, Settings
from .rows import Rows, RowsReport, read_rows


@dataclass(frozen=True)
class CropReport(RowsReport):
    def fields(self) -> Fields:
        return [("points", f"{self.points:,} of {self.points_in:,}"), *self.closing(self.device)]


def crop_file(
    source: FilePath,
    output: FilePath,
    *,
    box: tuple[float, ...] | None = None,
    polygon: FilePath | None = None,
    invert: bool = False,
    **settings: Unpack[Settings],
) -> CropReport:
    """Write the points inside a box (with its faces) or a polygon volume, or outside with `invert`.

    `box` is the lowest and highest corner [m]; infinite values leave a side open. With `invert`, non-finite points are
    included. `polygon` is a file of Open3D's SelectionPolygonVolume.
    """
    if box is not None and polygon is None:
        volume = AxisAlignedBoundingBox(box[:3], box[3:])
    elif polygon is not None and box is None:
        volume = SelectionPolygonVolume.from_json(polygon)
    else:
        raise ValueError("box, polygon: expected one of the two")
    job = Job("crop", source, **settings)
    job.check(output)
    rows = read_rows(job)
    with job.stage("crop"):
        inside = rows.cloud.crop(volume, invert)
    warning = None if len(inside) else f"{_why_empty(rows, invert)}; nothing was written"
    if len(inside):
        job.write_points(rows.take(rows.of(inside)), output)
    return CropReport(job.done(warning), str(job.device), len(rows.cloud), len(inside))


def _why_empty(rows: Rows, invert: bool) -> str:
    if not len(rows.cloud.remove_non_finite_points()):
        return "no point is finite, so no point is inside"
    low, high = finite_box(rows.table.points)
    extent = f"the points extend from {format_triple(low)} to {format_triple(high)}"
    return f"no point is {'outside' if invert else 'inside'}; {extent}"
