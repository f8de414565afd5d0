"""Clean-up, orientation and hole filling of meshes of 76k triangles beside Open3D, without a target; results are
compared.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed
from mesh_scenes import Arrays, in_open3d, in_pointloom, wavy_mesh
from reasons import CALL, PROCESSOR


@cache
def loose_mesh(cells: int) -> Arrays:
    """Triangles that share no vertex, as in an STL file, each fifth one duplicated."""
    vertices, triangles = wavy_mesh(cells)
    triangles = np.vstack([triangles, triangles[::5, [1, 2, 0]]])
    return vertices[triangles.reshape(-1)], np.arange(3 * len(triangles), dtype=np.int32).reshape(-1, 3)


@cache
def crowded_mesh(cells: int) -> Arrays:
    """A closed surface with a small third triangle at a tenth of its edges."""
    vertices, triangles = wavy_mesh(cells)
    chosen = triangles[::7]
    tips = vertices[chosen].mean(axis=1) + 0.01
    fins = np.column_stack([chosen[:, :2], len(vertices) + np.arange(len(chosen))])
    return np.vstack([vertices, tips]), np.vstack([triangles, fins]).astype(np.int32)


@cache
def flipped_mesh(cells: int) -> Arrays:
    """A closed surface with each third triangle flipped."""
    vertices, triangles = wavy_mesh(cells)
    triangles = triangles.copy()
    triangles[::3] = triangles[::3, ::-1]
    return vertices, triangles


@cache
def holed_mesh(cells: int) -> Arrays:
    """A closed surface without each 300th triangle and its neighbors at one vertex."""
    vertices, triangles = wavy_mesh(cells)
    return vertices, triangles[~np.isin(triangles, triangles[::300, 0]).any(axis=1)]


def run_pointloom(scene: Arrays, device: str, *, steps: tuple[tuple[str, tuple[Any, ...]], ...]) -> Any:
    mesh = in_pointloom(scene, device)

    def call() -> Any:
        result = mesh
        for name, arguments in steps:
            result = getattr(result, name)(*arguments)
        return result[0] if isinstance(result, tuple) else result

    return call


def run_open3d(scene: Arrays, device: str, *, steps: tuple[tuple[str, tuple[Any, ...]], ...]) -> Any:
    o3d, mesh = load_open3d(), in_open3d(scene)

    def call() -> Any:
        result = o3d.geometry.TriangleMesh(mesh)  # changes in place
        for name, arguments in steps:
            getattr(result, name)(*arguments)
        return result

    return call


def fill_open3d(scene: Arrays, device: str) -> Any:
    mesh = load_open3d().t.geometry.TriangleMesh.from_legacy(in_open3d(scene))
    return lambda: mesh.fill_holes().to_legacy()


def facts(mesh: Any) -> tuple[int, int]:
    return len(np.asarray(mesh.vertices)), len(np.asarray(mesh.triangles))


def check(actual: tuple[int, int], reference: tuple[int, int], peer: str) -> None:
    """Check for the same numbers of vertices and triangles."""
    assert actual == reference, (actual, reference, peer)


def check_manifold(actual: tuple[int, int], reference: tuple[int, int], peer: str) -> None:
    """Check for the same number of vertices; Open3D's edge order is that of a hash table, so some triangles differ."""
    assert actual[0] == reference[0] and abs(actual[1] - reference[1]) <= 0.01 * reference[1], (actual, reference, peer)


def check_filled(actual: tuple[int, int], reference: tuple[int, int], peer: str) -> None:
    """Check for the same number of vertices; VTK does not fill some holes."""
    assert actual[0] == reference[0] and actual[1] >= reference[1], (actual, reference, peer)


def operation(name: str, scene: Any, steps: tuple[tuple[str, tuple[Any, ...]], ...], same: Any = check) -> Operation:
    return Operation(
        name=name,
        scenes={"1k": partial(scene, 16), "76k": partial(scene, 128)},
        quick={"small": partial(scene, 24)},
        contestants=(
            Contestant(POINTLOOM, partial(run_pointloom, steps=steps), facts, ("cpu", "cuda")),
            Contestant("open3d-legacy", partial(run_open3d, steps=steps), facts),
        ),
        check=same,
    )


REPEATS = (("remove_duplicated_vertices", ()), ("remove_duplicated_triangles", ()), ("remove_degenerate_triangles", ()))
CLEAN = replace(
    operation("mesh_clean", loose_mesh, REPEATS), targets={"76k": 3}, reasons={"1k": CALL, "76k": PROCESSOR.format(3.4)}
)
MERGE = replace(operation("mesh_merge_close", loose_mesh, (("merge_close_vertices", (0.02,)),)), reasons={"1k": CALL})
CROWDED = replace(
    operation("mesh_non_manifold", crowded_mesh, (("remove_non_manifold_edges", ()),), check_manifold),
    reasons={"1k": CALL},
)
ORIENT = operation("mesh_orient", flipped_mesh, (("orient_triangles", ()),))
FILL = Operation(
    name="mesh_fill_holes",
    scenes={"1k": partial(holed_mesh, 16), "76k": partial(holed_mesh, 128)},
    quick={"small": partial(holed_mesh, 24)},
    contestants=(
        Contestant(POINTLOOM, partial(run_pointloom, steps=(("fill_holes", ()),)), facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", fill_open3d, facts),
    ),
    check=check_filled,
    reasons={"1k": CALL},
)
OPERATIONS = (CLEAN, MERGE, CROWDED, ORIENT, FILL)


@timed(CLEAN)
def test_mesh_clean(time_lap) -> None:
    time_lap()


@timed(MERGE)
def test_mesh_merge_close(time_lap) -> None:
    time_lap()


@timed(CROWDED)
def test_mesh_non_manifold(time_lap) -> None:
    time_lap()


@timed(ORIENT)
def test_mesh_orient(time_lap) -> None:
    time_lap()


@timed(FILL)
def test_mesh_fill_holes(time_lap) -> None:
    time_lap()
