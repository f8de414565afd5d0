"""create_from_point_cloud_poisson of 200k points with normals at depths 8 and 9, beside Open3D."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from mesh_scenes import in_pointloom, wavy_mesh
from numpy.typing import NDArray

Scene = tuple[NDArray[np.float64], NDArray[np.float64], int]
Surface = tuple[NDArray[np.float64], NDArray[np.float64]]


@cache
def samples(count: int, depth: int, cells: int = 128) -> Scene:
    """Points and normals of a closed surface, and the octree depth."""
    mesh = in_pointloom(wavy_mesh(cells), "cpu").compute_vertex_normals()
    cloud = mesh.sample_points_uniformly(count)
    assert cloud.normals is not None
    return cloud.points.copy(), cloud.normals.astype(np.float64), depth


def prepare_pointloom(scene: Scene, device: str) -> Any:
    import pointloom as loom

    points, normals, depth = scene
    cloud = loom.PointCloud(points, normals=normals, device=device)
    return waiting(lambda: loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth), device, "warp")


def prepare_open3d(scene: Scene, device: str) -> Any:
    o3d = load_open3d()
    points, normals, depth = scene
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    cloud.normals = o3d.utility.Vector3dVector(normals)
    return lambda: o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth)


def facts(result: Any) -> Surface:
    mesh, densities = result
    return np.asarray(mesh.vertices), np.asarray(densities)


def check(actual: Surface, reference: Surface, peer: str) -> None:
    """Check for the same number of vertices, closer to each other than to their neighbors, with the same densities.

    If the samples end between two levels (200k at depth 9), pointloom's band of finer cells is wider: up to 50 % more.
    """
    from scipy.spatial import cKDTree

    tree = cKDTree(reference[0])
    distances, nearest = tree.query(actual[0])
    step = np.median(tree.query(reference[0][:1000], k=2)[0][:, 1])
    assert 0.8 < len(actual[0]) / len(reference[0]) < 1.5, f"{len(actual[0])} vertices, {peer} has {len(reference[0])}"
    assert np.median(distances) < step, f"{np.median(distances):.3g} from {peer}'s, whose are {step:.3g} apart"
    gap = np.median(np.abs(actual[1] - reference[1][nearest]))
    assert gap < 0.05, f"densities {gap:.3f} from {peer}'s"


POISSON = Operation(
    name="poisson",
    scenes={"1k, depth 5": partial(samples, 1000, 5)}
    | {f"200k, depth {depth}": partial(samples, 200_000, depth) for depth in (8, 9)},
    quick={"5k, depth 5": partial(samples, 5_000, 5, 32)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, facts),
    ),
    check=check,
)
OPERATIONS = (POISSON,)


@timed(POISSON)
def test_poisson(time_lap) -> None:
    time_lap()
