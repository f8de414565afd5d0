"""Points on the surface of a file's mesh: `sample_mesh_file`."""

from __future__ import annotations

from typing import Any

from ..pcd.io.formats import WRITTEN
from ..pcd.io.point_cloud import table_of
from . import tables
from .clouds import FilePath, closing_fields
from .mesh_job import MeshJob


def sample_mesh_file(
    source: FilePath,
    output: FilePath,
    *,
    count: int,
    even: bool = False,
    triangle_normals: bool = False,
    seed: int = 0,
    **settings: Any,
) -> dict[str, Any]:
    """Write points on the surface of a mesh as a cloud.

    Args:
        source: A mesh.
        output: A cloud.
        count: How many.
        even: Spread them evenly (Poisson disk) instead of drawing each by itself.
        triangle_normals: Give them the normals of their triangles.
        seed: Chooses the points.
        settings: device, as_text, overwrite and progress as of `MeshJob`.

    Returns:
        What was done, in JSON's types. Nothing is written where the mesh has no area.

    Raises:
        FileError: A file that cannot be read or written.
        ValueError: A count out of range.
        DeviceError: No such device.
    """
    job = MeshJob("sample-mesh", source, output, formats=WRITTEN, what="clouds", **settings)
    area = job.mesh.get_surface_area()
    points = 0
    if area > 0:
        with job.stages("sample"):
            draw = job.mesh.sample_points_poisson_disk if even else job.mesh.sample_points_uniformly
            cloud = draw(count, use_triangle_normal=triangle_normals, seed=seed)
            points = len(cloud)
        with job.stages("write"):
            left_out = tables.write_cloud_table(output, table_of(cloud), as_text=job.as_text, overwrite=job.overwrite)
            job.wrote(left_out)
    poor = None if area > 0 else "the mesh has no area to draw points from; nothing was written"
    return job.report(poor=poor) | {"points": points, "even": even, "seed": seed, "area": area}


def sample_mesh_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    how = "evenly" if report["even"] else "each by itself"
    spacing = (report["area"] / report["points"]) ** 0.5 if report["points"] else 0.0
    return [
        ("triangles", f"{report['triangles_in']:,}, {report['area']:.4g} m^2"),
        ("points", f"{report['points']:,}, drawn {how}, seed {report['seed']}; one in {spacing:.3g} m squared"),
        *closing_fields(report),
    ]
