"""Meshes in Open3D's form, its results as plain arrays, and batches of its results for many small meshes."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pointloom import TriangleMesh


def in_open3d(o3d: Any, mesh: TriangleMesh, scale: float = 1.0) -> Any:
    """The mesh as Open3D's, with normals and colors."""
    vectors, triples = o3d.utility.Vector3dVector, o3d.utility.Vector3iVector
    peer = o3d.geometry.TriangleMesh(vectors(mesh.vertices * scale), triples(mesh.triangles.copy()))
    for name in ("vertex_normals", "vertex_colors"):
        values = getattr(mesh, name)
        if values is not None:
            setattr(peer, name, vectors(values.astype(float)))
    return peer


def tensor_mesh(o3d: Any, mesh: TriangleMesh) -> Any:
    core = o3d.core
    return o3d.t.geometry.TriangleMesh(core.Tensor(mesh.vertices.copy()), core.Tensor(mesh.triangles.astype(np.int64)))


def raycasting_scene(o3d: Any, *meshes: tuple[Any, Any]) -> Any:
    """A scene of meshes (vertices, triangles)."""
    scene, tensor = o3d.t.geometry.RaycastingScene(), o3d.core.Tensor
    for vertices, triangles in meshes:
        scene.add_triangles(tensor(np.array(vertices, np.float32)), tensor(np.array(triangles, np.uint32)))
    return scene


def arrays_of(peer: Any, *names: str) -> tuple[np.ndarray, ...]:
    """Arrays of shape (n, 3) of Open3D's mesh by name, by default vertices and triangles."""
    return tuple(np.array(getattr(peer, name)).reshape(-1, 3) for name in names or ("vertices", "triangles"))


def open3d_arrays(o3d: Any, mesh: TriangleMesh, method: str, *arguments: Any, names: Sequence[str] = ()) -> Any:
    """Arrays of the mesh that an Open3D method returns or modifies."""
    peer = in_open3d(o3d, mesh)
    made = getattr(peer, method)(*arguments)
    return arrays_of(peer if made is None else made, *names)


def for_each(o3d: Any, compute: Callable[..., Sequence[Any]], scenes: Sequence[Any]) -> list[tuple[Any, Any]]:
    """Open3D's arrays `compute(o3d, *scene)` for each scene, joined over the scenes: see `one_by_one`."""
    answers = [[np.asarray(values) for values in compute(o3d, *scene)] for scene in scenes]
    return [
        (np.array([len(values) for values in column], np.int16), np.concatenate(column))
        for column in zip(*answers, strict=True)
    ]


def one_by_one(answer: list[tuple[Any, Any]]) -> list[tuple[Any, ...]]:
    """The arrays of each scene from a result of `for_each`."""
    parts = [np.split(values, np.cumsum(counts)[:-1]) for counts, values in answer]
    return list(zip(*parts, strict=True))


def assert_meshes_are_open3ds(oracle: Callable[..., Any], name: str, scenes: Sequence[tuple[Any, ...]]) -> None:
    """The same call gives Open3D's vertices and triangles for scenes (mesh, method, *arguments)."""
    answer = one_by_one(oracle(name, for_each, open3d_arrays, scenes))
    for (mesh, method, *arguments), (vertices, triangles) in zip(scenes, answer, strict=True):
        made = getattr(mesh, method)(*arguments)
        np.testing.assert_array_equal(made.vertices, vertices)
        np.testing.assert_array_equal(made.triangles, triangles)
