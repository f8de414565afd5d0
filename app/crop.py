"""The points of a file inside a box or a polygon: `crop_file`."""

from __future__ import annotations

from typing import Any

from ..pcd.boxes import AxisAlignedBoundingBox
from ..pcd.coordinates import finite_box
from ..pcd.polygon_volume import SelectionPolygonVolume
from .cloud_job import CloudJob, take_rows
from .clouds import FilePath, closing_fields
from .console import format_triple


def crop_file(
    source: FilePath,
    output: FilePath,
    *,
    box: tuple[float, ...] | None = None,
    polygon: FilePath | None = None,
    invert: bool = False,
    **settings: Any,
) -> dict[str, Any]:
    """Write the points of a cloud inside a box, its faces included, or inside a polygon volume.

    Args:
        source: A cloud; of a mesh the vertices count.
        output: A cloud.
        box: The lowest corner and the highest, six coordinates [m]; an infinite one leaves its side open.
        polygon: A file of Open3D's SelectionPolygonVolume, in place of a box.
        invert: Write the points outside instead, those that are not finite among them.
        settings: device, as_text, overwrite and progress as of `CloudJob`.

    Returns:
        What was done, in JSON's types. Nothing is written where no point is left.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A box whose lowest corner is above the highest, or not one of box and polygon.
        DeviceError: No such device.
    """
    if box is not None and polygon is None:
        volume = AxisAlignedBoundingBox(box[:3], box[3:])
    elif polygon is not None and box is None:
        volume = SelectionPolygonVolume.from_json(polygon)
    else:
        raise ValueError("box, polygon: expected one of the two")
    job = CloudJob("crop", source, output, **settings)
    with job.stage("crop"):
        inside = job.cloud.crop(volume, invert)
    poor = None if len(inside) else f"{_why_empty(job, invert)}; nothing was written"
    if len(inside):
        job.write(take_rows(job.table, job.rows(inside)))
    return job.report(len(inside), poor=poor)


def crop_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    return [("points", f"{report['points']:,} of {report['points_in']:,}"), *closing_fields(report)]


def _why_empty(job: CloudJob, invert: bool) -> str:
    if not len(job.cloud.remove_non_finite_points()):
        return "no point is finite, so none is inside"
    low, high = finite_box(job.table.points)
    extent = f"the points reach from {format_triple(low)} to {format_triple(high)}"
    return f"no point is {'outside' if invert else 'inside'}; {extent}"
