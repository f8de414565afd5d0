"""Meshes for benchmarks, as arrays and in the form of each contestant."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import scenes
from contest import load_open3d
from numpy.typing import NDArray

Arrays = tuple[NDArray[np.float64], NDArray[np.int32]]


@cache
def wavy_mesh(cells: int = 128) -> Arrays:
    """A closed surface; at 128 cells 76,460 triangles of very different sizes."""
    import pointloom as loom

    mesh = loom.meshing.marching_cubes(scenes.wavy_ball(cells))
    return mesh.vertices, mesh.triangles


@cache
def torn_mesh(cells: int = 128) -> Arrays:
    """The same surface without half of its triangles: about 10,000 parts."""
    vertices, triangles = wavy_mesh(cells)
    return vertices, triangles[np.random.default_rng(0).permutation(len(triangles))[: len(triangles) // 2]]


def in_pointloom(arrays: Arrays, device: str) -> Any:
    import pointloom as loom

    return loom.TriangleMesh(*arrays, device=device)


def in_open3d(arrays: Arrays) -> Any:
    o3d = load_open3d()
    vertices, triangles = (values.copy() for values in arrays)
    return o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(vertices), o3d.utility.Vector3iVector(triangles))


def scene_in_pointloom(arrays: Arrays, device: str) -> Any:
    import pointloom as loom

    scene = loom.RaycastingScene(device)
    scene.add_triangles(*arrays)
    return scene


def scene_in_open3d(arrays: Arrays) -> Any:
    o3d = load_open3d()
    vertices, triangles = arrays[0].astype(np.float32), np.asarray(arrays[1]).astype(np.uint32)
    scene = o3d.t.geometry.RaycastingScene()
    scene.add_triangles(o3d.core.Tensor(vertices), o3d.core.Tensor(triangles))
    return scene
