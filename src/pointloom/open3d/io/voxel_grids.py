"""Files of voxel grids (PLY) and octrees (JSON), as Open3D writes them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from ...core.atomic import atomic_write
from ...core.errors import FileError
from ...core.json_files import check_keys, read_json_object
from ..geometry.octree import Octree
from ..geometry.octree_nodes import node_from_json
from ..geometry.voxel_grid import VoxelGrid
from .ply_elements import FilePath, check_ply, color_columns, colors_of, columns_of, read_elements, write_elements

AXES = [f"r{row}{column}" for row in range(3) for column in range(3)]


def read_voxel_grid(filename: FilePath, format: str = "auto", print_progress: bool = False) -> VoxelGrid:
    """Read a .ply with an origin, a voxel size and voxel indices. Raises FileError."""
    path = check_ply(filename, format)
    elements = read_elements(path, "origin", "voxel_size", "vertex")
    cells = columns_of(path, elements, "vertex", "x", "y", "z")
    origin, size = columns_of(path, elements, "origin", "x", "y", "z"), columns_of(path, elements, "voxel_size", "val")
    if len(origin) != 1 or len(size) != 1:
        raise FileError(path, f"expected one origin and one voxel size, got {len(origin)} and {len(size)}")
    made = VoxelGrid._around(origin[0], float(size[0, 0]), cells.astype(np.int32), colors_of(path, elements, "vertex"))
    if "rotation" in elements:
        made.rotation = columns_of(path, elements, "rotation", *AXES).reshape(3, 3)
    return made


def write_voxel_grid(
    filename: FilePath,
    voxel_grid: Any,
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Write a .ply with 8-bit colors."""
    if not isinstance(voxel_grid, VoxelGrid):
        raise TypeError(f"voxel_grid: expected a VoxelGrid, got {type(voxel_grid).__name__}")
    cells, colors = voxel_grid._voxels()
    elements = {
        "origin": dict(zip("xyz", voxel_grid.origin.reshape(3, 1), strict=True)),
        "rotation": dict(zip(AXES, voxel_grid.rotation.reshape(9, 1), strict=True)),
        "voxel_size": {"val": np.array([voxel_grid.voxel_size])},
        "vertex": dict(zip("xyz", cells.astype(np.float64).T, strict=True)) | color_columns(colors),
    }
    write_elements(check_ply(filename), elements, ascii=write_ascii)
    return True


def read_octree(filename: FilePath, format: str = "auto") -> Octree:
    """Read a .json. Raises FileError."""
    content = read_json_object(_json(filename))
    check_keys(filename, content, required={"class_name", "origin", "size", "max_depth", "tree"})
    try:
        made = Octree(content["max_depth"], content["origin"], content["size"])
        made.root_node = node_from_json(content["tree"])
    except (TypeError, ValueError) as error:
        raise FileError(filename, str(error)) from error
    return made


def write_octree(filename: FilePath, octree: Any) -> bool:
    """Write a .json."""
    if not isinstance(octree, Octree):
        raise TypeError(f"octree: expected an Octree, got {type(octree).__name__}")
    content = {"class_name": "Octree", "max_depth": octree.max_depth, "origin": octree.origin.tolist()}
    content |= {"size": octree.size, "tree": {} if octree.root_node is None else octree.root_node._to_json()}
    with atomic_write(_json(filename)) as file:
        file.write(json.dumps(content).encode())
    return True


def _json(filename: FilePath) -> FilePath:
    if Path(filename).suffix.lower() != ".json":
        raise ValueError(f"filename: expected a name that ends in .json, got {filename}")
    return filename
