"""How far the meshes of two files lie apart: `compare_mesh_files`."""

from __future__ import annotations

import math
import os
from typing import Any

import numpy as np

from ..meshing.mesh import TriangleMesh
from ..meshing.mesh_files import mesh_table, read_triangle_mesh
from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from . import tables
from .clouds import FilePath, closing_fields
from .console import ReportProgress, format_share
from .mesh_job import Stages
from .pictures.picture_files import check_picture, save_picture

THRESHOLD = 0.01  # of the second mesh's diagonal: the distance of the F-score where none is given
APART = 0.1  # of the diagonal: a mean distance above this is another unit or frame
_TITLE = "distances of A from B, at the vertices of A"
MAP_FORMATS = (".ply", ".obj", ".glb", ".off")  # that hold colours at vertices


def compare_mesh_files(
    first: FilePath,
    second: FilePath,
    *,
    samples: int = 100_000,
    thresholds: list[float] | None = None,
    limit: float | None = None,
    error_map: FilePath | None = None,
    picture: FilePath | None = None,
    seed: int = 0,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Measure how far the surfaces of two meshes lie apart.

    Args:
        first: A mesh.
        second: The mesh that it is held against.
        samples: Points drawn from each.
        thresholds: Distances [m] of the F-scores; None for a hundredth of the second mesh's diagonal.
        limit: A Hausdorff distance [m] above this is a poor result.
        error_map: A file for the first mesh, coloured by its distance from the second.
        picture: A .png file for a picture of it, with a histogram of the distances.
        seed: Chooses the points.
        device: Where to compute.
        overwrite: Replace the error map and the picture if they exist.
        progress: Called with each stage when it begins.

    Returns:
        The figures as of `TriangleMesh.compute_metrics`, in JSON's types; "poor" says why they are.

    Raises:
        FileError: A file that cannot be read or written, or a mesh without area.
        ValueError: A number out of range.
        DeviceError: No such device.
    """
    if error_map is not None:
        tables.check_output(error_map, MAP_FORMATS, what="coloured meshes", overwrite=overwrite)
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    where, stages = resolve_device(device), Stages(progress)
    with stages("read"):
        meshes = [_read(path, where) for path in (first, second)]
    low, high = meshes[1].get_axis_aligned_bounding_box()
    diagonal = math.dist(low, high)
    radii = thresholds or [THRESHOLD * diagonal]
    with stages("compare"):
        found = meshes[0].compute_metrics(meshes[1], radii, samples, seed=seed)
    files = _write_maps(meshes, error_map, picture, stages, overwrite=overwrite)
    return {
        "command": "compare-meshes",
        "first": os.fspath(first),
        "second": os.fspath(second),
        "triangles": [len(mesh) for mesh in meshes],
        "diagonal": diagonal,
        "chamfer": found.chamfer,
        "hausdorff": found.hausdorff,
        "hausdorff_bound": found.hausdorff_bound,
        "fscore": dict(zip(map(str, radii), found.fscore.tolist(), strict=True)),
        "mean": list(found.mean),
        "rms": list(found.rms),
        "max": list(found.max),
        "samples": samples,
        "seed": seed,
        "device": str(where),
        "seconds": stages.clock.seconds,
        "left_out": [],
        "files": files,
        "poor": _why_poor(found, diagonal, limit),
    }


def compare_meshes_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The figures as labels and values for the terminal."""
    scores = ", ".join(f"{score:.1f} % within {float(radius):.3g} m" for radius, score in report["fscore"].items())
    return [
        ("triangles", " and ".join(f"{count:,}" for count in report["triangles"])),
        ("chamfer", f"{report['chamfer']:.4g} m"),
        ("mean", _there_and_back(report["mean"])),
        ("rms", _there_and_back(report["rms"])),
        ("Hausdorff", f"{report['hausdorff']:.4g} m, at most {report['hausdorff_bound']:.4g}"),
        ("F-score", scores),
        *closing_fields(report),
    ]


def _write_maps(
    meshes: list[TriangleMesh],
    error_map: FilePath | None,
    picture: FilePath | None,
    stages: Stages,
    *,
    overwrite: bool,
) -> list[str]:
    """Write the first mesh, coloured by its distances from the second, and a picture of it; gives the files' names."""
    if error_map is None and picture is None:
        return []
    with stages("map"):
        colored, distances = meshes[0].compute_error_map(meshes[1])
    if picture is not None:
        from .mesh import looks_inwards
        from .pictures.error_picture import draw_errors

        with stages("picture"):
            image = draw_errors(meshes[0], np.asarray(distances), _TITLE, back_faces=not looks_inwards(meshes[0]))
            save_picture(picture, image, overwrite=overwrite)
    if error_map is not None:
        tables.write_mesh_table(error_map, mesh_table(colored), overwrite=overwrite)
    return [os.fspath(path) for path in (error_map, picture) if path is not None]


def _there_and_back(values: list[float]) -> str:
    return f"{values[0]:.4g} m from A to B, {values[1]:.4g} m back"


def _read(path: FilePath, device: Any) -> TriangleMesh:
    mesh = read_triangle_mesh(path, device=device)
    if not mesh.get_surface_area() > 0:
        raise FileError(path, "holds no triangle with an area, so no distance can be taken")
    return mesh


def _why_poor(found: Any, diagonal: float, limit: float | None) -> str | None:
    mean = max(found.mean)
    if mean > APART * diagonal:
        share = format_share(mean / diagonal)
        return f"the surfaces lie {share} of their size apart: other units, or other frames? Register them first"
    if limit is not None and found.hausdorff > limit:
        return f"the surfaces lie up to {found.hausdorff:.4g} m apart, more than {limit:g} m"
    return None
