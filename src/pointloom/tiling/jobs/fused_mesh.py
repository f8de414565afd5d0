"""Merge the surfaces of a volume's cubes into one mesh with shared vertices, one cube at a time."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_folder, atomic_write, check_folder, check_writable
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.archives import Arrays, Expected, read_part_of_job, rows_of
from ...io.points.ply import write_ply_mesh, write_ply_mesh_parts
from ...io.table import MeshTable
from ...kernels.volumes.block_surface import EDGES_PER_BLOCK
from ..manifest import Manifest
from .fusion import Cube, FusionJob, surface_path
from .job import done_in
from .run_jobs import finished_job

RESULT = "mesh.ply"
LISTING = "parts.json"  # of a folder of parts


def _surface(folder: Path, name: str) -> Arrays:
    """The arrays of a cube's file. Raises FileError for other types, shapes and indices than `write_surface` writes."""
    remedy = "Plan and run the job again in another folder"
    path = surface_path(folder, name)
    return read_part_of_job(path, "a cube's surface", _arrays_of_cube, _find_wrong_number, remedy)


def _arrays_of_cube(arrays: Arrays) -> Expected:
    vertices, shared = (rows_of(arrays, key) for key in ("vertices", "shared"))
    expected: dict[str, Any] = {"vertices": (np.float32, (vertices, 3)), "shared": (np.int64, (shared,))}
    expected |= {"triangles": (np.int32, (rows_of(arrays, "triangles"), 3))}
    expected |= {"blocks": (np.int64, (shared,)), "places": (np.int32, (shared,))}
    return expected | ({"colors": (np.float32, (vertices, 3))} if "colors" in arrays else {})


def _find_wrong_number(arrays: Arrays) -> str:
    """Why arrays of the right shape are invalid, or ""."""
    vertices = len(arrays["vertices"])
    for name in ("triangles", "shared"):
        numbers = arrays[name]
        if numbers.size and not 0 <= numbers.min() <= numbers.max() < vertices:
            return f"{name}: expected indices of {vertices} vertices, got {numbers.min()}..{numbers.max()}"
    if arrays["places"].size and not 0 <= arrays["places"].min() <= arrays["places"].max() < EDGES_PER_BLOCK:
        return f"places: expected numbers from 0 to {EDGES_PER_BLOCK - 1}"
    return "" if np.isfinite(arrays["vertices"]).all() else "vertices: expected finite numbers"


class _Sides(NamedTuple):
    """Shared vertices of a cube: sorted edges, and numbers in the complete mesh."""

    blocks: NDArray[np.int64]
    edges: NDArray[np.int32]
    numbers: NDArray[np.int64]


class _Numbered(NamedTuple):
    """A cube's surface, the global numbers of its vertices (int64), and those that are new."""

    name: str
    arrays: Arrays
    numbers: NDArray[np.int64]
    is_new: NDArray[np.bool_]


def finish_fusion(folder: FilePath, path: FilePath | None = None, *, overwrite: bool = True) -> Path:
    """Merge the surfaces of all cubes into one mesh, or write them as matching parts.

    float32 positions, or float64 beyond 10 km from zero. Memory: a cube's surface and its neighbors' shared vertices.

    Args:
        folder: Folder of `plan_fusion`, all tasks done.
        path: A .ply file. Any other name becomes a folder with one `x_y_z.ply` per cube and `parts.json`, with bitwise
            equal shared vertices. If None: `mesh.ply` in the job's folder.
        overwrite: Allow replacing existing output.

    Returns:
        Path of the file or folder, written atomically.

    Raises:
        FileError: If tasks are not done, a cube's file is damaged, or the result cannot be written or is empty.
    """
    manifest, job = finished_job(folder, FusionJob)
    with manifest:
        path = manifest.folder / RESULT if path is None else path_of(path)
        is_file = path.suffix.lower() == ".ply"
        if path.suffix.lower() in MESH_FORMATS and not is_file:
            raise FileError(path, "a fused mesh is written as a .ply file or a folder of .ply files")
        if is_file:
            check_writable(path, overwrite=overwrite)
        else:
            check_folder(path, LISTING, overwrite=overwrite)
        cubes = _cubes_of(manifest, job)
        if not cubes:
            raise FileError(path, "there is nothing to write: no voxel was observed often enough for a surface")
        if is_file:
            _write_mesh(path, job, cubes, overwrite)
        else:
            _write_parts(path, job, cubes, overwrite)
        return path


def _cubes_of(manifest: Manifest, job: FusionJob) -> list[tuple[str, Cube]]:
    """Cubes with triangles, by position."""
    cubes = [(task.name, tuple(task.inputs["cube"])) for task in done_in(manifest, job, 1) if task.result["triangles"]]
    return sorted(cubes, key=lambda entry: entry[1])


def _write_parts(path: Path, job: FusionJob, cubes: list[tuple[str, Cube]], overwrite: bool) -> None:
    listing = []
    with atomic_folder(path, LISTING, overwrite=overwrite) as part:
        for name, cube in cubes:
            arrays = _surface(job.folder, name)
            table = _table(job, arrays, slice(None), arrays["triangles"])
            write_ply_mesh(part / f"{name}.ply", table)
            ends = [table.vertices.min(axis=0).tolist(), table.vertices.max(axis=0).tolist()]
            sizes = {"vertices": len(table.vertices), "triangles": len(table.triangles)}
            listing.append({"file": f"{name}.ply", "cube": list(cube), "bounds": ends} | sizes)
        edge = job.plan["blocks"] * 8 * job.plan["voxel_size"]
        header = {"voxel_size": job.plan["voxel_size"], "cube_size": edge, "origin": job.plan["origin"]}
        with atomic_write(part / LISTING) as file:
            file.write(json.dumps(header | {"parts": listing}, indent=1).encode())


def _write_mesh(path: Path, job: FusionJob, cubes: list[tuple[str, Cube]], overwrite: bool) -> None:
    vertices = triangles = 0
    for surface in _numbered(job.folder, cubes):
        vertices += int(surface.is_new.sum())
        triangles += len(surface.arrays["triangles"])

    def parts() -> Iterator[MeshTable]:
        for surface in _numbered(job.folder, cubes):
            yield _table(job, surface.arrays, surface.is_new, surface.numbers[surface.arrays["triangles"]])

    write_ply_mesh_parts(path, parts, (vertices, triangles), overwrite=overwrite)


def _table(job: FusionJob, arrays: Arrays, rows: Any, triangles: NDArray[Any]) -> MeshTable:
    origin, vertices = job.origin, arrays["vertices"][rows]
    colors = arrays["colors"][rows] if "colors" in arrays else None
    return MeshTable(vertices + origin if origin.any() else vertices, triangles, vertex_colors=colors)


def _numbered(folder: Path, cubes: list[tuple[str, Cube]]) -> Iterator[_Numbered]:
    """Cubes with global vertex numbers. Shared vertices keep the number of the first cube."""
    begin, sides = 0, dict[Cube, _Sides]()
    for name, cube in cubes:
        sides = {other: side for other, side in sides.items() if other[0] >= cube[0] - 1}
        arrays = _surface(folder, name)
        shared, blocks, edges = (arrays[key] for key in ("shared", "blocks", "places"))
        near = [sides[other] for other in _around(cube) if other in sides]
        known = _match(near, blocks, edges)
        is_new = np.ones(len(arrays["vertices"]), bool)
        is_new[shared[known >= 0]] = False
        numbers = begin + np.cumsum(is_new) - 1
        numbers[shared[known >= 0]] = known[known >= 0]
        sides[cube] = _Sides(blocks, edges, numbers[shared])
        yield _Numbered(name, arrays, numbers, is_new)
        begin += int(is_new.sum())


def _around(cube: Cube) -> Iterator[Cube]:
    x, y, z = cube
    return ((x + i, y + j, z + k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) if (i, j, k) != (0, 0, 0))


def _match(known: list[_Sides], blocks: NDArray[np.int64], edges: NDArray[np.int32]) -> NDArray[np.int64]:
    """Existing numbers of vertices, -1 if new."""
    if not known:
        return np.full(len(blocks), -1, np.int64)
    before = _Sides(*(np.concatenate([getattr(side, name) for side in known]) for name in _Sides._fields))
    rank = np.unique(np.concatenate([before.blocks, blocks]), return_inverse=True)[1].astype(np.int64)
    codes = rank * EDGES_PER_BLOCK + np.concatenate([before.edges, edges])
    old, new = codes[: len(before.blocks)], codes[len(before.blocks) :]
    order = np.argsort(old, kind="stable")
    if not len(order):
        return np.full(len(blocks), -1, np.int64)
    at = order[np.minimum(np.searchsorted(old, new, sorter=order), len(order) - 1)]
    return np.where(old[at] == new, before.numbers[at], -1)
